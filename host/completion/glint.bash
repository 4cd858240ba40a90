# SPDX-License-Identifier: MIT
# Completion for bash. It asks the command itself what it takes, so it is never out of date: --_options prints the options of
# a command, --_choices the names that an option or an argument takes.
_glint()
{
    local glint=${COMP_WORDS[0]} command= current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} options taken
    COMPREPLY=()
    # bash breaks words at =, so --model=ms are three.
    if [ "$current" = = ]; then
        current=
    elif [ "$before" = = ]; then
        before=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    if [ "$COMP_CWORD" -gt 1 ]; then
        command=${COMP_WORDS[1]}
    fi
    options=$("$glint" $command --_options 2>/dev/null | cut -f 1)
    taken=$(printf '%s\n' "$options" | sed -n "s/^$before=//p")
    case $taken in
    ?*FILE* | FILE* | PATH)
        COMPREPLY=($(compgen -f -- "$current"))
        compopt -o filenames 2>/dev/null
        ;;
    DIR*)
        COMPREPLY=($(compgen -d -- "$current"))
        compopt -o filenames 2>/dev/null
        ;;
    ?*)
        COMPREPLY=($(compgen -W '$("$glint" $command --_choices "$before=" 2>/dev/null)' -- "$current"))
        ;;
    *)
        case $current in
        -*)
            COMPREPLY=($(compgen -W '$(printf "%s\n" "$options" | sed "s/\(--.*=\).*/\1/; s/^\(-.\)=.*/\1/")' -- "$current"))
            case ${COMPREPLY[0]} in
            *=) compopt -o nospace 2>/dev/null ;;
            esac
            ;;
        *)
            COMPREPLY=($(compgen -W '$("$glint" $command --_choices "" 2>/dev/null)' -- "$current"))
            ;;
        esac
        ;;
    esac
}
complete -F _glint glint
