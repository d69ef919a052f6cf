"""A run: the results of a simulation, in a run folder."""

from __future__ import annotations

import json
import os
import pathlib
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

from . import _core

if TYPE_CHECKING:
    import numpy

    from .case import Case

OnFrame = Optional[Callable[[_core.Frame], Optional[bool]]]


class StoredFrame(NamedTuple):
    """A frame that a run has stored."""

    index: int
    strain: float  #: [-]


class Run:
    """A run folder that is read; `knitmech.read_run()` and `Case.run()` give it.

    It shows the folder as it was when it was read. Frames stay on the disk until they are asked
    for.
    """

    def __init__(self, stored: _core.StoredRun, folder: pathlib.Path) -> None:
        self._stored = stored
        self._folder = folder

    @property
    def folder(self) -> pathlib.Path:
        return self._folder

    @property
    def status(self) -> str:
        """ "completed", "interrupted", "failed" or, of a run under way, "running"."""
        return self._stored.status

    @property
    def reason(self) -> str:
        """Why the run failed, or why it ended before its end, in one sentence; may be empty."""
        return self._stored.reason

    @property
    def advice(self) -> str:
        """What to try where the run failed; may be empty."""
        return self._stored.advice

    @property
    def summary(self) -> dict[str, Any]:
        """What summary.json says (docs/results.md), with the verdict in ["quality"]."""
        return json.loads(self._stored.summary)

    @property
    def history(self) -> numpy.ndarray:
        """The rows of history.csv: a structured array, columns by their names.

        run.history["force_top_N"] are the forces at the strains run.history["strain"].
        """
        return self._stored.history

    @property
    def frames(self) -> list[StoredFrame]:
        """The frames that are stored, in the order of time."""
        return [StoredFrame(*frame) for frame in self._stored.frames]

    def frame(self, index: int = -1) -> _core.Frame:
        """A stored frame; -1 is the last one. Raises IndexError if there is none."""
        return self._stored.frame(self.frames[index].index)

    def frame_at(self, strain: float) -> _core.Frame:
        """The stored frame whose strain is nearest to this one."""
        return self._stored.nearest_frame(strain)

    @property
    def model(self) -> _core.Model:
        """The fabric as it was knitted, before the test."""
        return self._stored.model

    @property
    def case(self) -> Case:
        """The case that was run, with all defaults filled in."""
        from .case import Case

        return Case.read(self._folder / "case.toml")

    def resume(
        self, *, on_frame: OnFrame = None, threads: Optional[int] = None, pictures: bool = False
    ) -> Run:
        """Goes on with a run that was interrupted or killed, to the same results to the last bit.

        The arguments are those of Case.run(). Raises InputError if the run cannot go on.
        """
        begun = (os.fspath(self._folder),)
        return run_case(_core.resume_run, begun, self._folder, on_frame, threads, pictures)

    def report(self) -> pathlib.Path:
        """Writes report.html, one page that needs no other file, and figures/; gives its path."""
        self._stored.write_report(0)
        return self._folder / "report.html"

    def __repr__(self) -> str:
        return f"<knitmech.Run {str(self._folder)!r}, {self.status}>"


def read_run(folder: Union[str, os.PathLike[str]]) -> Run:
    """Reads a run folder. Raises InputError if it is none or is damaged, FileError."""
    return Run(_core.read_run(os.fspath(folder)), pathlib.Path(folder))


def run_case(
    start: Callable[..., None],
    begun: tuple[str, ...],
    folder: Union[str, os.PathLike[str]],
    on_frame: OnFrame,
    threads: Optional[int],
    pictures: bool,
) -> Run:
    """Runs what `start` begins, and reads its folder."""
    if threads is not None and threads < 1:
        raise ValueError(f"threads must be at least 1, not {threads}")
    start(*begun, on_frame, threads, pictures)
    return read_run(folder)
