#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Hostile text: names with control characters, and endless lines.

load common

# Checks that a file is UTF-8 without control characters other than line breaks, and without characters that
# change the direction of writing.
harmless() { # FILE
    iconv -f UTF-8 -t UTF-8 "$1" >/dev/null || same "$1: UTF-8" '(nothing)' "$(cat -v "$1")"
    if LC_ALL=C grep -aqP '[\x00-\x09\x0b-\x1f\x7f]|\xc2[\x80-\x9f]|\xe2\x80[\xa8-\xae]|\xe2\x81[\xa6-\xa9]' "$1"; then
        same "$1: control characters" '(nothing)' "$(cat -v "$1")"
    fi
}

# bats test_tags=rows,chance,sweeps,explain,save
@test "names that cannot be shown are escaped in table, csv, json, help and messages" {
    local name=$'a\e[31m\u202e\u009b\xff\tb.csv' shown='a\x1b[31m\u202e\u009b\xff\x09b.csv'
    printf '%s\n' "$two_dominoes" >"$name"
    printf '%s\n' "effect row \"$name\"" >"s $name"
    printf '%s\n' "effect row \"$name\"; effects; help row" >table.dom
    "$DOMINO" table.dom >table 2>&1
    harmless table
    grep -qF "row        $shown" table
    grep -qF "now      $shown" table
    printf '%s\n' "effect row \"$name\"; set output csv; effects" | "$DOMINO" >csv
    harmless csv
    grep -qF "row,$shown" csv
    printf '%s\n' "effect row \"$name\"; set output json; effects" | "$DOMINO" >json
    harmless json
    jq -es 'map(select(.effect)) | length >= 8' json
    # A program reads the same characters from json, except for invalid bytes.
    same 'json' $'a\e[31m\u202e\u009b\ufffd\tb.csv' "$(jq -r 'select(.effect == "row").state' json)"
    printf '%s\n' "source \"s $name\"" "source \"no$name\"" "effect row \"no$name\"" "foo$name" \
        "save \"/no/$name\"" "verdict > \"/no/$name\"" "apropos $name" "set $name 1" "print 1 $name" \
        "sweep $name 1" >messages.dom
    run -1 --separate-stderr "$DOMINO" --keep-going messages.dom "s no$name"
    printf '%s\n' "$stderr" >messages
    harmless messages
    same 'a line each' 10 "$(wc -l <messages)"
    # The name of a script is at the beginning of its messages, and must not hide them. A csv file would be a row.
    name=${name%.csv}.dom shown=${shown%.csv}.dom
    printf 'foo\n' >"$name"
    run -1 --separate-stderr "$DOMINO" "$name"
    printf '%s\n' "$stderr" >messages
    harmless messages
    grep -qF "$shown:1:1: unknown command 'foo'" messages
}

# Texts that a program could run, or could show as something else.
hostile_texts=('`touch P1`' "'.system(\"touch P1\").'" "'; system 'touch P1" '".system("touch P1")."' '!touch P1' '|touch P1' '$(touch P1)'
    '; touch P1;' "'''" "'@GPVAL_TERM" "it's @GPVAL_TERM" '@A @@B' '\\' '\n\101\"' '{/Symbol a}_b^c' '%s%n%d' '# x' '<&>' '\input{x}$y$~#^^41' 'é θ 你好')

# Types a text as it stands between double quotes.
typed() { printf '"%s"' "${1//\"/\"\"}"; }

# Prints the texts of an svg, a line each.
svg_texts() { xmllint --xpath '//*[local-name()="text"]' "$1" | sed 's/<[^>]*>//g; s/&lt;/</g; s/&gt;/>/g; s/&amp;/\&/g'; }

# bats test_tags=rows,pictures,planning
@test "a text in a picture is shown as it is typed, and gnuplot never runs it: in every format, and when a .gp is drawn" {
    local text
    for text in "${hostile_texts[@]}"; do
        "$DOMINO" -e "set r 1.4; effect row 4; plan title $(typed "$text") > plan.gp; plan title $(typed "$text") > plan.svg"
        svg_texts plan.svg >texts
        grep -qxF -- "$text" texts || same plan "$text" "$(cat texts)"
        gnuplot plan.gp
        same "$text: plan.gp" %PDF- "$(head -c 5 plan.pdf)"
        same "$text" 'plan.gp plan.pdf plan.svg texts' "$(ls | paste -sd ' ' -)"
    done
}

# bats test_tags=rows,pictures,planning
@test "bytes that cannot be shown are escape sequences in a title, too" {
    "$DOMINO" -e "set r 1.4; effect row 4; plan title \"$(printf 'a\001\t\033\177\200\377z')\" > a.svg"
    svg_texts a.svg | grep -qxF -- 'a\x01\x09\x1b\x7f\x80\xffz' || same title 'escapes' "$(svg_texts a.svg | head -n 3)"
}

# bats test_tags=rows,pictures
@test "the name of a file is a name, not a command, for gnuplot too" {
    local name
    for name in '|touch P1;' '`touch P1`' "'.system('touch P1').'" '"' '~' '!x' '-' '|cat>P1' '%d' ' a ' '$HOME' 'a\b' '<x'; do
        "$DOMINO" -e "draw > $(typed "$name.gp"); plot growth > $(typed "$name.svg"); set row 2; animate > $(typed "$name.gif")"
        gnuplot - <"./$name.gp"
        same "$name" %PDF- "$(head -c 5 "./$name.pdf")"
        same "$name" "$(printf '%s\n' "$name".{gif,gp,pdf,svg} | LC_ALL=C sort)" "$(LC_ALL=C ls)"
        rm -f -- ./*
    done
}

@test "completion offers no name with control characters" {
    touch row.csv $'r\e[31m' $'r\u009b' $'r\u202e' $'r\nx'
    same files row.csv "$("$DOMINO" -e 'complete source r')"
}

# bats test_tags=rows,save
@test "a line break in the name of a csv file does not smuggle a command into a saved session" {
    local folder=$'x"\nprint 41 + 1\n"'
    mkdir "$folder" && printf '%s\n' "$two_dominoes" >"$folder/row.csv" && ln -s "$folder/row.csv" link.csv
    run -1 --separate-stderr "$DOMINO" --keep-going -e 'effect row link.csv; save s.dom'
    [[ $stderr == *'contains a control character'* ]] || same message 'control character' "$stderr"
    [ ! -e s.dom ]
    (cd "$folder" && "$DOMINO" -e 'effect row row.csv' -e 'save ../s.dom' || true)
    [ ! -e s.dom ]
}

# bats test_tags=rows,chance
@test "endless NUL bytes: the first one ends the file, and the session goes on" {
    for command in 'source /dev/zero' 'effect row /dev/zero'; do
        run -1 --separate-stderr timeout 30 "$DOMINO" --keep-going -e "$command; print 41 + 1"
        [[ $stderr =~ (NUL|too long) ]] || same "$command" 'why not' "$stderr"
        same "$command: goes on" 42 "$output"
    done
    run -1 --separate-stderr timeout 30 "$DOMINO" --keep-going - -e 'print 41 + 1' </dev/zero
    same 'standard input' 'stdin:1: the line contains a NUL byte; commands are text' "$stderr"
    same 'the next source' 42 "$output"
}

# bats test_tags=rows,chance
@test "an endless line: one message, little memory, and the session goes on" {
    # A line of 100 MB in a session that may take 200 MB, except under sanitizers, which need more
    # memory.
    line() { head -c 100000000 /dev/zero | tr '\0' 7 && printf '\nprint 41 + 1\n'; }
    endless() { ulimit -v 200000 && "$@"; }
    (endless "$DOMINO" -V) >/dev/null 2>&1 || endless() { "$@"; }
    run -1 --separate-stderr endless "$DOMINO" --keep-going -n < <(line)
    same 'stdin' 'stdin:1: the line is longer than 4 MB; put each command on a line of its own' "$stderr"
    same 'goes on' 42 "$output"
    line >long
    for command in 'source long' 'effect row long'; do
        run -1 --separate-stderr endless "$DOMINO" --keep-going -e "$command; print 41 + 1"
        [[ $stderr =~ (line\ is\ longer|file\ is\ larger) ]] || same "$command" 'too long' "$stderr"
        same "$command" 42 "${lines[-1]}"
    done
}

# bats test_tags=sweeps
@test "every byte of a text reaches a terminal, a file, csv and json as itself or as an escape sequence" {
    local byte
    for byte in {1..9} {11..255}; do
        printf 'echo "a%b,;=b"\n' "$(printf '\\x%02x' "$byte" | sed 's/\\x22/""/')"
    done >all.dom
    for format in table csv json; do
        { echo "set output $format"; cat all.dom; } >script.dom
        "$DOMINO" script.dom >$format
        harmless $format
    done
    python3 "$BATS_TEST_DIRNAME/terminal.py" 80 24 "$DOMINO" -n all.dom >terminal
    harmless terminal
    same_file table terminal
    python3 - <<'END'
import csv, json
typed = [bytes([k]) for k in range(1, 256) if k != 10]
plain = [k.decode() if 32 <= k[0] <= 126 else "\\x%02x" % k[0] for k in typed]
rows = [row[0] for row in csv.reader(open("csv", encoding="utf-8", newline=""))][1:]
assert rows == ["a%s,;=b" % k for k in plain], rows
table = open("table", encoding="utf-8").read().split("\n")[:-1]
assert table == ["a%s,;=b" % k for k in plain], table
answers = [json.loads(line) for line in open("json", encoding="utf-8")]
texts = [answer["text"] for answer in answers if answer["command"] == "echo"]
assert texts == ["a%s,;=b" % (k.decode() if k[0] < 128 else "\ufffd") for k in typed], texts
END
}
