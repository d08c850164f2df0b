#!/usr/bin/env python3
"""kadr convert: every example of every control to every other is proven equal, or refused with the place; what is written is held against
its source once more by `kadr diff`, and a changed word of it is found.

    convert.py --kadr PROGRAM [--mutations N]
"""
import argparse
import random
import re
import subprocess
import tempfile
from pathlib import Path

from page_client.client import expect, result

CONTROLS = ('s2c42', 'mach3', 'correctors', 'gost', 'nct', 'linuxcnc', 'fanuc', 'haas', 'grbl')
EXAMPLES = Path(__file__).resolve().parent.parent / 'examples'
# Proven so far: fewer is a step back. The others are refused (docs/commands/convert.md).
LEAST_PROVEN = 176


def run(*words, **more):
    return subprocess.run([str(w) for w in words], capture_output=True, text=True, timeout=120, check=False, **more)


def programs():
    for control in CONTROLS:
        for file in sorted((EXAMPLES / control).glob('*')):
            if file.suffix in ('.nc', '.tap', '.nct', '.ngc') and not file.name.startswith('O'):
                yield control, file


def with_setup(file):
    setup = file.with_suffix('.json')
    return ['--setup', setup] if setup.exists() else []


def every_pair(kadr, folder):
    """No third outcome: proven and written, or refused with the reason, and nothing written."""
    proven = []
    for control, file in programs():
        for to in CONTROLS:
            if to == control:
                continue
            out, setup = folder / 'out.nc', folder / 'out.json'
            for old in (out, setup):
                old.unlink(missing_ok=True)
            got = run(kadr, 'convert', file, '--from', control, '--to', to, '--out', out, '--setup-out', setup, '--lang', 'en', *with_setup(file))
            what = f'{file.name} to {to}: {got.returncode} {got.stderr[:300]}'
            if got.returncode == 0:
                expect(out.exists() and got.stderr.startswith('equal: '), what)
                kept = folder / f'{control}_{file.stem}_{to}.nc'
                out.rename(kept)
                setup.rename(kept.with_suffix('.json'))
                proven.append((control, file, to, kept))
            else:
                expect(got.returncode == 1 and not out.exists() and not setup.exists(), what)
                expect('not converted' in got.stderr and len(got.stderr.splitlines()) >= 4, what)
    expect(len(proven) >= LEAST_PROVEN, f'proven: {len(proven)}')
    return proven


def diff(kadr, control, file, to, other, setup):
    return run(kadr, 'diff', file, other, '--control-a', control, '--control-b', to, '--tolerance', '0.001', '--setup-b', setup, '--lang', 'en',
               *(['--setup-a', file.with_suffix('.json')] if file.with_suffix('.json').exists() else []))


def again(kadr, proven, folder, mutations):
    """`kadr diff` opens both from their files: the set-up that is written belongs to the program; a changed coordinate is found."""
    random.seed(7)
    for control, file, to, out in random.sample(proven, 25):
        got = diff(kadr, control, file, to, out, out.with_suffix('.json'))
        expect(got.returncode == 0, f'{out.name}: {got.stdout[:300]}{got.stderr[:300]}')
    found = 0
    for _ in range(mutations):
        control, file, to, out = random.choice(proven)
        text = out.read_text()
        words = [m for m in re.finditer(r'(?m)(?<=[ ])([XYZ])(-?)(\d+)(\.?\d*)(?= |$)', re.sub(r'\([^)]*\)', lambda m: ' ' * len(m.group()), text))]
        if not words:
            continue
        word = random.choice(words)
        step = 2000 if '.' not in word.group(4) else 2
        changed = f'{word.group(1)}{word.group(2)}{int(word.group(3)) + step}{word.group(4)}'
        mutant = folder / 'mutant.nc'
        mutant.write_text(text[:word.start()] + changed + text[word.end():])
        got = diff(kadr, control, file, to, mutant, out.with_suffix('.json'))
        found += got.returncode == 1
        expect(got.returncode == 1, f'{out.name}: {word.group()} as {changed} is not found')
    expect(found > mutations // 2, f'changed words: {found}')


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
    forced = run(kadr, 'convert', EXAMPLES / 'mach3' / 'pocket_macro.tap', '--from', 'mach3', '--to', 'gost', '--force', '--lang', 'en')
    expect(forced.returncode == 1 and forced.stdout.startswith('(NOT PROVEN'), 'forced: it says so at its top')


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    options.add_argument('--mutations', type=int, default=40)
    given = options.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        wrong_use(given.kadr, folder)
        again(given.kadr, every_pair(given.kadr, folder), folder, given.mutations)
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
