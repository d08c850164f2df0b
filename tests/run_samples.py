#!/usr/bin/env python3
"""Samples obey every limit of the axes, end where the control says, and follow the path within the tolerance.

    run_samples.py --kadr build/kadr [--every 1] [--random 40] [--seed 7] [--rate 1000]

Programs of tests/golden and tests/cases, and random ones (short lines, long lines, arcs, reversals), each sampled on one machine.
Checked from the samples alone, and the greatest of each told:
  speed, acceleration, jerk   first, second and third differences of each axis
  end                         the last sample is the machine position of the trace's last line
  path                        no sample is further from the path than the tolerance; the path: the same program followed exactly
"""
import argparse
import json
import math
import random
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
LIMITS = {'speed': 200.0, 'acceleration': 1000.0, 'jerk': 20000.0}  # mm/s, mm/s², mm/s³
TOLERANCE = 0.02
OVER = 1.005           # of a limit: differences of samples with nine decimals
OVER_FAST = 1.04       # beyond 1 kHz the jerk between the places where the planner looks at it is seen too: 3.5 % at most are known
FAST = 2000            # Hz
EXACT_PATH = 0.005     # mm: the exact run's own arcs, chords between its samples, THIN
PATH_RATE = 1000       # Hz: of the samples whose way to the path is measured
MOST_PATH = 2000       # samples whose way to the path is measured
THIN = 0.003           # mm: points of the exact run nearer than this are one
AROUND_NEAR = 15       # points of the exact run, before and behind, where it is looked for,
AROUND = 150           # and so many if it is not within NEAR of them
NEAR = 0.01            # mm
TIME_LIMIT_S = 60
ROTARY = 'ABC'         # may roll over: they end on the same place of the turn
MACHINE = '''id = "test"
tool_change = 0
tolerance = {tolerance}
[axes]
'''


def machine(folder, tolerance):
    return Path(folder) / f'machine{tolerance}.toml'


def write_machine(folder, tolerance):
    row = f'{{ rapid = {LIMITS["speed"] * 60}, acceleration = {LIMITS["acceleration"]}, jerk = {LIMITS["jerk"]} }}\n'
    machine(folder, tolerance).write_text(MACHINE.format(tolerance=tolerance) + ''.join(f'{axis} = {row}' for axis in 'XYZABCUVW'))


def programs_of_cases():
    for path in sorted([*HERE.glob('golden/*/*.json'), *HERE.glob('cases/*/*.json')]):
        case = json.loads(path.read_text(encoding='utf-8'))
        setup = dict(case.get('setup', {}))
        text = case.get('program')
        if not isinstance(text, str) or 'channels' in setup or case.get('programs') or case.get('files'):
            continue
        setup.pop('machine', None)
        setup.pop('override', None)
        yield path.stem, case['control'], setup, text


def random_programs(choose, count):
    for i in range(count):
        kind = choose.choice(('short', 'long', 'arcs', 'noise', 'back'))
        lines, x, y, a = [f'G21 G90 G17 G64\nG0 X0 Y0 Z5\nG1 Z0 F{choose.choice((300, 1500, 4000, 9000))}'], 0.0, 0.0, 0.0
        for n in range(choose.randint(3, 120)):
            if kind == 'arcs':
                r = choose.uniform(0.3, 12)
                x += 2 * r
                lines.append(f'G{choose.choice((2, 3))} X{x:.3f} Y{y:.3f} I{r:.3f} J0')
                continue
            step = {'short': choose.uniform(0.02, 0.4), 'long': choose.uniform(1, 60), 'noise': choose.uniform(0.001, 5),
                    'back': choose.uniform(0.5, 20)}[kind]
            a = a + math.pi if kind == 'back' and choose.random() < 0.6 else a + choose.gauss(0, 0.1 if kind == 'short' else 1.2)
            x, y = x + step * math.cos(a), y + step * math.sin(a)
            z = f' Z{choose.uniform(-1, 1):.3f}' if choose.random() < 0.2 else ''
            lines.append(f'G{0 if choose.random() < 0.05 else 1} X{x:.4f} Y{y:.4f}{z}' + (f' F{choose.randint(200, 9000)}' if choose.random() < .1 else ''))
        yield f'random {i} {kind}', 'mach3', {}, '\n'.join(lines) + '\nM30\n'


def sampled(kadr, folder, profile, control, setup, program, rate):
    command = [kadr, 'run', program, '--control', control, '--setup', setup, '--machine', profile, '--samples', '-', '--quiet', '--rate', str(rate)]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, cwd=folder, timeout=TIME_LIMIT_S)
    if done.returncode not in (0, 1):
        return [], []  # it needs files beside it
    lines = done.stdout.decode('ascii').split('\n')
    return lines[0].split(',')[1:], [tuple(map(float, line.split(','))) for line in lines[1:] if line]


def differences(axis):
    return [b - a for a, b in zip(axis, axis[1:])]


def used(names, rows):
    """(share, limit, axis, time) of the most that is used of each limit by each axis."""
    if len(rows) < 3:
        return
    period = rows[1][0] - rows[0][0]
    for k, name in enumerate(names, 1):
        values = [row[k] for row in rows[:-1]]  # the last one is the end itself, less than a period on
        if min(values) == max(values):
            continue
        for limit, most in LIMITS.items():
            values = [d / period for d in differences(values)]
            at = max(range(len(values)), key=lambda i: abs(values[i]), default=None)
            if at is not None:
                yield abs(values[at]) / most, limit, name, rows[at][0]


def distance(p, a, b):
    way = [q - r for q, r in zip(b, a)]
    square = sum(w * w for w in way)
    part = 0 if square == 0 else max(0, min(1, sum(w * (q - r) for w, q, r in zip(way, p, a)) / square))
    return math.sqrt(sum((q - r - part * w) ** 2 for w, q, r in zip(way, p, a)))


def furthest(rows, exact):
    """Greatest distance of a sample from the exact path, looked for around where the last one was near."""
    path = [exact[0][1:]]
    for row in exact:
        if math.dist(row[1:], path[-1]) > THIN:
            path.append(row[1:])
    near, worst = 0, (0, 0)
    for row in rows[:MOST_PATH]:
        for around in (AROUND_NEAR, AROUND):
            found = [(distance(row[1:], path[i], path[i + 1]), i) for i in range(max(0, near - around), min(len(path) - 1, near + around))]
            if found and min(found)[0] < NEAR:
                break
        if not found:
            continue
        best = min(found)[0]
        close = [i for d, i in found if d <= best + 1e-3]  # where the path comes back on itself: rather on than back
        near = min((i for i in close if i >= near), default=max(close))
        if best > worst[0]:
            worst = (best, row[0])
    return worst


class Greatest:
    """The greatest of each thing found, and where."""

    def __init__(self):
        self.found = {}

    def take(self, what, value, where):
        if value > self.found.get(what, (-1,))[0]:
            self.found[what] = (value, where)

    def take_all(self, other, program):
        for what, (value, where) in other.found.items():
            self.take(what, value, f'{program}: {where}')

    def print(self):
        for what, (value, where) in self.found.items():
            print(f'greatest {what}: {value:.6g} ({where})')


def end_faults(names, end, at, greatest):
    """The last sample is where the control says that the axes are."""
    for axis, value in zip(names, end):
        if axis not in at:
            continue
        off = abs(math.remainder(at[axis] - value, 360 if axis in ROTARY else math.inf))
        greatest.take('drift, mm', off, axis)
        if off > 1e-6:
            yield f'ends at {axis} {value}, the control at {at[axis]}'


def check(kadr, folder, rate, item):
    number, (name, control, setup, text) = item
    base = Path(folder) / str(number)
    program, setup_file = base.with_suffix('.nc'), base.with_suffix('.json')
    program.write_text(text, encoding='utf-8')
    setup_file.write_text(json.dumps(setup), encoding='utf-8')
    faults, greatest = [], Greatest()
    try:
        names, rows = sampled(kadr, folder, machine(folder, TOLERANCE), control, setup_file, program, rate)
        _, exact = sampled(kadr, folder, machine(folder, 0), control, setup_file, program, rate)
    except (RuntimeError, subprocess.TimeoutExpired) as failed:
        return name, [str(failed)], 0, greatest
    if not rows:
        return name, [], 0, greatest
    for how, sampled_rows in ('', rows), ('exact: ', exact):
        for share, limit, axis, when in used(names, sampled_rows):
            greatest.take(f'share of {limit}', share, f'{how}{axis} at {when:.3f} s')
            if share > (OVER if rate < FAST else OVER_FAST):
                faults.append(f'{how}{limit} of {axis} {share:.4f} of its limit at {when:.3f} s')
    trace = subprocess.run([kadr, 'run', program, '--control', control, '--setup', setup_file, '--trace', '-', '--quiet'],
                           stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, cwd=folder, timeout=TIME_LIMIT_S).stdout.decode('utf-8')
    faults += end_faults(names, rows[-1][1:], json.loads(trace.strip().split('\n')[-1]).get('machine_position', {}), greatest)
    every = max(1, round(rate / PATH_RATE))
    away, when = furthest(rows[::every], exact)
    tolerance = max(TOLERANCE, 0.1 if 'G64 P0.1' in text else 0)
    greatest.take('distance from the path over its tolerance, mm', away - tolerance, f'at {when:.3f} s')
    if away > tolerance + EXACT_PATH:
        faults.append(f'{away:.4f} mm from the path at {when:.3f} s')
    return name, faults, len(rows), greatest


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--kadr', required=True)
    parser.add_argument('--every', type=int, default=1)
    parser.add_argument('--random', type=int, default=40)
    parser.add_argument('--seed', type=int, default=7)
    parser.add_argument('--rate', type=float, default=1000, help='Hz')
    parser.add_argument('--only', default='')
    options = parser.parse_args()
    kadr = str(Path(options.kadr).resolve())
    every = [*programs_of_cases()][::options.every] + [*random_programs(random.Random(options.seed), options.random)]
    every = [item for item in every if options.only in item[0]]
    sampled_any = failed = 0
    greatest = Greatest()
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        for tolerance in TOLERANCE, 0:
            write_machine(folder, tolerance)
        for name, faults, rows, found in pool.map(lambda item: check(kadr, folder, options.rate, item), enumerate(every)):
            sampled_any += rows > 0
            failed += bool(faults)
            greatest.take_all(found, name)
            if faults:
                print(f'FAIL {name}: ' + '; '.join(faults[:4]), flush=True)
    greatest.print()
    print(f'{len(every)} programs, {sampled_any} with motion, {failed} failed')
    return 1 if failed or sampled_any == 0 else 0


if __name__ == '__main__':
    sys.exit(main())
