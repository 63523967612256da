# bash completion for cagd
_cagd() {
    local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]}
    if [ "$COMP_CWORD" -eq 1 ]; then
        COMPREPLY=($(compgen -W "verify list show ledger figures curve fit --help --version" -- "$word"))
    elif [[ $word == -* ]]; then
        case $command in
        verify) COMPREPLY=($(compgen -W "--json --tap --junit --certificates --report --jobs --deep --shard --help" -- "$word")) ;;
        ledger) COMPREPLY=($(compgen -W "--json --summary --striking --jobs --help" -- "$word")) ;;
        show) COMPREPLY=($(compgen -W "--json --jobs --help" -- "$word")) ;;
        figures) COMPREPLY=($(compgen -W "--out --list --jobs --help" -- "$word")) ;;
        curve)
            COMPREPLY=($(compgen -W "--at --derivatives --left --insert --remove --elevate --reduce --split --bezier --json \
                --help" -- "$word")) ;;
        fit)
            COMPREPLY=($(compgen -W "--degree --knots --control-points --free --initial --weights-between --loss --scale \
                --unordered --dim --sigma-column --sigma --starts --seed --tolerance --max-iterations --no-verify --json \
                --verbose --curve --residuals --svg --help" -- "$word")) ;;
        *) COMPREPLY=($(compgen -W "--json --help" -- "$word")) ;;
        esac
    elif [ "$command" = figures ]; then
        COMPREPLY=($(compgen -W "$(cagd figures --list 2>/dev/null)" -- "$word"))
    elif [ "$command" = fit ] && [ "${COMP_WORDS[COMP_CWORD - 1]}" = --loss ]; then
        COMPREPLY=($(compgen -W "squares huber cauchy" -- "$word"))
    elif [ "$command" = fit ] && [ "${COMP_WORDS[COMP_CWORD - 1]}" = --free ]; then
        COMPREPLY=($(compgen -W "weights inner ends weights,inner weights,inner,ends none" -- "$word"))
    elif [ "$command" = curve ] || [ "$command" = fit ]; then
        COMPREPLY=($(compgen -f -- "$word"))
    else
        COMPREPLY=($(compgen -W "$(cagd list 2>/dev/null | cut -d' ' -f1)" -- "$word"))
    fi
}
complete -F _cagd cagd
