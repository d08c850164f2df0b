#!/usr/bin/env python3
"""Tests kadr convert from and to a control whose blocks have names (sinumerik): each conversion is proven, and `kadr diff` finds it equal again.

    convert_named.py --kadr PROGRAM [--jobs N]
"""
import argparse
import sys
import tempfile
from pathlib import Path

from conversions import pairs
from page_client.client import expect, result

NAMED = 'sinumerik'
# Loops, subprograms, frames and variables are expanded; every control can express what is left.
FROM = ('plate_outline.mpf', 'grille.mpf', 'star_cam.mpf', 'slot_family.mpf')
TO = ('fanuc', 'linuxcnc', 's2c42', 'grbl')
INTO = ('fanuc/rounded_plate.nc', 'fanuc/flange_taps.nc', 'haas/pocket.nc', 'haas/face.nc', 'linuxcnc/outline.ngc', 'mach3/bolt_circle.tap',
        'nct/cam_plate.nct', 'gost/plate.nc')


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--kadr', required=True)
    parser.add_argument('--jobs', type=int, default=2)
    given = parser.parse_args()
    kadr = Path(given.kadr).resolve()
    jobs = [(NAMED, pairs.EXAMPLES / NAMED / name, to) for name in FROM for to in TO]
    jobs += [(name.split('/')[0], pairs.EXAMPLES / name, NAMED) for name in INTO]
    with tempfile.TemporaryDirectory() as folder:
        made = pairs.convert_all(kadr, [(control, file, pairs.setup_of(file), to) for control, file, to in jobs], Path(folder), given.jobs)
        for one in made:
            expect(one.proven(), f'{one.name()}: {one.outcome} {one.said[:300]}')
        for one in [one for one in made if one.proven()][::4]:
            got = pairs.diff(kadr, one)
            expect(got.returncode == 0, f'{one.name()}: {got.stdout[:300]}{got.stderr[:300]}')
        # Tapping with an oriented spindle has no code on the others: the conversion is refused, and says so.
        flange = pairs.EXAMPLES / NAMED / 'hole_flange.mpf'
        refused = pairs.convert(kadr, NAMED, flange, 'fanuc', Path(folder) / 'flange.nc', pairs.setup_of(flange))
        expect(refused.outcome == 'refused', f'{refused.name()}: {refused.outcome}')
    return result()


if __name__ == '__main__':
    sys.exit(main())
