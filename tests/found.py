#!/usr/bin/env python3
"""Tests how kadr prints the findings of a program: the first warning of each id in full, similar ones counted; `--every`, `--disable`, the
set-up's key 'disable'. Every alarm is printed, whatever is disabled.

    found.py --kadr PROGRAM
"""
import json
import sys

import harness
from harness import expect

COUNT = 20
LOUD = 'O1\nT1 M6\nS500 M3\n' + ''.join(f'G0 X{n}. C5.\n' for n in range(1, COUNT + 1)) + 'M30\n'   # a mill without an axis C
FAULTY = 'O1\nG0 X1. C5.\nG777\nG778\nM30\n'
HEAD = 'warning axis_passed_over'


class Kadr(harness.Kadr):
    language = 'en'

    def told(self, *words, expected=0):
        return self.run(*words, '--control', 'fanuc', expected=expected).stderr


def check_each_is_printed_once(kadr):
    kadr.file('p.nc', LOUD)
    for command in (('run', '-q'), ('check',), ('report', '--out', 'p.html')):
        said = kadr.told(*command, 'p.nc')
        expect(said.count(HEAD) == 1, f'{command}: {said}')
        more = [line for line in said.splitlines() if 'more like the one above' in line]
        expect(len(more) == 1 and f'axis_passed_over: {COUNT - 1} more' in more[0] and 'in lines 5, 6, 7, 8, 9, 10, 11, 12, …' in more[0], f'{command}: {said}')


def check_the_count_is_of_all(kadr):
    kadr.file('p.nc', LOUD)
    done = kadr.run('check', 'p.nc', '--control', 'fanuc')
    expect(f'0 errors, {COUNT} warnings' in done.stdout, done.stdout)
    listed = json.loads(kadr.run('check', 'p.nc', '--control', 'fanuc', '--format', 'json').stdout)
    expect(sum(one['id'] == 'axis_passed_over' for one in listed) == COUNT, 'a list for programs has them all')


def check_every(kadr):
    kadr.file('p.nc', LOUD)
    for command in ('run', 'check'):
        said = kadr.told(command, 'p.nc', '--every')
        expect(said.count(HEAD) == COUNT and 'more like' not in said, f'{command}: {said[:300]}')


def check_disable(kadr):
    kadr.file('p.nc', LOUD)
    kadr.file('quiet.json', json.dumps({'disable': ['axis_passed_over']}))
    for more in (('--disable', 'axis_passed_over'), ('--setup', 'quiet.json')):
        for command in (('run', '-q'), ('check',), ('report', '--out', 'p.html')):
            said = kadr.told(*command, 'p.nc', *more)
            expect('axis_passed_over' not in said, f'{command} {more}: {said}')
    done = kadr.run('check', 'p.nc', '--control', 'fanuc', '--disable', 'axis_passed_over')
    expect('0 errors, 0 warnings' in done.stdout, done.stdout)


def check_an_alarm_is_always_told(kadr):
    kadr.file('f.nc', FAULTY)
    said = kadr.told('check', 'f.nc', '--disable', 'code_unknown', expected=1)
    expect(said.count('alarm code_unknown') == 2, said)


def check_a_name_that_none_has(kadr):
    kadr.file('p.nc', LOUD)
    kadr.file('wrong.json', json.dumps({'disable': ['axis_passed']}))
    expect('axis_passed' in kadr.told('check', 'p.nc', '--disable', 'axis_passed', expected=2), 'an option that names none is refused')
    expect('disable' in kadr.told('check', 'p.nc', '--setup', 'wrong.json', expected=2), 'a set-up that names none is refused')


if __name__ == '__main__':
    sys.exit(harness.main(__doc__, globals(), Kadr))
