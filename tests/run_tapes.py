#!/usr/bin/env python3
"""Tests tapes: EIA code, tapes that are reversed or flipped, tapes with several programs; permanent subprograms and coded feeds in a user's
own control.

    run_tapes.py --kadr build/kadr

The test writes the rows by itself from RS-244 and ISO 7-bit, not by `kadr tape`.
"""
import json
import sys

import harness

tally = harness.Tally()

# EIA RS-244: holes of tracks 1 to 4, then 5 (parity), 6, 7; the end of a block is track 8 alone.
EIA = {'\n': 0x80, ' ': 0x10, '%': 0x0B, '.': 0x6B, '/': 0x31, '+': 0x70, '-': 0x40, '(': 0x1A, ')': 0x4A}
EIA |= dict(zip('0123456789', (0x20, 0x01, 0x02, 0x13, 0x04, 0x15, 0x16, 0x07, 0x08, 0x19)))
EIA |= dict(zip('ABCDEFGHI', (0x61, 0x62, 0x73, 0x64, 0x75, 0x76, 0x67, 0x68, 0x79)))
EIA |= dict(zip('JKLMNOPQR', (0x51, 0x52, 0x43, 0x54, 0x45, 0x46, 0x57, 0x58, 0x49)))
EIA |= dict(zip('STUVWXYZ', (0x32, 0x23, 0x34, 0x25, 0x26, 0x37, 0x38, 0x29)))

PROGRAM = '%\nN1 G90 G0 X8000 Y13000\nN2 G1 X5123 Y-9314 F500\nN3 M2\n'


def eia(text):
    return bytes(EIA[c] for c in text)


def iso(text):
    return bytes(c | (0x80 if bin(c).count('1') % 2 else 0) for c in text.encode('ascii'))


def wrong_end(rows):
    return rows[::-1]


def wrong_side(rows):
    return bytes(int(f'{row:08b}'[::-1], 2) for row in rows)


class Runs(harness.Kadr):
    """Runs kadr in an empty folder and counts what differs from the expectation."""

    def file(self, name, content=''):
        return super().file(name, content).name

    def kadr_run(self, *args):
        done = self.call(*args, binary=True)
        return done.returncode, done.stdout, done.stderr.decode('utf-8')

    def expect(self, what, got, wanted):
        tally.same(what, got, wanted)

    def motions(self, *args):
        """Returns the end points of the motions of `kadr run`, by axis, and its exit status."""
        status, out, err = self.kadr_run('run', *args, '--trace', '-', '--quiet')
        ends = []
        for line in out.decode('utf-8').splitlines():
            action = json.loads(line)
            if action['do'] in ('rapid', 'feed', 'arc_cw', 'arc_ccw', 'home'):
                ends.append((action['do'], action['to'], action.get('feed')))
        return status, ends, err


def places(ends, axes):
    return [tuple(round(to.get(a, 0), 3) for a in axes) for _, to, _ in ends]


def eia_tapes(runs):
    for rows in eia(PROGRAM), bytes(20) + eia(PROGRAM) + bytes(20):  # with blank tape too
        runs.file('a.tape', rows)
        runs.expect('EIA decoded', runs.kadr_run('tape', 'decode', 'a.tape'), (0, PROGRAM.encode(), ''))
        status, ends, _ = runs.motions('a.tape', '--control', 's2c42')
        runs.expect('EIA run', (status, places(ends, 'XY')), (0, [(8, 13), (5.123, -9.314)]))
    runs.file('a.nc', PROGRAM)
    runs.kadr_run('tape', 'encode', 'a.nc', 'b.tape', '--code', 'eia', '--leader', '3')
    runs.expect('EIA encoded', (runs.folder / 'b.tape').read_bytes(), bytes(3) + eia(PROGRAM) + bytes(3))
    runs.file('small.nc', '%\nn1 x10 пс\n')
    runs.expect('EIA has no Russian letters', runs.kadr_run('tape', 'encode', 'small.nc', '--code', 'eia')[0], 1)
    runs.file('main.nc', ':1 X10\n')
    status, _, err = runs.kadr_run('tape', 'encode', 'main.nc', '--code', 'eia')
    runs.expect('EIA has no colon', (status, err), (1, "kadr: main.nc: ':' (byte 1) has no EIA code\n"))
    torn = bytearray(eia(PROGRAM))
    torn[7] ^= 0x04  # the 6th row of line 2
    runs.file('torn.tape', bytes(torn))
    status, _, err = runs.kadr_run('tape', 'decode', 'torn.tape')
    runs.expect('EIA torn', (status, err), (1, f'kadr: torn.tape: row 8: parity error (byte {torn[7]:03o})\n'))
    status, out, _ = runs.kadr_run('check', 'torn.tape', '--control', 's2c42', '--format', 'json')
    found = [(f['line'], f['id']) for f in json.loads(out)]
    runs.expect('EIA torn, checked', (status, found), (1, [(2, 'parity_error')]))


def reversed_tapes(runs):
    lies = {'read from its wrong end: turned': wrong_end, 'read from its wrong side: turned over': wrong_side,
            'read from its wrong end and side: turned': lambda rows: wrong_side(wrong_end(rows))}
    for name, code in (('iso', iso), ('eia', eia)):
        for words, lie in lies.items():
            runs.file('r.tape', lie(bytes(30) + code(PROGRAM)))
            runs.expect(f'{name}, {words}', runs.kadr_run('tape', 'decode', 'r.tape'),
                        (1, PROGRAM.encode(), f'kadr: r.tape: the tape was {words}\n'))
            status, _, err = runs.kadr_run('run', 'r.tape', '--control', 's2c42', '--quiet')
            runs.expect(f'{name}, {words}: run', (status, 'tape_reversed' in err), (1, True))
        runs.file('right.tape', code(PROGRAM))
        runs.expect(f'{name}, right', runs.kadr_run('tape', 'decode', 'right.tape'), (0, PROGRAM.encode(), ''))
    status, _, err = runs.kadr_run('tape', 'decode', 'r.tape', '--lang', 'ru')
    runs.expect('in Russian', err, 'kadr: r.tape: лента считана с конца и не той стороной: образ перевёрнут\n')


SEVERAL = '''L
N01001 G91 G1 X1000 F100
N01002 M17
N01003 M2
%101
N1 G90 G0 X0
N2 L01
N3 M2
L
N01001 G91 G1 X2000 F100
N01002 M17
N01003 M2
%102
N1 G90 G0 X0
N2 L01
N3 G77
N4 M2
%103
N1 G0 X7000
N2 M30
'''


def several_programs(runs):
    def run(*args):
        status, ends, err = runs.motions('t.nc', '--control', 's2c42', *args)
        return status, places(ends, 'X'), err

    runs.file('t.nc', SEVERAL)
    first = (0, [(0,), (1,)], 'kadr: t.nc: holds the programs 101, 102, 103; the first is run, otherwise: --program\n')
    runs.expect('several, first', run(), first)
    runs.expect('several, 101', run('--program', '101'), (0, [(0,), (1,)], ''))
    runs.expect('several, 103', run('--program', '103'), (0, [(7,)], ''))
    status, ends, err = run('--program', '102')  # the subprogram that was read last before it: +2
    runs.expect('several, 102', (status, ends, 't.nc:16:4: alarm code_unknown' in err), (1, [(0,), (2,)], True))
    status, _, err = run('--program', '7')
    runs.expect('several, none', (status, err), (2, 'kadr: t.nc: no program 7; there are: 101, 102, 103\n'))
    status, _, err = run('--program', '7', '--lang', 'ru')
    runs.expect('several, none, in Russian', (status, err), (2, 'kadr: t.nc: программы 7 нет; есть: 101, 102, 103\n'))

    def faults(*args):
        status, out, _ = runs.kadr_run('check', 't.nc', '--control', 's2c42', '--format', 'json', *args)
        return status, [(f['line'], f['id']) for f in json.loads(out)]

    runs.expect('several, check all', faults(), (1, [(16, 'code_unknown')]))
    runs.expect('several, check one', faults('--program', '103'), (0, []))
    runs.file('t.tape', iso(SEVERAL))
    status, ends, _ = runs.motions('t.tape', '--control', 's2c42', '--program', '103')
    runs.expect('several, tape', (status, places(ends, 'X')), (0, [(7,)]))
    runs.file('g.nc', '%%\n%012 LF\nN1 G00 X1. LF\nN2 M02 LF\n% LF\nO0002 LF\nN1 G00 X2. LF\nN2 M30 LF\n')
    for number, x in ((12, 1), (2, 2)):
        status, ends, _ = runs.motions('g.nc', '--control', 'gost', '--program', str(number))
        runs.expect(f'gost {number}', (status, places(ends, 'X')), (0, [(x,)]))
    runs.file('u.nc', '% LF\nN1 G00 X1. LF\nN2 M02 LF\n% LF\nN1 G00 X2. LF\nN2 M02 LF\n')
    status, ends, _ = runs.motions('u.nc', '--control', 'gost', '--program', '2')
    runs.expect('without numbers by their place', (status, places(ends, 'X')), (0, [(2,)]))


PERMANENT = '''extends = "correctors"
id = "shop"
name = { en = "Shop", ru = "Цех" }
spec = "instruction of the shop"
[cycle.G81]
body = ["G90 G00 X+R01 Y+R02", "G01 Z-R03 F+P100", "G00 Z+E01", "M17"]
parameters = { X = "R01", Y = "R02", Z = "R03" }
en = "hole"
ru = "отверстие"
manual = "1"
[g]
"81" = { group = "pocket", does = "permanent_subprogram", takes = "XYZ", en = "hole", ru = "отверстие", manual = "1" }
'''
CALLS = '''% LF
N1 E01+2. P100=80 LF
N2 G81 X10. Y20. Z5. LF
N3 R03+7.5 LF
N4 G81 X30. LF
N5 G91 G00 X+R01 Y-5.+R02 LF
N6 M02 LF
'''


def permanent_subprograms(runs):
    runs.file('shop.toml', PERMANENT)
    runs.file('p.nc', CALLS)
    status, ends, _ = runs.motions('p.nc', '--control', 'shop.toml')
    # N2 sets R01 = 10, R02 = 20, R03 = 5; N4 R01 = 30, the others stay except R03 of N3. G90 stays: N5 counts from 30, 20.
    wanted = [(10, 20, 0), (10, 20, -5), (10, 20, 2), (30, 20, 2), (30, 20, -7.5), (30, 20, 2), (60, 35, 2)]
    runs.expect('permanent subprogram', (status, places(ends, 'XYZ')), (0, wanted))
    runs.expect('… its feed', [feed for do, _, feed in ends if do == 'feed'], [80, 80])
    runs.file('q.nc', 'N1 G81 X1. Y2. Z3. LF\n')
    status, _, err = runs.kadr_run('run', 'q.nc', '--control', 'shop.toml', '--quiet')
    runs.expect('a parameter never set', (status, 'P100' in err), (1, True))
    runs.file('w.nc', 'N1 G00 R01+5. R12 LF\n')  # R12 without a sign is a word, which G00 does not use
    status, _, err = runs.kadr_run('run', 'w.nc', '--control', 'shop.toml', '--quiet')
    runs.expect('R12 is a word', (status, 'word_unused' in err), (1, True))


CODED = '''extends = "gost"
id = "coded"
name = { en = "Coded", ru = "С кодами" }
spec = "instruction"
format = "%: N3 3G2 X+33 Y+33 Z+42 I+33 J+33 K+33 F2 S2 T4 M2 LF"
[feed_codes]
progression = true
99 = 2400
[speed_codes]
progression = true
'''


def coded_feeds(runs):
    runs.file('coded.toml', CODED)
    # series R20: 28 = 2.5 · 10, 40 = 100, 59 = 9 · 100, 0 the stop; 54 = 5 · 100 rev/min
    runs.file('c.nc', '%LF\nN001G90G17S54M03LF\nN002G01X+010000F28LF\nN003X+020000F40LF\nN004X+030000F59LF\nN005X+040000F99LF\nN006M02LF\n')
    status, ends, err = runs.motions('c.nc', '--control', 'coded.toml')
    runs.expect('coded', (status, [feed for _, _, feed in ends], err), (0, [25, 100, 900, 2400], ''))
    _, out, _ = runs.kadr_run('run', 'c.nc', '--control', 'coded.toml', '--quiet', '--trace', '-')
    speeds = [json.loads(line)['rpm'] for line in out.decode().splitlines() if '"dir":"cw"' in line]
    runs.expect('coded speed', speeds, [500])
    runs.file('square.txt', 'from 0 0\nline 40 0\nline 40 30\nline 0 30\nclose\n')
    status, out, err = runs.kadr_run('mill', 'pocket', 'square.txt', '--tool-diameter', '10', '--depth', '2', '--feed', '110', '--plunge-feed',
                                     '31.5', '--speed', '640', '--tool', '4', '--control', 'coded.toml', '--quiet')
    text = out.decode('utf-8')
    # rounded down: 110 → 100 (F40), 31.5 (F30), 640 → 630 (S56)
    runs.expect('mill chooses codes', (status, 'F40' in text, 'F30' in text, 'S56' in text, 'G01' in text, 'F110' in text),
                (0, True, True, True, True, False))


def main():
    kadr = harness.kadr_of(__doc__)
    for part in (eia_tapes, reversed_tapes, several_programs, permanent_subprograms, coded_feeds):
        for fault in harness.in_a_folder(part, kadr, Runs):
            tally.expect(False, part.__name__, fault)
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
