"""The package: its names, its stub, its Python files and the listings of its page."""

import ast
import contextlib
import io
import re
import unittest

from support import SOURCE, FolderTest, program

import knitmech
from knitmech import _core

PACKAGE = SOURCE / "python" / "knitmech"
PYTHON_FILES = [
    *PACKAGE.glob("*.py*"),
    *(SOURCE / "tests" / "python").glob("*.py"),
    *(SOURCE / "examples").glob("*/*.py"),
]
DOCUMENTED = ("Case", "CaseError", "Frame", "Model", "Run", "export", "parameters", "read_run")


class Package(unittest.TestCase):
    def test_its_version_is_that_of_the_program(self):
        self.assertEqual(f"knitmech {knitmech.__version__}", program("--version").strip())

    def test_every_public_name_is_there_and_documented(self):
        for name in knitmech.__all__:
            self.assertTrue(hasattr(knitmech, name), name)
        for name in DOCUMENTED:
            self.assertTrue(getattr(knitmech, name).__doc__, name)

    def test_the_stub_has_what_the_compiled_part_has(self):
        stub = ast.parse((PACKAGE / "_core.pyi").read_text())

        def names(body):
            return {
                each.name if hasattr(each, "name") else each.target.id
                for each in body
                if isinstance(each, (ast.FunctionDef, ast.ClassDef, ast.AnnAssign))
            }

        def public(thing):
            return {name for name in vars(thing) if not name.startswith("_")}

        self.assertEqual(names(stub.body) - {"__version__"}, public(_core))
        for each in stub.body:
            if isinstance(each, ast.ClassDef):
                self.assertEqual(names(each.body), public(getattr(_core, each.name)), each.name)

    def test_every_file_is_python_in_lines_of_at_most_100_letters(self):
        self.assertGreater(len(PYTHON_FILES), 10)
        for path in PYTHON_FILES:
            text = path.read_text()
            compile(text, str(path), "exec")
            for number, line in enumerate(text.splitlines(), 1):
                self.assertLessEqual(len(line), 100, f"{path}:{number}")
                self.assertEqual(line, line.rstrip(), f"{path}:{number}")
                self.assertNotIn("\t", line, f"{path}:{number}")


class Page(FolderTest):
    def test_the_listings_of_the_page_run_as_they_are_written(self):
        page = (SOURCE / "docs" / "python.md").read_text()
        listings = re.findall(r"^```python\n(.*?)^```", page, re.DOTALL | re.MULTILINE)
        self.assertGreater(len(listings), 3)
        text = "\n".join(listings)
        for name in ("results/jersey", "jersey.toml", "jersey.inp"):
            text = text.replace(f'"{name}"', repr(str(self.folder / name)))
        names: dict = {}
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(compile(text, "docs/python.md", "exec"), names)
        self.assertIn("completed Quasi-static", printed.getvalue())
        for name in ("results/jersey/history.csv", "jersey.toml", "jersey.inp"):
            self.assertTrue((self.folder / name).exists(), name)
