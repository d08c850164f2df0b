#!/usr/bin/env python3
"""Tests `kadr setup`, the note about values that no set-up states, and --tool, --zero, --corrector.

    setup_command.py --kadr build/kadr

A template lists what the program uses, worked out by hand; used with the program, it is itself a set-up that `kadr run` accepts. Prints
a line per failure, then `N passed, N failed`. Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import harness


# name, control, program, template without notes, parts of its notes
TEMPLATES = [
    ('tools from comments', 'mach3',
     '(T1 D8 ENDMILL)\nG21 G90 G54\nT1 M6\nG43 H1 Z50\n/G0 X0\nM3 S1000\nG41 D1 G1 X10 Y10 F100\nX20\nG40 X30\nM1\nM30\n',
     {'offsets': {'1': {'length': None, 'radius': 4}}, 'work_offsets': {'G54': {'X': None, 'Y': None, 'Z': None}}, 'skip': [], 'optional_stop': False},
     ['work_offsets.G54: G54 in line 2', 'offsets.1.length: T1, line 4 (H1); fill in', 'offsets.1.radius: T1, line 7; proposed from line 1 "T1 D8 ENDMILL"',
      'skip: / stands in line 5', 'optional_stop: M1 stands in line 10']),
    ('comment beside the call, in Russian letters', 'mach3', 'T3 M6 (ФРЕЗА 12)\nG41 D3 G1 X10 Y10 F100\nX20\nG40 X30\nM30\n',
     {'offsets': {'3': {'radius': 6}}}, ['proposed from line 1 "ФРЕЗА 12"']),
    ('inches', 'mach3', 'G20\n(T1 D=0.5)\nT1 M6\nG41 D1 G1 X10 Y10 F10\nX20\nG40 X30\nM30\n', {'offsets': {'1': {'radius': 6.35}}}, []),
    ('inches of a Fanuc, which is back in millimetres at M30', 'fanuc',
     '(T2 D=0.842 CR=0. - FLAT END MILL)\nG20 G90\nT2 M6\nG41 D2 G1 X10. Y10. F10.\nX20.\nG40 X30.\nM30\n',
     {'offsets': {'2': {'radius': 10.6934, 'corner_radius': 0}}}, ['T2, line 4; proposed from line 1 "T2 D=0.842 CR=0. - FLAT END MILL"']),
    ('a numbered drill in inches', 'haas', 'G20 G90\nT3 M6 (#7 DRILL)\nG1 X1. F10.\nM30\n', {}, ['T3: line 2; diameter 5.1054 by line 2 "#7 DRILL"']),
    ('not sure', 'fanuc', '(T5 6. FLAT ENDMILL)\nG20 G90\nT5 M6\nG41 D5 G1 X10. Y10. F10.\nX20.\nG40 X30.\nT6 M6 (SPOT DRILL)\nM30\n',
     {'offsets': {'5': {'radius': None}}},
     ['offsets.5.radius: T5, line 4 (D5); fill in; not sure: line 1 "T5 6. FLAT ENDMILL"', 'T6: line 7; not sure: line 7 "SPOT DRILL"']),
    ('numbers of offsets are no figures', 'mach3', '(T1 H1 D1)\nT1 M6\nG43 H1 Z5\nM30\n', {'offsets': {'1': {'length': None}}}, ['line 3 (H1)']),
    ('H of another tool than its number', 'nct', '(T7 D=10)\nT7 M6\nG43 H21 Z50\nG41 D22 G1 X10 Y10 F100\nX20\nG40 X30\nM30\n',
     {'offsets': {'21': {'length': None}, '22': {'radius': 5}}}, ['offsets.22.radius: T7, line 4; proposed from line 1']),
    ('turning tools: geometry and wear, the nose where it is compensated, and the figure of a cycle counts as executed', 'fanuc-t',
     '(T0101 DRILL 20)\nG28 U0 W0\nG55 T0101\nG50 S2000\nG96 S150 M3\nG0 X60. Z2.\nG71 U2. R0.5\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G0 X20.\nG1 Z-20.\n'
     'N20 X60.\nT0202\nG42 G0 X20. Z1.\nG1 Z-5. F0.1\nG40 X60.\nM30\n',
     {'offsets': {'1': {'X': None, 'X_wear': None, 'Z': None, 'Z_wear': None},
                  '2': {'X': None, 'X_wear': None, 'Z': None, 'Z_wear': None, 'radius': None, 'tip': None}},
      'work_offsets': {'G55': {'X': None, 'Z': None}}},
     ['offsets.1: T0101 in line 3; fill in how far the tip is', 'half of what the control shows', 'offsets.2: T0202 in line 12',
      'offsets.2.radius: line 13; fill in the nose radius and the number of the imaginary tip', 'T1: line 3; diameter 20 by line 1']),
    ('a branch not taken is told, not looked into', 'nct',
     'G54\n#100=1\nIF[#100EQ1]GOTO10\nG55\nG43 H5 Z1\nN10 G0 X1\nM30\nG56\n',
     {'work_offsets': {'G54': {'X': None, 'Y': None, 'Z': None}}}, ['lines 4–5, 8']),
    ('what stands in the text only is not used', 'nct', '(G55 H7)\nG54\nM30\n', {'work_offsets': {'G54': {'X': None, 'Y': None, 'Z': None}}}, []),
    ('variables read before they are written', 'nct', '#101=5\nG0 X#101 Y#500\nIF[#0EQ#102]GOTO9\nN9 #102=1\nM30\n',
     {'variables': {'#500': None, '#102': None}}, ['#500: read in line 2', '#102: read in line 3']),
    ('variables of mach3', 'mach3', '#1=5\nG0 X#1 Y#2 Z#5221\nM30\n', {'variables': {'#2': None}}, ['#2: read in line 2']),
    ('an extended system', 'nct', 'G54.1 P2\nM30\n', {'work_offsets': {'G54.1 P2': {'X': None, 'Y': None, 'Z': None}}}, []),
    ('zeros by number: G55 is zero 3', 's2c42', '%\nN1 G90 G55 ПС\nN2 G43 Z10000 D2 ПС\nN3 M2 ПС\n',
     {'offsets': {'2': {'length': None}}, 'zeros': {'3': {'X': None, 'Y': None, 'Z': None}}}, ['zeros.3: G55 in line 2']),
    ('axis correctors', 'correctors', '%\nN1 G90 G00 X10 L17\nN2 M02\n', {'correctors': {'17': None}}, ['correctors.17: line 2']),
    ('nothing', 'nct', 'G0 X1\nM30\n', {}, []),
    ('faults are told', 'nct', 'G54\nG999\nG55\nM30\n', {'work_offsets': {'G54': {'X': None, 'Y': None, 'Z': None}, 'G55': {'X': None, 'Y': None, 'Z': None}}},
     ['the program has faults (1)']),
]

# name, control, program, options, the note's list; None: no note
NOTES = [
    ('all of it', 'nct', 'G54\nT1 M6\nG43 H1 Z50\nG41 D2 G1 X10 Y10 F100\nX20\nG40 X30\nM30\n', [], 'G54 (1), H1 (3), D2 (4)'),
    ('stated', 'nct', 'G54\nT1 M6\nG43 H1 Z50\nG41 D2 G1 X10 Y10 F100\nX20\nG40 X30\nM30\n',
     ['--zero', 'G54=X1', '--tool', '1:l0', '--tool', '2:r0'], None),
    ('the radius alone is stated', 'nct', 'G43 H1 Z50\nM30\n', ['--tool', '1:r5'], 'H1 (1)'),
    ('H0 and D0 are no offsets', 'nct', 'G43 H0 Z50\nD0\nM30\n', [], None),
    ('D without compensation is not used', 'nct', 'D1\nG1 X1 F100\nM30\n', [], None),
    ('the program sets it itself', 'nct', 'G10 L10 P1 R50\nG43 H1 Z50\nM30\n', [], None),
    ('the system of power-on is not named', 'nct', 'G0 X1\nM30\n', [], None),
    ('mach3', 'mach3', 'G55\nG43 H2 Z5\nM30\n', [], 'G55 (1), H2 (2)'),
    ('zeros by number', 's2c42', '%\nN1 G90 G55 ПС\nN2 M2 ПС\n', [], 'G55 (2)'),
    ('zeros by number, stated by the code', 's2c42', '%\nN1 G90 G55 ПС\nN2 M2 ПС\n', ['--zero', 'G55=X1'], None),
    ('zeros by number, stated', 's2c42', '%\nN1 G90 G55 ПС\nN2 M2 ПС\n', ['--zero', '3=X1'], None),
    ('another zero', 's2c42', '%\nN1 G90 G55 ПС\nN2 M2 ПС\n', ['--zero', '2=X1'], 'G55 (2)'),
    ('correctors', 'correctors', '%\nN1 G90 G00 X10 L17\nN2 M02\n', [], 'L17 (2)'),
    ('correctors, stated', 'correctors', '%\nN1 G90 G00 X10 L17\nN2 M02\n', ['--corrector', '17=0'], None),
    ('gost', 'gost', '%\nN1 G90 G55\nN2 M02\n', [], 'G55 (2)'),
    ('T of a lathe', 'fanuc-t', 'T0101\nG0 X50. Z2.\nT0203\nM30\n', [], 'T0101 (1), T0203 (3)'),
    ('T of a lathe, one value stated', 'fanuc-t', 'T0101\nG0 X50. Z2.\nM30\n', ['--tool', '1:l-40'], None),
    ('the nose radius of a lathe', 'fanuc-t', 'T0101\nG0 X50. Z2.\nG42 X20.\nG1 Z-5. F0.1\nG40 X60.\nM30\n', ['--tool', '1:l-40'], 'offsets.1.radius (3)'),
]

# control, program, options, machine position at the end: options override the set-up
POSITIONS = [
    ('nct', 'G54 G0 X10\nM30\n', ['--zero', 'G54=X-400,Y-250'], {'X': -390, 'Y': 0, 'Z': 0}),
    ('nct', 'G54.1 P2\nG0 X10\nM30\n', ['--zero', 'G54.1P2=X5'], {'X': 15}),
    ('nct', 'G54 G0 X10\nM30\n', ['--zero', 'common=X1', '--zero', 'G54=X2'], {'X': 13}),
    ('nct', 'G43 H1 Z0\nM30\n', ['--tool', '1:l100,lw-0.5'], {'Z': 99.5}),
    ('mach3', 'G55\nG0 X10\nM30\n', ['--zero', 'G55=X=-5'], {'X': 5}),
    ('mach3', 'G59 P7\nG0 X10\nM30\n', ['--zero', 'G59P7=X7'], {'X': 17}),
    ('s2c42', '%\nN1 G90 G0 G55 X10000 ПС\nN2 M2 ПС\n', ['--zero', 'G55=X3'], {'X': 13}),
    ('s2c42', '%\nN1 G90 G0 G55 X10000 ПС\nN2 M2 ПС\n', ['--zero', '3=X3'], {'X': 13}),
    ('correctors', '%\nN1 G90 G00 X10. L17\nN2 M02\n', ['--corrector', '17=-0.5'], {'X': 9.5}),
]

# name, control, program, lines of the tools file (without the comment after `#`), and what kadr cut still misses for the first
# tool
ASSUMED = 'neither flute_length nor length is given'   # a note: kadr cut assumes usual values
TOOLS = [
    ('mills and a drill', 'mach3', '(T1 D8 ENDMILL)\n(T2 D=8.5 TAPER=118DEG - DRILL)\nT1 M6\nG1 X1 F100\nT2 M6\nG1 X2\nT3 M6 (BALL R3)\nM30\n',
     ['[[tool]]', 'number = 1', 'kind = "flat"', 'diameter = 8', '[[tool]]', 'number = 2', 'kind = "drill"', 'diameter = 8.5', 'angle = 118',
      '[[tool]]', 'number = 3', 'kind = "ball"', 'diameter = 6'], ASSUMED),
    ('nothing said', 'nct', 'T7 M6\nG1 X1 F100\nM30\n', ['[[tool]]', 'number = 7'], 'kind must be'),
    ('a tap is none of the kinds', 'mach3', 'T3 M6 (TAP M8)\nM30\n', ['[[tool]]', 'number = 3', 'diameter = 8'], 'kind must be'),
    ('inches', 'mach3', 'G20\nT1 M6 (.5 IN ENDMILL R.0625)\nM30\n', ['[[tool]]', 'number = 1', 'kind = "bull"', 'diameter = 12.7', 'corner = 1.5875'],
     ASSUMED),
    ('inches of a Fanuc', 'fanuc', 'G20 G90\nT1 M6 (1/2 ENDMILL .030R)\nG1 X1. F10.\nM30\n',
     ['[[tool]]', 'number = 1', 'kind = "bull"', 'diameter = 12.7', 'corner = 0.762'], ASSUMED),
    ('not sure of the size', 'haas', 'G20 G90\nT1 M6 (ENDMILL 10)\nG1 X1. F10.\nM30\n', ['[[tool]]', 'number = 1'], 'kind must be'),
    ('no tool at all', 'mach3', 'G1 X1 F100\nM30\n', [], '[[tool]] tables'),
]


class Runner:
    def __init__(self, kadr, folder):
        self.kadr, self.folder, self.tally = kadr, Path(folder), harness.Tally()
        self.judge = self.tally.judge

    def run(self, command, program, control, *arguments, lang='en'):
        file = self.folder / 'program.nc'
        file.write_text(program, encoding='utf-8')
        return subprocess.run([self.kadr, command, file, '--control', control, '--lang', lang, *arguments], capture_output=True, text=True,
                              timeout=harness.TIME_LIMIT_S)

    def template(self, control, program, expected, notes):
        done = self.run('setup', program, control)
        if done.returncode != 0:
            yield f'status {done.returncode}: {done.stderr.strip()}'
            return
        made = json.loads(done.stdout)
        told = made.pop('notes', [])
        if made != expected:
            yield f'{made}, not {expected}'
        for note in notes:
            if not any(note in line for line in told):
                yield f'no note {note!r} in {told}'
        if not any('not carried out' in note or 'lines ' in note for note in notes) and any('not carried out' in line for line in told):
            yield f'false branches: {told}'
        setup = self.folder / 'setup.json'
        setup.write_text(done.stdout, encoding='utf-8')
        again = self.run('run', program, control, '-q', '--setup', str(setup))
        if again.returncode not in (0, 1) or ': key' in again.stderr:
            yield f'the template is no set-up: {again.stderr.strip()}'
        if 'ё' not in (russian := self.run('setup', program, control, lang='ru').stdout) and notes and not any('а' <= c <= 'я' for c in russian):
            yield f'not in Russian: {russian}'

    def note(self, control, program, options, expected):
        for command in ('run', 'check'):
            done = self.run(command, program, control, '-q', *options)
            lines = [line for line in done.stderr.splitlines() if ' not_stated: ' in line]
            wanted = [] if expected is None else [f'No set-up states {expected}: 0 is taken']
            if [line.split(' not_stated: ')[1] for line in lines] != wanted:
                yield f'{command}: {lines}, not {wanted}'
            if any(' note not_stated' not in line for line in lines):
                yield f'{command}: no note: {lines}'
            if done.returncode != 0:
                yield f'{command}: status {done.returncode}: {done.stderr.strip()}'

    def position(self, control, program, options, expected):
        done = self.run('run', program, control, '-q', '--trace', '-', *options)
        if done.returncode != 0:
            yield f'status {done.returncode}: {done.stderr.strip()}'
            return
        at = json.loads(done.stdout.splitlines()[-1])['machine_position']
        if any(abs(at[axis] - value) > 1e-9 for axis, value in expected.items()):
            yield f'{at}, not {expected}'

    def tools(self, control, program, expected, missing):
        done = self.run('setup', program, control, '--tools')
        if done.returncode != 0:
            yield f'status {done.returncode}: {done.stderr.strip()}'
            return
        lines = [x for x in (line.split('#')[0].rstrip() for line in done.stdout.splitlines()) if x]
        if lines != expected:
            yield f'{lines}, not {expected}'
        file = self.folder / 'tools.toml'
        file.write_text(done.stdout, encoding='utf-8')
        cut = self.run('cut', program, control, '--stock', 'box:0,0,0,10,10,10', '--tools', str(file))
        if (cut.returncode == 2) == (missing == ASSUMED) or missing not in cut.stderr:
            yield f'kadr cut takes it, or says otherwise what is missing: {cut.returncode}, {cut.stderr.strip()}'
        file.write_text(done.stdout.replace('# flute_length = ', 'flute_length = 20 #').replace('# kind = ""', 'kind = "flat" #').replace('# diameter = ', 'diameter = 5 #'),
                        encoding='utf-8')
        cut = self.run('cut', program, control, '--stock', 'box:0,0,0,10,10,10', '--tools', str(file))
        if expected and cut.returncode == 2:
            yield f'filled in, kadr cut does not take it: {cut.stderr.strip()}'

    def file_that_is_there(self):
        file = self.folder / 'there.json'
        file.write_text('mine', encoding='utf-8')
        done = self.run('setup', 'G54\nM30\n', 'nct', '--out', str(file))
        if done.returncode != 2 or file.read_text(encoding='utf-8') != 'mine':
            yield f'status {done.returncode}, {file.read_text(encoding="utf-8")!r}'
        new = self.folder / 'new.json'
        done = self.run('setup', 'G54\nM30\n', 'nct', '--out', str(new))
        if done.returncode != 0 or 'G54' not in json.loads(new.read_text(encoding='utf-8'))['work_offsets']:
            yield f'--out: status {done.returncode}: {done.stderr.strip()}'


def main():
    kadr = harness.kadr_of(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(kadr, folder)
        for name, *row in TEMPLATES:
            runner.judge(f'setup, {name}', runner.template(*row))
        for name, *row in TOOLS:
            runner.judge(f'tools, {name}', runner.tools(*row))
        for name, *row in NOTES:
            runner.judge(f'note, {name}', runner.note(*row))
        for row in POSITIONS:
            runner.judge(f'{row[0]} {" ".join(row[2])}', runner.position(*row))
        runner.judge('--out', runner.file_that_is_there())
    return runner.tally.result()


if __name__ == '__main__':
    sys.exit(main())
