# Shared by the test scripts: counts checks, compares statuses and words. Sourced, not run.
set -u
# The tests read English, whatever the user speaks; tests/language.sh asks for French by itself.
export LC_ALL=C
cd "$(dirname "$0")/.." || exit 1
BUILD=${BUILD:-build}
dioptre=$PWD/${DIOPTRE:-$BUILD/dioptre}
work=$(mktemp -d)
trap 'chmod -R u+w "$work" 2>/dev/null; rm -rf "$work"' EXIT
# Some shells do not run the line above for a signal: a test that is stopped leaves through it, too.
trap 'exit 130' INT
trap 'exit 143' TERM
failures=0

# ok NAME / fail NAME: one line a check.
ok() { echo "ok $1"; }
fail() {
    echo "not ok $1"
    failures=$((failures + 1))
}

# expect STATUS WORDS NAME COMMAND...: runs a command; its exit status must be STATUS and its errors
# must hold WORDS (a pattern of grep -E; empty: there must be none).
expect() {
    status=$1 words=$2 name=$3
    shift 3
    "$@" >"$work/out" 2>"$work/err" </dev/null
    got=$?
    if [ "$got" != "$status" ]; then
        fail "$name: status $got, not $status: $(head -3 "$work/err")"
    elif [ -z "$words" ] && [ -s "$work/err" ]; then
        fail "$name: unexpected words: $(head -3 "$work/err")"
    elif [ -n "$words" ] && ! grep -qE "$words" "$work/err"; then
        fail "$name: no '$words' in: $(head -3 "$work/err")"
    else
        ok "$name"
    fi
}

# holds FILE WORDS NAME: a file must hold a pattern.
holds() {
    if grep -qE "$2" "$1"; then ok "$3"; else fail "$3: no '$2' in $(head -3 "$1")"; fi
}

# same A B NAME: two files must be the same, byte for byte.
same() {
    if cmp -s "$1" "$2"; then ok "$3"; else fail "$3: $1 and $2 differ"; fi
}

# differing A B NAME: two files must differ. A file that cannot be read does not.
differing() {
    cmp -s "$1" "$2"
    case $? in
    0) fail "$3: $1 and $2 are the same" ;;
    1) ok "$3" ;;
    *) fail "$3: no $1 or no $2" ;;
    esac
}

# objects_of FOLDER...: the objects of sources below folders; those of sources that are gone are left out.
objects_of() {
    for folder; do
        find "$BUILD/obj/$folder" -name '*.o' 2>/dev/null
    done | while read -r object; do
        source=${object#"$BUILD/obj/"}
        if [ -e "${source%.o}.c" ] || [ -e "${source%.o}.cpp" ]; then echo "$object"; fi
    done
}

# within COMMAND...: waits until a command succeeds: for an event, however slow the machine is. Two minutes
# are many times what any takes: they bound a test that has failed.
within() {
    deadline=$(($(date +%s) + 120))
    until "$@"; do
        [ "$(date +%s)" -lt $deadline ] || return 1
        sleep 0.03
    done
}

# ended PID: whether a process has ended.
ended() { ! kill -0 "$1" 2>/dev/null; }
# has_lines FILE COUNT: whether it has more lines than that.
has_lines() { [ "$(wc -l <"$1")" -gt "$2" ]; }

finish() { [ "$failures" = 0 ]; }
