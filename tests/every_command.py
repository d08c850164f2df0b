#!/usr/bin/env python3
"""Runs every command that reads a program over every example and a share of the golden programs; then every command where a resource is
short: threads, memory, open files, disk space, a reader, time.

    every_command.py --kadr PROGRAM [--every N] [--examples-every N] [--jobs N] [--only 'limits*'] [--open]

With any program, a command ends with the exit status 0, 1 or 2 and without a signal, within a minute of processor time and 2 GiB of
memory; prints a message if the status is not 0; writes only the requested files, each completely or not at all; sends no control
character to a pipe; its JSON is valid. The folder of the examples stays unchanged.

Known faults are listed in tests/commands/known.py.
"""
import fnmatch
import subprocess
import sys
import traceback

import harness
from commands.known import Tally
from commands.limits import over_limits
from commands.observed import Kadr, listing
from commands.programs import EXAMPLES, over_programs

EVERY = 50   # takes every 50th golden program, so that the test needs some 75 s of processor time; all of them take ten minutes


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--every', type=int, default=EVERY, help='runs every Nth golden program')
    parser.add_argument('--examples-every', type=int, default=1, help='runs every Nth example')
    parser.add_argument('--jobs', type=int, default=harness.CORES, help='programs run at the same time')
    parser.add_argument('--only', default='*', help="only programs and limits of that name, e.g. 'examples/nct/*', 'limits*'")
    parser.add_argument('--open', action='store_true', help='print also each fault that OPEN names')
    options = harness.parsed(parser)
    kadr = Kadr(options.kadr, harness.ROOT)
    kadr.sanitized = subprocess.run(['grep', '-qE', '__[at]san_init', options.kadr], check=False).returncode == 0
    jobs = {name: job for name, job in [*over_limits(kadr), *over_programs(kadr, options)] if fnmatch.fnmatch(name, options.only)}
    if not jobs:
        parser.error('nothing has that name')
    tally = Tally(options.open)
    before = listing(EXAMPLES)

    def carried_out(name):
        try:
            for what, faults in jobs[name]():
                tally.judge(what, faults)
        except Exception:  # pylint: disable=broad-except
            tally.judge(name, [traceback.format_exc()])
    for _ in harness.each(carried_out, jobs, options.jobs):
        pass
    after = listing(EXAMPLES)
    tally.judge('the folder of the examples', [f'{name} is changed' for name in sorted(before.keys() | after.keys()) if before.get(name) != after.get(name)])
    print(f'{harness.spent_by_children():.0f} s of processor time', file=sys.stderr)
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
