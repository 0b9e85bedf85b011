#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Confidence and covariances mean what they say: in simulation, and on recordings where there are some.

usage: calibration_test.py FOLDER_OF_PROGRAMS

A pose with a confidence of p is less than 0.3 m off in a share p of all cases. The normalised estimation
error squared (NEES, Bar-Shalom 2001) of a covariance that is exact is 3 in the mean and 2.4 in the median."""
import importlib.machinery
import importlib.util
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = pathlib.Path(sys.argv.pop())
EXPERIMENTS = REPOSITORY / "config" / "experiments"
DATA = pathlib.Path(os.environ.get("ADAPTIVE_LOCALIZATION_DATA", REPOSITORY.parent / "shared" / "data"))


def script(name):
    """A program of scripts/ as a module."""
    sys.path.insert(0, str(REPOSITORY / "scripts"))
    loader = importlib.machinery.SourceFileLoader(name, str(REPOSITORY / "scripts" / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


def experiments(name, only, seeds):
    """The results of an experiment, of the cases and cores that match."""
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "out.jsonl")
        subprocess.run([str(PROGRAMS / "experiments"), str(EXPERIMENTS / name), "--only", only, "--seeds", str(seeds),
                        "--out", file], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with open(file, encoding="utf-8") as lines:
            return [json.loads(line) for line in lines]


def replays(core):
    """The results of each recorded window, from a known start."""
    evaluate = script("evaluate")
    return {window: evaluate.run(str(PROGRAMS / "replay"), arguments, core, 1, [])
            for window, arguments in evaluate.find_windows(DATA)}


class Calibration(unittest.TestCase):
    def assertCalibrated(self, runs, most_modest):
        """The share of right poses, from a confidence of 0.5 up, is at most 0.1 below the middle of each tenth,
        where scans are many, and at most so much above it."""
        reliability = script("reliability")
        (core, (scans, near)), = reliability.counts_of(runs).items()
        told = reliability.table({core: (scans, near)})
        print(told)
        self.assertGreater(scans[reliability.TENTHS - 1], 1000, told)
        for tenth in range(reliability.TENTHS // 2, reliability.TENTHS):
            if scans[tenth] < 500:
                continue
            off = near[tenth] / scans[tenth] - reliability.middle(tenth)
            self.assertGreater(off, -0.1, told)
            self.assertLess(off, most_modest, told)
        self.assertLess(reliability.calibration_error(scans, near), 0.1, told)

    def test_confidence_where_places_look_alike_and_after_kidnapping(self):
        self.assertCalibrated(experiments("lookalike.yaml", "/sa_kld$", 3) + experiments("kidnap.yaml", "/sa_kld$", 4)
                              + experiments("global_start.yaml", "/sa_kld$", 4), most_modest=0.1)

    def test_covariances_are_exact_where_all_noise_is_known(self):
        runs = experiments("ekf_accuracy.yaml", "told what laser", 8)
        self.assertEqual(len(runs), 32)
        for case in {run["case"] for run in runs}:
            errors = [run["accuracy"]["normalized_mean"] for run in runs if run["case"] == case]
            self.assertEqual(len(errors), 8)
            self.assertGreater(statistics.mean(errors), 2.0, case)
            self.assertLess(statistics.mean(errors), 3.6, case)

    def test_covariances_are_cautious_where_maps_and_wheels_are_better_than_usual(self):
        for core in ["kld refined", "ekf_icp"]:
            runs = experiments("ekf_accuracy.yaml", "/%s$" % core, 4)
            errors = [run["accuracy"]["normalized_mean"] for run in runs]
            self.assertEqual(len(errors), 16)
            self.assertGreater(min(errors), 0.1, core)
            self.assertLess(max(errors), 3.0, core)

    def test_confidence_and_covariances_on_recordings(self):
        if not DATA.exists():
            self.skipTest("no recorded data")
        for core in ["sa_kld", "ekf_icp"]:
            results = replays(core)
            for window, result in results.items():
                with self.subTest(core=core, window=window):
                    print(core, window, result["nees"])
                    is_rough = "wean" in window  # its reference is good to 0.2 to 0.3 m
                    self.assertGreater(result["nees"]["median"], 0.3)
                    self.assertLess(result["nees"]["median"], 60 if is_rough else 8)
            self.assertCalibrated(list(results.values()), most_modest=0.5)


if __name__ == "__main__":
    unittest.main()
