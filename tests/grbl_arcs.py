#!/usr/bin/env python3
"""Tests Grbl's arcs in 32 bits: Kadr's result against a twin of Grbl's arithmetic, and against Grbl itself where it is available.

    grbl_arcs.py --kadr build/kadr [--seed N] [--arcs N] [--show]
    KADR_GRBL_ORACLE=… grbl_arcs.py --kadr build/release/kadr --arcs 1000000         dev/grbl_oracle builds the oracle

The twin (class Twin) rounds each sum, product and root to 32 bits separately, in the order of gcode.c and mc_arc; a second one (class
Exact) does not round. Arcs are random and adversarial: short parts of large circles, full circles, R of half the chord, radii at the
limits of their errors, far from the origin, in inches, in increments, helices in each plane. Checked for each arc:
    refused     Kadr refuses it with Grbl's number, and refuses no other
    its path    at a quarter, a half, three quarters it is where Grbl's line segments end, within NEAR and the rounding of 32 bits
    a warning   single_arc_… is reported if the twins differ by more than NEAR, and only then
If the environment variable KADR_GRBL_ORACLE names an executable, Grbl's own source, Kadr and the twin are compared with it as well.
The seed is printed. Exit status: 0 all passed, 1 some failed.
"""
import json
import math
import os
import random
import re
import struct
import subprocess
import sys

import harness
from harness import Failure

NEAR, DOUBT = 0.01, 0.002    # mm: Kadr reports a difference larger than NEAR; the sums of both sides may differ by DOUBT
BATCH = 4000                 # arcs per program
EPSILON, PI = 5e-7, math.pi
WARNINGS = {'single_arc_turns', 'single_arc_path', 'single_arc_refused', 'single_arc_passed'}
AXES = 'XYZ'
PLANES = {'G17': (0, 1, 2), 'G18': (2, 0, 1), 'G19': (1, 2, 0)}
_FLOAT = struct.Struct('f')


def single(value):
    """Returns the nearest 32-bit number."""
    try:
        return _FLOAT.unpack(_FLOAT.pack(value))[0]
    except OverflowError:
        return math.copysign(math.inf, value)


# ---- the twin

class Twin:
    """Grbl from line to line. `line()` returns {'error': n}, {'arc': …} or None."""

    def __init__(self):
        r = self.rounded
        self.edge = False                                # R is half of the chord: rounding would decide even with exact figures
        self.at, self.zeros, self.shift = [0.0] * 3, [[0.0] * 3 for _ in range(7)], [0.0] * 3
        self.system, self.absolute, self.inch, self.plane, self.motion = 1, True, False, 'G17', 'G0'
        self.mm, self.tolerance, self.epsilon, self.turn = r(25.4), r(0.002), r(EPSILON), r(2 * r(PI))

    rounded = staticmethod(single)

    def number(self, text):
        """read_float: eight digits, then multiplied by a hundredth, a tenth, ten."""
        r = self.rounded
        digits, power, count, fraction = 0, 0, 0, False
        for c in text:
            if c == '.':
                fraction = True
            elif c.isdigit():
                count += 1
                if count <= 8:
                    digits, power = digits * 10 + int(c), power - fraction
                else:
                    power += not fraction
        value = r(float(digits))
        while power <= -2:
            value, power = r(value * r(0.01)), power + 2
        if power < 0:
            value = r(value * r(0.1))
        for _ in range(max(power, 0)):
            value = r(value * 10)
        return -value if text.startswith('-') else value

    def line(self, text):
        r = self.rounded
        words = re.findall(r'([A-Z])([-+.\d]+)', text)
        given = {}
        once = None
        for letter, value in words:
            code = letter + value
            if code in PLANES:
                self.plane = code
            elif code in ('G0', 'G1', 'G2', 'G3'):
                self.motion = code
            elif code in ('G90', 'G91'):
                self.absolute = code == 'G90'
            elif code in ('G20', 'G21'):
                self.inch = code == 'G20'
            elif code in ('G54', 'G55', 'G56'):
                self.system = int(value) - 53
            elif code in ('G92', 'G10'):
                once = code
            elif letter in 'LP':
                given[letter] = int(value)
            elif letter not in 'GFN':
                given[letter] = self.number(value)
        lengths = {c: r(given[c] * self.mm) if self.inch else given[c] for c in given if c in 'XYZIJKR'}
        if once:
            return self.offsets(once, lengths, given)
        named = [a for a in range(3) if AXES[a] in lengths]
        if not named:
            return None
        target = list(self.at)
        for a in named:
            v = lengths[AXES[a]]
            target[a] = r(v + r(self.zeros[self.system][a] + self.shift[a])) if self.absolute else r(v + self.at[a])
        if self.motion in ('G0', 'G1'):
            self.at = target
            return None
        found = self.arc(target, lengths)
        if 'error' not in found:
            found['start'], found['end'] = self.at, target
            self.at = target
        return found

    def offsets(self, code, lengths, given):
        r = self.rounded
        for a in range(3):
            if AXES[a] not in lengths:
                continue
            v = lengths[AXES[a]]
            if code == 'G92':
                self.shift[a] = r(r(self.at[a] - self.zeros[self.system][a]) - v)
            else:
                self.zeros[given['P']][a] = v if given['L'] == 2 else r(r(self.at[a] - self.shift[a]) - v)
        return None

    def arc(self, target, lengths):
        r = self.rounded
        first, second, _ = PLANES[self.plane]
        x, y = r(target[first] - self.at[first]), r(target[second] - self.at[second])
        if 'R' in lengths:
            radius = lengths['R']
            if target == self.at:
                return {'error': 33}
            root = r(r(r(r(4 * radius) * radius) - r(x * x)) - r(y * y))
            self.edge = abs(root) <= 1e-9 * (x * x + y * y)
            if root < 0:
                return {'error': 34}
            chord = self.length(x, y)
            if chord == 0:
                return {'turns': 0, 'center': (0, 0), 'straight': True}
            height = r(-r(math.sqrt(root)) / chord)
            if (self.motion == 'G3') != (radius < 0):
                height = -height
            offset = (r(0.5 * r(x - r(y * height))), r(0.5 * r(y + r(x * height))))
            return self.led(target, offset, abs(radius))
        offset = (lengths.get('IJK'[first], 0.0), lengths.get('IJK'[second], 0.0))
        radius, at_end = self.length(*offset), self.length(r(x - offset[0]), r(y - offset[1]))
        error = abs(r(at_end - radius))
        if error > r(0.005) and (error > 0.5 or error > r(r(0.001) * radius)):
            return {'error': 33}
        return self.led(target, offset, radius)

    def length(self, x, y):
        r = self.rounded
        return r(math.sqrt(r(r(x * x) + r(y * y))))

    def angle(self, r0, r1, t0, t1):
        r = self.rounded
        angle = r(math.atan2(r(r(r0 * t1) - r(r1 * t0)), r(r(r0 * t0) + r(r1 * t1))))
        if self.motion == 'G2':
            return r(angle - self.turn) if angle >= -self.epsilon else angle
        return r(angle + self.turn) if angle <= self.epsilon else angle

    def led(self, target, offset, radius):
        r = self.rounded
        first, second, _ = PLANES[self.plane]
        center = (r(self.at[first] + offset[0]), r(self.at[second] + offset[1]))
        r0, r1 = -offset[0], -offset[1]
        angle = self.angle(r0, r1, r(target[first] - center[0]), r(target[second] - center[1]))
        under = r(self.tolerance * r(r(2 * radius) - self.tolerance))
        count = 0
        if under > 0:
            count = math.floor(r(abs(r(r(0.5 * angle) * radius)) / r(math.sqrt(under)))) % 65536
        return {'angle': angle, 'center': center, 'straight': count == 0}


class Exact(Twin):
    """The same in 64 bits: rounding decides nothing, and a full circle is one whose ends coincide."""

    rounded = staticmethod(lambda value: value)

    def number(self, text):
        digits = re.sub(r'\D', '', text)
        if len(digits) <= 8:
            return float(text)
        return super().number(text)

    def angle(self, r0, r1, t0, t1):
        angle = math.atan2(r0 * t1 - r1 * t0, r0 * t0 + r1 * t1)
        sign = -1 if self.motion == 'G2' else 1
        if math.hypot(t0 - r0, t1 - r1) <= 1e-6:
            return sign * 2 * PI
        return angle if sign * angle > math.radians(1e-9) else angle + sign * 2 * PI


def points_of(found, plane):
    """Returns the positions of an arc at its quarters, in machine coordinates of the plane; `found` has the start and the end of all axes."""
    first, second, _ = PLANES[plane]
    (x0, y0), (x1, y1) = ((found[k][first], found[k][second]) for k in ('start', 'end'))
    if found['straight']:
        return [(p, x0 + p * (x1 - x0), y0 + p * (y1 - y0)) for p in (0.25, 0.5, 0.75)]
    cx, cy = found['center']
    out = []
    for p in (0.25, 0.5, 0.75):
        c, s = math.cos(found['angle'] * p), math.sin(found['angle'] * p)
        out.append((p, cx + (x0 - cx) * c - (y0 - cy) * s, cy + (x0 - cx) * s + (y0 - cy) * c))
    return out


def apart(one, other, plane):
    """Returns the greatest distance in mm between two arcs."""
    return max(math.hypot(a[1] - b[1], a[2] - b[2]) for a, b in zip(points_of(one, plane), points_of(other, plane)))


# ---- programs

def text_of(rng, value, least=3):
    text = f'{value:.{rng.choice((least, 4, 4, 5))}f}'
    return text if float(text) else '0'


def arc_lines(rng):
    """Returns the lines of a position, and an arc there."""
    plane = rng.choice(('G17', 'G17', 'G17', 'G18', 'G19'))
    first, second, third = (AXES[a] for a in PLANES[plane])
    offsets = dict(zip(AXES, 'IJK'))
    code = rng.choice(('G2', 'G3'))
    far = 10 ** rng.uniform(0, 3.5)
    x, y = rng.uniform(-far, far), rng.uniform(-far, far)
    inch = rng.random() < 0.1
    to = lambda v: text_of(rng, v)
    if inch:
        x, y = x / 25, y / 25
    place = f'{first}{to(x)} {second}{to(y)}'
    x, y = (float(t) for t in re.findall(r'-?[\d.]+', place))
    turned = rng.uniform(0, 2 * PI)
    kind = rng.randrange(8)
    if kind == 0:                                       # a short part of a large circle
        radius, chord = 10 ** rng.uniform(2, 7), 10 ** rng.uniform(-3, 1)
    elif kind == 1:                                     # tiny
        radius = 10 ** rng.uniform(-3, -1)
        chord = rng.uniform(0, 2 * radius)
    else:
        radius = 10 ** rng.uniform(-1, 3)
        chord = rng.uniform(0, 2) * radius
    sweep = 2 * math.asin(min(1, chord / 2 / radius)) * (1 if code == 'G3' else -1)
    center = (-radius * math.cos(turned), -radius * math.sin(turned))
    end = [center[0] + radius * math.cos(turned + sweep), center[1] + radius * math.sin(turned + sweep)]
    third_word = f' {third}{to(rng.uniform(-5, 5))}' if rng.random() < 0.2 else ''
    if kind == 2:                                       # a full circle
        end = [0, 0]
    if kind == 3:                                       # the error of the radius at its limits
        error = rng.choice((0.005, -0.005, 0.5, -0.5, 0.001 * radius, -0.001 * radius)) * (1 + rng.choice((0, 1e-4, -1e-4, 0.02, -0.02)))
        scale = (radius + error) / radius
        end = [c + (e - c) * scale for c, e in zip(center, end)]
    words = f'{first}{to(x + end[0])} {second}{to(y + end[1])}{third_word}'
    if kind in (4, 5):                                  # by R
        half = math.hypot(*(float(t) - v for t, v in zip(re.findall(r'-?[\d.]+', words), (x, y)))) / 2
        r = half * (1 + rng.choice((0, 0, 1e-7, -1e-7, 1e-5, -1e-5, 1e-3, 0.3, 3))) if kind == 4 else half + 10 ** rng.uniform(-4, 4)
        by = f'R{to(rng.choice((-1, 1)) * r) if r > 1e-3 else "0.01"}'
    else:
        by = f'{offsets[first]}{to(center[0])} {offsets[second]}{to(center[1])}'
    lines = [f'{plane} G90 G0 {place}', f'{code} {words} {by}']
    if kind == 6:                                       # the end in increments
        lines[0:1] = [f'{plane} G90 G0 {place}', 'G91'] + [f'G0 {first}0.1 {second}-0.1'] * 10 + [f'G0 {first}-1 {second}1', 'G90']
    if kind == 7:
        lines[1] = f'G91 {code} {first}{to(end[0])} {second}{to(end[1])} {by}'
    return ['G20', *lines, 'G21'] if inch else lines


def program(seed, arcs):
    rng = random.Random(seed)
    lines = ['G21 G90 F500']
    for n in range(arcs):
        if n % 40 == 0:
            lines += ['G90 G0 X1.1 Y2.2 Z3.3', rng.choice(('G54', 'G55', 'G10 L2 P2 X12.345 Y-7.891 Z3.3', 'G92 X1.234 Y0', 'G10 L20 P1 X0 Z1.27', 'G56'))]  # after a refused arc Kadr is at its end
        lines += arc_lines(rng)
    return lines


# ---- Kadr's results

def findings(kadr, lines):
    """Returns {line: (error, warnings)} of `kadr check`."""
    kadr.file('p.nc', '\n'.join(lines) + '\n')
    done = kadr.run('check', 'p.nc', '--control', 'grbl', '--format', 'json', '--every', '--lang', 'en', '-q', expected=(0, 1))
    out = {}
    for found in json.loads(done.stdout):
        number = re.match(r'error:(\d+)', found['text'])
        errors, warned = out.setdefault(found['line'], ([], set()))
        if number:
            errors.append(int(number[1]))
        elif found['id'] in WARNINGS:
            warned.add(found['id'])
    return out


def motions(kadr, lines):
    """Returns {line: action} of `kadr run`."""
    kadr.file('q.nc', '\n'.join(lines) + '\n')
    done = kadr.run('run', 'q.nc', '--control', 'grbl', '--trace', '-', '-q', '--lang', 'en', expected=(0, 1))
    out = [json.loads(x) for x in done.stdout.splitlines() if x.startswith('{')]
    if out[-1]['do'] != 'end':
        raise Failure(f'the run ends with {out[-1]}')
    return {x['line']: x for x in out if 'to' in x}


def kadr_points(action, start, parts, plane):
    """Machine coordinates; a start in them."""
    first, second, _ = (AXES[a] for a in PLANES[plane])
    to = [action['machine'][first], action['machine'][second]]
    if action['do'] not in ('arc_cw', 'arc_ccw'):
        return [(start[0] + p * (to[0] - start[0]), start[1] + p * (to[1] - start[1])) for p in parts]
    shift = [action['machine'][a] - action['to'][a] for a in (first, second)]
    center = [action['center'][a] + s for a, s in zip((first, second), shift)]
    sign = -1 if action['do'] == 'arc_cw' else 1
    rays = [start[0] - center[0], start[1] - center[1]]
    ratio = math.hypot(to[0] - center[0], to[1] - center[1]) / (math.hypot(*rays) or 1)
    out = []
    for p in parts:
        angle, grown = sign * 2 * PI * action['turns'] * p, 1 + (ratio - 1) * p
        c, s = math.cos(angle), math.sin(angle)
        out.append((center[0] + grown * (rays[0] * c - rays[1] * s), center[1] + grown * (rays[0] * s + rays[1] * c)))
    return out


def rounding(found, center, radius):
    """Returns the deviation in mm that 32 bits and Grbl's sums cause along an arc."""
    near = 3e-6 * (radius + max(map(abs, (*center, *found['start'], *found['end']))))
    return near + min(3e-4 / max(radius, 1e-9), 3 * radius)


# ---- comparison

class Batch:
    def __init__(self, seed, arcs):
        self.lines = program(seed, arcs)
        twin, exact = Twin(), Exact()
        self.arcs, self.edges = {}, set()                # line: plane, twin's, exact's; lines whose warning is not judged
        for number, line in enumerate(self.lines, 1):
            before, exact.edge = exact.at, False
            found, other = twin.line(line), exact.line(line)
            if found is None:
                continue
            self.arcs[number] = (twin.plane, found, other)
            self.edges |= {number} if exact.edge else set()
            if 'error' in found:
                exact.at = before                        # Grbl does not move
            elif 'error' in other:
                exact.at = self.meant(exact, line)

    @staticmethod
    def meant(exact, line):
        """Returns the end of a line that only the twin accepts."""
        as_line = Exact()
        as_line.__dict__.update(exact.__dict__)
        as_line.line(re.sub('G[23] ', 'G1 ', line))
        return as_line.at

    def faults(self, kadr):
        said = findings(kadr, self.lines)
        refused = {n for n, (_, found, _) in self.arcs.items() if 'error' in found}
        done = motions(kadr, ['' if n in refused else line for n, line in enumerate(self.lines, 1)])
        for number, (plane, found, exact) in self.arcs.items():
            errors, warned = said.get(number, ([], set()))
            fault = self.fault(found, exact, plane, errors, warned, number in self.edges)
            if not fault and 'error' not in found:
                fault = self.path_fault(found, plane, done.get(number))
            if fault:
                yield f'line {number} {self.lines[number - 1]!r}: {fault}'

    @staticmethod
    def fault(found, exact, plane, errors, warned, on_edge):
        expected = [found['error']] if 'error' in found else []
        if errors != expected:
            return f'errors {errors}, Grbl {expected}'
        if on_edge:
            return None
        if 'error' in found or 'error' in exact:
            parted = 'error' not in found or 'error' not in exact
            return None if parted == bool(warned) else f'warnings {warned}, the exact figures give {exact}, 32 bits {found}'
        distance = apart(found, exact, plane)
        doubt = DOUBT + 3e-7 * max(map(abs, (*found['center'], *found['start'], *found['end'])))  # for the position of both
        if distance > NEAR + doubt and not warned:
            return f'no warning where the readings part by {distance} mm'
        if distance < NEAR - doubt and warned:
            return f'warnings {warned} where the readings part by {distance} mm'
        return None

    @staticmethod
    def path_fault(found, plane, action):
        if action is None:
            return 'no motion'
        first, second, _ = PLANES[plane]
        start = (found['start'][first], found['start'][second])
        wanted = points_of(found, plane)
        ends = [math.hypot(found[k][first] - found['center'][0], found[k][second] - found['center'][1]) for k in ('start', 'end')]
        near = NEAR + DOUBT + (0 if found['straight'] else abs(ends[1] - ends[0]))  # Kadr distributes the error over the arc
        near += rounding(found, found['center'], math.hypot(start[0] - found['center'][0], start[1] - found['center'][1]))
        for (_, x, y), (mx, my) in zip(wanted, kadr_points(action, start, [p for p, _, _ in wanted], plane)):
            if not math.hypot(mx - x, my - y) <= near:
                return f'{action["do"]} passes {mx:.4f} {my:.4f}, Grbl {x:.4f} {y:.4f}'
        return None

    def oracle_faults(self, oracle):
        """Compares the twin with Grbl's own source."""
        done = subprocess.run([oracle], input='\n'.join(self.lines).encode(), capture_output=True, timeout=harness.TIME_LIMIT_S, check=True)
        theirs = {x['line']: x for x in map(json.loads, done.stdout.splitlines())}
        for number, (plane, found, _) in self.arcs.items():
            grbl = theirs.get(number, {})
            fault = self.oracle_fault(found, plane, grbl)
            if fault:
                yield f'line {number} {self.lines[number - 1]!r}: {fault}'

    @staticmethod
    def oracle_fault(found, plane, grbl):
        if found.get('error') != grbl.get('error'):
            return f'the twin says {found}, Grbl {grbl}'
        if 'error' in found:
            return None
        if list(found['end']) != [single(v) for v in grbl['to']]:
            return f'the twin ends at {found["end"]}, Grbl at {grbl["to"]}'
        if found['straight']:
            return None if grbl['segments'] == 1 else f'the twin goes straight, Grbl makes {grbl["segments"]} lines'
        first, second, _ = PLANES[plane]
        cx, cy = found['center']
        if [cx, cy] != [single(v) for v in grbl['center']]:
            return f'the centre of the twin is {cx} {cy}, Grbl\'s {grbl["center"]}'
        x0, y0 = found['start'][first] - cx, found['start'][second] - cy
        radius = math.hypot(x0, y0)
        if radius > 100 and abs(found['angle']) / grbl['segments'] > 0.02:
            return None                                  # the number of segments exceeded 65535: Grbl never makes a circle of so few
        near = 1e-3 + rounding(found, (cx, cy), radius)
        for part, (x, y) in grbl['points']:
            c, s = math.cos(found['angle'] * part), math.sin(found['angle'] * part)
            if not math.hypot(cx + x0 * c - y0 * s - x, cy + x0 * s + y0 * c - y) <= near:
                return f'at {part} the twin is at {cx + x0 * c - y0 * s} {cy + x0 * s + y0 * c}, Grbl at {x} {y}'
        return None


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--seed', type=int, default=23)
    parser.add_argument('--arcs', type=int, default=12000)
    parser.add_argument('--show', action='store_true', help='print all differences, not only the first of each program')
    options = harness.parsed(parser)
    oracle, tally = os.environ.get('KADR_GRBL_ORACLE'), harness.Tally()
    print(f'seed {options.seed}')
    sizes = [min(BATCH, options.arcs - at) for at in range(0, options.arcs, BATCH)]
    counts = {}

    def faults(work):
        n, size = work
        batch, out = Batch(f'{options.seed} {n}', size), []
        out += harness.in_a_folder(lambda kadr: out.extend(batch.faults(kadr)), options.kadr)
        out += batch.oracle_faults(oracle) if oracle else []
        parted = sum(1 for plane, a, b in batch.arcs.values()
                     if ('error' in a) != ('error' in b) or ('error' not in a and apart(a, b, plane) > NEAR))
        counts[n] = (len(batch.arcs), sum('error' in a for _, a, _ in batch.arcs.values()), parted)
        return out

    for (n, _), found in zip(enumerate(sizes), harness.each(faults, list(enumerate(sizes)))):
        found = list(found)
        tally.judge(f'program {n}', found if options.show else found[:1] + ([f'and {len(found) - 1} more'] if len(found) > 1 else []))
    arcs, refused, parted = map(sum, zip(*counts.values()))
    print(f'{arcs} arcs: {refused} refused, {parted} otherwise than by exact figures' + ('; Grbl itself asked too' if oracle else ''))
    if not oracle:
        harness.skipped('Grbl itself is not asked: KADR_GRBL_ORACLE is not set (dev/grbl_oracle)')
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
