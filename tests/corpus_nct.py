#!/usr/bin/env python3
"""Tests programs of other shops under --control nct: each runs to its end, or stops where the table of tests/corpus_nct/README.md states.

    corpus_nct.py --kadr build/kadr

A program without a row, a row without a program, and a table that cannot be read are failures.
"""
import argparse
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from harness import TIME_LIMIT_S

FOLDER = Path(__file__).resolve().parent / 'corpus_nct'
ROW = re.compile(r'\| ([^|]+\.(?:nc|NC)) \| ([^|]*) ?\| ([^|]+) \| [^|]* ?\|')
FINDING = re.compile(r'(\d+) ([a-z_]+)')


class Row:
    """A row of the table: the result of a program under these conditions."""

    def __init__(self, found):
        self.program, self.condition, does = (cell.strip() for cell in found.groups())
        self.findings = [] if does == 'runs' else [(int(m[1]), m[2]) for part in does.split(', ') if (m := FINDING.fullmatch(part))]
        if does != 'runs' and len(self.findings) != does.count(', ') + 1:
            raise ValueError(f'{self.program}: not understood: {does}')
        self.setup, self.arguments = {}, []
        if skip := re.fullmatch(r'skip (\d)', self.condition):
            self.arguments = ['--skip', skip[1]]
        elif parameter := re.fullmatch(r'(N\d{4}\S*)=(\S+)', self.condition):
            self.setup = {'parameters': {parameter[1]: float(parameter[2])}}
        elif self.condition:
            raise ValueError(f'{self.program}: not understood: {self.condition}')

    def name(self):
        return f'{self.program} {self.condition}'.strip()


def table():
    lines = (FOLDER / 'README.md').read_text(encoding='utf-8').splitlines()
    return [Row(found) for line in lines if (found := ROW.fullmatch(line))]


def kadr(options, row, command, *more):
    with tempfile.NamedTemporaryFile('w', suffix='.json') as setup:
        json.dump(row.setup, setup)
        setup.flush()
        call = [options.kadr, command, row.program, '--control', 'nct', '--lang', 'en', '-q', '--setup', setup.name, *row.arguments, *more]
        return subprocess.run(call, cwd=FOLDER, stdin=subprocess.DEVNULL, capture_output=True, timeout=TIME_LIMIT_S)


def judge(options, row):
    """Returns None, or why the row is not true."""
    checked = json.loads(kadr(options, row, 'check', '--format', 'json').stdout)
    findings = [(f['line'], f['id']) for f in checked if f['severity'] == 'alarm']
    if findings != row.findings:
        return f'check: expected {row.findings or "nothing"}, got {findings or "nothing"}'
    ran = kadr(options, row, 'run', '--trace', '-')
    last = json.loads([line for line in ran.stdout.decode().splitlines() if line.startswith('{')][-1])
    got = (last['line'], last['id']) if last['do'] == 'alarm' else None
    first = row.findings[0] if row.findings else None
    if got != first or ran.returncode != (1 if first else 0):
        return f'run: expected {first or "its end"}, got {got or "its end"} (exit status {ran.returncode})'
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--kadr', required=True)
    options = parser.parse_args()
    options.kadr = str(Path(options.kadr).resolve())
    rows = table()
    programs = {f.name for f in FOLDER.iterdir() if f.name != 'README.md'}
    failures = [f'{name}: has no row' for name in sorted(programs - {row.program for row in rows})]
    failures += [f'{row.program}: is not there' for row in rows if row.program not in programs]
    passed = 0
    for row in rows:
        if row.program not in programs:
            continue
        why = judge(options, row)
        passed += why is None
        if why is not None:
            failures.append(f'{row.name()}: {why}')
    for failure in failures:
        print(f'FAILED {failure}')
    print(f'{passed} passed, {len(failures)} failed')
    return 1 if failures or not passed else 0


if __name__ == '__main__':
    sys.exit(main())
