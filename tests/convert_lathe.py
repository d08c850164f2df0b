#!/usr/bin/env python3
"""Tests kadr convert for programs of lathes: X as a diameter, T with its offset, G98 and G99, U and W, threads, the limit of the spindle
speed. In random states of the machine both programs move to the same positions, as their traces show; each text with a typical mistake of a
lathe's conversion in it (X not doubled, another offset, another unit of the feed) is found to be another program.

    convert_lathe.py --kadr PROGRAM [--states N] [--seed N] [--jobs N]
"""
import argparse
import json
import math
import random
import re
import sys
import tempfile
from pathlib import Path

from conversions import pairs
from conversions.pairs import run
from page_client.client import expect, result

SAME = 0.0021  # mm: both texts are rounded

TURN = 'G0 X52. Z2.\nT0101\nG97 S1000 M3\nG1 X40. F0.2\nZ-20.\nX50. Z-30.\nG0 X60. Z5.\nM30\n'
OF_LINUXCNC = 'G21 G90 G18 G7 G95\nT1 M6\nG43 H1\nG97 S1000 M3\nG0 X52 Z2\nG1 X40 F0.2\nZ-20\nG2 X50 Z-25 I5 K0\nG1 X60\nG8\nG1 X25 Z-30\nM5\nM2\n'
# What a program is, the control, the text, and for each target control the words that the result must contain; None: the program is refused.
PROGRAMS = {
    'plain turning': ('fanuc-t', TURN, {'linuxcnc': 'G7 G18 G95 G43 X40.', 'nct': 'G18 G95 G43.7 X40.', 'haas-st': 'T0101 X40.', 'fanuc-t': 'T0101 G99 X40.'}),
    'arcs': ('fanuc-t', 'T0101\nG97 S900 M3\nG0 X20. Z2.\nG1 Z-10. F0.1\nG2 X30. Z-15. I5. K0\nG3 X40. Z-20. R5.\nG1 X60. W-3.\nM30\n',
             {'linuxcnc': 'G2 G3 I5. K-5.', 'nct': 'G2 G3', 'haas-st': 'G2 G3', 'fanuc-t': 'G2 G3'}),
    'two tools and their offsets': ('fanuc-t', 'T0101\nG97 S900 M3\nG0 X40. Z2.\nG1 Z-5. F0.2\nG0 X80. Z50.\nT0100\nT0303\nG0 X30. Z1.\nT0304\nG1 Z-2. F0.1\nG0 X80.\nM30\n',
                                    {'linuxcnc': 'T3 M6 G43', 'nct': 'G43.7', 'haas-st': 'T0101 T0303 T0304', 'fanuc-t': 'T0101 T0303 T0304'}),
    'surface speed with its limit': ('fanuc-t', 'T0101\nG50 S2500\nG96 S180 M3\nG0 X40. Z2.\nG1 Z-5. F0.2\nG97 S600\nX60.\nG96 S150\nG0 X70.\nG1 Z-9. F0.2\nM30\n',
                                     {'linuxcnc': 'G96 D2500 G97', 'nct': 'G92 S2500', 'haas-st': 'G50 S2500', 'fanuc-t': 'G50 S2500'}),
    'feed per minute': ('fanuc-t', 'T0101\nG97 S500 M3\nG98\nG0 X40. Z2.\nG1 Z-5. F120.\nG99 X44. F0.15\nG98 G1 Z-6. F50.\nM30\n',
                        {'linuxcnc': 'G94 G95', 'nct': 'G94 G95', 'haas-st': 'G98 G99', 'fanuc-t': 'G98 G99'}),
    'increments and cycles': ('fanuc-t', 'T0101\nG97 S500 M3\nG0 X60. Z2.\nG71 U2. R1.\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G0 X30.\nG1 Z-10. F0.1\nX40. W-5.\nN20 X60.\nG70 P10 Q20\nG0 U10. W20.\nM30\n',
                              {'linuxcnc': 'X60.', 'nct': 'X60.', 'fanuc-t': 'X60.'}),
    'positions of the machine': ('fanuc-t', 'T0101\nG97 S900 M3\nG0 X40. Z2.\nG1 Z-5. F0.2\nT0100\nG28 U0 W0\nG53 X-20. Z-30.\nM30\n',
                                 {'fanuc-t': 'G28 U0 W0 G53 X-20.', 'haas-st': 'G28 U0 W0 G53'}),
    'a thread': ('fanuc-t', 'T0202\nG97 S400 M3\nG0 X30. Z5.\nG32 Z-20. F1.5\nG0 X40.\nZ5.\nX29.\nG32 X29. Z-20. F1.5 Q90000\nG0 X40.\nM30\n',
                 {'fanuc-t': 'G32 F1.5 Q90000', 'haas-st': 'G32 F1.5 Q90000', 'linuxcnc': None}),
    'a thread of one start': ('fanuc-t', 'T0202\nG97 S400 M3\nG0 X30. Z5.\nG32 Z-20. F1.5\nG0 X40.\nM30\n', {'linuxcnc': 'G33 Z-20. K1.5', 'nct': 'G33 F1.5'}),
    'a taper thread': ('fanuc-t', 'T0202\nG97 S400 M3\nG0 X30. Z5.\nG32 X32. Z-20. F1.5\nG0 X40.\nM30\n', {'linuxcnc': None, 'nct': 'G33 F1.5'}),
    'a lathe of LinuxCNC': ('linuxcnc', OF_LINUXCNC, {'fanuc-t': 'T0101 G99 X40. X50.', 'haas-st': 'T0101 G99 X40. X50.'}),
    'a mill is no lathe': ('fanuc-t', TURN, {'fanuc': None, 'grbl': None}),
}
# Mistakes in what is written: what is wrong, the pattern of a word, and what it becomes. Each is found where the text has the word.
HALF = lambda word: f'X{float(word[1]) / 2:.3f}'
MISTAKES = {
    'X is not doubled': (r'\bX(-?[\d.]+)', HALF),
    'another offset': (r'\bT0101\b', lambda _: 'T0102'),
    'no offset': (r'\b(?:G43(?:\.7)?) H\d', lambda _: ''),
    'no diameters': (r'\bG7\b', lambda _: ''),
    'feed per minute': (r'\bG9[59]\b', lambda word: 'G98' if word[0] == 'G99' else 'G94'),
    'no limit of the speed': (r'\bG(?:50|92) S2500', lambda _: ''),
    'no limit in G96': (r'\bD2500', lambda _: ''),
    'another lead': (r'\b([FK])1\.5\b', lambda word: word[1] + '1.75'),
    'another length of Z': (r'\bZ-20\.', lambda _: 'Z-20.5'),
}


def targets(kadr):
    """The controls that Kadr has, so that the test runs before and after a further lathe is added."""
    return run(kadr, 'controls').stdout


def state(chance):
    """A random state of a machine. Lengths and zeros are true lengths, X included."""
    axes = lambda: {axis: round(chance.uniform(-200, -20), 2) for axis in 'XZ'}
    return {'zero': axes(), 'reference': {'X': round(chance.uniform(5, 40), 2), 'Z': round(chance.uniform(5, 40), 2)}, 'offsets': {n: axes() for n in range(1, 5)}}


def setup_for(control, of, folder):
    """Writes the state in the keys of the control."""
    form = {'linuxcnc': ('length_x', 'length', 1), 'nct': ('length_x', 'length', 2)}.get(control, ('X', 'Z', 1))
    setup = {'work_offsets': {'G54': of['zero']}, 'reference_points': {'1': of['reference']},
             'offsets': {str(n): {form[0]: round(form[2] * one['X'], 4), form[1]: one['Z']} for n, one in of['offsets'].items()}}
    if control == 'nct':
        setup.update({'axes': ['X', 'Z'], 'diameter': {'X': True}, 'parameters': {'N1416#2': 1}})
    file = folder / f'{control}_{random.getrandbits(64):x}.json'
    file.write_text(json.dumps(setup), encoding='utf-8')
    return file


def places(kadr, file, control, setup):
    """Returns the machine coordinates where motions end, without motions of length 0."""
    got = run(kadr, 'run', file, '--control', control, '--setup', setup, '--trace', '-', '--quiet')
    if got.returncode != 0:
        sys.exit(f'{control} {file.read_text()} {setup.read_text()}: {got.stdout[-300:]} {got.stderr}')
    ends = [(0.0, 0.0)]
    for line in got.stdout.splitlines():
        machine = json.loads(line).get('machine')
        end = machine and tuple(machine.get(axis, 0.0) for axis in 'XZ')
        if end and math.dist(end, ends[-1]) > SAME:
            ends.append(end)
    return ends


def held(kadr, one, chance, folder, count):
    """Checks that both programs move to the same positions in `count` states of the machine."""
    for _ in range(count):
        of = state(chance)
        a, b = places(kadr, one.file, one.control, setup_for(one.control, of, folder)), places(kadr, one.out, one.to, setup_for(one.to, of, folder))
        expect(len(a) > 3 and len(a) == len(b) and all(math.dist(p, q) < 2 * SAME for p, q in zip(a, b)),
               f'{one.name()}: other places\n{a}\n{b}\n{one.out.read_text(encoding="utf-8")}')


def mistakes(kadr, one, folder, counts):
    """Plants each mistake in what was written; `kadr diff`, which compares as the proof does, finds it."""
    text = one.out.read_text(encoding='utf-8')
    given = state(random.Random(one.name()))
    sides = [setup_for(one.control, given, folder), setup_for(one.to, given, folder)]

    def differs(file):
        got = run(kadr, 'diff', one.file, file, '--control-a', one.control, '--control-b', one.to, '--setup-a', sides[0], '--setup-b', sides[1],
                  '--tolerance', pairs.tolerance_of(one.control, one.to), '--lang', 'en', *one.rules())
        return got.returncode, got.stdout[:400] + got.stderr[:200]
    status, said = differs(one.out)
    expect(status == 0, f'{one.name()}: {said}\n{text}')
    for what, (pattern, change) in MISTAKES.items():
        found = re.search(pattern, text)
        if not found:
            continue
        file = folder / f'{one.out.stem}_{len(counts)}.nc'
        file.write_text(text[:found.start()] + change(found) + text[found.end():], encoding='utf-8')
        counts.append(what)
        status, said = differs(file)
        expect(status == 1, f'{one.name()}: {what}: not found: {said}\n{file.read_text(encoding="utf-8")}')


def flat(kadr, control, file, folder):
    """A program written out for its own control."""
    out = folder / f'{file.stem}_flat.nc'
    got = run(kadr, 'convert', file, '--from', control, '--to', control, '--flat', '--out', out, '--setup-out', out.with_suffix('.json'), '--lang', 'en')
    return pairs.Converted(control, file, None, control, 'written: ' if got.returncode == 0 else 'refused', got.stderr, out)


NOSE = 'T0101\nG97 S800 M3\nG0 X24. Z2.\nG42 G1 X20. Z0 F0.1\nZ-10.\nX30. Z-20.\nG2 X40. Z-25. R5.\nG1 X50.\nG40 G0 X60. Z5.\nM30\n'


def nose_radius(kadr, folder, known):
    """Compensation of the nose radius is G42 with the offset of T on a lathe. LinuxCNC enters and leaves the contour in another way, so there
    the path of the tip is written, for the stated radius and tip only."""
    file, setup = folder / 'nose.nc', folder / 'nose.json'
    file.write_text(NOSE, encoding='utf-8')
    setup.write_text(json.dumps({'offsets': {'1': {'X': -40, 'Z': -60, 'radius': 0.8, 'tip': 3}}}), encoding='utf-8')
    own = flat(kadr, 'fanuc-t', file, folder)
    expect(own.proven() and 'G42' in own.out.read_text(encoding='utf-8'), f'nose radius as codes: {own.said}')
    made = pairs.convert(kadr, 'fanuc-t', file, 'linuxcnc', folder / 'nose_linuxcnc.ngc', setup)
    expect(made.proven() and 'path of the tool' in made.outcome and 'G42' not in made.out.read_text(encoding='utf-8'), f'nose radius for LinuxCNC: {made.said}')
    told = json.loads(made.out_setup().read_text(encoding='utf-8'))['offsets']['1']
    # LinuxCNC draws the tips with X pointing down: tip 3 of the Fanuc is its orientation 2
    expect(told == {'length': -60.0, 'radius': 0.8, 'length_x': -40.0, 'tip_position': 2.0}, f'the offset of LinuxCNC: {told}')
    machine = {'machine': {'X': {'rapid': 12000, 'limits': [-220, 0]}}, 'chuck_face': -62, 'tailstock': 4}
    setup.write_text(json.dumps({'offsets': {'1': {'X': -40, 'Z': -60, 'radius': 0.8, 'tip': 3}}, **machine}), encoding='utf-8')
    for control in ('linuxcnc', 'haas-st', 'nct'):
        made = pairs.convert(kadr, 'fanuc-t', file, control, folder / f'nose_{control}', setup)
        told = json.loads(made.out_setup().read_text(encoding='utf-8')) if made.proven() else {}
        expect(all(told.get(key) == value for key, value in machine.items()), f'machine, chuck and tailstock for {control}: {made.outcome} {told}')
    bare = pairs.convert(kadr, 'fanuc-t', file, 'linuxcnc', folder / 'nose_bare.ngc')
    expect(bare.outcome == 'refused', f'a radius that no set-up states: {bare.outcome}')


OF_NCT = 'G18 G90 G21 G95\nT1 M6\nG43.7 H1\nG97 S500 M3\nG0 X40. Z2.\nG1 Z-5. F0.2\nG2 X50. Z-10. I5. K0\nG0 X60.\nM30\n'


def diameters_of_nct(kadr, folder):
    """A turning program of the NCT, whose set-up states the diameter and the turning table, becomes one of a lathe."""
    file, setup = folder / 'of_nct.nct', folder / 'of_nct.json'
    file.write_text(OF_NCT, encoding='utf-8')
    setup.write_text(json.dumps({'axes': ['X', 'Z'], 'diameter': {'X': True}, 'parameters': {'N1416#2': 1}}), encoding='utf-8')
    one = pairs.convert(kadr, 'nct', file, 'fanuc-t', folder / 'of_nct_made.nc', setup)
    made = one.out.read_text(encoding='utf-8').split() if one.proven() else []
    expect(one.proven() and all(word in made for word in ('T0101', 'G99', 'X50.', 'I5.')), f'NCT to fanuc-t: {one.outcome} {one.said} {made}')
    if one.proven():
        held(kadr, one, random.Random(1), folder, 2)


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True, type=Path)
    options.add_argument('--states', type=int, default=2)
    options.add_argument('--seed', type=int, default=20261129)
    options.add_argument('--jobs', type=int, default=2)
    given = options.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder, known, counts, proven = Path(name), targets(given.kadr), [], []
        for what, (control, text, wanted) in PROGRAMS.items():
            for to, words in wanted.items():
                if to not in known:
                    continue
                file = folder / f'{what.replace(" ", "_")}_{to}.nc'
                file.write_text(text, encoding='utf-8')
                one = flat(given.kadr, control, file, folder) if to == control else pairs.convert(given.kadr, control, file, to, folder / f'{file.stem}_made.nc')
                expect(one.proven() == (words is not None) and one.right(), f'{what}: {control} to {to}: {one.outcome} {one.said}')
                made = one.out.read_text(encoding='utf-8') if one.proven() else ''
                for word in (words or '').split():
                    expect(word in made.split() or word in made, f'{what}: {control} to {to}: no {word} in\n{made}')
                if one.proven():
                    proven.append(one)
        pairs.all_of(lambda one: held(given.kadr, one, random.Random(f'{given.seed} {one.name()}'), folder, given.states), proven, given.jobs)
        pairs.all_of(lambda one: mistakes(given.kadr, one, folder, counts), proven, given.jobs)
        expect(set(counts) == set(MISTAKES), f'mistakes that no text had: {set(MISTAKES) - set(counts)}')
        diameters_of_nct(given.kadr, folder)
        nose_radius(given.kadr, folder, known)
        print(f'{len(proven)} proven, {len(counts)} mistakes found', file=sys.stderr)
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
