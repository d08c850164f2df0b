#!/usr/bin/env python3
"""Tests `kadr drive` (docs/drive.md) over a pseudo-terminal, against the double of a Grbl controller (tests/drive/grbl_double.h).

    drive.py --kadr build/release/kadr --double build/release/tests/grbl_double

Nothing moves without --go and the answer `go`; with it the controller executes exactly the lines of the program; a refused row, an alarm, a
hold, a stop and Ctrl-C end as docs/drive.md says; the record is complete when the process is killed.
"""
import os
import signal
import subprocess
import sys
import time

import harness
from harness import expect

DOUBLE = ''
PROGRAM = '%\nG21 G90 G94 (a square)\nG54\nM3 S500\nG1 X5 F1500 ; first\nY5\nX0\nY0\nG4 P0.1\nM5\nM30\n'
SENT = ['G21G90G94', 'G54', 'M3S500', 'G1X5F1500', 'Y5', 'X0', 'Y0', 'G4P0.1', 'M5', 'M30']
LONG = 'G21G90G1F600\nX50\nY50\nX0\nY0\n'


class Machine:
    """A double behind a pseudo-terminal."""

    def __init__(self, *commands):
        self.process = subprocess.Popen([DOUBLE], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.port = self.process.stdout.readline().strip()
        for command in commands:
            self.tell(command)

    def tell(self, command):
        self.process.stdin.write(command + '\n')
        self.process.stdin.flush()

    def end(self):
        """Ends the double. Returns the lines that it executed, and its state and position."""
        out, _ = self.process.communicate('quit\n', timeout=harness.TIME_LIMIT_S)
        *lines, state = out.splitlines()
        return lines, state


def drive(kadr, machine, *options, typed='', program='p.nc'):
    return kadr.call('drive', program, '--control', 'grbl', '--port', machine.port, *options, input=typed)


def start(kadr, machine, *options):
    """Starts kadr drive --go, answers `go`, and waits until the axes move."""
    process = subprocess.Popen(kadr.command(['drive', 'p.nc', '--control', 'grbl', '--port', machine.port, '--go', *options]), cwd=kadr.folder,
                               stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    process.stdin.write('go\n')
    process.stdin.flush()
    log = kadr.folder / 'kadr-drive.log'
    until = time.monotonic() + harness.TIME_LIMIT_S
    while not (log.exists() and '<Run' in log.read_text()) and time.monotonic() < until and process.poll() is None:
        time.sleep(0.02)
    return process


def check_nothing_moves_without_go(kadr):
    kadr.file('p.nc', PROGRAM)
    machine = Machine()
    run = drive(kadr, machine)
    lines, state = machine.end()
    expect(run.returncode == 0, run.stderr)
    expect('nothing has moved' in run.stdout, run.stdout)
    expect('10 lines' in run.stdout and 'travel-x' in run.stdout, run.stdout)
    expect(lines == [] and state == 'Idle 0.000 0.000 0.000', f'{lines} {state}')


def check_another_answer_moves_nothing(kadr):
    kadr.file('p.nc', PROGRAM)
    for typed in ('', 'no\n', 'g\no\n'):
        machine = Machine()
        run = drive(kadr, machine, '--go', typed=typed)
        lines, _ = machine.end()
        expect(run.returncode == 1 and lines == [], f'{typed!r}: {run.returncode} {lines} {run.stderr}')
        expect('first motion: line 5: G1X5F1500: 5.000 mm to X5.000 Y0.000 Z0.000' in run.stdout, run.stdout)


def check_a_program_is_executed(kadr):
    kadr.file('p.nc', PROGRAM)
    machine = Machine()
    run = drive(kadr, machine, '--go', '--out', 'sent.nc', typed='go\n')
    lines, state = machine.end()
    expect(run.returncode == 0, run.stderr)
    expect('finished: 10 lines executed' in run.stderr, run.stderr)
    expect(lines == SENT and state == 'Idle 0.000 0.000 0.000', f'{lines} {state}')
    expect((kadr.folder / 'sent.nc').read_text().split() == SENT, 'the lines of --out are others')
    log = (kadr.folder / 'kadr-drive.log').read_text()
    expect(all(f'> {line}\n' in log for line in SENT) and '< ok' in log, log)


def check_a_program_of_another_control(kadr):
    kadr.file('part.ngc', 'G21 G90 G17\nG0 X1 Y1\n#1 = 3\no100 repeat [2]\nG91 G1 X#1 F1200\no100 endrepeat\nG90\nG1 X8 Y2\nM2\n')
    machine = Machine()
    run = kadr.call('drive', 'part.ngc', '--control', 'linuxcnc', '--port', machine.port, '--go', input='go\n')
    lines, state = machine.end()
    expect(run.returncode == 0, run.stderr)
    expect(state.startswith('Idle 8.000 2.000'), f'{lines} {state}')


def check_the_work_offset_of_the_controller_counts(kadr):
    kadr.file('p.nc', 'G21G90G0X1Y1\n')
    machine = Machine('offset G54 10 20 0')
    run = drive(kadr, machine, '--go', typed='go\n')
    _, state = machine.end()
    expect(run.returncode == 0 and state == 'Idle 11.000 21.000 0.000', f'{run.stderr} {state}')
    kadr.file('setup.json', '{"work_offsets": {"G54": {"X": 10, "Y": 20.5}}}')
    machine = Machine('offset G54 10 20 0')
    run = drive(kadr, machine, '--setup', 'setup.json')
    machine.end()
    expect(run.returncode == 1 and 'g54        REFUSED' in run.stdout, run.stdout + run.stderr)


def check_refused_rows(kadr):
    kadr.file('p.nc', 'G21G90\nM3S5000\nG1X400F100\n')
    machine = Machine('set 32 1')
    run = drive(kadr, machine)
    for row in ('travel-x', 'speed', 'laser'):
        expect(f'{row:10} REFUSED' in run.stdout, run.stdout)
    expect(run.returncode == 1 and '--accept' in run.stderr, run.stderr)
    run = drive(kadr, machine, '--accept', 'travel-x', '--accept', 'speed', '--accept', 'laser')
    expect(run.returncode == 0, run.stderr)
    machine.end()


def check_a_faulty_program_sends_nothing(kadr):
    for text, what in (('G21\nG1X5\n', 'p.nc:2'), ('G21\n$130=999\n', 'p.nc:2'), ('G1 X1 F100 Q1\n', 'p.nc:1')):
        kadr.file('p.nc', text)
        machine = Machine()
        run = drive(kadr, machine, '--go', typed='go\n')
        lines, _ = machine.end()
        expect(run.returncode == 1 and what in run.stderr and lines == [], f'{text!r}: {run.returncode} {run.stderr} {lines}')


def check_recorded_settings(kadr):
    kadr.file('p.nc', PROGRAM)
    kadr.file('grbl.txt', '$110=1000.000\n$111=1000.000\n$112=500.000\n$130=200\n$131=200\n$132=50\n[VER:1.1h.20190830:]\nok\n')
    run = kadr.call('drive', 'p.nc', '--control', 'grbl', '--settings', 'grbl.txt')
    expect(run.returncode == 0 and 'feed       note' in run.stdout, run.stdout + run.stderr)
    expect(kadr.call('drive', 'p.nc', '--control', 'grbl', '--settings', 'grbl.txt', '--go').returncode == 2, '--go without a port')
    expect(kadr.call('drive', 'p.nc', '--control', 'grbl').returncode == 2, 'neither port nor settings')
    expect(kadr.call('drive', '--port', '/dev/null').returncode == 2, 'no program')
    run = kadr.call('drive', 'p.nc', '--control', 'grbl', '--port', '/dev/null')
    expect(run.returncode == 1 and 'no serial line' in run.stderr, run.stderr)


def check_the_status(kadr):
    machine = Machine()
    run = kadr.call('drive', '--status', '--port', machine.port)
    machine.end()
    expect(run.returncode == 0 and run.stdout.startswith('Idle X0.000 Y0.000 Z0.000 ('), run.stdout + run.stderr)


def check_a_port_has_one_owner(kadr):
    kadr.file('p.nc', LONG)
    machine = Machine()
    process = start(kadr, machine)
    run = kadr.call('drive', '--status', '--port', machine.port)
    expect(run.returncode == 1 and 'another program' in run.stderr, run.stderr)
    process.stdin.write('s\n')
    process.communicate(timeout=harness.TIME_LIMIT_S)
    machine.end()


def check_hold_resume_and_stop(kadr):
    kadr.file('p.nc', LONG)
    machine = Machine()
    process = start(kadr, machine)
    process.stdin.write('h\n')
    process.stdin.flush()
    line = process.stderr.readline()
    while line and 'held' not in line:
        line = process.stderr.readline()
    expect('held at line 2' in line, line)
    process.stdin.write('r\n')
    process.stdin.flush()
    time.sleep(0.5)
    process.stdin.write('s\n')
    process.stdin.flush()
    _, err = process.communicate(timeout=harness.TIME_LIMIT_S)
    _, state = machine.end()
    expect(process.returncode == 1 and 'stopped at line 2' in err, err)
    expect(state.startswith('Idle ') and not state.startswith('Idle 50'), state)


def check_ctrl_c_brings_the_axes_to_rest(kadr):
    kadr.file('p.nc', LONG)
    machine = Machine()
    process = start(kadr, machine)
    process.send_signal(signal.SIGINT)
    _, err = process.communicate(timeout=harness.TIME_LIMIT_S)
    _, state = machine.end()
    expect(process.returncode == 130 and 'stopped at line' in err, f'{process.returncode} {err}')
    expect(state.startswith('Idle '), f'the buffers are not empty: {state}')


def check_an_alarm_ends_the_job(kadr):
    kadr.file('p.nc', LONG)
    machine = Machine()
    process = start(kadr, machine)
    machine.tell('limit')
    _, err = process.communicate(timeout=harness.TIME_LIMIT_S)
    machine.end()
    expect(process.returncode == 1 and 'ALARM:1' in err and 'position is not certain' in err, err)


def check_the_record_survives_a_kill(kadr):
    kadr.file('p.nc', LONG)
    machine = Machine()
    process = start(kadr, machine)
    process.kill()
    process.communicate(timeout=harness.TIME_LIMIT_S)
    lines, _ = machine.end()
    log = (kadr.folder / 'kadr-drive.log').read_text()
    sent = [line.split(' > ', 1)[1] for line in log.splitlines() if ' > ' in line]
    expect(log.endswith('\n'), 'the last record is not complete')
    expect([line for line in sent if line[0] in 'GXY'][:len(lines)] == lines, f'{sent} {lines}')


def check_a_stop_of_the_program(kadr):
    kadr.file('p.nc', 'G21G90G1F300X1\nX2M0\nX3\n')
    machine = Machine()
    process = start(kadr, machine)
    line = process.stderr.readline()
    while line and 'line 2: X2M0' not in line:
        line = process.stderr.readline()
    process.stdin.write('r\n')
    process.stdin.flush()
    _, err = process.communicate(timeout=harness.TIME_LIMIT_S)
    lines, state = machine.end()
    expect(process.returncode == 0, err)
    expect(lines == ['G21G90G1F300X1', 'X2', 'X3'] and state.startswith('Idle 3.000'), f'{lines} {state}')


def check_a_stop_without_an_operator(kadr):
    kadr.file('p.nc', 'G21G90G1F3000X1\nX2M0\nX3\n')
    machine = Machine()
    run = drive(kadr, machine, '--go', typed='go\n')
    lines, state = machine.end()
    expect(run.returncode == 1 and 'nobody is there' in run.stderr, run.stderr)
    expect(lines == ['G21G90G1F3000X1', 'X2'] and state.startswith('Idle 2.000'), f'{lines} {state}')


def check_a_locked_controller(kadr):
    kadr.file('p.nc', PROGRAM)
    machine = Machine('set 22 1')
    run = drive(kadr, machine, '--home', '--go', '--accept', 'travel-x', '--accept', 'travel-y', typed='go\n')
    lines, _ = machine.end()
    expect(run.returncode == 0 and lines == SENT, f'{run.stderr} {lines}')


def lines_then(process, *typed):
    """Types each text after the line with its mark has come. Returns what the process printed."""
    seen = ''
    for mark, text in typed:
        line = process.stderr.readline()
        while line and mark not in line:
            seen += line
            line = process.stderr.readline()
        seen += line
        expect(line, f'waited in vain for {mark!r}: {seen}')
        process.stdin.write(text)
        process.stdin.flush()
    _, err = process.communicate(timeout=harness.TIME_LIMIT_S)
    return seen + err


def check_a_tool_change(kadr):
    """The second tool is 2 mm longer. The operator touches the part and sets Z to 0; the program goes on at the same point of the part."""
    kadr.file('p.nc', 'G21 G90 G54 G1 F1200\nM3 S500\nZ-1\nX5\nT2 M6\nX8\nZ3\nM5\n')
    machine = Machine()
    process = start(kadr, machine, '--spin-up', '0.1')
    err = lines_then(process, ('change the tool', 'M5\nj z 10 f3000\n'), ('done: $J', 'G10 L20 P1 Z7\n'), ('done: G10', 'r\n'),
                     ('Type go', 'go\n'))
    lines, state = machine.end()
    expect(process.returncode == 0, err)
    expect(not any('M6' in line for line in lines) and 'T2' in lines, f'M6 was sent: {lines}')
    # the jog ends at machine Z 9; work Z 7 there: the zero is 2 mm higher
    expect(state == 'Idle 8.000 0.000 5.000', f'{state} {lines}')
    after = lines[lines.index('G10L20P1Z7') + 1:]
    expect(after.index('M3') < next(n for n, line in enumerate(after) if 'G53' in line), f'the spindle does not turn before the way: {after}')
    expect('G53G1Z1F100' in after, f'the tool does not come to Z-1 of the shifted work: {after}')


def check_a_tool_change_that_the_operator_ends(kadr):
    kadr.file('p.nc', 'G21 G90 G1 F1200\nX5\nM6 T2\nX8\n')
    machine = Machine()
    process = start(kadr, machine)
    err = lines_then(process, ('change the tool', 's\n'))
    _, state = machine.end()
    expect(process.returncode == 1 and state == 'Idle 5.000 0.000 0.000', f'{err} {state}')
    kadr.file('p.nc', 'G21 G90 G1 F1200\nX5\nM6 T2 X7\n')
    machine = Machine()
    run = drive(kadr, machine)
    machine.end()
    expect(run.returncode == 2 and 'a line of its own' in run.stderr, run.stderr)


def check_by_hand_at_a_stop(kadr):
    kadr.file('p.nc', 'G21G90G1F1200X3\nX4M0\nX6\n')
    machine = Machine()
    process = start(kadr, machine)
    err = lines_then(process, ('line 2: X4M0', 'm\n'), ('By hand', '$100=1\nj y 5 f3000\n'), ('done: $J', 'r\n'), ('Type go', 'go\n'))
    lines, state = machine.end()
    expect(process.returncode == 0 and 'not sent: $100=1' in err, err)
    expect(state == 'Idle 6.000 0.000 0.000' and 'G53G0Y0' in lines, f'{state} {lines}')


def check_a_jog_is_cancelled(kadr):
    kadr.file('p.nc', 'G21G90G1F1200X3\nM0\nX6\n')
    machine = Machine()
    process = start(kadr, machine)
    for mark, typed in (('line 2: M0', 'm\n'), ('By hand', 'j y 200 f600\n'), ('done: $J', '')):
        while mark not in process.stderr.readline():
            expect(process.poll() is None, mark)
        process.stdin.write(typed)
        process.stdin.flush()
    time.sleep(0.3)
    process.stdin.write('h\n')
    process.stdin.flush()
    time.sleep(0.3)
    _, err = process.communicate('r\nno\n', timeout=harness.TIME_LIMIT_S)
    _, state = machine.end()
    expect(process.returncode == 1 and 'before line 3: X6' in err and 1 < float(state.split()[2]) < 100, f'{err} {state}')


def check_a_probe_motion_is_answered(kadr):
    """The part is 4 mm lower than the end of the motion: what follows depends on where the probe touched."""
    kadr.file('p.nc', 'G21 G90 G54 G0 Z0\nG38.2 Z-10 F600\nG10 L20 P1 Z1\nG1 F1200 Z5\nG38.2 Z0 F600\nG92 Z0\nG0 Z2\nX1\n')
    machine = Machine('probe 0.4')
    run = drive(kadr, machine, '--go', '--accept', 'travel-z', typed='go\n')
    lines, state = machine.end()
    expect(run.returncode == 0 and 'touched at X0.000 Y0.000 Z-4.000' in run.stderr, run.stderr)
    # Z1 is at machine -4; Z5 at 0; from there 0.4 of 5 mm down: machine -2, which is Z0 of G92; Z2 at machine 0
    expect('touched at X0.000 Y0.000 Z-2.000' in run.stderr and state == 'Idle 1.000 0.000 0.000', f'{run.stderr} {state} {lines}')
    expect([line for line in lines if 'G38' in line] == ['G38.2Z-10F600', 'G38.2Z0F600'], f'{lines}')


def check_a_probe_that_touches_nothing(kadr):
    kadr.file('p.nc', 'G21 G90\nG38.2 Z-5 F600\nG1 X5 F600\n')
    machine = Machine('probe 2')
    run = drive(kadr, machine, '--go', typed='go\n')
    lines, state = machine.end()
    expect(run.returncode == 1 and 'ALARM:5' in run.stderr and not any('X5' in line for line in lines), f'{run.stderr} {state} {lines}')


def check_a_start_in_the_middle(kadr):
    kadr.file('p.nc', 'G20 G90 G55 G17\nM3 S700\nM8\nG0 X1 Y1\nG1 Z-0.1 F20\nG91\nX1\nY1 ; here\nX-1\nM5\n')
    machine = Machine('offset G55 10 20 -5')
    run = drive(kadr, machine, '--go', '--from', '8', '--spin-up', '0.1', '--clear', '1', typed='go\n')
    lines, state = machine.end()
    expect(run.returncode == 0 and 'before line 8: Y1 ; here' in run.stderr, run.stderr + run.stdout)
    # G55 10 20 -5 and inches: line 8 begins at X2 Y1 Z-0.1 and ends, after line 9, at X1 Y2 Z-0.1
    expect(state == 'Idle 35.400 70.800 -7.540', f'{state} {lines}')
    head = lines[:lines.index('Y1')]
    expect(head.index('M3') < head.index('G4P0.1') < head.index('G53G0X60.8Y45.4'), f'{head}')
    expect('G53G1Z-7.54F100' in head and 'M8' in head and 'S700' in head and 'G91' in head and 'G20' in head, f'{head}')
    expect('first motion: line 0: G53G0Z1' in run.stdout, run.stdout)


def check_a_start_that_is_not_possible(kadr):
    kadr.file('p.nc', 'G21 G90 G1 F100\nG2 X10 Y0 I5 J0\nX0 Y0 I-5 J0\nX5\n')
    machine = Machine()
    run = drive(kadr, machine, '--from', '3')
    expect(run.returncode == 1 and 'no line sets G2' in run.stderr, run.stderr)
    run = drive(kadr, machine, '--from', '9')
    expect(run.returncode == 1 and 'no block there' in run.stderr, run.stderr)
    run = kadr.call('drive', 'p.nc', '--control', 'grbl', '--settings', 'p.nc', '--from', '3')
    expect(run.returncode == 2, run.stderr)
    machine.end()


def check_the_check_mode(kadr):
    kadr.file('p.nc', 'G21 G90\nM3 S500\nG10 L2 P1 X1\nG4 P5\nG1 X5 F600\nM0\nM5\n')
    machine = Machine()
    run = drive(kadr, machine, '--check')
    lines, state = machine.end()
    expect(run.returncode == 0 and 'has read 5 lines' in run.stderr and 'nothing has moved' in run.stdout, run.stderr + run.stdout)
    expect(lines == ['checked 5'] and state == 'Idle 0.000 0.000 0.000', f'{lines} {state}')
    kadr.file('p.nc', 'G21 G90\nG1 X5 F600\nG18\nX6\n')  # the double knows only G17
    machine = Machine()
    run = drive(kadr, machine, '--check', '--go', typed='go\n')
    lines, state = machine.end()
    expect(run.returncode == 1 and 'line 3: error:20 to G18' in run.stderr and 'Type go' not in run.stdout, run.stderr + run.stdout)
    expect(state == 'Idle 0.000 0.000 0.000', f'{lines} {state}')


def check_the_feed_override(kadr):
    kadr.file('p.nc', 'G21G90G1F600X1\nX20\n')
    machine = Machine()
    process = start(kadr, machine, '--feed', '20')
    err = lines_then(process, ('feed 20 %', '+'), ('feed 30 %', 's\n'))
    machine.end()
    expect(process.returncode == 1, err)
    sent = (kadr.folder / 'kadr-drive.log').read_text()
    expect('> \\x90' + '\\x92' * 8 + '\\x97' in sent and '> \\x90' + '\\x92' * 7 + '\\x96' in sent, sent)


def check_hold_acts_at_once(kadr):
    """From the key to the byte at the controller, on this machine."""
    kadr.file('p.nc', LONG)
    times = []
    for _ in range(5):
        machine = Machine()
        process = start(kadr, machine)
        time.sleep(0.05)
        pressed = time.time()
        process.stdin.write('h\n')
        process.stdin.flush()
        log = kadr.folder / 'kadr-drive.log'
        while ' > !' not in log.read_text():
            time.sleep(0.0005)
        times.append(time.time() - pressed)
        process.stdin.write('s\n')
        process.communicate(timeout=harness.TIME_LIMIT_S)
        machine.end()
        log.unlink()
    expect(min(times) < 0.020, f'{times}')


def check_the_printed_commands(kadr):
    """The first day of docs/drive.md, in both languages."""
    kadr.file('part.nc', 'G21 G90 G94 G17 G54\nM3 S500\nG1 F1500\n' + ''.join(f'G1 X{n % 5} Y{n % 3}\n' for n in range(130)) + 'M5\nM30\n')
    for page in ('drive.md', 'ru/drive.md'):
        done = []
        for words in harness.printed_commands(page):
            if words[0] != 'drive':
                continue
            machine = Machine()
            words = [machine.port if w == 'PORT' else str(harness.ROOT / w) if w.startswith('examples/') else w for w in words]
            run = kadr.call(*words, input='go\n')
            lines, _ = machine.end()
            expect(run.returncode == 0, f'{page}: kadr {" ".join(words)}: {run.stdout}{run.stderr}')
            expect(bool(lines) == ('--go' in words), f'{page}: {words} {lines}')
            done += [word for word in words if word.startswith('--')] or ['proof']
        expect(sorted(set(done)) == ['--control', '--from', '--go', '--port', '--settings', '--status'], f'{page}: {done}')


def check_russian(kadr):
    kadr.file('p.nc', PROGRAM)
    machine = Machine()
    run = drive(kadr, machine, '--lang', 'ru')
    machine.end()
    expect('ничего не двигалось' in run.stdout and 'стойка: ' in run.stdout, run.stdout + run.stderr)


def main():
    global DOUBLE
    arguments = sys.argv[1:]
    if '--double' in arguments:
        at = arguments.index('--double')
        DOUBLE = os.path.abspath(arguments[at + 1])
        del arguments[at:at + 2]
    sys.argv[1:] = arguments
    return harness.main(__doc__, globals())


if __name__ == '__main__':
    sys.exit(main())
