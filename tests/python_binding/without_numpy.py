"""Checks that only arrays need numpy."""
import sys

sys.modules['numpy'] = None   # simulates a missing numpy

from cases import PART, raises, run_all  # noqa: E402

import kadr                              # noqa: E402


def test_moves():
    moves = list(kadr.Session(PART, control='nct').run().moves())
    assert [move.to for move in moves] == [(0, 0, 0), (30, 0, 0), (30, 40, 0), (0, 0, 0), (20, 0, 0)]
    assert moves[-1].kind is kadr.Kind.ARC_CW and moves[-1].center == (10, 0) and moves[0].tool == 1


def test_arrays_say_what_is_missing():
    raises(ImportError, kadr.Session(PART, control='nct').motions, 'python3-numpy', 'moves()')
    raises(ImportError, kadr.Session(PART, control='nct').samples, 'python3-numpy')


run_all(globals())
