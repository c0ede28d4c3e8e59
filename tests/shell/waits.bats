#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# Readers that are slow, and streams that another program has made non-blocking: no byte is lost.

load common

# slow.py STREAM COMMANDS: runs the program with a non-blocking pipe or terminal as its standard output, and begins to
# read only when this is full.
setup() {
    begin
    cat >slow.py <<'END'
import os, subprocess, sys
stream, commands = sys.argv[1], sys.argv[2]
reader, writer = os.openpty() if stream == "terminal" else os.pipe()
os.set_blocking(writer, False)
domino = subprocess.Popen([os.environ["DOMINO"], "-n", "--keep-going", "-e", commands], stdout=writer)
os.close(writer)
while True:  # until the program sleeps, because its reader does not read
    state = open(f"/proc/{domino.pid}/stat").read().rsplit(")", 1)[1].split()[0]
    if state in "SZ":
        break
read = b""
while True:
    try:
        piece = os.read(reader, 65536)
    except OSError:
        break
    if not piece:
        break
    read += piece
sys.stdout.buffer.write(read.replace(b"\r\n", b"\n"))
sys.exit(domino.wait())
END
}

# bats test_tags=rows,sweeps
@test "a slow reader of a non-blocking pipe or terminal gets every byte" {
    local rows='set output csv; sweep s 0.001 0.999 4000 : print s*1' stream
    "$DOMINO" -n -e "$rows" >expected
    same 'rows' 4001 "$(wc -l <expected)"
    for stream in pipe terminal; do
        soon python3 slow.py $stream "$rows" >obtained
        same_file expected obtained
    done
}

# bats test_tags=rows,sweeps
@test "a non-blocking standard input is waited for, and /dev/stdout and FIFOs get every byte" {
    python3 - >obtained <<'END'
import os, subprocess, time
reader, writer = os.pipe()
os.set_blocking(reader, False)
domino = subprocess.Popen([os.environ["DOMINO"], "-n"], stdin=reader, stdout=subprocess.PIPE)
os.close(reader)
for k in range(3):
    time.sleep(0.1)
    os.write(writer, b"print 40 + %d\n" % k)
os.close(writer)
print(domino.stdout.read().decode().split())
END
    same 'answers' "['40', '41', '42']" "$(cat obtained)"
    local rows='set output csv; sweep s 0.001 0.999 4000 : print s*1'
    "$DOMINO" -n -e "$rows" >expected
    soon python3 slow.py pipe "$rows > /dev/stdout" >obtained
    same_file expected obtained
    mkfifo fifo
    python3 -c 'import os, sys, time; f = os.open("fifo", os.O_RDONLY); time.sleep(0.3); sys.stdout.buffer.write(open(f, "rb").read())' >obtained 3>&- &
    soon "$DOMINO" -n -e "$rows > fifo"
    wait $!
    same_file expected obtained
}

# bats test_tags=rows,chance,sweeps
@test "a study that is killed has written its rows, but not each row by itself" {
    exec 5< <(exec "$DOMINO" -n -e 'set output csv; set threads 1; effect row 12; effect placement 5 mm; sweep seed 1 100000 100000 : placement 300' 3>&-)
    local child=$! row
    for _ in {1..20}; do read -r -t 60 row <&5; done # the head and 19 rows come while the program runs
    kill -KILL $child
    [[ $row == 19,* ]] || same 'row 19' '19,...' "$row"
    exec 5<&-
}
