"""What can go wrong, and what is found in a program."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Finding:
    """An alarm, a warning or a note with its place in the program."""

    id: str
    """Name of the fault, the same in every language: ``radius_mismatch``."""
    severity: str
    """``alarm``, ``warning`` or ``note``."""
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
    """What was asked for cannot be done: no such control, a wrong set-up, …"""


class Alarm(Error):
    """The program was stopped by an alarm, as the control would have stopped it."""

    def __init__(self, finding: Finding) -> None:
        super().__init__(finding)
        self.finding = finding

    def __str__(self) -> str:
        return str(self.finding)

    @property
    def id(self) -> str:
        """Name of the fault: ``radius_mismatch``."""
        return self.finding.id

    @property
    def text(self) -> str:
        """What the operator would read."""
        return self.finding.text

    @property
    def hint(self) -> str:
        """What to do about it; may be empty."""
        return self.finding.hint

    @property
    def file(self) -> str:
        """The file that the line stands in."""
        return self.finding.file

    @property
    def line(self) -> int:
        """From 1; 0: at no place."""
        return self.finding.line

    @property
    def column(self) -> int:
        """In characters, from 1."""
        return self.finding.column


def alarm_of(fields: dict[str, Any]) -> Alarm:
    """From what the extension tells."""
    return Alarm(Finding(**fields))
