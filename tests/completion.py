#!/usr/bin/env python3
"""Tests the completion of the command line as bash, fish and zsh would request it, and the manual page.

    completion.py --kadr build/kadr

bash runs: the test sources the script, sets COMP_WORDS and calls the script's function. fish and zsh, where installed, parse their
scripts. Prints a line per failure, then `N passed, N failed`. Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import re
import shutil
import subprocess
import sys
import tempfile

import harness

told = set()  # not checked here

# the line up to the cursor, what must be offered, what must not
LINES = [
    ('kadr ', 'run check machines mill completion', 'p.nc'),
    ('kadr ma', 'machines man', 'run'),
    ('kadr tape ', 'decode encode', 'run'),
    ('kadr state rec', 'recover', 'check'),
    ('kadr mill ', 'pocket face slot', ''),
    ('kadr mill pocket --to', '--tool-diameter --tool --top', '--width'),
    ('kadr mill slot --wi', '--width', ''),
    ('kadr run --con', '--control', '--control-for'),
    ('kadr check --con', '--control --control-for', ''),
    ('kadr run p.nc --control ', 'nct gost own.toml', 'p.nc setup.json'),
    ('kadr run p.nc --control NC', 'nct', 'gost'),
    ('kadr run --machine mach', 'mach3-router', 'generic'),
    ('kadr run --encoding cp', 'cp1251 cp866', 'utf-8'),
    ('kadr run --colour ', 'speed limit', 'p.nc'),
    ('kadr check --format ', 'text json sarif', 'p.nc'),
    ('kadr check --format = j', 'json', 'text'),
    ('kadr run --lang ', 'en ru', 'p.nc'),
    ('kadr --lang ru ru', 'run', 'p.nc'),
    ('kadr run --setup ', 'setup.json sub', 'p.nc own.toml'),
    ('kadr run --rate ', '', 'p.nc sub'),
    ('kadr run --trace ', 'p.nc sub', 'nct'),
    ('kadr run --files ', 'sub', 'p.nc'),
    ('kadr run --plot ', 'old.svg sub', 'p.nc'),
    ('kadr run ', 'p.nc sub', 'nct'),
    ('kadr tape decode --code ', 'iso eia', ''),
    ('kadr explain ', 'nct s2c42', 'G41'),
    ('kadr explain nct G4', 'G40 G41 G43', 'M3'),
    ('kadr explain NCT g41', 'G41', ''),
    ('kadr explain s2c42 L8', 'L81 L83', 'G41'),
    ('kadr machines nct', 'nct-vmc', 'nct'),
    ('kadr completion ', 'bash zsh fish', 'p.nc'),
    ('kadr mill pocket d.dxf --mark ', 'ПС LF', ''),
]


def bash_offers(script, line, program, folder):
    words = line.split(' ')
    words[0] = str(program)
    quoted = ' '.join("'" + word + "'" for word in words)
    ask = f'. {script}\nCOMP_WORDS=({quoted}); COMP_CWORD={len(words) - 1}; complete -p kadr >/dev/null && _kadr; printf "%s\\n" "${{COMPREPLY[@]}}"'
    done = subprocess.run(['bash', '--norc', '-c', ask], capture_output=True, text=True, cwd=folder, timeout=harness.TIME_LIMIT_S, check=False)
    return done.stdout.split(), done.stderr


def completion_checks(kadr, program, folder):
    for name in ('p.nc', 'setup.json', 'own.toml', 'old.svg'):
        (folder / name).write_text('')
    (folder / 'sub').mkdir()
    for lang in ('en', 'ru'):
        scripts = {shell: folder / f'sub/kadr.{shell}' for shell in ('bash', 'zsh', 'fish')}
        for shell, script in scripts.items():
            script.write_text(kadr('completion', shell, '--lang', lang))
            if not shutil.which(shell):
                told.add(f'{shell} does not read its script: it is not here')
            else:
                done = subprocess.run([shell, '-n', script], capture_output=True, text=True, timeout=harness.TIME_LIMIT_S, check=False)
                yield f'{shell} reads its script ({lang})', [] if done.returncode == 0 and not done.stderr else [done.stderr]
        for line, wanted, unwanted in LINES:
            offers, error = bash_offers(scripts['bash'], line, program, folder)
            faults = [f'no {word}' for word in wanted.split() if word not in offers] + [f'{word} is offered' for word in unwanted.split() if word in offers]
            yield f'bash ({lang}): {line}', [f'{fault}: {offers}' for fault in faults] + ([error] if error else [])


SECTIONS = {'en': ['NAME', 'SYNOPSIS', 'OPTIONS', 'COMMANDS', 'EXIT STATUS', 'FILES', 'ENVIRONMENT', 'SEE ALSO'],
            'ru': ['ИМЯ', 'ВЫЗОВ', 'ОБЩИЕ КЛЮЧИ', 'КОМАНДЫ', 'КОД ВОЗВРАТА', 'ФАЙЛЫ', 'ПЕРЕМЕННЫЕ СРЕДЫ', 'СМ. ТАКЖЕ']}
PIECES = {'en': ['\\fB\\-q\\fR, \\fB\\-\\-quiet\\fR', '\\fB\\-\\-trace\\fR \\fIFILE\\fR', '\\fB\\-\\-format\\fR \\fItext|json|sarif\\fR', '.SS "kadr tape decode"',
                 '\\fIPROGRAM\\fR', 'NO_COLOR'],
          'ru': ['\\fB\\-\\-trace\\fR \\fIФАЙЛ\\fR', '.SS "kadr mill pocket"', 'по умолчанию 1000']}


def manual_checks(kadr, folder):
    for lang in ('en', 'ru'):
        page = kadr('man', '--lang', lang)
        missing = [s for s in SECTIONS[lang] if f'.SH "{s}"' not in page] + [p for p in PIECES[lang] if p not in page]
        yield f'man ({lang}): sections and options', [f'no {piece}' for piece in missing]
        yield f'man ({lang}): each tag has its text', re.findall(r'\.TP\n(?:\n|\.).*|\.TP\n.*\n(?:\n|\.[A-Z]).*', page)
        names = set(re.findall(r'^  (?:-., )?(--[a-z-]+)', kadr('run', '--help'), re.M)) - {'--help'}
        told = page.replace('\\-', '-')
        yield f'man ({lang}): options of run', [f'no {name}' for name in names if f'\\fB{name}\\fR' not in told]
        if not shutil.which('groff'):
            told.add('the manual page is not set: groff is not here')
        else:
            file = folder / f'kadr.{lang}.1'
            file.write_text(page)
            done = subprocess.run(['groff', '-man', '-Kutf8', '-Tutf8', '-ww', file], capture_output=True, text=True, timeout=harness.TIME_LIMIT_S, check=False)
            preconv_missing = 'preconv' in done.stderr
            if preconv_missing:
                told.add('warnings of groff are not held: preconv is not here')
            yield f'man ({lang}): groff has no warning', [] if preconv_missing or (done.returncode == 0 and not done.stderr) else [done.stderr[:500]]


def main():
    tally = harness.Tally()
    with tempfile.TemporaryDirectory() as name:
        kadr = harness.Kadr(harness.kadr_of(__doc__), name)
        for what, faults in [*completion_checks(kadr.printed, kadr.program, kadr.folder), *manual_checks(kadr.printed, kadr.folder)]:
            tally.judge(what, faults)
    for reason in sorted(told):
        tally.skip(reason)
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
