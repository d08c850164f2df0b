"""The programs that tests/run_samples.py samples: those of the golden and other cases, and its own of each type.

Each is (name, control, setup, text); the name of an own program starts with its type.
"""
import json
import math
from pathlib import Path

from cases import reader

TESTS = Path(__file__).resolve().parent.parent


def programs_of_cases():
    golden = [(path.stem, json.loads(path.read_text(encoding='utf-8'))) for path in sorted(TESTS.glob('golden/*/*.json'))]
    for name, case in [*((case['id'], case) for case in reader.cases()), *golden]:
        setup = dict(case['setup'])
        if 'channels' in setup:
            continue
        setup.pop('machine', None)
        setup.pop('override', None)
        yield name, case['control'], setup, case['program']


TAPS = {'start': {'Z': 50}, 'parameters': {'N0607.1#2': 1, 'N1503#TSC': 1}, 'spindle': {'1': {'rpm': 500, 'dir': 'cw'}}}
SPINDLE_PROGRAMS = {  # nct 4.4, 18.1.9, 19.B
    'one': ({}, 'S300 M3\nG90 G0 Z5\nG33 Z-20 F2\nM30'),
    'two starts': ({}, 'S457 M3\nG90 G0 Z5\nG33 Z-20 F2\nG0 X1\nZ5\nX0\nG33 Z-20 Q180\nM30'),
    'counter-clockwise': ({}, 'S300 M4\nG90 G0 Z5\nG33 Z-20 F2 Q30\nM30'),
    'inch': ({}, 'S613 M3\nG90 G0 X3 Z5\nG33 Z-20 E8 Q400\nM30'),
    'cone': ({}, 'S300 M3\nG90 G0 Z5\nG33 X4 Z-20 F2 Q270\nG0 X10\nG33 X-10 Z-30 F3\nM30'),
    'chain': ({}, 'S300 M3\nG90 G0 Z5\nG33 Z-20 F2 Q90\nX5 Z-40\nZ-60 F1.5\nX0 Z-64\nG0 X10\nM30'),
    'another speed': ({}, 'S300 M3\nG90 G0 Z5\nG33 Z-20 F2 Q90\nS500\nG0 Z5\nG33 Z-20\nG0 X2\nM5\nG4 P0.3\nM3\nG0 X0 Z5\nG33 Z-20 Q10\nM30'),
    'behind other motions': ({}, 'S300 M3\nG90 G0 Z5\nG1 X20 F2000\nY5\nS450\nX0\nG33 Z-20 F2 Q45\nM30'),
    'turning cycle': ({'start': {'X': 50, 'Z': 10}, 'modal': ['G18', 'G90', 'G95'], 'spindle': {'1': {'rpm': 500, 'dir': 'cw'}}},
                      'G78.7 X40 Z-20 F2 Q90\nX39\nM30'),
    'tap': (TAPS, 'G84.2 X10 Z-8 R2 P0.5 F625 S500\nX20\nM30'),
    'tap left': (TAPS, 'G84.3 X10 Z-8 R2 P0.5 F625 S500 Q3\nM30'),
}


def spindle_programs():
    for name, (setup, text) in SPINDLE_PROGRAMS.items():
        yield f'spindle {name}', 'nct', setup, text


TURNING = {'start': {'X': 50}, 'modal': ['G18', 'G90', 'G95']}
TURNING_PROGRAMS = {  # nct 11.5: every feed is 0.2 mm/rev
    'facing': (TURNING, 'G92 S3000\nG96 S200 P1 M3\nG1 X0 F0.2\nM30'),
    'profile': (TURNING, 'G92 S2500\nG96 S250 P1 M4\nG1 Z-10 F0.2\nX40 Z-30\nG2 X20 Z-50 R20\nG1 X5\nM30'),
}


def turning_programs():
    for name, (setup, text) in TURNING_PROGRAMS.items():
        yield f'turning {name}', 'nct', setup, text


POLAR = {'axes': ['X', 'Z', 'C'], 'start': {'X': 50}, 'parameters': {'N0106.C#1': 1, 'N0305.C': 3600}}
CYLINDER = {'axes': ['X', 'Y', 'Z', 'A'], 'start': {'Z': 100}, 'parameters': {'N0106.A#1': 1}}
SURFACE_PROGRAMS = {  # nct 4.5, 4.6: setup, radius of the cylinder or 0, feed, contour in the plane
    'polar near the centre': (POLAR, 0, 1000, [(50, 1), (-50, 1)]),
    'polar contour': (POLAR, 0, 1000, [(50, 10), (30, 40), (-20, 30), (-35, -10), (20, -20), (50, 0)]),
    'polar outside': ({**POLAR, 'start': {'X': 150}}, 0, 3000, [(150, 100), (-100, 100), (-100, -50)]),
    'cylinder': (CYLINDER, 28.65, 1500, [(0, 0), (-20, 15), (-20, 30), (10, 45.5), (0, 0)]),
    'cylinder large': (CYLINDER, 120, 3000, [(0, 10), (-20, 150), (-80, 30.5), (0, 0)]),
}


def surface_programs():
    for name, (setup, radius, feed, contour) in SURFACE_PROGRAMS.items():
        second = 'C' if radius == 0 else 'A'
        if radius:
            lines = [f'G90 G17 G0 X{contour[0][0]} A0', f'G7.1 A{radius}', f'G1 A{math.degrees(contour[0][1] / radius)} F{feed}']
            lines += [f'X{x} A{math.degrees(w / radius):.9f}' for x, w in contour[1:]] + ['G7.1 A0']
        else:
            lines = [f'G90 G17 G0 X{setup["start"]["X"]} C0', 'G12.1', f'G1 X{contour[0][0]} C{contour[0][1]} F{feed}']
            lines += [f'X{x} {second}{w}' for x, w in contour[1:]] + ['G13.1']
        yield f'surface {name}', 'nct', setup, '\n'.join(lines) + '\nM30'


WAVE = [(x / 2, 5 * math.sin(x / 16)) for x in range(0, 120)]
SMOOTH_PROGRAMS = {  # nct 4.7: Q, its tolerance, mm; N3100 to N3102; points
    'q2': (2, 0.02, (5, 0, 20), WAVE),
    'q2 large turns': (2, 0.2, (5, 0, 80), [(x, (x % 3) * 0.4) for x in range(0, 60)]),
    'q3': (3, 0.02, (5, 0, 20), WAVE),
    'q3 large': (3, 0.2, (50, 0, 100), [(x, (x % 3) * 0.7) for x in range(0, 60)]),
    'q3 corners': (3, 0.05, (50, 0, 30), [(0, 0), (10, 0), (20, 1), (30, 3), (30, 20), (31, 30), (10, 30)]),
}


def smooth_programs():
    for name, (q, tolerance, (longest, shortest, angle), points) in SMOOTH_PROGRAMS.items():
        setup = {'parameters': {'N3100': longest, 'N3101': shortest, 'N3102': angle, 'N3104' if q == 2 else 'N3106': tolerance}}
        lines = [f'G90 G0 X{points[0][0]} Y{points[0][1]:.4f}', f'G5.1 Q{q} X0 Y0', 'G1 F4000']
        lines += [f'X{x} Y{y:.4f}' for x, y in points[1:]] + ['G5.1 Q0', 'M30']
        yield f'smoothing {name}', 'nct', setup, '\n'.join(lines)


def own_programs():
    for programs in (spindle_programs, surface_programs, smooth_programs, turning_programs):
        yield from programs()


def random_programs(choose, count):
    for i in range(count):
        kind = choose.choice(('short', 'long', 'arcs', 'noise', 'back'))
        lines, x, y, a = [f'G21 G90 G17 G64\nG0 X0 Y0 Z5\nG1 Z0 F{choose.choice((300, 1500, 4000, 9000))}'], 0.0, 0.0, 0.0
        for n in range(choose.randint(3, 120)):
            if kind == 'arcs':
                r = choose.uniform(0.3, 12)
                x += 2 * r
                lines.append(f'G{choose.choice((2, 3))} X{x:.3f} Y{y:.3f} I{r:.3f} J0')
                continue
            step = {'short': choose.uniform(0.02, 0.4), 'long': choose.uniform(1, 60), 'noise': choose.uniform(0.001, 5),
                    'back': choose.uniform(0.5, 20)}[kind]
            a = a + math.pi if kind == 'back' and choose.random() < 0.6 else a + choose.gauss(0, 0.1 if kind == 'short' else 1.2)
            x, y = x + step * math.cos(a), y + step * math.sin(a)
            z = f' Z{choose.uniform(-1, 1):.3f}' if choose.random() < 0.2 else ''
            g = 0 if choose.random() < 0.05 else 1
            lines.append(f'G{g} X{x:.4f} Y{y:.4f}{z}' + (f' F{choose.randint(200, 9000)}' if choose.random() < .1 else ''))
        yield f'random {i} {kind}', 'mach3', {}, '\n'.join(lines) + '\nM30\n'
