"""Runs a command once and checks what must hold for every command. Used by tests/every_command.py."""
import json
import os
import re
import resource
import signal
import subprocess

import harness

CPU_S = 60                  # s of processor time, the most that one run may use
SLOWER = 10                 # factor by which a program with a sanitizer is slower
MEMORY = 2 << 30            # bytes of address space
STATUSES = (0, 1, 2)
CONTROL_CHARACTER = re.compile(rb'[\x00-\x08\x0b-\x1f]')


class Kadr(harness.Kadr):
    language = 'en'
    sanitized = False

    def limits(self, more=()):
        """Returns limit → value for every run; `more` are further pairs."""
        those = {resource.RLIMIT_CPU: CPU_S * (SLOWER if self.sanitized else 1), resource.RLIMIT_CORE: 0}
        if not self.sanitized:   # the shadow memory of a sanitizer has no limit
            those[resource.RLIMIT_AS] = MEMORY
        return {**those, **dict(more)}

    def bounded(self, limits=(), before=lambda: None):
        """Returns what a child process does before it becomes the program."""
        def set_them():
            before()
            for what, most in self.limits(limits).items():
                resource.setrlimit(what, bounds(what, most))
        return set_them

    def observed(self, words, asked=(), limits=(), before=None, folder=None, said=True, **more):
        """Runs a command in the folder; `asked` are the files that it must write.  returns its result, and the faults"""
        folder = folder or self.folder
        listed = listing(folder)
        if limits or before:
            more['preexec_fn'] = self.bounded(limits, before or (lambda: None))
        done = self.carried_out(words, more.pop('input', b''), {'cwd': folder, **more})
        if done.returncode == 127 and b'error while loading shared libraries' in done.stderr:
            return done, []   # it did not start
        return done, [*ends_wrongly(done, said, asked), *prints_wrongly(words, done), *writes_wrongly(folder, listed, asked, done.returncode)]

    def carried_out(self, words, given, more):
        streams = {'stdin': subprocess.PIPE, **more} if given else more
        with subprocess.Popen(self.command(words), **self.streams(streams, binary=True)) as process:
            if 'preexec_fn' not in more:   # the usual limits are set after the start: that takes half the time
                self.limit(process)
            try:
                out, err = process.communicate(given or None, timeout=harness.TIME_LIMIT_S)
            except subprocess.TimeoutExpired:
                process.kill()
                raise harness.Failure(f'{" ".join(map(str, words))}: no end within {harness.TIME_LIMIT_S} s') from None
        return subprocess.CompletedProcess(words, process.returncode, out or b'', err or b'')

    def limit(self, process):
        try:
            for what, most in self.limits().items():
                resource.prlimit(process.pid, what, bounds(what, most))
        except ProcessLookupError:   # the process has ended already
            pass


def bounds(what, most):
    """Returns the soft and the hard limit: reaching the hard limit of time would be SIGKILL."""
    return most, most + (what == resource.RLIMIT_CPU)


def text(data):
    """Returns the last bytes as one readable line."""
    return ' / '.join(data.decode('utf-8', 'backslashreplace').split('\n')).strip(' /')[-200:]


def listing(folder):
    """Returns name below the folder → size and time of the last change."""
    found = {}
    for place, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(place, name)
            state = os.lstat(path)
            found[os.path.relpath(path, folder)] = state.st_size, state.st_mtime_ns
    return found


def ends_wrongly(done, said=True, asked=()):
    if done.returncode < 0:
        yield f'ended by {signal.Signals(-done.returncode).name}: {text(done.stderr)}'
    elif done.returncode not in STATUSES:
        yield f'exit status {done.returncode}: {text(done.stderr)}'
    elif said and done.returncode and not done.stderr.strip() and (done.returncode == 2 or not (done.stdout.strip() or asked)):   # findings may be elsewhere
        yield f'exit status {done.returncode} without a word'
    if b'Sanitizer' in done.stderr or b'runtime error: ' in done.stderr:
        yield f'Sanitizer: {text(done.stderr)}'


def prints_wrongly(words, done):
    data_on_stdout = words[:2] == ['tape', 'decode']   # decoded text may contain any byte
    for name, printed in (('standard output', b'' if data_on_stdout else done.stdout), ('standard error', done.stderr)):
        if found := CONTROL_CHARACTER.search(printed):
            yield f'control character {found[0]!r} on {name}: {printed[max(0, found.start() - 40):found.end() + 40]!r}'


def writes_wrongly(folder, before, asked, status):
    """Lists files that were not requested, or that are incomplete."""
    after = listing(folder)
    left = sorted(name for name in after if after[name] != before.get(name) and name not in asked and not name.startswith('written/'))
    if left:
        yield f'left over: {left}'
    if gone := sorted(before.keys() - after.keys()):
        yield f'gone: {gone}'
    for name in asked:
        if name in after and after[name] != before.get(name):
            if fault := not_whole(folder / name):
                yield f'left over: {name} is not whole: {fault}'
        elif status == 0:
            yield f'{name} is not written'


def not_json(data):
    try:
        json.loads(data)
    except ValueError as error:
        return f'no JSON: {error}'
    return ''


def not_whole(path):
    """Returns why a written file is incomplete; empty if it is complete."""
    data = path.read_bytes()
    if not data and path.suffix not in ('.jsonl', '.txt'):   # a program without blocks gives an empty file
        return 'it is empty'
    if path.suffix == '.json':
        return not_json(data)
    if path.suffix == '.jsonl':
        return next((f'line {number}: {fault}' for number, line in enumerate(data.splitlines(), 1) if (fault := not_json(line))), '')
    if path.suffix in ('.html', '.svg') and not data.rstrip().endswith(b'</%b>' % path.suffix[1:].encode()):
        return f'it ends with {data[-20:]!r}'
    if path.suffix == '.csv' and not data.endswith(b'\n'):
        return 'its last line is cut off'
    return ''
