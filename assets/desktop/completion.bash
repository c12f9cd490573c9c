# Completion of shading-sandbox for bash. Commands and options are read from the program's own --help, names from `list`.

# The names under one heading of `list`: Scenes, Lessons, Exercises, ...
_shading_sandbox_names() {
    "$1" list 2>/dev/null | sed -n "/^$2\$/,/^\$/s/^  \([^ ]*\).*/\1/p"
}

_shading_sandbox() {
    local cur prev words cword split
    _init_completion -s || return

    # The command: the first word that is one.
    local commands command= word
    commands=$("$1" --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
    for word in "${words[@]:1:cword-1}"; do
        if [[ " ${commands//$'\n'/ } " == *" $word "* ]]; then
            command=$word
            break
        fi
    done

    case $prev in
        --technique | --left | --right)
            local frequencies models
            frequencies=$("$1" list 2>/dev/null | sed -n '/^  Frequencies$/,/^$/s/^    \([^ ]*\).*/\1/p')
            models=$("$1" list 2>/dev/null | sed -n '/^  Models$/,/^$/s/^    \([^ ]*\).*/\1/p')
            COMPREPLY=($(compgen -W "$(for word in $frequencies; do printf "$word/%s " $models; done)" -- "$cur"))
            return
            ;;
        --lang) COMPREPLY=($(compgen -W 'en zh' -- "$cur")) && return ;;
        --profile) COMPREPLY=($(compgen -W 'core es' -- "$cur")) && return ;;
        --backend) COMPREPLY=($(compgen -W 'egl glfw' -- "$cur")) && return ;;
        --display) COMPREPLY=($(compgen -W 'linear srgb' -- "$cur")) && return ;;
        --lesson) COMPREPLY=($(compgen -W "$(_shading_sandbox_names "$1" Lessons)" -- "$cur")) && return ;;
        --exercise) COMPREPLY=($(compgen -W "$(_shading_sandbox_names "$1" Exercises)" -- "$cur")) && return ;;
        --case) COMPREPLY=($(compgen -W "$(_shading_sandbox_names "$1" 'Stability cases')" -- "$cur")) && return ;;
    esac
    if [[ $cur == -* ]]; then
        COMPREPLY=($(compgen -W "$(_parse_help "$1" "${command:+$command }--help")" -- "$cur"))
        [[ ${COMPREPLY-} == *= ]] && compopt -o nospace
        return
    fi

    # A name of what the command takes, or a file.
    local names=
    case $command in
        '') names="$commands $(_shading_sandbox_names "$1" Scenes)" ;;
        lesson) names="all gallery $(_shading_sandbox_names "$1" Lessons) $(_shading_sandbox_names "$1" 'Famous bugs')" ;;
        mark) names=$(_shading_sandbox_names "$1" Exercises) ;;
        list | stability) ;;
        *) names=$(_shading_sandbox_names "$1" Scenes) ;;
    esac
    _filedir
    COMPREPLY+=($(compgen -W "$names" -- "$cur"))
} &&
    complete -F _shading_sandbox shading-sandbox
