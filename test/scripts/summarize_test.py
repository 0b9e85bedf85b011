#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/summarize and what it counts, on runs that are made up here."""
import contextlib
import copy
import importlib.machinery
import io
import json
import pathlib
import random
import sys
import tempfile
import unittest
from unittest import mock

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))
sys.dont_write_bytecode = True
summarize = importlib.machinery.SourceFileLoader("summarize", str(SCRIPTS / "summarize")).load_module()
ACCURACY = {"scans": 0, "mean_m": 0.0, "mean_deg": 0.0, "normalized_mean": None, "normalized": [],
            "scan_bound_m": None, "scan_bound_deg": None, "drive_bound_m": None, "drive_bound_deg": None}


def trial(found_s=None, kind="start"):
    return {"kind": kind, "pose": [0, 0, 0], "found_s": found_s, "told_s": found_s, "validated_s": None,
            "wrongly_validated": 0, "within_s": None, "left_s": None, "at": 0.0, "scans": 100, "searching": 5,
            "searching_tracking": 2 if found_s is None else 0, "late_tracking": 0, "searching_ambiguous": 0,
            "end_status": "", "end_error_m": 3.0 if found_s is None else 0.1, "end_error_deg": 0.0,
            "is_silent_failure": found_s is None}


def run(seed, found_s=None, label="kld"):
    return {"experiment": "toy", "case": "hall", "label": label, "seed": seed, "settings": "same",
            "filter": "kld", "preset": "recommended", "duration_s": 10.0, "scans": 100, "updates": 50,
            "settled_s": 0.0 if found_s is None else 36.0, "left_tracking": 0, "false_jumps": 0, "jumps": 0,
            "silently_wrong": 0, "silently_wrong_s": 0.0, "carried": 0, "carried_tracking": 0,
            "carried_jumps": 0, "status": {"tracking": 25, "globalizing": 75}, "first_mass": 0.0,
            "second_mass": 0.0, "both_share": None, "has_both_at_end": False,
            "calibration": {"scans": [0] * 10, "near": [0] * 10}, "rms_m": 0.0, "rms_deg": 0.0, "max_m": 0.0,
            "accuracy": dict(ACCURACY), "probe_errors_m": [], "arrival_errors_m": [], "way_error_m": 0.0,
            "looks_elsewhere": 0, "particles_first": 0, "particles_max": 10 * seed, "particles_by_s": [],
            "particles_mean": 0.0, "update_ms_median": 0.0, "update_ms_max": 0.0, "trials": [trial(found_s)]}


def ten_runs(label="kld"):
    """Found after 1, 2, ... 9 s and never."""
    return [run(seed, seed if seed < 10 else None, label) for seed in range(1, 11)]


class Summarize(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def file(self, name):
        return str(pathlib.Path(self.folder.name) / name)

    def call(self, *arguments):
        """Exit code, output, and what is wrong."""
        output = io.StringIO()
        with mock.patch("sys.argv", ["summarize", *arguments]), contextlib.redirect_stdout(output):
            try:
                summarize.main()
            except SystemExit as end:
                return 1, output.getvalue(), str(end)
        return 0, output.getvalue(), ""

    def write(self, runs, name="runs.jsonl"):
        with open(self.file(name), "w", encoding="utf-8") as file:
            file.writelines(json.dumps(one) + "\n" for one in runs)
        return self.file(name)

    def summary(self, runs):
        """Rows and table."""
        code, output, errors = self.call(self.write(runs), "--json", self.file("summary.json"))
        self.assertEqual(code, 0, errors)
        with open(self.file("summary.json"), encoding="utf-8") as file:
            return json.load(file), output

    def row(self, runs):
        rows, output = self.summary(runs)
        self.assertEqual(len(rows), 1)
        return rows[0], output

    def test_counts_and_takes_quantiles(self):
        row, table = self.row(ten_runs())
        self.assertEqual(row["runs"], 10)
        self.assertEqual((row["found"]["count"], row["found"]["of"]), (9, 10))
        self.assertEqual(row["found_s"], {"median": 5.0, "p95": None}, "a tenth was never found")
        self.assertEqual(row["right_at_end"]["count"], 9)
        self.assertEqual(row["silent_failures"]["count"], 1)
        self.assertEqual(row["always_flagged"]["count"], 9)
        self.assertAlmostEqual(row["false_alarms"]["settled_h"], 0.09)
        self.assertAlmostEqual(row["tracking_share"], 0.25)
        self.assertEqual(row["particles"]["max"], 100)
        self.assertIn("| hall | kld | 10 | 9/10 | 59.6–98.2 % | 5.0, never |", table)

    def test_intervals_are_those_that_were_published(self):
        """Newcombe, Statistics in Medicine 17 (1998), table I, method 3."""
        for count, of, low, high in [(81, 263, .2553, .3662), (15, 148, .0624, .1605), (0, 20, 0, .1611)]:
            found = self.row([run(i, 1.0 if i < count else None) for i in range(of)])[0]["found"]
            self.assertAlmostEqual(found["low"], low, delta=5e-5)
            self.assertAlmostEqual(found["high"], high, delta=5e-5)

    def test_tells_trials_that_were_ambiguous_apart(self):
        runs = ten_runs()
        for one in runs:
            one["trials"][0]["searching_ambiguous"] = int(one["seed"] > 4)
        row, table = self.row(runs)
        self.assertEqual(row["ambiguous"]["count"], 6)
        self.assertEqual(row["found_clear_s"], {"median": 2.0, "p95": 4.0})
        self.assertIn("| 6/10 | 2.0, 4.0 |", table)

    def test_leaves_out_starts_that_were_known(self):
        known = run(1)
        known["trials"] = [trial(0.0, "known start")]
        row, table = self.row([known])
        self.assertIsNone(row["found"])
        self.assertNotIn("found", table)
        self.assertIn("| hall | kld | 1 |", table)

    def test_counts_known_starts_that_were_left(self):
        runs = ten_runs()
        for one in runs:
            one["trials"][0]["left_s"] = 1.0  # a start that was found
            one["trials"].append(trial(0.0, "known start"))
            one["trials"][1]["left_s"] = 3.0 if one["seed"] > 8 else None
        row, table = self.row(runs)
        self.assertEqual((row["left"]["count"], row["left"]["of"]), (2, 10))
        self.assertEqual(row["found"]["of"], 10)
        self.assertIn("left a known start", table)
        self.assertNotIn("left a known start", self.row(ten_runs())[1])

    def test_tells_what_was_in_time_or_flagged(self):
        prompt, late, flagged = run(1, 0.9), run(2, 1.5), run(3, 1.5)
        for one in (prompt, late, flagged):
            one["trials"][0]["within_s"] = 1.0
        late["trials"][0]["late_tracking"] = 3
        row, table = self.row([prompt, late, flagged])
        self.assertEqual(row["in_time"]["count"], 1)
        self.assertEqual(row["in_time_or_flagged"]["count"], 2)
        self.assertIn("| in time | in time or flagged |", table)
        self.assertIsNone(self.row(ten_runs())[0]["in_time"])

    def test_adds_up_jumps_and_calibration(self):
        runs = ten_runs()
        for one in runs:
            one["jumps"] = 5 if one["seed"] == 3 else 0
            one["calibration"] = {"scans": [0, 1] + [0] * 7 + [1], "near": [0] * 9 + [int(one["seed"] > 1)]}
        row, table = self.row(runs)
        self.assertEqual(row["jumps_per_run"], 0.5)
        self.assertEqual(row["calibration"]["scans"][9], 10)
        self.assertEqual(row["calibration"]["share"][9], 0.9)
        self.assertIsNone(row["calibration"]["share"][0])
        self.assertIn("| 0.50 | – 0.00 – – – – – – – 0.90 |", table)

    def test_tells_how_many_particles_there_were(self):
        runs = ten_runs()
        for one in runs:
            one["looks_elsewhere"] = 5 if one["seed"] == 2 else 1
            one["particles_by_s"] = [5000, 300]
        runs[0]["particles_by_s"] = [1000, 200, 100]  # a longer run
        row, table = self.row(runs)
        self.assertEqual(row["particles"]["by_s"], [4600.0, 290.0, 100.0])
        self.assertAlmostEqual(row["looks_elsewhere"], 1.4)
        self.assertIn("looks elsewhere per run", table)
        self.assertNotIn("looks elsewhere", self.row(ten_runs())[1])

    def test_compares_errors_with_their_bounds(self):
        runs = [run(seed, 1.0) for seed in (1, 2, 3)]
        for i, (one, error) in enumerate(zip(runs, (1.0, 2.0, 6.0))):
            one["rms_m"] = 0.02
            one["accuracy"] = dict(ACCURACY, scans=30, mean_m=0.01 * i, normalized_mean=error,
                                   normalized=[None, error, error, 100.0], scan_bound_m=0.003,
                                   scan_bound_deg=0.003, drive_bound_m=0.001, drive_bound_deg=0.001)
        lost = run(4)
        row, table = self.row(runs + [lost])
        self.assertAlmostEqual(row["nees"]["mean"], 3.0)
        self.assertAlmostEqual(row["nees"]["seconds_in_band"], 2 / 3, msg="all but the last")
        self.assertAlmostEqual(row["rms_error_m"]["rms"], 0.02)
        self.assertIn("| 10.0 (20.0), 0.00 | 20.0; 3.0, 1.0 |", table)
        self.assertIn("| 3.00; 0.90–6.34; 67 % |", table)
        for one in runs:
            one["accuracy"]["scan_bound_m"] = None
        self.assertNotIn("NEES", self.row(runs)[1])

    def test_tells_how_missions_went(self):
        runs = ten_runs()
        runs[0]["arrival_errors_m"] = [0.01, 0.03]
        runs[1]["arrival_errors_m"] = [0.02]
        row, table = self.row(runs)
        self.assertAlmostEqual(row["mission"]["median_m"], 0.02)
        self.assertAlmostEqual(row["mission"]["per_min"], 60 * 3 / 100)
        self.assertIn("off the way-points, mm", table)

    def test_does_not_depend_on_the_order_nor_on_doubles(self):
        runs = ten_runs("kld") + ten_runs("amcl")
        expected = self.summary(runs)
        shuffled = copy.deepcopy(runs) + [copy.deepcopy(runs[3])]
        random.Random(1).shuffle(shuffled)
        self.assertEqual(self.summary(shuffled), expected)
        self.assertEqual([row["core"] for row in expected[0]], ["amcl", "kld"])

    def test_makes_a_table_for_each_experiment(self):
        runs = [dict(one, both_share=0.5) for one in ten_runs()]
        other = dict(run(1, 0.25, "amcl"), experiment="other")
        table = self.summary(runs + [other])[1]
        self.assertIn("other:\n\n| case | core | runs | found |", table)
        self.assertEqual(table.count("both places at the end"), 1, "only one has such places")

    def test_a_metric_of_ones_own_is_a_column_and_a_value(self):
        with mock.patch.object(summarize, "METRICS", list(summarize.METRICS)):
            @summarize.metric("end_error_m", "error at the end, m: median", "{:.3f}".format)
            def _(row):
                return row.trials.end_error_m.median()

            @summarize.metric("scans_in_all", "scans in all")
            def _(row):
                return row.trials["scans"].sum()  # a number of numpy

            @summarize.metric("nothing", "nothing", "{:.1f}".format)
            def _(row):
                return row.known.end_error_m.median()  # of none: nan
            rows, table = self.summary(ten_runs())
        self.assertEqual(rows[0]["end_error_m"], 0.1)
        self.assertEqual(rows[0]["scans_in_all"], 1000)
        self.assertIsNone(rows[0]["nothing"])
        self.assertIn("| error at the end, m: median |", table)
        self.assertNotIn("nothing", table)

    def test_a_metric_has_a_name_of_its_own(self):
        for key in ("case", summarize.METRICS[0][0]):
            with self.assertRaisesRegex(ValueError, key):
                summarize.metric(key)(len)

    def test_draws(self):
        code, _, errors = self.call(self.write(ten_runs()), "--plot", self.file("plot.png"))
        self.assertEqual(code, 0, errors)
        self.assertEqual(pathlib.Path(self.file("plot.png")).read_bytes()[1:4], b"PNG")
        code, _, errors = self.call(self.write(ten_runs()), "--plot", self.file("plot.nosuch"))
        self.assertEqual(code, 1)
        self.assertIn("nosuch", errors)

    def test_refuses_unlike_runs(self):
        code, _, errors = self.call(self.write([run(1), dict(run(2), settings="other")]))
        self.assertEqual(code, 1)
        self.assertIn("toy/hall/kld", errors)

    def test_names_file_and_line_of_what_is_no_result(self):
        for text in (b"this is\n", b"{}\n", b"[1, 2]\n", b"3\n", b"\xd6\n"):
            path = pathlib.Path(self.write(ten_runs()))
            path.write_bytes(path.read_bytes() + text)
            code, _, errors = self.call(str(path))
            self.assertEqual(code, 1)
            self.assertIn("runs.jsonl', line 11: no result", errors)
        code, _, errors = self.call(self.file("nosuch.jsonl"))
        self.assertEqual(code, 1)
        self.assertIn("nosuch.jsonl", errors)

    def test_refuses_keys_that_are_none_and_files_without_a_result(self):
        path = pathlib.Path(self.write([dict(run(1), case=["a"])]))
        code, _, errors = self.call(str(path))
        self.assertEqual(code, 1)
        self.assertIn("runs.jsonl', line 1: no result", errors)
        path.write_text("")
        code, _, errors = self.call(str(path))
        self.assertEqual(code, 1)
        self.assertIn("runs.jsonl': no result in there", errors)

    def test_leaves_out_a_line_that_was_cut_off(self):
        path = pathlib.Path(self.write(ten_runs()))
        path.write_text(path.read_text()[:-5])
        self.assertIn("| hall | kld | 9 |", self.call(str(path))[1])


if __name__ == "__main__":
    unittest.main()
