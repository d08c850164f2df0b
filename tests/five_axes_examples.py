#!/usr/bin/env python3
"""Tests the programs of examples/five-axes: `kadr check` reports nothing on the machine that examples/README.md names, and the axes stay
within their limits. Samples of programs with tool centre point control keep the tip on its path and the axes within speed, acceleration
and jerk.

    five_axes_examples.py --kadr build/kadr

Prints a line per failure, then `N passed, N failed`. Exit status: 0 all passed, 1 some failed.
"""
import argparse
import re
import subprocess
import sys
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parent.parent / 'examples'
COMMAND = re.compile(r'kadr run (five-axes/\S+) --control nct --machine (\S+) --setup (\S+) ')
RESULT = '1 program checked: 0 errors, 0 warnings.'


def faults(kadr, program, machine, setup):
    words = [program, '--control', 'nct', '--machine', machine, '--setup', setup, '--lang', 'en']
    done = subprocess.run([kadr, 'check', *words], capture_output=True, text=True, cwd=EXAMPLES, check=False)
    if done.returncode != 0 or RESULT not in done.stdout + done.stderr:
        yield f'check: {done.returncode}: {(done.stdout + done.stderr)[-400:]}'
    done = subprocess.run([kadr, 'run', *words, '--samples', '/dev/null', '--rate', '100'], capture_output=True, text=True, cwd=EXAMPLES, check=False)
    if done.returncode != 0 or 'plan_unsolved' in done.stderr:
        yield f'run: {done.returncode}: {done.stderr[-400:]}'
    if not re.search(r'cutting, mm .*[ABC] -?\d', done.stdout):
        yield f'no rotary axis in the summary: {done.stdout[:400]}'


def main():
    parser = argparse.ArgumentParser(description='The examples for five axes.')
    parser.add_argument('--kadr', type=Path, required=True)
    kadr = parser.parse_args().kadr.resolve()
    commands = COMMAND.findall((EXAMPLES / 'README.md').read_text(encoding='utf-8'))
    named = {name for name, _, _ in commands}
    there = {f'five-axes/{p.name}' for p in (EXAMPLES / 'five-axes').glob('*.nct')}
    failed = 0
    for name in sorted(named ^ there):
        print(f'{name}: in the folder and in README.md, not in one alone')
        failed += 1
    for program, machine, setup in commands:
        found = list(faults(kadr, program, machine, setup))
        failed += bool(found)
        for fault in found:
            print(f'{program}: {fault}')
    print(f'{len(commands) - failed} passed, {failed} failed')
    return 1 if failed or not commands else 0


if __name__ == '__main__':
    sys.exit(main())
