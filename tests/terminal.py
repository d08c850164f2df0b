#!/usr/bin/env python3
"""Tests the output on a terminal: colours of messages, and that the progress bar leaves nothing behind.

    terminal.py --kadr build/kadr

Kadr runs in a pseudo terminal; the test draws its output on a screen of rows and columns, as a terminal would. Prints a line per
failure, then `N passed, N failed`. Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import fcntl
import os
import pty
import re
import select
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import time
from pathlib import Path

import harness
from harness import TIME_LIMIT_S

BAR = re.compile(r'\[#*\.+\] +\d+ %')
RED, YELLOW, CYAN, GREEN = '\033[1;31m', '\033[1;33m', '\033[1;36m', '\033[32m'


def screen(text, columns):
    """Returns the rows that the text leaves on a terminal, without trailing blanks."""
    rows, column = [[]], 0
    for c in re.sub('\033\\[[0-9;]*m', '', text):
        if c == '\n':
            rows.append([])
        elif c == '\r':
            column = 0
        else:
            if column == columns:
                rows.append([])
                column = 0
            row = rows[-1]
            row.extend(' ' * (column + 1 - len(row)))
            row[column] = c
            column += 1
        if c == '\n':
            column = 0
    return [''.join(row).rstrip() for row in rows]


class Terminal:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def run(self, words, env=(), columns=80, interrupt=False, out_too=True):
        """Returns the status and all output; the run is interrupted as soon as a bar appears."""
        leader, follower = pty.openpty()
        fcntl.ioctl(follower, termios.TIOCSWINSZ, struct.pack('HHHH', 24, columns, 0, 0))
        surroundings = {k: v for k, v in os.environ.items() if not k.startswith('LC_') and k != 'NO_COLOR'} | {'LANG': 'C', 'TERM': 'xterm'} | dict(env)
        process = subprocess.Popen([self.program, *words], stdin=subprocess.DEVNULL, stdout=follower if out_too else subprocess.DEVNULL,
                                   stderr=follower, env={k: v for k, v in surroundings.items() if v is not None}, cwd=self.folder)
        os.close(follower)
        text, sent, end = bytearray(), False, time.monotonic() + TIME_LIMIT_S
        while time.monotonic() < end:
            if select.select([leader], [], [], 0.1)[0]:
                try:
                    part = os.read(leader, 65536)
                except OSError:   # the other end is closed
                    break
                if not part:
                    break
                text += part
            if interrupt and not sent and BAR.search(text.decode(errors='replace')):
                process.send_signal(signal.SIGINT)
                sent = True
        if process.poll() is None and time.monotonic() >= end:
            process.kill()
        os.close(leader)
        return process.wait(), text.decode(errors='replace').replace('\r\n', '\n')


FAULTY = 'G21 G90 G0 X1\nX2 G999\nM30\n'
WARNED = '#1=ATAN[1]/[2]\nG0 X#1\nM30\n'   # a division here, but not on a Fanuc control: a warning
NOTED = 'G54 G0 X1\nM30\n'            # a work offset that no set-up states: a note
WORK = '+'.join(['SQRT[ABS[SIN[#1]*COS[#1]]]'] * 40)   # so slow that a second passes long before the limit of repeated blocks
LONG = '%\n' + 'G21 G90 G1 F1000 X0\n#1=0\nN10 #1=#1+1\nG1 X#1 F600\nIF[#1LT{count}*' + f'[1+0*[{WORK}]]]' + 'GOTO10\n{end}\n'


def colour_checks(terminal):
    def told(name, program, word, colour, env=()):
        (terminal.folder / 'p.nc').write_text(program)
        text = terminal.run(['run', 'p.nc', '--control', 'nct', '--quiet'], env)[1]
        plain = re.sub('\033\\[[0-9;]*m', '', text)
        faults = [] if word in plain else [f'no {word!r} in {text!r}']
        if colour and f'{colour}{word}\033[0m' not in text:
            faults.append(f'{word} is not coloured: {text!r}')
        if colour and not re.search(re.escape(GREEN) + r' *\^~*\033\[0m\n', text):
            faults.append(f'the mark is not green: {text!r}')
        if not colour and '\033' in text:
            faults.append(f'coloured: {text!r}')
        return name, faults

    yield told('an alarm is red', FAULTY, 'alarm', RED)
    yield told('an alarm is red, in Russian', FAULTY, 'ошибка', RED, {'LANG': 'ru_RU.UTF-8'})
    yield told('a warning is yellow', WARNED, 'warning', YELLOW)
    yield told('a note is cyan', NOTED, 'note', CYAN)
    yield told('NO_COLOR', FAULTY, 'alarm', None, {'NO_COLOR': '1'})
    yield told('NO_COLOR that is empty', FAULTY, 'alarm', RED, {'NO_COLOR': ''})
    yield told('a terminal without colours', FAULTY, 'alarm', None, {'TERM': 'dumb'})
    yield told('an unknown terminal', FAULTY, 'alarm', None, {'TERM': None})
    (terminal.folder / 'p.nc').write_text(FAULTY)
    for words in (['run', 'p.nc', '--control', 'nct'], ['check', 'p.nc', '--control', 'nct']):
        done = subprocess.run([terminal.program, *words], capture_output=True, text=True, cwd=terminal.folder, timeout=TIME_LIMIT_S,
                              env=os.environ | {'TERM': 'xterm'}, check=False)
        yield f'no colours in a pipe: {words[0]}', [] if 'G999' in done.stderr and '\033' not in done.stderr + done.stdout else [done.stderr]
    text = terminal.run(['check', 'p.nc', '--control', 'nct'])[1]
    yield 'check has colours', [] if f'{RED}alarm\033[0m' in text else [text]
    terminal.run(['check', 'p.nc', '--control', 'nct', '--output', 'found.txt'])
    found = (terminal.folder / 'found.txt').read_text()
    yield 'a file has none', [] if 'alarm' in found and '\033' not in found else [found]


def bar_checks(terminal, blocks):
    def left(name, words, status, interrupt=False, columns=80, env=()):
        got, text = terminal.run(words, env, columns, interrupt)
        rows = screen(text, columns)
        faults = [] if BAR.search(text) else [f'no bar was shown: {text[-300:]!r}']
        faults += [f'left behind: {row!r}' for row in rows if BAR.search(row) or '#' in row.replace('#1', '')]
        faults += [] if got == status else [f'status {got}']
        return name, faults, rows

    program = terminal.folder / 'long.nc'
    program.write_text(LONG.format(count=blocks, end='M30'))
    run = ['run', 'long.nc', '--control', 'nct']
    for columns in (80, 40):
        name, faults, rows = left(f'the summary stands alone, {columns} columns', run, 0, columns=columns)
        yield name, faults + ([] if rows[0].startswith('blocks') else [f'before the summary: {rows[:2]}'])
    name, faults, rows = left('in Russian', [*run, '--lang', 'ru'], 0)
    yield name, faults + ([] if rows[0].startswith('кадров') else [f'before the summary: {rows[:2]}'])
    program.write_text(LONG.format(count=blocks, end='G999\nM30'))
    name, faults, rows = left('an alarm stands on its own line', [*run, '--quiet'][:-1], 1)
    yield name, faults + ([] if rows[0].startswith('long.nc:7:1: alarm') else [f'before the alarm: {rows[:2]}'])
    name, faults, rows = left('of check, too', ['check', *run[1:]], 1)
    yield name, faults + ([] if rows[0].startswith('long.nc:7:1: alarm') else [f'before the alarm: {rows[:2]}'])
    program.write_text(LONG.format(count=100 * blocks, end='M30'))
    yield left('interrupted', run, 130, interrupt=True)[:2]
    program.write_text(LONG.format(count=blocks, end='M30'))
    text = terminal.run([*run, '--trace', '-'])[1]
    yield 'no bar among the lines of a trace', [] if not BAR.search(text) and text.count('"do":"feed"') > blocks / 2 else [
        f'{len(text)} characters, {text.count(chr(10))} lines, {bool(BAR.search(text))}']
    yield 'no bar with --quiet', [row for row in quiet_rows(terminal, program, blocks) if BAR.search(row)]


def quiet_rows(terminal, program, blocks):
    program.write_text(LONG.format(count=blocks, end='M30'))
    return terminal.run(['run', 'long.nc', '--control', 'nct', '--quiet'])[1].split('\r')


def blocks_for(terminal, seconds):
    """Returns enough blocks for the bar to appear, which it does after 0.8 s. They need this many seconds of processor time, so at least as
    long by the clock, whose time a busy machine could lengthen for the first run only."""
    program, blocks = terminal.folder / 'long.nc', 100_000
    while True:
        program.write_text(LONG.format(count=blocks, end='M30'))
        before = harness.spent_by_children()
        terminal.run(['run', 'long.nc', '--control', 'nct'])
        took = harness.spent_by_children() - before
        if took > seconds:
            return blocks
        blocks = int(blocks * min(10, 1.3 * seconds / max(took, 0.01)))


def main():
    tally = harness.Tally()
    with tempfile.TemporaryDirectory() as folder:
        terminal = Terminal(harness.kadr_of(__doc__), Path(folder))
        for name, faults in [*colour_checks(terminal), *bar_checks(terminal, blocks_for(terminal, 2.0))]:
            tally.judge(name, faults)
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
