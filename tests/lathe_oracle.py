#!/usr/bin/env python3
"""Compares turning with LinuxCNC's own interpreter: random figures for G71 and G72, random threads for G76.

    tests/lathe_oracle.py --kadr build/release/kadr [--count 40] [--seed 1] [--show]

Of each figure LinuxCNC's program is run in rs274 and in `kadr run --control linuxcnc`: the motions must be the same. The same figure is
roughed by G71 or G72 of fanuc-t: the passes differ, but both must leave the figure, fanuc-t moved by the allowance U W (LinuxCNC's U W
are for machines without these axes only). G76 with the smallest depth and the allowance 0: the same depths (first depth times the root of
the number), finishing passes, shifts of the start; LinuxCNC's flank moves the end too (docs/controls/fanuc-t-notes.md). Skipped, with a
message, where there is no rs274.

KADR_G7X_ORACLE names an executable that dev/g7x_oracle makes of a later release's source: each figure is then also compared with it, in the
same two ways.
"""
import json
import math
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

import harness
import lathe_cycles
import linuxcnc_oracle
from lathe_twin import programs, stock
from lathe_twin.figures import Frame, Grid, random_figure
from lathe_twin.shapes import EPS

sys.path[:0] = [str(Path(__file__).resolve().parent / 'rs274')]
import oracle  # noqa: E402

SECONDS = 5        # limit of rs274, which does not end with some figures
HEAD = 'G18 G21 G8 G90 G91.1 G94 F100 M3 S500'
LATER = os.environ.get('KADR_G7X_ORACLE')
EQUAL = 5e-5          # mm between the two parts: rs274's output has six decimals, its arcs a tolerance


def text_of(value):
    return f'{value:.7f}'.rstrip('0')


class Figure:
    """A figure for both controls: Fanuc's blocks, LinuxCNC's program, and the frame in which their parts are compared."""

    def __init__(self, seed):
        chance = random.Random(seed)
        grid = Grid(False)
        self.two_axes = chance.random() < 0.5
        self.main = 'Z' if self.two_axes or chance.random() < 0.6 else 'X'
        while True:
            self.frame = Frame(self.main, chance.choice((1, -1)), chance.choice((1, -1)))
            self.start = (chance.randint(-20, 20) * 100, chance.randint(300, 900) * 200)
            self.figure = random_figure(chance, grid, self.frame, self.start, self.two_axes, code=0)
            into, over = self.frame.into(grid.mm(*self.start))
            self.pieces = [piece.mapped(into, over) for piece in self.figure.pieces]
            if not self.two_axes or programs.lowest(self.pieces) >= -EPS:
                break
        deep = programs.deepest(self.pieces)
        self.grid = grid
        self.step, self.escape = max(100, int(deep * 1000 / chance.uniform(0.8, 8))), chance.randint(50, 400)
        self.w, self.u = (chance.choice((0, chance.randint(-10, 10) * 20)) for _ in range(2))      # U a diameter
        self.allowance = self.w / 1000, self.u / 2000

    def linuxcnc(self):
        """Returns the program in LinuxCNC's words; X is a radius."""
        point = lambda p: f'X{text_of(p[1])} Z{text_of(p[0])}'
        first = self.figure.pieces[0].a
        made = [HEAD, 'O100 SUB', f'G0 {point(first)}']
        for piece in self.figure.pieces:
            if piece.c is None:
                made.append(f'G1 {point(piece.b)}')
            else:
                made.append(f'G{3 if piece.ccw else 2} {point(piece.b)} I{text_of(piece.c[1] - piece.a[1])} K{text_of(piece.c[0] - piece.a[0])}')
        z, x = self.grid.mm(*self.start)
        code = 'G71' if self.main == 'Z' else 'G72'
        words = f'I{self.step / 1000} R{self.escape / 1000} D0'
        return '\n'.join([*made, 'O100 ENDSUB', f'G0 X{text_of(x)} Z{text_of(z)}', f'{code} Q100 {words}', 'M2', ''])

    def source(self):
        """Returns the input of dev/g7x_oracle's executable: the numbers that LinuxCNC's program has, as it computes with them."""
        z, x = self.grid.mm(*self.start)
        made = [f'{71 if self.main == "Z" else 72} 0 {z!r} {x!r} 0 {self.step / 1000} {self.escape / 1000}']
        written = lambda point: tuple(float(text_of(value)) for value in point)
        at = written(self.figure.pieces[0].a)
        if math.dist(at, (z, x)) > EPS:
            made.append(f'L {at[0]!r} {at[1]!r}')
        for piece in self.figure.pieces:
            kind = 'L'
            if piece.c is not None:
                centre = (a + float(text_of(c - b)) for a, b, c in zip(at, piece.a, piece.c))
                kind = ' '.join(['A', str(int(piece.ccw)), *map(repr, centre)])
            at = written(piece.b)
            made.append(f'{kind} {at[0]!r} {at[1]!r}')
        return '\n'.join(made) + '\n'

    def fanuc(self):
        """Returns a Program for fanuc-t with the same cycle."""
        p = programs.Program(random.Random(0), self.grid, programs.set_up({}), {})
        p.lines.append('G21')
        p.position(*self.start)
        code, depth = ('G71', 'U') if self.main == 'Z' else ('G72', 'W')
        ns, nf = p.numbers(self.figure)
        p.lines += [f'{code} {p.word(depth, self.step)}{p.word("R", self.escape)}',
                    f'{code} P{ns} Q{nf} {p.word("U", self.u)}{p.word("W", self.w)}F0.2']
        p.figure_text(self.figure)
        return p

    def is_closed_later(self):
        last = self.pieces[-1]
        return last.b[0] - last.a[0] > EPS and last.b[1] > EPS

    def heights(self, motions, allowance):
        """Returns what motions (kind, (Z, X), centre, ccw) cut, the figure moved by the allowance (Z, X): the heights of stock.py."""
        into, over = self.frame.into(tuple(a + b for a, b in zip(self.grid.mm(*self.start), allowance)))
        moves = [(kind, into(to), centre and into(centre), ccw != over) for kind, to, centre, ccw in motions]
        return stock.cut_by(moves, self.pieces)


def of_rs274(rs274, folder, text):
    """Returns the motions of LinuxCNC's own run as (kind, (Z, X), centre, ccw), or its alarm."""
    (folder / 'tool.tbl').write_text('')
    (folder / 'p.var').write_text('')
    (folder / 'main.ngc').write_text(text)
    said, error = rs274.run(folder, 'main.ngc', SECONDS, 'XYZABC')
    if error:
        return error
    found = []
    for action in oracle.Converter().all(said):
        if 'to' in action:
            arc = action['do'].startswith('arc')
            centre = (action['center']['Z'], action['center']['X']) if arc else None
            found.append(('arc' if arc else action['do'], (action['to']['Z'], action['to']['X']), centre, action['do'] == 'arc_ccw'))
    return found


def of_source(one):
    """Returns the motions of the later release's source as (kind, (Z, X), centre, ccw), or its alarm; those of no length are left out."""
    said = subprocess.run([LATER], input=one.source(), capture_output=True, text=True, timeout=SECONDS, check=True).stdout
    here, found = one.grid.mm(*one.start), []
    for line in said.splitlines():
        kind, *numbers = line.split(maxsplit=1) if line.startswith('!') else line.split()
        if kind == '!':
            return numbers[0]
        values = [float(number) for number in numbers]
        to = tuple(values[-2:])
        if kind == 'A':
            one = 'arc', to, tuple(values[1:3]), values[0] == 1
            goes_on = bool(found) and found[-1][0] == 'arc' and math.dist(one[2], found[-1][2]) < EQUAL and one[3] == found[-1][3]
            found[len(found) - goes_on:] = [one]           # an arc may come in two parts
        elif math.dist(to, here) > 1e-7:
            found.append(('rapid' if kind == 'R' else 'feed', to, None, False))
        here = to
    return found


def of_kadr(kadr, folder, text):
    """Returns Kadr's motions of LinuxCNC's program behind that to the start, and the last line of the trace."""
    (folder / 'main.ngc').write_text(text)
    done = subprocess.run([kadr, 'run', 'main.ngc', '--control', 'linuxcnc', '--files', '.', '--trace', '-', '--lang', 'en'], cwd=folder,
                          capture_output=True, timeout=harness.TIME_LIMIT_S, stdin=subprocess.DEVNULL, check=False)
    actions = [json.loads(line) for line in done.stdout.decode().splitlines() if line.startswith('{')]
    motions = lathe_cycles.in_full([a for a in actions if a['do'] in lathe_cycles.MOTIONS], {'X': 0, 'Z': 0})
    return [one[:4] for one in motions[1:]], actions[-1]


def later_faults(kadr, seed):
    """Compares a figure with the source of the later release: Kadr's motions of LinuxCNC's program, and what they leave."""
    one = Figure(seed)
    theirs = of_source(one)
    with tempfile.TemporaryDirectory(prefix='lathe') as place:
        ours, last = of_kadr(kadr, Path(place), one.linuxcnc())
    text = one.linuxcnc() + one.source()
    if isinstance(theirs, str):
        return text, None if last['do'] == 'alarm' and theirs in last['text'] else f'{last["do"]}, LinuxCNC: {theirs}'
    if last['do'] != 'end':                                # whether the search ends over a level at a crest, the last bit decides
        return text, 'no answer' if last.get('id') == 'cycle_endless' else f'kadr run --control linuxcnc: {last.get("text")}'
    for number, (a, b) in enumerate(zip(ours, theirs), 1):
        if a[0] != b[0] or math.dist(a[1], b[1]) > EQUAL or (a[2] and (math.dist(a[2], b[2]) > EQUAL or a[3] != b[3])):
            return text, f'motion {number}: {a}, LinuxCNC {b}'
    if len(ours) != len(theirs):
        return text, f'{len(ours)} motions, LinuxCNC {len(theirs)}'
    left = one.heights([('rapid', one.grid.mm(*one.start), None, False), *theirs], (0, 0))
    worst = max(((abs(x - y), u) for u, x, y in zip(left.u, left.cut, left.figure)), default=(0, 0))
    return text, None if worst[0] < EQUAL else f'LinuxCNC leaves {worst[0]:.5f} at u {worst[1]:.3f}'


def figure_faults(rs274, kadr, seed):
    """Compares a figure's two parts."""
    one = Figure(seed)
    with tempfile.TemporaryDirectory(prefix='lathe') as place:
        folder = Path(place, 'memory')
        folder.mkdir()
        text = one.linuxcnc()
        theirs = of_rs274(rs274, folder, text)
        if isinstance(theirs, str):
            return text, f'rs274: {theirs}'
        # A figure that does not end in a shoulder at S's level is closed up to it by 2.9.3 and later, and Kadr, but not before (docs/controls/linuxcnc-notes.md)
        same = None if one.is_closed_later() else linuxcnc_oracle.difference(rs274, kadr, folder, 'main.ngc', text)
        if same:
            return text, f'kadr run --control linuxcnc: {same}'
        motions, last = lathe_cycles.run(kadr, one.fanuc(), place)
        if last['do'] != 'end':
            return text, f'fanuc-t: {last.get("text")}'
        ours = [got[:4] for got in lathe_cycles.in_full(motions, one.fanuc().setup['start'])]
        a, b = one.heights(theirs, (0, 0)), one.heights(ours, one.allowance)
    worst = max(((abs(x - y), u) for u, x, y in zip(a.u, a.cut, b.cut)), default=(0, 0))
    return text, None if worst[0] < EQUAL else f'the parts differ by {worst[0]:.5f} at u {worst[1]:.3f}'


class Thread:
    """A thread for both controls: outside or inside, to the left or the right."""

    def __init__(self, seed):
        chance = random.Random(seed)
        self.height, self.angle, self.finishing = chance.randint(20, 250) * 10, chance.choice((60, 55, 30, 29, 0)), chance.randint(1, 4)
        self.first = chance.randint(self.height // 8, self.height - 1)
        self.start = (chance.randint(-20, 20) * 100, chance.randint(300, 900) * 200)
        self.away, self.outside = chance.randint(100, 2000), chance.choice((1, -1))
        self.end = (self.start[0] + chance.choice((1, -1)) * chance.randint(8000, 40000), self.start[1] - self.outside * 2 * (self.height + self.away))
        self.lead = chance.randint(5, 30) * 100

    def linuxcnc(self):
        z, x = self.start
        words = f'I{-self.outside * self.away / 1000} J{self.first / 1000} K{self.height / 1000} R2 Q{self.angle / 2} H{self.finishing}'
        return '\n'.join([HEAD, f'G0 X{x / 2000} Z{z / 1000}', f'G76 P{self.lead / 1000} Z{self.end[0] / 1000} {words}', 'M2', ''])

    def fanuc(self):
        p = programs.Program(random.Random(0), Grid(False), programs.set_up({}), {})
        p.position(*self.start)
        p.lines += [f'G76 P{self.finishing:02}00{self.angle:02} Q0 R0',
                    f'G76 {p.word("X", self.end[1])}{p.word("Z", self.end[0])}P{self.height} Q{self.first} {p.word("F", self.lead)}']
        return p

    def passes(self, motions):
        """Returns depth and shift of the start towards the cut of each thread motion, of (kind, (Z, X), centre, ccw)."""
        peak = self.start[1] / 2000 - self.outside * self.away / 1000
        sense, found, at = (1 if self.end[0] > self.start[0] else -1), [], None
        for kind, to, *_ in motions:
            if kind == 'thread':
                found.append((self.outside * (peak - to[1]), sense * (at[0] - self.start[0] / 1000)))
            at = to
        return found


def thread_faults(rs274, kadr, seed):
    """Compares the passes of a thread: depths and shifts of the start. LinuxCNC's end moves with the start, Fanuc's does not."""
    one = Thread(seed)
    with tempfile.TemporaryDirectory(prefix='lathe') as place:
        folder = Path(place, 'memory')
        folder.mkdir()
        text = one.linuxcnc()
        theirs = of_rs274(rs274, folder, text)
        if isinstance(theirs, str):
            return text, f'rs274: {theirs}'
        same = linuxcnc_oracle.difference(rs274, kadr, folder, 'main.ngc', text)
        if same:
            return text, f'kadr run --control linuxcnc: {same}'
        motions, last = lathe_cycles.run(kadr, one.fanuc(), place)
        if last['do'] != 'end':
            return text, f'fanuc-t: {last.get("text")}'
        ours = one.passes([got[:4] for got in lathe_cycles.in_full(motions, one.fanuc().setup['start'])])
    theirs = one.passes(theirs)
    if len(theirs) != len(ours):
        return text, f'{len(ours)} passes, LinuxCNC {len(theirs)}'
    for number, (a, b) in enumerate(zip(ours, theirs), 1):
        if math.dist(a, b) > EQUAL:
            return text, f'pass {number}: depth and shift {a}, LinuxCNC {b}'
    return text, None


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--count', type=int, default=40)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--show', action='store_true', help='print the programs of LinuxCNC that differ')
    options = harness.parsed(parser)
    tally = harness.Tally()
    seeds = range(options.seed, options.seed + options.count)
    with tempfile.TemporaryDirectory(prefix='lathe') as place:
        try:
            rs274 = oracle.Oracle(place)
            compare = lambda seed: (thread_faults if seed % 4 == 0 else figure_faults)(rs274, options.kadr, seed)
            judge_all(tally, 'seed', compare, seeds, options.show)
        except oracle.Absent as absent:
            tally.skip(f'nothing is compared with LinuxCNC: {absent}')
    if LATER:
        judge_all(tally, f'{LATER}, seed', lambda seed: later_faults(options.kadr, seed), seeds, options.show)
    return tally.result()


def judge_all(tally, name, compare, seeds, show):
    def answered(seed):
        try:
            return compare(seed)
        except (subprocess.TimeoutExpired, subprocess.CalledProcessError):     # it never ends, or its stack is full
            return '', 'no answer'

    for seed, (text, fault) in zip(seeds, harness.each(answered, seeds)):
        if fault == 'no answer':
            tally.skip(f'{name} {seed}: LinuxCNC does not end')
            continue
        tally.judge(f'{name} {seed}', [fault] if fault else [])
        if fault and show:
            print('\n'.join(f'    {n} {line}' for n, line in enumerate(text.splitlines(), 1)))


if __name__ == '__main__':
    sys.exit(main())
