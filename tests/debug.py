#!/usr/bin/env python3
"""Tests `kadr debug` by scripts on standard input, `kadr run --from --to`, and what both refuse.

    debug.py --kadr build/kadr

Expected results are worked out by hand. Prints a line per failure, then `N passed, N failed`. Exit status: 0 all passed, 1 some failed.
"""
import json
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

import harness

PROGRAM = '''N10 G21 G90 G17
N20 #100=1
N30 M98 P200
N40 G0 X10 Y10 Z5
N50 G81 X1 Y1 Z-5 R1 F100
N60 X5
N70 G80
N80 #100=#100+1
N90 IF[#100LT4]GOTO30
N100 M30
O200
G1 X20 F200
Y20
M99
'''

# (name, script, lines expected in this order on standard output, exit status)
SCRIPTS = [
    ('a place is file:line: text', 'step\n', ['p.nc:1: N10 G21 G90 G17', 'p.nc:2: N20 #100=1'], 0),
    ('into a call, and out of it', 'until 3\nstep 2\nwhere\nfinish\n',
     ['p.nc:3: N30 M98 P200', 'p.nc:12: G1 X20 F200', 'p.nc:12: G1 X20 F200', '  O200 called in line 3', 'p.nc:4: N40 G0 X10 Y10 Z5'], 0),
    ('over a call', 'next 3\n', ['p.nc:4: N40 G0 X10 Y10 Z5'], 0),
    ('a breakpoint with a condition', 'break 5 if #100 == 3\nbreaks\ncontinue\nprint #100\n',
     ['breakpoint 1', '1  5 if #100 == 3', 'breakpoint 1', 'p.nc:5: N50 G81 X1 Y1 Z-5 R1 F100', '#100 = 3'], 0),
    ('a condition alone, a call', 'break if #100 EQ 3\nc\np #100\ndelete 1\nbreak call O200\nc\n',
     ['breakpoint 1', 'p.nc:9: N90 IF[#100LT4]GOTO30', '#100 = 3', 'breakpoint 1', 'p.nc:11: O200'], 0),
    ('watches are told at each stop', 'watch #100\nstep 2\nunwatch 1\nstep\n', ['#100 = vacant', 'p.nc:3: N30 M98 P200', '#100 = 1'], 0),
    ('a pass of a line', 'until 12:3\nprint #100\n', ['p.nc:12: G1 X20 F200', '#100 = 3'], 0),
    ('a block of the operator', 'until 4\nmdi G0 Z77\nstate\n', ['p.nc:4: N40 G0 X10 Y10 Z5', '  position  X 20 Y 20 Z 77'], 0),
    ('a wrong block of the operator', 'until 4\nmdi G0 Q\nwhere\n', ['p.nc:4: N40 G0 X10 Y10 Z5'] * 3, 0),
    ('back', 'until 12:2\nprint #100\nback\nprint #100\n', ['#100 = 2', 'p.nc:1: N10 G21 G90 G17', '#100 = vacant'], 0),
    ('list', 'until 4\nlist 3\n', ['      3  N30 M98 P200', '▸     4  N40 G0 X10 Y10 Z5', '      5  N50 G81 X1 Y1 Z-5 R1 F100'], 0),
    ('to its end, with the summary', 'continue\nstep\n', ['the program is over', 'the program is over', 'blocks          36'], 0),
    ('what is not understood', 'foo\nstep x\nbreak\nbreak 0\ndelete 7\nuntil\nprint\n',
     ['foo: no such command (help lists them)', 'x: not understood (help)', ': not understood (help)', '0: not understood (help)',
      '7: not understood (help)', ': not understood (help)'], 0),
    ('the blocks of a restart', 'until 5\nrestart 50\n',
     ['p.nc:5: N50 G81 X1 Y1 Z-5 R1 F100', '#100=1', 'G0 Z50.', 'G0 X10. Y10.', 'G0 Z7.', 'G1 Z5. F100', 'G0', 'F200'], 0),
    ('restart there, and wrong ones', 'restart x\nrestart 10\n', ['x: not understood (help)'], 0),
    ('the block search of the control', 'search 4\nback\nsearch 99\n', ['p.nc:4: N40 G0 X10 Y10 Z5', 'p.nc:1: N10 G21 G90 G17', 'the program is over'], 0),
    ('comments and empty lines of a script', '# first\n\nstep\nquit\nstep\n', ['p.nc:2: N20 #100=1'], 0),
]

tally = harness.Tally()
check = lambda name, good, what='': tally.expect(good, name, what)  # noqa: E731


def in_order(wanted, lines):
    rest = iter(lines)
    return all(any(line == want for line in rest) for want in wanted)


class Bench:
    def __init__(self, kadr, folder):
        self.kadr, self.folder = kadr, Path(folder)

    def run(self, command, *options, script='', program=PROGRAM, control='nct', lang='en'):
        (self.folder / 'p.nc').write_text(program)
        return subprocess.run([self.kadr, command, 'p.nc', '--control', control, '--lang', lang, *options], cwd=self.folder, input=script,
                              capture_output=True, text=True, timeout=harness.TIME_LIMIT_S)

    def trace(self, *options):
        done = self.run('run', *options, '--trace', '-', '--quiet')
        return done, [json.loads(line) for line in done.stdout.splitlines()]


def scripts(bench):
    for name, script, wanted, status in SCRIPTS:
        done = bench.run('debug', script=script)
        check(name, done.returncode == status and in_order(wanted, done.stdout.splitlines()),
              f'{done.returncode}\n{done.stdout}{done.stderr}')
    done = bench.run('debug', script='until 4\nmdi G0 Q\n')
    check('the alarm of a block of the operator', 'MDI:1:' in done.stderr, done.stderr)
    done = bench.run('debug', script='continue\nprint #1\nback\nstep\n', program='#1=5\nG0 X1\nG999\nG0 X3\nM30\n')
    check('stopped by an alarm, back before it', done.returncode == 0 and 'p.nc:3:' in done.stderr and '#1 = 5' in done.stdout, done.stdout)
    done = bench.run('debug', script='continue\nstep\n', program='#1=5\nG0 X1\nG999\nM30\n')
    check('stopped by an alarm', done.returncode == 1 and 'stopped by an alarm' in done.stdout, done.stdout)
    done = bench.run('debug', '--from', '12:2', '--to', '12', script='print #100\ncontinue\n')
    check('from a line on, to a line', in_order(['p.nc:12: G1 X20 F200', '#100 = 2', 'p.nc:13: Y20'], done.stdout.splitlines()), done.stdout)
    done = subprocess.run([bench.kadr, 'debug', '-', '--control', 'nct'], input='step\n', capture_output=True, text=True,
                          timeout=harness.TIME_LIMIT_S)
    check('the program cannot come with the commands', done.returncode == 2 and done.stdout == '', done.stderr)
    done = bench.run('debug', '--trace', 't.jsonl', script='step 3\nquit\n')
    check('the trace of a part', done.returncode == 0 and '"end"' in (bench.folder / 't.jsonl').read_text(), done.stderr)
    russian = bench.run('debug', lang='ru', script='foo\nhelp\n')
    check('in Russian', 'такой команды нет' in russian.stdout and 'точки останова' in russian.stdout, russian.stdout)


def parts(bench):
    _, whole = bench.trace()
    done, part = bench.trace('--from', '12:2')
    actions = [a for a in whole if a['do'] != 'end']
    second = [i for i, a in enumerate(actions) if a['line'] == 12][1]
    check('from a pass: what follows of the whole', [a for a in part if a['do'] != 'end'] == actions[second:], part[:2])
    check('from: the end is that of the whole', part[-1] == whole[-1], part[-1])
    check('from: the state is told', done.returncode == 0 and 'p.nc:12: G1 X20 F200' in done.stderr and '#100=2' in done.stderr, done.stderr)
    _, part = bench.trace('--to', '5')
    check('to: the line itself is carried out', part[-2]['line'] == 5 and part[-1]['do'] == 'end', part)
    _, part = bench.trace('--from', '4', '--to', '4')
    check('one line', [a['line'] for a in part[:-1]] == [4], part)
    _, part = bench.trace('--to', '3')
    check('to: the calls of the line too', [a['line'] for a in part[:-1] if a['do'] != 'm'] in ([12, 13], [1, 12, 13]), part)
    for options, status, text in ((('--from', '0'), 2, 'LINE'), (('--from', 'x'), 2, 'LINE'), (('--from', '5:0'), 2, 'LINE'),
                                  (('--to', '-3'), 2, 'LINE'), (('--from', '999'), 2, 'not reached'), (('--from', '12:9'), 2, 'comes 3 times')):
        done = bench.run('run', *options)
        check(' '.join(options), done.returncode == status and text in done.stderr, f'{done.returncode} {done.stderr}')
    done = bench.run('run', '--from', '4', program='G0 X1\nG999\n\nG0 X2\nM30\n')
    check('an alarm before', done.returncode == 1 and 'p.nc:2:' in done.stderr and 'alarm comes before' in done.stderr, done.stderr)
    contour = 'G21 G90 G17 F500\nG0 X0 Y0\nG41 D1 G1 X10 Y10\nX50\nY50\nX10\nY10\nG40 X0 Y0\nM30\n'
    for line in range(1, 10):
        (bench.folder / 's.json').write_text('{"offsets": {"1": {"radius": 2}}}')
        done = bench.run('run', '--from', str(line), '--quiet', '--setup', 's.json', '--trace', '-', '--samples', 'samples.csv', program=contour)
        check(f'from line {line} of a compensated contour', done.returncode == 0, done.stderr)


def signals(bench):
    endless = '#1=0\nWHILE[#1GE0]DO1\n#1=#1+1\nEND1\nM30\n'
    (bench.folder / 'p.nc').write_text(endless)
    for command in (['debug', 'p.nc'], ['run', 'p.nc', '--from', '5']):
        started = subprocess.Popen([bench.kadr, *command, '--control', 'nct', '--max-blocks', '1000000000000'], cwd=bench.folder, stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        if command[0] == 'debug':
            started.stdin.write('continue\n')
            started.stdin.flush()
        begun = harness.at_work(started)
        took = harness.spent_after(started, signal.SIGINT)
        check(f'Ctrl-C ends {command[0]} at once', begun and started.returncode == 130 and took < 1, f'{started.returncode}, {took:.2f} s of work')
        started.communicate()


def main():
    kadr = harness.kadr_of(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(kadr, folder)
        scripts(bench)
        parts(bench)
        signals(bench)
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
