"""The command kadr-archive (docs/archive.md)."""
from __future__ import annotations

import argparse
import json
import os
import signal
import sqlite3
import sys
from pathlib import Path
from types import FrameType
from typing import Any, Iterator, Optional, Sequence

import kadr

from . import places, texts
from .archive import Archive, engine_of
from .children import CannotWork
from .progress import Bar
from .store import Store, WrongFile
from .work import Job, build

OK, FOUND, WRONG = 0, 1, 2
STATES_AGAIN = ('time', 'memory', 'killed')
MOST_NAMED = 20   # the table of the report and the CSV name all


class Wrong(Exception):
    """Wrong usage, or a file that cannot be read."""


def arguments(given: Optional[Sequence[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog='kadr-archive', description=texts.of('what'), add_help=True)
    commands = parser.add_subparsers(dest='command', required=True, metavar='COMMAND')
    for name in ('check', 'run', 'convert'):
        of = commands.add_parser(name, help=texts.of(f'{name}_help'), description=texts.of(f'{name}_help'))
        of.add_argument('sources', nargs='+', type=Path, metavar='FOLDER|ZIP|LIST', help=texts.of('sources'))
        of.add_argument('--db', type=Path, required=True, metavar='FILE', help=texts.of('db'))
        of.add_argument('--control', default='', metavar='ID', help=texts.of('control'))
        of.add_argument('--control-for', action='append', default=[], metavar='PATTERN=ID', help=texts.of('control_for'))
        of.add_argument('--exclude', action='append', default=[], metavar='PATTERN', help=texts.of('exclude'))
        of.add_argument('--machine', default='generic', metavar='ID', help=texts.of('machine'))
        of.add_argument('--setup', type=Path, metavar='FILE', help=texts.of('setup'))
        of.add_argument('--strict', action='store_true', help=texts.of('strict'))
        of.add_argument('--again', action='store_true', help=texts.of('again'))
        of.add_argument('--workers', type=int, default=os.cpu_count() or 1, metavar='N', help=texts.of('workers'))
        of.add_argument('--scheduler', default='', metavar='ADDRESS', help=texts.of('scheduler'))
        of.add_argument('--scheduler-file', type=Path, metavar='FILE', help=texts.of('scheduler_file'))
        of.add_argument('--by-content', action='store_true', help=texts.of('by_content'))
        of.add_argument('--most-seconds', type=float, default=60, metavar='S', help=texts.of('most_seconds'))
        of.add_argument('--most-memory', type=int, default=2048, metavar='MB', help=texts.of('most_memory'))
        of.add_argument('-q', '--quiet', action='store_true', help=texts.of('quiet'))
        if name == 'convert':
            of.add_argument('--to', required=True, metavar='ID', help=texts.of('to'))
            of.add_argument('--out', type=Path, metavar='DIR', help=texts.of('out_folder'))
    commands.add_parser('cut', help=texts.of('cut_help'), add_help=False)   # cut.py reads its options
    of = commands.add_parser('diff', help=texts.of('diff_help'), description=texts.of('diff_help'))
    of.add_argument('--db', type=Path, required=True, metavar='FILE', help=texts.of('db'))
    of.add_argument('--from', dest='before', type=int, metavar='RUN', help=texts.of('diff_from'))
    of.add_argument('--to', dest='after', type=int, metavar='RUN', help=texts.of('diff_to'))
    of = commands.add_parser('report', help=texts.of('report_help'), description=texts.of('report_help'))
    of.add_argument('--db', type=Path, required=True, metavar='FILE', help=texts.of('db'))
    of.add_argument('--out', type=Path, required=True, metavar='DIR', help=texts.of('report_out'))
    of.add_argument('--run', type=int, metavar='RUN', help=texts.of('which_run'))
    of.add_argument('--rows', type=int, default=200, metavar='N', help=texts.of('rows'))
    of.add_argument('--workers', type=int, default=os.cpu_count() or 1, metavar='N', help=texts.of('workers'))
    of = commands.add_parser('csv', help=texts.of('csv_help'), description=texts.of('csv_help'))
    of.add_argument('what', choices=('programs', 'findings', 'tools', 'extents'))
    of.add_argument('--db', type=Path, required=True, metavar='FILE', help=texts.of('db'))
    of.add_argument('--run', type=int, metavar='RUN', help=texts.of('which_run'))
    of.add_argument('--out', type=Path, metavar='FILE', help=texts.of('csv_out'))
    of = commands.add_parser('runs', help=texts.of('runs_help'), description=texts.of('runs_help'))
    of.add_argument('--db', type=Path, required=True, metavar='FILE', help=texts.of('db'))
    for name in commands.choices.values():
        name.add_argument('--lang', choices=('en', 'ru'), help=texts.of('lang'))
    return parser.parse_args(given)


def own_file(name: str) -> tuple[str, str]:
    """Returns the key and the text of an own control: its results are valid for this text only."""
    try:
        text = Path(name).read_text(encoding='utf-8')
    except OSError as error:
        raise Wrong(texts.reason(error)) from None
    return f'{Path(name).name}:{places.digest(text.encode()).hex()[:16]}', text


def choice_and_job(of: argparse.Namespace) -> tuple[places.Choice, Job]:
    controls: dict[str, str] = {}
    keys: dict[str, str] = {}

    def key_of(control: str) -> str:
        if not control.endswith('.toml'):
            if control and control not in kadr.controls():
                raise Wrong(texts.of('no_control').format(control) + texts.like(control, kadr.controls()))
            return control
        if control not in keys:
            keys[control], text = own_file(control)
            controls[keys[control]] = text
        return keys[control]

    pairs = [tuple(rule.rpartition('=')[::2]) for rule in of.control_for]
    if any(not pattern or not control for pattern, control in pairs):
        raise Wrong('--control-for PATTERN=ID')
    choice = places.Choice(of.exclude, of.control, [(str(p), str(c)) for p, c in pairs], key_of)
    for control in (of.control, *(c for _, c in choice.control_for)):
        key_of(control)
    setup = ''
    if of.setup:
        try:
            setup = json.dumps(json.loads(of.setup.read_text(encoding='utf-8')), sort_keys=True)
        except OSError as error:
            raise Wrong(texts.reason(error)) from None
        except ValueError as error:
            raise Wrong(texts.of('no_json').format(of.setup, error)) from None
    machine = own_file(of.machine)[1] if of.machine.endswith('.toml') else of.machine
    if '\n' not in machine and machine not in kadr.machines():
        raise Wrong(texts.of('no_machine').format(machine) + texts.like(machine, kadr.machines()))
    if of.command == 'convert':
        key_of(of.to)
    return choice, Job(of.command, machine, setup, getattr(of, 'to', ''), controls, of.most_seconds, of.most_memory << 20, build())


class Stop:
    """Set by Ctrl-C or SIGTERM: what is done is kept, and the next run goes on."""

    def __init__(self) -> None:
        self.signal = 0
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            if signal.getsignal(number) != signal.SIG_IGN:
                signal.signal(number, self._take)

    def _take(self, number: int, _: Optional[FrameType]) -> None:
        self.signal = number

    def __call__(self) -> bool:
        return self.signal != 0


def work(of: argparse.Namespace) -> int:
    choice, job = choice_and_job(of)
    if of.workers < 1 or of.most_seconds <= 0 or of.most_memory < 1:
        raise Wrong(texts.of('limits'))
    sources = [places.source_of(path) for path in of.sources]
    store = Store(of.db)
    machine = job.machine if '\n' not in job.machine else f'{Path(of.machine).name}:{places.digest(job.machine.encode()).hex()[:16]}'
    number = store.job(job.what, job.build, machine, job.setup, {'to': job.to} if job.to else {})
    if of.again:
        store.forget(number, STATES_AGAIN)
    stop = Stop()
    engine = None

    def start() -> Any:
        nonlocal engine
        engine = engine or engine_of(job, of.workers, of.scheduler, of.scheduler_file, of.by_content)
        return engine

    archive = Archive(store, sources, choice, job, number, Bar(of.quiet), stop)
    try:
        done = archive.bring_up_to_date(start)
    finally:
        if engine:
            engine.close()
    if stop():
        print(texts.of('interrupted'), file=sys.stderr)
        return 128 + stop.signal
    counts = totals(store, number, [source.name for source in sources])
    faults = [fault for source in sources for fault in source.faults]
    for fault in faults:
        print(f'kadr-archive: {fault}', file=sys.stderr)
    for name, state, reason in hostile(store, number, [source.name for source in sources]):
        print(f'kadr-archive: {name}: {texts.of(state)} ({reason})', file=sys.stderr)
    if job.what == 'convert' and of.out:
        from .output import write_all
        write_all(store, number, sources, of.out)
    if not of.quiet:
        print(in_words(counts, done, job.what))
    for source in sources:
        source.close()
    store.close()
    return status(counts, bool(faults), of.strict)


def totals(store: Store, job: int, names: list[str]) -> dict[str, int]:
    """Counts the programs that are there now, by their state; `warned` have no alarm but a warning."""
    from .store import WITH_RESULT
    marks = ','.join(f':s{i}' for i in range(len(names)))
    rows = store.rows(f"SELECT CASE WHEN p.content IS NULL THEN 'unreadable' ELSE r.state END, r.warnings > 0, COUNT(*) FROM places p {WITH_RESULT} "
                      f'WHERE p.until IS NULL AND p.source IN ({marks}) GROUP BY 1, 2', {'job': job, **{f's{i}': n for i, n in enumerate(names)}})
    counts: dict[str, int] = {}
    for state, warned, count in rows:
        key = state or 'undone'
        counts[key] = counts.get(key, 0) + count
        if warned and state == 'ok':
            counts['warned'] = counts.get('warned', 0) + count
    return counts


def hostile(store: Store, job: int, names: list[str]) -> Iterator[tuple[Any, ...]]:
    """Returns the first programs that exceeded a limit or were quarantined."""
    from .store import WITH_RESULT
    marks = ','.join(f':s{i}' for i in range(len(names)))
    return store.rows(f"SELECT p.folder || p.name, r.state, r.reason FROM places p {WITH_RESULT} WHERE p.until IS NULL AND p.source IN ({marks}) "
                      f"AND r.state IN ('time', 'memory', 'killed') ORDER BY p.place LIMIT {MOST_NAMED}",
                      {'job': job, **{f's{i}': n for i, n in enumerate(names)}})


def in_words(counts: dict[str, int], done: int, what: str) -> str:
    total = sum(count for state, count in counts.items() if state != 'warned')
    parts = [f'{texts.state(state, what)} {counts[state]}' for state in
             ('ok', 'warned', 'alarm', 'unknown', 'refused', 'time', 'memory', 'killed', 'unreadable', 'undone') if counts.get(state)]
    return texts.of('totals').format(total, done) + ('' if not parts else '; ' + ', '.join(parts))


def status(counts: dict[str, int], faults: bool, strict: bool) -> int:
    if faults or counts.get('unreadable') or counts.get('undone') or not any(count for state, count in counts.items() if state != 'unknown'):
        return WRONG
    found = any(counts.get(state) for state in ('alarm', 'refused', 'time', 'memory', 'killed')) or (strict and counts.get('warned'))
    return FOUND if found else OK


def main(given: Optional[Sequence[str]] = None) -> int:
    words = list(sys.argv[1:] if given is None else given)
    texts.choose(words)
    of = argparse.Namespace()
    try:
        if words[:1] == ['cut']:
            from .cut import cut
            return cut(words[1:], Stop())
        of = arguments(words)
        if of.command in ('check', 'run', 'convert'):
            return work(of)
        from . import shown
        return shown.SHOW[of.command](of)
    except (Wrong, WrongFile, CannotWork, OSError, ValueError) as error:
        print(f'kadr-archive: {texts.reason(error)}', file=sys.stderr)
        return WRONG
    except kadr.Error as error:   # a fault in a .kadr.toml
        print(f'kadr-archive: {error}', file=sys.stderr)
        return WRONG
    except sqlite3.Error as error:
        print(f'kadr-archive: {getattr(of, "db", "")}: {error}', file=sys.stderr)
        return WRONG
    except ImportError as error:
        print(f'kadr-archive: {error}: {texts.of("package")}', file=sys.stderr)
        return WRONG
