"""kadr-archive cut: a cut by windows, each of them cut by a process of its own, also on other computers; joined, the result has the same bits
as that of one process (docs/archive.md).

The window is a portion of the blank's bricks: `kadr cut --portion K/N` cuts it, `kadr cut --join` joins all.
"""
from __future__ import annotations

import argparse
import concurrent.futures
import os
import queue
import signal
import subprocess
import sys
import tempfile
import threading
import warnings
from pathlib import Path
from typing import Any, Callable, Iterator, NamedTuple, Optional, Sequence

from . import texts
from .children import CannotWork, WrongBuild
from .places import is_program_name
from .progress import Bar
from .work import build, kadr_program

TRIES = 2                 # of a window whose process was killed
MOST_SENT = 256 << 20     # bytes of the files that are sent with --by-content
RESULTS = ('--out', '--json', '--blocks', '--allow', '--allow-left', '--threads')   # options of the process that joins, with a value


class Window(NamedTuple):
    """What a process needs to cut one window."""

    number: int
    count: int
    words: list[str]               # of the command line of kadr cut
    place: str                     # folder for its file, which all processes see; empty: its content is returned
    files: dict[str, bytes]        # files that the words name, if the workers do not see them
    build: str


class Cut(NamedTuple):
    """What became of a window."""

    status: int
    said: str
    content: bytes                 # of its file, if the client does not see it


def arguments(given: Sequence[str]) -> tuple[argparse.Namespace, list[str]]:
    """Returns our own options, and the words for kadr cut."""
    parser = argparse.ArgumentParser(prog='kadr-archive cut', description=texts.of('cut_help'), usage='%(prog)s PROGRAM --resolution MM --tools FILE [options]',
                                     epilog=texts.of('cut_others'), allow_abbrev=False)
    parser.add_argument('--windows', type=int, metavar='N', help=texts.of('windows'))
    parser.add_argument('--workers', type=int, default=os.cpu_count() or 1, metavar='N', help=texts.of('workers'))
    parser.add_argument('--scheduler', default='', metavar='ADDRESS', help=texts.of('scheduler'))
    parser.add_argument('--scheduler-file', type=Path, metavar='FILE', help=texts.of('scheduler_file'))
    parser.add_argument('--by-content', action='store_true', help=texts.of('by_content'))
    parser.add_argument('--temporary', type=Path, metavar='DIR', help=texts.of('temporary'))
    parser.add_argument('--lang', choices=('en', 'ru'), help=texts.of('lang'))
    parser.add_argument('-q', '--quiet', action='store_true', help=texts.of('quiet'))
    own, others = split(list(given), {name: action.nargs != 0 for action in parser._actions for name in action.option_strings})
    return parser.parse_args(own), others


def split(words: list[str], known: dict[str, bool]) -> tuple[list[str], list[str]]:
    """Divides words into those of known options (name: has a value) with their values, and the others, which keep their order."""
    own: list[str] = []
    others: list[str] = []
    at = iter(words)
    for word in at:
        name = word.partition('=')[0]
        if name not in known:
            others.append(word)
            continue
        own.append(word)
        if known[name] and '=' not in word:
            own += [value for value in [next(at, None)] if value is not None]
    return own, others


def do_window(window: Window) -> Cut:
    """Cuts a window. Runs in a thread of the client, or in a worker of a cluster."""
    if window.build != build():
        return Cut(-1000, f'a worker has Kadr {build()}, this computer has {window.build}', b'')
    with tempfile.TemporaryDirectory(prefix='kadr-cut-') as folder:
        words = with_files(window.words, window.files, Path(folder))
        file = Path(window.place or folder, f'{window.number}.portion')
        done = run(['cut', *words, '--portion', f'{window.number}/{window.count}', '--out', str(file), '--threads', '1', '-q'])
        content = b'' if window.place or done.returncode != 0 else file.read_bytes()
        return Cut(done.returncode, done.stderr.decode('utf-8', 'replace'), content)


running: set[subprocess.Popen[bytes]] = set()
lock = threading.Lock()


def run(words: list[str]) -> subprocess.CompletedProcess[bytes]:
    """Runs kadr. The client ends what runs when it is interrupted."""
    process = subprocess.Popen([kadr_program(), *words], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    with lock:
        running.add(process)
    try:
        _, said = process.communicate()
    finally:
        with lock:
            running.discard(process)
    return subprocess.CompletedProcess(words, process.returncode, b'', said)


def end_running() -> None:
    with lock:
        for process in running:
            process.kill()


def named_files(words: Sequence[str]) -> dict[str, bytes]:
    """Returns the files that words name, as NAME or --option=NAME, and the programs next to the program, which it may call."""
    files: dict[str, bytes] = {}
    for word in words:
        name = word.partition('=')[2] if word.startswith('--') else word
        if name and Path(name).is_file():
            files[name] = Path(name).read_bytes()
    program = next((Path(word) for word in words if not word.startswith('-') and Path(word).is_file()), None)
    size = sum(map(len, files.values()))
    for other in sorted(program.parent.iterdir()) if program else ():
        if other.is_file() and is_program_name(other.name) and str(other) not in files and size + other.stat().st_size < MOST_SENT:
            files[str(other)] = other.read_bytes()
            size += len(files[str(other)])
    return files


def with_files(words: list[str], files: dict[str, bytes], folder: Path) -> list[str]:
    """Writes files into a folder. Returns the words with their new names. Files of one folder remain next to each other."""
    new: dict[str, str] = {}
    for name, content in files.items():
        parents = sorted({os.path.dirname(os.path.abspath(other)) for other in files})
        path = folder / 'files' / str(parents.index(os.path.dirname(os.path.abspath(name)))) / os.path.basename(name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
        new[name] = str(path)
    def renamed(word: str) -> str:
        option, equals, value = word.partition('=') if word.startswith('--') else ('', '', word)
        return f'{option}{equals}{new[value]}' if value in new else word
    return [renamed(word) for word in words]


Does = Callable[[list[Window], Callable[[], bool]], Iterator[tuple[Window, Cut]]]


def here(workers: int) -> Does:
    """Returns a function that cuts windows in processes of this computer."""
    def do(windows: list[Window], stop: Callable[[], bool]) -> Iterator[tuple[Window, Cut]]:
        with concurrent.futures.ThreadPoolExecutor(workers) as pool:
            left = {pool.submit(do_window, window): window for window in windows}
            while left:
                done, _ = concurrent.futures.wait(left, 0.2, concurrent.futures.FIRST_COMPLETED)
                if stop():
                    pool.shutdown(wait=False, cancel_futures=True)
                    end_running()
                    return
                for future in done:
                    yield left.pop(future), future.result()
    return do


def on_cluster(of: argparse.Namespace) -> tuple[Does, Callable[[], None]]:
    """Returns a function that cuts windows with a Dask cluster, and one that ends the connection."""
    from .cluster import connect
    distributed, client = connect(of.scheduler, of.scheduler_file)

    def do(windows: list[Window], stop: Callable[[], bool]) -> Iterator[tuple[Window, Cut]]:
        ready: queue.Queue[Any] = queue.Queue()
        with warnings.catch_warnings():   # Dask advises against large arguments; scattered ones would be lost with their worker
            warnings.simplefilter('ignore')
            left = {client.submit(do_window, window, pure=False): window for window in windows}
        for future in left:
            future.add_done_callback(ready.put)
        try:
            while left and not stop():
                try:
                    future = ready.get(timeout=0.5)
                    of = future.result(timeout=5)
                except queue.Empty:
                    continue
                except distributed.TimeoutError:
                    ready.put(future)   # its worker died with the result, which Dask computes again
                    continue
                except distributed.KilledWorker as error:
                    raise CannotWork(str(error)) from None
                yield left.pop(future), of
        finally:
            client.cancel(list(left), force=True)
    return do, client.close


def cut_all(windows: list[Window], does: Does, place: Path, bar: Bar, stop: Callable[[], bool]) -> Optional[Cut]:
    """Cuts all windows; their files are in `place` then. Returns what went wrong with one, if anything did."""
    bar.begin('cut', len(windows))
    try:
        for _ in range(TRIES):
            killed: list[Window] = []
            for window, of in does(windows, stop):
                if of.content:
                    (place / f'{window.number}.portion').write_bytes(of.content)
                if of.status > 0:
                    return of
                if of.status == -1000:
                    raise WrongBuild(of.said)
                if of.status < 0:
                    killed.append(window)
                else:
                    bar.add(1)
            windows = killed
            if not killed or stop():
                return None
        return Cut(2, texts.of('window_killed').format(windows[0].number, windows[0].count) + '\n', b'')
    finally:
        bar.end()


def cut(given: Sequence[str], stop: Any) -> int:
    """Cuts a program by windows and joins them. Returns the exit status of kadr cut."""
    of, words = arguments(given)
    if of.workers < 1 or (of.windows is not None and of.windows < 1):
        raise CannotWork(texts.of('window_limits'))
    results, windowed = split(words, {name: True for name in RESULTS})
    named = [b for a, b in zip(results, results[1:]) if a == '--out'] + [word[6:] for word in results if word.startswith('--out=')]
    out = Path(named[0]) if named else Path()
    with tempfile.TemporaryDirectory(prefix='.kadr-cut-', dir=of.temporary or out.parent) as folder:
        clustered = bool(of.scheduler or of.scheduler_file)
        does, close = on_cluster(of) if clustered else (here(of.workers), lambda: None)
        count = of.windows or 2 * of.workers
        files = named_files(windowed) if of.by_content else {}
        seen = '' if of.by_content else str(Path(folder).resolve())
        if clustered and not of.by_content:
            windowed = absolute(windowed)
        windows = [Window(number, count, windowed, seen, files, build()) for number in range(1, count + 1)]
        try:
            wrong = cut_all(windows, does, Path(folder), Bar(of.quiet), stop)
        finally:
            close()
        if stop():
            print(texts.of('cut_interrupted'), file=sys.stderr)
            return 128 + int(stop.signal)
        if wrong:
            sys.stderr.write(wrong.said)
            return wrong.status
        joined = [kadr_program(), 'cut', *words, *(['-q'] if of.quiet else []), *(['--lang', of.lang] if of.lang else []), '--join',
                  *(str(Path(folder, f'{number}.portion')) for number in range(1, count + 1))]
        process = subprocess.Popen(joined)
        while True:
            try:
                return process.wait(0.2)
            except subprocess.TimeoutExpired:
                if stop():
                    process.send_signal(signal.SIGINT)


def absolute(words: Sequence[str]) -> list[str]:
    """Returns the words with absolute names of files: a worker has another working directory."""
    def of(word: str) -> str:
        option, equals, value = word.partition('=') if word.startswith('--') else ('', '', word)
        return f'{option}{equals}{Path(value).resolve()}' if value and Path(value).exists() else word
    return [of(word) for word in words]
