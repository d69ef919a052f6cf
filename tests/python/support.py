"""What the tests of the module share."""

from __future__ import annotations

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import knitmech

PROGRAM = os.environ["KNITMECH_PROGRAM"]
SOURCE = pathlib.Path(os.environ["KNITMECH_SOURCE"])


def tiny_case() -> knitmech.Case:
    """The main case made so small that it is simulated at once: 3 x 2 stitches, 2 % strain."""
    case = knitmech.Case.new()
    case["fabric.wales"] = 3
    case["fabric.courses"] = 2
    case["test.strain"] = 0.02
    case["test.speed"] = "20 mm/s"
    case["test.ramp"] = "10 ms"
    case["solver.mass_scaling"] = 1e4
    case["output.frames_at"] = [0.01]
    case["output.history_points"] = 20
    return case


def program(*arguments: object) -> str:
    """What the program prints."""
    words = [PROGRAM, *map(str, arguments)]
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def program_json(*arguments: object) -> dict:
    return json.loads(program(*arguments))


class FolderTest(unittest.TestCase):
    """A test with an empty folder of its own."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory(prefix="knitmech-python-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
