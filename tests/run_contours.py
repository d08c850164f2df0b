#!/usr/bin/env python3
"""Tests contours with cutter radius compensation under rotation, mirroring and both (NCT 15.5, 16): the tool's path is the path of the
plain contour with each point mapped and, where the plane is mirrored, the arcs reversed; an alarm stays the same alarm.

    run_contours.py --kadr build/kadr [--seed 16] [--count 40]
"""
import argparse
import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

from harness import TIME_LIMIT_S

NEAR_MM = 1e-5   # the trace has nine decimals, the program six
OPPOSED = {'arc_cw': 'arc_ccw', 'arc_ccw': 'arc_cw'}
SETUP = {'offsets': {'1': {'radius': 1.5}}, 'parameters': {'N1339': 0.01}}


def contour(choose):
    """Blocks of lines, and arcs that start in any direction; compensated from the second block to the last but one."""
    x, y = 0.0, 0.0
    blocks = ['G90 G17 G40 G0 X-20 Y-7', f'G{choose.choice((41, 42))} D1 G1 X0 Y0 F300']
    for _ in range(choose.randint(2, 7)):
        way, length = math.radians(choose.uniform(-180, 180)), choose.uniform(8, 40)
        x, y = x + length * math.cos(way), y + length * math.sin(way)
        end = f'X{x:.6f} Y{y:.6f}'
        if choose.random() < 0.5:
            blocks.append(f'G1 {end}')
        else:
            blocks.append(f'G{choose.choice((2, 3))} {end} R{length * choose.uniform(0.6, 2) * choose.choice((1, 1, -1)):.6f}')
        if choose.random() < 0.1:
            blocks.append(f'G39 I{choose.uniform(-9, 9):.6f} J{choose.uniform(-9, 9):.6f}')
    return blocks + ['G40 G1 X50 Y70']


def rotation(choose):
    cx, cy, angle = choose.uniform(-30, 30), choose.uniform(-30, 30), choose.choice((90, 180, choose.uniform(-180, 180)))
    s, c = math.sin(math.radians(angle)), math.cos(math.radians(angle))
    return (f'G68 X{cx:.9f} Y{cy:.9f} R{angle:.9f}', lambda p: (cx + (p[0] - cx) * c - (p[1] - cy) * s, cy + (p[0] - cx) * s + (p[1] - cy) * c), False)


def mirror(choose):
    line = choose.uniform(-30, 30)
    if choose.random() < 0.5:
        return f'G51.1 Y{line:.9f}', lambda p: (p[0], 2 * line - p[1]), True
    return f'G51 X{line:.9f} Y0 I-1 J1', lambda p: (2 * line - p[0], p[1]), True


def run(kadr, folder, blocks):
    """Returns the motions and the alarm of a program."""
    program, setup = folder / 'contour.nc', folder / 'setup.json'
    program.write_text('\n'.join(blocks) + '\n', encoding='ascii')
    setup.write_text(json.dumps(SETUP), encoding='ascii')
    made = subprocess.run([kadr, 'run', program, '--control', 'nct', '--setup', setup, '--trace', '-', '-q'], capture_output=True, text=True,
                          timeout=TIME_LIMIT_S)
    lines = [json.loads(line) for line in made.stdout.splitlines()]
    return [line for line in lines if 'to' in line and line['do'] != 'end'], lines[-1].get('id')


def difference(plain, mapped, move, opposed):
    if plain[1] != mapped[1]:
        return f'alarm {plain[1]} became {mapped[1]}'
    if len(plain[0]) != len(mapped[0]):
        return f'{len(plain[0])} motions became {len(mapped[0])}'
    for before, after in zip(plain[0], mapped[0]):
        kind = OPPOSED.get(before['do'], before['do']) if opposed else before['do']
        if kind != after['do'] or abs(before.get('turns', 0) - after.get('turns', 0)) > NEAR_MM:
            return f"{before['do']} of {before['line']} became {after['do']}"
        for key in ('to', 'center'):
            if key in before and math.dist(move((before[key]['X'], before[key]['Y'])), (after[key]['X'], after[key]['Y'])) > NEAR_MM:
                return f"{key} of {before['line']}: {before[key]} became {after[key]}"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--kadr', required=True)
    parser.add_argument('--seed', type=int, default=16)
    parser.add_argument('--count', type=int, default=40)
    options = parser.parse_args()
    choose, failed, whole = random.Random(options.seed), 0, 0
    with tempfile.TemporaryDirectory() as name:
        for _ in range(options.count):
            blocks, outer, inner = contour(choose), mirror(choose), rotation(choose)
            plain = run(options.kadr, Path(name), blocks)
            whole += plain[1] is None
            for maps in ((inner,), (outer,), (outer, inner)):
                wrong = difference(plain, run(options.kadr, Path(name), [block for block, _, _ in maps] + blocks),
                                   lambda p, maps=maps: maps[0][1](p) if len(maps) == 1 else maps[0][1](maps[1][1](p)),
                                   any(opposes for _, _, opposes in maps))
                if wrong:
                    failed += 1
                    print('FAILED ' + ' · '.join([block for block, _, _ in maps] + blocks) + f': {wrong}')
    if whole < options.count / 4:
        failed += 1
        print(f'FAILED: only {whole} of {options.count} contours run to their end')
    print(f'{3 * options.count - failed} passed, {failed} failed')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
