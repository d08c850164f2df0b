#!/usr/bin/env python3
"""Tests kadr-archive (docs/archive.md): every result is that of the program kadr; nothing is done twice; a kill loses, doubles and changes
nothing; hostile programs cost only themselves; report, CSV, difference and conversion.

    archive.py --kadr build/release/kadr [--only NAME]

KADR_ARCHIVE_KILLS: how many random kills (12; on a cluster half of that, by default 2; docs/benchmarks.md names the count of the figures).
Prints a line per failure, then `N passed, N failed`. Exit status: 0 all passed or skipped, 1 some failed, 2 wrong usage.
"""
import contextlib
import csv
import functools
import io
import json
import os
import pty
import random
import re
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
import zipfile
from pathlib import Path

import harness
from harness import ROOT, expect, until

PYTHON = '/usr/bin/python3' if Path('/usr/bin/python3').exists() else sys.executable   # the interpreter that the binding is built for
SLOW = '+SIN[#1]*COS[#1]' * 60   # Kadr ends an endless program by itself after 20,000,000 blocks: minutes, with this
ENDLESS = f'%\nO1\n#1=0\nN1 #1=#1{SLOW}+1\nGOTO1\nM30\n%\n'
GOOD = 'G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX{}\nG0 Z5\nM2\n'
WRONG = 'G21 G90\nG0 X0 Y0\nG1 X{} F100\nG2 X5 Y5 I90 J0\nM2\n'


class Archive(harness.Kadr):
    """kadr-archive, with the program under test as kadr."""

    def environment(self):
        path = Path(self.program).parent / 'python'
        clean = {name: value for name, value in os.environ.items() if not name.startswith(('PYTHON', 'LC_', 'LANG'))}
        self.temporary.mkdir(exist_ok=True)
        return {**clean, 'PYTHONPATH': str(path), 'PYTHONDONTWRITEBYTECODE': '1', 'KADR': self.program, 'LANG': 'C', 'TMPDIR': str(self.temporary)}

    @property
    def temporary(self):
        return self.folder / 'temporary'

    def archive(self, *words, expected=0):
        """Runs kadr-archive to its end, with one process unless the words say otherwise: a second one costs a start and proves nothing more."""
        if words[0] in ('check', 'run', 'convert') and not {'--workers', '--scheduler', '--scheduler-file'} & set(words):
            words += ('--workers', '1')
        done = subprocess.run([PYTHON, '-m', 'kadr_archive', *map(str, words)], cwd=self.folder, env=self.environment(), capture_output=True,
                              encoding='utf-8', errors='replace', timeout=600, stdin=subprocess.DEVNULL, check=False)
        expect(done.returncode == expected, f'{" ".join(map(str, words))}: exit status {done.returncode}, expected {expected}; {done.stdout[-800:]}{done.stderr[-1500:]}')
        return done

    def begin(self, *words):
        self.started.append(subprocess.Popen([PYTHON, '-m', 'kadr_archive', *map(str, words)], cwd=self.folder, env=self.environment(),
                                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL))
        return self.started[-1]

    def db(self, query, *values, file='a.sqlite'):
        db = sqlite3.connect(self.folder / file)
        try:
            return db.execute(query, values).fetchall()
        finally:
            db.close()

    def made_now(self, done):
        """Returns how many programs a run has worked on."""
        return int(re.search(r'worked on now: (\d+)', done.stdout)[1])

    def everything(self, file='a.sqlite'):
        """Returns all results with their findings, in an order that does not depend on who computed them first."""
        results = self.db('SELECT result, hex(content), asked, hex(memory), control, state, alarms, warnings, advices, reason, seconds, summary, output FROM results'
                          ' ORDER BY content, asked, memory', file=file)
        return [(*row[1:], tuple(self.db('SELECT * FROM findings WHERE result = ? ORDER BY number', row[0], file=file)[i][1:]
                                 for i in range(len(self.db('SELECT 1 FROM findings WHERE result = ?', row[0], file=file)))),
                 tuple(self.db('SELECT tool, cutting FROM tools WHERE result = ? ORDER BY tool', row[0], file=file))) for row in results]


def children_of(pid):
    """Returns the processes that a process has started."""
    found = []
    for task in Path(f'/proc/{pid}/task').glob('*/children'):
        try:
            found += [int(word) for word in task.read_text().split()]
        except OSError:
            pass
    return found


def some_programs(kadr, folder, count):
    """Writes programs of several kinds: correct ones, and ones with an error."""
    for i in range(count):
        kadr.file(f'{folder}/{i % 7}/p{i}.ngc', (WRONG if i % 3 == 0 else GOOD).format(i + 1))


def check_each_result_is_that_of_kadr(kadr):
    shutil.copytree(ROOT / 'examples', kadr.folder / 'a')
    kadr.archive('check', 'a', '--db', 'a.sqlite', expected=1)
    for path in list((kadr.folder / 'a').rglob('*.tbl')) + list((kadr.folder / 'a').rglob('*.toml')):
        others = [other for other in path.parent.glob(f'{path.stem}.*') if other.suffix not in ('.toml', '.tbl', '.json')]
        if path.name == 'tools.toml' or others:
            path.unlink()   # a tools file: kadr check reads it, kadr-archive does not
    rows = kadr.db("SELECT folder, name, control, state, result FROM present WHERE fault IS NULL AND state <> 'unknown'")
    expect(len(rows) > 60, f'{len(rows)} programs')
    of_file = {f'a/{folder}{name}': [] for folder, name, *_ in rows}
    controls = [word for folder, name, control, *_ in rows for word in ('--control-for', f'a/{folder}{name}={control}')]
    for finding in json.loads(kadr.call('check', *of_file, *controls, '--format', 'json', '-q', '--lang', 'en').stdout):
        of_file[finding['file']].append(finding)
    for folder, name, control, _, result in rows:
        file = f'a/{folder}{name}'
        ours = kadr.db('SELECT severity, id, line, "column", block, alarm, text, hint FROM findings WHERE result = ? ORDER BY number', result)
        if same_findings(ours, of_file[file], folder):
            continue
        # Of a file alone kadr check knows less: not that another one calls it.
        alone = json.loads(kadr.call('check', file, '--control', control, '--format', 'json', '-q', '--lang', 'en').stdout)
        expect(same_findings(ours, alone, folder), f'{file}: {ours} instead of {alone}')


def same_findings(ours, theirs, folder):
    """Returns whether findings of the archive are those of kadr check, whose texts may name the folder."""
    wanted = [(f['severity'], f['id'], f['line'], f['column'], f['block'] or '', str(f['number'] or ''), f['text'], f['hint']) for f in theirs]
    return [row[:4] for row in ours] == [row[:4] for row in wanted] and ([row[6:] for row in ours] == [row[6:] for row in wanted] or f'a/{folder}' in str(wanted))


def check_nothing_is_done_twice(kadr):
    some_programs(kadr, 'a', 30)
    kadr.file('a/copy.ngc', GOOD.format(2))   # the same content as p1.ngc
    first = kadr.archive('check', 'a', '--db', 'a.sqlite', expected=1)
    expect(kadr.made_now(first) == 30, first.stdout)
    expect(kadr.made_now(kadr.archive('check', 'a', '--db', 'a.sqlite', expected=1)) == 0, 'done twice')
    kadr.file('a/0/p0.ngc', GOOD.format(500))
    os.utime(kadr.folder / 'a/1/p1.ngc')        # touched, not changed
    before = (kadr.folder / 'a/3/p3.ngc').stat()
    (kadr.folder / 'a/3/p3.ngc').unlink()
    kadr.file('a/3/p3.ngc', WRONG.format(9))    # replaced by a file of the same size and time
    os.utime(kadr.folder / 'a/3/p3.ngc', ns=(before.st_atime_ns, before.st_mtime_ns))
    (kadr.folder / 'a/2/p2.ngc').rename(kadr.folder / 'a/moved.ngc')
    expect(kadr.made_now(kadr.archive('check', 'a', '--db', 'a.sqlite', expected=1)) == 2, 'not only the changed programs')
    expect(kadr.made_now(kadr.archive('check', 'a', '--db', 'a.sqlite', '--control', 'linuxcnc', expected=1)) == 30, 'another control is another result')
    expect(kadr.made_now(kadr.archive('check', 'a', '--db', 'a.sqlite', '--machine', 'mach3-router', expected=1)) == 30, 'another machine is another result')
    kadr.file('setup.json', '{"work_offsets": {"G54": {"X": 100}}}')
    expect(kadr.made_now(kadr.archive('check', 'a', '--db', 'a.sqlite', '--control', 'linuxcnc', '--setup', 'setup.json', expected=1)) == 30, 'another set-up')


def check_called_programs_decide(kadr):
    main = '%\nO1\nG21 G90\nG0 X0 Z5\nM98 P9010\nM30\n%\n'
    kadr.file('a/x/O1.nc', main)
    kadr.file('a/y/O1.nc', main)
    kadr.file('a/y/O9010.nc', '%\nO9010\nG1 X5 F100\nM99\n%\n')
    command = ('check', 'a', '--db', 'a.sqlite', '--control', 'fanuc')
    kadr.archive(*command, expected=1)
    states = "SELECT folder, state FROM present WHERE name = 'O1.nc' ORDER BY folder"
    expect(kadr.db(states) == [('x/', 'alarm'), ('y/', 'ok')], kadr.db(states))
    kadr.file('a/x/O9010.nc', '%\nO9010\nG1 X7 F100\nM99\n%\n')
    kadr.file('a/y/O9010.nc', '%\nO9010\nG1 X5 F100 G777\nM99\n%\n')
    kadr.archive(*command, expected=1)
    expect(kadr.db(states) == [('x/', 'ok'), ('y/', 'alarm')], kadr.db(states))


def check_exit_status(kadr):
    kadr.file('good/p.ngc', GOOD.format(1))
    three = (ROOT / 'examples/docs/three_findings.nc').read_text(encoding='utf-8').splitlines()
    kadr.file('warned/p.nc', '\n'.join([*three[:3], 'N5 M2 ПС']) + '\n')   # without the two errors
    kadr.file('text/readme.txt', 'Nothing but a text\nof two lines.\n')
    kadr.archive('check', 'good', '--db', 'a.sqlite', '--control', 'linuxcnc')
    kadr.archive('check', 'good', '--db', 'a.sqlite', '--control', 'linuxcnc', '--strict')
    counts = kadr.archive('check', 'warned', '--db', 'b.sqlite', '--control', 's2c42')
    expect('with warnings 1' in counts.stdout, counts.stdout)
    kadr.archive('check', 'warned', '--db', 'b.sqlite', '--control', 's2c42', '--strict', expected=1)
    kadr.archive('check', 'text', '--db', 'c.sqlite', expected=2)
    kadr.archive('check', 'missing', '--db', 'c.sqlite', expected=2)
    kadr.archive('check', 'good', '--db', 'c.sqlite', '--control', 'okuma', expected=2)
    kadr.file('d.sqlite', 'no database at all, but a text that is long enough to be read as one')
    kadr.archive('check', 'good', '--db', 'd.sqlite', expected=2)
    if os.getuid() != 0:
        kadr.file('good/q.ngc', GOOD.format(2)).chmod(0)
        kadr.archive('check', 'good', '--db', 'a.sqlite', '--control', 'linuxcnc', expected=2)


def check_zip_and_list(kadr):
    some_programs(kadr, 'a', 12)
    kadr.file('a/x/O1.nc', '%\nO1\nG21 G90\nG0 X0 Z5\nM98 P9010\nM30\n%\n')
    kadr.file('a/x/O9010.nc', '%\nO9010\nG1 X5 F100\nM99\n%\n')
    with zipfile.ZipFile(kadr.folder / 'a.zip', 'w', zipfile.ZIP_DEFLATED) as packed:
        for path in sorted((kadr.folder / 'a').rglob('*.n*')):
            packed.write(path, path.relative_to(kadr.folder / 'a'))
        packed.writestr('../outside.ngc', GOOD.format(9))
    kadr.file('list.txt', '# programs\n' + ''.join(f'a/{i % 7}/p{i}.ngc\n' for i in range(12)) + 'a/x/O1.nc\na/x/O9010.nc\n')
    for source, count in (('a', 14), ('a.zip', 14), ('list.txt', 14)):
        file = f'{source}.sqlite'
        kadr.archive('check', source, '--db', file, '--control-for', '*.nc=fanuc', '--control', 'linuxcnc', expected=1)
        rows = kadr.db('SELECT name, state, alarms FROM present ORDER BY name', file=file)
        expect(len(rows) == count and ('O1.nc', 'ok', 0) in rows, f'{source}: {rows}')
        expect(sum(state == 'alarm' for _, state, _ in rows) == 4, f'{source}: {rows}')


def check_damaged_zip_files(kadr):
    with zipfile.ZipFile(kadr.folder / 'a.zip', 'w', zipfile.ZIP_DEFLATED) as packed:
        for i in range(5):
            packed.writestr(f'p{i}.ngc', GOOD.format(i) * 20)
    content = bytearray((kadr.folder / 'a.zip').read_bytes())
    at = content.find(b'p2.ngc') + len('p2.ngc')
    content[at:at + 20] = bytes(20)
    kadr.file('member.zip', bytes(content))
    kadr.file('end.zip', bytes(content[:-200]) + b'PK\5\6' + bytes(18))
    kadr.archive('check', 'member.zip', '--db', 'a.sqlite', '--control', 'linuxcnc', expected=2)
    rows = kadr.db('SELECT name, state, fault IS NULL FROM present ORDER BY name')
    expect(rows == [(f'p{i}.ngc', None if i == 2 else 'ok', i != 2) for i in range(5)], rows)
    said = kadr.archive('check', 'end.zip', '--db', 'b.sqlite', '--control', 'linuxcnc', expected=2)
    expect('Traceback' not in said.stderr, said.stderr)


def check_two_clients_at_once(kadr):
    some_programs(kadr, 'a', 150)
    kadr.archive('check', 'a', '--db', 'whole.sqlite', expected=1)
    both = [kadr.begin('check', 'a', '--db', 'a.sqlite', '--workers', '1') for _ in range(2)]
    for process in both:
        expect(process.wait(300) == 1, f'exit status {process.returncode}: {process.stderr.read()[-800:]}')
    expect(kadr.everything('a.sqlite') == kadr.everything('whole.sqlite'), 'the results differ')
    expect(kadr.db('SELECT COUNT(*) FROM places WHERE until IS NULL') == [(150,)], 'places twice')


def check_hostile_programs(kadr):
    kadr.file('a/endless.nc', ENDLESS)
    kadr.file('a/good.nc', '%\nO2\nG21 G90\nG0 X5\nM30\n%\n')
    kadr.file('a/large.nc', '%\nO3\n' + 'G1 X1 F100\n' * 6_000_000 + 'M30\n%\n')
    kadr.file('a/binary.nc', bytes(range(256)) * 40)
    kadr.file('a/empty.nc', '')
    kadr.file('a/deep.nc', '%\nO4\n#1=' + '[' * 50000 + '1' + ']' * 50000 + '\nM30\n%\n')
    kadr.archive('check', 'a', '--db', 'a.sqlite', '--control', 'fanuc', '--most-seconds', '2', '--most-memory', '48', '--workers', '2', expected=1)
    states = dict(kadr.db('SELECT name, state FROM present'))
    expect(states['endless.nc'] == 'time', states)
    expect(states['good.nc'] == 'ok', states)
    expect(states['large.nc'] in ('memory', 'time'), states)
    expect(len(states) == 6 and all(states.values()), states)
    expect(kadr.made_now(kadr.archive('check', 'a', '--db', 'a.sqlite', '--control', 'fanuc', '--most-seconds', '2', expected=1)) == 0, 'limits are kept')
    done = kadr.archive('check', 'a', '--db', 'a.sqlite', '--control', 'fanuc', '--most-seconds', '1', '--most-memory', '48', '--again', expected=1)
    expect(kadr.made_now(done) >= 1, 'not tried again')


def check_hostile_programs_of_run(kadr):
    kadr.file('a/endless.nc', ENDLESS)
    kadr.file('a/good.nc', '%\nO2\nG21 G90\nG0 X5\nM30\n%\n')
    kadr.archive('run', 'a', '--db', 'a.sqlite', '--control', 'fanuc', '--most-seconds', '2', '--workers', '2', expected=1)
    states = dict(kadr.db('SELECT name, state FROM present'))
    expect(states == {'endless.nc': 'time', 'good.nc': 'ok'}, states)
    process = kadr.begin('run', 'a', '--db', 'b.sqlite', '--control', 'fanuc', '--most-seconds', '500', '--workers', '2')
    named = f'{kadr.folder}/a/endless.nc'.encode()

    def at_work():
        return [path for path in Path('/proc').glob('[0-9]*/cmdline') if named in read_bytes(path)]
    expect(until(at_work), 'kadr does not run')
    process.kill()
    process.wait()
    expect(until(lambda: not at_work(), 30), 'kadr lives on')


def read_bytes(path):
    try:
        return path.read_bytes()
    except OSError:
        return b''


def check_a_program_that_kills_twice_is_quarantined(kadr):
    kadr.file('a/endless.nc', ENDLESS)
    kadr.file('a/z.nc', '%\nO2\nG21 G90\nG0 X5\nM30\n%\n')
    process = kadr.begin('run', 'a', '--db', 'a.sqlite', '--control', 'fanuc', '--workers', '1', '--most-seconds', '500')
    killed = set()
    while len(killed) < 2 and process.poll() is None:
        for child in children_of(process.pid):
            if child not in killed:
                def busy(child=child):
                    try:
                        fields = Path(f'/proc/{child}/stat').read_text().rsplit(')', 1)[1].split()
                    except OSError:
                        return True
                    return int(fields[11]) / harness.TICKS > 0.6   # it has started, and works
                until(busy)
                try:
                    os.kill(child, signal.SIGKILL)
                except ProcessLookupError:
                    continue
                killed.add(child)
        time.sleep(0.05)
    expect(process.wait(120) == 1, f'exit status {process.returncode}')
    expect(b'endless.nc: quarantined' in process.stderr.read(), 'the program is not named')
    states = dict(kadr.db('SELECT name, state FROM present'))
    expect(states == {'endless.nc': 'killed', 'z.nc': 'ok'}, states)
    reason, = kadr.db("SELECT reason FROM present WHERE name = 'endless.nc'")[0]
    expect('quarantined' in reason, reason)
    expect(not any(kadr.temporary.iterdir()), f'killed processes leave {list(kadr.temporary.iterdir())}')


def check_kills_change_nothing(kadr):
    some_programs(kadr, 'a', 400)
    kadr.archive('check', 'a', '--db', 'whole.sqlite', expected=1)
    kills = int(os.environ.get('KADR_ARCHIVE_KILLS', '12'))
    chance = random.Random(55)
    killed = runs = 0
    while killed < kills:
        process = kadr.begin('check', 'a', '--db', 'a.sqlite', '--workers', '2')
        runs += 1
        client_dies = chance.random() < 0.5
        time.sleep(chance.uniform(0.05, 1.5))
        if client_dies and process.poll() is None:
            process.kill()
            killed += 1
        while not client_dies and process.poll() is None and killed < kills:
            victims = children_of(process.pid)
            if victims:
                try:
                    os.kill(chance.choice(victims), signal.SIGKILL)
                    killed += 1
                except ProcessLookupError:
                    pass
            time.sleep(chance.uniform(0.3, 0.9))
        process.wait(300)
        process.stdout.close()
        process.stderr.close()
        if client_dies or killed >= kills:
            continue
        for end in ('', '-wal', '-shm'):   # it was done: begin again
            (kadr.folder / f'a.sqlite{end}').unlink(missing_ok=True)
    kadr.archive('check', 'a', '--db', 'a.sqlite', '--again', expected=1)   # on a slow machine two kills may meet one program: quarantined
    expect(kadr.everything('a.sqlite') == kadr.everything('whole.sqlite'), f'after {killed} kills in {runs} runs the results differ')
    expect(kadr.db('PRAGMA integrity_check') == [('ok',)], 'the file is damaged')


# ---- Dask

class Cluster:
    """A scheduler and workers of Dask on loopback."""

    def __init__(self, kadr, workers):
        self.kadr, self.file, self.workers = kadr, kadr.folder / 'scheduler.json', []
        self.scheduler = self.begin('dask_scheduler', '--host', '127.0.0.1', '--port', '0', '--no-dashboard', '--scheduler-file', self.file)
        expect(until(self.file.is_file), 'the scheduler does not start')
        for _ in range(workers):
            self.add()

    def begin(self, module, *words):
        """Starts a process, whose messages are in NUMBER.log."""
        with open(self.log(len(self.kadr.started)), 'wb') as log:
            more = {'cwd': self.kadr.folder, 'env': self.kadr.environment(), 'stdin': subprocess.DEVNULL, 'stdout': subprocess.DEVNULL, 'stderr': log}
            self.kadr.started.append(subprocess.Popen([PYTHON, '-m', f'distributed.cli.{module}', *map(str, words)], **more))
        return self.kadr.started[-1]

    def log(self, number):
        return self.kadr.folder / f'{number}.log'

    def all_serve(self):
        """Returns whether every worker has found the scheduler."""
        return all(b'Registered to' in self.log(self.kadr.started.index(worker)).read_bytes() for worker in self.workers)

    def add(self):
        self.workers.append(self.begin('dask_worker', '--scheduler-file', self.file, '--nthreads', '1', '--no-nanny', '--no-dashboard', '--local-directory',
                                       self.kadr.folder / 'dask'))


@functools.cache
def has(module):
    """Returns whether the interpreter has a module."""
    return subprocess.run([PYTHON, '-c', f'import importlib.util as u, sys; sys.exit(not u.find_spec("{module}"))'], check=False).returncode == 0


def has_dask():
    if has('distributed'):
        return True
    harness.skipped('kadr-archive on a cluster: python3-distributed is missing')
    return False


def check_a_cluster(kadr):
    if not has_dask():
        return
    some_programs(kadr, 'a', 200)
    kadr.file('a/x/O1.nc', '%\nO1\nG21 G90\nG0 X0 Z5\nM98 P9010\nM30\n%\n')
    kadr.file('a/x/O9010.nc', '%\nO9010\nG1 X5 F100 G777\nM99\n%\n')
    command = ('check', 'a', '--control', 'linuxcnc', '--control-for', '*.nc=fanuc')
    kadr.archive(*command, '--db', 'local.sqlite', expected=1)
    cluster = Cluster(kadr, 2)
    kadr.archive(*command, '--db', 'seen.sqlite', '--scheduler-file', cluster.file, expected=1)
    kadr.archive(*command, '--db', 'content.sqlite', '--scheduler', json.loads(cluster.file.read_text())['address'], '--by-content', expected=1)
    local = kadr.everything('local.sqlite')
    expect(kadr.everything('seen.sqlite') == local, 'another result on a cluster')
    expect(kadr.everything('content.sqlite') == local, 'another result by content')
    expect(kadr.made_now(kadr.archive(*command, '--db', 'seen.sqlite', '--scheduler-file', cluster.file, expected=1)) == 0, 'done twice')
    whole_and_by_windows(kadr, 'plate', 3, '--scheduler-file', cluster.file)
    whole_and_by_windows(kadr, 'plate', 2, '--scheduler-file', cluster.file, '--by-content')
    workers_die(kadr, cluster)


def workers_die(kadr, cluster):
    """Kills workers of the cluster while they work: no result is lost, doubled or changed."""
    most = int(os.environ.get('KADR_ARCHIVE_KILLS', '4')) // 2
    some_programs(kadr, 'b', max(500, min(20 * most, 4000)))
    kadr.archive('check', 'b', '--db', 'whole.sqlite', expected=1)
    chance = random.Random(7)
    kills = run = 0
    while kills < most:
        run += 1
        expect(run <= 10 * most, 'the runs end before a worker can be killed')
        db = f'b{run}.sqlite'
        process = kadr.begin('check', 'b', '--db', db, '--scheduler-file', cluster.file)
        while process.poll() is None and kills < most:
            time.sleep(chance.uniform(0.3, 1.0))
            if not (kadr.folder / db).is_file() or process.poll() is not None:
                continue
            cluster.workers.pop(0).kill()
            kills += 1
            cluster.add()
            expect(until(cluster.all_serve), 'a new worker does not start')   # else more are killed than start on a busy machine
        expect(process.wait(400) == 1, f'exit status {process.returncode} {process.stderr.read()[-800:]}')
        kadr.archive('check', 'b', '--db', db, '--again', expected=1)   # as above
        expect(kadr.everything(db) == kadr.everything('whole.sqlite'), f'after {kills} killed workers, run {run}, the results differ')
    if 'KADR_ARCHIVE_KILLS' in os.environ:
        print(f'archive: {kills} workers of a cluster killed in {run} runs')


# ---- a cut by windows

CUT = ROOT / 'examples/cut'
PLATE = (CUT / 'plate.nc', '--control', 'mach3', '--stock', 'box:-40,-30,-20,40,30,0', '--tools', CUT / 'tools.toml')
CUTS = {   # name: (words of kadr cut, counts of windows)
    'plate': ((*PLATE, '--resolution', '0.5', '--coolant', '--fixture', 'box:-60,-40,-40,-41,40,0'), (2, 3, 4)),   # ball, arcs, drills
    'crash': ((CUT / 'crash.nc', *PLATE[1:], '--resolution', '0.6', '--part', CUT / 'step.stl'), (2, 4)),   # findings, a wanted part
    'waves': ((CUT / 'waves.ngc', '--control', 'linuxcnc', '--stock', 'box:0,0,-20,60,40,0', '--tools', CUT / 'tools.toml', '--resolution', '0.7'), (3,)),
    'trunnion': ((CUT / 'trunnion.nc', '--control', 'mach3', '--machine', CUT / 'trunnion.toml', '--setup', CUT / 'trunnion.json',   # 5 axes
                  '--stock', 'box:-20,-20,-20,20,20,0', '--tools', CUT / 'tools.toml', '--resolution', '0.4'), (2, 4)),
    'ball': ((ROOT / 'examples/five-axes/sphere.nct', '--control', 'nct', '--machine', 'table-table', '--setup', ROOT / 'examples/five-axes/sphere.json',
              '--stock', 'cylinder:0,0,-40,31,62', '--tools', 'ball.toml', '--resolution', '1.2'), (4,)),
}
BALL = '[[tool]]\nnumber = 2\nkind = "ball"\ndiameter = 10\nflute_length = 40\nlength = 95\n'


def whole_and_by_windows(kadr, name, count, *options):
    """Cuts a program in one process and by windows, and compares mesh, JSON and table of blocks byte by byte."""
    kadr.file('ball.toml', BALL)
    words, _ = CUTS[name]
    results = ('--out', 'part.stl', '--json', 'part.json', '--blocks', 'blocks.csv')
    where = {kind: kadr.folder / f'{name}-{kind}' for kind in ('whole', 'windows')}
    for folder in where.values():
        folder.mkdir(exist_ok=True)
    put = {kind: [str(folder / word) if not word.startswith('-') else word for word in results] for kind, folder in where.items()}
    whole = kadr.call('cut', *words, *put['whole'], '--lang', 'en', '-q', env=kadr.environment())
    expect(whole.returncode in (0, 1), f'{name}: {whole.stderr}')
    joined = kadr.archive('cut', *words, *put['windows'], '--windows', count, '--lang', 'en', '-q', *options, expected=whole.returncode)
    expect(joined.stderr == whole.stderr, f'{name}: other messages: {set(joined.stderr.splitlines()) ^ set(whole.stderr.splitlines())}')
    for file in results[1::2]:
        one, other = ((folder / file).read_bytes() for folder in where.values())
        expect(len(one) > 100 and one == other, f'{name}: {file} by {count} windows differs from that of one process')
    expect(not list(kadr.folder.rglob('.kadr-cut-*')), 'files of the windows remain')


def check_a_cut_by_windows_is_the_same(kadr):
    for name, (_, counts) in CUTS.items():
        for count in counts:
            whole_and_by_windows(kadr, name, count, '--workers', '2')


def check_a_cut_that_is_refused(kadr):
    words = ('cut', *PLATE, '--resolution', '0.5')
    for more, said in ((('--window', '-10,-10,-10,10,10,0'), '--portion: not together with --window'), (('--plot', 'a.png'), 'not together with --plot'),
                       (('--out', 'a.3mf'), '.stl'), (('--windows', '0'), 'above 0'), (('--part', 'missing.stl'), 'missing.stl')):
        done = kadr.archive(*words, *more, expected=2)
        expect(said in done.stderr and 'Traceback' not in done.stderr, f'{more}: {done.stderr}')
    expect('--resolution' in kadr.archive('cut', *PLATE, expected=2).stderr, 'without --resolution')
    expect('--max-memory' in kadr.archive('cut', *PLATE, '--resolution', '0.05', '--max-memory', '16', expected=2).stderr, 'too little memory')
    kadr.run('cut', *PLATE, '--resolution', '0.5', '--portion', '1/2', '--out', '1.portion')
    kadr.run('cut', *PLATE, '--resolution', '0.5', '--portion', '2/2', '--out', '2.portion')
    kadr.run('cut', CUT / 'crash.nc', *PLATE[1:], '--resolution', '0.5', '--portion', '2/2', '--out', 'other.portion')
    kadr.file('short.portion', (kadr.folder / '2.portion').read_bytes()[:-1000])
    for files in (('1.portion',), ('1.portion', '1.portion'), ('1.portion', 'other.portion'), ('1.portion', 'short.portion'), ('1.portion', CUT / 'step.stl')):
        kadr.run('cut', *PLATE, '--resolution', '0.5', '--out', 'no.stl', '--join', *files, expected=2)
    expect(not (kadr.folder / 'no.stl').exists(), 'a wrong part was written')
    kadr.run('cut', *PLATE, '--resolution', '0.5', '--out', 'yes.stl', '--join', '2.portion', '1.portion')


def check_a_killed_window_is_cut_again(kadr):
    kadr.call('cut', *PLATE, '--resolution', '0.2', '--out', 'whole.stl')
    process = kadr.begin('cut', *PLATE, '--resolution', '0.2', '--out', 'part.stl', '--windows', '2', '--workers', '2')
    expect(until(lambda: children_of(process.pid) or process.poll() is not None), 'no process')
    for child in children_of(process.pid)[:1]:
        with contextlib.suppress(ProcessLookupError):   # on a fast machine it may have ended
            os.kill(child, signal.SIGKILL)
    expect(process.wait(200) == 0, process.stderr.read())
    expect((kadr.folder / 'part.stl').read_bytes() == (kadr.folder / 'whole.stl').read_bytes(), 'another part')
    process = kadr.begin('cut', *PLATE, '--resolution', '0.1', '--out', 'late.stl', '--windows', '2', '--workers', '2')
    expect(until(lambda: children_of(process.pid)), 'no process')
    process.send_signal(signal.SIGINT)
    expect(process.wait(100) == 130 and b'interrupted' in process.stderr.read(), 'no interruption')
    expect(not list(kadr.folder.glob('.kadr-cut-*')) and not (kadr.folder / 'late.stl').exists(), 'files remain')


def check_no_scheduler(kadr):
    if not has_dask():
        return
    kadr.file('a/p.ngc', GOOD.format(1))
    said = kadr.archive('check', 'a', '--db', 'a.sqlite', '--scheduler-file', 'missing.json', expected=2)
    expect('missing.json: no such file' in said.stderr, said.stderr)


def check_children_end_with_the_client(kadr):
    kadr.file('a/endless.nc', ENDLESS)
    process = kadr.begin('check', 'a', '--db', 'a.sqlite', '--control', 'fanuc', '--workers', '2', '--most-seconds', '500')
    expect(until(lambda: children_of(process.pid)), 'no child')
    children = children_of(process.pid)
    process.kill()
    process.wait()
    expect(until(lambda: not any(Path(f'/proc/{child}/stat').exists() and ') Z' not in Path(f'/proc/{child}/stat').read_text() for child in children), 30),
           'a child lives on')


def check_interrupt(kadr):
    kadr.file('a/endless.nc', ENDLESS)
    kadr.file('a/b.nc', '%\nO2\nG21 G90\nG0 X5\nM30\n%\n')
    process = kadr.begin('check', 'a', '--db', 'a.sqlite', '--control', 'fanuc', '--workers', '2', '--most-seconds', '500')
    expect(until(lambda: children_of(process.pid)), 'no child')
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    expect(process.wait(60) == 130, f'exit status {process.returncode}')
    expect(b'interrupted' in process.stderr.read(), 'it says nothing')


def check_run(kadr):
    shutil.copytree(ROOT / 'examples/haas', kadr.folder / 'a')
    kadr.archive('run', 'a', '--db', 'a.sqlite', '--control', 'haas')
    for name, seconds, summary in kadr.db("SELECT p.name, r.seconds, r.summary FROM present p JOIN results r USING (result)"):
        theirs = json.loads(kadr.call('run', f'a/{name}', '--control', 'haas', '--json').stdout)
        ours = json.loads(summary)
        expect(ours['program'] == name and {**ours, 'program': ''} == {**theirs, 'program': ''} and seconds == theirs['machining_time'], f'{name}: {ours}')
    rows = list(csv.DictReader(io.StringIO(kadr.archive('csv', 'extents', '--db', 'a.sqlite').stdout)))
    theirs = json.loads(kadr.call('run', 'a/face.nc', '--control', 'haas', '--json').stdout)['channels'][0]['cutting'][0]['axes']['X']
    ours = [[float(row['from']), float(row['to'])] for row in rows if (row['program'], row['of'], row['axis']) == ('face.nc', 'cutting', 'X')]
    expect(ours == [theirs], f'{ours} instead of {theirs}')
    tools = kadr.db('SELECT DISTINCT tool FROM tools')
    expect(tools, 'no tools')


def check_difference(kadr):
    some_programs(kadr, 'a', 9)
    kadr.archive('check', 'a', '--db', 'a.sqlite', '--control', 'linuxcnc', expected=1)
    kadr.archive('diff', '--db', 'a.sqlite', expected=2)   # one run only
    kadr.archive('check', 'a', '--db', 'a.sqlite', '--control', 'linuxcnc', expected=1)
    expect('programs that differ: 0' in kadr.archive('diff', '--db', 'a.sqlite').stdout, 'the same archive differs')
    kadr.file('a/1/p1.ngc', WRONG.format(77))
    kadr.file('a/new.ngc', GOOD.format(78))
    (kadr.folder / 'a/2/p2.ngc').unlink()
    kadr.archive('check', 'a', '--db', 'a.sqlite', '--control', 'linuxcnc', expected=1)
    said = kadr.archive('diff', '--db', 'a.sqlite', expected=1).stdout
    for line in ('1/p1.ngc: text differs; without errors → with errors; + 4: ', 'new.ngc: new', '2/p2.ngc: missing now', 'programs that differ: 3'):
        expect(line in said, f'{line}: {said}')
    expect('programs that differ: 0' in kadr.archive('diff', '--db', 'a.sqlite', '--from', '1', '--to', '2').stdout, 'earlier states are not kept')


def check_convert(kadr):
    shutil.copytree(ROOT / 'examples/haas', kadr.folder / 'a')
    kadr.archive('convert', 'a', '--db', 'a.sqlite', '--control', 'haas', '--to', 'fanuc', '--out', 'out', expected=(1))
    states = dict(kadr.db('SELECT name, state FROM present'))
    for name, state in states.items():
        theirs = kadr.call('convert', f'a/{name}', '--from', 'haas', '--to', 'fanuc', binary=True)
        made = kadr.folder / 'out' / name
        expect((state == 'ok') == (theirs.returncode == 0) == made.is_file(), f'{name}: {state}, {theirs.returncode}')
        expect(theirs.returncode != 0 or made.read_bytes() == theirs.stdout, f'{name}: another text')
    shutil.rmtree(kadr.folder / 'out')
    done = kadr.archive('convert', 'a', '--db', 'a.sqlite', '--control', 'haas', '--to', 'fanuc', '--out', 'out', expected=1)
    expect(kadr.made_now(done) == 0 and list((kadr.folder / 'out').iterdir()), 'written again without conversion')
    kadr.archive('convert', 'a', '--db', 'b.sqlite', '--control', 'haas', '--to', 'fanuc', '--out', 'a', expected=2)


def check_csv(kadr):
    kadr.file('a/<b>"quoted", name.ngc', WRONG.format(1))
    kadr.archive('check', 'a', '--db', 'a.sqlite', '--control', 'linuxcnc', expected=1)
    rows = list(csv.DictReader(io.StringIO(kadr.archive('csv', 'programs', '--db', 'a.sqlite').stdout)))
    expect(len(rows) == 1 and rows[0]['program'] == '<b>"quoted", name.ngc' and rows[0]['state'] == 'alarm', rows)
    kadr.archive('csv', 'findings', '--db', 'a.sqlite', '--out', 'f.csv')
    rows = list(csv.DictReader(io.StringIO((kadr.folder / 'f.csv').read_text(encoding='utf-8'))))
    expect(any(row['severity'] == 'alarm' and row['line'] == '4' for row in rows), rows)


def check_report(kadr):
    if not has('jinja2'):
        harness.skipped('the report of kadr-archive: python3-jinja2 is missing')
        return
    some_programs(kadr, 'a', 9)
    kadr.file('a/<script>alert(1)<&.ngc', WRONG.format('5 (<script>alert(1)</script>)'))
    kadr.archive('check', 'a', '--db', 'a.sqlite', '--control', 'linuxcnc', expected=1)
    kadr.archive('run', 'a', '--db', 'a.sqlite', '--control', 'linuxcnc', expected=1)
    for language in ('en', 'ru'):
        out = kadr.folder / language
        kadr.archive('report', '--run', '1', '--db', 'a.sqlite', '--out', out, '--lang', language)
        pages = list(out.glob('*.html'))
        links = 0
        for page in pages:
            text = page.read_text(encoding='utf-8')
            expect('<script' not in text and 'data:' not in text and 'http' not in re.sub(r'http-equiv', '', text), f'{page.name}: markup of a program')
            for link in re.findall(r'href="([^"]*)"', text):
                links += 1
                expect((page.parent / link).is_file(), f'{page.name}: {link} leads nowhere')
        expect(links > 20 and len(list((out / 'programs').glob('*.html'))) == 10, f'{links} links')
    index = (kadr.folder / 'en/index.html').read_text(encoding='utf-8')
    for words in ('linuxcnc', 'generic', 'By tool', '<td class="number">4</td>'):
        expect(words in index, f'{words}: not in the report')
    before = {page: page.stat().st_mtime_ns for page in (kadr.folder / 'en/programs').iterdir()}
    expect('made now: 0' in kadr.archive('report', '--run', '1', '--db', 'a.sqlite', '--out', kadr.folder / 'en').stdout, 'pages made twice')
    expect(before == {page: page.stat().st_mtime_ns for page in (kadr.folder / 'en/programs').iterdir()}, 'pages written twice')


def check_names_that_are_no_text(kadr):
    (kadr.folder / 'a').mkdir()
    with open(os.fsencode(kadr.folder) + b'/a/\xd4\xf0\xe5\xe7\xe0.ngc', 'wb') as to:
        to.write(GOOD.format(3).encode())
    kadr.archive('check', 'a', '--db', 'a.sqlite', '--control', 'linuxcnc')
    kadr.archive('run', 'a', '--db', 'a.sqlite', '--control', 'linuxcnc')


def check_the_bar(kadr):
    if not has('tqdm'):
        harness.skipped('the progress bar of kadr-archive: python3-tqdm is missing')
        return
    some_programs(kadr, 'a', 20)
    ours, theirs = pty.openpty()
    process = subprocess.Popen([PYTHON, '-m', 'kadr_archive', 'check', 'a', '--db', 'a.sqlite'], cwd=kadr.folder, env=kadr.environment(), stderr=theirs,
                               stdout=subprocess.PIPE, stdin=subprocess.DEVNULL)
    os.close(theirs)
    seen = b''
    try:
        while part := os.read(ours, 65536):
            seen += part
    except OSError:   # the other end is closed
        pass
    os.close(ours)
    expect(process.wait(60) == 1 and b'checking' in seen and b'/20 ' in seen, seen)
    process.stdout.close()


def check_a_worker_of_another_build_is_refused(kadr):
    program = """
from kadr_archive import children, places, work
item = work.Item(places.digest(b'M2\\n'), 'linuxcnc', b'', 'p.ngc', None, b'M2\\n', {}, True)
for build in (work.build(), 'another'):
    one = children.Child(work.Job('check', build=build))
    try:
        print(one.does(item)['state'])
    except children.WrongBuild as error:
        print(error)
    one.end()
"""
    done = subprocess.run([PYTHON, '-c', program], cwd=kadr.folder, env=kadr.environment(), capture_output=True, encoding='utf-8', timeout=200, check=False)
    expect(re.fullmatch(r'ok\na worker has Kadr \S+, this computer has another\n', done.stdout), f'{done.stdout} {done.stderr}')


def check_russian(kadr):
    some_programs(kadr, 'a', 3)
    said = kadr.archive('check', 'a', '--db', 'a.sqlite', '--control', 'linuxcnc', '--lang', 'ru', expected=1).stdout
    expect(said == 'программ: 3, обработано сейчас: 3; без ошибок 2, с ошибками 1\n', said)


if __name__ == '__main__':
    sys.exit(harness.main(__doc__, globals(), Archive))
