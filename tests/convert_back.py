#!/usr/bin/env python3
"""Tests kadr convert there and back: a program is converted for another control, and the result is converted back; `kadr diff` finds the
last program equal to the first. Examples are converted to all others, random programs over each control's grammar to one. Refused ways
back are counted.

    convert_back.py --kadr PROGRAM [--every N] [--programs N] [--seed N] [--jobs N]
"""
import argparse
import collections
import random
import re
import sys
import tempfile
from pathlib import Path

from conversions import pairs, random_programs
from conversions.pairs import CONTROLS
from page_client.client import expect, result

# Each of the two is within half an increment of the coarser word: a ten-thousandth of an inch at worst, plus the rounding of
# GOST.
TOLERANCE = 0.005
LOST = re.compile(r'how corners are gone round|what is done between: (G9 ?)+ — nothing|spindle: \S+ M[34] — M5$')  # M30 there stops the spindle, which is then written explicitly
# The least share of the proven conversions that must be proven on the way back too.
LEAST_SHARE = 0.6


def random_jobs(given, folder):
    for number in range(given.programs):
        chance = random.Random(f'back {given.seed} {number}')
        control = CONTROLS[number % len(CONTROLS)]
        file = folder / f'random_{number}.nc'
        file.write_text(random_programs.program(control, chance), encoding='utf-8')
        file.with_suffix('.json').write_text(random_programs.setup_of(control), encoding='utf-8')
        yield control, file, chance.choice([to for to in CONTROLS if to != control])


def there_and_back(kadr, job, folder):
    """Returns the outcome, and what is wrong with it."""
    number, (control, file, to) = job
    there = pairs.convert(kadr, control, file, to, folder / f'{number}_there.nc', pairs.setup_of(file))
    if not there.proven():
        return ('refused there', '') if there.right() else ('wrong', there.outcome)
    back = pairs.convert(kadr, to, there.out, control, folder / f'{number}_back.nc', there.out_setup())
    if not back.proven():
        return ('refused back', back.said) if back.right() else ('wrong', back.outcome)
    whole = pairs.Converted(control, file, there.setup, control, back.outcome, there.said + back.said, back.out)
    got = pairs.diff(kadr, whole, tolerance=TOLERANCE + pairs.tolerance_of(control, to))
    told = [line for line in got.stdout.splitlines()[:-1] if not line.startswith('  ')]
    if got.returncode == 1 and 'not carried over' in there.said and all(LOST.search(line) for line in told if line):
        return 'equal but for corners, as told', ''  # G64 P or exact stops, which the other control does not have
    return ('equal', '') if got.returncode == 0 else ('wrong', got.stdout[:400] + got.stderr[:300])


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True, type=Path)
    options.add_argument('--every', type=int, default=1)
    options.add_argument('--programs', type=int, default=90, help='number of random programs')
    options.add_argument('--seed', type=int, default=20261126)
    options.add_argument('--jobs', type=int, default=2)
    options.add_argument('--told', action='store_true', help='print why a way back is refused')
    given = options.parse_args()
    jobs = [(control, file, to) for control, file in pairs.examples() for to in CONTROLS if to != control][::given.every]
    counts = collections.Counter()
    with tempfile.TemporaryDirectory() as name:
        jobs += random_jobs(given, Path(name))
        outcomes = pairs.all_of(lambda job: there_and_back(given.kadr, job, Path(name)), list(enumerate(jobs)), given.jobs)
    for (control, file, to), (outcome, why) in zip(jobs, outcomes):
        counts[outcome] += 1
        expect(outcome != 'wrong', f'{control} {file.name} to {to} and back: {why}')
        if given.told and outcome == 'refused back':
            print(f'{control} {file.name} to {to} and back: {why}', file=sys.stderr)
    for outcome, count in counts.most_common():
        print(count, outcome, file=sys.stderr)
    expect(counts['equal'] > LEAST_SHARE * (counts['equal'] + counts['refused back']), f'equal: {counts["equal"]}')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
