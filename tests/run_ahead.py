#!/usr/bin/env python3
"""Tests that the control gives the same results in a thread ahead of the rooms after it (cli/run_ahead) as in one thread: on one processor,
where it runs as far ahead at once, and on several, many times. Trace, summary, messages and exit status are equal, byte by byte.

    run_ahead.py --kadr build/kadr [--runs 6]

The programs are long enough for many batches: compensated contours with a fault of the path, of the control and of a word in the
middle; warnings; a clock; dwells, codes and stops between the motions; a loop.
"""
import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from harness import TIME_LIMIT_S

SETUP = '{"offsets": {"1": {"radius": 2}}}'
BLOCKS = 3000
SMALL_ARC = ['G91 G3 X1 Y0 I0.5 J0', 'G90']  # smaller than the tool


def stairs(count, first=0):
    """A contour of lines and arcs that goes up in steps."""
    blocks = []
    for i in range(first, first + count // 4):
        x = y = 18 * i
        blocks += [f'G1 X{x + 10} Y{y}', f'G3 X{x + 18} Y{y + 8} I0 J8', f'G1 Y{y + 10}', f'G1 X{x + 18} Y{y + 18}']
    return blocks


def program(middle, count=BLOCKS):
    """Steps with cutter compensation, with further blocks in the middle."""
    half = count // 8 * 4
    start = ['G21 G90 G17 G40', 'G0 X-20 Y-20', 'G41 D1 G1 X0 Y0 F500']
    return start + stairs(half) + middle + stairs(half, half // 4) + ['G40 G1 X-50 Y9999', 'M30']


def nct():
    end = BLOCKS // 8 * 18
    yield 'sound', program([])
    for more in (0, 4, 40, 200, 252, 300):  # the fault at many positions of a batch
        yield f'no_intersection_{more}', program(SMALL_ARC, BLOCKS + 2 * more)
    yield 'zero_radius_arc', program(['G2 X1 Y1 I0 J0'])
    yield 'unknown_code', program(['G199'])
    yield 'unknown_word', program(['G1 X1 !'])
    yield 'warnings', program(['G1 Х5'] * 3)
    yield 'messages', program(['#3000=5 (STOP HERE)'])
    yield 'clock', program(['#1=#3001', f'G1 X[{end}+#1*0]'])
    yield 'zone', program(['G22 X1 Y1 Z1 I0 J0 K0 P0']) + ['G40 G0 X-9 Y-9', 'Z5', 'Z0']
    yield 'zone_met', program(['G22 X9999 Y15000 Z100 I0 J0 K0 P1'])
    yield 'dwell', program(['G4 P0.5'] * 70)
    yield 'codes', program(['M8', 'M9', 'S500 M3'] * 50)
    yield 'stop', program(['M0', 'M1'])
    yield 'no_end', program([])[:-2]
    yield 'repeated', ['#1=0', 'G90 G0 X-20 Y-20', 'WHILE[#1 LT 400]DO1', 'G41 D1 G1 X0 Y0 F500', 'X10', 'Y10', 'G40 X-20 Y-20', '#1=#1+1', 'END1', 'M30']
    yield 'gouged', ['G90 G0 X-20 Y-20', 'G41 D1 G1 X0 Y0 F500', *stairs(900), 'G1 X4060', 'G1 Y4051', 'G1 X4050', 'Y4200', 'G40 X0', 'M30']


def mach3():
    yield 'sound', [*program([])[:-2], 'G40', 'M30']
    yield 'gouged', program(['G1 X9 Y9', 'G2 X10 Y10 R0.8'])
    yield 'unknown_code', program(['G199'])


def outcome(kadr, command, one_processor):
    def alone():
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    made = subprocess.run([kadr, *command], capture_output=True, timeout=TIME_LIMIT_S, preexec_fn=alone if one_processor else None)
    return made.returncode, made.stdout, made.stderr


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--kadr', required=True)
    parser.add_argument('--runs', type=int, default=6)
    options = parser.parse_args()
    kadr, failed, cases = str(Path(options.kadr).resolve()), [], 0
    with tempfile.TemporaryDirectory() as folder:
        setup = Path(folder, 'setup.json')
        setup.write_text(SETUP, encoding='ascii')
        for control, programs in (('nct', nct()), ('mach3', mach3())):
            for name, blocks in programs:
                path = Path(folder, f'{control}_{name}.nc')
                path.write_text('\n'.join(blocks) + '\n', encoding='utf-8')
                for command in (['run', '--trace', '-'], ['run'], ['check']):
                    whole = [command[0], path, '--control', control, '--setup', setup, *command[1:]]
                    cases += 1
                    expected = outcome(kadr, whole, True)
                    if any(outcome(kadr, whole, False) != expected for _ in range(options.runs)):
                        failed.append(f'{control} {name}: {" ".join(command)}')
    print(f'{cases} commands, {len(failed)} differ')
    for line in failed:
        print('  ' + line)
    sys.exit(1 if failed else 0)


if __name__ == '__main__':
    main()
