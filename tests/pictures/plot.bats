#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Plots: their data compared with the commands, kinds of files, and pictures in characters.

load ../shell/common

row='effect row 6; effect friction 0.1'

plots=(fall speed growth 'sweep s 0.2 0.6 5 : rmax' 'sweep s 0.2 0.6 8 d 0.1 0.3 7 : rmax'
    energy omega)

# bats test_tags=rows,sweeps
@test "each plot makes an svg that parses, a png and a pdf, and fits 80 x 24 characters" {
    local what
    for what in "${plots[@]}"; do
        "$DOMINO" -e "$row; plot $what > a.svg; plot $what > a.png; plot $what > a.pdf; plot $what > a.txt" >said
        same "$what: standard output" '(nothing)' "$(cat said)"
        xmllint --noout a.svg
        same "$what: png" 89504e470d0a1a0a "$(head -c 8 a.png | od -An -tx1 | tr -d ' \n')"
        same "$what: its size" 00000500000003c0 "$(od -An -tx1 -j 16 -N 8 a.png | tr -d ' ')"
        same "$what: pdf" '%PDF-' "$(head -c 5 a.pdf)"
        same "$what: lines that are too wide" '(nothing)' "$(awk 'length > 79' a.txt)"
        [ "$(wc -l <a.txt)" -le 23 ] && [ "$(wc -l <a.txt)" -ge 15 ]
        same "$what: blanks at ends" '(nothing)' "$(grep ' $' a.txt)"
        same "$what: letters beyond ASCII" '(nothing)' "$(grep -P '[^\x00-\x7f]' a.txt)"
        same "$what: in a pipe, without gnuplot" "$(cat a.txt)" "$(PATH=/nowhere "$DOMINO" -e "$row; plot $what")"
        [ "$(wc -c <a.svg)" -lt 60000 ] && [ "$(wc -c <a.png)" -lt 150000 ]
    done
}

# bats test_tags=rows,sweeps,explain
@test "plot: titles and labels of the pictures" {
    while IFS='|' read -r what words; do
        "$DOMINO" -e "$row; plot $what" >picture
        for word in $words; do
            grep -q -- "${word//\~/ }" picture || same "plot $what" "$word" "$(cat picture)"
        done
    done <<'END'
fall|Energy~to~spare spare~energy~/~energy~needed,~in~% the~weakest,~domino All~6~fall\.
speed|Speed~of~the~front speed~in~m/s distance~from~the~first~domino~in 
energy|Energy launch top hit potential~energy kinetic~energy tilt~of~the~head~in~rad
omega|Angular~velocity launch top hit tilt~of~the~head the~head,~48~mm~tall
growth|solid~pair hollow~pair hollow~train solid~train reach:~r~=~1/s now:~s~=~0.4,~r~=~1.5 gap~over~height growth~r
sweep s 0.2 0.6 5 : rmax|rmax~against~s r_max s,~separation
sweep q 3, 4 s 0.2 0.6 5 : rmax|q~=~3 q~=~4 r_max
sweep s 0.2 0.6 9 d 0.1 0.3 7 : print 2*rmax|2\*rmax: d,~thickness~divided~by~height
END
    "$DOMINO" -e "$row; plot fall" >picture
    same 'a mark for each domino' 'o o o o #' "$(sed -n '/^ *10 +/q;3,$s/.*[|+]//p' picture | grep -o '[o#]' | paste -sd ' ' -)"
    "$DOMINO" -e 'set r 1.7; plot energy' | grep -q 'launch *stop'
    "$DOMINO" -e 'set q hollow; set s 0.54; set r 1.84; plot energy' | grep -q fall
    "$DOMINO" -e 'set angle deg; plot omega' | grep -q 'head in deg'
    "$DOMINO" -e 'set d 0.3; effect row 5; plot fall' | grep -q 'Domino 2 stops the row: it has 6 % of the energy that it needs'
}

# bats test_tags=rows,sweeps
@test "plot: no text is cut off, broken within 'r = 1.5', or written over another text; the legend takes little height" {
    local what title label
    while IFS='|' read -r what title label; do
        "$DOMINO" -e "$row; plot $what > a.svg"
        "$root/tests/pictures/labels" a.svg >texts || same "$what" 'texts apart' "$(cat texts)"
        for words in "$title" "$label"; do
            cut -d ' ' -f 5- texts | grep -qxF -- "$words" || same "$what" "$words" "$(cat texts)"
        done
        same "$what: where lines are broken" '(nothing)' "$(cut -d ' ' -f 5- texts | grep '=$\|^=')"
        "$DOMINO" -e "$row; plot $what" | tr -s ' \n' ' ' | grep -qF -- "$label"
    done <<'END'
growth|A train below its curve keeps falling|growth r
energy with q hollow s 0.54 r 1.84|Energy over a cycle: s = 0.54, r = 1.84, d = 0.1458, q = 3|energy, in units of m g h/2 of the head
sweep s 0.3 0.6 9 q 3 4 8 : rmax|rmax against s and q|q, mass exponent: 4 for solid dominoes, 3 for hollow ones
sweep s 0.3 0.6 9 d 0.1 0.3 7 : print barrier.margin|barrier.margin against s and d|barrier.margin
sweep s 0.1 0.4 8 d 0.2 0.4 7 : print barrier.margin/2 - fuel.fuel*cos(thetac) + 0*launch.kinetic|0*launch.kinetic against s and d|barrier.margin/2 - fuel.fuel*cos(thetac) + 0*launch.kinetic
END
    "$DOMINO" -e 'plot growth > a.svg'
    "$root/tests/pictures/labels" a.svg |
        awk '/ solid train/ { top = $2 } / now: s/ { low = $4 } END { exit !(top && low - top < 0.2 * 480) }'
}

# bats test_tags=rows,sweeps
@test "plot: every point is drawn, up to the ends of the axes, even if all values are nearly equal" {
    circles() { grep -c "href='#gpPt5' transform" a.svg; }
    "$DOMINO" -e 'plot sweep tol 1e-12, 1e-6, 1e-3 : rmax > a.svg'
    same 'nearly equal' 3 "$(circles)"
    same 'ticks' "$("$root/tests/pictures/labels" a.svg | cut -d ' ' -f 5- | sort -u)" "$("$root/tests/pictures/labels" a.svg | cut -d ' ' -f 5- | sort)"
}

@test "plot energy, omega: the data agree with energy and omega, and include the events" {
    csv 'plot energy' >energy
    same data "$(cat energy)" "$(csv 'plot omega')"
    "$DOMINO" -e 'plot omega > a.gp'
    same 'the title is not broken beside =' "'r = 1.5, d = 0.1458, q = 4'" "$(grep -o "'r = .* q = 4'" a.gp)"
    same keys theta,dH,kinetic,J,omegasq,omega,event "$(head -n 1 energy)"
    same events 'launch top hit' "$(awk -F, '$7 != "" && NR > 1 { print $7 }' energy | paste -sd ' ' -)"
    # The sum of climbed and kinetic energy is constant.
    awk -F, 'NR == 2 { sum = $2 + $3 } NR > 1 { d = $2 + $3 - sum; if (!(d <= 1e-12 && d >= -1e-12)) bad = 1 }
        NR > 2 && !($1 > before) { bad = 1 } { before = $1 } END { exit bad || NR < 140 }' energy
    for line in 2 20 77 140; do
        IFS=, read -r theta dH _ J omegasq omega _ < <(sed -n ${line}p energy)
        answer=$(json "energy $theta; omega $theta")
        for key in dH J omegasq omega; do
            close "$key at $theta" "$(values "$key" <<<"$answer" | tail -n 1)" "${!key}"
        done
    done
    # There are no values after a stop.
    csv 'set r 1.7; plot omega' | awk -F, 'stopped && $6 != "" { bad = 1 } $7 == "stop" { stopped = 1; bad = bad || $6 != 0; next }
        stopped { after++ } END { exit bad || !after }'
}

# bats test_tags=rows,sweeps,errors
@test "plot growth: the data agree with curve, for solid and hollow dominoes" {
    csv 'plot growth' >growth
    same keys s,solid,hollow,solid_pair,hollow_pair,reach "$(head -n 1 growth)"
    for q in 4 3; do
        csv "set q $q; curve 0.02 0.98 9" | sed 1d >curve
        same "rows, $q" 9 "$(wc -l <curve)"
        while IFS=, read -r s exact _ pair reach _; do
            row() { awk -F, -v s="$s" -v i="$1" 'NR > 1 && $1 - s < 1e-9 && s - $1 < 1e-9 { print $i }' growth; }
            close "$q $s exact" "$exact" "$(row $((6 - q)))"
            if [ -n "$pair" ]; then
                close "$q $s pair" "$pair" "$(row $((8 - q)))"
            else
                same "$q $s pair" '(nothing)' "$(row $((8 - q)))"
            fi
            close "$s reach" "$reach" "$(row 6)"
        done <curve
    done
    same "the paper's fuel" "$(json 'set fuel paper; rmax 0.4' | values r_max_paper | head -n 1 | cut -c 1-12)" \
        "$(csv 'set fuel paper; plot growth' | awk -F, '$1 == 0.4 { print $2 }' | cut -c 1-12)"
    same 'rows are columns of their own in json' 's solid hollow solid_pair hollow_pair reach' "$(json 'plot growth' | keys)"
    same 'no bounds, which a picture does not have' "$(csv 'plot growth')" "$(csv 'set errors on; plot growth')"
}

# bats test_tags=rows
@test "plot fall, speed: the data agree with fall" {
    for scene in "$row" 'effect row 6; set mass 0.02' 'set r 1.7; effect row 9'; do
        csv "$scene; fall" | cut -d, -f 1,6-8 >fall
        same "$scene" "$(cat fall)" "$(csv "$scene; plot fall" | cut -d, -f 1-4)"
        csv "$scene; plot fall" | awk -F, 'NR > 2 { d = $5 - $4 / $3; if (!(d < 1e-9 && d > -1e-9)) exit 1; n++ } END { exit n < 1 }'
    done
    # Between two hits, the front moves from the front edge of one foot to the front edge of the next foot.
    csv "$row; row" >row
    csv "$row; fall" >fall
    csv "$row; plot speed" >speed
    same keys domino,place,speed "$(head -n 1 speed)"
    awk -F, 'FNR == 1 { file++; next }
        file == 1 { pitch[$1] = $3 + $4 } file == 2 { hit[$1] = $3; ends[$1] = $4 }
        file == 3 && $1 > 1 { place += pitch[$1]; d = $2 - place; if (!(d < 1e-12 && d > -1e-12)) bad = 1 }
        file == 3 && $1 > 1 && $3 != "" { d = $3 / (pitch[$1 + 1] / (ends[$1] - hit[$1])) - 1; n++
            if (!(d < 1e-9 && d > -1e-9)) bad = 1 }
        END { exit bad || n < 4 }' row fall speed
}

# bats test_tags=sweeps,explain
@test "plot sweep: the data agree with sweep" {
    same csv "$(csv 'sweep s 0.2 0.6 5 : rmax')" "$(csv 'plot sweep s 0.2 0.6 5 : rmax')"
    same json "$(json 'sweep q 3, 4 s 0.2 0.6 3 : count 112')" "$(json 'plot sweep q 3, 4 s 0.2 0.6 3 : count 112')"
    wrong 'sweep s 0.2 0.6 5 : rmax > a.svg' "'sweep' cannot write 'a.svg'; use .csv, .json or .txt"
    # Each word of a grid has its own curve, logarithmic grids have logarithmic axes, and points without an answer are
    # counted.
    "$DOMINO" -e 'plot sweep fuel exact, paper s 0.2 0.6 5 : rmax' >picture
    for words in 'fuel = exact' 'fuel = paper'; do grep -q "$words" picture; done
    "$DOMINO" -e 'plot sweep r 1.2 3.2 5 : duration' | grep -q 'No answer at [1-4] of 5 points'
    "$DOMINO" -e 'plot sweep tol 1e-12, 1e-6, 1e-3 : rmax' | grep -q '^ *tol, relative tolerance'
    "$DOMINO" -e 'plot sweep d 0.001 1 7 log : rmax' | grep -q '^ *0.001 .*0.01 .*0.1 .*1$'
}

# bats test_tags=rows,explain,engine,sweeps
@test "what cannot be plotted: an error in one line that says what to do, and no file" {
    wrong 'plot energy rmax' "'plot energy' takes no arguments"
    wrong 'plot sweep' "needs a grid and an answer, such as 'plot sweep s 0.1 0.9 33 : rmax'"
    wrong 'plot sweep s 0.1 0.3 3' "':' and an answer are missing"
    wrong 'effect row 3; plot sweep s 0.1 0.3 3 : fall > a.svg' "'fall' answers with a table, but a picture needs one number for each point"
    wrong 'plot sweep s 0.1 0.3 3 d 0.1 0.3 3 q 3, 4 : rmax' 'one or two parameters, but this grid has 3'
    wrong 'plot sweep fuel exact, paper : rmax' "the values of 'fuel' are words, but a curve needs numbers"
    wrong 'plot sweep s 0.1, 0.2, 0.4, 0.5, 0.6, 0.7, 0.8 d 0.1 0.3 8 : rmax' 'a map needs evenly spaced numbers'
    wrong 'plot sweep r 3 4 3 : duration > a.svg' 'none of the 3 points has a number'
    for what in fall speed; do
        wrong "plot $what > a.svg" "there is no row"
    done
    wrong 'effect row 1; plot speed > a.svg' "this plot needs at least two dominoes; 'set row 5' sets up five"
    wrong 'effect row 1; plot fall' 'the only domino of this row starts past its tipping point, so it needs no energy to fall'
    wrong 'effect row 3; effect bounce 0.2; plot fall > a.csv' 'runs this row because bounce is on, and the engine does not compute the energy that a domino needs'
    wrong 'set q 4; set r 1.7; effect row 8; plot speed > a.svg' 'the front has no speed, because the fall ends before domino 2 is hit'
    for what in 'energy > a.svg' omega; do
        wrong "set s 0.001; plot $what" 'the fuel P is not positive'
        wrong "set r 9; plot $what" 'r s = 3.6 > 1'
    done
    same 'nothing is left' '(nothing)' "$(ls)"
}

# bats test_tags=rows,sweeps
@test "plot > FILE.gp: a gnuplot script with its data, which draws the picture by itself" {
    mkdir "$BATS_TEST_TMPDIR/scripts" && cd "$BATS_TEST_TMPDIR/scripts"
    "$DOMINO" -e "plot growth > growth.gp; draw 0.3 forces > forces.gp; plot sweep s 0.1 0.8 12 r 1 1.9 9 : fuel.fuel > \"it's.gp\"
        plot sweep s 0.1 0.5 9 q 3, 4 : rmax > sweep.gp; effect row 7; draw > row.gp; plot growth > growth.pdf"
    # The script needs no other file, and draws one picture.
    mkdir alone
    for script in *.gp; do
        cp "$script" alone
        (cd alone && gnuplot "$script") || same "$script" 'a script' 'an error'
        same "$script" '%PDF' "$(head -c 4 "alone/${script%.gp}.pdf")"
    done
    # Every text is in single quotes, in which gnuplot substitutes nothing.
    same 'double quotes' '(nothing)' "$(sed "s/'[^']*'//g; s/\.\"\\\\\(n\|047\)\"\.//g" ./*.gp | grep '["`]')"
    # The curves of the script agree with the data.
    close 'r_max of solid dominoes' "$(csv 'plot growth' | awk -F, 'NR == 11 { print $2 }')" \
        "$(sed -n '/^\$curve0/,/^END/p' growth.gp | awk 'NR == 11 { print $2 }')" 1e-8
    grep -qF "set output './'.'it'.\"\\047\".'s.pdf'" "it's.gp"
    run -1 "$DOMINO" -e 'plot growth >> growth.gp'
    grep -q 'can hold only one picture' <<<"$output"
    # The script is also written if gnuplot is not installed.
    mkdir bin && ln -s "$(command -v env)" bin
    PATH=$PWD/bin "$DOMINO" -e 'plot growth > again.gp'
    sed 's/again/growth/g' again.gp | diff growth.gp -
}

# bats test_tags=sweeps
@test "plot sweep: several answers are curves of one picture, with units if their units differ" {
    picture=$("$DOMINO" -e 'plot sweep s 0.1 0.8 30 : rmax, pair, 1/s')
    for words in 'rmax, pair, 1/s against s' 'o rmax  *# pair  *+ 1/s' 'No answer at [0-9]* of 30 points'; do
        grep -q "$words" <<<"$picture" || same 'three curves' "$words" "$picture"
    done
    "$DOMINO" -e 'set angle deg; plot sweep s 0.3 0.5 9 : duration.duration, thetac' |
        grep -q 'duration.duration in tau  *# thetac in deg'
    wrong 'plot sweep s 0.1 0.3 3 d 0.1 0.2 3 : rmax, pair' 'up to 6 answers against one parameter, or one answer against two'
}
