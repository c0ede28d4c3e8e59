# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Functions that the session suites share. "$DOMINO" is the program; nothing is written outside $BATS_TEST_TMPDIR.

bats_require_minimum_version 1.5.0

# A call of each command, and the keys of its answer in order.
# shellcheck disable=SC2034
commands='thetac|theta_c theta_u theta_inf theta_f theta_leave detaches
theta1 0.1|theta theta_1 slope arm_a arm_b
chain 0.1|i theta_i slope_i arm_a arm_b weight
energy 0.1|theta dH J J0
fuel|fuel fuel_exact fuel_paper
launch|omega0sq omega0 kinetic J0
omega 0.1|theta omegasq omega
barrier|theta_m barrier kinetic margin verdict
duration|duration tau seconds speed
cycle 3|event t theta theta_1 theta_2 omega kinetic potential
goto 0.1|cycle event theta t omega before lost gained fallen kinetic potential
where|cycle event theta t omega before lost gained fallen kinetic potential
why|verdict fuel J0 kinetic barrier margin r_max
rmax|s r_max ends_by r_max_exact r_max_paper r_start
rmax 0.3|s r_max ends_by r_max_exact r_max_paper r_start
pair|s r_max ends_by
pair 0.3|s r_max ends_by
best|s r_max
curve 0.3 0.5 3|s exact paper pair reach reason
count 112|height r dominoes exact first_height last_height feasible goes_on stops_at push r_start
count 112 2|height r dominoes exact first_height last_height feasible goes_on stops_at push r_start reason
slip|motion theta domino hit hit_domino slips slips_hit
effect row 5; fall|domino height hit falls omega kinetic barrier margin energy
effect row 5; effect floor 0.5; fall|domino height hit falls omega kinetic barrier margin energy floor floor_hit
effect row 5; verdict|verdict domino short_by seconds weakest spare
effect row 3; set mass 1; row|domino height thickness gap mass
effect row 3; tolerance|domino place from to gap gap_low gap_high height height_low height_high thickness thickness_low thickness_high lean lean_low lean_high friction_low friction_high first
effect row 5; rowmax|s count r_max r_train
design 1|s r steps feet length mass safety weakest train seconds probability low
sensitivity rmax|parameter value step less more
solve d : rmax = 5/3|value answer branch
effect row 4; effect placement 5 mm; placement 50|sigma heights rows fall probability low high unknown stops_most errors
effect row 4; effect placement 5 mm; budget 0.9 50|probability sigma low high rows scaled
reset; effect friction 0.2; goto 0.1|cycle event theta t omega before lost gained fallen kinetic potential rubbed
fewest 112|kind start dominoes r s gap last reach reason
landmarks|name height what source
print 0.1|value unit'

# Runs commands (with ';' or newlines) in one of the ways that need no terminal.
session() { # WAY COMMANDS
    local way=$1 text=$2 script=$BATS_TEST_TMPDIR/session.dom
    case $way in
    -e) "$DOMINO" -e "$text" ;;
    stdin) printf '%s\n' "$text" | "$DOMINO" ;;
    -f) printf '%s\n' "$text" >"$script" && "$DOMINO" -f "$script" ;;
    '#!')
        ln -sf "$DOMINO" "$BATS_TEST_TMPDIR/domino" # '#!' needs a path without blanks
        printf '#!%s -f\n%s\n' "$BATS_TEST_TMPDIR/domino" "$text" >"$script"
        chmod +x "$script"
        "$script"
        ;;
    esac
}

json() {
    "$DOMINO" --keep-going -e "set output json; $1" | bare
    return "${PIPESTATUS[0]}"
}

# Removes from json the key that names the command, and objects without an answer.
bare() {
    sed -uE '/^\{"command":"[a-z0-9]*"\}$/d; /^\{"command":[^,]*,"error":/d; s/^\{"command":"[a-z0-9]*",/{/'
}

# 'keys' prints the keys of the first json answer on stdin. 'values' prints the value of a key in each answer
# that has the key.
keys() { bare | head -n 1 | grep -o '"[A-Za-z0-9_]*":' | tr -d '":' | paste -sd ' ' -; }
values() { sed -En "s/^(.*,|\{)\"$1\":(\"[^\"]*\"|[^,}]*).*/\2/p" | tr -d '"'; }

# The contents of a csv file with a row.
# shellcheck disable=SC2034
two_dominoes='height (mm), thickness (mm), gap (mm)
48, 7, -
48, 7, 20'

# The folder of the sources. Nothing is written there.
# shellcheck disable=SC2034
root=${BATS_TEST_DIRNAME%/tests/*}

# Checks before every test that the program runs. Without this check, tests that expect nothing to happen
# would pass. Each test begins in an empty folder.
setup() { begin; }
begin() { answers_at_all && mkdir -p "$BATS_TEST_TMPDIR/work" && cd "$BATS_TEST_TMPDIR/work" || exit; }
answers_at_all() { same 'the program' 42 "$("$DOMINO" -e 'print 6*7' 2>&1)"; }

csv() { "$DOMINO" -e "set output csv; $1"; }
file() { cat >"$1"; }
completed() { "$DOMINO" -e "complete $1" | paste -sd ' ' -; }
inside() { find . ! -name . | sed 's,^\./,,' | LC_ALL=C sort | paste -sd , -; }
mode() { find "$1" -prune -perm "$2"; }
# Runs a program with a time limit, so that no test waits forever.
soon() { timeout 100 "$@"; }

# Runs a scenario at a terminal. The scenarios of NAME.bats are in NAME.exp.
prompt() { timeout 300 expect -f "${BATS_TEST_FILENAME%.bats}.exp" "$@" </dev/null; }

# Fails if an expected text is empty, because then a program that prints nothing would pass. To expect
# nothing, write '(nothing)'.
expects() { # WHAT EXPECTED
    [[ $2 == *[![:space:]]* ]] || { printf '%s: the expectation is empty\n' "$1" && false; }
}

# Checks that two texts are equal, and prints the difference. In json, the key that names the command is
# ignored.
same() { # WHAT EXPECTED OBTAINED
    expects "$1" "$2" || return
    local expected=$2 obtained=$3
    [ "$2" != '(nothing)' ] || expected=''
    if [[ $2$3 == *'{"command":'* ]]; then expected=$(bare <<<"$expected") obtained=$(bare <<<"$3"); fi
    [ "$expected" = "$obtained" ] || { printf '%s\nexpected: %s\nobtained: %s\n' "$1" "$2" "$3" && false; }
}

# Checks that two answers exist and differ, because comparing empty or constant answers would prove nothing.
differ() { # WHAT ONE OTHER
    expects "$1" "$2" && expects "$1" "$3" || return
    [ "$2" != "$3" ] || { printf '%s\ntwice: %s\n' "$1" "$2" && false; }
}

# Checks that two files are equal and not empty.
same_file() { # EXPECTED OBTAINED
    [ -s "$1" ] || { printf '%s: the expectation is empty\n' "$1" && return 1; }
    diff -u "$1" "$2"
}

# Checks that numbers agree to a relative error of BOUND, by default 1e-10, or to 1e-15 if the value is 0.
# '(nothing)' stands for null.
close() { # WHAT EXPECTED OBTAINED [BOUND]
    expects "$1" "$2" || return
    awk -v e="$2" -v o="$3" -v bound="${4:-1e-10}" 'BEGIN {
        if (e == "(nothing)") exit !(o == "null")
        number = "^[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?$"
        if (e !~ number || o !~ number) exit 1
        error = e - o; if (error < 0) error = -error
        size = e < 0 ? -e : +e
        exit !(error <= bound * size + 1e-15)
    }' || { printf '%s\nexpected: %s\nobtained: %s\n' "$1" "$2" "$3" && false; }
}

# Checks an awk condition, in which d is the relative difference of the two numbers.
within() { # WHAT EXPECTED OBTAINED CONDITION
    if [[ $2 =~ [0-9] && $3 =~ [0-9] ]] && awk -v e="$2" -v o="$3" "BEGIN { d = o / e - 1; exit !($4) }"; then
        return 0
    fi
    printf '%s\nexpected: %s, %s\nobtained: %s\n' "$1" "$2" "$4" "$3"
    return 1
}

# Checks that commands run without an error, and that their answer contains each text, however its lines are broken.
# shellcheck disable=SC2154 # bats sets output
says() { # COMMANDS TEXT...
    local text
    run -0 "$DOMINO" -n -e "$1"
    for text in "${@:2}"; do
        expects "$1" "$text"
        [[ $(tr -s ' \n' ' ' <<<"$output") == *"$text"* ]] || same "$1" "$text" "$output"
    done
}

# Checks that a command fails with a one-line message that matches PATTERN, and that the session goes on. Sets
# the variables of 'run'.
# shellcheck disable=SC2154
wrong() { # COMMANDS PATTERN
    run --separate-stderr "$DOMINO" --keep-going -e "$1; print 41 + 1"
    [ "$status" -eq 1 ] || same "$1: status" 1 "$status"
    [ "$(wc -l <<<"$stderr")" -eq 1 ] || same "$1: one line" 1 "$stderr"
    expects "$1" "$2" || return
    grep -qE -- "$2" <<<"$stderr" || same "$1" "$2" "$stderr"
    [ "${lines[-1]}" = 42 ] || same "$1: goes on" 42 "$output"
}

# Like 'wrong', but also checks that the command writes nothing to standard output.
wrong_line() { # COMMANDS PATTERN
    wrong "$@"
    [ "$output" = 42 ] || same "$1: no row, and it goes on" 42 "$output"
}

# Checks lines LINE|ANSWER on stdin. ANSWER must be the last line of the output of LINE.
all_print() {
    local line answer
    while IFS='|' read -r line answer; do same "$line" "$answer" "$("$DOMINO" -e "$line" | tail -n 1)"; done
}

# Checks lines LINE|COMMANDS on stdin. LINE and COMMANDS must have the same json output.
all_mean() {
    local line commands
    while IFS='|' read -r line commands; do same "$line" "$(json "$commands")" "$(json "$line")"; done
}

# Checks the output of 'print' for lines VALUE|UNIT|EXPRESSION on stdin, where '-' means no unit.
all_worth() {
    local value unit expression rows answers
    mapfile -t rows
    mapfile -t answers < <({ echo 'set output json'; printf 'print %s\n' "${rows[@]#*|*|}"; } | "$DOMINO")
    same 'one answer each' "${#rows[@]}" "${#answers[@]}"
    for i in "${!rows[@]}"; do
        IFS='|' read -r value unit expression <<<"${rows[i]}"
        close "$expression" "$value" "$(values value <<<"${answers[i]}")"
        [ "$unit" != - ] || unit='(nothing)'
        same "$expression: unit" "$unit" "$(values unit <<<"${answers[i]}")"
    done
}

# Checks lines COLUMN|COMMAND|MESSAGE on stdin in one session. Each command must fail with one error at the
# column, and must change no parameter. The message must match the regular expression MESSAGE. Column 0 means
# that the error is about the whole command.
all_wrong() { # [WAY...]: how domino gets the commands: stdin, -e, or the name of a file to write
    local column command message place way rows errors i each=()
    mapfile -t rows
    "$DOMINO" -e 'set output json; show' >"$BATS_TEST_TMPDIR/shown"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/shown")" -gt 15 ] || same 'what is shown' 'all parameters' "$(cat "$BATS_TEST_TMPDIR/shown")"
    for i in "${!rows[@]}"; do
        IFS='|' read -r column command message <<<"${rows[i]}"
        printf '%s\nset output json; show\nreset\n' "$command" >&3
        cat "$BATS_TEST_TMPDIR/shown"
        each+=(-e "$command" -e 'set output json; show; reset')
    done 3>"$BATS_TEST_TMPDIR/rows" >"$BATS_TEST_TMPDIR/expected"
    for way in "${@:-stdin}"; do
        case $way in
        -e) run -1 --separate-stderr "$DOMINO" --keep-going "${each[@]}" ;;
        stdin) run -1 --separate-stderr "$DOMINO" <"$BATS_TEST_TMPDIR/rows" ;;
        *) cp "$BATS_TEST_TMPDIR/rows" "$way" && run -1 --separate-stderr "$DOMINO" --keep-going -f "$way" ;;
        esac
        bare <<<"$output" | diff -u <(bare <"$BATS_TEST_TMPDIR/expected") - || same "${rows[0]} and more ($way)" 'parameters do not change' 'they do'
        mapfile -t errors <<<"$stderr"
        same "${rows[0]} and more ($way): lines on stderr" "${#rows[@]}" "${#errors[@]}"
        for i in "${!rows[@]}"; do
            IFS='|' read -r column command message <<<"${rows[i]}"
            place=$way:$((3 * i + 1)):
            if [ "$way" = -e ]; then place=-e:1:; fi
            if [ "$column" -gt 0 ]; then place=$place$column:; fi
            same "$command ($way): place" "$place" "${errors[i]%% *}"
            expects "$command" "$message"
            [[ ${errors[i]#* } =~ $message ]] || same "$command ($way)" "$message" "${errors[i]}"
        done
    done
}
wrong_at() { all_wrong stdin <<<"$1|$2|$3"; } # COLUMN COMMANDS MESSAGE

# Prints the options for linking with a library that was built with sanitizers or for coverage.
checked() {
    if nm "$1" 2>/dev/null | grep -q __asan_init; then echo -fsanitize=address,undefined; fi
    if nm "$1" 2>/dev/null | grep -q __gcov_init; then echo --coverage; fi
}

# Prefers the system's Python, because another Python that is first on PATH may have no NumPy.
python() { if [ -x /usr/bin/python3 ]; then /usr/bin/python3 "$@"; else python3 "$@"; fi; }
