"""Session: a program that is being run."""
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
    """A block and its location in the program."""

    file: str
    line: int
    block: Optional[int]
    """Its number, N…; None: it has none."""
    depth: int
    """Calls of subprograms around it."""


class PlannedTime(NamedTuple):
    """Seconds computed by the minimum-time planner, by what they are spent on."""

    cutting: float
    rapid: float
    dwell: float
    tool_change: float

    @property
    def total(self) -> float:
        """The sum of all parts."""
        return self.cutting + self.rapid + self.dwell + self.tool_change


class Snapshot:
    """Everything that decides how a session continues. It is a value: it can be restored any number of times."""

    def __init__(self, kept: _kadr.Kept) -> None:
        self._kept = kept


class Picture(str):
    """A picture as SVG text; a notebook displays it."""

    def _repr_svg_(self) -> str:
        return str(self)

    def save(self, file: str | os.PathLike[str]) -> None:
        """Writes the picture to a file."""
        with open(file, 'w', encoding='utf-8') as to:
            to.write(self)


def _program(program: Program) -> tuple[bytes, Optional[bytes]]:
    """Returns the file name and, if the program was given as text, the text."""
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
    """Returns the file name, or the text of the set-up."""
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
    """A program that is run as one particular control would run it.

    program
        the path of a file; or text: ``bytes``, or a ``str`` of more than one line
    control
        id of a control (``kadr.controls()``), or a file that ends with ``.toml``; None: guessed from the text of the program
    machine
        id of a machine (``kadr.machines()``), or a file that ends with ``.toml``
    setup
        the state before the start (docs/setup.md): a dict, or the path of a JSON file
    lang
        ``en`` or ``ru``: the language of alarm texts
    max_motions
        the most motions that a session keeps; a program with more raises ``Error``

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

    # ---- running

    def run(self) -> Session:
        """Runs to the end of the program. Raises the ``Alarm`` that stops the program; otherwise returns the session itself."""
        self._run.run()
        return self

    def step(self) -> Optional[Block]:
        """Executes the next block and stops before the one after it. Returns the executed block, or None at the end of the program."""
        place = self._run.step()
        return None if place is None else Block(*place)

    def __iter__(self) -> Iterator[Block]:
        """Runs block by block: ``for block in session: …``"""
        while (block := self.step()) is not None:
            yield block

    def snapshot(self) -> Snapshot:
        """Saves everything that decides how the session continues."""
        return Snapshot(self._run.snapshot())

    def restore(self, snapshot: Snapshot) -> None:
        """Continues from a snapshot as if the session had just reached it. The snapshot may come from a ``fork()``."""
        self._run.restore(snapshot._kept)

    def fork(self) -> Session:
        """Returns another session of the same program, control, machine and set-up, in the same state as this one."""
        other = object.__new__(Session)
        other._spec, other._most = self._spec, self._most
        other._run = _kadr.Run(self._spec, self._most)
        other._run.restore(self._run.snapshot())
        return other

    # ---- results so far

    def motions(self) -> npt.NDArray[np.void]:
        """The motions so far as a numpy structured array, one row each.

        Fields: begins, seconds (s, by programmed feeds), length (mm), feed (mm/min; 0: rapid), center and turns (of an arc), line, block
        (-1: no number), tool, file (index into ``files``), kind (``Kind``), channel; start, to (work coordinates), machine_start,
        machine_to: one value per axis, in the order of ``axes``, in mm or degrees.
        """
        return array_of(self._run.rows(), len(self.axes))

    def moves(self) -> Iterator[Motion]:
        """Yields the same motions one by one, without numpy."""
        return moves_of(self._run.rows(), len(self.axes))

    def evaluate(self, expression: str) -> float:
        """Returns the current value of an expression in the syntax of the program: ``#100 + 1``, ``R2``."""
        return self._run.evaluate(expression)

    @property
    def state(self) -> str:
        """``running``, ``stopped`` (by an alarm) or ``ended``."""
        return self._run.state

    @property
    def next(self) -> Optional[Block]:
        """The block that ``step()`` executes next."""
        place = self._run.next
        return None if place is None else Block(*place)

    @property
    def axes(self) -> list[str]:
        """Names of the axes."""
        return self._run.axes

    @property
    def position(self) -> dict[str, float]:
        """Position of the tool, in work coordinates."""
        return self._run.position(machine=False)

    @property
    def machine_position(self) -> dict[str, float]:
        """Positions of the axes, in machine coordinates."""
        return self._run.position(machine=True)

    @property
    def seconds(self) -> float:
        """Virtual time so far, in s, by programmed feeds and rapid rates."""
        return self._run.seconds

    @property
    def variables(self) -> dict[str, float]:
        """All variables that have a value: ``#100``, ``R2``."""
        return self._run.variables()

    @property
    def modal(self) -> list[str]:
        """The modal codes in force."""
        return self._run.modal()

    @property
    def warnings(self) -> list[Finding]:
        """The warnings so far; at most the first thousand."""
        return [Finding(**fields) for fields in self._run.warnings()]

    @property
    def files(self) -> list[str]:
        """The program's file and the files it has called so far; ``file`` of a motion is an index into this list."""
        return self._run.files()

    @property
    def control(self) -> str:
        """Id of the control, guessed or given."""
        return self._spec.control

    @property
    def machine(self) -> str:
        """Id of the machine."""
        return self._spec.machine

    # ---- whole program: each of these runs the program separately; the state of this session does not change

    def check(self) -> list[Finding]:
        """Returns every fault of the program, each once; the check continues after each fault. Empty if there is none."""
        return [Finding(**fields) for fields in self._spec.check()]

    def plot(self) -> Picture:
        """Draws the path as SVG; if an alarm stops the program, the path ends there."""
        return Picture(self._spec.picture('.svg').decode())

    def png(self) -> bytes:
        """Draws the path as PNG; needs libcairo."""
        return self._spec.picture('.png')

    def _repr_svg_(self) -> str:
        return self.plot()

    def samples(self, rate: float = 1000, max_seconds: float = 3600) -> npt.NDArray[np.void]:
        """Samples the axes along the minimum-time motion within the machine's limits (docs/planner.md), ``rate`` times a second.

        Returns a numpy structured array with the fields t (s) and each axis (machine coordinates). A motion longer than ``max_seconds``
        raises an ``Alarm``."""
        if not 1 <= rate <= 100_000:
            raise ValueError('rate: 1 … 100000 Hz')
        if not max_seconds > 0:
            raise ValueError('max_seconds: above 0')
        numpy = numpy_there()
        axes, rows, _ = self._spec.axes_in_time(rate, max_seconds)
        return numpy.frombuffer(rows, dtype=numpy.dtype([(name, 'f8') for name in ['t', *axes]]))

    def planned(self) -> PlannedTime:
        """Returns the duration of the program by the minimum-time planner."""
        return PlannedTime(**self._spec.axes_in_time(0, 0)[2])

    def __repr__(self) -> str:
        return f'<kadr.Session {self.control} on {self.machine}, {self.state}, {self._run.motions} motions>'
