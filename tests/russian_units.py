#!/usr/bin/env python3
"""Tests that a command's Russian output has Russian units: no Latin `mm`, `mm/min`, `rev/min`, `s`, `inch` after a number or alone. Every
command runs with --lang ru over the examples; `diff` compares each example with a changed copy. `kadr check` runs over a share of the
faulty programs and over programs whose advice contains figures. All Russian texts of controls/*.toml are read too. Words that a person
types (options, files, JSON, programs) are not sentences and are not checked.

    russian_units.py --kadr PROGRAM [--only 'diff*']
"""
import fnmatch
import re
import shutil
import tempfile
import tomllib
from pathlib import Path

import harness
from commands.programs import CONTROLS, EXAMPLES, PROGRAMS, TOOLS, change
from run_faulty import ROOT as FAULTY
from run_faulty import Expected

UNITS = r'(?:mm[³²]?|mil|min|rev|rpm|sec|inch(?:es)?|ipm|deg|tooth|teeth|MB)'
LATIN = re.compile(rf'(?<![\w.\-/<]){UNITS}(?:/{UNITS}|/s)?(?![\w=³²/])|(?<![\w.])\d+(?:\.\d+)? (?:s|h|in)(?![\w=.])')
STOCK = ('--stock', 'box:-20,-20,-10,40,40,5', '--resolution', '2')
DEBUG = 'step\nnext\nwhere\nstate\ncontinue\nquit\n'

EVERY = 8   # every 8th faulty program
WRITTEN_SO = {('alarms.toml', '.contour_unit.hint_ru')}   # units as an SVG file writes them
TOLD_WITH_FIGURES = {   # (control, what the advice is about): the program
    ('fanuc', 'feed_too_large'): 'G21 G90\nG0 X0 Y0 Z5.\nS1000 M3\nG1 Z-1. F150000.\nX10.\nM30\n',
    ('fanuc', 'feed_too_small'): 'G21 G90\nG0 X0 Y0 Z5.\nS1000 M3\nG1 Z-1. F0.5\nX10.\nM30\n',
    ('nct', 'feed_too_large'): 'G21 G90 G95\nG0 X0 Y0 Z5\nS1000 M3\nG1 Z-1 F30\nX10\nM30\n',
    ('fanuc', 'point_forgotten'): 'G21 G90\nG0 X0. Y0. Z5.\nS1000 M3\nG1 Z-1. F100.\nX10.\nY10.\nX30\nX0.\nY0.\nM30\n',
    ('haas', 'point_forgotten'): 'G20 G90\nG0 X0. Y0. Z5.\nS1000 M3\nG1 Z-1. F10.\nX1.\nY1.\nX3\nX0.\nY0.\nM30\n',
}


def programs():
    """Yields (control, path) of the examples."""
    for control in CONTROLS:
        for path in sorted((EXAMPLES / control).glob('*')):
            if path.suffix in PROGRAMS and path.suffix != '.tape':
                yield control, path


def commands(file, changed, control, setup, folder):
    """Yields (name, words, more) of each command that prints sentences."""
    words = ['--control', control, *setup]
    yield 'run', ['run', file, *words, '--max-passes', 2], {}
    yield 'run --why', ['run', file, *words, '--max-passes', 2, '--max-time', 2, '--samples', folder / 's.csv', '--why'], {}
    yield 'check', ['check', file, *words, '--every'], {}
    yield 'diff', ['diff', file, changed, *words], {}
    yield 'cut', ['cut', file, *words, *STOCK, '--tools', folder / 'tools.toml', '--simplify', '0.1', '--out', folder / 'p.stl'], {}
    yield 'report', ['report', file, *words, '--out', folder / 'r.html'], {}
    yield 'setup', ['setup', file, *words], {}
    yield 'debug', ['debug', file, *words], {'input': DEBUG}
    yield 'explain', ['explain', file, *words], {}
    for to in ('gost', 'nct'):
        yield f'convert --to {to}', ['convert', file, '--from', control, *setup, '--to', to, '--explain', '--out', folder / 'c.nc', '--max-passes', 2], {}


def sentences(text, program):
    """Returns the lines that are neither lines of the program nor data."""
    own = {line.strip() for line in program.splitlines()}
    for line in text.splitlines():
        shown = line.strip()
        if shown and shown not in own and not shown.startswith(('{', '[', '"', '(', ';', '%')):
            yield re.sub(r'\([^)]*\)|"[^"]*"', lambda m: m[0] if re.search('[а-яё]', m[0]) else '', line)


def faults(text, program=''):
    return [f'{found[0]!r} in: {line.strip()[:160]}' for line in sentences(text, program) if (found := LATIN.search(line))]


def over_programs(kadr, folder, tally, only):
    for control, path in programs():
        place = folder / control
        shutil.copytree(EXAMPLES / control, place, dirs_exist_ok=True)
        (place / 'tools.toml').write_text(TOOLS, encoding='utf-8')
        changed = place / f'changed{path.suffix}'
        change(path, changed)
        setup = ['--setup', path.with_suffix('.json').name] if path.with_suffix('.json').exists() else []
        program = path.read_bytes().decode('utf-8', 'replace')
        for name, words, more in commands(path.name, changed.name, control, setup, place):
            if fnmatch.fnmatch(name, only):
                done = harness.Kadr(kadr, place).call(*words, '--lang', 'ru', **more)
                tally.judge(f'{name} {control}/{path.name}', faults(done.stdout + done.stderr, program))


def over_checks(kadr, folder, tally):
    for control in CONTROLS:
        for path in sorted((FAULTY / control).glob('*.nc'))[::EVERY]:
            words = Expected(path.with_suffix('.expect')).args
            done = harness.Kadr(kadr, FAULTY / control).call('check', path.name, '--control', control, *words, '--lang', 'ru')
            tally.judge(f'check faulty/{control}/{path.name}', faults(done.stdout + done.stderr, path.read_bytes().decode('utf-8', 'replace')))
    for (control, told), program in TOLD_WITH_FIGURES.items():
        (folder / 'told.nc').write_text(program, encoding='utf-8')
        done = harness.Kadr(kadr, folder).call('check', 'told.nc', '--control', control, '--lang', 'ru')
        tally.judge(f'check {control} {told}', [*faults(done.stderr, program), *([] if told in done.stderr else [f'{told} is not told: {done.stderr}'])])


def over_texts(tally):
    """Checks the texts under `ru` in the alarms' file and in the controls' own files."""
    for path in sorted((harness.ROOT / 'controls').glob('*.toml')):
        def walk(value, where):
            for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
                if isinstance(inner, (dict, list)):
                    walk(inner, f'{where}.{key}')
                elif isinstance(inner, str) and (str(key) in ('ru', 'hint_ru') or str(key).endswith('_ru')):
                    if (path.name, f'{where}.{key}') not in WRITTEN_SO:
                        tally.judge(f'{path.name} {where}.{key}', faults(inner))
        walk(tomllib.loads(path.read_text(encoding='utf-8')), '')


def over_help(kadr, folder, tally):
    for command in ('run', 'check', 'cut', 'diff', 'convert', 'setup', 'mill', 'report', 'serve', 'tape', 'debug', 'explain', 'state', 'controls'):
        done = harness.Kadr(kadr, folder).call(command, '--help', '--lang', 'ru')
        tally.judge(f'{command} --help', faults(done.stdout + done.stderr))
    for drawing in sorted((EXAMPLES / 'mill').glob('*.txt')):
        done = harness.Kadr(kadr, folder).call('mill', drawing, '--control', 'nct', '--task', 'pocket', '--tool-diameter', 6, '--depth', 5, '--out', folder / 'm.nct', '--lang', 'ru')
        tally.judge(f'mill {drawing.name}', faults(done.stdout + done.stderr))


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--only', default='*', help="commands of that name, e.g. 'diff*'")
    options = harness.parsed(parser)
    tally = harness.Tally()
    with tempfile.TemporaryDirectory(prefix='kadr-units-') as place:
        over_programs(options.kadr, Path(place), tally, options.only)
        over_checks(options.kadr, Path(place), tally)
        over_help(options.kadr, Path(place), tally)
    over_texts(tally)
    return tally.result()


if __name__ == '__main__':
    raise SystemExit(main())
