#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Fit: parameters from measured speeds, times of rows, and times of hits, by camera or by sound.

load ../shell/common

@test "fit: the published friction of each surface" {
    measured=$BATS_TEST_DIRNAME/../../examples/measured
    while read -r file d mu; do
        within "$file" "$mu" "$(json "set d $d/48; fit friction $measured/$file.csv" | values friction | head -n 1)" \
            'd < 2e-3 && d > -2e-3'
    done <<'END'
laboratory 7.5 0.294
sandpaper 7.5 0.711
END
    # The published friction is 0.067. It was fitted with another speed at the widest gap, where only a range is known.
    fit=$(json "set d 7.5438/48; fit friction $measured/hard-floor.csv")
    awk -v mu="$(values friction <<<"$fit" | head -n 1)" -v sd="$(values friction_sd <<<"$fit" | head -n 1)" \
        'BEGIN { exit !(sd > 0.005 && sd < 0.03 && mu - 0.067 < sd && 0.067 - mu < sd) }'
}

# bats test_tags=chance
@test "fit: the friction of the model is found from speeds of the model, with and without errors" {
    for gap in 8 12 20 30; do
        echo "$gap,$(json "set r 1; set s $gap/48; effect friction 0.25; duration" | values speed),0.01"
    done >rows
    { echo 'gap (mm), speed (m/s), error (m/s)'; cat rows; } >errors.csv
    { printf 'Spacing [mm];Velocity [m/s]\n' && sed 's/,0.01$//; s/,/;/; s/\./,/' rows; } >commas.csv
    for file in errors commas; do
        close "$file" 0.25 "$(json "fit friction $file.csv" | values friction | head -n 1)" 1e-5
    done
    # The uncertainty is proportional to the errors.
    wide=$(json 'fit friction errors.csv' | values friction_sd | head -n 1)
    sed -i 's/,0\.01$/,0.005/' errors.csv
    close uncertainty "$wide" "$(json 'fit friction errors.csv' | values friction_sd | head -n 1 | awk '{ print 2 * $1 }')" 1e-3
    printf 'gap (mm), speed (m/s)\n9, 2\n15, 2\n' >fast.csv
    says 'fit friction fast.csv' 'The best fit is friction 0, which is the limit of its range.'
}

# bats test_tags=rows,chance
@test "fit: an error in a file gives a one-line message" {
    : >empty.csv
    printf 'gap (mm), speed (m/s)\n9, 1.3\n9, 1.31\n' >one.csv
    printf 'gap (mm), speed (m/s), error (m/s)\n9, 1.3, 0.1\n10, 1.2,\n' >some.csv
    printf 'gap (mm), speed (m/s)\n9, 1.3\n60, 1.2\n' >wide.csv
    wrong 'fit friction empty.csv' "empty.csv:1:1: the file has no rows; its first line must name gap \(mm\), speed \(m/s\), and, if known, error"
    wrong 'fit friction, push one.csv' '2 measurements are too few for 2 unknowns'
    wrong 'fit friction some.csv' 'some.csv:3:9: some lines have an error and some have none'
    wrong 'fit friction wide.csv' 'wide.csv:3:1: the gap 6 cm is longer than the domino is tall, h = 4\.8 cm'
    printf 'Spacing [mm];front [cm/s]\n9;130,5\n' >front.csv
    wrong 'fit friction front.csv' "front.csv:1:1: the column 'speed' is missing; the first line must name gap"
    wrong 'fit friction push one.csv' "a comma is missing before 'push'"
    printf 'domino, frame\n1, 10\n2, 20\n3, 29\n' >frames.csv
    printf 'domino, time (s), run\n1, 0, 1\n2, 0.1, 2\n3, 0.2, 1\n' >mixed.csv
    printf 'domino, time (s)\n2, 0.1\n2, 0.2\n' >twice.csv
    printf 'domino, time (s)\n1, 0.2\n2, 0.1\n' >back.csv
    printf 'domino, place (m)\n1, 0.2\n2, 0.1\n' >timeless.csv
    printf 'domino, time (s), frame\n1, 0.1, 3\n' >two.csv
    wrong 'fit friction frames.csv' 'frames.csv:2:4: frames need a frame rate: enter .fit ... FILE 240.'
    wrong 'fit friction mixed.csv' '3 measurements are too few for 1 unknown and the start time of each run'
    wrong 'fit friction twice.csv' 'twice.csv:3:1: domino 2 comes after domino 2'
    wrong 'fit friction back.csv' 'back.csv:3:1: the time 0.1 s is not later than 0.2 s'
    wrong 'fit friction timeless.csv' "timeless.csv:1:1: the column 'gap' is missing; the first line must name .* domino, time \(s\)"
    wrong 'fit friction two.csv' 'two.csv:1:19: both time and frame are given; leave one of these columns out'
    wrong 'effect row 2; effect push 5; fit friction frames.csv 240' 'domino 3 was measured in run 1, but the row has only 2 dominoes'
}

# Writes hit times of a row with errors of 1 ms, for two runs that are measured by different clocks.
noisy_hits() { # SEED
    awk -F , -v seed="$1" 'BEGIN { srand(seed); print "run,domino,time (s)" } NR > 1 { hit[++n] = $3 }
        END { for (run = 1; run <= 2; run++) for (k = 1; k <= n; k++)
            printf "%d,%d,%.6f\n", run, k, 3 * run + hit[k] + 0.001 * sqrt(-2 * log(1 - rand())) * cos(6.283185307 * rand()) }' exact.csv
}

# bats test_tags=rows
@test "fit: several parameters of the model are found from hits, within the stated uncertainty" {
    scene='set r 1; set s 0.4; effect row 12; '
    "$DOMINO" -e "$scene effect push 4; effect friction 0.25; fall > exact.csv"
    awk -F , 'NR == 1 { print "domino,frame,rate" } NR > 1 { printf "%d,%.9f,1000\n", $1, 1000 * $3 + 77 }' exact.csv >frames.csv
    for file in exact frames; do
        fit=$(json "$scene fit friction, push $file.csv" | tail -n 1)
        close "$file friction" 0.25 "$(values friction <<<"$fit")" 1e-6
        close "$file push" 4 "$(values push <<<"$fit")" 1e-6
    done
    # Without 'effect row', the gap of each run may be in the file.
    awk -F , -v gap="$(awk 'BEGIN { print 0.4 * 48 }')" 'NR == 1 { print "gap (mm),domino,time" } NR > 1 { print gap "," $1 "," $3 }' exact.csv >gaps.csv
    close gap 0.25 "$(json 'set r 1; set s 0.9; fit friction, push gaps.csv' | tail -n 1 | values friction)" 1e-6
    # With errors of 1 ms, the 95 % interval must contain the true value in at least 34 of 40 trials.
    for seed in $(seq 40); do
        noisy_hits "$seed" >"noisy$seed.csv"
        echo "fit friction, push noisy$seed.csv"
    done >fits
    { echo 'set output json' && echo "$scene" && cat fits; } >fits.dom
    "$DOMINO" -f fits.dom | jq -s '[map(select(.command == "fit")) | group_by(.friction)[] | .[0]]
        | [length, ([.[] | select((.friction - 0.25 | fabs) <= 2.08 * .friction_sd)] | length),
           ([.[] | select((.push - 4 | fabs) <= 2.08 * .push_sd)] | length)] | @tsv' -r >inside
    awk '{ exit !($1 == 40 && $2 >= 34 && $3 >= 34 && $2 + $3 < 80) }' inside
}

# bats test_tags=rows
@test "fit: messages about hit times that drift, a parameter at the limit of its range, and one that has no influence" {
    measured=$BATS_TEST_DIRNAME/../../examples/measured
    fit=$("$DOMINO" -e "set tol 1e-8; set r 1; set h 48 mm; set d 7.5438/48; fit friction, push $measured/felt-frames.csv")
    grep -q '^The best fit is friction 0, which is the limit of its range\.$' <<<"$fit"
    grep -q '^The measured times drift away' <<<"$fit"
    run ! "$DOMINO" -e 'set r 1; fit q exact.csv'
    "$DOMINO" -e 'set r 1; set s 0.4; effect row 12; effect push 4; fall > exact.csv'
    run "$DOMINO" -e 'set r 1; set s 0.4; effect row 12; effect push 4; fit q exact.csv'
    [[ $status == 1 && $output == *'exact.csv: the measurements do not depend on q' ]]
}

@test "several trials at one gap determine one unknown" {
    local scene='set r 1; set d 7.5/48'
    printf 'gap (mm),speed (m/s)\n12,0.84\n12,0.86\n12,0.85\n' >trials.csv
    friction=$(json "$scene; fit friction trials.csv" | values friction | head -n 1)
    within 'about 0.325' 0.325 "$friction" 'd > -0.005 && d < 0.005'
    close 'the mean of the trials' 0.85 "$(json "$scene; set s 12/48; effect friction $friction; duration" | values speed)" 1e-3
    # the error of the mean of n trials is that of one divided by sqrt(n)
    for n in 1 2 3; do sed 1d trials.csv; done | sed '1i gap (mm),speed (m/s)' >nine.csv
    close 'three times as many' 2 "$(values friction_sd < <(json "$scene; fit friction trials.csv") | head -n 1 | awk -v nine="$(json "$scene; fit friction nine.csv" | values friction_sd | head -n 1)" '{ print $1/nine }')" 0.01
    wrong "$scene; fit friction, slope trials.csv" 'trials.csv: the measurements do not depend on (friction|slope), or not separately from the others; fit fewer parameters'
}

# bats test_tags=rows
@test "the ends of an interval have as many digits as it takes to tell them apart" {
    local scene='set r 1; set s 0.4; set row 12' line from to
    "$DOMINO" -e "$scene; set push 4; set friction 0.25; fall > exact.csv"
    # Exact times, and times with errors of a tenth and of a hundredth of a millisecond.
    for digits in 12 5 4; do
        awk -F , -v digits=$digits 'NR == 1 { print "domino,time (s)" } NR > 1 { printf "%d,%.*f\n", $1, digits, $3 }' exact.csv >times.csv
        line=$("$DOMINO" -e "$scene; fit friction, push times.csv; details" | grep 'The best fit is')
        while read -r from to; do
            [ "$from" != "$to" ] || same "$digits digits" 'two ends' "$line"
        done < <(grep -oE '[0-9.]+( rad/s)? to [0-9.]+' <<<"$line" | sed 's/ rad.s//; s/ to / /')
        [ "$(grep -oE '[0-9.]+( rad/s)? to [0-9.]+' <<<"$line" | wc -l)" -ge 2 ] || same "$digits digits" 'two intervals' "$line"
    done
}

@test "an interval ends where the range of the parameter does" {
    printf 'gap (mm),speed (m/s)\n10,0.8\n20,1.0\n30,1.05\n' >three.csv
    "$DOMINO" -e 'set r 1; fit friction three.csv' | grep -qF 'a 95 % interval of 0 to 0.7475.'
}

# The times of a row of equal blocks without friction, by plain sums of energies (row.awk).
row_times() { awk -v n="$1" -v h=0.044 -v d=0.007 -v gap="$2" -v push=5 -f "$BATS_TEST_DIRNAME/row.awk"; }
block='set h 44 mm; set d 7 mm; set r 1; '

# bats test_tags=rows
@test "the total times of rows of n dominoes, in the units and with the columns that people have" {
    for gap in 10 14 18 26; do
        for n in 15 28; do
            echo "$gap $n $(row_times $n 0.0$gap | tail -n 1)"
        done
    done >totals
    awk 'BEGIN { print "gap (mm),dominoes,time (s)" } { print $1 "," $2 "," $3 }' totals >plain.csv
    awk 'BEGIN { print "Abstand [cm];Anzahl;Gesamtzeit (s);Fehler (ms)" } { printf "%g;%d;%s;2,5\n", $1/10, $2, $3 }' totals | sed 's/\./,/g' >german.csv
    awk 'BEGIN { print "Spacing (in),n,Total time (ms)" } { printf "%.12g,%d,%.9f\n", $1/25.4, $2, 1000*$3 }' totals >inches.csv
    awk 'BEGIN { print "pitch (mm),dominoes,time (s),error (%)" } { print $1 + 7 "," $2 "," $3 ",2" }' totals >pitch.csv
    awk 'BEGIN { print "gap (mm),n,Trial 1 (s),Trial 2 (s),Trial 3 (s),Average time (s)" } { printf "%d,%d,%.9f,%.9f,,99\n", $1, $2, 0.98*$3, 1.02*$3 }' totals >trials.csv
    for file in plain german inches pitch trials; do
        close "$file: push" 5 "$(json "$block set push 4; fit push $file.csv" | values push | head -n 1)" 1e-6
    done
    # Without the column, 'set row' says how many dominoes fell.
    grep -v ',15,' plain.csv | cut -d , -f 1,3 >bare.csv
    close 'set row' 5 "$(json "$block set push 4; set row 28; fit push bare.csv" | values push | head -n 1)" 1e-6
    same 'the columns' '28 0.01' "$(json "$block set push 4; fit push plain.csv" | jq -r 'select(.dominoes == 28) | "\(.dominoes) \(.gap)"' | head -n 1)"
    wrong "$block set push 4; fit push bare.csv" "bare.csv:1:1: how many dominoes fell in this time\? Add a column 'dominoes', or enter, for example, 'set row 28'"
    wrong "$block fit friction plain.csv" "plain.csv:2: 15 dominoes with gaps of 1 cm fell in .* s, but in the scene the fall ends at domino 2: 'fall' shows why; if the row was pushed, 'set push' to about its speed, or fit push as well"
    printf 'domino,time (s)\n2,0.1\n3,0.2\n5,0.3\n6,0.4\n' >hits.csv
    wrong "$block set row 6; set push 0.1; fit friction hits.csv" "the fall ends at domino 1: 'fall' shows why; if the row was pushed, 'set push' to about its speed"
    wrong "$block set d 17 mm; set push 4; fit push pitch.csv" "pitch.csv:2:1: the pitch 1.7 cm must exceed the thickness of a domino, d h = 1.7 cm"
    wrong "$block set push 4; fit d pitch.csv" 'pitch.csv has pitches, from which the gaps follow only if the thickness is known'
    sed 's/,0\.[0-9]*$/,-1/' plain.csv >negative.csv
    wrong "$block set push 4; fit push negative.csv" 'negative.csv:2:7: the time in which a row falls must be more than 0'
}

@test "errors in per cent, trials in columns of their own, and averages" {
    printf 'gap (mm),speed (m/s),error (m/s)\n9,1.3,0.026\n15,1.1,0.022\n21,1.05,0.021\n' >plain.csv
    printf 'gap (cm);Average speed (cm/s);error (%%)\n0,9;130;2\n1,5;110;2 %%\n2,1;105;2\n' >share.csv
    printf 'Gap in cm,Mean velocity (mm/s),Relative error\n0.9,1300,0.02\n1.5,1100,2 %%\n2.1,1050,2 %%\n' >relative.csv
    # The deviations are +-3 %, +-1 % and +-2 %, in 6 trials at 3 gaps: the spread is sqrt(28/3) %, and a mean of two has
    # the error sqrt(14/3) %.
    printf 'gap (mm),speed 1 (cm/s),speed 2 (m/s),average speed (m/s)\n9,133.9,1.261,77\n15,108.9,1.111,77\n21,107.1,1.029,77\n' >trials.csv
    sed '1s/.*/gap (mm),v1 (cm\/s),v2 (m\/s),mean/' trials.csv >letters.csv
    sed '1s/.*/gap (mm),Trial 1 (cm\/s),Trial #2 (m\/s),Average/' trials.csv >numbers.csv
    awk 'BEGIN { print "gap (mm),speed (m/s),error (m/s)"; e = sqrt(14/3)/100; print "9,1.3," 1.3*e; print "15,1.1," 1.1*e; print "21,1.05," 1.05*e }' >spread.csv
    while read -r expected files; do
        for file in $expected $files; do
            json "set r 1; set d 7.5/48; fit friction $file.csv" | head -n 1 | jq -r '.friction, .friction_sd' >"$file"
            close "$file: friction" "$(head -n 1 "$expected")" "$(head -n 1 "$file")" 1e-5
            close "$file: its error" "$(tail -n 1 "$expected")" "$(tail -n 1 "$file")" 1e-4
        done
    done <<<$'plain share relative\nspread trials letters numbers'
    "$DOMINO" -e 'set r 1; set d 7.5/48; fit friction trials.csv' | grep -qF 'Single trials differ from their mean by 3.1 %'
    while IFS='|' read -r message head row; do
        printf '%s\n%s\n' "$head" "$row" >wrong.csv
        wrong 'set r 1; fit friction wrong.csv' "wrong.csv:$message"
    done <<'END'
1:10: both gap and pitch are given; leave one of these columns out|gap (mm),pitch (mm),n,time (s)|10,17,20,0.6
1:28: both error and error % are given; leave one|gap (mm), speed (m/s), m,  error (%), error (m/s)|9, 1.3, 1, 2, 0.1
1:1: hits have one column 'time \(s\)', and errors in s; number repeated runs in a column 'run'|time 1 (s), time 2 (s)|0.1, 0.2
2:7: speed is missing|gap (mm), v1 (m/s), v2 (m/s)|9,    , -
2:9: error: this is a percentage; write a speed such as 1.3 m/s|gap (mm), speed (m/s), error (m/s)|9, 1.3, 2 %
2:9: error % = 2 is too large; the range of error % is more than 0, up to 100 %|gap (mm), speed (m/s), relative error|9, 1.3, 2
END
}

# bats test_tags=rows
@test "hits by sound are numbered, although some are missing" {
    # The times in ms on the clock of the recorder, with errors of up to 5 % of an interval, without dominoes 5, 9, 10, 17.
    row_times 26 0.018 | head -n 25 | awk 'BEGIN { srand(3); print "time (ms)" }
        { n++; shift = 0.002*(rand() - 0.5) } n != 4 && n != 8 && n != 9 && n != 16 { printf "%.3f\n", 1000*($1 + 7 + shift) }' >sound.csv
    numbers=$(seq 2 26 | grep -vxE '5|9|10|17' | paste -sd ' ')
    hits() { json "$block set s 18 mm; set push $2; fit push $1.csv" | jq -r "select(.run).domino" | paste -sd ' '; }
    same 'with the right push' "$numbers" "$(hits sound 5)"
    same 'with another push' "$numbers" "$(hits sound 4)"
    awk -v push="$(json "$block set s 18 mm; set push 4; fit push sound.csv" | values push | head -n 1)" 'BEGIN { exit !(push > 4.8 && push < 5.2) }'
    # Some lines may have numbers: here the first hits are missing.
    sed '1s/.*/domino, time (ms)/; 2,4d; 2,$s/^/,/' sound.csv | sed '2s/,/6,/' >some.csv
    same 'some numbers' "$(cut -d ' ' -f 4- <<<"$numbers")" "$(hits some 5)"
    # Real hits of a row with uneven gaps: without every fifth hit, none gets a wrong number. Of all hits, none is in doubt.
    scene='set r 1; set d 7.5438/48; set s 9.38 mm; set push 4'
    awk -F , '$1 == 7 && $4 > 4 { print $4, $5/$2 }' "$BATS_TEST_DIRNAME/../../examples/measured/hard-floor-frames.csv" >film
    awk 'BEGIN { print "domino,time (s)" } NR == 1 { print $1 "," $2 } NR > 1 && NR % 5 { print "," $2 }' film >film.csv
    wrong "$scene; set row 300; fit friction film.csv" 'film.csv:[0-9]+: the hit .* cannot be numbered'
    awk 'BEGIN { print "time (s)" } NR <= 30 { print $2 }' film >whole.csv
    same 'a whole row' "$(seq 3 31 | paste -sd ' ')" "$(json "$scene; set row 31; fit friction whole.csv" | jq -r 'select(.run).domino' | paste -sd ' ')"
    # An echo, half of an interval late; a row that is too short; a number that is too low.
    awk 'NR == 12 { before = $1 } NR == 13 { print (before + $1)/2 } { print }' sound.csv >echo.csv
    wrong "$block set s 18 mm; set push 5; fit push echo.csv" 'echo.csv:13: the hit [0-9.]+ s after that of domino 15 cannot be numbered: the next one is due after about [0-9.]+ s; if it is an echo, delete the line'
    wrong "$block set s 18 mm; set push 5; set row 20; fit push sound.csv" "sound.csv:17: this hit would be that of domino 21 or a later one, but the row has only 20 dominoes"
    wrong "$block set s 18 mm; set push 0.1; fit friction sound.csv" "sound.csv:3: this hit would be that of domino 2 or a later one, but in the scene the fall ends at domino 1: 'fall' shows why; if the row was pushed, 'set push'"
    printf 'domino,time (s)\n6,0\n,0.028\n7,0.056\n' >twice.csv
    wrong "$block set s 18 mm; set push 5; fit push twice.csv" 'twice.csv:4: domino 7 comes after domino 7'
}
