# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Completion of domino's command line in bash; what may stand in -e comes from domino itself.
_domino() {
    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} words
    case $prev in
    -e | --execute)
        words=$("$1" --safe -e "complete ${cur#[\"\']}" 2>/dev/null)
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "${cur#[\"\']}")
        return
        ;;
    esac
    case $cur in
    -*) mapfile -t COMPREPLY < <(compgen -W '-e -f -n --execute --file --no-init --bail --safe --help --version' -- "$cur") ;;
    *) mapfile -t COMPREPLY < <(compgen -f -- "$cur") ;;
    esac
}
complete -o filenames -F _domino domino
