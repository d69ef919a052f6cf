"""Runs from Python are those of the program, and are read back."""

import csv
import gc
import json
import unittest

import numpy as np
from support import FolderTest, program, tiny_case

import knitmech


class Runs(FolderTest):
    def setUp(self):
        super().setUp()
        self.case = tiny_case()
        self.run_folder = self.folder / "run"

    def test_it_is_the_run_of_the_program_bit_by_bit(self):
        path = self.folder / "tiny.toml"
        self.case.save(path)
        program("run", path, "-o", self.folder / "program", "--no-pictures", "--quiet")
        for threads in (None, 2):
            run = self.case.run(self.run_folder, threads=threads)
            self.assertEqual(run.status, "completed")
            for file in ("history.csv", "case.toml", "frames/frame_0002.vtp"):
                ours, theirs = self.run_folder / file, self.folder / "program" / file
                self.assertEqual(ours.read_bytes(), theirs.read_bytes(), file)

    def test_the_history_has_the_columns_of_the_file(self):
        run = self.case.run(self.run_folder)
        with open(self.run_folder / "history.csv", newline="") as file:
            names, *rows = csv.reader(file)
        self.assertEqual(run.history.dtype.names, tuple(names))
        self.assertEqual(run.history.shape, (21,))
        for column, name in enumerate(names):
            self.assertEqual([float(row[column]) for row in rows], run.history[name].tolist(), name)
        self.assertEqual(run.frame(1).row["force_top_N"], run.history["force_top_N"][10])

    def test_a_folder_is_read_as_it_was_run(self):
        ran = self.case.run(self.run_folder)
        read = knitmech.read_run(str(self.run_folder))
        np.testing.assert_array_equal(read.history, ran.history)
        self.assertEqual(read.frames, ran.frames)
        self.assertEqual(read.folder, self.run_folder)
        self.assertEqual(read.reason, "")
        self.assertEqual(read.summary, json.loads((self.run_folder / "summary.json").read_text()))
        self.assertEqual(read.case.text, (self.run_folder / "case.toml").read_text())
        self.assertEqual(read.case["fabric.wales"], 3)
        np.testing.assert_array_equal(read.model.nodes, self.case.model().nodes)

    def test_frames_by_index_and_by_strain(self):
        run = self.case.run(self.run_folder)
        self.assertEqual([frame.index for frame in run.frames], [0, 1, 2])
        self.assertEqual(run.frame().index, 2)
        self.assertEqual(run.frame(0).strain, 0)
        self.assertEqual(run.frame(1).strain, run.frames[1].strain)
        self.assertEqual(run.frame_at(0.012).index, 1)
        with self.assertRaises(IndexError):
            run.frame(3)

    def test_the_fields_of_a_frame(self):
        run = self.case.run(self.run_folder)
        frame, model = run.frame(), run.model
        n, m = len(model.nodes), len(model.elements)
        for name, shape in (
            ("positions", (n, 3)),
            ("rotations", (n, 4)),
            ("contact_force", (n, 3)),
            ("tie_force", (n, 3)),
            ("gap", (n,)),
            ("axial_force", (m,)),
            ("shear_force", (m,)),
            ("bending_moment", (m,)),
            ("torque", (m,)),
            ("axial_strain", (m,)),
            ("curvature", (m,)),
            ("stretch_energy", (m,)),
            ("bending_energy", (m,)),
            ("twist_energy", (m,)),
            ("broken", (0,)),
        ):
            array = getattr(frame, name)
            self.assertEqual(array.shape, shape, name)
            self.assertFalse(array.flags.writeable, name)
        np.testing.assert_allclose(np.linalg.norm(frame.rotations, axis=1), 1)
        np.testing.assert_array_equal(run.frame(0).positions, model.nodes)
        self.assertAlmostEqual(frame.time, run.history["time_s"][-1])

    def test_the_units_of_the_fields_fit_each_other(self):
        run = self.case.run(self.run_folder)
        frame, check = run.frame(), run.case.check()
        # N = EA strain on every element [N], M = EI curvature [N mm]
        axial_force = check["axial_stiffness_N"] * frame.axial_strain
        np.testing.assert_allclose(frame.axial_force, axial_force, rtol=1e-9, atol=1e-15)
        moment = check["bending_stiffness_N_mm2"] * frame.curvature
        np.testing.assert_allclose(frame.bending_moment, moment, rtol=1e-9, atol=1e-15)
        # the grip has moved the heads by strain times gauge length [mm]
        moved = (frame.positions - run.model.nodes)[run.model.node_sets["top_heads"], 1]
        np.testing.assert_allclose(moved, frame.strain * run.model.gauge_length, rtol=1e-9)
        energies = frame.stretch_energy + frame.bending_energy + frame.twist_energy
        self.assertAlmostEqual(energies.sum(), frame.row["internal_energy_mJ"], 12)

    def test_contacts_are_those_of_the_table(self):
        run = self.case.run(self.run_folder)
        contacts = run.frame().contacts
        with open(self.run_folder / "frames" / "contacts_0002.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertGreater(len(rows), 0)
        self.assertEqual(len(contacts), len(rows))
        for row, contact in zip(rows, contacts):
            for name in contacts.dtype.names:
                if name in row:
                    self.assertAlmostEqual(float(row[name]), contact[name], 12, name)
            for name, column in (
                ("position_mm", "{}_mm"),
                ("normal", "normal_{}"),
                ("friction_force_N", "friction_force_{}_N"),
            ):
                vector = [float(row[column.format(axis)]) for axis in "xyz"]
                self.assertEqual(vector, contact[name].tolist(), name)
            self.assertEqual(row["state"] == "slip", contact["slips"])
        normal_force = run.history["contact_normal_force_N"][-1]
        self.assertAlmostEqual(contacts["normal_force_N"].sum(), normal_force)

    def test_arrays_outlive_their_frame_and_run(self):
        run = self.case.run(self.run_folder)
        expected = run.frame().positions.copy()
        positions, history = run.frame().positions, knitmech.read_run(self.run_folder).history
        others = [run.frame(1) for _ in range(5)]  # which would take the memory, were it free
        gc.collect()
        np.testing.assert_array_equal(positions, expected)
        np.testing.assert_array_equal(history, run.history)
        self.assertEqual(len(others), 5)

    def narrow(self):
        """The case with a single wale and two frames, of which pictures are soon drawn."""
        self.case["fabric.wales"] = 1
        self.case["fabric.courses"] = 5
        self.case["output.frames_at"] = None  # the default ones come after the end
        return self.case

    def test_a_report(self):
        path = self.narrow().run(self.run_folder).report()
        self.assertEqual(path, self.run_folder / "report.html")
        self.assertIn("Monofilament jersey", path.read_text())
        # the next run does not keep the report of this one
        self.case.run(self.run_folder)
        self.assertFalse(path.exists())

    def test_pictures_where_they_are_asked_for(self):
        self.narrow().run(self.run_folder)
        self.assertFalse((self.run_folder / "pictures").exists())
        self.case.run(self.run_folder, pictures=True)
        for name in ("force-strain.svg", "frame_0001.png"):
            self.assertGreater((self.run_folder / "pictures" / name).stat().st_size, 0)

    def test_a_run_that_fails_says_why(self):
        self.case["test.speed"] = "10 m/s"
        self.case["test.ramp"] = "1 us"
        self.case["test.strain"] = 2
        run = self.case.run(self.run_folder)
        self.assertEqual(run.status, "failed")
        self.assertIn("A yarn went through another", run.reason)
        self.assertIn("a smaller test.speed", run.advice)

    def test_a_run_that_a_break_ends_says_so(self):
        self.case["yarn.strength"] = "1 mN"
        run = self.case.run(self.run_folder)
        self.assertEqual(run.status, "completed")
        self.assertIn("because a yarn broke", run.reason)

    def test_broken_elements_are_those_of_the_summary_and_have_no_force(self):
        self.case["yarn.strength"] = "1 mN"
        self.case["test.on_break"] = "go on"
        run = self.case.run(self.run_folder)
        broken = run.frame().broken
        middles = run.model.arc_length[run.model.elements[broken]].mean(axis=1)
        places = [each["place_mm"] for each in run.summary["breaks"]]
        self.assertGreater(len(places), 1)
        np.testing.assert_allclose(np.sort(middles), np.sort(places))
        np.testing.assert_array_equal(run.frame().axial_force[broken], 0)
        self.assertGreater(np.count_nonzero(run.frame().axial_force), 0)


class Refusals(FolderTest):
    def test_a_folder_that_is_none_of_a_run(self):
        with self.assertRaisesRegex(knitmech.InputError, "There is no folder"):
            knitmech.read_run(self.folder / "none")
        (self.folder / "notes.txt").write_text("mine")
        with self.assertRaises(knitmech.InputError):
            knitmech.read_run(self.folder)
        with self.assertRaisesRegex(knitmech.InputError, str(self.folder)):
            tiny_case().run(self.folder)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["notes.txt"])

    def test_a_case_with_mistakes_is_not_run(self):
        with self.assertRaises(knitmech.CaseError):
            knitmech.Case("").run(self.folder / "run")
        self.assertFalse((self.folder / "run").exists())

    def test_threads(self):
        with self.assertRaisesRegex(ValueError, "threads must be at least 1"):
            tiny_case().run(self.folder / "run", threads=0)

    def test_a_damaged_frame(self):
        run = tiny_case().run(self.folder / "run")
        path = run.folder / "frames" / "frame_0001.vtp"
        path.write_text(path.read_text()[:500])
        with self.assertRaisesRegex(knitmech.InputError, "frame_0001.vtp"):
            run.frame(1)
        path.unlink()
        with self.assertRaises(OSError):
            run.frame(1)


