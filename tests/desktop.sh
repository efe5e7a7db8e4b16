#!/bin/bash
# What `make install` puts where a desktop looks: the entry, the icon, the type of scene files and
# the completion of command lines.
. "$(dirname "$0")/check.sh"

app=org.dioptre.Dioptre
there=$work/there
share=$there/usr/share
expect 0 '' 'make install' make -s BUILD="$BUILD" PREFIX=/usr DESTDIR="$there" install

expect 0 '' 'the desktop entry' desktop-file-validate "$share/applications/$app.desktop"
[ ! -s "$work/out" ] && ok 'has no flaws' || fail "desktop entry: $(cat "$work/out")"
expect 0 '' 'the AppStream data' appstreamcli validate --no-net "$share/metainfo/$app.metainfo.xml"
version=$("$dioptre" --version)
holds "$share/metainfo/$app.metainfo.xml" "release version=\"${version#dioptre }\"" 'names this version'
holds "$share/icons/hicolor/scalable/apps/$app.svg" '<svg ' 'the icon is there'

# --- installed ---------------------------------------------------------------------------------------
expect 0 '' 'the installed program finds its modules and scenes' \
    "$there/usr/bin/dioptre" render "$share/dioptre/scenes/earth.lua" -s 32x24 -o "$work/earth.png"
cmp -s doc/dioptre.1 "$share/man/man1/dioptre.1" && ok 'the man page' || fail 'man page'

# --- scene files -------------------------------------------------------------------------------------
mkdir -p "$share/mime/packages"
cp /usr/share/mime/packages/freedesktop.org.xml "$share/mime/packages"
expect 0 '' 'the type of scene files' env XDG_DATA_DIRS="$share" update-mime-database "$share/mime"
# type_of FILE: what a desktop takes it for.
type_of() {
    XDG_DATA_HOME=$work/none XDG_DATA_DIRS=$share gio info -a standard::content-type "$1" | sed -n 's/.*content-type: //p'
}
others=$(for scene in scenes/*.lua; do [ "$(type_of "$scene")" = text/x-dioptre-scene ] || echo "$scene"; done)
[ -z "$others" ] && ok 'every scene is known for one' || fail "no scenes to a desktop: $others"
echo 'print("hello")' >"$work/other.lua"
type=$(type_of "$work/other.lua")
[ "$type" = text/x-lua ] && ok 'another Lua file is none' || fail "other.lua is $type"

# --- completion --------------------------------------------------------------------------------------
# completed WORD...: what the last word may become.
PATH=$there/usr/bin:$PATH
. "$share/bash-completion/completions/dioptre" || fail 'the completion is no bash'
completed() {
    COMP_WORDS=("$@")
    COMP_CWORD=$(($# - 1))
    _dioptre 2>/dev/null
    printf '%s\n' "${COMPREPLY[@]}" | LC_ALL=C sort | tr '\n' ' '
}
# completes EXPECTED WORD...
completes() {
    expected=$1
    shift
    got=$(completed "$@")
    [ "$got" = "$expected" ] && ok "completes $*" || fail "$* completes to '$got', not '$expected'"
}
completes 'animate ' dioptre an
completes '--samples --sampling ' dioptre render --samp
completes 'f32x1 f32x16 f32x4 f32x8 ' dioptre render --engine f32
completes 'scenes/box.lua ' dioptre render scenes/box
completes '--rays ' dioptre bench --ra
completes 'scenes/lessons/01-shadows.lua ' dioptre view --lesson scenes/lessons/01
completes ' ' dioptre render --ra
completes 'fresnel-into fresnel-out ' dioptre lab fres
completes 'sphere-ground ' dioptre chart --kernels sphere-gr
finish
