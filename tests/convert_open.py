#!/usr/bin/env python3
"""Tests kadr convert without a set-up: for any work offsets, lengths, radii and reference points of the machine, the other control moves to
the same machine positions, or the program is refused. Positions come from the trace of both, not from Kadr's own comparison.

    convert_open.py --kadr PROGRAM [--states N] [--seed N] [--jobs N]
"""
import argparse
import json
import math
import random
import sys
import tempfile
from pathlib import Path

from conversions import pairs
from page_client.client import expect, result

CONTROLS = ('fanuc', 'haas', 'nct', 'linuxcnc', 'mach3', 'grbl')
SAME = 0.0021  # mm: both texts are rounded

# Programs with machine positions, each with the words that the result must contain for controls that have them.
PROGRAMS = {
    'a tool is changed at the reference point': ('fanuc', 'G0 Z5.\nT2\nG91 G28 Z0 M06\nG90 G0 X10.\nM30\n', 'G28'),
    'machine coordinates between increments': ('haas', 'G0 Z5.\nG91 G1 X1. F100.\nG53 Z0.\nM30\n', 'G53'),
    'lengths by their number': ('fanuc', 'T1 M6\nG0 G54 X0 Y0\nG43 H1 Z50.\nG1 Z-2. F100\nX20.\nG0 Z50.\nG91 G28 Z0\nG28 X0 Y0\nM30\n', 'G28'),
    'a second work system': ('fanuc', 'G54 G0 X0 Y0\nG1 Z-1. F100\nG55 G0 X0 Y0\nG1 Z-1.\nG0 Z10.\nG53 Z0\nM30\n', 'G55'),
    'a second reference point': ('fanuc', 'G0 X5. Z5.\nG91 G30 Z0\nG90 G0 X10.\nM30\n', 'G30'),
    'through a point to the reference point': ('linuxcnc', 'G0 X5 Z5\nG28 X20 Z30\nG0 X1\nM2\n', 'G28'),
    'cuts in machine coordinates': ('linuxcnc', 'G0 X5\nG53 G1 X-20 F100\nG1 X3\nM2\n', 'G53'),
    'home of Mach3': ('mach3', 'G0 X5 Z5\nG28 Z10\nG0 X1\nM30\n', 'G28'),
    'stored positions of Grbl': ('grbl', 'G0 X5 Z5\nG91 G28 Z0\nG90 G0 X1\nM2\n', 'G28'),
    'a side with its radius': ('fanuc', 'G0 X-10. Y-10.\nG1 G41 D1 X0 Y0 F200\nY40.\nX40.\nY0\nX0\nG40 X-10. Y-10.\nM30\n', ''),
    'nothing of the machine': ('fanuc', 'G0 X1. Y2.\nG1 Z-1. F100\nG2 X11. Y12. R10.\nG0 Z10.\nM30\n', ''),
}


def state(chance, tools=(1, 2)):
    """A random state of a machine: everything that no set-up states."""
    axes = lambda least, most: {axis: round(chance.uniform(least, most), 2) for axis in 'XYZ'}
    return {'zeros': {n: axes(-500, -20) for n in range(1, 7)}, 'references': {'1': axes(-40, 40), '2': axes(-40, 40)},
            'offsets': {str(n): {'length': round(chance.uniform(20, 200), 2), 'radius': round(chance.uniform(0.2, 3), 2)} for n in tools}}


def setup_for(control, of, folder):
    """Writes the state as a set-up of the control."""
    zeros = {'work_offsets': {f'G{53 + n}': values for n, values in of['zeros'].items()}}
    setup = {**zeros, 'reference_points': of['references'], **({} if control == 'grbl' else {'offsets': of['offsets']})}
    file = folder / f'{control}_{random.getrandbits(64):x}.json'
    file.write_text(json.dumps(setup), encoding='utf-8')
    return file


def places(kadr, file, control, setup):
    """Returns the machine coordinates where motions end; None if the control stops, or refuses the set-up."""
    got = pairs.run(kadr, 'run', file, '--control', control, '--setup', setup, '--trace', '-', '--quiet')
    if got.returncode == 2:
        sys.exit(f'{control} {setup.read_text()}: {got.stderr}')
    if got.returncode != 0:
        return None
    ends = [(0.0, 0.0, 0.0)]
    for line in got.stdout.splitlines():
        machine = json.loads(line).get('machine')
        end = machine and tuple(machine.get(axis, 0.0) for axis in 'XYZ')
        if end and math.dist(end, ends[-1]) > SAME:
            ends.append(end)
    return ends


def held(kadr, one, chance, folder, count):
    """Checks that both move to the same positions in `count` states; returns how often the source program itself ran to its end."""
    told = 0
    for _ in range(count):
        of = state(chance)
        a = places(kadr, one.file, one.control, setup_for(one.control, of, folder))
        b = places(kadr, one.out, one.to, setup_for(one.to, of, folder))
        if a is None:
            continue
        told += 1
        text = one.out.read_text(encoding='utf-8')
        expect(b is not None and len(a) == len(b) and all(math.dist(p, q) < 2 * SAME for p, q in zip(a, b)),
               f'{one.name()}: other places\n{a}\n{b}\n{text}')
    return told


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True, type=Path)
    options.add_argument('--states', type=int, default=3)
    options.add_argument('--seed', type=int, default=20261127)
    options.add_argument('--jobs', type=int, default=2)
    given = options.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        jobs, words = [], {}
        for what, (control, text, word) in PROGRAMS.items():
            file = folder / f'{what.replace(" ", "_")}.nc'
            file.write_text(text, encoding='utf-8')
            words[file] = word
            jobs += [(control, file, None, to) for to in CONTROLS if to != control]
        made = pairs.convert_all(given.kadr, jobs, folder, given.jobs)
        proven = [one for one in made if one.proven()]
        for one in made:
            expect(one.right(), f'{one.name()}: {one.outcome}')
            if not one.proven():
                print(f'{one.name()}: {one.said.strip()}', file=sys.stderr)
        for one in proven:
            expect(words[one.file] in one.out.read_text(encoding='utf-8'), f'{one.name()}: no {words[one.file]}\n{one.out.read_text()}')
        chance = random.Random(given.seed)
        told = pairs.all_of(lambda one: held(given.kadr, one, random.Random(f'{given.seed} {one.name()}'), folder, given.states), proven, given.jobs)
        expect(chance is not None and sum(told) > len(proven), f'states that tell something: {sum(told)} of {len(proven)} conversions')
        expect(len(proven) * 10 >= len(made) * 7, f'proven: {len(proven)} of {len(made)}')
        print(f'{len(proven)} of {len(made)} proven', file=sys.stderr)
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
