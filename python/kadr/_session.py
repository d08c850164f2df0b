"""Session: a program being run."""
from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, Iterator, Mapping, NamedTuple, Optional, Union

from . import _kadr
from ._errors import Error, Finding
from ._motions import Motion, array_of, moves_of, numpy_there

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

Program = Union[str, bytes, 'os.PathLike[str]']
"""A file; or the program's text: bytes, or a str of more than one line."""


class Block(NamedTuple):
    """A block by its place."""

    file: str
    line: int
    block: Optional[int]
    """Its number, N…; None: it has none."""
    depth: int
    """Calls of subprograms around it."""


class PlannedTime(NamedTuple):
    """Seconds by the planner of least time, by what they are spent on."""

    cutting: float
    rapid: float
    dwell: float
    tool_change: float

    @property
    def total(self) -> float:
        """All of them."""
        return self.cutting + self.rapid + self.dwell + self.tool_change


class Snapshot:
    """All that decides how a session goes on. A value: it may be restored as often as wanted."""

    def __init__(self, kept: _kadr.Kept) -> None:
        self._kept = kept


class Picture(str):
    """A picture as SVG text; a notebook shows it."""

    def _repr_svg_(self) -> str:
        return str(self)

    def save(self, file: str | os.PathLike[str]) -> None:
        """Writes it."""
        with open(file, 'w', encoding='utf-8') as to:
            to.write(self)


def _program(program: Program) -> tuple[bytes, Optional[bytes]]:
    """The file's name and the text, if it is one."""
    if isinstance(program, bytes):
        return b'<text>', program
    if isinstance(program, str):
        if '\n' in program:
            return b'<text>', program.encode()
        return os.fsencode(program), None
    if isinstance(program, os.PathLike):
        return os.fsencode(program), None
    raise TypeError(f'program: a path, a str or bytes, not {type(program).__name__}')


def _setup(setup: Union[Mapping[str, Any], str, os.PathLike[str], None]) -> tuple[bytes, str]:
    """The file's name, or the text."""
    if setup is None:
        return b'', ''
    if isinstance(setup, (str, os.PathLike)):
        if not os.fspath(setup):
            raise Error('setup: an empty name')
        return os.fsencode(setup), ''
    if isinstance(setup, Mapping):
        return b'', json.dumps(setup, allow_nan=False)
    raise TypeError(f'setup: a dict or a path, not {type(setup).__name__}')


class Session:
    """A program being run as one particular control would.

    program
        the path of a file; or text: ``bytes``, or a ``str`` of more than one line
    control
        id of a control (``kadr.controls()``), or a file that ends with ``.toml``; None: guessed by the program's text
    machine
        id of a machine (``kadr.machines()``), or a file that ends with ``.toml``
    setup
        the state before the start (docs/setup.md): a dict, or the path of a JSON file
    lang
        ``en`` or ``ru``: of the alarms' texts
    max_motions
        more than these a session does not keep: ``Error``

    >>> session = kadr.Session('part.nc', setup={'work_offsets': {'G54': {'X': 100}}})
    >>> session.run().motions()['to']
    """

    def __init__(self, program: Program, control: Optional[str] = None, machine: str = 'generic',
                 setup: Union[Mapping[str, Any], str, os.PathLike[str], None] = None, *, lang: str = 'en', max_motions: int = 5_000_000) -> None:
        if lang not in ('en', 'ru'):
            raise ValueError(f"lang: 'en' or 'ru', not {lang!r}")
        if max_motions < 0:
            raise ValueError('max_motions: not below 0')
        file, text = _program(program)
        setup_file, setup_json = _setup(setup)
        self._spec = _kadr.Spec(file=file, text=text, control=os.fspath(control or ''), machine=os.fspath(machine), setup_file=setup_file,
                                setup_json=setup_json, lang=lang)
        self._most = max_motions
        self._run = _kadr.Run(self._spec, max_motions)

    # ---- going on

    def run(self) -> Session:
        """Runs to the end of the program; raises the ``Alarm`` that stops it. Returns itself."""
        self._run.run()
        return self

    def step(self) -> Optional[Block]:
        """Carries the next block out and stands before the one after it. Returns the block; None: the program is at its end."""
        place = self._run.step()
        return None if place is None else Block(*place)

    def __iter__(self) -> Iterator[Block]:
        """Block by block: ``for block in session: …``"""
        while (block := self.step()) is not None:
            yield block

    def snapshot(self) -> Snapshot:
        """All that decides how it goes on."""
        return Snapshot(self._run.snapshot())

    def restore(self, snapshot: Snapshot) -> None:
        """Goes on from there, as if it had just come there. The snapshot may be of a ``fork()``."""
        self._run.restore(snapshot._kept)

    def fork(self) -> Session:
        """Another session of the same program, control, machine and set-up, that stands where this one stands."""
        other = object.__new__(Session)
        other._spec, other._most = self._spec, self._most
        other._run = _kadr.Run(self._spec, self._most)
        other._run.restore(self._run.snapshot())
        return other

    # ---- what is so far

    def motions(self) -> npt.NDArray[np.void]:
        """The motions so far as a numpy structured array, a row each.

        begins, seconds (s, by programmed feeds), length (mm), feed (mm/min, 0: rapid), center and turns (of an arc), line, block (-1: no
        number), tool, file (index into ``files``), kind (``Kind``), channel; start, to (work coordinates), machine_start, machine_to: a
        value of each axis, in the order of ``axes``, mm or degrees.
        """
        return array_of(self._run.rows(), len(self.axes))

    def moves(self) -> Iterator[Motion]:
        """The same one by one, without numpy."""
        return moves_of(self._run.rows(), len(self.axes))

    def evaluate(self, expression: str) -> float:
        """The value of an expression, written as the program would write it, now: ``#100 + 1``, ``R2``."""
        return self._run.evaluate(expression)

    @property
    def state(self) -> str:
        """``running``, ``stopped`` (by an alarm) or ``ended``."""
        return self._run.state

    @property
    def next(self) -> Optional[Block]:
        """The block before which it stands, after ``step()``."""
        place = self._run.next
        return None if place is None else Block(*place)

    @property
    def axes(self) -> list[str]:
        """Names of the axes."""
        return self._run.axes

    @property
    def position(self) -> dict[str, float]:
        """Where the tool stands, work coordinates."""
        return self._run.position(machine=False)

    @property
    def machine_position(self) -> dict[str, float]:
        """Where the axes stand, machine coordinates."""
        return self._run.position(machine=True)

    @property
    def seconds(self) -> float:
        """Virtual time so far, by programmed feeds and rapid rates."""
        return self._run.seconds

    @property
    def variables(self) -> dict[str, float]:
        """All that are set: ``#100``, ``R2``."""
        return self._run.variables()

    @property
    def modal(self) -> list[str]:
        """Codes in force."""
        return self._run.modal()

    @property
    def warnings(self) -> list[Finding]:
        """What was warned of so far, the first thousand."""
        return [Finding(**fields) for fields in self._run.warnings()]

    @property
    def files(self) -> list[str]:
        """The program's file and those that it called so far, by ``file`` of a motion."""
        return self._run.files()

    @property
    def control(self) -> str:
        """Id of the control, guessed or named."""
        return self._spec.control

    @property
    def machine(self) -> str:
        """Id of the machine."""
        return self._spec.machine

    # ---- of the whole program: by a way through it of their own; this session stays where it is

    def check(self) -> list[Finding]:
        """Every fault of the program, each once; it goes on after each. Empty: there is none."""
        return [Finding(**fields) for fields in self._spec.check()]

    def plot(self) -> Picture:
        """The path as SVG; where an alarm stops the program, up to there."""
        return Picture(self._spec.picture('.svg').decode())

    def png(self) -> bytes:
        """The same as PNG; needs libcairo."""
        return self._spec.picture('.png')

    def _repr_svg_(self) -> str:
        return self.plot()

    def samples(self, rate: float = 1000, max_seconds: float = 3600) -> npt.NDArray[np.void]:
        """The axes in the least time that the machine's limits allow (docs/planner.md), ``rate`` times a second: a numpy structured array
        with the fields t (s) and each axis (machine coordinates). A motion longer than ``max_seconds`` is an ``Alarm``."""
        if not 1 <= rate <= 100_000:
            raise ValueError('rate: 1 … 100000 Hz')
        if not max_seconds > 0:
            raise ValueError('max_seconds: above 0')
        numpy = numpy_there()
        axes, rows, _ = self._spec.axes_in_time(rate, max_seconds)
        return numpy.frombuffer(rows, dtype=numpy.dtype([(name, 'f8') for name in ['t', *axes]]))

    def planned(self) -> PlannedTime:
        """The time of the program by the planner of least time."""
        return PlannedTime(**self._spec.axes_in_time(0, 0)[2])

    def __repr__(self) -> str:
        return f'<kadr.Session {self.control} on {self.machine}, {self.state}, {self._run.motions} motions>'
