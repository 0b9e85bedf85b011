#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""usage: worlds_test.py FOLDER, that of the programs

Random worlds in which the pose was once left, up to 29 m and for 35 s of tracking, though plain kld
keeps it: boxes on the map that are not there, in one of eight aisles (29, 136); a camera that looks
at furniture which was moved (158, 407); speckle on the map (153, 365); somebody who stands
before a camera, and was followed (853); a robot that turns close to a wall (1336); a camera that
sees but one wall again, which is not on the map (complex, 0).
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import yaml

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "worlds"
PROGRAMS = pathlib.Path(sys.argv.pop())


class WorldsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def worlds(self, *options):
        environment = {**os.environ, "EXPERIMENTS": str(PROGRAMS / "experiments"),
                       "DRAW_MAP": str(PROGRAMS / "draw_map")}
        return subprocess.run([SCRIPT, self.folder, *options], env=environment, text=True, capture_output=True)

    def test_a_place_that_was_told_is_kept(self):
        worlds = {29: 2, 136: 2, 153: 2, 158: 2, 365: 2, 407: 2, 853: 3, 1336: 4}
        for number, seeds in worlds.items():
            done = self.worlds("--worlds", f"{number}:{number + 1}", "--cores", "sa_kld", "--seeds", str(seeds))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"| `sa_kld` | {seeds} | 0 | 0 |  | 0.0 |", done.stdout)
            lines = (self.folder / f"worlds_{number}_{number + 1}_told.jsonl").read_text().splitlines()
            self.assertEqual(len(lines), seeds)
            for run in map(json.loads, lines):
                self.assertGreater(run["scans"], 400)

    def test_what_a_core_lost_is_named(self):
        done = self.worlds("--worlds", "29:30", "--cores", "mcl", "--seeds", "1", "--start", "kidnap")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("| `mcl` | 1 | 0 | 1 | 0 of 2 |", done.stdout)
        self.assertIn("  29 aisles urg clutter=0.029 moved, seed 1: mcl ", done.stdout)

    def test_maps_are_buildings_to_drive_in(self):
        maps = SCRIPT.parent.parent / "maps"
        done = self.worlds("--maps", maps / "maze/map.yaml", maps / "complex/map.yaml", "--worlds", "0:3", "--cores",
                           "sa_kld", "--seeds", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("| `sa_kld` | 6 | 0 | 0 |  | 0.0 |", done.stdout)
        runs = [json.loads(line) for line in (self.folder / "maps_0_3_told.jsonl").read_text().splitlines()]
        self.assertEqual({tuple(run["case"].split()[:2]) for run in runs},
                         {(number, name) for number in "012" for name in ("maze", "complex")})
        for run in runs:
            self.assertGreater(run["scans"], 400)

        def cells(folder, name):
            return (self.folder / folder / f"{name}.pgm").read_bytes().split(b"255\n", 1)[1]
        self.assertEqual(cells("complex_0", "building"), cells("complex_1", "building"))
        self.assertEqual(cells("complex_0", "building"), cells("complex_0", "world"))
        self.assertNotEqual(cells("complex_2", "building"), cells("complex_2", "world"), "furniture")

    def test_in_a_small_building_robots_are_carried_less_far(self):
        maze = SCRIPT.parent.parent / "maps/maze/map.yaml"
        done = self.worlds("--maps", maze, "--worlds", "0:1", "--cores", "sa_kld", "--seeds", "1", "--start", "kidnap")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"\| `sa_kld` \| 1 \|.*\| \d of 2 \|")
        experiment = yaml.safe_load((self.folder / "maps_0_1_kidnap.yaml").read_text())
        self.assertAlmostEqual(experiment["cases"][0]["events"][0]["to"]["farther_than"], 1.8, delta=0.3)

    def test_maps_of_one_name_are_refused(self):
        maze = SCRIPT.parent.parent / "maps/maze/map.yaml"
        done = self.worlds("--maps", maze, maze)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("--maps: got maze, maze, expected files, or folders of map.yaml, of different names", done.stderr)

    def test_a_range_that_is_none_is_refused(self):
        done = self.worlds("--worlds", "7")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("--worlds: got '7', expected FIRST:LAST", done.stderr)


if __name__ == "__main__":
    unittest.main()
