"""The table of all parameters of a case."""

from __future__ import annotations

from typing import NamedTuple, Optional, Union

from . import _core

#: A value of a case: a number where the parameter is one, a text with its unit where it is a
#: quantity ("7 mm"), a word, "auto", a list; None where it is not given.
Value = Union[str, int, float, list[Union[str, int, float]], None]


class Parameter(NamedTuple):
    """One parameter of a case, as docs/input-reference.md tells it."""

    key: str  #: "loop.height": section, then name
    symbol: str  #: in formulas; may be empty
    help: str  #: what it is
    units: tuple[str, ...]  #: in which it may be written; empty for a number or a word
    need: str  #: "required", "defaulted", "automatic" or "optional"
    default: Value  #: what holds if it is not given: a value, "auto" or None
    example: Value
    least: Value  #: of a number; None for words
    least_excluded: bool  #: whether it must be greater than the least
    greatest: Value
    choices: tuple[str, ...]  #: of a word; empty for others


def parameters() -> dict[str, Parameter]:
    """All parameters by their keys, in the order of the case file."""
    return {entry["key"]: Parameter(**entry) for entry in _core.parameters()}


def find_parameter(key: str) -> Optional[Parameter]:
    """The parameter of a key, or None."""
    return _TABLE.get(key)


_TABLE = parameters()
