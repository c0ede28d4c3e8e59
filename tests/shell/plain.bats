#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Texts for people are in plain words: README, man pages and help avoid those of tests/plain-words.

load common

root=$BATS_TEST_DIRNAME/../..

# Prints the lines of a text on stdin that have a word of tests/plain-words: name, line, what is better, the line.
violations() { # NAME
    awk -v name="$1" -F '\t' '
        FNR == NR { if (!/^#/) { word[++n] = "(^|[^a-z_-])(" $1 ")([^a-z_-]|$)"; better[n] = $2 } next }
        { text = tolower($0)
          for (i = 1; i <= n; i++)
              if (text ~ word[i]) printf "%s:%d: better: %s: %s\n", name, FNR, better[i], $0 }' "$root/tests/plain-words" -
}

# The help of every command, parameter and effect, one after the other.
all_help() {
    { echo help; "$DOMINO" -e 'complete help ' | sed 's/^/help /'; } | "$DOMINO" -
}

# What a man page repeats of help or of the library's lists is theirs: sentences of the summaries, of the meanings of
# parameters, of statuses and of the ends of a row.
of_help() {
    {
        "$DOMINO" -e help | sed -nE 's/^  ([^ ].{20})(.*)/\2/p'
        json show | values meaning
        printf '#include <domino.h>\n#define TEXT(name, text) @text@\nDOM_STATUSES(TEXT) DOM_ROW_ENDS(TEXT)\n' |
            cc -E -P -I"$root/include" -x c - | sed -n '/@/{s/" *"//g;s/@"/\n@/g;s/"@/@/g;p}' | sed -nE 's/^@(.*)@ *$/\1/p'
    } | sed -E 's/^(.)(.*)$/\U\1\E\2./'
}

@test "words that are not plain are found" {
    for line in 'The file stands behind it.' 'Massive dominoes fall off.' 'Whoever calls is told.'; do
        expects "$line" "$(violations text <<<"$line")"
    done
    same 'plain' '(nothing)' "$(violations text <<<'A solid domino detaches; understand whole words only: outside, goodwho.')"
    [ "$(grep -vc '^#' "$root/tests/plain-words")" -ge 20 ]
}

@test "README and man pages are in plain words" {
    of_help >"$BATS_TEST_TMPDIR/help"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/help")" -ge 60 ]
    for text in README.md src/README.md man/domino.1 man/domino-{effects,model,rows}.7 man/libdomino.3; do
        # An empty line instead of each line from help keeps the line numbers.
        "$root/tests/prose" "$root/$text" |
            awk 'FNR == NR { help[$0]; next } $0 in help { $0 = "" } 1' "$BATS_TEST_TMPDIR/help" - >"$BATS_TEST_TMPDIR/prose"
        [ "$(grep -c '[a-z]' "$BATS_TEST_TMPDIR/prose")" -ge 50 ]
        same "$text" '(nothing)' "$(violations "$text" <"$BATS_TEST_TMPDIR/prose")"
    done
}

@test "help is in plain words" {
    all_help >"$BATS_TEST_TMPDIR/help"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/help")" -ge 900 ]
    violations help <"$BATS_TEST_TMPDIR/help" >"$BATS_TEST_TMPDIR/found"
    same help '(nothing)' "$(cat "$BATS_TEST_TMPDIR/found")"
}

# The texts that the shell passes to the functions that report errors or print sentences, a literal on a line.
source_messages() {
    for source in "$root"/src/shell/*/*.c "$root"/src/shell/*/*/*.c; do
        tr '\n' ' ' <"$source" | grep -oE '\b(session_(error|no_answer|report)|expression_fail|wrong|answer_say)\([^;]*;' |
            sed -E 's/" +"//g' | grep -oE '"([^"\\]|\\.)*[a-z]([^"\\]|\\.)*"' || true # a file without messages
    done
}

# The messages that the lines of errors.bats provoke.
provoked_messages() {
    sed -nE 's/^([^|]*)\|[0-9]+\|.*/\1/p' "$BATS_TEST_DIRNAME/errors.bats" | "$DOMINO" --keep-going - 2>&1 >/dev/null | sed -E 's/^[^ ]* //'
}

@test "messages are in plain words" {
    source_messages >"$BATS_TEST_TMPDIR/source"
    [ "$(wc -l <"$BATS_TEST_TMPDIR/source")" -ge 150 ]
    provoked_messages >"$BATS_TEST_TMPDIR/provoked" || true
    [ "$(wc -l <"$BATS_TEST_TMPDIR/provoked")" -ge 80 ]
    for kind in source provoked; do
        violations "$kind" <"$BATS_TEST_TMPDIR/$kind" >"$BATS_TEST_TMPDIR/found"
        same "$kind" '(nothing)' "$(cat "$BATS_TEST_TMPDIR/found")"
    done
}

@test "the README is read to its end: at most 180 lines, and its picture is there, and small" {
    [ "$(wc -l <"$root/README.md")" -le 180 ]
    pictures=$(grep -oE '\(examples/pictures/[^)]*\)' "$root/README.md" | tr -d '()')
    expects pictures "$pictures"
    for picture in $pictures; do
        [ "$(wc -c <"$root/$picture")" -lt 300000 ]
        same "$picture" GIF89a "$(head -c 6 "$root/$picture")"
    done
    # Links lead to files.
    for link in $(grep -oE '\]\([a-z][^:)]*\)' "$root/README.md" | tr -d ']()'); do
        [ -e "$root/$link" ] || { echo "$link"; false; }
    done
}

@test "comments and names of tests are in plain words, and ask no questions" {
    same comments '(nothing)' "$("$root/tests/comments")"
    # What is wrong is found: words, at the first line of the comment, and questions; not in strings.
    printf '%s\n' 'int a; /* Nobody' ' * reads it. */' '/* Is it over? */ char *b = "who /* knows */";' >"$BATS_TEST_TMPDIR/bad.c"
    run "$root/tests/comments" "$BATS_TEST_TMPDIR/bad.c"
    [ "$status" = 1 ]
    [[ ${lines[0]} = *'bad.c:1: better: name the subject'* ]]
    [[ ${lines[1]} = *'bad.c:3: a question: Is it over?'* ]]
    [ "${#lines[@]}" = 2 ]
    printf '%s\n' '# It stands' '# behind it.' 'echo "# who"' '@test "nobody" {' >"$BATS_TEST_TMPDIR/bad.bats"
    run "$root/tests/comments" "$BATS_TEST_TMPDIR/bad.bats"
    [ "$status" = 1 ]
    [[ ${lines[0]} = *'bad.bats:1: better: after'*': It stands behind it.' ]]
    [[ ${lines[1]} = *'bad.bats:4: better: name the subject'* ]]
    [ "${#lines[@]}" = 2 ]
}

@test "each equation is cited with the number that the paper prints, and the table lists the files" {
    same equations '(nothing)' "$("$root/tests/equations")"
}
