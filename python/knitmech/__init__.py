"""Mechanics of knitted fabrics, yarn by yarn.

    import knitmech

    case = knitmech.Case.new()
    case["loop.height"] = "7 mm"
    print(case.check()["loop_length_mm"])
    run = case.run("results/jersey")
    print(run.history["strain"], run.history["force_top_N"])

The words are those of the case file and of the program `knitmech`; docs/python.md shows all of
it. Arrays are read-only: `array.copy()` is one to change.
"""

from ._core import Frame, Model, __version__
from .case import Case, Value
from .errors import CaseError, FileError, InputError, Mistake
from .export import ExportFormat, export, export_formats
from .parameters import Parameter, parameters
from .run import Run, StoredFrame, read_run

__all__ = [
    "Case",
    "CaseError",
    "ExportFormat",
    "FileError",
    "Frame",
    "InputError",
    "Mistake",
    "Model",
    "Parameter",
    "Run",
    "StoredFrame",
    "Value",
    "__version__",
    "export",
    "export_formats",
    "parameters",
    "read_run",
]
