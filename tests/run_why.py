#!/usr/bin/env python3
"""Tests the output of the minimum-time planner (docs/planner.md): `kadr run` with --why, --plot-speed and --plot --colour.

    run_why.py --kadr build/kadr

Expected values are calculated by hand, on machines/linuxcnc-sim: 200 mm/s, 1000 mm/s², 20,000 mm/s³. A line from stop to stop at the
speed v takes v/a + a/j longer than at its feed where v ≥ a²/j = 50 mm/s, else 2·√(v/j). Its four phases of jerk, a/j each, lose half of
their time, 0.1 s (less where the speed is not reached); the rest is lost by the acceleration.
"""
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import harness


# line, time, by feed, lost, by, block
PROGRAM = '''G21 G90 G17 G61
G1 X200 F6000
G0 Y50
G1 Z-10 F600
G4 P0.5
M98 P100 L3
M30
O100
G91 G1 X20 F6000
G90 G1 Y50
G91 G1 Y20 F3000
G90 G1 Y50 F12000
M99
'''
ROWS_EN = '''9 (3 times) 1.050 0.600 0.450 jerk, X 67 % G91 G1 X20 F6000
11 (3 times) 1.500 1.200 0.300 jerk, Y 100 % G91 G1 Y20 F3000
3 0.500 0.250 0.250 acceleration, Y 60 % G0 Y50
2 2.150 2.000 0.150 jerk, X 67 % G1 X200 F6000
4 1.045 1.000 0.045 jerk, Z 100 % G1 Z-10 F600'''.splitlines()
# 20 mm at 200 mm/s: two ramps of 10 mm; a/2 (√(T² + 4 L/a) − T) = 118.6 mm/s is reached, T = 0.05 s; 2 (0.1186 + 0.05) s instead of 0.1 s
FAST_ROW = r'12 \(3 times\) 1.01[12] 0.300 0.71[12] \S+ Y \d+ % G90 G1 Y50 F12000'

SLOW, FASTER = (0xB2, 0x18, 0x2B), (0xE0, 0x82, 0x14)
SLOWEST = tuple(a + (b - a) * 5 * 0.5 / 24 for a, b in zip(SLOW, FASTER))  # the middle of the first of 24 steps over 5 spans
INK = {'corner': (0xD5, 0x5E, 0x00), 'feed': (0x00, 0x9E, 0x73), 'acceleration': (0xE6, 0x9F, 0x00), 'curve': (0xCC, 0x79, 0xA7),
       'slow': SLOWEST, 'axis X': (0xD5, 0x5E, 0x00), 'axis Y': (0x00, 0x9E, 0x73), 'axis Z': (0x6A, 0x3D, 0x9A),
       'commanded': (0xE6, 0x9F, 0x00), 'dwell': (0xF0, 0xC9, 0x3A), 'rapid': (0x7A, 0x87, 0x94)}


class Bench:
    def __init__(self, kadr, folder):
        self.kadr, self.folder, self.tally = kadr, Path(folder), harness.Tally()

    def check(self, name, good, why=''):
        self.tally.expect(good, name, why)

    def run(self, program, *options, control='mach3', machine='linuxcnc-sim', setup=None):
        (self.folder / 'p.nc').write_text(program, encoding='utf-8')
        (self.folder / 'setup.json').write_text(json.dumps(setup or {}), encoding='utf-8')
        command = [self.kadr, 'run', 'p.nc', '--control', control, '--machine', machine, '--setup', 'setup.json', *options]
        return subprocess.run(command, capture_output=True, text=True, cwd=self.folder, timeout=harness.TIME_LIMIT_S)

    def svg(self, program, *options):
        """Returns how often each colour occurs in the picture; None if there is no picture."""
        file = self.folder / 'out.svg'
        file.unlink(missing_ok=True)
        done = self.run(program, '-q', *[o.replace('OUT', 'out.svg') for o in options])
        if done.returncode != 0 or not file.exists():
            return None
        text = file.read_text()
        return {name: strokes_of(text, '#%02x%02x%02x' % tuple(round(c) for c in rgb)) for name, rgb in INK.items()}


def strokes_of(text, ink):
    """Returns the strokes and areas of a colour."""
    groups = re.findall(rf'<g [^>]*stroke="{ink}"[^>]*>(.*?)</g>', text, re.DOTALL)
    return sum(group.count('<path') for group in groups) + len(re.findall(rf'fill="{ink}"', text))


def rows_of(text):
    lines = [' '.join(line.split()) for line in text.splitlines()]
    head = next((i for i, line in enumerate(lines) if line.startswith(('line time', 'строка время'))), None)
    return [] if head is None else lines[head + 1:-1]


def tables(bench):
    done = bench.run(PROGRAM, '--why', '--lang', 'en')
    rows = rows_of(done.stdout)
    bench.check('the fastest line loses most', len(rows) == 6 and re.fullmatch(FAST_ROW, rows[0]), rows[:1])
    for row in ROWS_EN:
        bench.check('row ' + row, row in rows, rows)
    bench.check('the worst first', [r for r in rows if r in ROWS_EN] == ROWS_EN, rows)
    bench.check('pauses lose nothing', not any('G4' in r for r in rows), rows)
    ru = bench.run(PROGRAM, '--why', '--lang', 'ru').stdout
    words = (('jerk', 'рывок'), ('acceleration', 'ускорение'), ('times', 'раз'))
    for row in ROWS_EN:
        for en, word in words:
            row = row.replace(en, word)
        bench.check('Russian row ' + row, row in rows_of(ru), rows_of(ru))
    bench.check('Russian heading', 'потери времени' in ru and 'мин. время' in ru, ru)
    # dwell 0.5 s; G0 Y50 0.5 s, all of it ramps
    bench.check('time split', re.search(r'least time +\S+ \(cutting \S+, rapid 0:00.5, dwell 0:00.5, tool change 0:00.0\)', done.stdout), done.stdout)
    bench.check('ramps', re.search(r'rapid speeding up 0:00.[23], slowing down 0:00.[23]', done.stdout), done.stdout)
    quiet = bench.run(PROGRAM, '--why', '-q', '--lang', 'en').stdout
    bench.check('quiet: the table alone', quiet.startswith('lost time') and rows_of(quiet) == rows, quiet)
    plain = bench.run(PROGRAM, '--lang', 'en').stdout
    bench.check('without the planner as ever', 'least time' not in plain and plain.count('\n') + 3 == done.stdout[:done.stdout.index('lost time')].count('\n'), plain)


def mode(bench):
    """X200 at 100 mm/s from stop to stop takes 2.15 s, two of them as programmed; `planner` decides which time the machine shows."""
    rows = ''.join(f'{axis} = {{ rapid = 12000, acceleration = 1000, jerk = 20000 }}\n' for axis in 'XYZ')
    machine = 'id = "m"\ntool_change = 0\nPLANNER\n[axes]\n' + rows
    for planner, time, other in (('planner = "optimal"', '2.1', 'from programmed'), ('planner = "control"', '2.2', 'from programmed'), ('', '2.0', "Kadr's planner")):
        (bench.folder / 'm.toml').write_text(machine.replace('PLANNER', planner))
        text = bench.run('G61 G21 G90\nG1 X200 F6000\nM30\n', '--lang', 'en', machine='m.toml').stdout
        bench.check(f'mode {planner}', re.search(rf'^time +0:0{time} ', text, re.M) and other not in text and 'least time' not in text, text)


def overrides(bench):
    """100 mm/s along X. An override of 50 % from the start: twice as long. A feed hold of 1 s; the axes stop meanwhile."""
    program = 'G61 G21 G90\nG1 X100 F6000\nM30\n'

    def samples(*options):
        done = bench.run(program, '-q', '--samples', '-', *options)
        return [tuple(map(float, row.split(','))) for row in done.stdout.splitlines()[1:]]

    plain, half, held = samples(), samples('--override', '0:50'), samples('--override', '0.5:0,1.5:100')
    bench.check('plain', abs(plain[-1][0] - 1.15) < 0.002 and plain[-1][1] == 100, plain[-1])
    bench.check('half', abs(half[-1][0] - 2.3) < 0.003 and half[-1][1] == 100, half[-1])
    bench.check('hold', plain[-1][0] + 0.95 < held[-1][0] < plain[-1][0] + 1.3 and held[-1][1] == 100, held[-1])
    bench.check('stands', held[900][1] == held[1499][1] < held[1600][1], held[900])
    bench.check('for ever', 0.5 < samples('--override', '0.5:0')[-1][0] < 0.8, '')
    for wrong in ('1', '1:101', '-1:50', '1:x', ':5', '1:nan'):
        bench.check(f'wrong usage {wrong}', bench.run(program, '-q', f'--override={wrong}').returncode == 2, wrong)


def other_files(bench):
    """A line of a called file is shown with that file's name and text, not with the program's line of the same number."""
    (bench.folder / 'O7000.nc').write_text('%O7000\n(SUB)\nG1 Y200 F6000\nM99\n%\n')
    done = bench.run('%O1\nM98 P7000\nG1 X100 F6000\nM30\n%\n', '--why', '-q', '--lang', 'en', control='nct')
    rows = rows_of(done.stdout)
    bench.check('file of the line', any(r.startswith('O7000.nc:3 2.') and r.endswith('G1 Y200 F6000') for r in rows), done.stdout + done.stderr)
    bench.check('the same line of the program', any(r.startswith('3 1.') and r.endswith('G1 X100 F6000') for r in rows), done.stdout)


def bad_input(bench):
    for options in (('--plot-speed', 'x.pdf'), ('--plot', 'x'), ('--colour', 'speed'), ('--plot', 'x.svg', '--colour', 'green')):
        done = bench.run(PROGRAM, '-q', *options)
        bench.check(f'wrong usage {options}', done.returncode == 2 and done.stderr, done)
    done = bench.run('G61 G21 G90\nG1 X200 F6000\nG1 Y10 Q!\n', '--why', '--lang', 'en')
    bench.check('alarm: what ran', done.returncode == 1 and rows_of(done.stdout) == ['2 2.150 2.000 0.150 jerk, X 67 % G1 X200 F6000'], done)
    for empty in ('', '\n', 'M30\n'):
        done = bench.run(empty, '--why', '-q', '--lang', 'en', '--plot-speed', 'e.svg', '--plot', 'f.png', '--colour', 'limit')
        bench.check('empty', done.returncode in (0, 1) and 'nothing' in done.stdout and (bench.folder / 'e.svg').exists(), done)
    done = bench.run('G61 G21 G90\nG1 X200 F6000\nG0 Y50\nM30\n', '--why', '--lang', 'en', '--plot-speed', 'n.png', setup={'override': {'feed': 0}})
    bench.check('never ends', done.returncode == 0 and [r.split()[0] for r in rows_of(done.stdout)] == ['3'], done)


def channels(bench):
    other = 'O2\nG1 X50 F600\nM30\n'
    done = bench.run('O1\nG61 G1 X200 F6000\nM30\n', '--why', '--lang', 'en', control='nct', setup={'channels': {'2': {'axes': ['X', 'Z'], 'program': other}}})
    tail = done.stdout[done.stdout.index('lost time') - len('channel 1\n'):] if 'lost time' in done.stdout else ''
    bench.check('channels: the own one', tail.startswith('channel 1\nlost time') and len(rows_of(tail)) == 1 and 'X200' in tail, done.stdout + done.stderr)


def pictures(bench):
    corner = 'G21 G90 G17 G64 P0.02\nG1 X40 F6000\nG1 Y40\nM30\n'
    inks = bench.svg(corner, '--plot', 'OUT', '--colour', 'limit') or {}
    bench.check('limit: corner and feed', inks.get('corner', 0) > 4 and inks.get('feed', 0) > 4 and inks['curve'] == 0, inks)
    inks = bench.svg('G21 G90 G17 G61\nG1 X40 F6000\nM30\n', '--plot', 'OUT', '--colour', 'limit') or {}
    bench.check('limit: no corner', inks.get('corner') == 0 and inks.get('feed', 0) > 4, inks)
    inks = bench.svg(corner, '--plot', 'OUT', '--colour', 'speed') or {}
    bench.check('speed: it stands somewhere', inks.get('slow', 0) > 4 and inks['feed'] == 0, inks)
    inks = bench.svg(corner, '--plot', 'OUT') or {}
    bench.check('without colours as ever', inks.get('slow') == 0, inks)
    inks = bench.svg('G21 G90 G61\nG1 X40 F6000\nG4 P1\nG1 Y9\nM30\n', '--plot-speed', 'OUT') or {}
    bench.check('speed page: X and Y', inks.get('axis X', 0) >= 2 and inks['axis Y'] >= 2 and inks['axis Z'] == 0, inks)
    bench.check('speed page: feed and dwell', inks.get('commanded', 0) >= 2 and inks['dwell'] >= 2, inks)


def main():
    kadr = harness.kadr_of(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(kadr, folder)
        for part in (tables, mode, overrides, other_files, bad_input, channels, pictures):
            part(bench)
    return bench.tally.result()


if __name__ == '__main__':
    sys.exit(main())
