#!/usr/bin/env python3
"""Feeds the HAL component kadr with samples, without Kadr: a slow twin of what `kadr drive --hal` does.

    feeder.py SAMPLES.csv [--hold-at N]

SAMPLES.csv is what `kadr run --samples` has written, of X, Y, Z. The shortest ramp to rest from each sample is found by trying, with numpy.
The feeder holds when the component has come to sample N, lets it stand for 0.3 s, and lets it go on by a ramp that it has tried. It ends when
the component is at the last sample, with exit status 0, or reports a fault, with 1.
"""
import argparse
import ctypes
import mmap
import sys
import time

import numpy as np

AXES, SAMPLES, HEAD_BITS = 3, 4096, 40
ACCELERATION, JERK = 1000e-6 * 1.005, 20_000e-9 * 1.025   # mm per period² and period³ at 1 kHz, with the excess that is accepted
LONGEST = 2000   # periods
WAIT, END, HELD, ENDED, FAULT = 1, 2, 4, 6, 7


class Sample(ctypes.Structure):
    _fields_ = [('position', ctypes.c_double * 9), ('spindle', ctypes.c_float), ('line', ctypes.c_uint32), ('passed', ctypes.c_uint32),
                ('file', ctypes.c_uint16), ('brake', ctypes.c_uint16), ('flags', ctypes.c_uint16), ('tool', ctypes.c_uint16), ('reserved', ctypes.c_uint32)]


class Header(ctypes.Structure):
    _fields_ = [('magic', ctypes.c_uint64), ('version', ctypes.c_uint32), ('size', ctypes.c_uint32), ('axes', ctypes.c_uint32),
                ('period_ns', ctypes.c_uint32), ('speed', ctypes.c_double * 9)]


class Command(ctypes.Structure):
    _fields_ = [('head', ctypes.c_uint64), ('beat', ctypes.c_uint64), ('release', ctypes.c_uint64), ('hold', ctypes.c_uint32), ('ramp', ctypes.c_uint32),
                ('ramp_at', ctypes.c_uint64), ('ramp_part', ctypes.c_double), ('ramp_to', ctypes.c_double), ('ramp_periods', ctypes.c_double)]


class Status(ctypes.Structure):
    _fields_ = [('sequence', ctypes.c_uint64), ('ticks', ctypes.c_uint64), ('generation', ctypes.c_uint64), ('taken', ctypes.c_uint64), ('at', ctypes.c_uint64),
                ('part', ctypes.c_double), ('rate', ctypes.c_double), ('position', ctypes.c_double * 9), ('feedback', ctypes.c_double * 9),
                ('spindle_feedback', ctypes.c_double), ('state', ctypes.c_uint32), ('fault', ctypes.c_uint32), ('fault_axis', ctypes.c_uint32),
                ('ramp', ctypes.c_uint32), ('ramp_refused', ctypes.c_uint32), ('starved', ctypes.c_uint32), ('leases_lost', ctypes.c_uint32),
                ('at_speed', ctypes.c_uint32), ('tool_changed', ctypes.c_uint32), ('reserved', ctypes.c_uint32)]


class Ring(ctypes.Structure):
    _fields_ = [('header', Header), ('command', Command), ('status', Status), ('sample', Sample * SAMPLES)]


def passed(u, start, end):
    """Samples that a ramp of one period passes in its share u."""
    return start * u + (end - start) * (2.5 * u**4 - 3 * u**5 + u**6)


def positions(x, at, s):
    """Positions at the samples at + s: the cubic polynomial through four samples.  shape: len(at), len(s), AXES"""
    whole = np.floor(s).astype(int)
    part = (s - whole)[None, :, None]
    index = at[:, None] + whole[None, :]
    a, b, c, d = part + 1, part, part - 1, part - 2
    row = [x[np.clip(index + k, 0, len(x) - 1)] for k in (-1, 0, 1, 2)]
    return b * c * d / -6 * row[0] + a * c * d / 2 * row[1] + a * b * d / -2 * row[2] + a * b * c / 6 * row[3]


def keeps_limits(x, at, periods, start, end):
    """True for each of the samples `at` from which the ramp keeps acceleration and jerk."""
    n = np.arange(periods + 1)
    s = np.concatenate([np.arange(-3, 0) * start, passed(n / periods, start, end) * periods, periods * (start + end) / 2 + np.arange(1, 4) * end])
    rows = positions(x, at, s)
    return (np.abs(np.diff(rows, 2, axis=1)) <= ACCELERATION).all(axis=(1, 2)) & (np.abs(np.diff(rows, 3, axis=1)) <= JERK).all(axis=(1, 2))


def grid():
    periods = 8
    while periods <= LONGEST:
        yield periods
        periods = max(periods + 2, 2 * round(1.15 * periods / 2))


def brakes(x):
    """The shortest ramp to rest from each sample, in periods."""
    found, left = np.zeros(len(x), int), np.arange(len(x))
    for periods in grid():
        for part in np.array_split(left, max(1, len(left) // 500)):
            found[part[keeps_limits(x, part, periods, 1, 0)]] = periods
        left = np.flatnonzero(found == 0)
        if not len(left):
            return found
    raise SystemExit(f'no ramp from the samples {left}')


class Feeder:
    def __init__(self, x):
        self.file = open('/dev/shm/kadr-test', 'r+b')
        self.ring = Ring.from_buffer(mmap.mmap(self.file.fileno(), ctypes.sizeof(Ring)))
        self.x, self.brakes, self.head = x, brakes(x), 0
        command = self.ring.command
        command.hold, command.release, command.beat = 0, 0, command.beat + 1
        self.generation = (command.head >> HEAD_BITS) + 1
        command.head = self.generation << HEAD_BITS

    def fill(self):
        status = self.ring.status
        seen = status.generation == self.generation
        at, taken = (status.at, status.taken) if seen else (0, 0)
        while self.head < min(len(self.x), taken + SAMPLES, at + 3500):
            sample = self.ring.sample[self.head % SAMPLES]
            sample.position[:AXES] = self.x[self.head]
            sample.brake = int(self.brakes[self.head])
            sample.flags = WAIT if self.head == 0 else WAIT | END if self.head == len(self.x) - 1 else 0
            self.head += 1
            self.ring.command.head = self.generation << HEAD_BITS | self.head
        self.ring.command.beat += 1
        if taken > min(1500, len(self.x) - 1):
            self.ring.command.release = 2**64 - 1
        return status.state if seen else 0

    def go_on(self):
        command, status = self.ring.command, self.ring.status
        periods = next(n for n in grid() if keeps_limits(self.x, np.array([status.at]), n, 0, 1)[0])
        command.hold, command.ramp_at, command.ramp_part, command.ramp_to, command.ramp_periods = 0, status.at, 0, 1, periods
        command.ramp += 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('samples')
    parser.add_argument('--hold-at', type=int, default=1 << 40)
    options = parser.parse_args()
    feeder = Feeder(np.loadtxt(options.samples, delimiter=',', skiprows=1, ndmin=2)[:, 1:1 + AXES])
    held_at = None
    while True:
        state = feeder.fill()
        if state in (ENDED, FAULT):
            print(f'state {state}, fault {feeder.ring.status.fault}, at {feeder.ring.status.at}')
            return state == FAULT
        if feeder.ring.status.at >= options.hold_at and held_at is None:
            feeder.ring.command.hold, held_at = 1, 0
        if state == HELD and held_at == 0:
            held_at = time.monotonic()
        if state == HELD and held_at and time.monotonic() - held_at > 0.3:
            held_at = -1
            feeder.go_on()
        time.sleep(0.002)


if __name__ == '__main__':
    sys.exit(main())
