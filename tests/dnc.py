#!/usr/bin/env python3
"""Tests `kadr dnc` (docs/dnc.md) over pseudo-terminals, with controls that have small buffers, stop the sender, punch and request programs.

    dnc.py --kadr build/release/kadr
"""
import os
import pty
import select
import signal
import subprocess
import sys
import threading
import time
import tty

import harness
from harness import expect

DC1, DC2, DC3, DC4, NAK = 0x11, 0x12, 0x13, 0x14, 0x15
S2C42 = '%\nN1 G0 X10 Y5\nN2 G1 X20 F600\nN3 M02\n'
PROGRAM = 'O1234\n' + ''.join(f'N{n} G1 X{n % 50}. Y{n % 7}. F200.\n' for n in range(1, 80)) + 'M30\n'


def even(code):
    """Returns the byte with even parity in its eighth bit."""
    return code | 0x80 if bin(code).count('1') % 2 else code


class Control:
    """A control at the other end of a serial line. `parity`: its characters have even parity in the eighth bit."""

    def __init__(self, parity=True, works=2000):
        self.master, slave = pty.openpty()
        tty.setraw(slave)
        self.port, self.kept = os.ttyname(slave), slave
        self.got, self.waiting, self.stopped, self.parity, self.works, self.ended = b'', 0, False, parity, works, False
        self.stops = 0
        self.thread = threading.Thread(target=self.serve, daemon=True)
        self.thread.start()

    def put(self, *codes):
        os.write(self.master, bytes(even(code) if self.parity else code for code in codes))

    def punch(self, text):
        os.write(self.master, bytes(even(c) if self.parity else c for c in b'\x12' + text.encode() + b'\x14'))

    def serve(self):
        last = time.monotonic()
        while not self.ended:
            ready, _, _ = select.select([self.master], [], [], 0.002)
            if ready:
                got = os.read(self.master, 4096)
                self.got += got
                self.waiting += len(got)
            now = time.monotonic()
            self.waiting = max(0, self.waiting - int((now - last) * self.works) - 1)
            last = now
            if self.waiting > 40 and not self.stopped:
                self.stopped, self.stops = True, self.stops + 1
                self.put(DC3)
            elif self.waiting < 10 and self.stopped:
                self.stopped = False
                self.put(DC1)

    def text(self):
        """Returns what came, without parity, leader and DC codes."""
        return bytes(b & 0x7f for b in self.got if b & 0x7f not in (0, DC1, DC2, DC3, DC4)).decode()

    def end(self):
        self.ended = True
        self.thread.join()
        os.close(self.master)
        os.close(self.kept)


def start(kadr, *words):
    return subprocess.Popen(kadr.command(['dnc', *words]), cwd=kadr.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def until(holds, what):
    end = time.monotonic() + harness.TIME_LIMIT_S
    while not holds():
        expect(time.monotonic() < end, f'waited in vain: {what}')
        time.sleep(0.02)


def check_a_program_is_sent_when_the_control_asks(kadr):
    kadr.file('p.nc', PROGRAM)
    control = Control(works=300)
    process = start(kadr, 'send', 'p.nc', '--control', 'fanuc', '--port', control.port, '--profile', 'fanuc-rs232', '--baud', '19200')
    time.sleep(1)
    expect(control.got == b'', 'it begins before DC1')
    control.put(DC1)
    _, err = process.communicate(timeout=harness.TIME_LIMIT_S)
    until(lambda: control.text().count('%') == 2, 'the end of the program')
    control.end()
    expect(process.returncode == 0 and control.text() == f'%\n{PROGRAM}%\n', f'{err} {control.text()[:200]!r}')
    expect(all(bin(b).count('1') % 2 == 0 for b in control.got), 'a byte has odd parity')
    expect(control.stops > 0 and f'stopped it {control.stops} times' in err, err)


def check_every_profile(kadr):
    kadr.file('p.nc', 'O7\nG0 X1.\nM30\n')
    for profile, parity in (('haas-rs232', False), ('generic', False), ('nct-rs232', False), ('iso7', True), ('s2c42-tape', True)):
        control = Control(parity)
        run = kadr.call('dnc', 'send', 'p.nc', '--unchecked', '--port', control.port, '--profile', profile, '--baud', '19200')
        until(lambda c=control: 'M30' in c.text(), profile)
        control.end()
        expect(run.returncode == 0 and 'G0 X1.' in control.text(), f'{profile}: {run.stderr} {control.text()!r}')


def check_a_faulty_program_is_not_sent(kadr):
    kadr.file('p.nc', 'O1\nG1 X10.\nG2 X0 Y5. I1. J1.\nM30\n')
    control = Control()
    run = kadr.call('dnc', 'send', 'p.nc', '--control', 'fanuc', '--port', control.port, '--profile', 'generic')
    expect(run.returncode == 1 and 'p.nc:' in run.stderr and control.got == b'', run.stderr)
    kadr.file('p.nc', 'O1\n(ПС)\nM30\n')
    run = kadr.call('dnc', 'send', 'p.nc', '--unchecked', '--port', control.port, '--profile', 'haas-rs232')
    control.end()
    expect(run.returncode == 1 and 'byte 5' in run.stderr, run.stderr)


def check_a_refusal_of_the_control(kadr):
    kadr.file('p.nc', PROGRAM)
    control = Control()
    process = start(kadr, 'send', 'p.nc', '--unchecked', '--port', control.port, '--profile', 'fanuc-rs232', '--baud', '1200')
    time.sleep(0.5)
    control.put(DC1)
    until(lambda: len(control.got) > 20, 'characters')
    control.put(NAK)
    _, err = process.communicate(timeout=harness.TIME_LIMIT_S)
    control.end()
    expect(process.returncode == 1 and 'refused' in err, err)


def check_a_program_is_received(kadr):
    control = Control()
    process = start(kadr, 'receive', 'got.nc', '--port', control.port, '--profile', 'fanuc-rs232')
    until(lambda: DC1 in [b & 0x7f for b in control.got], 'DC1')
    control.punch(f'%\n{PROGRAM}%\n')
    _, err = process.communicate(timeout=harness.TIME_LIMIT_S)
    control.end()
    expect(process.returncode == 0 and (kadr.folder / 'got.nc').read_text() == f'%\n{PROGRAM}%\n', err)


def check_a_wrong_parity_is_reported(kadr):
    control = Control(parity=False)
    process = start(kadr, 'receive', 'got.nc', '--port', control.port, '--profile', 'fanuc-rs232')
    until(lambda: DC1 in control.got, 'DC1')
    os.write(control.master, bytes(map(even, b'%\nO1\nM3')) + b'\x31' + bytes(map(even, b'\n%\n')))
    _, err = process.communicate(timeout=harness.TIME_LIMIT_S)
    control.end()
    expect(process.returncode == 1 and '1 bytes' in err, err)


def check_a_server_stores_versions_and_answers_requests(kadr):
    (kadr.folder / 'archive').mkdir()
    kadr.file('archive/FLANGE.NC', '%\nO55\nG0 X1.\nM30\n%\n')
    control = Control()
    process = start(kadr, 'serve', 'archive', '--unchecked', '--port', control.port, '--profile', 'fanuc-rs232', '--baud', '19200')
    stored = kadr.folder / 'archive' / 'O1234.nc'
    for text in (PROGRAM, PROGRAM, PROGRAM.replace('X3.', 'X4.')):
        began = control.got.count(even(DC1))
        until(lambda n=began: control.got.count(even(DC1)) + control.got.count(DC1) > 0, 'DC1')
        time.sleep(0.3)
        control.punch(f'%\n{text}%\n')
        until(lambda t=text: stored.exists() and stored.read_text() == f'%\n{t}%\n', 'the stored program')
        time.sleep(0.5)
    control.got = b''
    control.punch('%\nO8000(SEND FLANGE.NC)\nM30\n%\n')
    time.sleep(1)
    control.put(DC1)
    until(lambda: 'O55' in control.text() and control.text().rstrip().endswith('%'), 'the requested program')
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=harness.TIME_LIMIT_S)
    control.end()
    names = sorted(path.name for path in (kadr.folder / 'archive').iterdir())
    expect(len(names) == 3 and names[0] == 'FLANGE.NC' and names[1].startswith('O1234.2'), f'{names}')


def check_a_server_says_what_was_changed_at_the_control(kadr):
    (kadr.folder / 'changed').mkdir()
    control = Control()
    process = start(kadr, 'serve', 'changed', '--control', 'fanuc', '--port', control.port, '--profile', 'fanuc-rs232', '--baud', '19200')
    stored = kadr.folder / 'changed' / 'O0077.nc'
    first = 'O0077\nN10 G21 G90 G54\nN20 G0 X1. Y1.\nN30 G1 X9. F200\nN40 M30\n'
    for text in (first, first.replace('N30', '(SLOWER)\nN30'), first.replace('F200', 'F300'), first.replace('F200', 'F300').replace('X9.', 'X8.')):
        began = control.got.count(even(DC1))
        until(lambda n=began: control.got.count(even(DC1)) + control.got.count(DC1) > 0, 'DC1')
        time.sleep(0.3)
        control.punch(f'%\n{text}%\n')
        until(lambda t=text: stored.exists() and stored.read_text() == f'%\n{t}%\n', 'the stored program')
        time.sleep(1.2)
    process.send_signal(signal.SIGINT)
    _, err = process.communicate(timeout=harness.TIME_LIMIT_S)
    control.end()
    versions = err.split('another text than before')
    expect(len(versions) == 4, err)
    expect('equal' in versions[1] and 'F200' not in versions[1], f'a comment: {versions[1]}')
    expect('F200' in versions[2] and 'F300' in versions[2], f'a feed: {versions[2]}')
    expect('equal' not in versions[3] and '5 | 5' in versions[3], f'a way: {versions[3]}')


def check_the_printed_commands(kadr):
    """The first days of docs/dnc.md, step by step, in both languages: what a step writes, the next one reads."""
    for page in ('dnc.md', 'ru/dnc.md'):
        folder = kadr.folder / page.replace('/', '-')
        folder.mkdir()
        (folder / 'part.nc').write_text(S2C42)
        done = []
        for words in harness.printed_commands(page):
            control = Control()
            process = subprocess.Popen(kadr.command([control.port if w == 'PORT' else w for w in words]), cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            if words[:2] == ['dnc', 'receive']:
                until(lambda c=control: DC1 in [b & 0x7f for b in c.got], 'DC1')
                control.punch('%\nO1234\nG21 G90 G54\nG0 X1. Y2.\nM30\n%\n')
            elif words[:2] == ['dnc', 'send']:
                time.sleep(0.5)
                control.put(DC1)
            out, err = process.communicate(timeout=harness.TIME_LIMIT_S)
            control.end()
            expect(process.returncode == 0, f'{page}: kadr {" ".join(words)}: {out}{err}')
            if words[:2] == ['dnc', 'send'] and 'fanuc' in words:  # received again
                (folder / 'received.nc').write_text(control.text())
            if words[:2] == ['tape', 'encode']:
                (folder / 'old.tape').write_bytes((folder / 'part.tape').read_bytes())
            done.append(' '.join(words[:2]))
        expect(sorted(done) == sorted(['dnc receive', 'check O1234.nc', 'dnc send', 'diff O1234.nc', 'check part.nc', 'tape encode', 'tape decode', 'dnc send']), f'{page}: {done}')


def check_wrong_usage(kadr):
    kadr.file('p.nc', PROGRAM)
    expect(kadr.call('dnc', 'send', 'p.nc', '--port', '/dev/null', '--profile', 'none').returncode == 2, 'an unknown profile')
    expect(kadr.call('dnc').returncode == 2, 'no subcommand')
    run = kadr.call('dnc', 'send', 'p.nc', '--unchecked', '--port', '/dev/null', '--profile', 'generic')
    expect(run.returncode == 1 and 'no serial line' in run.stderr, run.stderr)
    run = kadr.call('dnc', 'send', 'p.nc', '--unchecked', '--port', '/dev/null', '--profile', 'generic', '--baud', '1000')
    expect(run.returncode == 2, run.stderr)


if __name__ == '__main__':
    sys.exit(harness.main(__doc__, globals()))
