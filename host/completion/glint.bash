# SPDX-License-Identifier: MIT
# Completion for bash. It asks the command itself what it takes, so it is never out of date: --_options prints the options of
# a command, --_choices the names that an option or an argument takes.
_glint()
{
    local glint=${COMP_WORDS[0]} current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
    local command=() names=() taken= line choices= files=
    COMPREPLY=()
    # bash breaks words at =, so --model=ms are three.
    if [ "$current" = = ]; then
        current=
    elif [ "$before" = = ]; then
        before=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    if [ "$COMP_CWORD" -gt 1 ]; then
        command=("${COMP_WORDS[1]}")
    fi
    # Words of the line are compared, never made part of a program: a file's name may hold anything.
    while IFS=$'\t' read -r line _; do
        if [[ $line == "$before="* ]]; then
            taken=${line#"$before="}
        fi
        case $line in
        --*=*) names+=("${line%%=*}=") ;;
        *) names+=("${line%%=*}") ;;
        esac
    done < <("$glint" ${command[0]+"${command[@]}"} --_options 2>/dev/null)
    case $taken in
    *FILE*)
        files=-f
        ;;
    DIR*)
        files=-d
        ;;
    ?*)
        choices=$("$glint" ${command[0]+"${command[@]}"} --_choices "$before=" 2>/dev/null)
        ;;
    *)
        case $current in
        -*)
            choices=${names[*]}
            ;;
        *)
            choices=$("$glint" ${command[0]+"${command[@]}"} --_choices "" 2>/dev/null)
            ;;
        esac
        ;;
    esac
    if [ "$files" ]; then
        while IFS= read -r line; do
            COMPREPLY+=("$line")
        done < <(compgen $files -- "$current")
        compopt -o filenames 2>/dev/null
    else
        COMPREPLY=($(compgen -W '$choices' -- "$current"))
        if [[ ${COMPREPLY[0]-} == *= ]]; then
            compopt -o nospace 2>/dev/null
        fi
    fi
}
complete -F _glint glint
