#!/usr/bin/env python3
"""Differential test of the control grbl against Grbl's own parser.

    grbl_oracle.py --kadr build/kadr [--seed N] [--programs N] [--lines N] [--keep FOLDER]

The oracle is an executable named by the environment variable KADR_GRBL_ORACLE (dev/grbl_oracle builds it from Grbl's source); without it
the whole test is skipped, with a message. The oracle reads a program on stdin, as Grbl would receive it line by line, and prints one JSON
object per line for each call that Grbl's gcode.c makes, in order:
    {"line": 3, "error": 20}                      the answer to a line that is refused
    {"line": 3, "alarm": 5}                       ALARM:5; nothing follows
    {"line": 3, "do": "rapid" | "feed" | "probe", "to": [X, Y, Z], "feed": F, "inverse": false}        machine position, mm
    {"line": 3, "do": "arc_cw" | "arc_ccw", the same keys, "center": [first, second axis of the plane], "plane": "ZX", "turns": 0.5,
     "segments": 12}                              lines that approximate the arc
    {"line": 3, "do": "dwell", "seconds": 0.5}, "stop" (M0), "home"
    {"line": 3, "do": "spindle", "dir": "cw" | "ccw" | "off", "rpm": 500}; "coolant" with "flood": true
It starts with the settings of the generic build, at machine zero; its probe signal does not change: the probe finds no contact and loses
none.

Both get random programs of valid lines, changed lines and bare words. Each line that Grbl refuses must stop Kadr with the same number
when only correct lines precede it; without the refused lines, motions, dwells, stops and the spindle and coolant state during them must
be the same (`kadr run --trace`).

Grbl calculates in 32-bit floats: positions may differ by NEAR mm and by FLOAT of the largest coordinate so far. Where the rounding of a
float decides (a radius equal to half of the chord, an arc error at its limit) the generator keeps a distance from the limit:
tests/grbl_arcs.py does not.
The seed is printed. Exit status: 0 all passed or skipped, 1 some failed.
"""
import json
import math
import os
import random
import re
import subprocess
import sys
from pathlib import Path

import harness
from harness import Failure

NEAR = 1e-4    # mm
FLOAT = 1e-6   # of the largest coordinate: several accumulated roundings of 2^-24
MOTIONS = ('rapid', 'feed', 'arc_cw', 'arc_ccw', 'probe', 'home')
AXES = 'XYZ'


# ---- programs

def number(rng, most=60.0):
    """A value as people write it."""
    kind = rng.randrange(6)
    value = rng.uniform(-most, most)
    if kind == 0:
        return str(round(value))
    if kind == 1:
        return f'{value:.1f}'
    if kind == 2:
        return f'{value:.3f}'
    if kind == 3:
        return f'{value:+.2f}'
    if kind == 4:
        return f'{round(value)}.'
    return f'{value:.4f}'.replace('0.', '.', 1) if abs(value) < 1 else f'{value:.4f}'


def some_axes(rng, most=60.0, axes=AXES):
    """Returns `X1.5Z-3`: one to three axis words in any order."""
    chosen = rng.sample(axes, rng.randint(1, len(axes)))
    return [letter + number(rng, most) for letter in chosen]


def arc(rng):
    """Returns lines of an arc in increments: exact, in tolerance, out of it; by centre or radius."""
    plane, first, second, third = rng.choice((('G17', 'X', 'Y', 'Z'), ('G18', 'Z', 'X', 'Y'), ('G19', 'Y', 'Z', 'X')))
    offset = dict(zip(AXES, 'IJK'))
    radius = rng.choice((1, 5, 10, 12.5, 40))
    begin, swept = rng.uniform(0, 2 * math.pi), rng.uniform(0.05, 6.2)
    center = (round(-radius * math.cos(begin), 4), round(-radius * math.sin(begin), 4))
    end = (radius * math.cos(begin + swept), radius * math.sin(begin + swept))
    # 5.2: 0.005 mm, then 0.1 % of the radius up to 0.5 mm; never closer to a limit than 0.0005
    error = rng.choice((0, 0, 0, 0.003, -0.0042, 0.0058, -0.007, 0.001 * radius - 0.0008, 0.001 * radius + 0.0009, 0.45, 0.6, -3))
    scale = (radius + error) / radius
    delta = (center[0] + end[0] * scale, center[1] + end[1] * scale)
    code = rng.choice(('G2', 'G3', 'G02', 'G03'))
    words = [code, f'{first}{delta[0]:.4f}', f'{second}{delta[1]:.4f}']
    kind = rng.randrange(8)
    if kind < 4:
        words += [f'{offset[first]}{center[0]:.4f}', f'{offset[second]}{center[1]:.4f}']
    elif kind == 4:  # a full circle
        words = [code, f'{first}0', f'{offset[first]}{radius}'] + ([f'{second}0'] if rng.random() < 0.5 else [])
    elif kind == 5:
        half = math.hypot(*delta) / 2
        words.append(f'R{rng.choice((-1, 1)) * (half + rng.choice((0.002, 0.5, 5, 30, -0.002, -1))):.4f}')
    else:
        words.append(f'R{rng.choice((-1, 1)) * radius * 2.5:.3f}')
    if rng.random() < 0.3:
        words.append(third + number(rng, 10))
    return [[plane, 'G91', 'G21', 'G94', 'F' + str(rng.randint(50, 900))], words, ['G90']]


def plain(rng):
    """Returns a line that is usually correct."""
    kind = rng.randrange(24)
    if kind < 6:
        return [[rng.choice(('G0', 'G1', 'G00', 'G01'))] + some_axes(rng) + (['F' + str(rng.randint(1, 2000))] if rng.random() < 0.6 else [])]
    if kind < 9:
        return [some_axes(rng) + (['F' + str(rng.randint(1, 2000))] if rng.random() < 0.4 else [])]
    if kind < 13:
        return arc(rng)
    if kind == 13:
        return [[rng.choice(('G90', 'G91', 'G90', 'G21', 'G20', 'G17', 'G18', 'G19', 'G40', 'G61', 'G91.1', 'G80', 'G49', 'G93', 'G94'))]]
    if kind == 14:
        return [['G93', 'G1', 'F' + number(rng).lstrip('+-')] + some_axes(rng), ['F3'] + some_axes(rng), ['G94']]
    if kind == 15:
        return [['G10', rng.choice(('L2', 'L20', 'L20', 'L2', 'L3', 'L')), 'P' + rng.choice('01234567') + rng.choice(('', '.5'))] + some_axes(rng)]
    if kind == 16:
        return [[rng.choice(('G28.1', 'G30.1', 'G28', 'G30', 'G92', 'G92.1'))] + (some_axes(rng, 20) if rng.random() < 0.6 else [])]
    if kind == 17:
        return [['G43.1', 'Z' + number(rng, 20)] + (['X1'] if rng.random() < 0.1 else [])]
    if kind == 18:
        return [['G53', rng.choice(('G0', 'G1', 'G2', ''))] + some_axes(rng)]
    if kind == 19:
        return [[rng.choice(('G54', 'G55', 'G56', 'G57', 'G58', 'G59'))] + (some_axes(rng) if rng.random() < 0.4 else [])]
    if kind == 20:
        return [[rng.choice(('M3', 'M4', 'M5', 'M8', 'M9', 'M03', 'M0', 'M1', 'S500', 'S0', 'T3', 'M3 S700', 'S1500 M4', 'M2', 'M30'))]]
    if kind == 21:
        return [['G4', 'P' + number(rng, 5).lstrip('+-')]]
    if kind == 22:
        return [['$J=' + rng.choice(('', 'G91', 'G90', 'G53', 'G20', 'G91G21', 'G0', 'N5'))] + some_axes(rng, 5) +
                (['F' + str(rng.randint(1, 500))] if rng.random() < 0.9 else [])]
    if rng.random() < 0.25:
        return [['G38.3', 'F50'] + some_axes(rng, 10)]
    return [[rng.choice(('$X', '$G', '$$', '$#', '$I', '$N', '$Q', '$J', '$JX1', '$110=500', '$5=1', '$0=2', '$999=1', '$20=1', '$13=0',
                         '$22=0', '$X1', '$30=900', '$31=100', '$1=', '$=1', '$30', '$30=-1', '$30=5X', '$12=.002', '$-1=2', '$13=1.5'))]]


LETTERS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ'
CODES = ('G0 G1 G2 G3 G4 G5 G10 G17 G18 G19 G20 G21 G28 G28.1 G30 G30.1 G33 G38.2 G38.3 G38 G40 G41 G43 G43.1 G43.2 G49 G50 G53 G54 '
         'G59 G59.1 G60 G61 G61.1 G64 G80 G81 G90 G90.1 G91 G91.1 G92 G92.1 G92.2 G93 G94 G95 G98 G99 G1.5 G2.01 G17.004 G256 G257 '
         'G-1 G100 G28.3 G92.15 G0.001 M0 M1 M2 M3 M4 M5 M6 M7 M8 M9 M30 M3.1 M48 M98 M56 M256 M259 M-3 M3.004').split()


def one_word(rng):
    kind = rng.randrange(5)
    if kind < 2:
        return rng.choice(CODES)
    if kind == 2:
        return rng.choice(('F0', 'F-1', 'F100', 'S-1', 'S300', 'T255', 'T256', 'T-1', 'T2.5', 'N10', 'N-1', 'N10000000', 'N10000001', 'N5.5',
                           'P1', 'P-1', 'P0', 'L2', 'L20', 'L0', 'L258', 'R5', 'R-5', 'R0', 'I1', 'J2', 'K3'))
    if kind == 3:
        return rng.choice(LETTERS) + number(rng)
    return rng.choice('XYZFP') + rng.choice(('1.2.3', '', '-', '.', '+.5', '--1', '1e3', '12.345678901', '0012.3456789', '0000000012', '1 2',
                                             '000000.25', '5-', '00000000.5', '-0'))


def changed(rng, words):
    """Returns a valid line with an error in it, or only written differently."""
    words = list(words)
    for _ in range(rng.randint(1, 2)):
        kind = rng.randrange(9)
        at = rng.randrange(len(words)) if words else 0
        if kind == 0 and words:
            del words[at]
        elif kind == 1 and words:
            words.insert(rng.randint(0, len(words)), words[at])
        elif kind < 4:
            words.insert(rng.randint(0, len(words)), one_word(rng))
        elif kind == 4 and words:
            words[at] = words[at].lower()
        elif kind == 5:
            words.insert(rng.randint(0, len(words)), rng.choice(('(note)', '(a ; b)', ';rest', '(open', '/', '\t', '(п)', ')', '(a)(b)', '!', '~')))
        elif kind == 6 and words:
            place = rng.randrange(len(words[at]) + 1)
            words[at] = words[at][:place] + rng.choice('%#*=,_:"[] .-+5@') + words[at][place:]
        elif kind == 7:
            words.append('X0.' + '1' * rng.choice((50, 60, 65, 70, 75)))
        elif words:
            rng.shuffle(words)
    return words


def joined(rng, words):
    return rng.choice(('', ' ', '  ')).join(words)


def program(rng, lines):
    """The last line may be one that stops Grbl with an alarm."""
    text = ['G21 G90 G94 F100']
    limits = rng.random() < 0.2
    if limits:
        text += ['$22=1', '$20=1', '$130=50', 'G53 G0 X-20 Y-20 Z-20']
    while len(text) < lines:
        kind = rng.random()
        for words in [[one_word(rng) for _ in range(rng.randint(1, 5))]] if kind < 0.15 else plain(rng):
            words = changed(rng, words) if rng.random() < 0.22 else words
            line = joined(rng, words)
            if not re.search(r'(?i)^\W*\$\W*[CHNRS]', line):  # these change the machine, not the program
                text.append(line)
        if rng.random() < 0.1:
            text.append('G53 G0 X-10 Y-10 Z-10' if limits else 'G90 G0 X0 Y0 Z0')
    if rng.random() < 0.3:
        text.append(rng.choice(('G38.2', 'G38.4', 'G38.5', 'G38.3')) + ' F20 Z' + number(rng, 10))
    return text


# ---- results of both

def oracle_of(oracle, text):
    done = subprocess.run([oracle], input='\n'.join(text).encode(), capture_output=True, timeout=harness.TIME_LIMIT_S, check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def kadr_actions(kadr, text):
    kadr.file('p.nc', '\n'.join(text))
    kadr.file('setup.json', '{"probe": {"1": null}}')
    done = kadr.run('run', 'p.nc', '--control', 'grbl', '--setup', 'setup.json', '--trace', '-', '-q', '--lang', 'en', '--encoding', 'utf-8', expected=(0, 1))
    return [json.loads(line) for line in done.stdout.splitlines()]


# ---- comparison

def with_state(actions):
    """Returns motions, dwells, stops, each with the spindle and coolant state during it."""
    spindle, flood, out = ('off', 0.0), False, []
    for a in actions:
        what = a.get('do')
        if what == 'spindle':
            spindle = ('off', 0.0) if a['dir'] in ('off', 'stop') else (a['dir'], a['rpm'])
        elif what == 'speed':
            spindle = (spindle[0], a['rpm'] if spindle[0] != 'off' else 0.0)
        elif what == 'coolant':
            flood = a['flood'] if 'flood' in a else a['what'] == 'flood'
        elif what in MOTIONS or what in ('dwell', 'stop'):
            out.append((a, spindle, flood))
    return out


def position(a):
    where = a.get('machine', a['to']) if 'machine' in a else a['to']
    return [where[axis] for axis in AXES] if isinstance(where, dict) else list(where)


def compare_arc(mine, theirs, near, start):
    if mine['plane'] != theirs['plane']:
        raise Failure(f"plane {mine['plane']}, Grbl {theirs['plane']}")
    first, second = mine['plane']
    work = [mine['center'][first], mine['center'][second]]
    shift = [mine['machine'][axis] - mine['to'][axis] for axis in (first, second)]
    center = [w + s for w, s in zip(work, shift)]
    # By R the centre depends on the root of 4R² - d²; the smaller the root, the more its rounding matters.
    radius = theirs['radius']
    ends = [position(theirs)[AXES.index(axis)] - start[AXES.index(axis)] for axis in (first, second)]
    root = math.sqrt(max(4 * radius * radius - ends[0] ** 2 - ends[1] ** 2, 1e-9))
    loose = near + 4 * radius * (near / 10 + radius * FLOAT) / root
    for axis, mine_c, theirs_c in zip(mine['plane'], center, theirs['center']):
        if abs(mine_c - theirs_c) > loose:
            raise Failure(f'centre {axis}{mine_c}, Grbl {theirs_c}')
    turns = abs(mine['turns'] - theirs['turns'])
    if min(turns, abs(turns - 1)) > 2 * loose / max(radius, 1e-3) + 1e-5:
        raise Failure(f"turns {mine['turns']}, Grbl {theirs['turns']}")
    if turns > 0.5 and math.hypot(*ends) > 2 * near:
        raise Failure(f"turns {mine['turns']}, Grbl {theirs['turns']}")


def compare(mine, theirs, largest, start):
    """Compares one action."""
    (a, *state), (b, *expected) = mine, theirs
    straight = b.get('segments') == 1 and b['do'].startswith('arc')  # Grbl approximates the arc by a single line
    if (a['do'] != b['do'] and not (straight and a['do'] == 'feed')) or a['line'] != b['line']:
        raise Failure(f"line {a['line']} {a['do']}, Grbl line {b['line']} {b['do']}")
    if state[1] != expected[1] or state[0][0] != expected[0][0] or abs(state[0][1] - expected[0][1]) > 1e-3:
        raise Failure(f"line {a['line']}: spindle and coolant {state}, Grbl {expected}")
    if a['do'] == 'dwell' and abs(a['seconds'] - b['seconds']) > NEAR:
        raise Failure(f"line {a['line']}: {a['seconds']} s, Grbl {b['seconds']}")
    if a['do'] not in MOTIONS:
        return
    near = NEAR + FLOAT * largest
    for axis, mine_p, theirs_p in zip(AXES, position(a), position(b)):
        if abs(mine_p - theirs_p) > near:
            raise Failure(f"line {a['line']}: {axis}{mine_p}, Grbl {theirs_p}")
    if a['do'] in ('rapid', 'home'):
        return
    inverse = a['unit'] == '1/min'
    if inverse != b['inverse'] or abs(a['feed'] - b['feed']) > NEAR + FLOAT * b['feed']:
        raise Failure(f"line {a['line']}: feed {a['feed']} {a['unit']}, Grbl {b['feed']} inverse {b['inverse']}")
    if a['do'] in ('arc_cw', 'arc_ccw') and not straight:
        compare_arc(a, b, near, start)


def refusal_of(actions):
    """Returns (line, "error:20") of the alarm that ended the run; nothing if the program ran to its end."""
    last = actions[-1]
    return (last['line'], last['text'].split(' ')[0]) if last['do'] == 'alarm' else None


def compare_program(kadr, oracle, text):
    """Compares both; returns the number of lines compared."""
    theirs = oracle_of(oracle, text)
    faults = {a['line']: f"error:{a['error']}" for a in theirs if 'error' in a}
    alarm = next(((a['line'], f"ALARM:{a['alarm']}") for a in theirs if 'alarm' in a), None)
    last = alarm[0] if alarm else len(text)
    for fault in faults.items():  # each refused line after correct ones only
        upto = ['' if n in faults and n != fault[0] else line for n, line in enumerate(text[:fault[0]], 1)]
        refusal = refusal_of(kadr_actions(kadr, upto))
        if refusal != fault:
            raise Failure(f'line {fault[0]}: {refusal}, Grbl {fault[1]}: {text[fault[0] - 1]!r}')
    actions = kadr_actions(kadr, ['' if n in faults else line for n, line in enumerate(text[:last], 1)])
    refusal = refusal_of(actions)
    if refusal != alarm:
        raise Failure(f'{refusal}, Grbl {alarm or "ok"}: {text[(refusal or alarm)[0] - 1]!r}')
    mine, theirs = with_state(actions), with_state(theirs)
    largest, start = 0.0, [0.0, 0.0, 0.0]
    for a, b in zip(mine, theirs):
        if 'to' in b[0]:
            largest = max([largest] + [abs(v) for v in b[0]['to']])
        try:
            compare(a, b, largest, start)
        except Failure as failure:
            raise Failure(f"{failure}: {text[a[0]['line'] - 1]!r}") from None
        if 'to' in b[0]:
            start = b[0]['to']
    if len(mine) != len(theirs):
        extra = (mine[len(theirs):] or theirs[len(mine):])[0][0]
        raise Failure(f'{len(mine)} actions, Grbl {len(theirs)}; the first that one has not: {extra}')
    return last


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--seed', type=int, default=19)
    parser.add_argument('--programs', type=int, default=600)
    parser.add_argument('--lines', type=int, default=40, help='lines of a program')
    parser.add_argument('--keep', type=Path, help='folder for the programs that differ')
    options = harness.parsed(parser)
    oracle, tally = os.environ.get('KADR_GRBL_ORACLE'), harness.Tally()
    if not oracle:
        tally.skip('nothing is compared with Grbl: KADR_GRBL_ORACLE is not set')
        return tally.result()
    print(f'seed {options.seed}')
    texts = [program(random.Random(f'{options.seed} {n}'), options.lines) for n in range(options.programs)]
    lines = []

    def faults(text):
        return harness.in_a_folder(lambda kadr: lines.append(compare_program(kadr, oracle, text)), options.kadr)

    for n, (text, found) in enumerate(zip(texts, harness.each(faults, texts))):
        tally.judge(f'program {n}', found)
        if found and options.keep:
            options.keep.mkdir(parents=True, exist_ok=True)
            (options.keep / f'{n}.nc').write_text('\n'.join(text))
    print(f'{sum(lines)} lines compared')
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
