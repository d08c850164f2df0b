#!/usr/bin/env python3
"""Tests Ctrl-C, SIGTERM and a reader that closes its pipe: every command ends at once, whatever it is doing.

    run_interrupts.py --kadr build/kadr [--only 'sigint*']

Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import signal
import subprocess
import sys

import harness
from harness import expect

MOST_S = 1.0   # s of processor time after a signal; a command ends within 0.2 s on one processor, and some programs work in three threads

RUN = ('run', '{file}', '--quiet', '--max-passes', '1000000000', '--max-blocks', '1000000000000')
OPTIMAL = ('--machine', str(harness.ROOT / 'machines' / 'mach3-router.toml'))
MILL = ('mill', 'pocket', '{file}', '--tool-diameter', '2', '--stepover', '0.02', '--depth', '50', '--pass', '0.1', '--control', 'mach3')

# name: text of the program, command
WORK = {
    'blocks': ('F1000\nG1 X#1\n#1=[1-#1]\nM99\n', (*RUN, '--control', 'mach3')),
    'goto': ('N1 #1=#1+1\nGOTO 1\n', (*RUN, '--control', 'nct')),
    'while': ('#1=0\nWHILE[#1 GE 0] DO1\n#1=#1+1\nEND1\n', (*RUN, '--control', 'nct')),
    'check-loop': ('N1 #1=#1+1\nGOTO 1\n', ('check', '{file}', '--control', 'nct', '--max-blocks', '1000000000000')),
    'dwell-samples': ('G4 P99999999\nM30\n', (*RUN, '--control', 'mach3', '--samples', '{out}', *OPTIMAL)),
    'turns-why': ('G0 X50 Y200\nF100\n' + 'G2 I10 L9999\n' * 50, (*RUN, '--control', 'nct', '--why', *OPTIMAL)),
    'planner': (''.join(f'G1 X{i % 7} Y{i % 5} F3000\n' for i in range(200_000)), (*RUN, '--control', 'mach3', '--samples', '{out}', *OPTIMAL)),
    'trace': ('F1000\nG1 X#1\n#1=[1-#1]\nM99\n', (*RUN, '--control', 'mach3', '--trace', '{out}')),
    'mill': ('from 0 0\nline 200 0\nline 200 200\nline 0 200\nclose\n', MILL),
    'standard-input': (None, ('run', '-', '--control', 'mach3')),
}


class Kadr(harness.Kadr):
    def begin(self, name):
        """Starts the work of that name; its output goes into a file, so that a full pipe does not block it."""
        text, command = WORK[name]
        if text is not None:
            self.file('program.nc', text)
        self.file('out', 'old')
        words = [part.format(file=self.folder / 'program.nc', out=self.folder / 'out') for part in command]
        with open(self.folder / 'said', 'wb') as said:
            return self.start(*words, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=said)

    def said(self):
        return (self.folder / 'said').read_text(encoding='utf-8', errors='replace')


def interrupt(kadr, name, sent):
    process = kadr.begin(name)
    waits = WORK[name][0] is None   # for standard input, which stays open
    begun = harness.stands(process) if waits else harness.at_work(process)
    expect(begun and not harness.ended(process), f'it is not at work: {kadr.said()[:300]}')
    took = harness.spent_after(process, sent)
    expect(process.returncode == 128 + sent, f'exit status {process.returncode}, expected {128 + sent}; {kadr.said()[:300]}')
    expect(took < MOST_S, f'it worked on for {took:.2f} s after the signal')
    expect((kadr.folder / 'out').read_text(encoding='utf-8') == 'old', 'what was there was replaced')
    left = [path.name for path in kadr.folder.iterdir() if path.name not in ('program.nc', 'out', 'said')]
    expect(not left, f'left over: {left}')


def leave(kadr, command, text):
    """The reader reads one line and closes the pipe; the work is endless, so that it ends only because of that."""
    file = kadr.file('program.nc', text)
    with open(kadr.folder / 'said', 'wb') as said:
        process = kadr.start(*(part.format(file=file) for part in command), stderr=said)
    process.stdout.readline()
    process.stdout.close()
    before = harness.spent(process)
    expect(harness.until(lambda: harness.ended(process)), 'it does not end')
    took = harness.spent(process) - before
    process.wait()
    expect(process.returncode == 2, f'exit status {process.returncode}, expected 2; {kadr.said()[:300]}')
    lines = [line for line in kadr.said().splitlines() if line.startswith('kadr:')]
    expect(not lines, f'a reader that has enough is nothing to complain of: {kadr.said()!r}')
    expect(took < MOST_S, f'it worked on for {took:.2f} s for nobody')


def checks():
    """Returns name → check."""
    for name in WORK:
        yield f'sigint-{name}', lambda kadr, name=name: interrupt(kadr, name, signal.SIGINT)
    for name in ('blocks', 'dwell-samples'):
        yield f'sigterm-{name}', lambda kadr, name=name: interrupt(kadr, name, signal.SIGTERM)
    endless = 'F1000\nG1 X#1\n#1=[1-#1]\nM99\n'
    for option in ('--trace', '--samples'):
        yield f'pipe{option}', lambda kadr, option=option: leave(kadr, (*RUN, '--control', 'mach3', option, '-'), endless)


if __name__ == '__main__':
    sys.exit(harness.main(__doc__, dict(checks()), Kadr))
