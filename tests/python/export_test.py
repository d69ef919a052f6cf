"""Exports from Python are those of the program."""

from support import FolderTest, program, tiny_case

import knitmech


class Export(FolderTest):
    def setUp(self):
        super().setUp()
        self.case = tiny_case()
        self.path = self.folder / "tiny.toml"
        self.case.save(self.path)

    def test_a_case(self):
        program("export", self.path, "-f", "abaqus", "-o", self.folder / "program.inp")
        files = knitmech.export(self.case, "abaqus", self.folder / "ours.inp")
        self.assertEqual(files, [self.folder / "ours.inp"])
        self.assertEqual(files[0].read_bytes(), (self.folder / "program.inp").read_bytes())

    def test_every_format_of_a_run(self):
        run = self.case.run(self.folder / "run")
        for name, format in knitmech.export_formats().items():
            if name == "calculix-beams":
                continue  # see test_what_a_format_refuses
            with self.subTest(format=name):
                ours, theirs = self.folder / f"ours-{name}", self.folder / f"theirs-{name}"
                ours.mkdir()
                theirs.mkdir()
                files = knitmech.export(run, name, ours / "jersey")
                self.assertGreater(len(files), 0)
                program("export", run.folder, "-f", name, "-o", theirs / "jersey")
                self.assertEqual(sorted(files), sorted(ours.iterdir()))
                for file in files:
                    expected = (theirs / file.name).read_bytes()
                    self.assertEqual(file.read_bytes(), expected, file.name)
                if not format.has_frames:
                    with self.assertRaisesRegex(knitmech.InputError, "has no frames"):
                        knitmech.export(run, name, ours / "framed", frame=run.frame(1))

    def test_what_a_format_refuses(self):
        """Beams without contact hold nothing of courses that hang in each other."""
        with self.assertRaisesRegex(knitmech.InputError, "only contact joins the courses"):
            knitmech.export(self.case, "calculix-beams", self.folder / "refused.inp")
        self.assertFalse((self.folder / "refused.inp").exists())

    def test_what_is_not_there(self):
        with self.assertRaisesRegex(knitmech.InputError, 'there is no format "ansys"'):
            knitmech.export(self.case, "ansys", self.folder / "x")
        with self.assertRaises(knitmech.CaseError):
            knitmech.export(knitmech.Case(""), "abaqus", self.folder / "x")
        with self.assertRaises(OSError):
            knitmech.export(self.case, "abaqus", self.folder / "none" / "x.inp")
        run = self.case.run(self.folder / "run")
        with self.assertRaisesRegex(TypeError, "a case has no frames"):
            knitmech.export(self.case, "abaqus", self.folder / "x", frame=run.frame())
