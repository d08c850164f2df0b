#!/usr/bin/env python3
"""Tests kadr convert where words must be rounded: chains of arcs and lines whose ends and centres have nine decimals, as CAM systems write
them for LinuxCNC, in mm and in inches, to every control. Each is proven, never refused because of the rounding. A separate reader here
reads the programs written for Fanuc: each arc is as close to the true one as a single rounding of its end and its centre allows, which
is the tolerance that docs/commands/convert.md names.

    convert_rounded.py --kadr PROGRAM [--programs N] [--seed N]
"""
import math
import random
import re
import tempfile
from pathlib import Path

import harness
from commands.programs import CONTROLS

HALF = 0.0005                                    # mm, half an increment
AROUND = math.hypot(3 * HALF, 3 * HALF) + 1e-6   # mm, in the plane: rounding of the start once, of the centre twice
INCH = 25.4
POINTS = 24   # points checked on each arc


class Chain:
    """Lines and arcs in XY, each from the end of the last one: (end, centre or None, counterclockwise)."""

    def __init__(self, chance):
        self.at, self.pieces = (0.0, 0.0), []
        for _ in range(chance.randint(60, 120)):
            if chance.random() < 0.25:
                self.line(chance)
            else:
                self.arc(chance)

    def line(self, chance):
        self.at = (self.at[0] + chance.uniform(-20, 20), self.at[1] + chance.uniform(-20, 20))
        self.pieces.append((self.at, None, False))

    def arc(self, chance):
        radius, begin = chance.choice((0.3, 0.635, 3, 17, 120)) * chance.uniform(0.8, 1.2), chance.uniform(0, 2 * math.pi)
        turn = chance.uniform(0.3, 5.9) * chance.choice((-1, 1))
        centre = (self.at[0] - radius * math.cos(begin), self.at[1] - radius * math.sin(begin))
        self.at = (centre[0] + radius * math.cos(begin + turn), centre[1] + radius * math.sin(begin + turn))
        self.pieces.append((self.at, centre, turn > 0))

    def program(self, unit):
        lines = ['G21' if unit == 1 else 'G20', 'G90 G17 G91.1', 'T1 M6', 'S1000 M3', 'G0 Z0.2 X0 Y0', f'G1 Z{-1 / unit:.9f} F{300 / unit:.4f}']
        before = (0.0, 0.0)
        for end, centre, ccw in self.pieces:
            words = f'X{end[0] / unit:.9f} Y{end[1] / unit:.9f}'
            if centre is None:
                lines.append(f'G1 {words}')
            else:
                lines.append(f'G{3 if ccw else 2} {words} I{(centre[0] - before[0]) / unit:.9f} J{(centre[1] - before[1]) / unit:.9f}')
            before = end
        return '\n'.join([*lines, 'G0 Z5', 'M5', 'M2', ''])


def written_pieces(text):
    """Returns (start, end, centre or None, counterclockwise) of the feed motions in XY of a program in mm with arc centres relative to the
    start."""
    at, code, pieces = (0.0, 0.0), '', []
    for line in text.splitlines():
        words = re.findall(r'([A-Z])(-?\d*\.?\d+|-?\d+\.)', re.sub(r'\(.*?\)', '', line))
        code = next((f'G{int(v)}' for letter, v in words if letter == 'G' and v in ('0', '1', '2', '3', '00', '01', '02', '03')), code)
        value = {letter: float(v) for letter, v in words}
        if 'X' not in value and 'Y' not in value:
            continue
        end = (value.get('X', at[0]), value.get('Y', at[1]))
        if code in ('G1', 'G2', 'G3') and (code == 'G1' or 'I' in value or 'J' in value):
            centre = None if code == 'G1' else (at[0] + value.get('I', 0), at[1] + value.get('J', 0))
            pieces.append((at, end, centre, code == 'G3'))
        at = end
    return pieces


def points_of(begin, end, centre, ccw):
    radius, first, last = math.dist(begin, centre), math.atan2(begin[1] - centre[1], begin[0] - centre[0]), math.atan2(end[1] - centre[1], end[0] - centre[0])
    turn = (last - first) % (2 * math.pi) if ccw else -((first - last) % (2 * math.pi))
    return [(centre[0] + radius * math.cos(first + turn * k / POINTS), centre[1] + radius * math.sin(first + turn * k / POINTS)) for k in range(POINTS)]


def farthest(chain, written):
    """Returns the distance in mm between the true and the written arcs, across the path; a complaint if the segments do not correspond."""
    if len(written) != len(chain.pieces):
        return f'{len(written)} motions, not {len(chain.pieces)}'
    most, before = 0.0, (0.0, 0.0)
    for (end, centre, ccw), (begin, to, middle, sense) in zip(chain.pieces, written):
        if (centre is None) != (middle is None) or (centre and ccw != sense):
            return 'another kind of motion'
        most = max(most, math.dist(end, to) - math.hypot(HALF, HALF) + AROUND)
        if centre:
            radius = math.dist(before, centre)
            most = max([most, *(abs(math.dist(point, centre) - radius) for point in points_of(begin, to, middle, sense))])
        before = end
    return most


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--programs', type=int, default=12)
    parser.add_argument('--seed', type=int, default=48)
    options = harness.parsed(parser)
    print(f'seed {options.seed}')
    chance, tally = random.Random(options.seed), harness.Tally()
    with tempfile.TemporaryDirectory(prefix='kadr-rounded-') as place:
        kadr = harness.Kadr(options.kadr, place)
        for n in range(options.programs):
            chain, unit = Chain(chance), (1, INCH)[n % 2]
            kadr.file('a.ngc', chain.program(unit))
            for to in CONTROLS:
                if to in ('linuxcnc', 'gost', 'correctors'):  # linuxcnc is the source itself; the others have hundredths, or feeds by code
                    continue
                for way in ('words', 'codes'):
                    out = kadr.folder / 'b.nc'
                    out.unlink(missing_ok=True)
                    done = kadr.call('convert', 'a.ngc', '--from', 'linuxcnc', '--to', to, '--out', out, '--lang', 'en', *(['--way', way] if way != 'words' else []))
                    tally.expect(done.returncode == 0, f'program {n} to {to} ({way}) is proven', done.stderr[-400:])
                    if to == 'fanuc' and way == 'codes' and done.returncode == 0:
                        off = farthest(chain, written_pieces(out.read_text()))
                        tally.expect(not isinstance(off, str) and off <= AROUND, f'program {n}: arcs as near as rounding leaves them', off)
    return tally.result()


if __name__ == '__main__':
    raise SystemExit(main())
