#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the separation at which a train can grow by GROWTH, in a line-by-line dialogue with the program domino.

Each question depends on the previous answer, so neither side may wait for more than one line.

usage: client.py GROWTH
"""
import json
import subprocess
import sys


class Domino:
    """A calculator that answers one object for each command that has no table of rows."""

    def __init__(self, program="domino"):
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.DEVNULL, text=True, bufsize=1)
        self.process.stdin.write("set output json\n")  # this command has no answer, because the output is not yet json

    def ask(self, command):
        """Returns the answer; raises ValueError with the message of an error."""
        self.process.stdin.write(command + "\n")
        answer = json.loads(self.process.stdout.readline())
        if "error" in answer:
            raise ValueError(answer["error"])
        return answer

    def close(self):
        self.process.stdin.close()
        return self.process.wait()


def main(arguments):
    if len(arguments) != 1:
        print("usage: client.py GROWTH", file=sys.stderr)
        return 2
    domino = Domino()
    try:
        growth = domino.ask(f"print {arguments[0]}")["value"]
        low, high = 0.001, domino.ask("best")["s"]  # the largest growth increases with s up to the best separation
        for _ in range(40):
            middle = (low + high) / 2
            if domino.ask(f"rmax {middle!r}")["r_max"] < growth:
                low = middle
            else:
                high = middle
        print(f"{high:.9g}")
    except ValueError as error:
        print(f"client: {error}", file=sys.stderr)
        return 1
    finally:
        domino.close()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
