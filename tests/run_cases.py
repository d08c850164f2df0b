#!/usr/bin/env python3
"""Runs the referee of the golden cases over our own cases, tests/cases/CONTROL/*.json.

    run_cases.py --kadr build/kadr
    run_cases.py --kadr build/kadr --only 'h-*'

The form of a case and its rules: tests/golden/README.md. Before the referee each case is held against that form: a key it does
not know, a name that is not the file's, a control that is not the folder's, or an empty folder fails.
"""
import argparse
import json
import subprocess
import sys
from pathlib import Path

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


def form_faults():
    form = Form(json.loads(SCHEMA.read_text(encoding='utf-8')))
    folders = sorted(f for f in CASES.iterdir() if f.is_dir())
    if not folders:
        yield f'{CASES}: no case'
    for folder in folders:
        files = sorted(folder.iterdir())
        if not files:
            yield f'{folder.name}/: no case'
        for file in files:
            where = f'{folder.name}/{file.name}'
            if file.suffix != '.json':
                yield f'{where}: not a case'
                continue
            try:
                case = json.loads(file.read_text(encoding='utf-8'))
            except json.JSONDecodeError as error:
                yield f'{where}: {error}'
                continue
            yield from form.faults(case, form.schema, where)
            if case.get('id') != file.stem or case.get('control') != folder.name:
                yield f'{where}: id or control is not the name of the file or folder'
            if case.get('basis') not in BASIS or not case.get('derivation'):
                yield f'{where}: basis is rule or inferred, with its derivation'


def main():
    parser = argparse.ArgumentParser(description='Run our own cases.')
    parser.add_argument('--kadr', required=True, help='the program under test')
    parser.add_argument('--only', help='only cases whose name matches')
    options = parser.parse_args()
    faults = list(form_faults())
    for fault in faults:
        print(f'FAILED {fault}')
    only = ['--only', options.only] if options.only else []
    status = subprocess.run([sys.executable, str(REFEREE), '--kadr', options.kadr, '--jobs', '2', *only, str(CASES)]).returncode
    if faults:
        print(f'{len(faults)} cases out of form')
    return status or (1 if faults else 0)


if __name__ == '__main__':
    sys.exit(main())
