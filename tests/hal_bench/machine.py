"""A HAL for the tests: builds modules/hal/kadr.c, loads it with halrun as an ordinary user and without real time, records what the joints get
with LinuxCNC's sampler, and measures it. Each HAL has mounts, shared memory, processes and a folder of components of its own.
"""
import os
import shutil
import subprocess
from pathlib import Path

import harness
from harness import expect

HEADERS, MODULES = Path('/usr/include/linuxcnc/hal.h'), Path('/usr/lib/linuxcnc/modules')
LIMITS = 1000, 20_000   # mm/s², mm/s³ of machines/linuxcnc-sim
MOST = 1.01, 1.03       # of these
SCALE = 1000            # the sampler prints six decimals: positions are recorded in µm
USER = 'nobody'         # as whom HAL runs if the test runs as root: rtapi_app refuses root

SETUP = '''loadrt threads name1=servo period1=1000000
loadrt kadr ring=test joints=3
loadrt mult2 count=3
loadrt sampler depth=16000 cfg=fffs
addf kadr.period servo
addf mult2.0 servo
addf mult2.1 servo
addf mult2.2 servo
addf sampler.0 servo
setp mult2.0.in1 {scale}
setp mult2.1.in1 {scale}
setp mult2.2.in1 {scale}
net x kadr.joint.0.motor-pos-cmd kadr.joint.0.motor-pos-fb mult2.0.in0
net y kadr.joint.1.motor-pos-cmd kadr.joint.1.motor-pos-fb mult2.1.in0
net z kadr.joint.2.motor-pos-cmd kadr.joint.2.motor-pos-fb mult2.2.in0
net x-um mult2.0.out sampler.0.pin.0
net y-um mult2.1.out sampler.0.pin.1
net z-um mult2.2.out sampler.0.pin.2
net state kadr.state sampler.0.pin.3
{more}
setp kadr.emc-enable-in {enable}
start
loadusr halsampler -t {folder}/rows.txt
loadusr -w bash {folder}/body.sh
loadusr -w sleep 0.3
'''


def missing():
    """Returns why nothing can be tested here; empty if it can."""
    if not shutil.which('halrun') or not shutil.which('rtapi_app'):
        return 'linuxcnc-uspace is not installed (dev/setup oracle)'
    if not HEADERS.exists():
        return 'linuxcnc-uspace-dev is not installed (dev/setup oracle)'
    if subprocess.run(namespace('true'), capture_output=True).returncode:
        return 'no namespaces can be created'
    return ''


def namespace(command):
    """Returns the words that run a shell command with mounts, shared memory and processes of its own."""
    root = os.geteuid() == 0
    return ['unshare', *([] if root else ['--map-current-user', '--keep-caps']), '--mount', '--ipc', '--pid', '--fork', '--kill-child', '--mount-proc',
            'bash', '-c', command]


class Machine(harness.Kadr):
    """Kadr and a HAL."""

    language = 'en'

    def components(self):
        """Returns a folder with LinuxCNC's components and ours."""
        folder = self.folder / 'modules'
        folder.mkdir()
        for module in MODULES.glob('*.so'):
            shutil.copy(module, folder)
        done = subprocess.run(['make', '-C', harness.ROOT / 'modules/hal', f'OUT={folder}'], capture_output=True, text=True)
        expect(done.returncode == 0 and 'warning' not in done.stderr, done.stderr)
        return folder

    def hal(self, body, more='', enable=1):
        """Runs the lines of `body` in bash, in the folder, while HAL runs; $KADR is the program.
        returns what was printed, and the recorded rows: x, y, z in mm, state"""
        modules = self.components()
        self.file('setup.hal', SETUP.format(scale=SCALE, more=more, enable=enable, folder=self.folder))
        self.file('body.sh', f'cd {self.folder}\n{body}\n')
        home = self.folder / 'home'
        home.mkdir(exist_ok=True)
        program = self.folder / 'kadr'
        shutil.copy(self.program, program)
        as_user = f'setpriv --reuid={USER} --regid=$(id -g {USER}) --clear-groups' if os.geteuid() == 0 else ''
        if as_user:
            subprocess.run(['chown', '-R', USER, self.folder], check=True)
        command = (f'mount --bind {modules} {MODULES} && mount -t tmpfs -o mode=1777 tmpfs /dev/shm && cd {home} && '
                   f'exec {as_user} env HOME={home} LANG=C KADR={program} halrun -f {self.folder}/setup.hal')
        done = subprocess.run(namespace(command), capture_output=True, text=True, timeout=harness.TIME_LIMIT_S, stdin=subprocess.DEVNULL)
        said = done.stdout + done.stderr
        rows = []
        for number, line in enumerate((self.folder / 'rows.txt').read_text().splitlines()):
            count, x, y, z, state = line.split()
            expect(int(count) == number, f'the sampler has lost rows: {line}')
            rows.append((float(x) / SCALE, float(y) / SCALE, float(z) / SCALE, int(state)))
        return said, rows


def moving(rows):
    """Returns the positions without repetitions."""
    positions = [row[:3] for row in rows]
    return [position for n, position in enumerate(positions) if n == 0 or position != positions[n - 1]]


def shares(rows):
    """Returns the greatest share of the acceleration and the jerk."""
    acceleration = jerk = 0
    for a in range(3):
        x = [row[a] for row in rows]
        for n in range(3, len(x)):
            acceleration = max(acceleration, abs(x[n] - 2 * x[n - 1] + x[n - 2]) * 1e6 / LIMITS[0])
            jerk = max(jerk, abs(x[n] - 3 * x[n - 1] + 3 * x[n - 2] - x[n - 3]) * 1e9 / LIMITS[1])
    return acceleration, jerk


def expect_in_limits(rows, said):
    acceleration, jerk = shares(rows)
    expect(acceleration <= MOST[0] and jerk <= MOST[1], f'acceleration {acceleration:.4f}, jerk {jerk:.4f}; {said}')


def main(text, checks):
    """Runs a runner whose checks get a Machine, one after the other; says so where there is no HAL.  returns the exit status"""
    why = missing()
    if not why:
        return harness.main(text, checks, make=Machine, jobs=1)
    harness.parsed(harness.arguments(text))
    harness.skipped(why)
    print('0 passed, 0 failed')
    return 0
