# SPDX-License-Identifier: GPL-3.0-or-later
"""Recomputes the derivations of 'explain' from their texts alone.

check.py commands SEED COUNT writes commands for COUNT random scenes; check.py check reads the json that
they answer, and evaluates each line twice: its numbers as they stand, and its equation with the values of the
quantities that it needs. The two sides of an equation are equal.
"""
import json
import math
import random
import sys



def rounded(function):
    """Wraps asin or acos for an argument that may exceed 1 because of rounding."""
    return lambda x: function(max(-1, min(1, x)) if abs(x) < 1 + 1e-14 else x)


NAMES = {name: getattr(math, name) for name in ("sin", "cos", "atan", "sqrt", "ceil")} | {
    "ln": math.log, "asin": rounded(math.asin), "acos": rounded(math.acos)}  # fmt: skip
QUESTIONS = ("thetac", "theta1 0.6*thetac", "energy 0.7*thetac", "fuel", "launch", "omega 0.3*thetac", "barrier",
             "duration", "why", "rmax", "count 112 m",
             *(f"{n} {tilt}*thetac" if (n in (3, 12, 13, 14, 16, 19, 20, 21, *range(27, 32), *range(33, 38), 39, *range(46, 50),
                                              43, 44, 51)) and n not in (45, 50) else n
               for tilt in (0.1, 0.5) for n in range(1, 60)))  # fmt: skip


def commands(seed: int, count: int) -> None:
    rng = random.Random(seed)
    print("set output json")
    for k in range(count):
        s, d, q = rng.uniform(0.05, 0.9), rng.uniform(0.03, 0.25), rng.choice((3, 4, rng.uniform(2, 5)))
        r = 1 + rng.random() * min(1 / s - 1, 1.2)
        print(f"reset; set output json; set s {s!r}; set r {r!r}; set d {d!r}; set q {q!r}")
        effect = rng.choice((None, None, "effect slope {:.3f} deg", "effect friction {:.3f}", "effect edges {:.4f}",
                             "set fuel paper", "effect walls 0.4 mm"))  # fmt: skip
        if effect:
            print(effect.format(rng.uniform(-1, 1) if "slope" in effect else 0.015 * rng.random() + 0.001))
        print(f"explain {QUESTIONS[k % len(QUESTIONS)]} deep")


def close(row: dict, a: float, b: float, scale: float) -> bool:
    bound = 2e-10 * max(1, abs(a), scale)
    if row["unit"] == "rad":  # near asin(1) and acos(1) only the sine or the cosine has all digits
        return abs(a - b) < 1e-6 and min(abs(math.sin(a) - math.sin(b)), abs(math.cos(a) - math.cos(b))) <= bound
    return abs(a - b) <= bound


def groups():
    rows = {}
    for text in sys.stdin:
        row = json.loads(text)
        if row["command"] == "reset":
            yield rows
            rows = {}
        elif row["command"] == "explain" and "error" not in row:
            rows[row["quantity"]] = row
    yield rows


def main() -> None:
    if sys.argv[1] == "commands":
        commands(int(sys.argv[2]), int(sys.argv[3]))
        return
    scenes = lines = ended = 0
    for rows in groups():
        scenes += bool(rows)
        values = {name: row["value"] for name, row in rows.items() if row["value"] is not None}
        for name, row in rows.items():
            if row["numbers"] is None:
                ended += "; with " in row["meaning"]
                continue
            if row["value"] is None:
                continue
            terms = [abs(float(x)) for x in row["numbers"].split(" ")[::2]] if row["equation"].startswith("sum(") else [0]
            found = eval(row["numbers"].replace("^", "**"), NAMES)
            scale = max(terms)
            if not close(row, row["value"], found, scale):
                sys.exit(f"{name} = {row['numbers']} is {found}, not {row['value']}: {rows}")
            if not row["equation"].startswith("sum("):
                found = eval(row["equation"].replace("^", "**"), NAMES | values)
                if not close(row, row["value"], found, scale):
                    sys.exit(f"{name} = {row['equation']} is {found}, not {row['value']}: {rows}")
            other = rows.get(name.replace("_left", "_right"), row)
            if other["value"] is not None and not close(row, row["value"], other["value"], 1):
                sys.exit(f"{name} = {row['value']} is not {other['value']}: {rows}")
            lines += 1
    print(scenes, lines, ended)


main()
