#!/usr/bin/env python3
"""Tests kadr convert for a user's own control: its M functions by the table [convert] in both directions, and the letters that a text may
contain; keys of the set-up that both controls have.

    convert_own.py --kadr PROGRAM
"""
import argparse
import json
import sys
import tempfile
from pathlib import Path

from conversions.pairs import run
from page_client.client import expect, result

OWN = '''id = "mine"
name = { en = "Own", ru = "Своя" }
extends = "haas"
[convert]
M27 = { nct = "M8", mach3 = "M8", "*" = "M8" }
M28 = "M9"
M51 = { nct = "M61" }
'''
OTHER = '''id = "theirs"
name = { en = "Theirs", ru = "Чужая" }
extends = "nct"
[m]
"61" = { does = "machine_function", en = "air", ru = "воздух" }
'''
PROGRAM = '%\nO1\nG21 G90 G17\nM3 S1000\nG0 X0. Y0. Z5.\nM27\nG1 Z-1. F100.\nM51\nX10.\nM28\nG0 Z5.\nM5\nM30\n%\n'
BACK = 'G21 G90\nM3 S1000\nG0 X0 Y0 Z5\nM8\nG1 Z-1 F100\nX10\nM9\nG0 Z5\nM5\nM30\n'
RUSSIAN = 'G21 G90\n(ФРЕЗА Ø10, щека)\nM3 S1000\nG0 X0 Y0 Z5\nG1 Z-1 F100 (врезание)\nM30\n'


class Place:
    def __init__(self, kadr, folder):
        self.kadr, self.folder = kadr, folder

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding='utf-8')
        return path

    def convert(self, file, source, to, *more):
        out = self.folder / 'out.nc'
        out.unlink(missing_ok=True)
        got = run(self.kadr, 'convert', file, '--from', source, '--to', to, '--out', out, '--lang', 'en', *more)
        return got, out.read_bytes() if out.exists() else b''


def words(text):
    return text.decode('utf-8').split()


def m_functions(place):
    own, other = place.file('own.toml', OWN), place.file('other.toml', OTHER)
    program = place.file('part.nc', PROGRAM.replace('M51\n', ''))
    for to in ('nct', 'mach3', 'linuxcnc', 'fanuc'):
        got, text = place.convert(program, own, to)
        expect(got.returncode == 0 and 'M8' in words(text) and 'M9' in words(text) and 'M27' not in words(text), f'to {to}: {got.stderr} {text}')
    got, text = place.convert(program, own, 'gost')
    expect(got.returncode == 0 and 'M8' in words(text), f'GOST: {got.stderr} {text}')
    back = place.file('back.nc', BACK)
    for source in ('mach3', 'linuxcnc', 'gost'):
        text = BACK if source != 'gost' else '%\nN1 G90 M03 S1000\nN2 G00 X0 Y0 Z500\nN3 M08\nN4 G01 Z-100 F1000\nN5 X10000\nN6 M09\nN7 G00 Z500\nN8 M05\nN9 M30\n'
        back.write_text(text)
        got, text = place.convert(back, source, own)
        expect(got.returncode == 0 and 'M27' in words(text) and 'M28' in words(text) and 'M8' not in words(text), f'from {source}: {got.stderr} {text}')
        got, text = place.convert(back, source, own, '--flat')
        expect(got.returncode == 0 and 'M27' in words(text) and 'M28' in words(text), f'from {source}, written out: {got.stderr} {text}')
    part = place.file('part.nc', PROGRAM)
    got, text = place.convert(part, own, other)
    expect(got.returncode == 0 and 'M61' in words(text), f'one of the machine: {got.stderr} {text}')
    there = place.file('there.nct', text.decode())
    same = run(place.kadr, 'diff', part, there, '--control-a', own, '--control-b', other, '--lang', 'en')
    expect(same.returncode == 0, f'kadr diff knows the tables: {same.stdout}')
    for old, new in (('M61', 'M51'), ('M61', ''), ('M8', 'M7'), ('M9', '')):
        there.write_text(text.decode().replace(old, new))
        got = run(place.kadr, 'diff', part, there, '--control-a', own, '--control-b', other, '--lang', 'en')
        expect(got.returncode == 1, f'{old} as {new}: {got.stdout}')
    own.write_text(OWN.replace('nct = "M61"', 'nct = "M30"'), encoding='utf-8')
    got, text = place.convert(part, own, 'nct')
    expect(got.returncode == 2 and 'M51' in got.stderr and 'M30' in got.stderr and text == b'', f'an end is no function of the machine: {got.stderr}')


def letters(place):
    program = place.file('russian.tap', RUSSIAN)
    got, text = place.convert(program, 'mach3', 'fanuc')
    expect(got.returncode == 0 and b'(FREZA D10, shheka)' in text and text.isascii() and 'written as others: 18' in got.stderr, f'Fanuc has no Russian letters: {got.stderr} {text}')
    got, text = place.convert(program, 'mach3', 'linuxcnc')
    expect(got.returncode == 0 and 'щека' in text.decode() and 'others' not in got.stderr, f'LinuxCNC has: {got.stderr} {text}')
    for name, codec in (('cp1251', 'cp1251'), ('koi8-r', 'koi8-r'), ('cp866', 'cp866')):
        got, text = place.convert(program, 'mach3', 'linuxcnc', '--encoding-out', name)
        expect(got.returncode == 0 and '(ФРЕЗА D10, щека)' in text.decode(codec) and 'others: 1' in got.stderr, f'{name}: {got.stderr} {text}')
        file = place.folder / 'read.ngc'
        file.write_bytes(text)
        same = run(place.kadr, 'diff', program, file, '--control-a', 'mach3', '--control-b', 'linuxcnc')
        expect(same.returncode == 0, f'{name} is read again: {same.stdout}{same.stderr}')
    got, rows = place.convert(program, 'mach3', 's2c42', '--encoding-out', 'iso7')
    tape = place.folder / 'part.tape'
    tape.write_bytes(rows)
    same = run(place.kadr, 'diff', program, tape, '--control-a', 'mach3', '--control-b', 's2c42')
    expect(got.returncode == 0 and same.returncode == 0, f'a tape: {got.stderr} {same.stdout}{same.stderr}')
    own = place.file('old.toml', OTHER.replace('"theirs"', '"theirs"\nencoding = "cp866"'))
    got, text = place.convert(program, 'mach3', own)
    expect(got.returncode == 0 and 'врезание' in text.decode('cp866'), f'the file of the control says it: {got.stderr} {text}')
    expect(place.convert(program, 'mach3', 'fanuc', '--encoding-out', 'koi9')[0].returncode == 2, 'no such encoding')


# What the set-up of each control may state and a conversion to the same control must keep: a set-up that is written without it would not be
# the one with which the programs were proven equal.
CARRIED = {
    'start': {'X': 5.0, 'Z': 20.0}, 'start_frame': 'work', 'override': {'feed': 80.0, 'rapid': 50.0, 'spindle': 110.0},
    'spindle': {'1': {'rpm': 600.0, 'dir': 'cw'}}, 'clock': '2014-05-18T15:32:41', 'tool': 2,
    'machine': {'*': {'rapid': 8000.0, 'acceleration': 900.0, 'jerk_time': 0.04}, 'Z': {'limits': [-400.0, 10.0], 'acceleration': None}},
    'offsets': {'1': {'length': 12.5, 'length_wear': 0.1, 'radius': 4.0, 'radius_wear': -0.02}},
    'skip': [2], 'optional_stop': True}
NCT_ALONE = {'machine': {'X': {'zone3': [-300.0, -200.0], 'switches': [-405.0, 500.0], 'position_error': 0.1}},
             'spindle': {'1': {'name': 'S', 'ranges': [[50.0, 1000.0], [800.0, 4000.0]], 'rpm': 600.0, 'dir': 'ccw'}},
             'offsets': {'1': {'length': 12.5, 'corner_radius': 0.8}}}


def carried_setup(place):
    """A conversion to the same control writes the set-up that it was given."""
    program = place.file('part.nc', '%\nO1\nG21 G90\nG0 X10.\nM30\n%\n')
    there = place.folder / 'there.json'
    for control in ('nct', 'fanuc', 'haas', 'fanuc-t', 'haas-st'):
        for given in [CARRIED, NCT_ALONE] if control == 'nct' else [CARRIED]:
            for key, value in given.items():
                if key == 'offsets' and control in ('fanuc-t', 'haas-st'):
                    value = {'1': {'X': -20.0, 'X_wear': 0.1, 'Z': -50.0, 'radius': 0.8, 'tip': 3}}
                setup = place.file('setup.json', json.dumps({'axes': ['X', 'Z'], key: value} if control.endswith('t') and control != 'nct' else {key: value}))
                if run(place.kadr, 'run', program, '--control', control, '--setup', setup, '-q').returncode == 2:
                    continue   # not a key of this control
                there.unlink(missing_ok=True)
                got, _ = place.convert(program, control, control, '--setup', setup, '--setup-out', there)
                kept = json.loads(there.read_text(encoding='utf-8')).get(key) if there.exists() else got.stderr
                if key == 'offsets' and value != CARRIED[key] and 'X' in value['1']:   # a lathe's set-up knows two names of each
                    value = {'1': {'length': -50.0, 'length_x': -20.0, 'length_x_wear': 0.1, 'radius': 0.8, 'tip_position': 3}}
                expect(kept == value, f'{control}: {key} was {value}, is {kept}')


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True, type=Path)
    given = options.parse_args()
    with tempfile.TemporaryDirectory() as name:
        place = Place(given.kadr.resolve(), Path(name))
        m_functions(place)
        letters(place)
        carried_setup(place)
    return result()


if __name__ == '__main__':
    sys.exit(main())
