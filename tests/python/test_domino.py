# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the Python module with the program, and tests what Python adds. $DOMINO is the path of the program."""

import json
import math
import os
import random
import signal
import subprocess
import threading
import unittest
from pathlib import Path

import numpy as np
import pandas

import domino

PROGRAM = os.environ["DOMINO"]
ROOT = Path(__file__).resolve().parents[2]


def ask(lines):
    """Returns the program's answers to the last command of each line: a list for each line, empty after an error."""
    text = "set output json\n" + "".join(f"{line}\necho end\n" for line in lines)
    run = subprocess.run([PROGRAM, "-n"], input=text, capture_output=True, text=True, check=False)
    answers = [[]]
    for line in run.stdout.splitlines():
        if json.loads(line)["command"] == "echo":
            answers.append([])
        elif json.loads(line)["command"] == lines[len(answers) - 1].split(";")[-1].split()[0]:
            answers[-1].append(json.loads(line))
    return answers[:-1]


class SameAsTheProgram(unittest.TestCase):
    KEYS = {
        "rmax": ("r_max", lambda t: domino.rmax(**t).r_max),
        "pair": ("r_max", lambda t: domino.pair(**t).r_max),
        "barrier": ("margin", lambda t: domino.barrier(**t).margin),
        "theta1 0.1": ("theta_1", lambda t: domino.theta1(0.1, **t).theta_1),
        "duration": ("duration", lambda t: domino.duration(**t)),
        "fuel": ("fuel_exact", lambda t: domino.fuel(**t).exact),
        "launch": ("kinetic", lambda t: domino.launch(**t).kinetic),
        "energy 0.1": ("dH", lambda t: domino.energy(0.1, **t).dH),
        "thetac": ("theta_inf", lambda t: domino.angles(**t).theta_inf),
        "omega 0.01": ("omegasq", lambda t: domino.omegasq(0.01, **t)),
    }

    def test_a_thousand_questions_have_the_same_answers_to_the_last_bit(self):
        random.seed(1)
        lines, mine = [], []
        for k in range(1000):
            train = {"s": random.uniform(0.1, 0.9), "d": random.uniform(0.02, 0.4), "q": random.choice([3.0, 4.0])}
            train["r"] = random.uniform(1, min(1.6, 1 / train["s"]))
            effect = random.choice(["", "friction", "slope", "edges", "walls", "friction"])
            if effect:
                train[effect] = {"friction": 0.2, "slope": 0.01, "edges": 0.004, "walls": 0.002}[effect] * random.random()
            question, (key, answer) = random.choice(list(self.KEYS.items()))
            settings = "".join(
                f"{'effect' if name == effect else 'set'} {name} {value!r}{' rad' if name == 'slope' else ''}; "
                for name, value in train.items()
            )
            lines.append(f"reset; {settings}{question}")
            try:
                mine.append((lines[-1], key, answer(train)))
            except domino.DominoError:
                mine.append((lines[-1], key, None))
        compared = 0
        for (line, key, value), answer in zip(mine, ask(lines), strict=True):
            theirs = answer[-1].get(key) if answer else None
            if value is None or (isinstance(value, float) and math.isnan(value)):
                self.assertIsNone(theirs, line)
                continue
            self.assertEqual(value, theirs, line)
            compared += 1
        self.assertGreater(compared, 700)

    def test_rows_fall_as_in_the_program(self):
        csv = ROOT / "examples/record.csv"
        frame = pandas.read_csv(csv, comment="#", na_values="-", skipinitialspace=True)
        for effects, commands in (({"friction": 0.3, "push": 3}, "effect friction 0.3; effect push 3"),
                                  ({"push": 3}, "effect push 3")):  # fmt: skip
            [falls] = ask([f'effect row "{csv}"; {commands}; fall'])
            row = domino.Row.from_pandas(frame, **effects)
            for mine, theirs in zip(row.fall(), falls, strict=False):
                self.assertEqual(mine.domino, theirs["domino"])
                self.assertTrue(math.isclose(mine.kinetic, theirs["kinetic"], rel_tol=1e-12))
        self.assertFalse(domino.Row.from_pandas(frame, friction=0.3, push=3).verdict().falls)
        self.assertEqual(domino.Row.from_pandas(frame, friction=0.3, push=3).mend()[0].domino, 8)

    def test_boxes_have_the_width_of_the_program(self):
        [narrow, usual] = ask(["set width 0.2; set walls 1 mm; set row 6; set push 4; verdict; reset width; verdict"])[0]
        for width, answer in ((0.2, narrow), (0.5, usual)):
            row = domino.Row.of_train(6, width=width, walls=0.001, push=4)
            self.assertTrue(math.isclose(row.verdict().seconds, answer["seconds"], rel_tol=1e-12))
            self.assertTrue(math.isclose(row.dominoes[5].width, width * row.dominoes[5].height, rel_tol=1e-12))

    def test_air_brakes_trains_and_rows(self):
        [limit], [verdict] = ask(["set density 650; set air 1.2; set drag 2; rmax 0.4", "set row 6; set push 4; verdict"])
        train = domino.rmax(s=0.4, air=1.2 / 650, drag=2).r_max
        self.assertTrue(math.isclose(train, limit["r_max"], rel_tol=1e-11))
        mass = 650 * 0.048**3 / 2 * 7 / 48
        for air, same in ((1.2, True), (0, False)):
            row = domino.Row.of_train(6, mass=mass, air=air, drag=2, push=4)
            self.assertEqual(math.isclose(row.verdict().seconds, verdict["seconds"], rel_tol=1e-11), same)

    def test_counts_and_designs(self):
        [count], [best], design = ask(["count 112 m", "set q hollow; best", "reset; design 2 m"])
        self.assertEqual(domino.count(112).dominoes, count["dominoes"])
        self.assertEqual(domino.best(q="hollow"), (best["s"], best["r_max"]))
        mine = domino.design(2.0)
        self.assertEqual(mine.steps, design[0]["steps"])
        self.assertTrue(math.isclose(mine.r, design[0]["r"], rel_tol=1e-12))
        self.assertTrue(mine.row.verdict().falls)

    def test_studies_are_those_of_the_program(self):
        [answer] = ask(["effect row 6; effect placement 2 mm; placement 500"])
        row = domino.Row.of_train(6)
        study = row.placement(0.002, rows=500)
        self.assertEqual((study.rows, study.fall), (answer[0]["rows"], answer[0]["fall"]))
        self.assertEqual(row.placement(0.002, rows=500), study)
        self.assertEqual(sum(study.stops) + study.fall + study.unknown, 500)
        [answer] = ask(["effect row 6; effect placement 2 mm; effect error_thickness 0.1 uniform; placement 500"])
        self.assertEqual(row.placement(0.002, thickness=(0.1, "uniform"), rows=500).fall, answer[0]["fall"])
        all_errors = row.budget(0.9, "all", gap=0.002, thickness=(0.1, "uniform"), rows=200)
        self.assertTrue(0 < all_errors.low < all_errors.sigma)
        with self.assertRaises(ValueError):
            row.placement(colour=0.1)
        budget = row.budget(0.9, rows=200)
        self.assertTrue(budget.low < budget.sigma < budget.high)


class Arrays(unittest.TestCase):
    def test_arrays_broadcast_and_equal_single_questions(self):
        s, q = np.linspace(0.1, 0.9, 9)[:, None], np.array([3.0, 4.0])
        limit = domino.rmax(s, q=q)
        self.assertEqual(limit.r_max.shape, (9, 2))
        for i, j in np.ndindex(9, 2):
            one = domino.rmax(float(s[i, 0]), q=float(q[j]))
            self.assertEqual((limit.r_max[i, j], limit.ends[i, j]), (one.r_max, one.ends))
        tilts = domino.theta1(np.array([0.0, 0.1, 0.2]))
        self.assertEqual(tilts.theta_1[1], domino.theta1(0.1).theta_1)

    def test_a_train_without_an_answer_is_nan_among_others(self):
        found = domino.duration(r=np.array([1.5, 1.9]))
        self.assertEqual(found[0], domino.duration(r=1.5))
        self.assertTrue(math.isnan(found[1]))

    def test_a_wrong_parameter_is_named_with_its_index(self):
        with self.assertRaises(domino.OutOfRange) as caught:
            domino.rmax(np.array([0.1, -1.0]))
        self.assertEqual(caught.exception.parameter, "s")
        self.assertIn("(1,)", str(caught.exception))


class Errors(unittest.TestCase):
    def test_errors_name_the_parameter_or_the_reason(self):
        for call, parameter in ((lambda: domino.rmax(2.0), "s"), (lambda: domino.rmax(0.4, friction=-1), "friction"),
                                (lambda: domino.rmax(0.4, edges=1), "edges"), (lambda: domino.theta1(5), "theta"),
                                (lambda: domino.rmax(0.4, tol=1.0), "tol"),
                                (lambda: domino.rmax(q="wood"), "q")):  # fmt: skip
            with self.assertRaises(domino.OutOfRange) as caught:
                call()
            self.assertEqual(caught.exception.parameter, parameter)
            self.assertIsInstance(caught.exception, ValueError)
        with self.assertRaises(domino.DominoError) as caught:
            domino.duration(r=1.9)
        self.assertEqual(caught.exception.status, "STOPS")
        with self.assertRaisesRegex(domino.OutOfRange, "domino 2"):
            domino.Row([(0.05, 0.01), (0.06, -0.01, 0.02)]).verdict()
        with self.assertRaises(domino.DominoError):
            domino.design(8, hall=8.1)
        with self.assertRaises(domino.DominoError):
            domino.prove("rmax", friction=0.1)

    def test_every_effect_is_a_keyword_of_trains_and_rows(self):
        for name, member in domino._api.EFFECTS.items():
            self.assertEqual(getattr(domino.Train(**{name: 0.001}).structure(), member), 0.001)
            self.assertTrue(domino.Row.of_train(3, r=1.1, **{name: 0.001}).verdict().falls)
        for call in (domino.rmax, lambda **effects: domino.Row.of_train(3, **effects), lambda **effects: domino.design(8, **effects)):
            with self.assertRaisesRegex(TypeError, "'fricton'.*friction, slope"):
                call(fricton=0.1)
        with self.assertRaisesRegex(TypeError, "no air"):
            domino.design(8, air=1.2)

    @unittest.skipUnless(hasattr(signal, "pthread_kill"), "no signals to threads")
    def test_an_interrupt_ends_a_long_computation(self):
        row = domino.Row.of_train(30, r=1.1, friction=0.1, edges=0.005, slope=0.002)
        timer = threading.Timer(0.5, lambda: signal.pthread_kill(threading.main_thread().ident, signal.SIGINT))
        with self.assertRaises(KeyboardInterrupt):
            timer.start()
            row.placement(0.002, rows=50_000_000)
        timer.join()
        self.assertTrue(row.verdict().falls, "after an interrupt questions are answered as before")


class Rows(unittest.TestCase):
    def test_rows_come_from_lists_and_frames(self):
        rows = [(0.05, 0.008, 0.0), (0.0602, 0.009, 0.02)]
        frame = pandas.DataFrame({"height (mm)": [50, 60.2], "Thickness [mm]": [8, 9], "gap (cm)": [math.nan, 2], "note": "xy"})
        for mine, theirs in zip(domino.Row.from_pandas(frame).dominoes, domino.Row(rows).dominoes, strict=True):
            np.testing.assert_allclose(mine, theirs, rtol=1e-15)
        with self.assertRaisesRegex(ValueError, "needs its unit"):
            domino.Row.from_pandas(frame.rename(columns={"height (mm)": "height"}))
        frame["gap (cm)"] = [2, 2]
        self.assertEqual([one.gap for one in domino.Row.from_pandas(frame)], [0, 0.02])
        frame["gap (cm)"] = [2, math.nan]
        with self.assertRaisesRegex(ValueError, "domino 1 has no gap, .* move all one line down"):
            domino.Row.from_pandas(frame)
        frame["gap (cm)"] = [math.nan, math.nan]
        with self.assertRaisesRegex(domino.OutOfRange, r"a gap is outside its range \(domino 2\)"):
            domino.Row.from_pandas(frame).verdict()

    def test_windows_hold_what_they_promise(self):
        row = domino.Row.of_train(5)
        window = row.tolerance("gap")[1]
        for gap, falls in ((window.low * 1.001, True), (window.high * 0.999, True), (window.high * 1.01, False)):
            dominoes = list(row.dominoes)
            dominoes[2] = dominoes[2]._replace(gap=gap)
            self.assertEqual(domino.Row(dominoes).verdict().falls, falls)


if __name__ == "__main__":
    unittest.main()
