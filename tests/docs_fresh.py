#!/usr/bin/env python3
"""Checks that the pages docs/controls/ID.md, docs/setup.md and docs/ru/setup.md are what dev/docs generates from the controls built into
the program, and that each control has its notes.

    docs_fresh.py --kadr build/kadr

Prints a line per page that is out of date, then `N passed, N failed`. Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import argparse
import difflib
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from harness import TIME_LIMIT_S

ROOT = Path(__file__).resolve().parent.parent
PAGES = ROOT / 'docs' / 'controls'
SETUP = {'setup.md': ROOT / 'docs' / 'setup.md', 'setup.ru.md': ROOT / 'docs' / 'ru' / 'setup.md'}   # pages that belong to no single control


def made_by(kadr, folder):
    """Returns name → text of the pages that dev/docs generates."""
    subprocess.run([ROOT / 'dev' / 'docs', folder], env={**os.environ, 'KADR': kadr}, check=True, timeout=TIME_LIMIT_S)
    return {page.name: page.read_text(encoding='utf-8') for page in sorted(Path(folder).iterdir())}


def faults_of(name, text):
    """Returns what is wrong with one page."""
    page = SETUP.get(name, PAGES / name)
    if not page.is_file():
        yield 'is missing'
        return
    there = page.read_text(encoding='utf-8')
    if there != text:
        lines = difflib.unified_diff(there.splitlines(), text.splitlines(), 'there', 'now', lineterm='', n=0)
        yield 'is out of date, run dev/docs\n' + '\n'.join(f'    {line}' for line in list(lines)[2:8])
    if name in SETUP:
        return
    notes = PAGES / f'{page.stem}-notes.md'
    if not notes.is_file():
        yield f'has no {notes.name}'
    elif f']({name})' not in notes.read_text(encoding='utf-8'):
        yield f'{notes.name} does not link to it'


def main():
    parser = argparse.ArgumentParser(description='Are the generated pages up to date?')
    parser.add_argument('--kadr', required=True, help='the program under test')
    kadr = os.path.abspath(parser.parse_args().kadr)
    if not os.access(kadr, os.X_OK):
        print(f'{kadr}: not a program', file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as folder:
        pages = made_by(kadr, folder)
    passed, failed = 0, 0
    for name, text in pages.items():
        faults = list(faults_of(name, text))
        for fault in faults:
            print(f'FAILED {SETUP.get(name, PAGES / name).relative_to(ROOT)} {fault}')
        passed, failed = passed + (not faults), failed + bool(faults)
    known = set(pages) | {f'{Path(name).stem}-notes.md' for name in pages}
    for stray in sorted(page.name for page in PAGES.iterdir() if page.name not in known):
        print(f'FAILED docs/controls/{stray} belongs to no control')
        failed += 1
    print(f'{passed} passed, {failed} failed')
    return 0 if passed and not failed else 1


if __name__ == '__main__':
    sys.exit(main())
