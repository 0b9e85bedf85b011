#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/swarms, on numbers that are made up here."""
import json
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "swarms"


def fix(iterations, is_reached, is_found, matched_mm):
    return {"seed": 1, "iterations": iterations, "cost": 0.02, "is_reached": is_reached, "is_found": is_found,
            "error_mm": matched_mm + 50, "matched_mm": matched_mm, "ms": 1.5}


class Swarms(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def call(self, cells, *arguments):
        file = pathlib.Path(self.folder.name) / "cells.json"
        file.write_text(cells if isinstance(cells, str) else json.dumps(cells))
        done = subprocess.run(["/usr/bin/python3", str(SCRIPT), str(file), *arguments], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True)
        return done.returncode, done.stdout, done.stderr

    def test_functions_are_a_table_and_a_plot(self):
        runs = [{"iterations": n, "is_reached": n < 500} for n in (40, 13, 10, 500)]
        cells = [{"function": "Ackley", "move": "pso", "searchers": count, "runs": runs} for count in (20, 50, 100)]
        image = pathlib.Path(self.folder.name) / "race.png"
        code, output, errors = self.call(cells, "--plot", str(image))
        self.assertEqual(code, 0, errors)
        self.assertIn("\n| Ackley, pso | 141 (75) | 141 (75) | 141 (75) |", output)
        self.assertEqual(image.read_bytes()[1:4], b"PNG")

    def test_fixes_are_a_table_and_a_comparison(self):
        leaders = {"start": "ser", "core": "lbba improved", "searchers": 20,
                   "runs": [fix(1, True, True, 4.0), fix(2, True, True, 5.0), fix(3, False, True, 6.0),
                            fix(3, False, False, 900.0)]}
        bats = {"start": "ser", "core": "ba, right sign", "searchers": 20,
                "runs": [fix(9, True, True, 5.0), fix(9, False, False, 70.0), fix(9, False, False, 80.0),
                         fix(4, False, False, 90.0)]}
        code, output, errors = self.call([leaders, bats])
        self.assertEqual(code, 0, errors)
        self.assertIn("| ser | lbba improved | 20 | 75 | 50 | 2.2 | 55.0 | 5.0 / 1.2 / 0.8 | 1.50 | 1.50 |", output)
        # 4 of 4 signs: 1 of 16; Wilcoxon's exact number for four ranks is the same
        self.assertIn("| ser | 20 | 2.2 | 7.8 | 0.062 | 0.062 |", output)

    def test_no_error_is_told_where_nobody_was_found(self):
        lost = {"start": "free", "core": "pso", "searchers": 20, "runs": [fix(500, False, False, 5000.0)] * 2}
        self.assertIn("| free | pso | 20 | 0 | 0 | 500.0 |  |  | 1.50 | 1.50 |", self.call([lost])[1])

    def test_what_cannot_be_used_is_named(self):
        for text in ("", "[]", "{}", "[{}]"):
            code, _, errors = self.call(text)
            self.assertEqual(code, 1)
            self.assertIn("cells.json", errors)


if __name__ == "__main__":
    unittest.main()
