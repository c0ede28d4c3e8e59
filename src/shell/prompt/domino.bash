# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Completion of domino's command line in bash. domino itself completes the commands that follow -e.
_domino() {
    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} text last head word
    COMPREPLY=()
    case $prev in
    -e | --execute)
        # Only the last word of the commands is completed. The words before it stay as they are.
        text=${cur#[\"\']}
        last=${text##*[ ;]}
        head=${text%"$last"}
        while IFS= read -r word; do
            [ -n "$word" ] && COMPREPLY+=("$head$word")
        done < <("$1" --safe -e "complete $text" 2>/dev/null)
        return
        ;;
    esac
    case $cur in
    -*) mapfile -t COMPREPLY < <(compgen -W '-e -f -i -n --execute --file --interactive --no-init --bail --keep-going --safe --interruptible --shard --help --version' -- "$cur") ;;
    *) mapfile -t COMPREPLY < <(compgen -f -- "$cur") ;;
    esac
}
complete -o filenames -F _domino domino
