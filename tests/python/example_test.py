"""The example runs as it is written, and gives the figures that its page promises."""

import re
import subprocess
import sys

import numpy as np
from support import SOURCE, FolderTest

EXAMPLE = SOURCE / "examples" / "11-python"


class Example(FolderTest):
    def test_it_runs_and_keeps_its_promise(self):
        script = [sys.executable, str(EXAMPLE / "wale_tension.py")]
        ran = subprocess.run(script, cwd=self.folder, capture_output=True, text=True)
        self.assertEqual((ran.returncode, ran.stderr), (0, ""))
        self.assertIn("completed: Quasi-static", ran.stdout)

        # rows of the page: | 0.1 | 0.780 mN |
        page = (EXAMPLE / "README.md").read_text()
        promised = re.findall(r"^\| ([\d.]+) \| ([\d.]+) mN \|", page, re.M)
        printed = re.findall(r"^ +([\d.]+) +([\d.]+) mN", ran.stdout, re.M)
        self.assertEqual(len(promised), 3)
        np.testing.assert_allclose(np.float64(printed), np.float64(promised), rtol=0.05)

        lines = (self.folder / "results" / "11-python" / "curves.csv").read_text().splitlines()
        self.assertEqual(lines[0].split(",")[:2], ["strain", "force_at_friction_0.0_N"])
        curves = np.array([[float(cell) for cell in line.split(",")] for line in lines[1:]])
        self.assertEqual(curves.shape, (81, 4))
        without, usual, rough = curves[-1, 1:]
        self.assertLess(without, usual)
        self.assertLess(usual, rough)
