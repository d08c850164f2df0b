#!/usr/bin/env python3
"""Tests that no input and no environment makes kadr crash, hang, use too much memory, or leave a broken trace.

    run_robustness.py --kadr build/kadr             all checks
    run_robustness.py --kadr build/kadr --only 'sig*'

Each check_… function below is one check and writes its program into a folder of its own.
Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import json
import os
import random
import subprocess
import sys

import harness
from harness import Failure, expect

MEMORY_LIMIT_MB = 64
CONTROLS = ('s2c42', 'mach3', 'gost', 'correctors', 'nct')


class Kadr(harness.Kadr):
    def __init__(self, program, folder):
        super().__init__(program, folder)
        self.sanitized = subprocess.run(['grep', '-q', '__asan_init', program], check=False).returncode == 0   # grep reads it, not this process: a child's memory would include what this process read

    def run(self, *arguments, expected=(0, 1)):
        """Runs to the end; returns the exit status and the text of stderr. Checks time, memory, signals."""
        with open(self.folder / 'stdout', 'wb') as out, open(self.folder / 'stderr', 'wb') as err:
            process = self.start(*arguments, stdout=out, stderr=err)
        if not harness.until(lambda: harness.ended(process)):
            process.kill()
            process.wait()
            raise Failure(f'{arguments[0]}: no end within {harness.TIME_LIMIT_S} s')
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = code = os.waitstatus_to_exitcode(status)
        text = (self.folder / 'stderr').read_bytes().decode(errors='replace')
        expect(code in expected, f'{" ".join(map(str, arguments[:3]))}: exit status {code}, expected {expected}; {text[:300]}')
        megabytes = usage.ru_maxrss / 1024
        expect(self.sanitized or megabytes < MEMORY_LIMIT_MB, f'{arguments[0]} took {megabytes:.0f} MB')
        return code, text

    def faults(self, file, control, *options):
        """Returns the ids of the faults that `kadr check` finds."""
        self.run('check', file, '--control', control, *options, '--format', 'json', '--quiet', '--lang', 'en')
        return [fault['id'] for fault in json.loads((self.folder / 'stdout').read_text(encoding='utf-8'))]


# ---- files that are not programs

def check_long_line(kadr):
    path = kadr.file('long.nc', 'G0 X1\n')
    with open(path, 'ab') as file:
        for _ in range(64):
            file.write(b' X1' * (1 << 18) + b' ' * (1 << 18))
    expect('line_too_long' in kadr.faults(path, 'mach3'), 'line_too_long is not named')
    kadr.run('run', path, '--control', 'mach3', '--quiet', expected=(1,))


def check_zeros(kadr):
    path = kadr.file('zeros.nc', '')
    os.truncate(path, 20 << 20)
    for control in CONTROLS:
        expect('line_too_long' in kadr.faults(path, control), f'{control}: line_too_long is not named')


def check_junk(kadr):
    path = kadr.file('junk.nc', random.Random(1).randbytes(2 << 20))
    for control in CONTROLS:
        expect(kadr.faults(path, control), f'{control}: no fault')
    kadr.run("run", path, "--quiet", expected=(2,))   # it is no program of any control
    kadr.run('tape', 'decode', path, '/dev/null')


def check_nested_brackets(kadr):
    deep = 100_000
    path = kadr.file('nested.nc', 'F100\n' + 'G1 X' + '[' * deep + '1' + ']' * deep + '\nG1 X' + '[' * 30_000 + '1' + ']' * 30_000 + '\n')
    for control in ('mach3', 'nct'):
        found = kadr.faults(path, control)
        expect('nesting_too_deep' in found, f'{control}: nesting_too_deep is not named, but {found}')


def check_signs_and_functions_in_a_row(kadr):
    path = kadr.file('signs.nc', 'F100\nG1 X' + '[' + '-' * 60_000 + '1]\nG1 X' + 'sin[' * 15_000 + '\nG1 X' + '#' * 60_000 + '1\n')
    for control in ('mach3', 'nct'):
        found = kadr.faults(path, control)
        expect(len(found) >= 3, f'{control}: three faults expected, found {found}')


def check_many_labels(kadr):
    path = kadr.file('labels.nc', 'M98 P99999\nM98 P1\nM30\n' + ''.join(f'O{n}\nM99\n' for n in range(1, 100_001)))
    for control in ('mach3', 'nct'):
        expect(kadr.faults(path, control, '--disable', 'subprogram_uncalled') == [], f'{control}: a program of 100,000 subprograms has no fault')


def check_endless(kadr):
    for n, text in enumerate(('WHILE [1 EQ 1] DO1\nEND1\n', 'N1 GOTO 1\n', 'G65 P1 L99999999\nM30\nO1\nG0 X1\nM99\n')):
        path = kadr.file(f'endless{n}.nc', text)
        expect('endless_program' in kadr.faults(path, 'nct', '--max-blocks', '100000'), f'{text!r}: endless_program is not named')


def check_recursion(kadr):
    path = kadr.file('recursion.nc', 'M98 P1\nM30\nO1\nM98 P1 L99999999\nM99\n')
    for control in ('mach3', 'nct'):
        expect('call_too_deep' in kadr.faults(path, control), f'{control}: call_too_deep is not named')
    for call in ('G65 P1', 'G66 P1', 'G66.1 P1'):
        path = kadr.file('macro_recursion.nc', f'{call}\nG0 X1\nM30\nO1\n{call}\nG0 X2\nM99\n')
        expect('call_too_deep' in kadr.faults(path, 'nct'), f'{call}: call_too_deep is not named')
    path = kadr.file('recursion2.nc', '%\nN1 L01\nN2 M2\nL\nN01001 L01\nN2 M17\nM20\n')
    expect('call_too_deep' in kadr.faults(path, 's2c42'), 'call_too_deep is not named')


def check_half_a_character(kadr):
    path = kadr.file('half.nc', '%\nN1 G1 X1000 F100 ПС\nN2 П'.encode()[:-1])
    expect('bad_encoding' in kadr.faults(path, 's2c42') or kadr.faults(path, 's2c42'), 'no fault')
    path = kadr.file('half_comment.nc', 'G0 X1 (П'.encode()[:-1])
    expect(kadr.faults(path, 'mach3'), 'no fault')


def check_empty(kadr):
    path = kadr.file('empty.nc', '')
    for control in CONTROLS:
        kadr.run('run', path, '--control', control, '--quiet')
        kadr.run('check', path, '--control', control, '--quiet')


# ---- damaged programs of lathes

HAAS_PART = """%
O100
G18 G40 G54 G80 G99
G50 S1600
T101
G96 S150 M03
G00 X50. Z2.
G71 P10 Q40 U0.4 W0.1 D1.5 F0.2
N10 G00 G42 X20.
G01 Z0. F0.1
G03 X30. Z-5. R5.
N40 G01 G40 X46. Z-20.
G70 P10 Q40 F0.1
G76 X26. Z-4. K1.2 D0.4 A60 F2.
G83 Z-30. R2. Q4. F0.1
G80 G97
M30
%
"""


def damaged(lines, chance):
    """Returns the lines with one of them lost, doubled, moved, cut off, or with a character lost, added or replaced."""
    at = chance.randrange(len(lines))
    line, how = lines[at], chance.randrange(7)
    if how == 0:
        return lines[:at] + lines[at + 1:]
    if how == 1:
        return lines[:at] + [line] + lines[at:]
    if how == 2:
        return lines[:at] + lines[at + 1:at + 2] + [line] + lines[at + 2:]
    place = chance.randrange(len(line) + 1)
    added = chance.choice('0123456789.-GXZUWRFTMNPQIKDCAS#[]()%/;,O')
    changed = {3: line[:place], 4: line[:place] + line[place + 1:], 5: line[:place] + added + line[place:]}.get(how, line[:place] + added + line[place + 1:])
    return lines[:at] + [changed] + lines[at + 1:]


def check_damaged_lathe_programs(kadr):
    chance = random.Random(7)
    shaft = harness.ROOT / 'examples/fanuc-t/shaft.nc'
    for control, text in (('fanuc-t', shaft.read_text(encoding='utf-8')), ('haas-st', HAAS_PART)):
        path = kadr.file('whole.nc', text)
        kadr.run('run', path, '--control', control, '--files', kadr.folder, '--quiet', expected=(0,))
        for _ in range(60):
            lines = damaged(text.splitlines(), chance)
            path = kadr.file('damaged.nc', '\n'.join(damaged(lines, chance) if chance.random() < 0.3 else lines) + '\n')
            kadr.run('run', path, '--control', control, '--files', kadr.folder, '--quiet')


def check_lathe_figures_without_their_ends(kadr):
    """A cycle whose P or Q block has lost its number never cuts."""
    for control, text in (('haas-st', HAAS_PART), ('fanuc-t', HAAS_PART.replace('G71 P', 'G71 U1.5 R0.5\nG71 P').replace(' D1.5', '').replace('G42 ', '').replace('G40 X46', 'X46'))):
        for number in ('N10 ', 'N40 '):
            path = kadr.file('lost.nc', text.replace(number, ''))
            found = kadr.faults(path, control)
            expect('figure_block_missing' in found, f'{control} without {number}: {found}')


# ---- files that cannot be read

def check_directory(kadr):
    (kadr.folder / 'folder.nc').mkdir()
    _, text = kadr.run('run', 'folder.nc', '--control', 'mach3', expected=(2,))
    expect('folder.nc' in text, f'the message does not name the folder: {text!r}')


def check_unreadable(kadr):
    path = kadr.file('secret.nc', 'G0 X1\n')
    os.chmod(path, 0)
    if not os.access(path, os.R_OK):   # root may read everything
        _, text = kadr.run('run', path, '--control', 'mach3', expected=(2,))
        expect('secret.nc' in text, f'the message does not name the file: {text!r}')
    _, text = kadr.run('run', 'missing.nc', '--control', 'mach3', expected=(2,))
    expect('missing.nc' in text, f'the message does not name the file: {text!r}')


# ---- interrupted runs (signals and pipes: run_interrupts.py)

def check_disk_full(kadr):
    path = kadr.file('trace_full.nc', 'F1000\n' + 'G1 X1\nG1 X0\n' * 50_000)
    _, text = kadr.run('run', path, '--control', 'mach3', '--trace', '/dev/full', '--quiet', expected=(2,))
    expect('/dev/full' in text, f'the message does not name the trace: {text!r}')
    path = kadr.file('trace_short.nc', 'G0 X1\n')
    _, text = kadr.run('run', path, '--control', 'mach3', '--trace', '/dev/full', '--quiet', expected=(2,))
    expect('/dev/full' in text, f'a short trace: the message does not name it: {text!r}')


def check_trace_into_nothing(kadr):
    path = kadr.file('short.nc', 'G0 X1\n')
    _, text = kadr.run('run', path, '--control', 'mach3', '--trace', 'no/such/folder/trace.jsonl', '--quiet', expected=(2,))
    expect('no/such/folder' in text, f'the message does not name the trace: {text!r}')


if __name__ == '__main__':
    sys.exit(harness.main(__doc__, globals(), Kadr))
