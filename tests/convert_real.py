#!/usr/bin/env python3
"""Tests kadr convert with real programs to every other control: by the method that tests/convert_real/results.json records, or refused.

    convert_real.py --kadr PROGRAM [--every N] [--jobs N] [--update]
"""
import argparse
import json
import tempfile
from pathlib import Path

from conversions import pairs
from conversions.pairs import CONTROLS
from page_client.client import expect, result

FILE = Path(__file__).resolve().parent / 'convert_real' / 'results.json'
# From the method that keeps most of the program to the one that keeps nothing.
WAYS = ('as it stands', 'word by word', 'with offsets and radius compensation as codes', "with the path of the tool's centre", 'with all offsets calculated in', 'refused')


def way_of(made):
    return made.outcome.removeprefix('written: ')


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True, type=Path)
    options.add_argument('--every', type=int, default=1)
    options.add_argument('--jobs', type=int, default=2)
    options.add_argument('--update', action='store_true', help='write the results down as expected')
    given = options.parse_args()
    recorded = json.loads(FILE.read_text(encoding='utf-8'))
    jobs = [(row['control'], FILE.parent / row['program'], None, to) for row in recorded for to in CONTROLS if to != row['control']][::given.every]
    with tempfile.TemporaryDirectory() as name:
        made = pairs.convert_all(given.kadr, jobs, Path(name), given.jobs)
    rows = {(FILE.parent / row['program'], row['control']): row['results'] for row in recorded}
    for one in made:
        expect(one.right(), f'{one.name()}: {one.outcome} {one.said[:300]}')
        now = way_of(one)
        before = rows[one.file, one.control].get(one.to, 'refused')
        if given.update and one.right():
            rows[one.file, one.control][one.to] = now
        elif one.right():
            better = WAYS.index(now) < WAYS.index(before)
            expect(now == before, f'{one.name()}: {now}, recorded is: {before}' + (': better, write it down by --update' if better else f'\n{one.said}'))
    expect(len(made) > 0 and any(one.proven() for one in made), 'something is converted')
    if given.update:
        FILE.write_text(json.dumps(recorded, indent=1) + '\n', encoding='utf-8')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
