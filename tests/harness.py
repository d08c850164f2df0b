"""The common parts of the test runners in this folder: their command line, the program under test in a folder of its own, and the counting
of checks.

A runner whose checks are functions looks like this; each check gets a fresh folder, and fails if `expect` fails or any exception is raised:

    import harness
    from harness import expect

    def check_the_end(kadr):
        kadr.file('p.nc', 'M30\\n')
        expect('blocks' in kadr.run('run', 'p.nc').stdout, 'the summary is missing')

    if __name__ == '__main__':
        sys.exit(harness.main(__doc__, globals()))

A runner that counts each expectation has a Tally, and ends with `return tally.result()`. Both print a line per failure, then
`N passed, N failed`. Exit status: 0 all passed or skipped, 1 some failed, 2 wrong usage.

No check depends on how busy the machine is. A time limit only ends a hanging program, so it is generous
(TIME_LIMIT_S). A check that waits names the condition (`until`, `at_work`), and measures how soon a program ends by its processor time
(`spent_after`).
"""
import argparse
import concurrent.futures
import fnmatch
import os
import re
import subprocess
import tempfile
import threading
import time
import traceback
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CONTROLS = tuple(sorted(path.stem for path in (ROOT / 'controls').glob('*.toml') if f'\nid = "{path.stem}"\n' in path.read_text(encoding='utf-8')))   # built in
TIME_LIMIT_S = 120   # for one run of the program; it only ends a hanging one
CORES = len(os.sched_getaffinity(0))
TICKS = os.sysconf('SC_CLK_TCK')   # of processor time, per second


class Failure(Exception):
    """The reason why a check failed."""


def expect(holds, why):
    """Fails the check unless the condition holds."""
    if not holds:
        raise Failure(why)


def printed_commands(page):
    """Returns the complete commands that a page of docs/ prints, in their order, as words without `kadr`. Commands with a place to fill in
    are left out, except the port, which is `PORT` in both languages."""
    all_of_page = re.findall(r'(?m)(?:^    (?:\$ )?|`)kadr ([^`\n]+)', (ROOT / 'docs' / page).read_text(encoding='utf-8'))
    words = [command.replace('ПОРТ', 'PORT').split() for command in all_of_page]
    return [w for w in words if len(w) > 1 and not any('…' in word or (word.isupper() and word.isalpha() and word != 'PORT') or word.endswith('...') for word in w)]


# ---- counting

class Tally:
    """Counts passed and failed checks, and prints a line for each fault. Threads may share one."""

    def __init__(self):
        self.passed, self.failed, self.skipped = 0, 0, 0
        self.lock = threading.Lock()

    def judge(self, what, faults):
        """Counts one check; each of its faults is printed."""
        faults = list(faults)
        with self.lock:
            for fault in faults:
                print(f'FAILED {what}: {fault}', flush=True)
            self.passed, self.failed = self.passed + (not faults), self.failed + bool(faults)

    def expect(self, holds, what, *more):
        """Counts one check, named by what must be true; `more` is printed with a failure."""
        with self.lock:
            self.passed, self.failed = self.passed + bool(holds), self.failed + (not holds)
            if not holds:
                print('FAILED ' + ': '.join(map(str, [what, *more])), flush=True)

    def same(self, what, got, wanted):
        """Counts one comparison."""
        self.judge(what, [] if got == wanted else [f'\n  got    {got!r}\n  wanted {wanted!r}'[:2000]])

    def skip(self, reason):
        """Reports that something is not checked here; a run in which everything is skipped has not failed."""
        self.skipped += 1
        skipped(reason)

    def result(self):
        """Prints the totals.  returns the exit status"""
        print(f'{self.passed} passed, {self.failed} failed', flush=True)
        return 1 if self.failed or not (self.passed or self.skipped) else 0


def skipped(reason):
    """Reports that something is not checked here, because a tool or a part of the build is missing. dev/test collects these lines."""
    print(f'skipped: {reason}', flush=True)


# ---- the program under test

class Kadr:
    """The program under test in a folder of its own. A subclass may set `language`: it is passed in every run that names none."""

    language = None

    def __init__(self, program, folder):
        self.program, self.folder, self.started = str(program), Path(folder), []

    def file(self, name, content=''):
        """Writes a file, and the folders above it; text is written as UTF-8.  returns its path"""
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode('utf-8'))
        return path

    def command(self, words):
        """Returns the words of a command line."""
        words = [word if isinstance(word, bytes) else str(word) for word in words]
        return [self.program, *words, *(['--lang', self.language] if self.language and '--lang' not in words else [])]

    def streams(self, more, binary=False):
        """Returns how a process is started: in the folder, without standard input, both outputs captured; `more` overrides this."""
        nothing = {} if 'input' in more else {'stdin': subprocess.DEVNULL}
        form = {} if binary else {'encoding': 'utf-8', 'errors': 'replace'}
        return {'cwd': self.folder, 'stdout': subprocess.PIPE, 'stderr': subprocess.PIPE, **nothing, **form, **more}

    def call(self, *words, binary=False, **more):
        """Runs the program to its end.  returns its status and its output, as text or as bytes"""
        try:
            return subprocess.run(self.command(words), timeout=TIME_LIMIT_S, check=False, **self.streams(more, binary))
        except subprocess.TimeoutExpired:
            raise Failure(f'{" ".join(map(str, words))}: no end within {TIME_LIMIT_S} s') from None

    def run(self, *words, expected=0, **more):
        """Runs the program like call(); the check fails if the exit status is not the expected one, or one of several."""
        done = self.call(*words, **more)
        wanted = expected if isinstance(expected, tuple) else (expected,)
        said = f'{done.stdout or ""} {done.stderr or ""}'
        expect(done.returncode in wanted, f'{" ".join(map(str, words))}: exit status {done.returncode}, expected {expected}; {said[:800]}')
        return done

    def printed(self, *words):
        """Returns the program's standard output in English."""
        done = self.call(*words, env={**os.environ, 'LANG': 'C'})
        expect(done.returncode == 0, f'{" ".join(map(str, words))}: exit status {done.returncode}; {done.stderr[:300]}')
        return done.stdout

    def start(self, *words, **more):
        """Starts the program without waiting; it is killed if it still runs after the check."""
        self.started.append(subprocess.Popen(self.command(words), **self.streams(more, binary=True)))
        return self.started[-1]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for process in self.started:
            with process:   # closes its pipes
                if process.poll() is None:
                    process.kill()

    def left_over(self):
        """Returns Kadr's temporary files that should have been removed."""
        return [str(path) for path in self.folder.rglob('.kadr-*')]


# ---- time

def until(condition, seconds=TIME_LIMIT_S):
    """Waits for a condition.  returns whether it became true"""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            return bool(condition())
        time.sleep(0.01)
    return True


def ended(process):
    """True if a process has ended; its status has still to be collected."""
    return os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is not None


def times_of(process):
    """Returns the fields of /proc/PID/stat after the name; they exist until the process's status is collected."""
    return Path(f'/proc/{process.pid}/stat').read_text(encoding='ascii', errors='replace').rsplit(')', 1)[1].split()


def spent(process):
    """Processor time of a process with all its threads, s."""
    return sum(map(int, times_of(process)[11:13])) / TICKS


def spent_by_children():
    """Processor time of all processes whose status this one has collected, s."""
    times = os.times()
    return times.children_user + times.children_system


def at_work(process, seconds=0.3):
    """Waits until a process has spent that much processor time, or has ended.  returns whether it still works"""
    until(lambda: ended(process) or spent(process) >= seconds)
    return not ended(process)


def stands(process, seconds=1.0):
    """Waits until a process spends no processor time for that long: it waits for something.  returns whether it does"""
    end, before, since = time.monotonic() + TIME_LIMIT_S, None, time.monotonic()
    while time.monotonic() < end:
        now = times_of(process)[0], spent(process)
        if now[0] == 'Z':   # it has ended
            return False
        if now != before or now[0] != 'S':
            before, since = now, time.monotonic()
        elif time.monotonic() - since >= seconds:
            return True
        time.sleep(0.05)
    return False


def spent_after(process, sign):
    """Sends a signal and waits for the end; a process that does not end within the limit is killed, and the check fails.
    returns the processor time that the process has spent since the signal, s; its status is then in `returncode`"""
    before = spent(process)
    process.send_signal(sign)
    if not until(lambda: ended(process)):
        process.kill()
        process.wait()
        raise Failure(f'it does not end within {TIME_LIMIT_S} s after signal {sign}')
    after = spent(process)
    process.wait()
    return after - before


def each(function, items, jobs=CORES):
    """Applies the function to every item, in threads; the runs of the program do the work.  returns the results in the order of the items"""
    with concurrent.futures.ThreadPoolExecutor(max(1, jobs)) as pool:
        yield from pool.map(function, items)


# ---- the runner

def arguments(text):
    """Returns a parser for the runner's command line, with --kadr; `text` is the runner's own docstring."""
    parser = argparse.ArgumentParser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--kadr', required=True, help='the program under test')
    return parser


def parsed(parser):
    """Parses the options; `kadr` becomes the absolute path of an existing program, else the runner ends with status 2."""
    options = parser.parse_args()
    options.kadr = os.path.abspath(options.kadr)
    if not os.path.isfile(options.kadr) or not os.access(options.kadr, os.X_OK):
        parser.error(f'{options.kadr}: not a program')
    return options


def kadr_of(text):
    """Returns the program that the command line names, for a runner without other options."""
    return parsed(arguments(text)).kadr


def checks_of(namespace):
    """Returns the functions check_… of a module by name: check_a_fifo becomes a-fifo."""
    return {name.removeprefix('check_').replace('_', '-'): check for name, check in namespace.items()
            if name.startswith('check_') and callable(check)}


def in_a_folder(check, program, make=Kadr):
    """Runs a check in a fresh folder.  returns the faults: none, or why it failed"""
    with tempfile.TemporaryDirectory(prefix='kadr_check_') as folder:
        try:
            with make(program, folder) as made:
                check(made)
        except Failure as failure:
            return [str(failure)]
        except Exception:  # pylint: disable=broad-except
            return [traceback.format_exc()]
    return []


def carried_out(checks, program, make=Kadr, jobs=CORES):
    """Runs named checks, `jobs` at a time, and prints the totals.  returns the exit status"""
    tally = Tally()
    for name, faults in zip(checks, each(lambda check: in_a_folder(check, program, make), checks.values(), jobs)):
        tally.judge(name, faults)
    return tally.result()


def main(text, checks, make=Kadr, jobs=CORES):
    """Runs a whole runner. `checks` is the module's globals(), or checks by name; `make` creates from the program and the folder the object
    that a check gets; `jobs` checks run in parallel.  returns the exit status"""
    parser = arguments(text)
    parser.add_argument('--only', default='*', help='only checks whose name matches, e.g. "clash*"')
    parser.add_argument('--jobs', type=int, default=jobs, help='checks run at the same time')
    options = parsed(parser)
    named = checks_of(checks) if '__name__' in checks else checks
    chosen = {name: check for name, check in named.items() if fnmatch.fnmatch(name, options.only)}
    if not chosen:
        parser.error('no check of that name')
    return carried_out(chosen, options.kadr, make, options.jobs)
