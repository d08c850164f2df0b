#!/usr/bin/env python3
"""Ctrl-C, SIGTERM, a reader that goes away: every command ends at once, whatever it is at.

    run_interrupts.py --kadr build/kadr [--only 'sigint*']

Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import argparse
import fnmatch
import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
TIME_LIMIT_S = 20
BEGUN_S = 0.5        # by then it is at work
ENDED_S = 0.2        # promised (design.md 10) …
SLOWNESS_S = 1.0     # … and what a machine at full load may add before the processor comes round

RUN = ('run', '{file}', '--quiet', '--max-passes', '1000000000', '--max-blocks', '1000000000000')
OPTIMAL = ('--machine', str(ROOT / 'machines' / 'mach3-router.toml'))
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


class Failure(Exception):
    """Why a check failed, for a person."""


def expect(holds, why):
    if not holds:
        raise Failure(why)


def start(kadr, folder, name, stdout=subprocess.DEVNULL):
    text, command = WORK[name]
    file, out = Path(folder) / 'program.nc', Path(folder) / 'out'
    if text is not None:
        file.write_text(text, encoding='utf-8')
    out.write_text('old', encoding='utf-8')
    arguments = [part.format(file=file, out=out) for part in command]
    return subprocess.Popen([kadr, *arguments], cwd=folder, stdin=subprocess.PIPE, stdout=stdout, stderr=subprocess.PIPE)


def interrupt(kadr, folder, name, sent):
    process = start(kadr, folder, name)
    time.sleep(BEGUN_S)
    if process.poll() is not None:
        raise Failure(f'ended by itself, status {process.returncode}: {process.stderr.read()[:300]}')
    begin = time.monotonic()
    process.send_signal(sent)
    try:
        error = process.communicate(timeout=TIME_LIMIT_S)[1].decode(errors='replace')
    except subprocess.TimeoutExpired:
        process.kill()
        raise Failure('does not end') from None
    took = time.monotonic() - begin
    expect(process.returncode == 128 + sent, f'exit status {process.returncode}, expected {128 + sent}; {error[:300]}')
    expect(took < ENDED_S + SLOWNESS_S, f'ended {took:.2f} s after the signal')
    expect((Path(folder) / 'out').read_text(encoding='utf-8') == 'old', 'what was there was replaced')
    left = [path.name for path in Path(folder).iterdir() if path.name not in ('program.nc', 'out')]
    expect(not left, f'left over: {left}')


def leave(kadr, folder, command, text):
    """The reader takes one line and goes."""
    file = Path(folder) / 'program.nc'
    file.write_text(text, encoding='utf-8')
    process = subprocess.Popen([kadr, *(part.format(file=file) for part in command)], cwd=folder, stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    process.stdout.readline()
    process.stdout.close()
    begin = time.monotonic()
    try:
        process.wait(timeout=TIME_LIMIT_S)
    except subprocess.TimeoutExpired:
        process.kill()
        raise Failure('does not end') from None
    error = process.stderr.read().decode(errors='replace')
    expect(process.returncode == 2, f'exit status {process.returncode}, expected 2; {error[:300]}')
    said = [line for line in error.splitlines() if line.startswith('kadr:')]
    expect(len(said) == 1 and 'reader has gone' in said[0], f'one line should name the pipe: {error!r}')
    expect(time.monotonic() - begin < ENDED_S + SLOWNESS_S, 'it went on for nobody')


def checks():
    """Name → function of the program and a folder."""
    for name in WORK:
        yield f'sigint-{name}', lambda kadr, folder, name=name: interrupt(kadr, folder, name, signal.SIGINT)
    for name in ('blocks', 'dwell-samples'):
        yield f'sigterm-{name}', lambda kadr, folder, name=name: interrupt(kadr, folder, name, signal.SIGTERM)
    endless = 'F1000\nG1 X#1\n#1=[1-#1]\nM99\n'
    for option in ('--trace', '--samples'):
        yield f'pipe{option}', lambda kadr, folder, option=option: leave(kadr, folder, (*RUN, '--control', 'mach3', option, '-'), endless)


def main():
    parser = argparse.ArgumentParser(description='Check that every command ends when it is asked to.')
    parser.add_argument('--kadr', required=True, help='the program under test')
    parser.add_argument('--only', default='*', help='only checks whose name matches, e.g. "sigint*"')
    options = parser.parse_args()
    program = os.path.abspath(options.kadr)
    if not os.access(program, os.X_OK):
        print(f'{options.kadr}: not a program', file=sys.stderr)
        return 2
    chosen = {name: check for name, check in checks() if fnmatch.fnmatch(name, options.only)}
    if not chosen:
        print('no check of that name', file=sys.stderr)
        return 2
    failed = 0
    for name, check in chosen.items():
        with tempfile.TemporaryDirectory() as folder:
            try:
                check(program, folder)
            except Failure as failure:
                print(f'FAILED {name}: {failure}')
                failed += 1
    print(f'{len(chosen) - failed} passed, {failed} failed')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
