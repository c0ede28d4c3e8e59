# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of domino's command line in fish. domino itself completes the commands that follow -e.

# Prints the commands typed so far after -e, each with a completion in the place of its last word.
function __domino_commands
    set -l typed (string trim --left --chars='"\'' -- (commandline --current-token))
    set -l head (string replace --regex '[^ ;]*$' '' -- $typed)
    for word in (domino --safe -e "complete $typed" 2>/dev/null)
        echo $head$word
    end
end

complete -c domino -s e -l execute -x -a '(__domino_commands)' -d 'Run commands'
complete -c domino -s f -l file -r -d 'Run a file of commands'
complete -c domino -s i -l interactive -d 'Then read commands from standard input'
complete -c domino -s n -l no-init -d 'Do not run the start-up file'
complete -c domino -l bail -d 'Stop at the first error'
complete -c domino -l keep-going -d 'Go on after errors'
complete -c domino -l safe -d 'Commands may not read or write files'
complete -c domino -l interruptible -d 'SIGINT ends the running command, not the program'
complete -c domino -l shard -x -d 'Compute only a part of a curve or sweep, such as 2/7'
complete -c domino -l help -d 'Print a summary of the options'
complete -c domino -l version -d 'Print the version'
