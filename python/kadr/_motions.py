"""Motions as rows; the fields are those of src/motion_rows.h."""
from __future__ import annotations

import struct
from enum import IntEnum
from typing import TYPE_CHECKING, Any, Iterator, NamedTuple

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt


class Kind(IntEnum):
    """The type of a motion."""

    RAPID = 0
    FEED = 1
    ARC_CW = 2
    ARC_CCW = 3
    PROBE = 4
    HOME = 5
    THREAD = 6


class Motion(NamedTuple):
    """One motion. Lengths in mm, angles in degrees, times in s, feed in mm/min; axis values are in the order of ``Session.axes``."""

    begins: float
    seconds: float
    length: float
    feed: float
    center: tuple[float, float]
    turns: float
    line: int
    block: int
    tool: int
    file: int
    kind: Kind
    channel: int
    start: tuple[float, ...]
    to: tuple[float, ...]
    machine_start: tuple[float, ...]
    machine_to: tuple[float, ...]


_HEAD = '7dIiIHBB'   # without padding: 72 bytes


def numpy_there() -> Any:
    """Returns numpy; raises an error that explains why it is needed if it is not installed."""
    try:
        import numpy
    except ModuleNotFoundError:  # any other import error is reported by numpy itself
        raise ImportError('arrays need numpy (Debian: python3-numpy); without it: Session.moves()') from None
    return numpy


def array_of(rows: bytearray, axes: int) -> npt.NDArray[np.void]:
    """Converts the rows to a structured array."""
    numpy = numpy_there()
    axis = ('f8', (axes,))
    fields = [('begins', 'f8'), ('seconds', 'f8'), ('length', 'f8'), ('feed', 'f8'), ('center', 'f8', (2,)), ('turns', 'f8'), ('line', 'u4'),
              ('block', 'i4'), ('tool', 'u4'), ('file', 'u2'), ('kind', 'u1'), ('channel', 'u1'), ('start', *axis), ('to', *axis),
              ('machine_start', *axis), ('machine_to', *axis)]
    return numpy.frombuffer(rows, dtype=numpy.dtype(fields))


def moves_of(rows: bytearray, axes: int) -> Iterator[Motion]:
    """Yields the motions one by one, without numpy."""
    for row in struct.iter_unpack(f'={_HEAD}{4 * axes}d', rows):
        begins, seconds, length, feed, x, y, turns, line, block, tool, file, kind, channel = row[:13]
        start, to, machine_start, machine_to = (tuple(row[13 + i * axes:13 + (i + 1) * axes]) for i in range(4))
        yield Motion(begins, seconds, length, feed, (x, y), turns, line, block, tool, file, Kind(kind), channel, start, to, machine_start, machine_to)
