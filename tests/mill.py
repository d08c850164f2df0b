#!/usr/bin/env python3
"""Tests kadr mill from outside: with every scheme, plunge and control the control executes the resulting program along the walls of the
pocket.

    tests/mill.py --kadr PROGRAM
"""
import json
import math
import os
import pty
import signal
import subprocess
import sys
import tempfile

import harness

SCHEMES = ['zigzag', '1zigzag', '2zigzag', 'spiral-out', 'spiral-in', 'comb', '1comb', '2comb']
# as printed in the source: with blanks, some with their direction (shared/seeds, figure of the schemes)
RUSSIAN = ['ЗИГЗАГ', '1 ЗИГЗАГ', '2 ЗИГЗАГ', 'СПИР ПЧС', 'АСПИР ЧС', 'ШТИП', '1 ШТИП', '2 ШТИП']
SAME = [('1ЗИГЗАГ', '1 зигзаг'), ('СПИР', 'спир пчс'), ('СПИРЧС', 'СПИР ЧС'), ('АСПИР', 'АСПИР ЧС'), ('2\u00a0ШТИП', '2ШТИП')]
CONTROLS = ['s2c42', 'mach3', 'nct', 'correctors', 'gost', 'heidenhain']
PLUNGES = ['hole', 'tangential', 'ramp']
WIDTH, HEIGHT, TOOL, DEPTH, ISLAND = 60, 40, 10, 4, (30, 20, 4)   # a pocket with a round island

TEXT = f'from 0 0\nline {WIDTH} 0\nline {WIDTH} {HEIGHT}\nline 0 {HEIGHT}\nclose\ncircle {ISLAND[0]} {ISLAND[1]} {ISLAND[2]}\n'
SVG = (f'<svg width="{WIDTH}mm" height="{HEIGHT}mm" viewBox="0 0 {WIDTH} {HEIGHT}"><rect width="{WIDTH}" height="{HEIGHT}"/>'
       f'<circle cx="{ISLAND[0]}" cy="{ISLAND[1]}" r="{ISLAND[2]}"/></svg>')
CORNERS = [(0, 0), (WIDTH, 0), (WIDTH, HEIGHT), (0, HEIGHT)]
DXF = ('0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n' + ''.join(f'10\n{x}\n20\n{y}\n' for x, y in CORNERS) +
       f'0\nCIRCLE\n8\n0\n10\n{ISLAND[0]}\n20\n{ISLAND[1]}\n40\n{ISLAND[2]}\n0\nENDSEC\n0\nEOF\n')

# drawing, options besides --tool-diameter 10 --depth 4, exit status, alarm
FAULTS = [
    ('from 0 0\nline 60 0\nline 60 40\n', [], 1, 'contour_open_end'),
    ('from 0 0\nline 60 0\nline 0 40\nline 60 40\nclose\n', [], 1, 'contour_crosses'),
    (TEXT + 'from 0 0\nline 5 5\n', [], 1, 'contour_branch'),
    ('nothing\n', [], 1, 'contour_syntax'),
    ('', [], 1, 'contour_empty'),
    ('from 0 0\nline 60 0\nline 60 8\nline 0 8\nclose\n', [], 1, 'tool_does_not_fit'),
    (TEXT, ['--stepover', '120%'], 2, 'mill_stepover'),
    (TEXT, ['--stepover', 'wide'], 2, 'mill_value'),
    (TEXT, ['--scheme', 'star'], 2, "--scheme: 'star' is none of zigzag"),
    (TEXT, ['--scheme', 'СПИР ПЧС', '--direction', 'ЧС'], 2, 'mill_value'),
    (TEXT, ['--feed', '-3'], 2, 'mill_value'),
    (TEXT, ['--plunge', 'hole', '--hole', '30', '20'], 1, 'mill_hole'),
    (TEXT.replace('from 0 0', 'from 0 0', 1), ['--top', '99999'], 1, 'word_has_no_room'),
]


class Runner(harness.Kadr):
    def __init__(self, program, folder):
        super().__init__(program, folder)
        self.tally = harness.Tally()
        self.expect = self.tally.expect

    def mill(self, drawing, control, *options, task='pocket'):
        contour, program = self.file('contour', drawing), self.folder / 'program.nc'
        program.unlink(missing_ok=True)
        language = [] if '--lang' in options else ['--lang', 'en']
        done = self.call('mill', task, contour, '--tool-diameter', TOOL, '--depth', DEPTH, '--control', control, '--output', program, *language, *options)
        return done, program

    def trace(self, program, control):
        """Returns (do, from, to) of every motion, by `kadr run`."""
        done = self.call('run', program, '--control', control, '--trace', '-', '--quiet', '--lang', 'en')
        at, moves = {'X': 0, 'Y': 0, 'Z': 0}, []
        for row in map(json.loads, done.stdout.splitlines()):
            if 'to' in row and row['do'] in ('rapid', 'feed', 'arc_cw', 'arc_ccw'):
                to = {**at, **row['to']}
                moves.append((row['do'], at, to))
                at = to
        return done.returncode, moves

    def keeps_off(self, moves):
        """All motions below the top end at least a radius off the walls; rapid motion there is vertical only."""
        for do, start, to in moves:
            if min(start['Z'], to['Z']) >= -1e-6:
                continue
            x, y = to['X'], to['Y']
            off = min(x, y, WIDTH - x, HEIGHT - y, math.hypot(x - ISLAND[0], y - ISLAND[1]) - ISLAND[2])
            if off < TOOL / 2 - 0.002 or (do == 'rapid' and math.hypot(x - start['X'], y - start['Y']) > 0.002):
                return False
        return True

    def good(self, what, drawing, control, *options):
        done, program = self.mill(drawing, control, *options)
        self.expect(done.returncode == 0, f'{what}: {done.stderr}')
        if done.returncode != 0:
            return ''
        status, moves = self.trace(program, control)
        deepest = min((to['Z'] for _, _, to in moves), default=0)
        self.expect(status == 0 and abs(deepest + DEPTH) < 1e-6 and self.keeps_off(moves), f'{what}: the program itself')
        return program.read_text(encoding='utf-8')


def names(run):
    """Names with and without blanks mean the same, and are displayed as printed in the source."""
    for one, other in SAME:
        texts = [run.good(name, TEXT, 'mach3', '--scheme', name) for name in (one, other)]
        run.expect(texts[0] and texts[0] == texts[1], f'{one} and {other}')
    done, _ = run.mill(TEXT, 'mach3', '--scheme', '1zigzag')
    run.expect('1 ЗИГЗАГ ПЧС' in done.stdout, f'the name as printed: {done.stdout}')
    done, _ = run.mill(TEXT, 'mach3', '--lang', 'ru')
    run.expect('врезание         СПУСК: ' in done.stdout and '; 3°' in done.stdout, f'the way down in Russian: {done.stdout}')


def seconds(run, scheme, stepover):
    """Returns the processor time: wall-clock time depends on what else runs."""
    before = harness.spent_by_children()
    done, _ = run.mill(TEXT, 'mach3', '--scheme', scheme, '--stepover', stepover)
    run.expect(done.returncode == 0, f'{scheme} {stepover}: {done.stderr}')
    return harness.spent_by_children() - before


def speed(run):
    """Rings and lifted rows take at most a few times as long as zigzag rows, and twice the passes twice the time (issue 15: they took 30
    times, and four times, as long)."""
    zigzag = seconds(run, 'zigzag', '0.2')
    for scheme in ('spiral-out', 'spiral-in', 'comb', '2comb'):
        fine, coarse = seconds(run, scheme, '0.2'), seconds(run, scheme, '0.4')
        run.expect(fine < 10 * zigzag + 0.2, f'{scheme} takes {fine} s, zigzag {zigzag} s')
        run.expect(fine < 3.2 * coarse + 0.2, f'{scheme}: step 0.4 takes {coarse} s, 0.2 {fine} s')


def all_of(terminal):
    """Returns what was written to a terminal whose other end is closed."""
    parts = []
    try:
        while part := os.read(terminal, 1 << 16):
            parts.append(part)
    except OSError:  # Linux: no writer is left
        pass
    os.close(terminal)
    return b''.join(parts).decode()


def until_bar(terminal):
    """Returns the terminal output up to the first progress display; all output if there is none."""
    shown = ''
    while ' %  ' not in shown:
        try:
            part = os.read(terminal, 1 << 16)
        except OSError:
            break
        if not part:
            break
        shown += part.decode(errors='replace')
    return shown


def stopped(run):
    """Work of minutes shows its progress on a terminal, ends soon after Ctrl-C or SIGTERM, and leaves no program file."""
    contour, program = run.file('contour', TEXT.replace('60', '600').replace('40', '400')), run.folder / 'stopped.nc'
    for sign, scheme in ((signal.SIGINT, 'spiral-out'), (signal.SIGTERM, 'comb')):
        terminal, end = pty.openpty()
        process = run.start('mill', 'pocket', contour, '--tool-diameter', '10', '--depth', '4', '--control', 'mach3', '--scheme', scheme,
                            '--stepover', '0.02', '--output', program, '--lang', 'en', stdout=subprocess.DEVNULL, stderr=end)
        os.close(end)
        shown = until_bar(terminal)
        took = harness.spent_after(process, sign)
        status = process.returncode
        shown += all_of(terminal)
        run.expect(status in (128 + sign, -sign) and took < 2 and not program.exists(), f'{scheme}: status {status}, {took:.1f} s of work after {sign.name}')
        run.expect(' %  ' in shown, f'{scheme}: on the terminal: {shown[-300:]!r}')


def main():
    kadr = harness.kadr_of(__doc__)
    with tempfile.TemporaryDirectory() as folder, Runner(kadr, folder) as run:
        for i, (scheme, russian) in enumerate(zip(SCHEMES, RUSSIAN)):
            by_name = {}
            for control in CONTROLS:
                by_name[control] = run.good(f'{scheme}, {control}', TEXT, control, '--scheme', scheme, '--pass', '2', '--speed', '800')
            control = CONTROLS[i % len(CONTROLS)]
            run.expect(run.good(russian, TEXT, control, '--scheme', russian, '--pass', '2', '--speed', '800') == by_name[control], russian)
        for plunge in PLUNGES:
            for control in CONTROLS:
                run.good(f'{plunge}, {control}', TEXT, control, '--plunge', plunge, '--tool', '4', '--coolant')
        programs = {run.good(name, drawing, 'mach3') for name, drawing in (('text', TEXT), ('SVG', SVG), ('DXF', DXF))}
        run.expect(len({len(p.splitlines()) for p in programs}) == 1, 'the three formats give programs of the same length')
        marked = run.good('ПС', TEXT, 's2c42', '--mark', 'ПС')
        run.expect(marked and all(line.endswith(' ПС') for line in marked.splitlines()), 'every block ends with ПС')
        names(run)
        speed(run)
        stopped(run)
        for drawing, options, status, alarm in FAULTS:
            done, program = run.mill(drawing, 's2c42', *options)
            run.expect(done.returncode == status and alarm in done.stderr and not program.exists(), f'{alarm}: {done.returncode} {done.stderr}')
        for control in ('fanuc-t', 'fanuc-t-c'):   # a lathe: its X is a diameter
            done, program = run.mill(TEXT, control)
            run.expect(done.returncode == 1 and f'mill_lathe: {control} ' in done.stderr and not program.exists(), f'{control}: {done.stderr}')
        return run.tally.result()


if __name__ == '__main__':
    sys.exit(main())
