#!/usr/bin/env python3
"""Tests what people type first: `kadr help run`, `kadr version`, `kadr controls fanuc`, `kadr explain` with an alarm as it is printed,
without a control, by words; and what other programs expect: only data on standard output, silence when the reader closes the pipe.

    usual_words.py --kadr PROGRAM
"""
import json
import subprocess
import sys

import harness
from harness import expect

PROGRAM = 'O1\nG21 G90\nG0 X1. Y2.\nG1 Z-1. F100\nX20.\nM30\n'


class Kadr(harness.Kadr):
    language = 'en'


def check_help(kadr):
    whole, of_run = kadr.printed('--help'), kadr.printed('run', '--help')
    expect(kadr.printed('help') == whole, 'help is --help')
    expect(kadr.printed('help', 'run') == of_run, 'help run is run --help')
    expect(kadr.printed('help', 'tape', 'decode') == kadr.printed('tape', 'decode', '--help'), 'help tape decode')


def check_version(kadr):
    version = kadr.printed('--version')
    expect(version.startswith('kadr ') and kadr.printed('version') == version == kadr.printed('-V'), version)


def check_controls_of_one(kadr):
    expect(kadr.printed('controls', 'fanuc') == kadr.printed('explain', 'fanuc'), 'controls fanuc')
    expect('fanuc' in kadr.printed('controls') and 'grbl' in kadr.printed('controls'), 'controls')


def check_an_alarm_as_it_is_printed(kadr):
    kadr.file('p.nc', 'O1\nG1 X1. F100\nG777\nM30\n')
    said = kadr.run('check', 'p.nc', '--control', 'fanuc', expected=1).stderr
    expect('PS0010' in said, said)
    for words in (('explain', 'fanuc', 'PS0010'), ('explain', 'fanuc', 'ps0010'), ('explain', 'PS0010')):
        expect('IMPROPER G-CODE' in kadr.printed(*words), words)
    expect('error:33' in kadr.printed('explain', 'grbl', 'error:33'), 'an alarm of Grbl')
    kadr.run('explain', 'fanuc', 'PS9999', expected=2)


def check_a_code_without_a_control(kadr):
    said = kadr.printed('explain', 'G41')
    expect('fanuc G41' in said and 's2c42 G41' in said, said[:300])
    expect('no' in kadr.run('explain', 'no_such_thing_at_all', expected=2).stderr, 'nobody knows it')


def check_words(kadr):
    said = kadr.printed('explain', 'fanuc', 'cutter compensation')
    expect('G41' in said and 'compensation' in said, said[:300])
    expect('G41' in kadr.printed('explain', 'fanuc', 'коррекция', '--lang', 'ru'), 'Russian words')
    kadr.run('explain', 'fanuc', 'gobbledygook machine', expected=2)


def check_data_are_alone_on_standard_output(kadr):
    kadr.file('p.nc', PROGRAM)
    done = kadr.run('run', 'p.nc', '--control', 'fanuc', '--trace', '-')
    for line in done.stdout.splitlines():
        json.loads(line)
    expect('motions' in done.stderr and 'motions' not in done.stdout, 'the summary stands on standard error then')
    expect('motions' in kadr.printed('run', 'p.nc', '--control', 'fanuc'), 'else on standard output')


def check_a_reader_that_has_enough(kadr):
    kadr.file('p.nc', 'O1\n' + 'G0 X1.\nG0 X2.\n' * 20000 + 'M30\n')
    for words in (('run', 'p.nc', '--control', 'fanuc', '--trace', '-'), ('explain', 'nct')):
        process = kadr.start(*words, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        process.stdout.readline()
        process.stdout.close()
        said = process.stderr.read().decode()
        process.wait()
        expect('kadr:' not in said, f'{words}: {said}')


def check_a_folder_without_programs(kadr):
    kadr.file('notes.txt', 'Milk, bread and a new broom.\n')
    done = kadr.run('check', '.', expected=2)
    expect('0 error' not in done.stdout, 'nothing was checked, and nothing is said to be in order')


if __name__ == '__main__':
    sys.exit(harness.main(__doc__, globals(), Kadr))
