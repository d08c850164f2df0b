#!/usr/bin/env python3
"""Compares the turning cycles of fanuc-t with a slow reference (tests/lathe_twin): random programs of G70 to G76, G90, G92, G94.

    tests/lathe_cycles.py --kadr build/release/kadr [--count 250] [--seed 1] [--kind N] [--show]

The reference is written from spec/fanuc-t alone. Compared: every motion, its end point within 2e-6 mm, centre, sense, feed and lead. Of
each G71 and G72 also what it leaves: the figure with its allowance, nothing cut beyond it, no cut deeper than stated, no rapid through the
stock. Of cycles in G41 or G42 that the nose leaves the same. Programs with a fault end with its alarm. `--show` prints the programs that
differ.
"""
import collections
import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

import harness
from lathe_twin import nose, programs, refused, stock

TOLERANCE = 2e-6
CENTRE = 2e-5        # mm, of an arc given by its radius
NOSE, FAULT = -1, -2   # values of --kind
MOTIONS = ('rapid', 'feed', 'arc_cw', 'arc_ccw', 'thread')


def run(kadr, program, folder):
    """Runs a program.  returns the motions of its trace, the last line"""
    folder = Path(folder)
    (folder / 'setup.json').write_text(program.setup_text(), encoding='utf-8')
    (folder / 'main.nc').write_text(program.text(), encoding='utf-8')
    done = subprocess.run([kadr, 'run', 'main.nc', '--control', 'fanuc-t', '--setup', 'setup.json', '--files', '.', '--trace', '-', '--lang', 'en'],
                          cwd=folder, capture_output=True, timeout=harness.TIME_LIMIT_S, stdin=subprocess.DEVNULL, check=False)
    actions = [json.loads(line) for line in done.stdout.decode().splitlines() if line.startswith('{')]
    last = next((a for a in actions if a['do'] in ('end', 'alarm')), {'do': 'nothing', 'text': done.stderr.decode()[:300]})
    return [a for a in actions if a['do'] in MOTIONS or a['do'] == 'home'], last


def in_full(motions, start):
    """Returns (kind, (Z, X), centre, ccw, action) of the motions, those of no length left out."""
    here, found = dict(start), []
    for action in motions:
        to = {**here, **action['to']}
        kind = 'arc' if action['do'].startswith('arc') else action['do']
        centre = (action['center']['Z'], action['center']['X']) if kind == 'arc' else None
        if kind == 'arc' or any(abs(to[a] - here[a]) > 1e-7 for a in 'ZX'):
            one = kind, (to['Z'], to['X']), centre, action['do'] == 'arc_ccw', action
            goes_on = bool(found) and kind == 'arc' == found[-1][0] and math.dist(centre, found[-1][2]) < CENTRE and one[3] == found[-1][3]
            found[len(found) - goes_on:] = [one]           # an arc may come in two parts
        here = to
    return found


def moving(expected, start):
    """Returns the numbers of the expected moves that have a length, of an arc in several parts the last."""
    here, found = start, []
    for number, move in enumerate(expected):
        if move.kind == 'arc' or math.dist(here, move.to) > 1e-7:
            before = expected[found[-1]] if found else None
            goes_on = before and move.kind == 'arc' == before.kind and math.dist(move.centre, before.centre) < CENTRE and move.ccw == before.ccw
            found[len(found) - bool(goes_on):] = [number]
        here = move.to
    return found


def apart(wanted, got):
    """Returns how a motion differs from the one that must come; None if it does not."""
    kind, to, centre, ccw, action = got
    if kind != wanted.kind or math.dist(to, wanted.to) > TOLERANCE:
        return 'the motion'
    if kind == 'arc' and (math.dist(centre, wanted.centre) > CENTRE or ccw != wanted.ccw):
        return 'the arc'
    if wanted.feed is not None and not math.isclose(action.get('feed', 0), wanted.feed, abs_tol=1e-9):
        return f'the feed {action.get("feed")} for {wanted.feed}'
    if wanted.lead is not None and not math.isclose(action.get('lead', 0), wanted.lead, abs_tol=1e-9):
        return f'the lead {action.get("lead")} for {wanted.lead}'
    return None


def judge(program, motions, last):
    """Returns the faults of a run."""
    if last['do'] != 'end':
        return [f'{last["do"]} {last.get("number")} {last.get("text")} (line {last.get("line")})']
    start = program.setup['start']
    got, numbers = in_full(motions, start), moving(program.moves, (start['Z'], start['X']))
    for n, (number, one) in enumerate(zip(numbers, got)):
        wrong = apart(program.moves[number], one)
        if wrong:
            want = program.moves[number]
            return [f'motion {n + 1}, line {one[4].get("line")}: {wrong}: {one[0]} Z{one[1][0]:.6f} X{one[1][1]:.6f}, '
                    f'wanted {want.kind} Z{want.to[0]:.6f} X{want.to[1]:.6f}']
    if len(got) != len(numbers):
        return [f'{len(got)} motions, wanted {len(numbers)}']
    return [f'{part.name}: {fault}' for part in program.parts for fault in of_part(program, part, got, numbers)]


def judge_nose(one, motions, last):
    """Returns the faults of a run with nose radius compensation, or 'refused'."""
    if last['do'] == 'alarm' and last.get('number') in one.may_be_refused():
        return 'refused'
    if last['do'] != 'end':
        return [f'{last["do"]} {last.get("number")} {last.get("text")} (line {last.get("line")})']
    return one.faults(in_full(motions, one.program.setup['start']))


def judge_refused(program, alarm, motions, last):
    """Returns the faults of a run that must end with the alarm before the cycle moves."""
    if last['do'] != 'alarm' or last.get('number') != alarm:
        return [f'{last["do"]} {last.get("number")} {last.get("text")}, wanted alarm {alarm}']
    start = program.setup['start']
    return [] if len(in_full(motions, start)) == len(moving(program.moves, (start['Z'], start['X']))) else ['the cycle moves before the alarm']


def of_part(program, part, got, numbers):
    """Returns what stock.py finds in Kadr's motions of one roughing."""
    to_frame, over = part.to_frame
    chosen = [one for number, one in zip(numbers, got) if part.first <= number < part.last]
    moves = [(kind, to_frame(to), centre and to_frame(centre), ccw != over) for kind, to, centre, ccw, _ in chosen]
    return stock.faults(moves, part.pieces, (0.0, 0.0), part.step, part.whole) + stock.straight_down(moves, part.pieces, (0.0, 0.0))


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--count', type=int, default=250)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--kind', type=int, help=f'only this row of SEGMENTS in lathe_twin/programs.py; {NOSE}: with nose compensation, {FAULT}: with a fault')
    parser.add_argument('--show', action='store_true', help='print the programs that differ')
    options = harness.parsed(parser)
    tally, cycles = harness.Tally(), collections.Counter()

    def of_seed(seed):
        """Makes, runs and judges a program: of ten, two are in G41 or G42, one has a fault."""
        chance, kind = random.Random(seed), options.kind
        if kind == NOSE or (kind is None and seed % 5 == 0):
            one = nose.NoseProgram(chance)
            program, by = one.program, lambda *ran: judge_nose(one, *ran)
        elif kind == FAULT or (kind is None and seed % 10 == 1):
            program, alarm = refused.random_program(chance)
            by = lambda *ran: judge_refused(program, alarm, *ran)
        else:
            program = programs.random_program(chance, kind)
            by = lambda *ran: judge(program, *ran)
        with tempfile.TemporaryDirectory(prefix='lathe') as folder:
            return seed, program, by(*run(options.kadr, program, folder))

    for seed, program, found in harness.each(of_seed, range(options.seed, options.seed + options.count)):
        cycles.update(program.names)
        if found == 'refused':
            cycles['refused for the nose'] += 1
            continue
        tally.judge(f'seed {seed} ({", ".join(program.names)})', found)
        if found and options.show:
            print(json.dumps(program.setup), *(f'    {n} {line}' for n, line in enumerate(program.lines, 1)), sep='\n')
    print(', '.join(f'{name} {count}' for name, count in sorted(cycles.items())), file=sys.stderr)
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
