#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/reliability, on numbers that are made up here."""
import json
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "reliability"


def calibration(**tenths):
    """scans and near by tenth: t9=(10, 9)."""
    values = [tenths.get(f"t{i}", (0, 0)) for i in range(10)]
    return {"scans": [scans for scans, _ in values], "near": [near for _, near in values]}


class Reliability(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return str(self.folder / name)

    def call(self, *arguments):
        done = subprocess.run(["/usr/bin/python3", str(SCRIPT), *arguments], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True)
        return done.returncode, done.stdout, done.stderr

    def test_adds_up_experiments_and_recordings(self):
        drives = self.write("drives.jsonl", "\n".join(json.dumps(
            {"label": "kld", "filter": "kld", "calibration": calibration(t9=(10, 9), t5=(4, 2))}) for _ in range(2)))
        recordings = self.write("recordings.json", json.dumps([
            {"filter": "kld", "calibration": calibration(t9=(20, 20))},
            {"filter": "mcl", "calibration": calibration(t0=(5, 0))},
            {"filter": "mcl", "calibration": None}]))
        image = str(self.folder / "plot.png")
        code, output, errors = self.call(drives, recordings, "--plot", image)
        self.assertEqual(code, 0, errors)
        self.assertIn("| 0.9 to 1.0 | 0.95 (40) | – |", output)
        self.assertIn("| 0.5 to 0.6 | 0.50 (8) | – |", output)
        self.assertIn("| 0.0 to 0.1 | – | 0.00 (5) |", output)
        self.assertIn("| mean distance | 0.008 | 0.050 |", output)  # 8 of 48 scans are 0.05 off
        self.assertEqual(pathlib.Path(image).read_bytes()[1:4], b"PNG")

    def test_takes_one_run(self):
        run = self.write("run.json", json.dumps({"filter": "kld", "calibration": calibration(t9=(4, 4))}))
        self.assertIn("| 0.9 to 1.0 | 1.00 (4) |", self.call(run)[1])

    def test_says_what_it_cannot_use(self):
        for text in ("", "{", '[{"filter": "kld", "calibration": {}, "x": 1}]', "[3]", "[]"):
            code, _, errors = self.call(self.write("x.json", text))
            self.assertEqual(code, 1, text)
            self.assertIn("reliability: ", errors)
            self.assertNotIn("Traceback", errors)
        self.assertIn("nosuch", self.call("nosuch.json")[2])


if __name__ == "__main__":
    unittest.main()
