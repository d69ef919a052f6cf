"""A case in Python: the same words, texts and sentences as in the case file."""

import copy
import pickle
import unittest

import numpy as np
from support import SOURCE, FolderTest, program, program_json, tiny_case

import knitmech


class Values(unittest.TestCase):
    def test_a_new_case_is_what_the_program_writes(self):
        self.assertEqual(knitmech.Case.new().text, program("new"))

    def test_values_come_back_as_they_are_written(self):
        case = knitmech.Case.new()
        self.assertEqual(case["loop.height"], "7 mm")
        self.assertEqual(case["fabric.wales"], 9)
        self.assertIsInstance(case["fabric.wales"], int)
        self.assertEqual(case["contact.friction"], 0.1)
        self.assertEqual(case["title"], "Monofilament jersey, wale-wise tension")

    def test_what_is_not_given_has_its_default(self):
        case = knitmech.Case.new()
        self.assertNotIn("fabric.elements_per_erc", case.given())
        self.assertEqual(case["fabric.elements_per_erc"], 10)
        self.assertEqual(case["solver.mass_damping"], "0 /s")
        self.assertEqual(case["loop.out_of_plane"], "auto")
        self.assertIsNone(case["yarn.strength"])

    def test_only_the_value_changes_in_the_text(self):
        case = knitmech.Case('[loop]  # mine\nheight = "7 mm"   # measured on Monday\n')
        case["loop.height"] = "6.9 mm"
        self.assertEqual(case.text, '[loop]  # mine\nheight = "6.9 mm"   # measured on Monday\n')
        case["loop.width"] = "3.9 mm"
        self.assertEqual(
            case.text,
            '[loop]  # mine\nheight = "6.9 mm"   # measured on Monday\nwidth = "3.9 mm"\n',
        )

    def test_numbers_of_any_kind_are_written_with_all_their_digits(self):
        case = knitmech.Case.new()
        for number in (0.1 + 0.2, 1e-05, np.float64(1) / 3, np.int32(1), 0):
            case["contact.friction"] = number
            self.assertEqual(case["contact.friction"], number)

    def test_lists(self):
        case = knitmech.Case.new()
        case["output.frames_at"] = np.linspace(0, 0.2, 3)
        self.assertEqual(case["output.frames_at"], [0, 0.1, 0.2])
        with self.assertRaisesRegex(knitmech.CaseError, "is empty; give at least one number"):
            case["output.frames_at"] = []
        case["yarn.curve_forces"] = ["0 N", "0.9 N"]
        self.assertEqual(case["yarn.curve_forces"], ["0 N", "0.9 N"])

    def test_none_takes_a_value_out_of_force(self):
        case = knitmech.Case.new()
        case["solver.mass_scaling"] = 50
        case["solver.mass_scaling"] = None
        self.assertEqual(case["solver.mass_scaling"], "auto")
        self.assertNotIn("solver.mass_scaling", case.given())

    def test_it_is_a_mapping_of_all_keys(self):
        case = knitmech.Case.new()
        self.assertEqual(list(case.keys()), list(knitmech.parameters()))
        self.assertEqual(dict(case)["loop.width"], "3.9 mm")
        self.assertIn("loop.height", case)
        self.assertNotIn("loop.depth", case)
        self.assertEqual(case, case.copy())

    def test_a_copy_is_a_case_of_its_own(self):
        case = knitmech.Case.new()
        for other in (case.copy(), copy.copy(case), pickle.loads(pickle.dumps(case))):
            other["contact.friction"] = 0.3
            self.assertEqual((case["contact.friction"], other["contact.friction"]), (0.1, 0.3))


class Files(FolderTest):
    def test_what_is_saved_is_read_again(self):
        case = tiny_case()
        path = self.folder / "tiny.toml"
        case.save(path)
        self.assertEqual(path.read_text(), case.text)
        self.assertEqual(knitmech.Case.read(path).text, case.text)
        self.assertEqual(knitmech.Case.read(str(path)).name, str(path))

    def test_a_file_that_cannot_be_read_or_written(self):
        missing = self.folder / "none" / "x.toml"
        with self.assertRaisesRegex(knitmech.FileError, "there is no such file"):
            knitmech.Case.read(missing)
        with self.assertRaises(OSError):
            knitmech.Case.new().save(missing)

    def test_a_file_that_is_no_text(self):
        path = self.folder / "x.toml"
        path.write_bytes(b'title = "\xff"\n')
        with self.assertRaisesRegex(knitmech.CaseError, "x.toml: is not a text file in UTF-8"):
            knitmech.Case.read(path)


class Check(FolderTest):
    def test_it_says_what_the_program_says(self):
        for path in sorted((SOURCE / "cases").glob("*.toml")):
            check = knitmech.Case.read(path).check()
            self.assertEqual(check, program_json("check", "--json", path), path)

    def test_counts_and_stiffness_of_the_main_case(self):
        check = knitmech.Case.new().check()
        self.assertEqual(check["elements"], 2 * 10 * 9 * 15)
        self.assertEqual(check["nodes"], 2 * 10 * 9 * 15 + 15)
        # a solid circle of 0.12 mm: EI = E pi D^4 / 64
        self.assertAlmostEqual(check["bending_stiffness_N_mm2"], 1700 * np.pi * 0.12**4 / 64, 12)


class Mistakes(unittest.TestCase):
    def test_a_wrong_value_is_refused_where_it_is_set(self):
        case = knitmech.Case.new()
        before = case.text
        with self.assertRaises(knitmech.CaseError) as caught:
            case["loop.height"] = "7 N"
        (mistake,) = caught.exception.mistakes
        self.assertEqual(mistake.key, "loop.height")
        self.assertEqual(before.splitlines()[mistake.line - 1][:6], "height")
        self.assertTrue(mistake.sentence.startswith('"7 N" has the unit "N", which is for a force'))
        self.assertEqual(str(caught.exception), mistake.message)
        self.assertEqual(case.text, before)

    def test_a_quantity_needs_its_unit(self):
        with self.assertRaisesRegex(knitmech.CaseError, '"7" has no unit'):
            knitmech.Case.new()["loop.height"] = 7

    def test_ranges_words_and_what_must_be_given(self):
        case = knitmech.Case.new()
        for key, value, sentence in (
            ("contact.friction", -1, "must be at least 0 and at most 5, but is -1"),
            ("contact.friction", float("nan"), '"nan"'),
            ("fabric.structure", "knotted", 'is "knotted", but must be "basic"'),
            ("output.frames_at", ["a"], "has something else than a number at place 1"),
            ("loop.height", None, "must be given"),
        ):
            with self.subTest(key=key), self.assertRaises(knitmech.CaseError) as caught:
                case[key] = value
            self.assertIn(sentence, str(caught.exception))

    def test_values_that_no_case_has(self):
        for value in (True, object()):
            with self.assertRaisesRegex(TypeError, "a text, a number or a list of these"):
                knitmech.Case.new()["contact.friction"] = value

    def test_an_unknown_key(self):
        case = knitmech.Case.new()
        with self.assertRaisesRegex(KeyError, "did you mean 'loop.height'"):
            case["loop.heigth"] = "7 mm"
        with self.assertRaises(KeyError):
            case["nothing"]
        self.assertIsNone(case.get("nothing"))

    def test_a_check_tells_all_mistakes(self):
        text = knitmech.Case.new().text.replace('"7 mm"', '"7"').replace("wales = 9", "wales = 0")
        with self.assertRaises(knitmech.CaseError) as caught:
            knitmech.Case(text, "jersey.toml").check()
        keys = [mistake.key for mistake in caught.exception.mistakes]
        self.assertEqual(keys, ["loop.height", "fabric.wales"])
        lines = str(caught.exception).splitlines()
        self.assertEqual(len(lines), 2)
        number = text[: text.index("\nheight =")].count("\n") + 2
        self.assertTrue(lines[0].startswith(f"jersey.toml, line {number}: loop.height: "), lines[0])
        self.assertIsInstance(caught.exception, ValueError)
        again = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual(again.mistakes, caught.exception.mistakes)

    def test_a_geometry_that_cannot_be(self):
        case = knitmech.Case.new()
        case["fabric.course_spacing"] = "6.8 mm"
        for what in (case.check, case.model):
            with self.assertRaises(knitmech.CaseError) as caught:
                what()
            self.assertIn("The courses do not interlock", str(caught.exception))
            self.assertEqual(caught.exception.mistakes[0].key, "fabric.course_spacing")

    def test_a_text_that_is_no_toml(self):
        case = knitmech.Case("[loop\n")
        for what in (case.check, case.given, lambda: case["loop.height"]):
            with self.assertRaises(knitmech.CaseError) as caught:
                what()
            self.assertEqual(caught.exception.mistakes[0].line, 1)


class Parameters(unittest.TestCase):
    def test_the_table_is_that_of_the_program(self):
        printed = program("parameters").splitlines()
        keys = [line for line in printed if line and not line.startswith(" ")]
        for key, parameter in knitmech.parameters().items():
            self.assertIn(key, keys)
            self.assertTrue(any(parameter.help in line for line in printed), key)

    def test_ranges_and_defaults_are_written_as_values_are(self):
        table = knitmech.parameters()
        height = table["loop.height"]
        self.assertEqual((height.least, height.greatest), ("0 mm", "1000 mm"))
        self.assertTrue(height.least_excluded)
        self.assertEqual((height.need, height.units[0], height.symbol), ("required", "mm", "H"))
        self.assertEqual(table["contact.friction"].greatest, 5)
        self.assertEqual(table["fabric.structure"].choices, ("basic", "tied", "adjusted"))
        self.assertEqual(table["solver.mass_scaling"].default, "auto")
