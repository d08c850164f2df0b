#!/usr/bin/env python3
"""Runs the referee of the golden cases over our own cases, tests/cases/CONTROL/TOPIC.cases.

    run_cases.py --kadr build/kadr
    run_cases.py --kadr build/kadr --only 'h-*'

The form of the files: tests/cases/reader.py; the meaning of the keys: tests/golden/README.md. A file that cannot be read, a key or value
that tests/golden/schema.json does not have, two cases of one name, an empty file or folder fail, reported as FILE:LINE.
"""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import harness
from cases import reader

TESTS = Path(__file__).resolve().parent
CASES = TESTS / 'cases'
REFEREE = TESTS / 'golden' / 'check.py'
SCHEMA = TESTS / 'golden' / 'schema.json'
BASIS = ('rule', 'inferred')


class Form:
    """The part of JSON Schema that schema.json uses to close its vocabulary: properties, required, enum, items, $ref."""

    def __init__(self, schema):
        self.schema = schema

    def faults(self, value, rule, where):
        while '$ref' in rule:
            rule = self.schema['$defs'][rule['$ref'].rpartition('/')[2]]
        if 'enum' in rule and value not in rule['enum']:
            yield f'{where}: {value!r} is not one of {rule["enum"]}'
        if isinstance(value, dict):
            known = rule.get('properties', {})
            for key in rule.get('required', []):
                if key not in value:
                    yield f'{where}: {key} is missing'
            for key, inner in value.items():
                if key in known:
                    yield from self.faults(inner, known[key], f'{where}.{key}')
                elif rule.get('additionalProperties') is False and not rule.get('patternProperties'):
                    yield f'{where}: unknown key {key!r}'
        elif isinstance(value, list):
            for i, inner in enumerate(value):
                yield from self.faults(inner, rule.get('items', {}), f'{where}[{i}]')


def form_faults(cases):
    """Returns what the schema finds wrong in each case; and files below tests/cases that no runner reads."""
    form = Form(json.loads(SCHEMA.read_text(encoding='utf-8')))
    for where, case in cases:
        yield from form.faults(case, form.schema, where)
        if case['basis'] not in BASIS or not case.get('derivation'):
            yield f'{where}: basis is rule or inferred, with its derivation'
        if case['control'] not in harness.CONTROLS:
            yield f'{where}: {case["control"]!r} is no file of controls/'
    for folder in sorted(CASES.iterdir()):
        if folder.name in ('reader.py', '__pycache__'):
            continue
        files = sorted(folder.iterdir()) if folder.is_dir() else [folder]
        if not files:
            yield f'{folder.name}/: no case'
        yield from (f'{file.relative_to(CASES)}: not a file of cases' for file in files if file.suffix != '.cases' or file == folder)


def write_json(cases, folder):
    """Writes the cases as the referee reads them, CONTROL/ID.json; the reader reports two cases with the same name."""
    for _, case in cases:
        file = Path(folder, case['control'], case['id'] + '.json')
        file.parent.mkdir(exist_ok=True)
        file.write_text(json.dumps(case, ensure_ascii=False), encoding='utf-8')


def main():
    parser = argparse.ArgumentParser(description='Run our own cases.')
    parser.add_argument('--kadr', required=True, help='the program under test')
    parser.add_argument('--only', help='only cases whose name matches')
    parser.add_argument('--jobs', default='2', help='cases run at the same time')
    options = parser.parse_args()
    cases, faults = reader.read_all()
    faults += form_faults(cases)
    for fault in faults:
        print(f'FAILED {fault}')
    only = ['--only', options.only] if options.only else []
    with tempfile.TemporaryDirectory(prefix='kadr_cases') as folder:
        write_json(cases, folder)
        status = subprocess.run([sys.executable, str(REFEREE), '--kadr', options.kadr, '--jobs', options.jobs, *only, folder]).returncode
    if faults:
        print(f'{len(faults)} faults of form')
    return status or (1 if faults else 0)


if __name__ == '__main__':
    sys.exit(main())
