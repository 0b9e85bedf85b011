#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Programs on a full disk, and killed at any moment: what a file held before stands until all of what
comes in its stead is written, and the reason is told.

usage: writes_test.py FOLDER_OF_PROGRAMS

strace makes the n-th system call that changes a file fail, or kills the program there, for all n."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = pathlib.Path(sys.argv.pop())
MAPS = REPOSITORY / "maps" / "simple"
OLD = "what was there before\n"
WRITES = ["write", "writev", "pwrite64"]
CHANGES = WRITES + ["rename", "renameat", "renameat2", "unlink", "unlinkat", "fsync", "ftruncate", "mkdir"]
FULL = ["%s:error=ENOSPC" % call for call in WRITES]
KILLED = ["%s:signal=KILL" % call for call in CHANGES]
EXPERIMENT = """name: two
sentence: Two short drives.
start_known: true
duration: 2
seeds: {first: 1, count: 2}
cores: [{filter: kld}]
cases: [{label: simple, world: %s}]
""" % MAPS


def traced(command, inject, folder):
    """The run's result, and whether anything was injected."""
    log = folder / "strace"
    done = subprocess.run(
        ["strace", "-f", "-qq", "-o", str(log), "-e", "trace=" + ",".join(CHANGES), "-e", "inject=" + inject,
         str(PROGRAMS / command[0])] + [str(word) for word in command[1:]],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
        env=dict(os.environ, ASAN_OPTIONS="detect_leaks=0"))
    told = log.read_text(errors="replace")
    return done, "(INJECTED)" in told or "killed by SIGKILL" in told


def can_trace():
    with tempfile.TemporaryDirectory() as folder:
        try:
            done = subprocess.run(["strace", "-o", folder + "/log", "true"], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE)
        except OSError:
            return False
        return done.returncode == 0


def carmen_log(steps=12):
    """A robot that drives straight on among what it does not know."""
    lines = ["# CARMEN Logfile"]
    for i in range(steps):
        ranges = " ".join("%.2f" % (2.0 + 0.05 * (k % 7)) for k in range(31))
        lines.append("FLASER 31 %s %.2f 0 0 %.2f 0 0 %.1f host %.1f"
                     % (ranges, 0.3 * i, 0.3 * i, 0.1 * i, 0.1 * i))
    return "\n".join(lines) + "\n"


def is_complete(file):
    """Whether nothing is missing at the end of what a program wrote."""
    text = file.read_bytes()
    if file.suffix == ".json":
        return isinstance(json.loads(text.decode()), (dict, list))
    if file.suffix == ".pgm":
        _, size, depth, cells = text.split(b"\n", 3)
        width, height = map(int, size.split())
        return depth == b"255" and len(cells) == width * height
    lines = text.decode().splitlines()
    if file.suffix == ".tum":
        return len(lines) > 2 and len(lines[-1].split()) == 8
    if file.suffix == ".csv":
        return len(lines) > 2 and lines[-1].count(",") == lines[0].count(",")
    return file.suffix == ".yaml" and lines[-1].startswith("free_thresh: ")


@unittest.skipUnless(can_trace(), "strace is not there, or may not trace")
class Writes(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, str(self.root))
        self.out = self.root / "out"

    def prepare(self, outputs):
        """All files are there, of an earlier run."""
        shutil.rmtree(str(self.out), ignore_errors=True)
        for output in outputs:
            output.parent.mkdir(parents=True, exist_ok=True)
            output.write_text(OLD)

    def assert_none_is_broken(self, outputs):
        for output in outputs:
            if output.read_bytes() != OLD.encode():
                self.assertTrue(is_complete(output), "%s: %r" % (output, output.read_bytes()[-80:]))

    def assert_all_are_new(self, outputs):
        for output in outputs:
            self.assertTrue(is_complete(output), output)

    def for_each(self, faults, command, prepare, check):
        """Runs a command with each fault at the first, second, ... call, until there is no further."""
        injected = 0
        for fault in faults:
            for n in range(1, 1000):
                prepare()
                done, was_injected = traced(command, "%s:when=%d" % (fault, n), self.root)
                if not was_injected:
                    self.assertEqual(done.returncode, 0, done.stderr)
                    break
                injected += 1
                with self.subTest(fault=fault, n=n, said=done.stderr[-200:]):
                    check(done)
        return injected

    def check(self, command, names):
        outputs = [self.out / name for name in names]

        def check_full(done):
            self.assertIn(done.returncode, (0, 1))
            self.assert_none_is_broken(outputs)
            if done.returncode == 0:
                self.assert_all_are_new(outputs)
            elif any(output.read_bytes() == OLD.encode() for output in outputs):
                self.assertIn("No space left on device", done.stderr)

        prepare = lambda: self.prepare(outputs)
        full = self.for_each(FULL, command, prepare, check_full)
        self.assertGreaterEqual(full, len(outputs))
        killed = self.for_each(KILLED, command, prepare, lambda _: self.assert_none_is_broken(outputs))
        self.assertGreaterEqual(killed, 3 * len(outputs))  # write, fsync, rename
        self.assert_all_are_new(outputs)
        self.assertEqual([str(path) for path in self.out.rglob("*.part")], [])

    def test_draw_map(self):
        self.check(["draw_map", MAPS / "world.yaml", "0.1", self.out / "map"], ["map.pgm", "map.yaml"])

    def test_energy_grid(self):
        self.check(["energy_grid", "--map", MAPS / "map.yaml", "--json", self.out / "grid.json"], ["grid.json"])

    def test_line_drive(self):
        self.check(["line_drive", MAPS / "world.yaml", "--seconds", 5, "--json", self.out / "drive.json"],
                   ["drive.json"])

    def test_sonar_map(self):
        self.check(["sonar_map", "--world", MAPS / "world.yaml", "--seconds", 5, "--model", "elfes",
                    "--out", self.out, "--json", self.out / "numbers.json", "--quiet"],
                   ["elfes/map.pgm", "elfes/map.yaml", "elfes/probability.pgm", "maps.json", "numbers.json"])

    def test_replay(self):
        log = self.root / "drive.log"
        log.write_text(carmen_log())
        self.check(["replay", "--map", MAPS / "map.yaml", "--log", log, "--start", "1.5,1.5,0", "--allow-misfit",
                    "--trajectory", self.out / "poses.tum", "--json", self.out / "numbers.json",
                    "--report", self.out / "report", "--set", "cache_dir=" + str(self.root / "cache"), "--quiet"],
                   ["poses.tum", "numbers.json", "report/map.pgm", "report/map.yaml", "report/scans.csv",
                    "report/views.json", "report/run.json"])

    def runs_in(self, file):
        """The seeds of its whole lines; what comes after them is no line yet."""
        return [json.loads(line)["seed"] for line in file.read_text().split("\n")[:-1]]

    def test_experiments(self):
        """What was measured is kept; what is missing is made when called again."""
        experiment, results = self.root / "two.yaml", self.root / "results.jsonl"
        experiment.write_text(EXPERIMENT)
        command = ["experiments", experiment, "--out", results, "--jobs", 1, "--quiet"]
        whole = [str(word) for word in [PROGRAMS / command[0]] + command[1:]]
        subprocess.run(whole + ["--seeds", "1"], check=True)
        first = results.read_text()

        def check(_):
            self.assertTrue(results.read_text().startswith(first))
            self.assertIn(self.runs_in(results), ([1], [1, 2]))
            subprocess.run(whole, check=True)
            self.assertEqual(self.runs_in(results), [1, 2])

        self.assertGreater(self.for_each(FULL + KILLED, command, lambda: results.write_text(first), check), 1)

    def test_cache(self):
        """A grid that was not written whole is made anew, and nobody says that it is damaged."""
        log, cache = self.root / "drive.log", self.root / "cache"
        log.write_text(carmen_log())
        command = ["replay", "--map", MAPS / "map.yaml", "--log", log, "--start", "global", "--allow-misfit",
                   "--quiet", "--set", "cache_dir=" + str(cache)]
        whole = [str(word) for word in [PROGRAMS / command[0]] + command[1:]]

        def check(done):
            self.assertIn(done.returncode, (0, -9, 137))
            again = subprocess.run(whole, stderr=subprocess.PIPE, universal_newlines=True)
            self.assertEqual((again.returncode, "made anew" in again.stderr), (0, False), again.stderr)

        remove = lambda: shutil.rmtree(str(cache), ignore_errors=True)
        self.assertGreater(self.for_each(FULL + KILLED, command, remove, check), 2)


if __name__ == "__main__":
    unittest.main()
