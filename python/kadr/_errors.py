"""The exceptions of this package, and the findings in a program that they carry."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Finding:
    """An alarm, a warning or a note, with its location in the program."""

    id: str
    """Name of the fault, the same in every language: ``radius_mismatch``."""
    severity: str
    """``alarm``, ``warning``, ``note`` or ``advice``."""
    text: str
    hint: str
    """What to do about it; may be empty."""
    file: str
    line: int
    """From 1; 0: at no place."""
    column: int
    """In characters, from 1."""
    end_column: int
    block: str
    """``N10``; empty: the block has no number."""
    number: str
    """The control's own number of the alarm; empty: none."""
    line_text: str = field(repr=False)
    calls: tuple[str, ...] = field(repr=False)
    """Calls of subprograms around it, the outermost first."""

    def __str__(self) -> str:
        place = f'{self.file}:{self.line}:{self.column}: ' if self.line else f'{self.file}: ' if self.file else ''
        return f'{place}{self.severity} {self.id}: {self.text}'


class Error(Exception):
    """A request that cannot be fulfilled: an unknown control, a wrong set-up, …"""


class Alarm(Error):
    """An alarm stopped the program, as it would have stopped on the control."""

    def __init__(self, finding: Finding) -> None:
        super().__init__(finding)
        self.finding = finding

    def __str__(self) -> str:
        return str(self.finding)

    @property
    def id(self) -> str:
        """Name of the fault, for example ``radius_mismatch``."""
        return self.finding.id

    @property
    def text(self) -> str:
        """The message that the operator would read."""
        return self.finding.text

    @property
    def hint(self) -> str:
        """Advice on how to correct the fault; may be empty."""
        return self.finding.hint

    @property
    def file(self) -> str:
        """The file that contains the line."""
        return self.finding.file

    @property
    def line(self) -> int:
        """Line number, from 1; 0 if the finding has no location."""
        return self.finding.line

    @property
    def column(self) -> int:
        """Column in characters, from 1."""
        return self.finding.column


def alarm_of(fields: dict[str, Any]) -> Alarm:
    """Creates an ``Alarm`` from the fields that the extension reports."""
    return Alarm(Finding(**fields))
