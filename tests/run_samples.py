#!/usr/bin/env python3
"""Tests that samples obey every limit of the axes, end where the control reports, and follow the path within the tolerance.

    run_samples.py --kadr build/kadr [--every 1] [--random 40] [--seed 7] [--rate 1000]

Programs of tests/golden and tests/cases, and random ones (short lines, long lines, arcs, reversals), each sampled on one machine.
Checked from the samples alone; the greatest value of each is printed:
  speed, acceleration, jerk   first, second and third differences of each axis
  end                         the last sample is the machine position of the trace's last line
  path                        no sample is further from the path than the tolerance; the path: the same program followed exactly
  surface                     polar and cylindrical interpolation: path and feed in the programmed plane, the rotary axis' own limit
  smoothing                   G5.1 Q2 within N3104 of the programmed chords and through their ends, Q3 within N3106
  spindle                     threads and rigid tapping: axis position and spindle angle stay in step
  turning                     feed per revolution with a constant surface speed
  overrides                   all but path, surface and smoothing again with feed holds and overrides during the run
"""
import argparse
import json
import math
import random
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

try:
    import numpy as np
except ImportError:
    sys.exit('run_samples.py needs numpy (python3-numpy): so many samples take a minute without it')

from samples.geometry import EXACT_PATH, LIMITS, OVER, TOLERANCE, furthest, off_chords, off_feed, off_surface, out_of_step, used
from samples.programs import own_programs, programs_of_cases, random_programs

OVER_CHANGED = 1.02    # while the override changes: the plan's own jerk between its grid points, and a ramp that the limits would otherwise not allow
OVERRIDES = '0.05:40,0.7:0,0.9:70,1.2:20,1.6:100,2.5:0,2.9:30,4:100'  # s, %
OVER_FAST = 1.04       # above 1 kHz the jerk between the planner's grid points becomes visible: at most 3.5 % are known
FAST = 2000            # Hz
LED_AXES = 0.1         # mm: greatest deviation of the axes from their path where the tip is controlled and keeps the tolerance (docs/planner.md); five_axis_samples.py checks the tip
LEADS_TIP = re.compile(r'G43\.[4589]')
PATH_RATE = 1000       # Hz: of the samples whose distance from the path is measured
NO_ROWS = np.empty((0, 1))
ROTARY = 'ABC'         # these may roll over: they end at the same angle
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


MOST_BYTES = 100_000_000   # samples of one run that are read; some 15 minutes of motion
# Programs that do not pass yet, each with its reason; a named program that passes is a fault.
OPEN = {}


def sampled(kadr, folder, profile, control, setup, program, rate, *more):
    """Returns the names of the axes, a row of numbers for each sample, and the spindle's angles."""
    command = [kadr, 'run', program, '--control', control, '--setup', setup, '--machine', profile, '--quiet', '--samples', '-', '--rate', str(rate), *more]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, cwd=folder) as running:
        text = running.stdout.read(MOST_BYTES)
        if len(text) == MOST_BYTES:  # it moves for hours: its samples fill the memory
            running.kill()
            print(f'skipped: {program.stem} has more than {MOST_BYTES} bytes of samples', flush=True)
            return [], NO_ROWS, []
    if running.returncode not in (0, 1):
        return [], NO_ROWS, []  # it needs further files
    head, _, text = text.decode('ascii').partition('\n')
    names, lines = head.split(',')[1:], text.split('\n')[:-1]
    if not lines:
        return names, NO_ROWS, []
    rows = np.loadtxt(lines, delimiter=',', ndmin=2)
    if rows.shape != (len(lines), 1 + len(names)) or not np.isfinite(rows).all():
        raise ValueError('samples that are no rows of numbers')
    return (names[:-1], rows[:, :-1], rows[:, -1]) if names[-1] == 'spindle' else (names, rows, [])


class Greatest:
    """The greatest value of each quantity, and where it occurs."""

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


def end_faults(names, end, at, greatest, probes_last):
    """The last sample is at the axis positions that the control reports; but Mach3 retracts a probe without a motion if nothing follows."""
    for axis, value in zip(names, end):
        if axis not in at or probes_last:
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
    trace = base.with_suffix('.trace')
    try:
        names, rows, spindle = sampled(kadr, folder, machine(folder, TOLERANCE), control, setup_file, program, rate, '--trace', trace)
        if len(rows) == 0:
            return name, [], 0, greatest
        _, exact, _ = sampled(kadr, folder, machine(folder, 0), control, setup_file, program, rate)
        _, changed, turned = sampled(kadr, folder, machine(folder, TOLERANCE), control, setup_file, program, rate, '--override', OVERRIDES)
        actions = [json.loads(line) for line in trace.read_text(encoding='utf-8').strip().split('\n')]
    except ValueError as failed:
        return name, [str(failed)], 0, greatest
    for how, sampled_rows in ('', rows), ('exact: ', exact), ('overrides: ', changed):
        for share, limit, axis, when in used(names, sampled_rows):
            greatest.take(f'share of {limit}', share, f'{how}{axis} at {when:.3f} s')
            if share > (OVER_FAST if rate >= FAST else OVER_CHANGED if sampled_rows is changed else OVER):
                faults.append(f'{how}{limit} of {axis} {share:.4f} of its limit at {when:.3f} s')
    probes_last = len(actions) > 1 and actions[-2].get('do') == 'probe'
    for sampled_rows in rows, changed:
        faults += end_faults(names, sampled_rows[-1][1:], actions[-1].get('machine_position', {}), greatest, probes_last)
    every = max(1, round(rate / PATH_RATE))
    away, when = furthest(rows[::every], exact)
    tolerance = max(TOLERANCE, 0.1 if 'G64 P0.1' in text else 0, LED_AXES if LEADS_TIP.search(text) else 0)
    greatest.take('distance from the path over its tolerance, mm', away - tolerance, f'at {when:.3f} s')
    if away > tolerance + EXACT_PATH:
        faults.append(f'{away:.4f} mm from the path at {when:.3f} s')
    if name.startswith('smoothing'):
        faults += off_chords(name, exact)
    if name.startswith('surface'):
        faults += off_surface(name, names, rows)
    if name.startswith('turning'):
        faults += off_feed(rows, spindle)
    if name.startswith('spindle'):
        faults += out_of_step(actions, names, rows, spindle)
        faults += [f'overrides: {fault}' for fault in out_of_step(actions, names, changed, turned)]
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
    every = [*programs_of_cases()][::options.every]
    every += [*own_programs(), *random_programs(random.Random(options.seed), options.random)]
    every = [item for item in every if options.only in item[0]]
    sampled_any = failed = 0
    greatest = Greatest()
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        for tolerance in TOLERANCE, 0:
            write_machine(folder, tolerance)
        for name, faults, rows, found in pool.map(lambda item: check(kadr, folder, options.rate, item), enumerate(every)):
            sampled_any += rows > 0
            if name in OPEN and bool(faults) is True:
                print(f'open {name}: {OPEN[name]} ({"; ".join(faults[:2])})', flush=True)
                continue
            if name in OPEN and rows > 0:
                faults = [f'is named in OPEN, and holds: {OPEN[name]}']
            failed += bool(faults)
            greatest.take_all(found, name)
            if faults:
                print(f'FAIL {name}: ' + '; '.join(faults[:4]), flush=True)
    greatest.print()
    print(f'{len(every)} programs, {sampled_any} with motion, {failed} failed')
    return 1 if failed or sampled_any == 0 else 0


if __name__ == '__main__':
    sys.exit(main())
