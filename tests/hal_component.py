#!/usr/bin/env python3
"""Tests the HAL component modules/hal/kadr.c in LinuxCNC's HAL, fed by a slow twin of Kadr (tests/hal_bench/feeder.py).

    hal_component.py --kadr build/release/kadr

The samples are those of `kadr run --samples`. Every sample arrives in order; a killed feeder and a hold brake along the path within 1.01 of
the acceleration and 1.03 of the jerk; wrong numbers in the shared memory move no joint faster than its limit. Skipped, with a message, without
linuxcnc-uspace, its headers, or the right to create namespaces.
"""
import shutil
import sys

import harness
from harness import expect
from hal_bench.machine import expect_in_limits, main, moving

PROGRAM = 'G21 G90 G61\nG1 X20 F6000\nG3 X25 Y5 I0 J5\nG64 P0.05\n' + ''.join(f'G1 X{x % 4 * 5} Y{x * 7 % 11} Z{x % 3} F9000\n' for x in range(10)) + 'M30\n'
# /usr/bin/python3 has Debian's numpy, whatever else is in the PATH.
BEGIN = '''sample() { while [ $(($(halcmd getp kadr.sample))) -lt $1 ]; do sleep 0.01; done; }
state() { while [ $(halcmd getp kadr.state) != $1 ]; do sleep 0.01; done; }
'''
FEED = '/usr/bin/python3 feeder.py s.csv'
PATIENT = 'setp kadr.lease-time 30'   # where the feeder lives: it may wait for a busy machine


def fed(kadr, body, **more):
    """Runs the lines of `body` with the samples and the feeder in the folder.  returns what was printed, the rows, and the samples"""
    kadr.file('p.nc', PROGRAM)
    kadr.run('run', 'p.nc', '--control', 'linuxcnc', '--machine', 'linuxcnc-sim', '-q', '--samples', 's.csv')
    shutil.copy(harness.ROOT / 'tests/hal_bench/feeder.py', kadr.folder)
    said, rows = kadr.hal(BEGIN + body, **more)
    return said, rows, [tuple(map(float, line.split(',')[1:4])) for line in (kadr.folder / 's.csv').read_text().splitlines()[1:]]


def check_every_sample_arrives(kadr):
    said, rows, samples = fed(kadr, f'{FEED}; echo status $?', more=PATIENT)
    expect('state 6' in said and 'status 0' in said, said)
    got, wanted = moving(rows), moving(samples)
    expect(len(got) == len(wanted), f'{len(got)} positions, {len(wanted)} samples; {said}')
    for n, (a, b) in enumerate(zip(got, wanted)):
        expect(all(abs(p - q) < 2e-9 for p, q in zip(a, b)), f'sample {n}: {a}, {b}')
    expect_in_limits(rows, said)


def check_a_killed_feeder(kadr):
    said, rows, _ = fed(kadr, f'{FEED} & feeder=$!; sample 800; kill -9 $feeder; state 4; halcmd getp kadr.leases-lost; halcmd getp kadr.fault')
    expect('1\n0\n' in said, said)
    expect(len(moving(rows)) > 800 and rows[-1][:3] == rows[-100][:3], f'{len(moving(rows))} positions; {said}')
    expect_in_limits(rows, said)


def check_holds(kadr):
    for place in (300, 700, 1234):
        said, rows, samples = fed(kadr, f'{FEED} --hold-at {place}; echo status $?', more=PATIENT)
        expect('state 6' in said and 'status 0' in said, said)
        expect(sum(row[3] == 4 for row in rows) > 100 and rows[-1][:3] == samples[-1], f'held at {place}: {said}')
        expect_in_limits(rows, said)
        shutil.rmtree(kadr.folder / 'modules')


def check_an_emergency_stop(kadr):
    said, rows, _ = fed(kadr, f'{FEED} & feeder=$!; sample 800; halcmd setp kadr.emc-enable-in 0; state 0; halcmd getp kadr.motion-enabled; sleep 0.1;'
                             'kill $feeder')
    expect('FALSE' in said, said)
    off = next(n for n, row in enumerate(rows) if n > 800 and row[3] == 0)
    expect(rows[off][:3] == rows[-1][:3], 'a joint moves without being enabled')


def check_wrong_numbers_in_the_memory(kadr):
    """Garbage over all samples and the number of samples: the component brakes along what it has accepted."""
    garbage = "f=open('/dev/shm/kadr-test','r+b');f.seek(96);f.write(b'\\xff'*8);f.seek(408);f.write(b'\\xa5'*4096*96);f.flush()"
    said, rows, _ = fed(kadr, f'{FEED} & feeder=$!; sample 800; kill -STOP $feeder; /usr/bin/python3 -c "{garbage}"; state 7; echo a fault; kill -9 $feeder')
    expect('a fault' in said, said)
    expect_in_limits(rows, said)


if __name__ == '__main__':
    sys.exit(main(__doc__, globals()))
