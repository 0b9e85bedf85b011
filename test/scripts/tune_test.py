#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/tune, with a program in place of replay whose errors are known."""
import os
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "tune"
# The laser sits 0.08 m ahead and is turned by 0.03 rad, and its scans are 0.06 s late; the log says otherwise.
REPLAY = """#!/usr/bin/python3
import json, math, pathlib, sys
words = sys.argv[1:]
value = lambda name: words[words.index(name) + 1]
settings = dict(word.split("=") for word in words if "=" in word)
x, _, yaw = map(float, value("--mount").split(",")) if "--mount" in words else (0.0, 0.0, 0.0)
late = 0.06 + float(settings.get("scan_time_offset", 0))
error = 0.01 + math.sqrt((x - 0.08) ** 2 + 4 * (yaw - 0.03) ** 2 + late ** 2)
folder = pathlib.Path(value("--report"))
folder.mkdir(parents=True, exist_ok=True)
(folder / "views.json").write_text("[]")
(folder / "map.pgm").write_bytes(b"P5 40 40 255\\n" + bytes([254] * 1600))
(folder / "map.yaml").write_text("image: map.pgm\\nresolution: 0.1\\norigin: [0, 0, 0]\\n")
(folder / "run.json").write_text(json.dumps({
    "filter": "kld", "log": "l", "map": "m", "spoil": "", "start": "", "scans": 100, "duration_s": 100, "path_m": 10,
    "ate_rmse_m": error, "ate_max_m": error, "heading_rmse_deg": 0, "lost_share": 0, "misled_share": 0,
    "misled_longest_s": 0, "status": {"tracking": 1}, "jumps": 0, "confidence_mean": 1, "peak_rss_mb": 1,
    "update_ms": {"median": 1, "p99": 1, "longest_after_first": 1, "first": 1},
    "particles": {"mean": 1, "max": 1}, "mount": [0, 0, 0]}))
names = ("stamp,x,y,yaw,deviation,status,confidence,fit,modes,particles,updated,update_ms,"
         "odom_x,odom_y,odom_yaw,reference_x,reference_y,reference_yaw")
begin, end = (max(0.0, float(value("--begin"))), min(100.0, float(value("--end"))))
def times(a, b):
    return (a[0] + math.cos(a[2]) * b[0] - math.sin(a[2]) * b[1], a[1] + math.sin(a[2]) * b[0] + math.cos(a[2]) * b[1],
            a[2] + b[2])
def estimate(base):  # of a robot whose laser is where the scans say, as seen from where it is said to be
    laser = times(base, (0.08, 0.0, 0.03))
    back = (-x * math.cos(yaw), x * math.sin(yaw), -yaw)
    return "%f,%f,%f" % times(laser, back)
rows = [f"{t},{estimate((t / 30, 1, 0.01 * (t % 7) ** 2))},0.1,tracking,1,1,1,100,1,1,{t / 30},1,{0.01 * (t % 7) ** 2},"
        f"{t / 30},1,{0.0101 * (t % 7) ** 2}" for t in range(101) if begin <= t <= end]
(folder / "scans.csv").write_text("\\n".join([names, *rows]) + "\\n")
with open(pathlib.Path(__file__).with_name("calls"), "a") as calls:
    calls.write("x")
"""


class Tune(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        replay = self.folder / "replay"
        replay.write_text(REPLAY)
        replay.chmod(0o755)

    def tune(self, *more, reference=("--truth", "t.tum")):
        done = subprocess.run(["/usr/bin/python3", str(SCRIPT), "--map", "m.yaml", "--log", "l.bag", *reference,
                               "--out", str(self.folder / "out"), *more], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True,
                              env=dict(os.environ, REPLAY=str(self.folder / "replay")))
        return done.returncode, done.stdout, done.stderr

    @staticmethod
    def mount_in(lines):
        """What --mount of replay is said to be."""
        said = next(line for line in lines if "--mount" in line).split("--mount ")[1].split(")")[0]
        return [float(part) for part in said.split(",")]

    def test_finds_mount_and_time_offset_and_goes_on_after_an_interruption(self):
        code, output, errors = self.tune()
        self.assertEqual(code, 0, errors)
        lines = (self.folder / "out" / "tuned.yaml").read_text().splitlines()
        values = dict(line.split(": ") for line in lines if not line.startswith("#"))
        self.assertAlmostEqual(float(values["scan_time_offset"]), -0.06, delta=0.01)
        x, _, yaw = self.mount_in(lines)
        self.assertAlmostEqual(x, 0.08, delta=0.01)
        self.assertAlmostEqual(yaw, 0.03, delta=0.005)
        self.assertNotIn("laser_max_beams", values, "it makes no difference")
        before, after = [float(word) for word in output.splitlines()[-2].split() if word.startswith("0.")]
        self.assertGreater(before, 0.1)
        self.assertLess(after, 0.02)
        self.assertIn("<html", (self.folder / "out" / "report.html").read_text())
        calls = len((self.folder / "calls").read_text())
        self.assertEqual(self.tune()[1], output)
        self.assertEqual(len((self.folder / "calls").read_text()), calls + 2, "only the two that judge, anew")

    def test_finds_a_mount_without_a_reference(self):
        code, output, errors = self.tune("--start", "0,1,0", reference=[])
        self.assertEqual(code, 0, errors)
        self.assertIn("mount: x 0.080 m, yaw 0.0300 rad; the log has 0.000 m, 0.0000 rad", output)
        tuned = (self.folder / "out" / "tuned.yaml").read_text()
        x, y, yaw = self.mount_in(tuned.splitlines())  # of least squares, whose last digits are the processor's
        self.assertAlmostEqual(x, 0.08, delta=0.0002)
        self.assertEqual(y, 0.0)
        self.assertAlmostEqual(yaw, 0.03, delta=0.0002)
        self.assertIn("odom_alpha1: ", tuned)
        self.assertNotIn("scan_time_offset", tuned)
        before, after = [float(word) for word in output.splitlines()[-2].split() if word.startswith("0.")]
        self.assertLess(after, 0.1 * before)

    def test_needs_a_reference_or_a_start(self):
        done = subprocess.run(["/usr/bin/python3", str(SCRIPT), "--map", "m", "--log", "l", "--out", str(self.folder / "out")],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("--truth", done.stderr)

    def test_says_why_replay_failed(self):
        (self.folder / "replay").write_text("#!/bin/sh\necho 'replay: no such map' >&2\nexit 1\n")
        code, _, errors = self.tune()
        self.assertEqual(code, 1)
        self.assertIn("replay: no such map", errors)


if __name__ == "__main__":
    unittest.main()
