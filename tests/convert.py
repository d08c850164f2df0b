#!/usr/bin/env python3
"""Tests kadr convert with every example of every control to every other: each conversion is proven equal, or refused with the location.
`kadr diff` compares each result with its source again, and must find a changed word in it.

    convert.py --kadr PROGRAM [--every N] [--mutations N] [--again N] [--seed N] [--jobs N]
"""
import argparse
import collections
import json
import random
import re
import sys
import tempfile
from pathlib import Path

from conversions import pairs
from conversions.pairs import EXAMPLES, WITH_NAMES, run
from page_client.client import expect, result

# The least number of conversions that must be proven; fewer is a regression. The others are refused (docs/commands/convert.md).
# S12000 of two Grbl examples does not fit in S of the 2С42 and GOST; formerly the speed limited by $30 was written. A lathe
# program (gost/shaft_turning) cannot become one for a Fanuc or a Haas mill.
LEAST_PROVEN = 264


def every_pair(kadr, folder, given):
    jobs = [(control, file, pairs.setup_of(file), to) for control, file in pairs.examples(WITH_NAMES) for to in WITH_NAMES if to != control][::given.every]
    made = pairs.convert_all(kadr, jobs, folder, given.jobs)
    for one in made:
        expect(one.right(), f'{one.name()}: {one.outcome} {one.said[:300]}')
    proven = [one for one in made if one.proven()]
    if given.table:
        print('\n'.join(table(made)))
    if given.every == 1:
        rows = '\n'.join(re.findall(r'^\| [^|]* (\|.*)$', '\n'.join(table(made)), re.M))
        for page in ('docs/commands/convert.md', 'docs/ru/commands/convert.md'):
            told = '\n'.join(re.findall(r'^\| [^|]* (\|.*)$', (EXAMPLES.parent / page).read_text(encoding='utf-8'), re.M))
            expect(rows in told, f'{page}: its table is another one than --table prints')
    expect(len(proven) >= (LEAST_PROVEN if given.every == 1 else LEAST_PROVEN // given.every // 2), f'proven: {len(proven)} of {len(made)}')
    return proven


def table(made):
    """The table of docs/commands/convert.md: proven and all conversions, from each control to each."""
    counts = collections.Counter((one.control, one.to, one.proven()) for one in made)
    yield f'{sum(one.proven() for one in made)} of {len(made)} proven, {sum("word by word" in one.outcome for one in made)} word by word'
    for control in WITH_NAMES:
        cells = [f'{counts[control, to, True]}/{counts[control, to, True] + counts[control, to, False]}' if to != control else '' for to in WITH_NAMES]
        yield f'| {control} | ' + ' | '.join(cells) + ' |'


def again(kadr, proven, given):
    """`kadr diff` opens both from their files: the written set-up belongs to the program."""
    chosen = random.sample(proven, min(given.again, len(proven)))
    for one, got in zip(chosen, pairs.all_of(lambda one: pairs.diff(kadr, one), chosen, given.jobs)):
        expect(got.returncode == 0, f'{one.name()}: {got.stdout[:300]}{got.stderr[:300]}')


def larger(letter):
    """Increases the number of a word of that letter by more than the rounding of its format."""
    def change(word):
        sign, whole, rest = re.fullmatch(r'[A-Z](-?)(\d*)(\.?\d*)', word).groups()
        step = 2 if '.' in rest else 2000 if letter in 'XYZ' else 1
        return f'{word[0]}{sign}{int(whole or 0) + step:0{len(whole)}}{rest}'
    return change


# The mutations: a pattern of the words, and how such a word is changed.
NUMBER = r'-?\d*\.?\d+\.?'
MUTATIONS = {
    'a coordinate': (rf'[XYZ]{NUMBER}', larger('X')),
    'a feed': (rf'F{NUMBER}', larger('F')),
    'a speed': (rf'S{NUMBER}', larger('S')),
    'an M code gone': (r'M\d+', lambda word: ''),
    'a dwell': (rf'(?<=G4 )[PXE]{NUMBER}|(?<=G04 )[PXE]{NUMBER}', larger('P')),
    'a tool': (r'T\d+', larger('T')),
}


def mutant(text, kind):
    """Returns the text with one word changed, and the original word; comments and expressions stay unchanged."""
    pattern, change = MUTATIONS[kind]
    blank = re.sub(r'\([^)\n]*\)|;.*|\[[^]\n]*\]', lambda gone: ' ' * len(gone.group()), text)
    words = [word for word in re.finditer(rf'(?m)(?:(?<=[ \d])|^)(?:{pattern})(?=[ A-Z\n]|$)', blank) if '#' not in line_of(blank, word)]
    if not words:
        return None
    word = random.choice(words)
    changed = change(word.group())
    return text[:word.start()] + changed + text[word.end():], f'{word.group()} as {changed!r} in {line_of(text, word)!r}'


def line_of(text, word):
    return text[text.rfind('\n', 0, word.start()) + 1:].split('\n', 1)[0]


def mutations(kadr, proven, folder, given):
    """A changed word is found, or has no effect: a repeated feed, an end that comes anyway."""
    jobs = []
    while len(jobs) < given.mutations:
        one, kind = random.choice(proven), random.choice(list(MUTATIONS))
        if made := mutant(one.out.read_text(encoding='utf-8'), kind):
            file = folder / f'mutant_{len(jobs)}.nc'
            file.write_text(made[0], encoding='utf-8')
            jobs.append((one, kind, file, made[1]))

    def outcome(job):
        one, _, file, _ = job
        got = pairs.diff(kadr, one, file)
        if got.returncode == 0 and pairs.course(kadr, file, one.to, one.out_setup()) == pairs.course(kadr, one.out, one.to, one.out_setup()):
            return 'nothing changes'
        return {0: 'not found', 1: 'found'}.get(got.returncode, f'status {got.returncode}: {got.stderr[:300]}')
    counts = collections.Counter()
    for (one, kind, _, what), told in zip(jobs, pairs.all_of(outcome, jobs, given.jobs)):
        counts[f'{kind} {told}'] += 1
        expect(told in ('found', 'nothing changes'), f'{one.name()}: {what}: {told}')
    for what, count in sorted(counts.items()):
        print(count, what, file=sys.stderr)
    found = sum(count for what, count in counts.items() if what.endswith(' found'))
    expect(found > given.mutations // 2, f'changed words: {found}')


# Exact stops of each control: by a modal code, by a non-modal code; none where it has none.
EXACT = {
    's2c42': '% ПС\nN1 G90 G1 X10000 F120 ПС\nN2 G9 X20000 ПС\nN3 G9 Y10000 ПС\nN4 X0 ПС\nN5 Y0 ПС\nN6 M2 ПС\n',
    'gost': '%\nN1 G90 G01 X10000 F1200\nN2 G60 X20000\nN3 G09 Y10000\nN4 X0\nN5 Y0\nN6 M02\n',
    **{control: 'G21 G90\nG1 X10 F120\nG61 X20\nY10\nG64 X0\nY0\nM2\n' for control in ('mach3', 'linuxcnc')},
    **{control: 'G21 G90\nG1 X10. F120.\nG9 X20.\nG61 Y10.\nG64 X0.\nY0.\nM2\n' for control in ('nct', 'fanuc', 'haas')},
}
EXACT_WORDS = r'\bG0?9\b|\bG6[014]\b'


def exact_stops(kadr, folder, given):
    """Exact stops are written with the other control's codes, block by block and in expanded form; a removed or never cancelled one is
    found."""
    jobs = []
    for control, text in EXACT.items():
        file = folder / f'exact_{control}.nc'
        file.write_text(text, encoding='utf-8')
        jobs += [(control, file, to, way) for to in EXACT if to != control for way in ((), ('--flat',), ('--flat', '--way', 'plain'))]

    def convert(numbered):
        number, (control, file, to, way) = numbered
        out = folder / f'exact_{number}.nc'
        got = run(kadr, 'convert', file, '--from', control, '--to', to, '--out', out, '--lang', 'en', *way)
        return pairs.Converted(control, file, None, to, 'written: ' if got.returncode == 0 else 'refused', got.stderr, out)
    made = pairs.all_of(convert, list(enumerate(jobs)), given.jobs)
    mutants = []
    for one in made:
        expect(one.proven() and 'not carried over' not in one.said, f'exact stops: {one.name()}: {one.said[:300]}')
        text = one.out.read_text(encoding='utf-8') if one.proven() else ''
        words = list(re.finditer(EXACT_WORDS, text))
        expect(len(words) >= 2, f'exact stops: {one.name()}: {text}')
        for word in words:
            file = folder / f'exact_mutant_{len(mutants)}.nc'
            file.write_text(text[:word.start()] + text[word.end():], encoding='utf-8')
            mutants.append((one, file, word.group()))

    def outcome(job):
        one, file, _ = job
        return run(kadr, 'diff', one.file, file, '--control-a', one.control, '--control-b', one.to, '--tolerance', pairs.tolerance_of(one.control, one.to), '--lang', 'en').returncode
    for (one, file, word), status in zip(mutants, pairs.all_of(outcome, mutants, given.jobs)):
        # A mode that is in force at power-on, or that the next block repeats, may be removed without effect.
        again = len(re.findall(rf'{word}', one.out.read_text(encoding='utf-8'))) > 1
        expect(status == 1 or (status == 0 and word in ('G61', 'G64') and again), f'exact stops: {one.name()}: without {word} {status} in {file.read_text(encoding="utf-8")}')


# Corner modes of the NCT and Fanuc (slower at inside corners, not slowed down, usual), within a contour and between expanded
# positions.
CORNERS = '''G21 G90 G17 G64
G0 X0. Y0. Z5.
G1 X10. F300.
G62 X20.
Y10.
G3 X10. Y20. I-10. J0.
G63 G1 X0.
G64 Y0.
G62
G52 X1.
X5. Y5.
G52 X0.
G64 X30.
M2
'''


def corner_modes(kadr, folder, given):
    """G62 and G63 are written in expanded blocks; a program with one of them removed is not equal."""
    file = folder / 'corners.nc'
    file.write_text(CORNERS, encoding='utf-8')
    jobs = [(control, to, way) for control, to in (('nct', 'fanuc'), ('fanuc', 'nct')) for way in ((), ('--flat',), ('--flat', '--way', 'plain'))]

    def look(numbered):
        number, (control, to, way) = numbered
        out = folder / f'corners_{number}.nc'
        got = run(kadr, 'convert', file, '--from', control, '--to', to, '--out', out, '--lang', 'en', *way)
        if got.returncode != 0 or 'not carried over' in got.stderr:
            return got.stderr
        text = out.read_text(encoding='utf-8')
        gone = folder / f'corners_gone_{number}.nc'
        gone.write_text(text.replace('G63', ''), encoding='utf-8')
        found = run(kadr, 'diff', file, gone, '--control-a', control, '--control-b', to, '--lang', 'en')
        return '' if 'G62' in text and 'G63' in text and found.returncode == 1 else text
    for job, said in zip(jobs, pairs.all_of(look, list(enumerate(jobs)), given.jobs)):
        expect(said == '', f'corners: {job}: {said[:600]}')


# Subprograms with numbers and names, called from another one, several times, next to a line that must be expanded for the 2С42.
SUBPROGRAMS = {
    'fanuc': 'O0001\nG90 G54\nG0 X0. Y0. Z5.\nM98 P2 L3\nG90 G0 X50.\nM98 P1234\nM30\nO0002\nG91 G1 X5. F200.\n(UP)\nM98 P1234\nG90\nM99\nO1234\nG91 G1 Y2. F100.\nG1 X4. Y1.\nG90\nM99\n',
    'mach3': 'G90 G40\nG0 X0 Y0 Z5\nM98 P100 L2\nM98 P7\nM30\nO100\nG91 G1 X5 F200\nG90\nM99\nO7\nG1 X1 Y1\nM99\n',
    'linuxcnc': 'o<step> sub\nG91 G1 X5 F200\nG90\no<step> endsub\no12 sub\no<step> call\nG1 Y7\no12 endsub\nG90 G40\nG0 X0 Y0 Z5\no<step> call\no12 call\nM2\n',
}
SECTIONS = {'fanuc': (('L02', 'L0203', 'N02001'), 2), 'mach3': (('L07', 'N07001'), 2), 'linuxcnc': (('L12', 'N12001'), 2)}


def sections(kadr, folder):
    """Subprograms become those of the 2С42, before the program, and keep their numbers where these have two digits."""
    for control, text in SUBPROGRAMS.items():
        file = folder / f'sections_{control}.nc'
        file.write_text(text, encoding='utf-8')
        one = pairs.convert(kadr, control, file, 's2c42', folder / f'sections_{control}_out.nc')
        expect(one.outcome == 'written: word by word', f'sections of {control}: {one.outcome} {one.said[:600]}')
        made = one.out.read_text(encoding='utf-8') if one.proven() else ''
        words, ends = SECTIONS[control]
        expect(made.startswith('L\n') and all(word in made for word in words) and made.count(' M17') == ends and made.index(' M2\n') < made.index('%'), f'sections of {control}:\n{made}')
        back = pairs.convert(kadr, 's2c42', one.out, control, folder / f'sections_{control}_back.nc', one.out_setup())
        expect(back.proven(), f'sections back to {control}: {back.outcome} {back.said[:600]}')


def set_ups(kadr, folder):
    """Entries that the other control does not have are left out of its set-up; several channels are refused."""
    file, setup = folder / 'given.ngc', folder / 'given.json'
    file.write_text('G21 G90\nG1 X#100 F100\nG1 Y[#31 * 2]\nM2\n', encoding='utf-8')
    setup.write_text(json.dumps({'variables': {'#100': 7, '#5161': 10, '#5181': 20, '#31': 3}}), encoding='utf-8')
    for to in ('nct', 'fanuc', 'haas', 'mach3'):
        one = pairs.convert(kadr, 'linuxcnc', file, to, folder / f'given_{to}.nc', setup)
        expect(one.proven() and (one.out_setup().read_text(encoding='utf-8').count('#5161') == 0 or to == 'mach3'), f'given variables to {to}: {one.outcome}')
    two = folder / 'two.json'
    two.write_text(json.dumps({'channels': {'2': {'program': 'M30'}}}), encoding='utf-8')
    got = run(kadr, 'convert', EXAMPLES / 'nct' / 'corners.nct', '--from', 'nct', '--to', 'fanuc', '--setup', two, '--lang', 'en')
    expect(got.returncode == 1 and got.stdout == '' and 'not converted' in got.stderr and 'two.json: channels.2' in got.stderr, f'channels: {got.returncode} {got.stderr}')


def wrong_use(kadr, folder):
    flange = EXAMPLES / 's2c42' / 'flange.nc'
    expect(run(kadr, 'convert', flange, '--from', 's2c42').returncode == 2, 'no control to convert to')
    expect(run(kadr, 'convert', flange, '--to', 'nothing').returncode == 2, 'no such control')
    expect(run(kadr, 'convert', folder / 'none.nc', '--to', 'mach3').returncode == 2, 'no such file')
    copy = folder / 'own.nc'
    copy.write_bytes(flange.read_bytes())
    expect(run(kadr, 'convert', copy, '--from', 's2c42', '--to', 'mach3', '--out', copy).returncode == 2 and copy.read_bytes() == flange.read_bytes(), 'onto itself')
    (folder / 'empty.nc').write_text('')
    expect(run(kadr, 'convert', folder / 'empty.nc', '--from', 'mach3', '--to', 'nct').returncode in (0, 1), 'an empty program')
    (folder / 'alarm.nc').write_text('G21\nG1 X10 F0\nG99 X1\nM30\n')
    got = run(kadr, 'convert', folder / 'alarm.nc', '--from', 'mach3', '--to', 'linuxcnc', '--lang', 'en')
    expect(got.returncode == 1 and got.stdout == '', f'a program with an alarm {got.stderr}')
    forced = run(kadr, 'convert', EXAMPLES / 'mach3' / 'bolt_circle.tap', '--from', 'mach3', '--to', 'nct', '--force', '--lang', 'en')
    expect(forced.returncode == 1 and forced.stdout.startswith('(NOT PROVEN'), 'forced: it says so at its top')


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True, type=Path)
    options.add_argument('--every', type=int, default=1)
    options.add_argument('--mutations', type=int, default=40)
    options.add_argument('--again', type=int, default=40, help='number of results that kadr diff compares with their sources')
    options.add_argument('--seed', type=int, default=7)
    options.add_argument('--jobs', type=int, default=2)
    options.add_argument('--table', action='store_true', help='prints the table of docs/commands/convert.md')
    given = options.parse_args()
    random.seed(given.seed)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        wrong_use(given.kadr, folder)
        exact_stops(given.kadr, folder, given)
        corner_modes(given.kadr, folder, given)
        sections(given.kadr, folder)
        set_ups(given.kadr, folder)
        proven = every_pair(given.kadr, folder, given)
        again(given.kadr, proven, given)
        mutations(given.kadr, proven, folder, given)
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
