#!/usr/bin/env python3
"""Tests kadr check of folders: what is checked, what is left out, what cannot be read; its report, its baseline.

    run_check.py --kadr build/kadr [--only 'exclude*']

Each check_… function is one check and works in a folder of its own.
Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import json
import os
import subprocess
import sys

import harness
from harness import expect

GOOD = 'G0 X1.5\nM30\n'
FAULTY = 'G0 X1.5\nG0 Q7\nM30\n'
WARNED = 'G0 Х1.5\nM30\n'   # a Cyrillic Х


class Kadr(harness.Kadr):
    language = 'en'

    def file(self, name, content=GOOD):
        return super().file(name, content)

    def check(self, *arguments, expected=0):
        """Returns stdout and stderr of `kadr check`."""
        done = self.run('check', *arguments, expected=expected)
        return done.stdout, done.stderr


def check_which_files_are_programs(kadr):
    for name in ('a.nc', 'b.NGC', 'O1001', 'sub/2.001', 'deep/er/c.tap', 'sub/d.txt'):
        kadr.file(name)
    for name, text in (('README', 'This folder holds programs for the mill.\n'), ('notes.txt', 'Call the customer.\nThen the foreman.\n'),
                       ('.hidden.nc', FAULTY), ('.git/x.nc', FAULTY), ('part.json', '{}'), ('binary', bytes(range(256)) * 20)):
        kadr.file(name, text)
    out, err = kadr.check('.')
    expect(out == '6 programs checked: 0 errors, 0 warnings.\n', out)
    expect('notes.txt: unknown' in err, f'notes.txt is not told: {err}')


def check_names_that_others_use(kadr):
    """PLATE.H is a conversational program by its text, lib.h a header of C."""
    kadr.file('PLATE.H', '0 BEGIN PGM PLATE MM\n1 TOOL CALL 1 Z S2000\n2 L Z+100 R0 FMAX M3\n3 ; Retract far enough for the chips to fall\n4 L Z+2 F500 M30\n'
              '5 END PGM PLATE MM\n')
    kadr.file('lib.h', '#pragma once\n// A header of C.\n#include <string.h>\nint f(int x);\nint g(int y);\n')
    out, err = kadr.check('.')
    expect(out == '1 program checked: 0 errors, 0 warnings.\n' and 'lib.h' not in err, f'{out} {err}')


def check_exclude(kadr):
    for name in ('a.nc', 'old/b.nc', 'x/old/c.nc', 'd.bak.nc'):
        kadr.file(name)
    for patterns, count in ((('old',), 2), (('old/*',), 3), (('*.bak.nc', 'old'), 1), (('?.nc',), 1)):
        out, _ = kadr.check('.', '--control', 'mach3', *[word for pattern in patterns for word in ('--exclude', pattern)])
        expect(out.startswith(f'{count} program'), f'{patterns}: {out}')


def check_control_for(kadr):
    kadr.file('a.nc', 'G0 X1.5\nM30\n')
    kadr.file('shop/b.nct', 'WHILE[1 EQ 2]DO1\nEND1\nG0 X1\nM30\n')
    _, err = kadr.check('.', '--control', 'mach3', expected=1)
    expect('b.nct' in err, err)
    kadr.check('.', '--control', 'mach3', '--control-for', '*.nct=nct')
    kadr.check('.', '--control', 'mach3', '--control-for', 'nothing*=gost', '--control-for', '*shop/*=nct')


def check_strict(kadr):
    kadr.file('a.nc', WARNED)
    kadr.check('a.nc', '--control', 'mach3')
    kadr.check('a.nc', '--control', 'mach3', '--strict', expected=1)


def check_quiet(kadr):
    kadr.file('a.nc', FAULTY)
    out, err = kadr.check('a.nc', '-q', expected=1)
    expect(out == '' and 'looks like' not in err and 'a.nc:2:' in err, f'{out!r} {err!r}')


def check_output_and_baseline(kadr):
    kadr.file('a.nc', FAULTY)
    out, err = kadr.check('.', '--control', 'mach3', '--format', 'json', '--output', 'known.json', expected=1)
    expect(out == '' and err == '', f'{out!r} {err!r}')
    expect(len(json.loads((kadr.folder / 'known.json').read_text())) == 1, 'the report')
    kadr.file('a.nc', '(moved down)\n' + FAULTY)
    out, err = kadr.check('.', '--control', 'mach3', '--baseline', 'known.json')
    expect('1 known finding left out' in out and 'a.nc' not in err, f'{out!r} {err!r}')
    kadr.file('a.nc', FAULTY.replace('M30', 'G0 Q7\nM30'))
    _, err = kadr.check('.', '--control', 'mach3', '--baseline', 'known.json', expected=1)
    expect(err.count('a.nc:') == 1, f'the same fault once more is new: {err}')
    for text in ('', 'x', '{}', '[1]', '[{"file": 1, "id": "x"}]'):
        kadr.file('bad.json', text)
        _, err = kadr.check('.', '--control', 'mach3', '--baseline', 'bad.json', expected=2)
        expect('bad.json' in err, err)
    before = (kadr.folder / 'a.nc').read_text()
    for name in ('a.nc', 'known.json'):
        kadr.check('.', '--control', 'mach3', '--baseline', 'known.json', '--output', name, expected=2)
    expect((kadr.folder / 'a.nc').read_text() == before, 'the program is destroyed')


def check_text_output(kadr):
    kadr.file('a.nc', FAULTY)
    out, err = kadr.check('a.nc', '--control', 'mach3', '--output', 'report.txt', expected=1)
    expect('a.nc:2:' in (kadr.folder / 'report.txt').read_text() and 'a.nc' not in err and out.startswith('1 program'), err)


def check_what_cannot_be_read(kadr):
    kadr.file('a.nc')
    kadr.file('dark/b.nc')
    (kadr.folder / 'loop').symlink_to('.')
    (kadr.folder / 'gone.nc').symlink_to('nowhere')
    kadr.check('.', '--control', 'mach3')
    os.chmod(kadr.folder / 'dark', 0)
    readable = os.access(kadr.folder / 'dark', os.R_OK)   # root may read everything
    out, err = kadr.check('.', '--control', 'mach3', '--format', 'sarif', expected=0 if readable else 2)
    os.chmod(kadr.folder / 'dark', 0o755)
    invocation = json.loads(out)['runs'][0]['invocations'][0]
    expect(invocation['executionSuccessful'] == readable and ('dark' in err) != readable, f'{invocation} {err}')
    _, err = kadr.check('missing.nc', 'a.nc', '--control', 'mach3', '--format', 'sarif', expected=2)
    expect('missing.nc' in err, err)
    kadr.file('readme', 'Nothing but words is here.\n')
    out, err = kadr.check('readme', '--format', 'sarif', expected=2)
    expect('readme: unknown' in err and json.loads(out)['runs'][0]['invocations'][0]['toolExecutionNotifications'], err)


def check_files_of_subprograms(kadr):
    """LinuxCNC: files that contain only O subprograms are called, not run; they need no %."""
    kadr.file('main.ngc', 'G21 F100\no<one> call [5]\nM2\n')
    kadr.file('one.ngc', '(for the main program)\no<one> sub\nG0 X#1\no<one> endsub\n\n')
    kadr.file('two.ngc', 'o100 sub ; the first\nG0 X1\no100 endsub\nO<Two> Sub\nG0 X2\no<two> endsub\n')
    out, err = kadr.check('.', '--control', 'linuxcnc')
    expect(out.startswith('3 programs checked: 0 errors'), out + err)
    kadr.file('one.ngc', 'o<one> sub\nG0 X#1\no<one> endsub\nG0 X3\n')     # a motion after it: a program
    kadr.file('two.ngc', 'o<two> sub\nG0 X2\n')                            # the end of the definition is missing
    kadr.file('three.ngc', '(nothing)\n')
    kadr.file('four.ngc', 'O00300 (of another control)\nG0 X1\n')        # only a number: no word of a definition follows
    _, err = kadr.check('.', '--control', 'linuxcnc', expected=1)
    for name in ('one.ngc', 'two.ngc', 'three.ngc', 'four.ngc'):
        expect(f'{name}:' in err, f'{name} has no end, which is not told: {err}')


def check_the_program_memory(kadr):
    """Called programs are searched in the folder of --files and, for LinuxCNC, in the folders of the ini file that are inside it."""
    kadr.file('jobs/a.ngc', 'G21 F100\no<near> call\no<far> call\nM2\n')
    kadr.file('jobs/b.ngc', 'G21 F100\no<near> call\no<far> call\n(the same)\nM2\n')
    kadr.file('memory/near.ngc', 'o<near> sub\nG1 X1 Z-1\no<near> endsub\n')
    kadr.file('memory/subs/far.ngc', 'o<far> sub\nG1 X2\no<far> endsub\n')
    kadr.file('memory/mill.ini', '[DISPLAY]\nPROGRAM_PREFIX = subs\n')
    kadr.file('setup.json', '{"ini": "mill.ini"}')
    common = ('--control', 'linuxcnc', '--setup', 'setup.json', '-q')
    _, err = kadr.check('jobs/a.ngc', '--control', 'linuxcnc', expected=1)
    expect('o<near>' in err, f'without --files: {err}')
    memory = (*common, '--files', 'memory')
    kadr.check('jobs/a.ngc', *memory)
    kadr.file('tools.toml', '[[tool]]\nnumber = 1\nkind = "flat"\ndiameter = 6\nflutes = 20\nlength = 50\n')
    cut = kadr.run('cut', 'jobs/a.ngc', *memory, '--stock', 'box:-20,-20,-10,20,20,0', '--tools', 'tools.toml', expected=(0, 1))
    expect('o<near>' not in cut.stderr, cut.stderr)
    kadr.run('report', 'jobs/a.ngc', *memory, '--out', 'a.html')
    kadr.run('diff', 'jobs/a.ngc', 'jobs/b.ngc', *memory)
    kadr.run('convert', 'jobs/a.ngc', '--from', 'linuxcnc', '--to', 'linuxcnc', '--setup', 'setup.json', '--files', 'memory', '-q', '--out', 'c.ngc')
    expect(sorted(p.name for p in (kadr.folder / 'memory').iterdir()) == ['mill.ini', 'near.ngc', 'subs'], 'something was written there')
    _, err = kadr.check('jobs/a.ngc', *common, '--files', 'nowhere', expected=2)
    expect('nowhere' in err, err)


def check_a_deep_tree(kadr):
    deep = os.open(kadr.folder, os.O_RDONLY)
    for _ in range(60):   # longer than a path may be
        os.mkdir('d' * 100, dir_fd=deep)
        below = os.open('d' * 100, os.O_RDONLY, dir_fd=deep)
        os.close(deep)
        deep = below
    os.close(deep)
    kadr.file('a.nc')
    out, err = kadr.check('.', '--control', 'mach3', expected=2)
    expect(out.startswith('1 program') and 'too long' in err, f'{out!r} {err[-200:]!r}')
    subprocess.run(['rm', '-rf', str(kadr.folder / ('d' * 100))], check=True)


if __name__ == '__main__':
    sys.exit(harness.main(__doc__, globals(), Kadr))
