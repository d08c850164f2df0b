#!/usr/bin/env python3
"""Tests programs in UTF-16: each command gives the same result as for the same program in UTF-8.

    utf16.py --kadr build/kadr

Covers texts with and without the byte order mark, both byte orders, from a file and from a pipe; called files; folders; damaged texts.
"""
import re
import sys

import harness

PROGRAM = '%\r\nO0001 (Карман, сверло 8)\r\nN1 G21 G90 G0 X10 Y20\r\nN2 G1 Z-2 F100 (ход)\r\nN3 X30 M3 S1000\r\nN4 M30\r\n%\r\n'
FAULTY = 'N1 G90 G0 X10\nN2 (сверло) G1 X20 Q5 F100\nN3 G7777\nN4 Г1 X5\nN5 M30\n'
LONG = 'N1 G90 G0 X0\n' + ''.join(f'N{n} G1 X{n % 50} F200 (проход {n} 😀)\n' for n in range(2, 6000)) + 'N6000 X\nN6001 M30\n'
tally = harness.Tally()
FORMS = {
    'le-mark': lambda text: b'\xff\xfe' + text.encode('utf-16-le'),
    'be-mark': lambda text: b'\xfe\xff' + text.encode('utf-16-be'),
    'le': lambda text: text.encode('utf-16-le'),
    'be': lambda text: text.encode('utf-16-be'),
}


class Runs(harness.Kadr):
    def run(self, *args, stdin=b''):
        done = self.call(*args, binary=True, input=stdin)
        return done.returncode, done.stdout, done.stderr

    def expect(self, what, got, wanted):
        tally.same(what, got, wanted)

    def write(self, name, content):
        self.file(name, content)


def commands(runs):
    """One file name, so that messages are equal byte by byte."""
    for title, text in (('program', PROGRAM), ('faulty', FAULTY), ('long', LONG)):
        for command in (('run', 'p.nc', '--trace', '-'), ('run', 'p.nc'), ('check', 'p.nc'), ('check', '--format', 'json', 'p.nc'),
                        ('check', '--lang', 'ru', 'p.nc'), ('setup', 'p.nc')):
            runs.write('p.nc', text)
            wanted = runs.run(*command, '--control', 'mach3')
            for form, encoded in FORMS.items():
                runs.write('p.nc', encoded(text))
                runs.expect(f'{title}, {form}, {command}', runs.run(*command, '--control', 'mach3'), wanted)


def guessed(runs):
    runs.write('p.nc', PROGRAM)
    wanted = runs.run('check', 'p.nc')
    for form, encoded in FORMS.items():
        runs.write('p.nc', encoded(PROGRAM))
        runs.expect(f'guessed, {form}', runs.run('check', 'p.nc'), wanted)


def from_a_pipe(runs):
    """With --control, and when the guess has read the pipe already."""
    runs.write('p.nc', PROGRAM)
    wanted = runs.run('run', 'p.nc')[:2]
    for form, encoded in {'utf-8': str.encode, **FORMS}.items():
        runs.expect(f'guessed from a pipe, {form}', runs.run('run', '-', stdin=encoded(PROGRAM))[:2], wanted)
    wanted = runs.run('run', '-', '--control', 'mach3', '--trace', 't.json', stdin=PROGRAM.encode('utf-8'))
    for form, encoded in FORMS.items():
        runs.expect(f'pipe, {form}', runs.run('run', '-', '--control', 'mach3', '--trace', 't.json', stdin=encoded(PROGRAM)), wanted)


def named(runs):
    """--encoding: a text that cannot be guessed, all but one line Chinese; a byte order mark overrides the option."""
    text = 'N1 G90 G0 X10\nN2 M30\n(' + '銑削' * 400 + ')\n'
    runs.write('p.nc', text)
    wanted = runs.run('run', 'p.nc', '--control', 'mach3', '--trace', '-')
    for name, bytes_ in (('utf-16le', text.encode('utf-16-le')), ('UTF-16BE', text.encode('utf-16-be')),
                         ('utf-16', b'\xfe\xff' + text.encode('utf-16-be')), ('utf16le', b'\xfe\xff' + text.encode('utf-16-be'))):
        runs.write('p.nc', bytes_)
        runs.expect(name, runs.run('run', 'p.nc', '--control', 'mach3', '--trace', '-', '--encoding', name), wanted)
    status, _, err = runs.run('run', 'p.nc', '--control', 'mach3', '--encoding', 'utf-17')
    runs.expect('no such encoding', (status, b'utf-16le' in err), (2, True))


def called_files(runs):
    """nct 14.4: a subprogram by its file name, and one from another shop by the O word in its text."""
    main, by_name, by_word = 'G90 G0 X1\nM98 P10\nM98 P77\nM30\n', 'G1 X5 F100 (ход)\nM99\n', 'O0077 (ход)\nG1 X9\nM99\n'
    for form, encoded in {'utf-8': str.encode, **FORMS}.items():
        folder = f'calls-{form}'
        for name, text in (('m.nc', main), ('O0010.nc', by_name), ('other.nc', by_word)):
            runs.write(f'{folder}/{name}', encoded(text))
        status, out, _ = runs.run('run', f'{folder}/m.nc', '--control', 'nct', '--trace', '-')
        ends = [float(x) for x in re.findall(r'"to": ?\{"X": ?([0-9.]+)', out.decode())]
        runs.expect(f'called, {form}', (status, ends), (0, [1, 5, 9]))


def folders(runs):
    for form, encoded in FORMS.items():
        runs.write(f'dir-{form}/O1001', encoded(PROGRAM))  # without a file ending: recognized by its contents
        status, out, _ = runs.run('check', f'dir-{form}', '--control', 'mach3')
        runs.expect(f'folder, {form}', (status, b'1 program checked' in out), (0, True))


def tapes(runs):
    text = '%\nN1 G90 X100\nN2 M30\n'
    runs.write('p.nc', text)
    wanted = runs.run('tape', 'encode', 'p.nc', '-')
    runs.expect('tape', wanted[0], 0)
    for form, encoded in FORMS.items():
        runs.write('p.nc', encoded(text))
        runs.expect(f'tape, {form}', runs.run('tape', 'encode', 'p.nc', '-'), wanted)


def several_programs(runs):
    text = '%101\nN1 G90 G00 X+1.\nN2 M02\n%102\nN1 G00 X+7.\nN2 M02\n'
    for form, encoded in FORMS.items():
        runs.write('p.nc', encoded(text))
        status, out, _ = runs.run('run', 'p.nc', '--control', 'gost', '--program', '102', '--trace', '-')
        runs.expect(f'several programs, {form}', (status, b'"X":7' in out, b'"X":1,' in out), (0, True, False))


def damaged(runs):
    """Half a surrogate pair, an odd byte: U+FFFD in its place, no crash, no silence."""
    runs.write('p.nc', b'\xff\xfe' + 'N1 G0 X1\nN2 M30 '.encode('utf-16-le') + b'\x3d\xd8' + '\nN3 '.encode('utf-16-le') + b'X')
    status, out, err = runs.run('check', 'p.nc', '--control', 'mach3')
    runs.expect('half a pair', (status, b'p.nc:2:8' in out + err), (1, True))
    runs.write('p.nc', b'\xff\xfe' + 'N1 G0 X1\nN2 X2'.encode('utf-16-le') + b'0')
    status, out, err = runs.run('check', 'p.nc', '--control', 'mach3')
    runs.expect('an odd byte', (status, b'p.nc:2:6' in out + err), (1, True))
    runs.write('p.nc', b'\xff\xfe')
    runs.expect('a mark alone', runs.run('check', 'p.nc', '--control', 'mach3')[0], 0)


def main():
    kadr = harness.kadr_of(__doc__)
    for part in (commands, guessed, from_a_pipe, named, called_files, folders, tapes, several_programs, damaged):
        for fault in harness.in_a_folder(part, kadr, Runs):
            tally.expect(False, part.__name__, fault)
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
