#!/usr/bin/env python3
"""Tests how the programs of kadr mill plunge: by the trace of the program as its control runs it, judged here by geometry alone.

    tests/mill_plunge.py --kadr PROGRAM [--only SHAPE]

Runs every shape with every scheme, a small and a large tool, the controls in turn. A motion steeper than the ramp ends where no material
is left under the tool, or in a drilled hole that the summary lists; no lift returns where it started; the tool's edge keeps off the
walls.
"""
import bisect
import itertools
import json
import math
import re
import sys
import tempfile

import harness

SCHEMES = ['zigzag', '1zigzag', '2zigzag', 'spiral-out', 'spiral-in', 'comb', '1comb', '2comb']
CONTROLS = ['mach3', 's2c42', 'nct', 'correctors', 'gost']
INCREMENTS = {'gost': 0.01}  # mm, of the words; 0.001 for the others


def polygon(*corners):
    """A closed contour in the text format; a corner with a third member: the side that leads to it is open."""
    first, *rest = corners
    text = f'from {first[0]} {first[1]}\n'
    for corner in rest:
        text += f'line {corner[0]} {corner[1]}{" open" if len(corner) > 2 else ""}\n'
    return text + 'close\n'


def star(points, outer, inner):
    at = [((outer if i % 2 == 0 else inner), math.pi * i / points) for i in range(2 * points)]
    return polygon(*[(round(r * math.cos(a), 3), round(r * math.sin(a), 3)) for r, a in at])


# name: contour, tools, whether there is room for a ramp everywhere
SHAPES = {
    'rectangle': (polygon((0, 0), (60, 0), (60, 40), (0, 40)), (4, 16), True),
    'circle': ('circle 0 0 30\n', (8, 25), True),                    # issue 15: the first row of the comb is 0.06 mm long
    'small circle': ('circle 20 10 6\n', (3, 8), True),              # the centre has a disk of 2 mm: less than the tool's radius
    'slot': (polygon((0, 0), (60, 0), (60, 10.2), (0, 10.2)), (4, 10), True),
    'narrow slot, turned': (polygon((0, 0), (40, 30), (35.2, 36.4), (-4.8, 6.4)), (3, 7.9), True),
    'L': (polygon((0, 0), (60, 0), (60, 12), (12, 12), (12, 45), (0, 45)), (3, 10), True),
    'star': (star(5, 40, 18) + 'circle 0 0 4\n', (4, 9), True),
    'star without island': (star(7, 36, 14), (3, 8), True),
    'ring': ('circle 0 0 25\ncircle 0 0 12\n', (5, 12.6), True),
    'two pockets': ('circle 0 0 12\n' + polygon((30, 0), (50, 0), (40, 25)), (4, 9), True),
    'shelf': ('from 0 0\nline 90 0 open\nline 90 50 open\nline 20 50\narc 0 30 20 30 ccw\nclose\ncircle 55 28 8\n', (6, 16), True),
    'tool and 0.2': (polygon((0, 0), (10.2, 0), (10.2, 10.2), (0, 10.2)), (10,), False),
    'bore and 0.2': ('circle 0 0 5.1\n', (10,), False),
}


class Wall:
    """A line or an arc of a contour."""

    def __init__(self, a, b, centre=None, sweep=0.0, is_open=False):
        self.a, self.b, self.centre, self.sweep, self.open = a, b, centre, sweep, is_open

    def distance(self, p):
        if self.centre is None:
            return to_line(p, self.a, self.b)
        c = self.centre
        start = math.atan2(self.a[1] - c[1], self.a[0] - c[0])
        turn = (math.atan2(p[1] - c[1], p[0] - c[0]) - start) * (1 if self.sweep > 0 else -1) % (2 * math.pi)
        if turn <= abs(self.sweep):
            return abs(math.dist(p, c) - math.dist(self.a, c))
        return min(math.dist(p, self.a), math.dist(p, self.b))

    def corners(self):
        return chords(self.a, self.b, self.centre, self.sweep)


def to_line(p, a, b):
    vx, vy = b[0] - a[0], b[1] - a[1]
    size = vx * vx + vy * vy
    t = 0 if size == 0 else max(0.0, min(1.0, ((p[0] - a[0]) * vx + (p[1] - a[1]) * vy) / size))
    return math.hypot(p[0] - a[0] - t * vx, p[1] - a[1] - t * vy)


def chords(a, b, centre, sweep, sag=0.01):
    """Returns the points after `a` of a polyline along a line or arc."""
    if centre is None:
        return [b]
    radius = math.dist(a, centre)
    pieces = max(1, math.ceil(abs(sweep) / (2 * math.acos(1 - min(1, sag / max(radius, sag))))))
    start = math.atan2(a[1] - centre[1], a[0] - centre[0])
    at = [start + sweep * i / pieces for i in range(1, pieces)]
    return [(centre[0] + radius * math.cos(t), centre[1] + radius * math.sin(t)) for t in at] + [b]


def walls_of(text):
    """The loops of a drawing in the text format."""
    loops, start, at = [], None, None
    for words in (line.split() for line in text.splitlines()):
        n, is_open = [float(w) for w in words[1:] if re.match(r'^-?[\d.]', w)], words[-1] == 'open'
        if words[0] == 'circle':
            left, right = (n[0] - n[2], n[1]), (n[0] + n[2], n[1])
            loops.append([Wall(left, right, (n[0], n[1]), math.pi), Wall(right, left, (n[0], n[1]), math.pi)])
            continue
        if words[0] == 'from':
            loops.append([])
            start = at = (n[0], n[1])
            continue
        to, centre, sweep = start if words[0] == 'close' else (n[0], n[1]), None, 0.0
        if words[0] == 'arc':
            centre = (n[2], n[3])
            turn = math.atan2(to[1] - n[3], to[0] - n[2]) - math.atan2(at[1] - n[3], at[0] - n[2])
            sweep = turn % (2 * math.pi) if 'ccw' in words else -(-turn % (2 * math.pi))
        loops[-1].append(Wall(at, to, centre, sweep, is_open))
        at = to
    return loops


class Stock:
    """The material that is already cut: path segments with the highest level on each."""

    def __init__(self, loops, radius, everywhere=False):
        self.polygons = [[p for wall in loop for p in wall.corners()] for loop in loops]
        self.radius, self.everywhere, self.cut = radius, everywhere, []

    def holds(self, p):
        if self.everywhere:
            return True
        inside = False
        for corners in self.polygons:
            for (ax, ay), (bx, by) in zip(corners, corners[-1:] + corners[:-1]):
                if (ay > p[1]) != (by > p[1]) and p[0] < ax + (bx - ax) * (p[1] - ay) / (by - ay):
                    inside = not inside
        return inside

    def left_under(self, centre, level):
        """True if there is material above `level` under a tool at this position; slivers of a few hundredths do not count."""
        r = self.radius
        near = [(a, b) for a, b, z in self.cut if z <= level + 0.0015 and to_line(centre, a, b) < 2 * r]
        for share in (0, 0.4, 0.7, 0.96):
            for i in range(16 if share else 1):
                p = (centre[0] + share * r * math.cos(i * math.pi / 8), centre[1] + share * r * math.sin(i * math.pi / 8))
                if self.holds(p) and all(to_line(p, a, b) > r + 0.025 for a, b in near):
                    return True
        return False


class Checker:
    def __init__(self, text, task, tool, angle, holes, increment):
        self.loops = walls_of(text)
        if task == 'face':  # its outer sides are open: the first loop here
            for wall in self.loops[0]:
                wall.open = True
        self.radius, self.slope, self.holes, self.increment = tool / 2, math.tan(math.radians(angle)), holes, increment
        self.stock = Stock(self.loops, self.radius, task == 'slot')
        self.walls = [] if task == 'slot' else [w for loop in self.loops for w in loop if not w.open]
        self.faults, self.straight, self.deepest = [], 0, 0.0

    def run(self, moves):
        lifted, drop, gone = None, 0.0, 0.0
        for do, a, b, centre, sweep in moves:
            start, end = a[:2], b[:2]
            corners = [start] + chords(start, end, centre, sweep)
            flat = sum(math.dist(p, q) for p, q in zip(corners, corners[1:]))
            down = a[2] - b[2]
            if a[2] < -1e-6 <= b[2]:
                lifted = start
            if b[2] < -1e-6 <= a[2]:
                if lifted and math.dist(lifted, end) < self.radius / 2:
                    self.faults.append(f'lift and plunge at X{end[0]} Y{end[1]}')
            if down > 0 and b[2] < -1e-6:
                self.descends(do, end, b[2], down, flat)
            drop, gone = (drop + down, gone + flat) if do != 'rapid' and down > 0 and flat > 0 else (0.0, 0.0)
            if drop > gone * self.slope * 1.01 + 2 * self.increment:
                self.faults.append(f'the ramp to X{end[0]} Y{end[1]} Z{b[2]} is steeper than asked: {drop} on {gone}')
            if min(a[2], b[2]) < -1e-6:
                self.keeps_off(corners)
                if do != 'rapid':
                    self.stock.cut += [(p, q, max(a[2], b[2])) for p, q in zip(corners, corners[1:])]
            self.deepest = min(self.deepest, b[2])
        return self.faults

    def descends(self, do, end, level, down, flat):
        if do != 'rapid' and down <= flat * self.slope + 1e-6:
            return
        if any(math.dist(end, hole) < 0.002 for hole in self.holes) or not self.stock.left_under(end, level):
            return
        self.straight += 1
        if self.straight == 1:
            self.first = f'straight down into the material: {do} to X{end[0]} Y{end[1]} Z{level}'

    def keeps_off(self, corners):
        """Checks a point every millimetre, and the corners. The distance from a wall changes by at most the distance travelled, so the
        points within that distance are clear of the wall as well."""
        points, gone = [corners[0]], [0.0]
        for p, q in zip(corners, corners[1:]):
            way = math.dist(p, q)
            pieces, begin = 1 + int(way), gone[-1]
            points += [(p[0] + (q[0] - p[0]) * i / pieces, p[1] + (q[1] - p[1]) * i / pieces) for i in range(1, pieces + 1)]
            gone += [begin + way * i / pieces for i in range(1, pieces + 1)]
        for wall in self.walls:
            i = 0
            while i < len(points):
                away = wall.distance(points[i])
                clear = away - (self.radius - 0.013)  # the checker's own chords: 0.01
                if clear < 0:
                    self.faults.append(f'X{points[i][0]} Y{points[i][1]} is {away} from a wall')
                    return
                i = bisect.bisect_left(gone, gone[i] + clear - 1e-9, i + 1)


class Runner(harness.Kadr):
    def __init__(self, program, folder):
        super().__init__(program, folder)
        self.tally = harness.Tally()

    def moves(self, program, control):
        done = self.call('run', program, '--control', control, '--trace', '-', '--quiet')
        at, moves = (0.0, 0.0, 0.0), []
        for row in map(json.loads, done.stdout.splitlines()):
            if row['do'] in ('rapid', 'feed', 'arc_cw', 'arc_ccw'):
                to = tuple(row['to'].get(axis, 0.0) for axis in 'XYZ')
                centre = (row['center']['X'], row['center']['Y']) if 'center' in row else None
                sweep = 2 * math.pi * abs(row.get('turns', 0)) * (-1 if row['do'] == 'arc_cw' else 1)
                moves.append((row['do'], at, to, centre, sweep))
                at = to
        return moves if done.returncode == 0 else []

    def one(self, name, text, task, tool, control, options, roomy=True, straight=False, depth=6.0):
        contour, program = self.file('contour', text), self.folder / 'program.nc'
        angle = float(options[options.index('--ramp-angle') + 1]) if '--ramp-angle' in options else 3.0
        done = self.call('mill', task, contour, '--tool-diameter', tool, '--depth', depth, '--control', control, '--output', program, '--lang', 'en', *options)
        what = f'{name}, Ø{tool}, {control}, {" ".join(options)}'
        self.tally.expect(done.returncode == 0, f'{what}: {done.stderr}')
        if done.returncode != 0:
            return
        holes = [(float(x), float(y)) for x, y in re.findall(r'^drill before +X(\S+) Y(\S+)$', done.stdout, re.M)]
        checker = Checker(text, task, tool, angle, holes, INCREMENTS.get(control, 0.001))
        faults = checker.run(self.moves(program, control))
        if checker.straight and not straight:
            faults.append(checker.first)
        told = re.search(r'straight down into the material \(.*\): (\d+)', done.stdout)
        if straight and checker.straight != (int(told[1]) if told else 0):
            faults.append(f'{checker.straight} times straight down, told: {done.stdout}')
        if '--plunge' not in options:
            if roomy == bool(holes):
                faults.append(f'holes: {holes}')
            if bool(holes) != ('no room for a ramp' in done.stderr):
                faults.append(f'not said: {done.stderr}')
        if abs(checker.deepest + depth) > 0.0015:
            faults.append(f'deepest Z{checker.deepest}')
        self.tally.expect(not faults, f'{what}: ' + '; '.join(faults[:3]))

    def all_shapes(self, only):
        turn = itertools.count()
        for name, (text, tools, roomy) in SHAPES.items():
            if only and name != only:
                continue
            for scheme, tool in itertools.product(SCHEMES, tools):
                i = next(turn)
                angle = (['--ramp-angle', '8'], ['--ramp-angle', '1'])[i // 3 % 2] if i % 3 == 2 else []
                layers = ['--pass', '2.1'] if i % 2 else []
                self.one(name, text, 'pocket', tool, CONTROLS[i % 5], ['--scheme', scheme, *layers, *angle], roomy)
            for plunge in ('hole', 'tangential'):
                scheme = SCHEMES[next(turn) % len(SCHEMES)]
                self.one(name, text, 'pocket', tools[0], CONTROLS[next(turn) % 5], ['--scheme', scheme, '--plunge', plunge, '--pass', '3'],
                         straight=plunge == 'tangential')
        if only:
            return
        for i, scheme in enumerate(SCHEMES):
            self.one('face', SHAPES['rectangle'][0] + 'circle 30 20 6\n', 'face', 12, CONTROLS[i % 5], ['--scheme', scheme, '--pass', '3'])
        line = 'from 0 0\nline 40 0\narc 60 20 40 20 ccw\nline 60 50\n'
        for i, pass_options in enumerate(([], ['--pass', '2'])):
            self.one('slot along a line', line, 'slot', 6, CONTROLS[i], pass_options)
            self.one('wide slot', line, 'slot', 6, CONTROLS[i + 2], ['--width', '11', *pass_options])
            self.one('slot of 1 mm', 'from 0 0\nline 1 0\n', 'slot', 6, CONTROLS[i + 3], pass_options, roomy=False)


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--only', help='run only this shape')
    options = harness.parsed(parser)
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(options.kadr, folder)
        runner.all_shapes(options.only)
        return runner.tally.result()


if __name__ == '__main__':
    sys.exit(main())
