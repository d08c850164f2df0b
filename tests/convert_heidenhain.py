#!/usr/bin/env python3
"""Tests kadr convert from and to conversational blocks (heidenhain): each conversion is proven, and `kadr diff` finds it equal again.

    convert_heidenhain.py --kadr PROGRAM [--jobs N]
"""
import argparse
import sys
import tempfile
from pathlib import Path

from conversions import pairs
from page_client.client import expect, result

KLARTEXT = 'heidenhain'
# Labels, cycles, parameters, approach and departure are expanded; every control can express what is left.
FROM = ('curved_slots.h', 'pump_cover.h')
TO = ('fanuc', 'linuxcnc', 'haas', 'sinumerik')
INTO = ('fanuc/rounded_plate.nc', 'haas/pocket.nc', 'haas/face.nc', 'linuxcnc/outline.ngc', 'mach3/bolt_circle.tap', 'nct/cam_plate.nct',
        'gost/plate.nc', 'sinumerik/star_cam.mpf')


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--kadr', required=True)
    parser.add_argument('--jobs', type=int, default=2)
    given = parser.parse_args()
    kadr = Path(given.kadr).resolve()
    jobs = [(KLARTEXT, pairs.EXAMPLES / KLARTEXT / name, to) for name in FROM for to in TO]
    jobs += [(name.split('/')[0], pairs.EXAMPLES / name, KLARTEXT) for name in INTO]
    with tempfile.TemporaryDirectory() as folder:
        made = pairs.convert_all(kadr, [(control, file, pairs.setup_of(file), to) for control, file, to in jobs], Path(folder), given.jobs)
        for one in made:
            expect(one.proven(), f'{one.name()}: {one.outcome} {one.said[:300]}')
        for one in [one for one in made if one.proven()][::3]:
            got = pairs.diff(kadr, one)
            expect(got.returncode == 0, f'{one.name()}: {got.stdout[:300]}{got.stderr[:300]}')
    return result()


if __name__ == '__main__':
    sys.exit(main())
