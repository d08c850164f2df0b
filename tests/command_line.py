#!/usr/bin/env python3
"""Tests the command line: help and usage errors in both languages, spelling suggestions, ids in any case, kadr machines.

    command_line.py --kadr build/kadr

The test finds the commands through their own help, so a new command or option without its Russian text fails here. Prints a line per
failure, then `N passed, N failed`. Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import os
import re
import sys
import tempfile

import harness

CYRILLIC = re.compile('[а-яё]', re.I)
LATIN_SENTENCE = re.compile(r'(?<![-\w./<=])[a-z]{3,} (?:[a-z]+ )*[a-z]{3,}')   # two English words in a row

# command line, its language, text that the message contains, text that it does not contain
MISTAKES = [
    ('rnu x.nc', 'en', ["no command 'rnu'", "did you mean 'run'?"], []),
    ('rnu x.nc', 'ru', ['команды «rnu» нет', 'возможно, «run»?', 'Справка: kadr --help'], []),
    ('zzzzzzz', 'en', ["no command 'zzzzzzz'; there are: run, check,"], ['did you mean']),
    ('', 'en', ['a command is missing; there are: run, check,'], []),
    ('', 'ru', ['не указана команда; есть: run, check,'], []),
    ('tape decod x', 'en', ["no command 'decod'; did you mean 'decode'?", 'Help: kadr tape --help'], []),
    ('state', 'ru', ['не указана команда; есть: check, recover'], []),
    ('run PROGRAM --contrl nct', 'en', ["no option '--contrl' of kadr run; did you mean '--control'?"], []),
    ('run --contrl nct', 'en', ["no option '--contrl' of kadr run; did you mean '--control'?"], []),
    ('run --contrl', 'en', ["no option '--contrl' of kadr run; did you mean '--control'?"], []),
    ('run PROGRAM --contrl=nct', 'ru', ['у kadr run нет ключа «--contrl»; возможно, «--control»?'], []),
    ('mill pocket d.txt --tool-diametr 3', 'en', ["no option '--tool-diametr' of kadr mill pocket; did you mean '--tool-diameter'?"], []),
    ('run', 'en', ['PROGRAM is missing: the part program'], []),
    ('run', 'ru', ['не указано УП: управляющая программа', 'Справка: kadr run --help'], []),
    ('run PROGRAM PROGRAM', 'en', ["' is too many: kadr run takes no more"], []),
    ('run PROGRAM PROGRAM', 'ru', ['» — лишнее: kadr run столько не берёт'], []),
    ('mill pocket d.txt --tool-diameter 3 --control nct', 'ru', ['не указано --depth: глубина'], []),
    ('check PROGRAM --format jsn', 'en', ["--format: 'jsn' is none of text, json, sarif; did you mean 'json'?"], []),
    ('check PROGRAM --format jsn', 'ru', ['--format: значения «jsn» нет, есть: text, json, sarif; возможно, «json»?'], []),
    ('run PROGRAM --colour sped', 'en', ["did you mean 'speed'?"], []),
    ('run PROGRAM --encoding cp1252', 'en', ["--encoding: 'cp1252' is none of utf-8, cp1251,", "did you mean 'cp1251'?"], []),
    ('tape encode x --encoding utf-9', 'ru', ['--encoding: значения «utf-9» нет', 'возможно, «utf-8»?'], []),
    ('completion fsh', 'en', ["did you mean 'fish'?"], []),
    ('run PROGRAM --control ntc', 'en', ["no control 'ntc'; there are: ", "did you mean 'nct'?"], []),
    ('run PROGRAM --control ntc', 'ru', ['УЧПУ «ntc» нет; есть: ', 'возможно, «nct»?'], []),
    ('explain s2c43', 'ru', ['УЧПУ «s2c43» нет', 'возможно, «s2c42»?'], []),
    ('run PROGRAM --control nct --machine generik', 'en', ["no machine 'generik'; there are: ", "did you mean 'generic'?"], []),
    ('machines generik', 'ru', ['станка «generik» нет; есть: ', 'возможно, «generic»?'], []),
    ('run PROGRAM --skip 12', 'en', ["--skip: '12': a whole number from 1 to 9 is wanted"], []),
    ('run PROGRAM --skip 12', 'ru', ['--skip: «12»: нужно целое число от 1 до 9'], []),
    ('run PROGRAM --skip 1.5', 'ru', ['--skip: «1.5»: нужно целое число от 1 до 9'], []),
    ('run PROGRAM --rate abc', 'en', ["--rate: 'abc': a number from 1 to 1000000 is wanted"], []),
    ('run PROGRAM --rate nan', 'en', ["--rate: 'nan': a number from 1 to 1000000 is wanted"], []),
    ('run PROGRAM --max-blocks -1', 'ru', ['--max-blocks: «-1»: нужно целое число от 0 до'], []),
    ('mill face d.txt --tool-diameter x --depth 1 --control nct', 'ru', ['--tool-diameter: «x»: нужно число'], ['от']),
    ('run PROGRAM --control', 'en', ['--control: a value is missing: ID'], []),
    ('run PROGRAM --control', 'ru', ['--control: нет значения: ОБОЗНАЧЕНИЕ'], []),
    ('run PROGRAM --trace --why', 'en', ['--trace: a value is missing: FILE'], []),
    ('mill face COVER --tool-diameter 3 --depth 1 --control nct --plunge rmp', 'ru', ['--plunge: значения «rmp» нет, есть: hole,', 'возможно, «ramp»?'], []),
    ('mill face COVER --tool-diameter 3 --depth 1 --control nct --scheme spirl-in', 'en', ["did you mean 'spiral-in'?"], []),
    ('mill face COVER --tool-diameter 3 --depth 1 --control nct --direction left', 'en', ["--direction: 'left' is none of ccw, cw, ПЧС, ЧС"], []),
    ('run PROGRAM --plot a.svg --plot b.svg', 'en', ['--plot is given more than once'], []),
    ('run PROGRAM --plot a.svg --plot b.svg', 'ru', ['--plot: указано больше одного раза'], []),
    ('mill face d.txt --tool-diameter 3 --depth 1 --control nct --hole 1', 'ru', ['--hole: нужно значений: 2'], []),
    ('run PROGRAM --why=x', 'ru', ['--why: значения не имеет'], []),
    ('run PROGRAM --override 1', 'ru', ['--override: 1: нужно СЕКУНДЫ:ПРОЦЕНТ'], []),
    ('run PROGRAM --lang de', 'en', ["--lang: 'de' is none of en, ru"], []),
    ('run PROGRAM --tool x', 'ru', ['--tool x: нужно НОМЕР:'], []),
]

# What may be written in capitals: command line, a part of the expected output (standard output or error)
CAPITALS = [
    ('run PROGRAM --control NCT', 'blocks'),
    ('run PROGRAM --control NcT --machine GENERIC', 'blocks'),
    ('run PROGRAM --control nct --encoding UTF-8', 'blocks'),
    ('explain NCT G41', 'G41'),
    ('check PROGRAM --control NCT --format JSON', '[]'),
    ('check PROGRAM --control-for *.nc=NCT', '0 errors'),
    ('mill pocket COVER --tool-diameter 12 --depth 8 --control NCT', 'read back: the same path'),
    ('mill pocket COVER --tool-diameter 12 --depth 8 --control nct --scheme SPIRAL-IN --direction CW --plunge RAMP', 'read back: the same path'),
    ('machines NCT-VMC', 'X    30000'),
    ('explain nct G41 --lang RU', 'коррекция'),
    ('completion BASH', 'complete '),
]

# --lang anywhere, LANG: arguments, LANG, whether the answer is in Russian
LANGUAGES = [
    (['--lang', 'ru', 'run', '--help'], 'C', True), (['run', '--help', '--lang', 'ru'], 'C', True), (['run', '--lang=ru', '--help'], 'C', True),
    (['--help'], 'ru_RU.UTF-8', True), (['--help'], 'en_US.UTF-8', False), (['--help', '--lang', 'en'], 'ru_RU.UTF-8', False),
    (['mill', '--lang', 'ru', '--help'], 'C', True), (['--lang', 'RU', 'tape', 'decode', '-h'], 'C', True),
    (['--lang', 'ru', 'controls'], 'C', True), (['--lang', 'ru', 'machines'], 'C', True), (['man'], 'ru_RU.UTF-8', True),
]


class Kadr(harness.Kadr):
    def __init__(self, program, folder):
        super().__init__(program, folder)
        self.program_file = self.file('p.nc', 'G21 G90 G0 X1\nM30\n')
        self.cover = harness.ROOT / 'examples/mill/cover.txt'

    def __call__(self, line, lang='C'):
        words = line.split() if isinstance(line, str) else list(line)
        words = [{'PROGRAM': str(self.program_file), 'COVER': str(self.cover)}.get(word, word) for word in words]
        env = {k: v for k, v in os.environ.items() if not k.startswith('LC_')} | {'LANG': lang}
        done = self.call(*words, env=env)
        return done.returncode, done.stdout, done.stderr

    def help(self, command, lang):
        return self([*command, '--help', '--lang', lang])[1]


def sections(page):
    """Returns the titles of a help page, each with its lines."""
    found, title = {}, ''
    for line in page.splitlines():
        if line.endswith(':') and not line.startswith(' '):
            title = line
        found.setdefault(title, []).append(line)
    return found


def commands_of(kadr, command=()):
    yield list(command)
    for line in sections(kadr.help(command, 'en')).get('Commands:', [])[1:]:
        match = re.match(r'  ([a-z]+) ', line)
        if match:
            yield from commands_of(kadr, (*command, match[1]))


def entries(page, titles):
    """Returns the options and commands of a help page: name → description, with wrapped lines joined."""
    found, name = {}, None
    for title in titles:
        for line in sections(page).get(title, [])[1:]:
            match = re.match(r'  (-[^ ]*(?:, -[^ ]+)*|[^ -][^ ]*)(.*)', line) if re.match(r'  [^ ]', line) else None
            if match:
                name = re.search(r'--[a-z-]+|^.*', match[1])[0] if match[1].startswith('-') else match[1]
                found[name] = ''
                value, _, text = match[2].partition('  ')
                found[name] = text.strip()
            elif name and line.startswith(' ' * 20):
                found[name] += ' ' + line.strip()
            elif not line.strip():
                name = None
    return found


def help_faults(kadr, command):
    """Checks that both pages list the same options, commands and examples, each described in the page's language."""
    en, ru = kadr.help(command, 'en'), kadr.help(command, 'ru')
    if CYRILLIC.search(re.sub('ПС|2С42|ЗИГЗАГ|А?СПИР|ШТИП|ЗАСВ|КАС|СПУСК', '', en)):
        yield 'the English page has Russian words'
    for titles in ((['Options:'], ['Ключи:']), (['Commands:'], ['Команды:'])):
        e, r = entries(en, titles[0]), entries(ru, titles[1])
        if list(e) != list(r):
            yield f'{titles[0][0]} {sorted(set(e) ^ set(r))} stand in one page only'
        for name, text in r.items():
            if not CYRILLIC.search(text):
                yield f'{name}: no Russian text: {text!r}'
            if not e.get(name):
                yield f'{name}: no English text'
    e, r = entries(en, ['Arguments:']), entries(ru, ['Что указать:'])
    if len(e) != len(r) or not all(CYRILLIC.search(text) for text in r.values()):
        yield 'the arguments have no Russian text'
    for line in ru.splitlines():
        if line in en.splitlines() and line.strip() and not re.match('  kadr |  -[^ ]*(, -[^ ]*)* [^ ]*$', line):
            yield f'the same in both pages: {line!r}'
        if LATIN_SENTENCE.search(line) and not line.startswith('  kadr ') and not re.search('zigzag|kadr', line):
            yield f'English words: {line!r}'
    last = [page.strip().splitlines()[-1] for page in (en, ru)]
    if last[0].startswith('Exit status') != last[1].startswith('Код возврата'):
        yield 'the exit status stands in one page only'
    longest = max(map(len, (en + ru).splitlines()))
    if longest > 140:
        yield f'a line of {longest} characters'


def checks(kadr):
    commands = list(commands_of(kadr))
    yield 'commands are found', [] if ['mill', 'slot'] in commands and len(commands) > 15 else [commands]
    for command in commands:
        yield 'help of ' + ' '.join(['kadr', *command]), list(help_faults(kadr, command))
    for line, lang, wanted, unwanted in MISTAKES:
        status, out, err = kadr([*line.split(), *([] if '--lang' in line else ['--lang', lang])])
        faults = [f'no {piece!r}' for piece in wanted if piece not in err] + [f'{piece!r}' for piece in unwanted if piece in err]
        faults += [] if status == 2 and not out else [f'status {status}']
        yield f'{line} ({lang})', [f'{fault} in {err!r}' for fault in faults]
    for line, piece in CAPITALS:
        status, out, err = kadr(line)
        yield line, [] if status == 0 and piece in out + err else [f'status {status}, no {piece!r}: {(out + err)[:300]!r}']
    for words, lang, russian in LANGUAGES:
        status, out, _ = kadr(words, lang)
        yield f'{words} {lang}', [] if status == 0 and bool(re.search('[а-яё]{4}', out)) == russian else [out[:200]]
    yield from machine_checks(kadr)


def machine_checks(kadr):
    folder = harness.ROOT / 'machines'
    for lang in ('en', 'ru'):
        out = kadr(['machines', '--lang', lang])[1]
        rows = {line.split()[0]: line for line in out.splitlines()[1:]}
        faults = [] if sorted(rows) == sorted(file.stem for file in folder.glob('*.toml')) else [out]
        for file in folder.glob('*.toml'):
            name = re.search(rf'{lang} = "([^"]+)"', file.read_text())[1]
            faults += [] if name in rows.get(file.stem, '') else [f'{file.stem}: no {name!r}']
        yield f'machines ({lang})', faults
    # compares with machines/mach3-router.toml, whose values are repeated here
    out = kadr('machines')[1]
    yield 'rapid rates', [] if re.search(r'^mach3-router .* X Y 6000|^mach3-router .*A 3600, X Y 6000, Z 3000$', out, re.M) else [out]
    out = kadr('machines mach3-router')[1]
    rows = [line.split() for line in out.splitlines()]
    wanted = [['X', '6000', '0', '…', '900', '400', '8000'], ['Z', '3000', '-120', '…', '0', '300', '6000'],
              ['A', '3600', 'no', 'limits', '300', '6000'], ['tool', 'change', '60', 's']]
    yield 'one machine', [f'no {row} in {out}' for row in wanted if row not in rows]
    kadr.file('own.toml', 'id = "own"\nname = { en = "own", ru = "свой" }\n[axes]\nX = { rapid = 1, limits = [0, 2] }\nspeed = 3\n')
    status, _, err = kadr(['machines', 'own.toml'])
    yield 'an own file with a fault', [] if status == 2 and 'own.toml:5' in err else [err]


def main():
    tally = harness.Tally()
    with tempfile.TemporaryDirectory() as folder:
        for name, faults in checks(Kadr(harness.kadr_of(__doc__), folder)):
            tally.judge(name, faults)
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
