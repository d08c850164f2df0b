#!/usr/bin/env python3
"""Tests the milling cycles whose contour is a subprogram: CYCLE72 of the Sinumerik, the SL cycles of the Heidenhain. The trace is judged here by
geometry alone: distances of the tool's centre from the contours, and sampled points that must be cut.

    tests/contour_cycles.py --kadr PROGRAM [--only NAME]
"""
import json
import math
import random
import sys

import harness
from harness import expect

RADIUS = 4.0
STEP = 0.25   # mm between the points at which a path is sampled


def polygon(rng, centre, least, most, corners):
    """A star-shaped polygon, counter-clockwise, corners rounded to 0.001 mm."""
    turns = sorted(2 * math.pi * (i + rng.uniform(-0.3, 0.3)) / corners for i in range(corners))
    return [(round(centre[0] + (r := rng.uniform(least, most)) * math.cos(a), 3), round(centre[1] + r * math.sin(a), 3)) for a in turns]


def sides(loop):
    return list(zip(loop, loop[1:] + loop[:1]))


def distance(p, a, b):
    vx, vy = b[0] - a[0], b[1] - a[1]
    size = vx * vx + vy * vy
    t = max(0.0, min(1.0, ((p[0] - a[0]) * vx + (p[1] - a[1]) * vy) / size)) if size else 0
    return math.dist(p, (a[0] + t * vx, a[1] + t * vy))


def inside(p, loop):
    odd = False
    for a, b in sides(loop):
        if (a[1] > p[1]) != (b[1] > p[1]) and p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]):
            odd = not odd
    return odd


def sampled(trace):
    """Yields (kind, x, y, z) along the motions of a trace."""
    at = [0.0, 0.0, 0.0]
    for line in trace.splitlines():
        event = json.loads(line)
        kind = event.get('do')
        if 'to' not in event or kind not in ('rapid', 'feed', 'arc_cw', 'arc_ccw'):
            continue
        to = [event['to'].get(axis, at[i]) for i, axis in enumerate('XYZ')]
        if kind.startswith('arc'):
            cx, cy = event['center']['X'], event['center']['Y']
            radius, start = math.dist(at[:2], (cx, cy)), math.atan2(at[1] - cy, at[0] - cx)
            sweep = 2 * math.pi * event['turns'] * (1 if kind == 'arc_ccw' else -1)
            count = max(1, int(abs(sweep) * radius / STEP))
            points = [(cx + radius * math.cos(start + sweep * i / count), cy + radius * math.sin(start + sweep * i / count),
                       at[2] + (to[2] - at[2]) * i / count) for i in range(1, count + 1)]
        else:
            count = max(1, int(math.dist(at, to) / STEP))
            points = [tuple(at[j] + (to[j] - at[j]) * i / count for j in range(3)) for i in range(1, count + 1)]
        for point in points:
            yield (kind, *point)
        at = to


def traced(kadr, name, text, control, setup):
    kadr.file(name, text)
    kadr.file('setup.json', json.dumps(setup))
    done = kadr.call('run', '--control', control, '--setup', 'setup.json', '--trace', 'out.jsonl', '--quiet', name)
    expect(done.returncode == 0, f'exit status {done.returncode}: {done.stdout}{done.stderr}\n{text}')
    return list(sampled((kadr.folder / 'out.jsonl').read_text(encoding='utf-8')))


def contour_program(loop, side):
    lines = [f'  L X{loop[0][0]:+.3f} Y{loop[0][1]:+.3f} {side}']
    return lines + [f'  L X{x:+.3f} Y{y:+.3f}' for x, y in loop[1:] + loop[:1]]


SL_DATA = '''CYCL DEF 20 CONTOUR DATA ~
  Q1=-6 ~
  Q2=+1 ~
  Q3=+{side} ~
  Q4=+{floor} ~
  Q5=+0 ~
  Q6=+2 ~
  Q7=+30 ~
  Q8=+0 ~
  Q9=+{sense}
'''


def sl_program(contours, cycle, side=0.3, floor=0.5, sense=1):
    """`contours`: (loop, is an island)."""
    text = 'BEGIN PGM T MM\nTOOL CALL 1 Z S2000\nL Z+50 R0 FMAX M3\nCYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL '
    text += '/'.join(str(i + 1) for i in range(len(contours))) + '\n' + SL_DATA.format(side=side, floor=floor, sense=sense)
    text += cycle + '\nCYCL CALL\nL Z+50 R0 FMAX M2\n'
    for i, (loop, island) in enumerate(contours):
        # the tool is left of a counter-clockwise contour, which is inside, and right of it outside
        text += '\n'.join([f'LBL {i + 1}', *contour_program(loop, 'RR' if island else 'RL'), 'LBL 0']) + '\n'
    return text + 'END PGM T MM\n'


ROUGH = 'CYCL DEF 22 ROUGH-OUT ~\n  Q10=-2.5 ~\n  Q11=+150 ~\n  Q12=+400 ~\n  Q18=+0 ~\n  Q19=+0 ~\n  Q208=+9999'
FLOOR = 'CYCL DEF 23 FLOOR FINISHING ~\n  Q11=+150 ~\n  Q12=+300'
WALLS = 'CYCL DEF 24 SIDE FINISHING ~\n  Q9=+1 ~\n  Q10=-3 ~\n  Q11=+150 ~\n  Q12=+300 ~\n  Q14=+0'
SETUP = {'offsets': {'1': {'radius': RADIUS}}}
WALL_TOLERANCE = 0.02   # mm; path/pocketing keeps walls within tol::area_wall


def areas(rng):
    """Pockets and islands: apart from each other, or crossing each other."""
    pocket = polygon(rng, (0, 0), 30, 45, rng.randint(4, 8))
    other = polygon(rng, (rng.uniform(25, 60), rng.uniform(-15, 15)), 15, 30, rng.randint(3, 7))
    island = polygon(rng, (rng.uniform(-8, 8), rng.uniform(-8, 8)), 4, 9, rng.randint(3, 6))
    return [[(pocket, False)], [(pocket, False), (island, True)], [(pocket, False), (other, False)], [(pocket, False), (other, False), (island, True)]]


def to_remove(p, contours):
    return any(inside(p, loop) for loop, island in contours if not island) and not any(inside(p, loop) for loop, island in contours if island)


def boundary(contours):
    """The walls of the area: sampled points of the contours that are not inside another contour's area."""
    points = []
    for loop, island in contours:
        others = [(each, kind) for each, kind in contours if each is not loop]
        for a, b in sides(loop):
            count = max(1, int(math.dist(a, b) / 0.5))
            for i in range(count):
                p = (a[0] + (b[0] - a[0]) * i / count, a[1] + (b[1] - a[1]) * i / count)
                covered = any(inside(p, each) for each, kind in others if not kind) if not island else not any(
                    inside(p, each) for each, kind in others if not kind)
                cut_off = any(inside(p, each) for each, kind in others if kind)
                if not covered and not cut_off:
                    points.append(p)
    return points


def judge_area(points, contours, side, bottom, levels):
    walls = boundary(contours)
    cut = [(x, y, z) for kind, x, y, z in points if z < -1e-6]
    expect(cut, 'nothing is cut')
    expect(abs(min(z for *_, z in cut) - bottom) < 1e-6, f'deepest {min(z for *_, z in cut)}, not {bottom}')
    for x, y, z in cut[::3]:
        nearest = min(math.dist((x, y), wall) for wall in walls)
        expect(nearest > RADIUS + side - WALL_TOLERANCE, f'the centre is {nearest} from a wall at {x:.3f} {y:.3f} {z:.3f}')
        expect(to_remove((x, y), contours), f'the centre is outside the area at {x:.3f} {y:.3f}')
    at = None
    for kind, x, y, z in points:
        expect(kind == 'rapid' or z < 2 + 1e-6, f'at feed {z:.3f} above the surface, where nothing can be cut')
        sideways = at is not None and math.dist(at[:2], (x, y)) > 1e-6
        expect(kind != 'rapid' or z > -1e-6 or not sideways, f'sideways at rapid at {x:.3f} {y:.3f} {z:.3f}')
        at = (x, y, z)
    if not levels:
        return
    lowest = [(x, y) for x, y, z in cut if abs(z - bottom) < 1e-6]
    grid = {}
    for x, y in lowest:
        grid.setdefault((int(x // RADIUS), int(y // RADIUS)), []).append((x, y))
    for px in range(-45, 95, 3):
        for py in range(-50, 51, 3):
            p = (float(px), float(py))
            if not to_remove(p, contours) or min(math.dist(p, wall) for wall in walls) < 2 * RADIUS + side + 0.5:
                continue   # a narrow part may be out of the cutter's reach
            cell = (int(p[0] // RADIUS), int(p[1] // RADIUS))
            near = [q for dx in (-1, 0, 1) for dy in (-1, 0, 1) for q in grid.get((cell[0] + dx, cell[1] + dy), [])]
            expect(any(math.dist(p, q) <= RADIUS + STEP for q in near), f'{p} is not cut')


def check_sl_cycles(kadr):
    rng = random.Random(59)
    for _ in range(4):
        for contours in areas(rng):
            judge_area(traced(kadr, 'a.h', sl_program(contours, ROUGH), 'heidenhain', SETUP), contours, 0.3, -5.5, True)
            judge_area(traced(kadr, 'a.h', sl_program(contours, FLOOR), 'heidenhain', SETUP), contours, 0.3, -6, True)
            judge_area(traced(kadr, 'a.h', sl_program(contours, WALLS), 'heidenhain', SETUP), contours, 0, -6, False)


def check_sl_walls_are_reached(kadr):
    """Side finishing touches each wall, and travels with the material on its right, which is climb milling with M3."""
    square = [(0, 0), (60, 0), (60, 40), (0, 40)]
    for sense in (1, -1):
        text = sl_program([(square, False)], WALLS.replace('Q9=+1', f'Q9={sense:+}'))
        points = [(x, y) for _, x, y, z in traced(kadr, 'w.h', text, 'heidenhain', SETUP) if abs(z + 6) < 1e-6]
        box = [min(p[0] for p in points), min(p[1] for p in points), max(p[0] for p in points), max(p[1] for p in points)]
        expect(all(abs(got - wanted) < 0.01 for got, wanted in zip(box, (4, 4, 56, 36))), f'the centre turns within {box}')
        turned = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(points, points[1:]))
        expect((turned > 0) == (sense > 0), f'Q9={sense} turns the other way')


def check_pilot_holes_are_where_the_cutter_plunges(kadr):
    square = [(0, 0), (60, 0), (60, 40), (0, 40)]
    drill = 'CYCL DEF 21 PILOT DRILLING ~\n  Q10=-2 ~\n  Q11=+100 ~\n  Q13=+1\nCYCL CALL\nTOOL CALL 1 Z S1000\n' + ROUGH
    text = sl_program([(square, False)], drill)
    points = traced(kadr, 'p.h', text, 'heidenhain', {'offsets': {'1': {'radius': RADIUS}}})
    first_deep = next((x, y) for _, x, y, z in points if z < -1)
    plunges = {(round(b[1], 3), round(b[2], 3)) for a, b in zip(points, points[1:]) if b[3] < a[3] - 1e-6 and b[3] < -1e-6 and math.dist(a[1:3], b[1:3]) < 1e-6}
    expect(plunges == {tuple(round(v, 3) for v in first_deep)}, f'plunges at {plunges}, drilled at {first_deep}')


def check_contour_train(kadr):
    """Cycle 25 keeps the tool at R + Q3 from an open contour, on the side of RL."""
    line = [(0, 0), (40, 0), (60, 20), (60, 60)]
    text = ('BEGIN PGM T MM\nTOOL CALL 1 Z S2000\nL Z+50 R0 FMAX M3\nCYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL 1\n'
            'CYCL DEF 25 CONTOUR TRAIN ~\n  Q1=-4 ~\n  Q3=+0.5 ~\n  Q5=+0 ~\n  Q7=+20 ~\n  Q10=-2 ~\n  Q11=+100 ~\n  Q12=+400 ~\n  Q15={way}\n'
            'CYCL CALL\nL Z+50 R0 FMAX M2\nLBL 1\n  L X+0 Y+0 RL\n' + '\n'.join(f'  L X{x:+} Y{y:+}' for x, y in line[1:]) + '\nLBL 0\nEND PGM T MM\n')
    for way, first in ((1, (0, 4.5)), (-1, (55.5, 60)), (0, (0, 4.5))):
        points = [p for p in traced(kadr, 't.h', text.format(way=f'{way:+}'), 'heidenhain', SETUP) if p[3] < -1e-6]
        for _, x, y, _ in points:
            nearest = min(distance((x, y), a, b) for a, b in zip(line, line[1:]))
            expect(abs(nearest - 4.5) < 1e-3, f'Q15={way}: {nearest} from the contour at {x} {y}')
        expect(math.dist(points[0][1:3], first) < 1e-3, f'Q15={way} begins at {points[0]}')
        expect(min(p[3] for p in points) == -4, 'the depth')


CYCLE72 = 'CYCLE72("{name}",30,0,2,-6,2,0.3,0.5,400,150,{vari},{side},{way},5,1000,{way},5)\n'


def check_cycle72(kadr):
    """The centre is at R + _FAL from the contour while it follows it, at every depth; approach and retraction stay outside."""
    rng = random.Random(58)
    for form in (1, 2, 3, 11, 12):
        for outside in (True, False):
            loop = polygon(rng, (0, 0), 40, 50, 8)   # large enough for an approach inside
            start = rng.randrange(len(loop))
            (ax, ay), (bx, by) = sides(loop)[start]
            middle = ((ax + bx) / 2, (ay + by) / 2)
            path = [middle, *loop[start + 1:], *loop[:start + 1], middle]
            text = 'T1 M6\nG0 X0 Y0 Z50\nS2000 M3\n' + CYCLE72.format(name='KONTUR', vari=1, side=42 if outside else 41, way=form) + 'M30\n'
            sub = 'G0 X{:.4f} Y{:.4f}\n'.format(*path[0]) + ''.join(f'G1 X{x:.4f} Y{y:.4f}\n' for x, y in path[1:]) + 'M17\n'
            kadr.file('KONTUR.SPF', sub)
            points = traced(kadr, 'c.mpf', text, 'sinumerik', SETUP)
            deep = [(x, y, z) for _, x, y, z in points if z < -1e-6]
            expect(abs(min(z for *_, z in deep) + 5.5) < 1e-6, 'the depth less the allowance')
            reach = 4.3
            least = min(min(distance((x, y), a, b) for a, b in sides(loop)) for x, y, _ in deep)
            expect(abs(least - reach) < 2e-3, f'form {form}: {least} from the contour, not {reach}')
            for x, y, _ in deep:
                expect(inside((x, y), loop) != outside, f'form {form}: on the wrong side at {x} {y}')
            levels = sorted({round(z, 6) for *_, z in deep if all(abs(z - other) < 1e-9 for other in [z])})
            if form < 10:
                expect([z for z in (-5.5, -3.666667, -1.833333) if z in levels] == [-5.5, -3.666667, -1.833333], f'the depths {levels[:5]}')
            expect(points[-1][3] == 30, 'the end is at _RTP')


def check_labels_name_a_contour(kadr):
    text = ('T1 M6\nG0 X0 Y0 Z50\nS2000 M3\n' + CYCLE72.format(name='BEG:LAST', vari=2, side=40, way=1) +
            'GOTOF OVER\nBEG: G0 X10 Y0\nG1 X40\nG1 Y30\nLAST: G1 X10 Y30\nOVER:\nM30\n')
    points = traced(kadr, 'l.mpf', text, 'sinumerik', SETUP)
    deep = [p for p in points if abs(p[3] + 6) < 1e-6]
    box = [min(p[1] for p in deep), min(p[2] for p in deep), max(p[1] for p in deep), max(p[2] for p in deep)]
    expect([round(v, 6) for v in box] == [5, 0, 40, 30], f'{box}: the contour and 5 mm before and after it')


def check_faults_are_named(kadr):
    square = [(0, 0), (10, 0), (10, 6), (0, 6)]
    for text, control, wanted in (
            (sl_program([(square, False)], ROUGH), 'heidenhain', 'contour_tool_large'),
            (sl_program([(square, False)], ROUGH).replace('LBL 1\n', 'LBL 7\n'), 'heidenhain', 'label_missing'),
            (sl_program([(square, False)], ROUGH).replace('  L X+0.000 Y+0.000\n', ''), 'heidenhain', 'contour_not_closed'),
            (sl_program([(square, False)], ROUGH).replace('  L X+10.000 Y+6.000\n', '  L X+10 Y+6 Z\n'), 'heidenhain', 'alarm'),
            (sl_program([(square, False)], ROUGH).replace('LBL 1\n', 'LBL 1\n' + ROUGH + '\nCYCL CALL\n'), 'heidenhain', 'outline_missing'),
            ('T1 M6\nS1000 M3\nG0 Z50\n' + CYCLE72.format(name='AA:BB', vari=1, side=41, way=1) + 'AA: G0 X0\n' +
             CYCLE72.format(name='AA:BB', vari=1, side=41, way=1) + 'BB: M0\nM30\n', 'sinumerik', 'outline_missing'),
            ('T1 M6\nS1000 M3\n' + CYCLE72.format(name='NOWHERE', vari=1, side=41, way=1) + 'M30\n', 'sinumerik', 'program_missing'),
            ('T1 M6\nS1000 M3\nG0 Z50\n' + CYCLE72.format(name='AA:BB', vari=1, side=41, way=1) + 'AA: G0 X0\nBB: M0\nM30\n', 'sinumerik', 'outline_missing'),
            ('T1 M6\nS1000 M3\nG0 Z50\n' + CYCLE72.format(name='AA:BB', vari=1, side=41, way=1) + 'AA: G0 X0\nCC: G1 X9\nGOTOB CC\nBB: M0\nM30\n', 'sinumerik', '')):
        kadr.file('f.txt', text)
        kadr.file('setup.json', json.dumps(SETUP))
        done = kadr.call('run', '--control', control, '--setup', 'setup.json', 'f.txt')
        expect(done.returncode == 1 and wanted in done.stdout + done.stderr, f'not {wanted}: {done.returncode} {done.stdout}{done.stderr}')


if __name__ == '__main__':
    sys.exit(harness.main(__doc__, globals()))
