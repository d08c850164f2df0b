#!/usr/bin/env python3
"""Tests that the minimum-time planner and its samples end, or report why they do not.

    planned_ends.py --kadr build/kadr

Reversals on the same line, of any length and anywhere, take no longer than with a stop at each corner; samples end with them.
A dwell of three years ends at --max-time with a message, and the output so far is kept. Expected values are worked out by hand.
"""
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import harness

X = {'mach3-router': (100, 400, 8000), 'linuxcnc-sim': (200, 1000, 20000)}  # mm/s, mm/s², mm/s³ of the machine files


def rest_to_rest(way, feed, machine):
    """nct 7.0: returns the time in s of a single line from stop to stop."""
    speed, a, j = X[machine]
    v = min(feed, speed)
    reached = min(a, math.sqrt(v * j))
    ramp = v / reached + reached / j
    if way >= v * ramp:
        return way / v + ramp
    if way < 2 * a ** 3 / j ** 2:
        return (32 * way / j) ** (1 / 3)
    t = a / j
    v = a / 2 * (math.sqrt(t * t + 4 * way / a) - t)
    return 2 * (v / a + t)


REVERSALS = [  # positions on X; the last blocks of the issue's program
    lambda d: [10, 10 - d],
    lambda d: [d, 0, 5],
    lambda d: [10, 10 - d, 20],
    lambda d: [4, 4 - d, 4, 4 - d, 4, 9],
]
STEPS = [0.0001, 0.001, 0.01, 0.1, 1]


def reversals():
    for machine in X:
        for code, feed in (('G1', 10), ('G0', 1e9)):
            for number, places in enumerate(REVERSALS):
                for d in STEPS:
                    text = f'G90 {code} F600 ' + '\n'.join(f'X{x:.4f}' for x in places(d)) + '\nM30\n'
                    ways = [abs(b - a) for a, b in zip([0] + places(d), places(d))]
                    yield f'{machine} {code} {number} {d}', machine, text, sum(rest_to_rest(way, feed, machine) for way in ways)


class Bench:
    def __init__(self, kadr, folder):
        self.kadr, self.folder, self.tally = kadr, Path(folder), harness.Tally()

    def check(self, name, good, why=''):
        self.tally.expect(good, name, why)

    def run(self, text, machine, *options):
        (self.folder / 'p.nc').write_text(text)
        command = [self.kadr, 'run', 'p.nc', '--control', 'mach3', '--machine', machine, *options]
        return subprocess.run(command, capture_output=True, text=True, cwd=self.folder, timeout=harness.TIME_LIMIT_S)


def of_reversals(bench):
    for name, machine, text, longest in reversals():
        run = bench.run(text, machine, '-q', '--samples', 'out.csv', '--max-time', '20')
        rows = (bench.folder / 'out.csv').read_text().splitlines()
        bench.check(name, run.returncode == 0 and not run.stderr, f'status {run.returncode}: {run.stderr[:200]}')
        bench.check(name, float(rows[-1].split(',')[0]) <= 1.02 * longest + 0.002, f'{rows[-1]}, at rest at each corner {longest:.4f} s')


def of_the_issue(bench):
    """10 mm at 10 mm/s, and ramps of 10/400 + 400/8000 s."""
    run = bench.run('G90 G1 F600 X10\nX9.999\nM30\n', 'mach3-router', '--samples', 'out.csv')
    bench.check('summary', 'least time      0:01.1 ' in run.stdout, run.stdout)


def of_a_long_dwell(bench):
    for lang, word in (('en', 'The samples end after 3 s'), ('ru', 'Отсчёты положений закончены через 3 с')):
        run = bench.run('G0 X1\nG4 P99999999\nM30\n', 'linuxcnc-sim', '-q', '--samples', 'out.csv', '--max-time', '3', '--lang', lang)
        rows = (bench.folder / 'out.csv').read_text().splitlines()
        bench.check('dwell', run.returncode == 1, f'status {run.returncode}')
        bench.check('dwell', 'p.nc:2:1: ' in run.stderr and 'samples_too_long' in run.stderr and word in run.stderr, run.stderr)
        bench.check('dwell', len(rows) == 1 + 3001 and rows[-1].startswith('3.000000,1.0'), f'{len(rows)}, {rows[-1]}')


def of_usage(bench):
    for value in ('-1', 'x'):
        run = bench.run('M30\n', 'linuxcnc-sim', '--samples', 'out.csv', '--max-time', value)
        bench.check(f'--max-time {value}', run.returncode == 2, f'status {run.returncode}')


def main():
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(harness.kadr_of(__doc__), folder)
        for part in (of_the_issue, of_reversals, of_a_long_dwell, of_usage):
            part(bench)
    return bench.tally.result()


if __name__ == '__main__':
    sys.exit(main())
