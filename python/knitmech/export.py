"""Models and shapes for other programs."""

from __future__ import annotations

import os
import pathlib
from typing import NamedTuple, Optional, Union

from . import _core
from .case import Case
from .run import Run


class ExportFormat(NamedTuple):
    """A format of `knitmech export`."""

    name: str  #: "abaqus"
    label: str  #: "Abaqus/Explicit input file"
    has_frames: bool  #: whether it is the shape of a frame, and no model with its test


def export_formats() -> dict[str, ExportFormat]:
    """All formats by their names."""
    return {entry[0]: ExportFormat(*entry) for entry in _core.export_formats()}


def export(
    source: Union[Case, Run],
    format: str,
    path: Union[str, os.PathLike[str]],
    *,
    frame: Optional[_core.Frame] = None,
    sides: int = 12,
) -> list[pathlib.Path]:
    """Writes a case or a run in a format of `knitmech export`; gives the files that it made.

    path: of the file; where the format makes several, each has its own ending in place of that.
    frame: of the run, whose shape is written; a shape is that of the last frame unless told.
    sides: of the polygon that stands for a round yarn, where the format has tubes.

    Raises InputError for a format that there is not, or that has no frames; CaseError; FileError.
    """
    file = os.fspath(path)
    if isinstance(source, Case):
        if frame is not None:
            raise TypeError("a case has no frames; give the run")
        paths = _core.export_case(source.text, source.name, format, file, sides)
    else:
        known = export_formats().get(format)
        if frame is None and known is not None and known.has_frames:
            frame = source.frame()
        paths = _core.export_run(source._stored, frame, format, file, sides)
    return [pathlib.Path(each) for each in paths]
