# Completes the command line of dioptre in bash. It asks the program itself for its commands and
# their options, so that it knows no more and no less than the program does.

# _dioptre_commands: the names of all commands.
_dioptre_commands() {
    dioptre --help 2>/dev/null | sed -n 's/^  \([a-z]\{1,\}\) .*/\1/p'
}

# _dioptre_options COMMAND: the long options of a command, and its short ones.
_dioptre_options() {
    dioptre "$1" --help 2>/dev/null | grep -oE '^ +(-[a-zA-Z],)? *--[a-z-]+' | grep -oE -- '--?[a-zA-Z][a-z-]*'
}

# _dioptre_words OPTION: what an option takes, where that is one of a few words.
_dioptre_words() {
    case $1 in
    --engine) echo auto f32x16 f32x8 f32x4 f32x1 f64x4 f64x1 f128x1 ;;
    --offset) echo none fixed bound ;;
    --pixel) echo center corner ;;
    --methods) echo own a b c d ;;
    --sampling) echo adaptive full ;;
    --progress) echo auto json none ;;
    --rays) echo image primary random ;;
    --keys) echo places letters ;;
    esac
}

# _dioptre_tests: the tests of the laboratory, as the program says them to who names none of them.
_dioptre_tests() {
    LANGUAGE=C dioptre lab '?' --out . 2>&1 | sed -n 's/.*there are \(sphere-.*\)/\1/p' | tr -d ,
}

# _dioptre_files: scenes, and folders on the way to them.
_dioptre_files() {
    compopt -o filenames 2>/dev/null
    compgen -f -X '!*.lua' -- "$1"
    compgen -f -X '!*.nff' -- "$1"
    compgen -d -- "$1"
}

_dioptre() {
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} words
    COMPREPLY=()
    words=$(_dioptre_words "$previous")
    if [ -n "$words" ]; then
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
    elif [[ $previous == -o || $previous == --output || $previous == --map || $previous == --svg || $previous == --answers ]]; then
        compopt -o filenames 2>/dev/null
        mapfile -t COMPREPLY < <(compgen -f -- "$current")
    elif [[ $previous == --lesson-snapshots || $previous == --out ]]; then
        compopt -o filenames 2>/dev/null
        mapfile -t COMPREPLY < <(compgen -d -- "$current")
    elif [[ $current == -* && $COMP_CWORD -gt 1 ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(_dioptre_options "${COMP_WORDS[1]}")" -- "$current")
    elif [ "$COMP_CWORD" = 1 ]; then
        mapfile -t COMPREPLY < <(compgen -W "$(_dioptre_commands)" -- "$current"; _dioptre_files "$current")
    elif [ "${COMP_WORDS[1]}" = compare ]; then
        compopt -o filenames 2>/dev/null
        mapfile -t COMPREPLY < <(compgen -f -- "$current")
    elif [[ ${COMP_WORDS[1]} == lab || " ${COMP_WORDS[*]} " == *' chart --kernels '* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(_dioptre_tests)" -- "$current")
    else
        mapfile -t COMPREPLY < <(_dioptre_files "$current")
    fi
}
complete -F _dioptre dioptre
