"""Kadr runs part programs of CNC controls, each as one particular control would run it.

>>> import kadr
>>> session = kadr.Session('part.nc', control='nct').run()
>>> session.motions()['to']
"""
from __future__ import annotations

from . import _kadr
from ._errors import Alarm, Error, Finding
from ._motions import Kind, Motion
from ._session import Block, Picture, PlannedTime, Session, Snapshot

__version__: str = _kadr.version
__all__ = ['Alarm', 'Block', 'Error', 'Finding', 'Kind', 'Motion', 'Picture', 'PlannedTime', 'Session', 'Snapshot', 'controls', 'machines']


def controls() -> list[str]:
    """Returns the ids of the built-in controls."""
    return _kadr.controls()


def machines() -> list[str]:
    """Returns the ids of the built-in machines."""
    return _kadr.machines()
