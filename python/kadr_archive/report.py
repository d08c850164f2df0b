"""The report of an archive in HTML: an overview, a page for each group of programs, and the page that `kadr report` makes of each program."""
from __future__ import annotations

import concurrent.futures
import json
import os
import subprocess
import tempfile
import time
from collections import Counter
from pathlib import Path
from typing import Any, Iterable, NamedTuple, Optional

from . import places, texts
from .progress import Bar
from .store import Store, WrongFile
from .work import kadr_program

MOST_SECONDS = 120   # for the page of one program

# the programs of a run, with the results of the run's job
PROGRAMS = '''CREATE TEMP TABLE shown AS SELECT p.place, p.source, p.folder, p.name, p.size, p.content, p.asked,
    CASE WHEN p.content IS NULL THEN 'unreadable' ELSE COALESCE(r.state, 'undone') END AS state, COALESCE(r.control, '') AS control, r.result,
    COALESCE(p.fault, r.reason, '') AS reason
  FROM places p
  LEFT JOIN folders f ON f.source = p.source AND f.folder = p.folder AND f.since <= :run AND (f.until IS NULL OR f.until > :run)
  LEFT JOIN results r ON r.job = :job AND r.content = p.content AND r.asked = p.asked AND (r.memory = x'' OR r.memory = f.memory)
  WHERE p.since <= :run AND (p.until IS NULL OR p.until > :run) AND p.source IN (SELECT value FROM json_each(:sources))'''
# the last results of `run` for the same contents: times and tools
TIMED = '''CREATE TEMP TABLE timed AS SELECT s.place, r.result, r.seconds FROM shown s
  JOIN results r ON r.result = (SELECT MAX(q.result) FROM results q JOIN jobs j USING (job)
    WHERE j.what = 'run' AND q.content = s.content AND q.asked = s.asked)'''


class Row(NamedTuple):
    """A program of the report."""

    path: str
    size: int
    state: str
    control: str
    seconds: str
    first: str
    page: str


class Group(NamedTuple):
    """Programs with something in common; they have a page of their own."""

    name: str
    file: str
    programs: int
    times: int
    seconds: Optional[float]
    severity: str


class Report:
    def __init__(self, store: Store, run: dict[str, Any], out: Path, rows: int) -> None:
        self.store = store
        self.run = run
        self.out = out
        self.most = rows
        self.pages: dict[str, int] = {}   # page → place of a program that it shows
        self.names: Counter[str] = Counter()
        store.db.execute('DROP TABLE IF EXISTS temp.shown')
        store.db.execute(PROGRAMS, run)
        store.db.execute('DROP TABLE IF EXISTS temp.timed')
        store.db.execute(TIMED)
        self.what, self.machine, self.setup, self.kadr, self.begun = store.db.execute(
            'SELECT what, machine, setup, kadr, begun FROM runs JOIN jobs USING (job) WHERE run = :run', run).fetchone()

    def groups(self, kind: str, query: str) -> list[Group]:
        """Returns the groups of a query with the columns name, programs, times, seconds, severity."""
        made = []
        for name, programs, times, seconds, severity in self.store.rows(query):
            safe = ''.join(c if c.isascii() and (c.isalnum() or c in '-_') else '-' for c in str(name)) or 'none'
            file = f'{kind}-{safe}'
            self.names[file] += 1
            made.append(Group(str(name), f'{file}.html' if self.names[file] == 1 else f'{file}-{self.names[file]}.html', programs, times, seconds, severity))
        return made

    def rows(self, where: str, values: Iterable[Any]) -> list[Row]:
        """Returns the first programs of a group; each has a page."""
        rows = []
        for place, folder, name, size, state, control, result, reason, content, asked, seconds in self.store.rows(
                f'SELECT s.place, folder, name, size, state, control, s.result, reason, content, asked, t.seconds FROM shown s LEFT JOIN timed t USING (place) '
                f'WHERE {where} ORDER BY source, folder, name LIMIT ?', (*values, self.most)).fetchall():
            first = self.store.db.execute("SELECT line, text FROM findings WHERE result = ? ORDER BY severity <> 'alarm', number LIMIT 1", (result,)).fetchone()
            page = self._page(place, content, control or asked, folder)
            rows.append(Row(folder + name, size, texts.state(state, self.what), control, duration(seconds), reason or (f'{first[0]}: {first[1]}' if first else ''), page))
        return rows

    def _page(self, place: int, content: Any, control: str, folder: str) -> str:
        """Returns the name of a program's page. It depends on all that the page shows, so that a page is made once."""
        key = places.digest(b'\0'.join([content or b'', control.encode(), self.machine.encode(), self.setup.encode(), self.kadr.encode(),
                                         folder.encode('utf-8', 'surrogateescape'), str(place).encode() if content is None else b'']))
        page = f'{key.hex()[:20]}.html'
        self.pages.setdefault(page, place)
        return page


def duration(seconds: Any) -> str:
    if seconds is None:
        return ''
    whole = int(seconds + 0.5)
    return f'{whole // 3600}:{whole // 60 % 60:02}:{whole % 60:02}' if whole >= 3600 else f'{whole // 60}:{whole % 60:02}'


QUERIES = {
    'state': ("SELECT state, COUNT(*), COUNT(*), SUM(seconds), '' FROM shown LEFT JOIN timed USING (place) GROUP BY state ORDER BY 2 DESC, 1", 'state = ?'),
    'finding': ('SELECT id, COUNT(DISTINCT place), COUNT(*), NULL, severity FROM shown s JOIN findings f ON f.result = s.result GROUP BY id '
                "ORDER BY instr('alarm warning advice note', severity), 2 DESC, 1",
                's.result IN (SELECT result FROM findings WHERE id = ?)'),
    'control': ("SELECT control, COUNT(*), COUNT(*), SUM(seconds), '' FROM shown LEFT JOIN timed USING (place) GROUP BY control ORDER BY 2 DESC, 1", 'control = ?'),
    'tool': ("SELECT tool, COUNT(DISTINCT place), COUNT(*), SUM(cutting), '' FROM timed t JOIN tools o ON o.result = t.result GROUP BY tool ORDER BY tool",
             't.result IN (SELECT result FROM tools WHERE tool = CAST(? AS INTEGER))'),
}


def write_report(store: Store, run: dict[str, Any], out: Path, rows: int, workers: int) -> int:
    """Writes the report into a folder. Pages that are there already are not made again."""
    import jinja2
    out.mkdir(parents=True, exist_ok=True)
    (out / 'programs').mkdir(exist_ok=True)
    report = Report(store, run, out, rows)
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(Path(__file__).parent / 'templates'), autoescape=True, undefined=jinja2.StrictUndefined)
    environment.globals.update(t=texts.of, lang=texts.LANGUAGE, duration=duration)
    group_page = environment.get_template('group.html')
    tables: dict[str, list[Group]] = {}
    for kind, (query, where) in QUERIES.items():
        tables[kind] = report.groups(kind, query)
        for group in tables[kind]:
            listed = report.rows(where, (group.name,))
            title = texts.state(group.name, report.what) if kind == 'state' else group.name or texts.of('unknown')
            write(out / group.file, group_page.render(title=title, kind=kind, rows=listed, total=group.programs))
    total = store.one('SELECT COUNT(*) FROM shown')
    timed, seconds = store.db.execute('SELECT COUNT(*), SUM(seconds) FROM timed').fetchone()
    machines = store.rows("SELECT machine, COUNT(DISTINCT s.place), SUM(r.state IN ('ok')), SUM(r.state NOT IN ('ok', 'unknown')) FROM shown s "
                          'JOIN results r ON r.content = s.content AND r.asked = s.asked JOIN jobs j ON j.job = r.job '
                          "WHERE j.what = 'check' GROUP BY machine ORDER BY machine").fetchall()
    write(out / 'index.html', environment.get_template('index.html').render(
        sources=json.loads(run['sources']), kadr=report.kadr.partition('+')[0], run=run['run'], when=time.strftime('%Y-%m-%d %H:%M', time.localtime(report.begun)),
        what=report.what, state=texts.state, total=total, timed=timed, seconds=seconds or 0, tables=tables, machines=machines))
    made = make_pages(report, workers)
    print(texts.of('report_made').format(out / 'index.html', len(report.pages), made))
    return 0


def write(file: Path, text: str) -> None:
    """Replaces a file in one step."""
    part = file.with_suffix('.part')
    part.write_text(text, encoding='utf-8')
    os.replace(part, file)


def make_pages(report: Report, workers: int) -> int:
    """Has `kadr report` make the pages that are missing. Returns their number."""
    missing = [(page, place) for page, place in report.pages.items() if not (report.out / 'programs' / page).is_file()]
    if not missing:
        return 0
    program = kadr_program()
    bar = Bar(False)
    bar.begin('pages', len(missing))
    opened: dict[str, places.Source] = {}
    with concurrent.futures.ThreadPoolExecutor(max(1, workers)) as pool:
        waiting = []
        for page, place in missing:
            source, folder, name, control, asked, reason = report.store.db.execute(
                'SELECT source, folder, name, control, asked, reason FROM shown WHERE place = ?', (place,)).fetchone()
            try:
                of = opened.get(source) or opened.setdefault(source, places.source_of(Path(source)))
                text = of.read(folder, name)
                path = of.on_disk(folder, name)
            except (OSError, KeyError, ValueError) as error:
                write(report.out / 'programs' / page, plain_page(name, str(error)))
                continue
            waiting.append(pool.submit(make_page, program, report, page, name, path, text, control, asked, reason))
        for future in concurrent.futures.as_completed(waiting):
            future.result()
            bar.add(1)
    bar.end()
    return len(missing)


def make_page(program: str, report: Report, page: str, name: str, path: Any, text: bytes, control: str, asked: str, reason: str) -> None:
    with tempfile.TemporaryDirectory(prefix='kadr-archive-') as folder:
        if path is None:
            path = f'{folder}/{os.path.basename(places.as_path(name))}'
            Path(path).write_bytes(text)
        command = [program, 'report', path, '--out', f'{folder}/page.html', '-q', '--lang', texts.LANGUAGE]
        if control and ':' not in asked:
            command += ['--control', control]
        if ':' not in report.machine:
            command += ['--machine', report.machine]
        if report.setup:
            Path(folder, 'setup.json').write_text(report.setup, encoding='utf-8')
            command += ['--setup', f'{folder}/setup.json']
        try:
            ran = subprocess.run(command, capture_output=True, stdin=subprocess.DEVNULL, timeout=MOST_SECONDS)
            made = Path(folder, 'page.html')
            why = reason or ran.stderr.decode('utf-8', 'replace').strip()
        except subprocess.TimeoutExpired:
            made, why = Path(folder, 'none'), texts.of('time')
        if made.is_file():
            part = report.out / 'programs' / f'{page}.part'
            part.write_bytes(made.read_bytes())
            os.replace(part, report.out / 'programs' / page)
        else:
            write(report.out / 'programs' / page, plain_page(name, why))


def plain_page(name: str, why: str) -> str:
    """Returns the page of a program of which Kadr makes no report."""
    import jinja2
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(Path(__file__).parent / 'templates'), autoescape=True)
    environment.globals.update(t=texts.of, lang=texts.LANGUAGE)
    return environment.get_template('plain.html').render(name=name, why=why)


__all__ = ['WrongFile', 'write_report']
