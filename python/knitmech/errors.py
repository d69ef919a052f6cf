"""What knitmech raises; the sentences are those of the program."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple, Optional


class Mistake(NamedTuple):
    """A mistake in a case."""

    key: Optional[str]  #: "loop.height"; None where it belongs to no key
    line: Optional[int]  #: in the text of the case, counted from 1; None where it is in no line
    sentence: str  #: what is wrong and what would be right
    message: str  #: the same with the name of the case, line and key before it


class InputError(ValueError):
    """Wrong input: one sentence that says what is wrong, where, and what would be right."""


class CaseError(InputError):
    """Mistakes in a case; its text has a line for each of them."""

    def __init__(self, mistakes: Iterable[Mistake]) -> None:
        self.mistakes: list[Mistake] = list(mistakes)
        super().__init__(self.mistakes)

    def __str__(self) -> str:
        return "\n".join(mistake.message for mistake in self.mistakes)


class FileError(OSError):
    """A file that cannot be read or written."""
