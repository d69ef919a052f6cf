"""A case: everything that a simulation is made from."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from numbers import Integral, Real
from typing import Any, Optional, Union

from . import _core
from .errors import CaseError
from .parameters import Value, find_parameter, parameters
from .run import Run, run_case

Path = Union[str, os.PathLike[str]]


class Case(Mapping[str, Value]):
    """The text of a case file, whose values are read and set by their keys.

    A case is a mapping of every key there is (`knitmech.parameters()`). What the text does not
    give has its default, "auto" where the program chooses it, or None. Setting a value changes
    that value in the text and nothing else: comments stay.
    """

    def __init__(self, text: str, name: str = "case") -> None:
        """A case of a text, which is not looked at yet. name: of the text, in messages."""
        self._text = text
        self._name = name

    @classmethod
    def new(cls) -> Case:
        """The case that `knitmech new` writes: the main example, every key with its meaning."""
        return cls(_core.case_template())

    @classmethod
    def read(cls, path: Path) -> Case:
        """A case from a file. Raises FileError if it cannot be read, CaseError if it is no text."""
        return cls(_core.case_file_text(os.fspath(path)), os.fspath(path))

    @property
    def text(self) -> str:
        """The text of the case file, with its comments."""
        return self._text

    @property
    def name(self) -> str:
        """Of the case in messages: the path that it was read from, or "case"."""
        return self._name

    def save(self, path: Path) -> None:
        """Writes the text to a file, in place of one that is there. Raises FileError."""
        _core.write_file(os.fspath(path), self._text)

    def copy(self) -> Case:
        """Another case with the same text."""
        return Case(self._text, self._name)

    def __getitem__(self, key: str) -> Value:
        _check_key(key)
        return _core.value_in(self._text, self._name, key)

    def __setitem__(self, key: str, value: Union[Value, Iterable[Any]]) -> None:
        """Puts a value into the text; None takes it out of force.

        Raises KeyError for a key that is none, CaseError for a value that is not allowed; the
        text then stays as it was. Whether the values fit each other is for check() to say.
        """
        _check_key(key)
        self._text = _core.with_value(self._text, self._name, key, _typed(value))

    def __iter__(self) -> Iterator[str]:
        return iter(parameters())

    def __len__(self) -> int:
        return len(parameters())

    def __contains__(self, key: object) -> bool:
        return isinstance(key, str) and find_parameter(key) is not None

    def given(self) -> list[str]:
        """The keys that the text gives, in its order."""
        return _core.given_keys(self._text, self._name)

    def __repr__(self) -> str:
        return f"<knitmech.Case {self._name!r}>"

    def check(self) -> dict[str, Any]:
        """What is known of the case before it is run; nothing is simulated.

        The words are those of `knitmech check --json`, with the unit in each: loop_length_mm,
        elements, bending_stiffness_N_mm2, least_out_of_plane_per_mm, mass_per_area_g_per_m2,
        estimated_seconds and more. Raises CaseError with all mistakes that can be told at once.
        """
        self._refuse_mistakes()
        return json.loads(_core.check_json(self._text, self._name))

    def model(self) -> _core.Model:
        """The nodes, elements and node sets of the fabric. Raises CaseError like check()."""
        self._refuse_mistakes()
        return _core.model_of(self._text, self._name)

    def run(
        self,
        folder: Path,
        *,
        on_frame: Optional[Callable[[_core.Frame], Optional[bool]]] = None,
        threads: Optional[int] = None,
        pictures: bool = False,
    ) -> Run:
        """Simulates the test and leaves a run folder (docs/results.md), as `knitmech run` does.

        folder: where to; that of an earlier run is replaced, one with other things in it refused.
        on_frame: called with each frame that is stored (output.frames_at, the start, the end);
            where it returns False, the run ends with status "interrupted". What it raises ends
            the run in the same way, and is raised here. So does Ctrl-C.
        threads: as many as serve the fabric unless told; the results are the same to the last bit.
        pictures: also draws each frame and the force-strain curve into folder/pictures.

        A simulation that cannot go on raises nothing: see Run.status and Run.reason. Raises
        CaseError like check(), InputError for a folder that is not taken, FileError.
        """
        self._refuse_mistakes()
        begun = (self._text, self._name, os.fspath(folder))
        return run_case(_core.run_case, begun, folder, on_frame, threads, pictures)

    def _refuse_mistakes(self) -> None:
        mistakes = _core.mistakes_in(self._text, self._name)
        if mistakes:
            raise CaseError(mistakes)


def _check_key(key: str) -> None:
    if find_parameter(key) is not None:
        return
    nearest = _core.nearest_key(key)
    advice = f"did you mean {nearest!r}?" if nearest else "knitmech.parameters() has all keys"
    raise KeyError(f"there is no parameter {key!r}; {advice}")


def _typed(value: Union[Value, Iterable[Any]]) -> str:
    """A value as a person types it into a field."""
    if value is None:
        return ""
    if isinstance(value, bool):
        raise TypeError("a value of a case is a text, a number or a list of these, not a bool")
    if isinstance(value, str):
        return value
    if isinstance(value, Integral):
        return str(int(value))
    if isinstance(value, Real):
        return repr(float(value))
    if isinstance(value, Iterable):
        return ", ".join(_typed(item) for item in value) or "[]"
    kind = type(value).__name__
    raise TypeError(f"a value of a case is a text, a number or a list of these, not a {kind}")
