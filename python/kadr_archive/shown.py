"""What the file of an archive holds, shown: runs, the difference of two states, tables as CSV."""
from __future__ import annotations

import argparse
import csv
import json
import sys
import time
from typing import Any, Iterator, Optional

from . import texts
from .report import write_report
from .store import Store, WrongFile

OK, FOUND = 0, 1
# the state of an archive after a run: its places at that time, with the results of the run's job
STATE = '''SELECT p.source, p.folder || p.name, hex(p.content), COALESCE(p.fault, ''), COALESCE(r.control, ''), COALESCE(r.state, ''), r.result,
    COALESCE(r.seconds, 0), COALESCE(r.reason, '') FROM places p
  LEFT JOIN folders f ON f.source = p.source AND f.folder = p.folder AND f.since <= :run AND (f.until IS NULL OR f.until > :run)
  LEFT JOIN results r ON r.job = :job AND r.content = p.content AND r.asked = p.asked AND (r.memory = x'' OR r.memory = f.memory)
  WHERE p.since <= :run AND (p.until IS NULL OR p.until > :run) AND p.source IN (SELECT value FROM json_each(:sources))
  ORDER BY 1, 2'''
PROGRAMS = STATE.replace('COALESCE(r.reason', 'r.alarms, r.warnings, r.advices, COALESCE(r.reason')


def run_of(store: Store, number: Optional[int]) -> dict[str, Any]:
    found = store.last_run(number)
    if found is None:
        raise WrongFile(f'{store.file}: ' + (texts.of('no_run') if number is None else texts.of('no_such_run').format(number)))
    return dict(zip(('run', 'job', 'sources'), found))


def runs(of: argparse.Namespace) -> int:
    store = Store(of.db, new=False)
    for run, what, kadr, machine, begun, ended, sources in store.rows(
            'SELECT run, what, kadr, machine, begun, ended, sources FROM runs JOIN jobs USING (job) ORDER BY run'):
        when = time.strftime('%Y-%m-%d %H:%M', time.localtime(begun))
        state = f'{ended - begun:.1f} s' if ended else texts.of('cut_off')
        print(f'{run:4}  {when}  {what:8}{kadr:22}{machine:12}{state:>12}  {" ".join(json.loads(sources))}')
    return OK


def tables(of: argparse.Namespace) -> int:
    """Writes a table as CSV."""
    store = Store(of.db, new=False)
    run = run_of(store, of.run)
    to = open(of.out, 'w', newline='', encoding='utf-8') if of.out else sys.stdout
    try:
        write = csv.writer(to, lineterminator='\n')
        heading, rows = TABLE[of.what]
        write.writerow(heading)
        write.writerows(rows(store, run))
    finally:
        if to is not sys.stdout:
            to.close()
    return OK


def programs_rows(store: Store, run: dict[str, Any]) -> Iterator[tuple[Any, ...]]:
    for source, path, content, fault, control, state, result, seconds, alarms, warnings, advices, reason in store.rows(PROGRAMS, run):
        yield (source, path, content.lower(), control, state if result else 'unreadable' if fault else 'undone', alarms, warnings, advices,
               seconds if result else None, fault or reason)


def findings_rows(store: Store, run: dict[str, Any]) -> Iterator[tuple[Any, ...]]:
    for place in store.rows(PROGRAMS, run):
        for row in store.rows('SELECT severity, id, file, line, "column", block, alarm, text, hint FROM findings WHERE result = ? ORDER BY number',
                              (place[6],)):
            yield (place[0], place[1], place[4], *row)


def tools_rows(store: Store, run: dict[str, Any]) -> Iterator[tuple[Any, ...]]:
    for place in store.rows(PROGRAMS, run):
        for row in store.rows('SELECT tool, cutting FROM tools WHERE result = ? ORDER BY tool', (place[6],)):
            yield (place[0], place[1], *row)


def extents_rows(store: Store, run: dict[str, Any]) -> Iterator[tuple[Any, ...]]:
    for place in store.rows(PROGRAMS, run):
        summary = store.one('SELECT summary FROM results WHERE result = ?', (place[6],))
        for channel in json.loads(summary)['channels'] if summary else ():
            for of in ('cutting', 'all'):
                for box in channel[of]:
                    for axis, ends in box['axes'].items():
                        yield (place[0], place[1], channel['channel'], of, box['system'], axis, *ends)


TABLE = {
    'programs': (('source', 'program', 'sha256', 'control', 'state', 'alarms', 'warnings', 'advices', 'seconds', 'reason'), programs_rows),
    'findings': (('source', 'program', 'control', 'severity', 'id', 'file', 'line', 'column', 'block', 'number', 'text', 'hint'), findings_rows),
    'extents': (('source', 'program', 'channel', 'of', 'system', 'axis', 'from', 'to'), extents_rows),
    'tools': (('source', 'program', 'tool', 'cutting'), tools_rows),
}


# ---- the difference of two states

def diff(of: argparse.Namespace) -> int:
    """Prints what is new, missing, or has another result. Exit status 1: something differs."""
    store = Store(of.db, new=False)
    after = run_of(store, of.after)
    before = run_of(store, of.before if of.before is not None else _run_before(store, after))
    old = store.db.cursor().execute(STATE, before)
    new = store.db.cursor().execute(STATE, after)
    what = store.one('SELECT what FROM jobs WHERE job = ?', (after['job'],))
    differs = 0
    for a, b in _pairs(old, new):
        line = _difference(store, what, a, b)
        if line:
            differs += 1
            print(line)
    print(texts.of('differences').format(differs, before['run'], after['run']))
    return FOUND if differs else OK


def _run_before(store: Store, after: dict[str, Any]) -> int:
    """Returns the last complete run before this one that did the same with the same sources."""
    what = store.one('SELECT what FROM jobs WHERE job = ?', (after['job'],))
    found = store.one('SELECT MAX(run) FROM runs JOIN jobs USING (job) WHERE run < ? AND what = ? AND sources = ? AND ended IS NOT NULL',
                      (after['run'], what, after['sources']))
    if found is None:
        raise WrongFile(f'{store.file}: {texts.of("no_run_before").format(after["run"])}')
    return int(found)


def _pairs(old: Any, new: Any) -> Iterator[tuple[Optional[tuple[Any, ...]], Optional[tuple[Any, ...]]]]:
    """Yields the rows of two sorted states side by side: None where a program is missing."""
    a, b = next(old, None), next(new, None)
    while a or b:
        if a and b and a[:2] == b[:2]:
            yield a, b
            a, b = next(old, None), next(new, None)
        elif b is None or (a and a[:2] < b[:2]):
            yield a, None
            a = next(old, None)
        else:
            yield None, b
            b = next(new, None)


def _difference(store: Store, what: str, a: Optional[tuple[Any, ...]], b: Optional[tuple[Any, ...]]) -> str:
    if a is None or b is None:
        there = a or b or ()
        return f'{there[1]}: {texts.of("missing" if b is None else "new")}'
    parts = []
    if a[2] != b[2]:
        parts.append(texts.of('text_differs'))
    if a[4] != b[4]:
        parts.append(f'{a[4] or "?"} → {b[4] or "?"}')
    if a[5] != b[5]:
        parts.append(f'{_state(a, what)} → {_state(b, what)}')
    if abs(a[7] - b[7]) > 1e-6 * max(1.0, abs(a[7])):
        parts.append(f'{a[7]:.1f} s → {b[7]:.1f} s')
    if a[6] != b[6]:
        was, now = _found(store, a[6]), _found(store, b[6])
        parts += [f'+ {finding}' for finding in sorted(now - was)] + [f'- {finding}' for finding in sorted(was - now)]
    return f'{b[1]}: {"; ".join(parts)}' if parts else ''


def _state(row: tuple[Any, ...], what: str) -> str:
    return texts.state(row[5], what) if row[5] else texts.of('unreadable' if row[3] else 'undone')


def _found(store: Store, result: Optional[int]) -> set[str]:
    return {f'{line}: {id}' for line, id in store.rows("SELECT line, id FROM findings WHERE result = ? AND severity <> 'note'", (result,))}


def report(of: argparse.Namespace) -> int:
    store = Store(of.db, new=False)
    return write_report(store, run_of(store, of.run), of.out, of.rows, of.workers)


SHOW = {'runs': runs, 'csv': tables, 'diff': diff, 'report': report}
