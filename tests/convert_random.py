#!/usr/bin/env python3
"""Tests kadr convert with random programs of every control to two others: each is proven or refused, with no third outcome; `kadr diff`
finds each proven result equal too.

    convert_random.py --kadr PROGRAM [--programs N] [--seed N] [--jobs N] [--keep FOLDER]
"""
import argparse
import collections
import random
import sys
import tempfile
from pathlib import Path

from conversions import pairs, random_programs
from conversions.pairs import CONTROLS
from page_client.client import expect, result

# The least share that must be proven: it shows that the programs can still be converted, and that the conversion is still good.
LEAST_PROVEN = 0.75


def jobs_of(given, folder):
    for number in range(given.programs):
        chance = random.Random(f'{given.seed} {number}')
        control = CONTROLS[number % len(CONTROLS)]
        file = folder / f'{given.seed}_{number}.nc'
        file.write_text(random_programs.program(control, chance), encoding='utf-8')
        setup = file.with_suffix('.json')
        setup.write_text(random_programs.setup_of(control), encoding='utf-8')
        for to in chance.sample([to for to in CONTROLS if to != control], 2):
            yield control, file, setup, to


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True, type=Path)
    options.add_argument('--programs', type=int, default=72)
    options.add_argument('--seed', type=int, default=20261126)
    options.add_argument('--jobs', type=int, default=2)
    options.add_argument('--keep', type=Path, help='keep the programs, their results and the reasons of refusals in this folder')
    given = options.parse_args()
    counts, alarms = collections.Counter(), 0
    with tempfile.TemporaryDirectory() as name:
        folder = given.keep or Path(name)
        folder.mkdir(exist_ok=True)
        made = pairs.convert_all(given.kadr, list(jobs_of(given, folder)), folder, given.jobs)
        again = pairs.all_of(lambda one: pairs.diff(given.kadr, one) if one.proven() else None, made, given.jobs)
        for one, got in zip(made, again):
            if given.keep:
                one.out.with_suffix('.txt').write_text(f'{one.outcome}\n{one.said}', encoding='utf-8')
            counts[one.outcome if one.right() else 'wrong'] += 1
            expect(one.right(), f'{one.name()}: {one.outcome} {one.said[:300]}')
            expect(got is None or got.returncode == 0, f'{one.name()}: {got and got.stdout[:300]}{got and got.stderr[:300]}')
            alarms += 'an alarm stops the program under its own control' in one.said
    for outcome, count in counts.most_common():
        print(count, outcome, file=sys.stderr)
    proven = sum(count for outcome, count in counts.items() if outcome.startswith('written'))
    expect(alarms == 0, f'programs that their own control does not carry out: {alarms}')
    expect(proven > LEAST_PROVEN * sum(counts.values()), f'proven: {proven}')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
