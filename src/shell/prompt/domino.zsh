#compdef domino
# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of domino's command line in zsh; what may stand in -e comes from domino itself.

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
    '(-n --no-init)'{-n,--no-init}'[read no start-up file]' \
    '(--keep-going)--bail[end after the first error]' \
    '(--bail)--keep-going[go on after an error]' \
    '--safe[touch no files]' \
    '--interruptible[an interrupt ends the command, not the program]' \
    '--shard[compute a part of sweeps and studies]:part, such as 2/7' \
    '(-)--help[show how the program is called]' \
    '(-)--version[show the version]' \
    '*:file of commands:_files'
