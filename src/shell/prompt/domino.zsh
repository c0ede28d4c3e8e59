#compdef domino
# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of domino's command line in zsh. domino itself completes the commands that follow -e.

# Completes the last word of the commands that follow -e.
_domino_commands() {
    local text=${(Q)PREFIX} last
    local -a found
    last=${text##*[ ;]}
    compset -P '*[ ;]'
    found=(${(f)"$(_call_program commands $words[1] --safe -e ${(q):-complete $text} 2>/dev/null)"})
    compadd -Q -U -S '' -a found
}

_arguments -s \
    '*'{-e,--execute}'[run commands]:commands:_domino_commands' \
    '*'{-f,--file}'[run a file of commands]:file:_files' \
    '(-i --interactive)'{-i,--interactive}'[then read commands from standard input]' \
    '(-n --no-init)'{-n,--no-init}'[do not run the start-up file]' \
    '(--keep-going)--bail[stop at the first error]' \
    '(--bail)--keep-going[go on after errors]' \
    '--safe[commands may not read or write files]' \
    '--interruptible[SIGINT ends the running command, not the program]' \
    '--shard[compute only a part of a curve or sweep]:part, such as 2/7' \
    '(-)--help[print a summary of the options]' \
    '(-)--version[print the version]' \
    '*:file of commands:_files'
