"""A callback hears of each frame, and may end the run."""

import gc
import signal
import threading
import unittest
import weakref

import numpy as np
from support import FolderTest, tiny_case

import knitmech


def long_case() -> knitmech.Case:
    """A case that runs for minutes unless it is stopped, with a frame at once."""
    case = knitmech.Case.new()
    case["fabric.elements_per_erc"] = 30
    case["solver.mass_scaling"] = 1
    case["output.frames_at"] = [1e-12]
    return case


class Callback(FolderTest):
    def setUp(self):
        super().setUp()
        self.run_folder = self.folder / "run"

    def test_it_gets_each_frame_that_is_stored(self):
        frames = []
        run = tiny_case().run(self.run_folder, on_frame=frames.append)
        self.assertEqual([(each.index, each.strain) for each in frames], run.frames)
        for live in frames:
            stored = run.frame(live.index)
            for name in ("positions", "rotations", "axial_force", "contact_force", "torque"):
                ours, theirs = getattr(live, name), getattr(stored, name)
                np.testing.assert_array_equal(ours, theirs, name)
            self.assertEqual(live.row, stored.row)
            self.assertEqual(len(live.contacts), len(stored.contacts))

    def test_frames_may_be_kept_when_the_run_is_gone(self):
        kept = []
        tiny_case().run(self.run_folder, on_frame=lambda frame: kept.append(frame.positions))
        gc.collect()
        self.assertEqual([array.shape for array in kept], [(122, 3)] * 3)
        self.assertGreater(np.abs(kept[2] - kept[0]).max(), 0.2)  # 2 % of 12 mm

    def test_false_ends_the_run_which_can_be_gone_on_with(self):
        case = tiny_case()
        whole = case.run(self.folder / "whole")
        heard = []

        def stop_at_the_second(frame):
            heard.append(frame.index)
            return frame.index < 1

        run = case.run(self.run_folder, on_frame=stop_at_the_second)
        self.assertEqual(heard, [0, 1])
        self.assertEqual(run.status, "interrupted")
        self.assertLess(run.history["strain"][-1], 0.02)
        resumed = run.resume()
        self.assertEqual(resumed.status, "completed")
        np.testing.assert_array_equal(resumed.history, whole.history)
        with self.assertRaises(knitmech.InputError):
            resumed.resume()

    def test_nothing_and_other_answers_let_it_go_on(self):
        for answer in (None, True, 0, ""):
            run = tiny_case().run(self.run_folder, on_frame=lambda frame: answer)
            self.assertEqual(run.status, "completed")

    def test_what_it_raises_ends_the_run_and_is_raised(self):
        class Mine(Exception):
            pass

        heard = []

        def raise_mine(frame):
            heard.append(frame.index)
            raise Mine("enough")

        with self.assertRaisesRegex(Mine, "enough"):
            long_case().run(self.run_folder, on_frame=raise_mine)
        self.assertEqual(heard, [0])
        self.assertEqual(knitmech.read_run(self.run_folder).status, "interrupted")
        # the folder is free again
        self.assertEqual(tiny_case().run(self.run_folder).status, "completed")

    def test_it_is_let_go_of_when_the_run_has_ended(self):
        class Listener:
            def hear(self, frame):
                pass

        listener = Listener()
        gone = weakref.ref(listener)
        tiny_case().run(self.run_folder, on_frame=listener.hear)
        del listener
        gc.collect()
        self.assertIsNone(gone())

    def test_ctrl_c_ends_the_run(self):
        def press_ctrl_c(frame):
            # comes while the solver runs, outside of Python
            if frame.index == 0:
                threading.Timer(0.3, signal.raise_signal, [signal.SIGINT]).start()

        with self.assertRaises(KeyboardInterrupt):
            long_case().run(self.run_folder, on_frame=press_ctrl_c)
        self.assertEqual(knitmech.read_run(self.run_folder).status, "interrupted")

    def test_other_threads_of_python_run_while_it_is_solved(self):
        # The run goes on until another thread has ticked: it would never end if that could not run.
        begun, ticked = threading.Event(), threading.Event()

        def tick():
            begun.wait()
            for _ in range(1000):
                ticked.count = getattr(ticked, "count", 0) + 1
            ticked.set()
            signal.raise_signal(signal.SIGINT)

        thread = threading.Thread(target=tick)
        thread.start()
        with self.assertRaises(KeyboardInterrupt):
            long_case().run(self.run_folder, on_frame=lambda frame: begun.set())
        thread.join()
        self.assertEqual(ticked.count, 1000)

    def test_two_runs_side_by_side(self):
        runs = {}

        def run(name):
            runs[name] = tiny_case().run(self.folder / name)

        threads = [threading.Thread(target=run, args=[name]) for name in ("a", "b")]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        np.testing.assert_array_equal(runs["a"].history, runs["b"].history)


class InTheCallback(FolderTest):
    def test_a_run_may_be_read_while_it_is_under_way(self):
        seen = []

        def look(frame):
            if frame.index == 2:
                seen.append(knitmech.read_run(self.folder / "run").status)

        tiny_case().run(self.folder / "run", on_frame=look)
        self.assertEqual(seen, ["running"])
