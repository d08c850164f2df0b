#!/usr/bin/env python3
"""Tests kadr diff: what is the same, what is not, where; and a mutation test against `kadr run --trace`, which does not use diff.

    run_diff.py --kadr PROGRAM [--mutations N]
"""
import json
import math
import random
import re
import signal
import subprocess
import sys
import tempfile

try:
    import numpy as np
except ImportError:
    sys.exit('run_diff.py needs numpy (python3-numpy): so many distances take a minute without it')

import harness

EXAMPLES = harness.ROOT / 'examples'
TOLERANCE = 0.001
MOST_PAIRS = 200_000  # pairs of points and lines whose distances are computed at once
tally = harness.Tally()
expect = tally.expect


BASE = 'G21 G90 G17\nS1000 M3\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX10\nY10\nG2 X0 Y10 I-5 J0\nG0 Z5\nM30\n'
# what is changed, status, what the output contains
CASES = [
    ('itself', [], 0, 'equal: 6 motions, greatest distance 0.0000 mm'),
    ('a line in two', [('X10\n', 'X4\nX10\n')], 0, 'equal'),
    ('comments, numbers, order of words', [('X10\n', 'N7 (side) X10 F100\n')], 0, 'equal'),
    ('the arc by its radius', [('I-5 J0', 'R5')], 0, 'equal'),
    ('another way', [('Y10\nG2', 'X10.5 Y5\nX10 Y10\nG2')], 1, 'a.nc:6 | b.nc:6-7: another way, up to 0.5 mm apart\n  < Y10\n  > X10.5 Y5\n1 differences, up to 0.5 mm apart'),
    ('a feed', [('Y10\nG2', 'Y10 F150\nG2')], 1, 'feed: F100 mm/min — F150 mm/min'),
    ('rapid for feed', [('G1 Z-1 F100\n', 'G0 Z-1\nG1 F100\n')], 1, 'kind of motion: feed — rapid'),
    ('spindle', [('S1000', 'S1200')], 1, 'spindle: S1000 M3 — S1200 M3'),
    ('the other way round', [('M3', 'M4')], 1, 'spindle: S1000 M3 — S1000 M4'),
    ('coolant', [('M3', 'M3 M8')], 1, 'coolant: M9 — M8'),
    ('a dwell more', [('X10\n', 'X10\nG4 P1.5\n')], 1, 'what is done between: nothing — G4 1.5 s'),
    ('a stop more', [('Y10\n', 'Y10\nM0\n')], 1, 'what is done between: nothing — M0'),
    ('another tool', [('S1000', 'T2 M6 S1000')], 1, 'M6 T2'),
    ('an alarm', [('I-5 J0', 'I-5 J1')], 1, 'another way, up to'),
    ('an alarm that stops it', [('X10\n', 'X10 X12\n')], 1, 'alarm rs274_form: Multiple x words'),
    ('far off', [('X0 Y0 Z5', 'X400 Y0 Z5')], 1, 'mm apart'),
]


def cases(kadr):
    folder = kadr.folder
    (folder / 'a.nc').write_text(BASE)
    for name, changes, status, holds in CASES:
        text = BASE
        for before, after in changes:
            assert before in text, name
            text = text.replace(before, after, 1)
        (folder / 'b.nc').write_text(text)
        got = kadr.call('diff', 'a.nc', 'b.nc', '--control', 'linuxcnc', '--lang', 'en')
        expect(got.returncode == status and holds in got.stdout + got.stderr, f'{name}: {got.returncode} {got.stdout}{got.stderr}')
    got = kadr.call('diff', 'a.nc', 'b.nc', '--control', 'linuxcnc', '--lang', 'ru')
    expect('расходятся' in got.stdout, 'Russian')
    (folder / 'b.nc').write_text(BASE.replace('X10\n', 'X10.004\n'))
    expect(kadr.call('diff', 'a.nc', 'b.nc', '--control', 'linuxcnc', '--tolerance', '0.01').returncode == 0, '--tolerance')
    (folder / 'b.nc').write_text(BASE.replace('M30', 'M02'))
    got = kadr.call('diff', 'a.nc', 'b.nc', '--control-a', 'linuxcnc', '--control-b', 'mach3', '--lang', 'en')
    expect(got.returncode == 0 and 'equal' in got.stdout, f'two controls: {got.stdout}{got.stderr}')
    for wrong in (['a.nc'], ['a.nc', 'none.nc'], ['a.nc', 'a.nc', '--tolerance', '0'], ['-', '-'], ['a.nc', '/dev']):
        got = kadr.call('diff', *wrong, '--control', 'linuxcnc')
        expect(got.returncode == 2 and got.stderr, f'wrong usage {wrong}: {got.returncode}')
    (folder / 'empty.nc').write_text('')
    expect(kadr.call('diff', 'empty.nc', 'a.nc', '--control', 'linuxcnc').returncode == 1, 'an empty file')
    many = BASE.replace('Y10\nG2', ''.join(f'Y{i} F{100 + i}\n' for i in range(1, 60)) + 'Y10\nG2')
    (folder / 'b.nc').write_text(many)
    (folder / 'c.nc').write_text(re.sub(r'F(1\d\d)', lambda m: f'F{int(m[1]) + 1}', many))
    short, long = (kadr.call('diff', 'b.nc', 'c.nc', '--control', 'linuxcnc', '--lang', 'en', *o).stdout for o in ([], ['--all']))
    expect(short.count('feed:') == 20 and 'more: --all' in short and long.count('feed:') > 50, 'the first twenty, or all')
    (folder / 'endless.nc').write_text('G21 G90 F1000\no100 while [1]\nG1 X1\nX0\no100 endwhile\nM2\n')
    process = kadr.start('diff', 'endless.nc', 'endless.nc', '--control', 'linuxcnc', '--max-blocks', '1000000000000', stdout=subprocess.DEVNULL,
                         stderr=subprocess.DEVNULL)
    begun = harness.at_work(process)
    took = harness.spent_after(process, signal.SIGINT)
    expect(begun and process.returncode == 130 and took < 1, f'Ctrl-C: status {process.returncode}, {took:.2f} s of work behind it')


def programs():
    """Yields (file, control, other options) of examples that run to their end."""
    for control in ('mach3', 'linuxcnc', 'nct', 's2c42', 'gost', 'correctors', 'fanuc', 'haas', 'grbl'):
        for file in sorted((EXAMPLES / control).glob('*')):
            if file.suffix not in ('.json', '.toml', '.md', '.tbl', '.txt'):
                setup = file.with_suffix('.json')
                yield file, control, (['--setup', setup] if setup.exists() else [])


def actions_of(kadr, file, control, options):
    got = kadr.call('run', file, '--control', control, '--trace', '-', '--quiet', *options)
    if got.returncode != 0:
        return None
    return [json.loads(line) for line in got.stdout.splitlines()]


LOOKED_AT = {'do', 'machine', 'feed', 'unit', 'center', 'turns', 'rpm', 'dir', 'tool', 'seconds', 'what', 'text', 'code'}
NOT_DONE = {'tool', 'frame', 'end'}  # a tool call without a change; the frame of the next block; the final state


def kept(actions):
    """Returns the part of the actions that a comparison looks at: without the location in the text."""
    return [{k: v for k, v in a.items() if k in LOOKED_AT} for a in actions if a['do'] not in NOT_DONE]


def mutate(text, random_):
    """Changes one number of the text by more than the tolerance."""
    numbers = [m for m in re.finditer(r'(?<=[XYZF])-?\d+(\.\d+)?', text)]
    if not numbers:
        return None
    m = random_.choice(numbers)
    value = float(m[0]) + random_.choice((-1, 1)) * random_.choice((0.02, 0.5, 3))
    return text[:m.start()] + (f'{value:.3f}' if '.' in m[0] else f'{round(value + random_.choice((-20, 20)))}') + text[m.end():]


def places(actions):
    """Returns the points of the paths in a trace, in machine coordinates, and the actions between them."""
    points, doings, at = [], [], None
    for action in kept(actions):
        if 'machine' not in action:
            doings.append(action)
            continue
        full = action['machine']
        to = tuple(full.get(a, 0.0) for a in 'XYZ')
        row = next(r for r in actions if r.get('machine') is full)
        if at is not None and action['do'].startswith('arc'):
            first, second = row['plane']
            shift = {a: full[a] - row['to'][a] for a in 'XYZ'}
            names = 'XYZ'
            centre = (row['center'][first] + shift[first], row['center'][second] + shift[second])
            begin = math.atan2(at[names.index(second)] - centre[1], at[names.index(first)] - centre[0])
            radius = math.hypot(at[names.index(second)] - centre[1], at[names.index(first)] - centre[0])
            sweep = row['turns'] * 2 * math.pi * (1 if action['do'] == 'arc_ccw' else -1)
            for k in range(1, 100):
                p = [a + (b - a) * k / 100 for a, b in zip(at, to)]
                p[names.index(first)] = centre[0] + radius * math.cos(begin + sweep * k / 100)
                p[names.index(second)] = centre[1] + radius * math.sin(begin + sweep * k / 100)
                points.append(tuple(p))
        points.append(to)
        doings.append((action['do'], action.get('feed'), action.get('unit')))
        at = to
    return points, doings


def farthest(points, way):
    """Returns the distance in mm of the farthest point from the segments of the path."""
    points, way = np.array(points, dtype=float), np.array(way, dtype=float)
    begins, along = (way[:-1], np.diff(way, axis=0)) if len(way) > 1 else (way, np.zeros_like(way))
    squares = (along * along).sum(1)
    most = 0.0
    for some in np.array_split(points, 1 + len(points) * len(begins) // MOST_PAIRS):
        to = some[:, None, :] - begins
        part = np.clip((to * along).sum(2) / np.where(squares == 0, 1, squares), 0, 1)
        off = to - part[:, :, None] * along
        most = max(most, float(np.sqrt((off * off).sum(2).min(1)).max(initial=0)))
    return most


def is_the_same_way(before, after):
    """An arc that continues tangentially may end anywhere: a slow check that nothing has moved."""
    (points, doings), (other, others) = places(before), places(after)
    return doings == others and farthest(points, other) < 2 * TOLERANCE and farthest(other, points) < 2 * TOLERANCE


def mutations(kadr, count):
    folder = kadr.folder
    random_ = random.Random(20261125)
    found = missed = same = 0
    all_of_them = [(f, c, o, actions_of(kadr, f, c, o)) for f, c, o in programs()]
    usable = [p for p in all_of_them if p[3] is not None]
    expect(len(usable) > 20, f'examples that run: {len(usable)}')
    for file, control, options, _ in usable:
        got = kadr.call('diff', file, file, '--control', control, *options)
        expect(got.returncode == 0, f'{file.name} and itself: {got.stdout[-300:]}{got.stderr[-300:]}')
    while found + missed + same < count:
        file, control, options, before = random_.choice(usable)
        try:
            text = mutate(file.read_text(), random_)
        except UnicodeDecodeError:
            continue
        if text is None:
            continue
        other = folder / f'mutant{file.suffix}'
        other.write_text(text)
        after = actions_of(kadr, other, control, options)
        if after is None:
            continue
        got = kadr.call('diff', file, other, '--control', control, *options)
        moved = kept(before) != kept(after)
        if not moved:
            same += 1
            expect(got.returncode == 0, f'{file.name}: the same trace, yet {got.stdout[-300:]}')
        elif got.returncode == 1:
            found += 1
        elif is_the_same_way(before, after):
            same += 1
        else:
            missed += 1
            (folder / f'missed{missed}').write_text(text)
            print(f'not found: {file} {control}\n{"".join(line for line in set(text.splitlines(True)) - set(file.read_text().splitlines(True)))}')
    print(f'mutations: {found} found, {missed} not found, {same} without effect')
    return missed


def main():
    options = harness.arguments(__doc__)
    options.add_argument('--mutations', type=int, default=100)
    args = harness.parsed(options)
    with tempfile.TemporaryDirectory() as folder, harness.Kadr(args.kadr, folder) as kadr:
        cases(kadr)
        expect(mutations(kadr, args.mutations) == 0, 'each change that moves anything is found')
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
