#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/draw, where it cannot draw; what it draws is tested with the programs that write for it."""
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "draw"


class Draw(unittest.TestCase):
    def refusal(self, text, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "what.json"
            file.write_bytes(text.encode("latin-1"))
            done = subprocess.run(["/usr/bin/python3", str(SCRIPT), str(file), *arguments], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, universal_newlines=True)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertNotIn("Traceback", done.stderr)
            return done.stderr

    def test_a_file_of_another_kind_is_named(self):
        for text in ("{}", "[]", '{"kind": "song"}'):
            self.assertIn("what.json': kind is ", self.refusal(text))
        self.assertIn("expected one of energies, sonar_maps", self.refusal('{"kind": "song"}'))

    def test_what_is_missing_is_named(self):
        for text in ("", "\xd6\x00", '{"kind": '):
            self.assertIn("what.json': ", self.refusal(text))
        self.assertIn("what.json': no 'map'", self.refusal('{"kind": "energies"}'))
        self.assertIn("/nosuch/map.yaml", self.refusal('{"kind": "energies", "map": "/nosuch/map.yaml"}'))

    def test_a_picture_that_cannot_be_written_is_named(self):
        self.assertIn("/nosuch/x.png", self.refusal(
            '{"kind": "sonar_profiles", "profiles": [{"model": "elfes", "range": 1, "along": [[0, 0.5]], '
            '"arc": [[0, 0.5]], "half_way": [[0, 0.5]]}]}', "/nosuch/x.png"))


if __name__ == "__main__":
    unittest.main()
