"""An archive: finds what is to be done, has it done, and keeps the results."""
from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Iterator, Optional, Protocol

from . import places
from .store import WITH_RESULT, Store
from .work import Item, Job

BATCH_BYTES = 4 << 10       # for each program of a batch: long programs make it shorter
MOST_SENT = 1 << 20         # bytes; the workers read a longer file themselves, if they see it
MOST_FOLDER = 64 << 20      # bytes of called programs that are sent with a program
SAVE_RESULTS = 500          # results in a transaction,
SAVE_SECONDS = 0.5          # or what has arrived in this time
MOST_ROUNDS = 5             # a file that changes all the time does not keep the archive busy endlessly


class Engine(Protocol):
    """Distributes batches and yields their results in any order, each batch once."""

    sees_files: bool

    def batch_programs(self, todo: int) -> int: ...
    def results(self, batches: Iterator[list[Item]], stop: Callable[[], bool]) -> Iterator[list[dict[str, Any]]]: ...
    def close(self) -> None: ...


class Progress(Protocol):
    def begin(self, what: str, total: Optional[int]) -> None: ...
    def add(self, count: int) -> None: ...
    def end(self) -> None: ...


@dataclass
class Archive:
    """Sources, what is done with their programs, and where the results are kept."""

    store: Store
    sources: list[places.Source]
    choice: places.Choice
    job: Job
    number: int                 # of the job in the store
    progress: Progress
    stop: Callable[[], bool]

    def bring_up_to_date(self, engine: Callable[[], Engine]) -> int:
        """Scans the sources and does what is not done yet. Returns how many programs were worked on. The engine starts if there is work."""
        run = self.store.begin(self.number, [source.name for source in self.sources])
        done = 0
        for _ in range(MOST_ROUNDS):
            self._scan(run)
            changed = False
            first = True
            while not self.stop() and (todo := self._find_todo(first)):
                new, moved = self._do(engine(), todo)
                done, changed = done + new, changed or moved
                first = False
                if new == 0:
                    break
            if not changed or self.stop():
                break
        if not self.stop():
            self.store.end(run)
        return done

    def _scan(self, run: int) -> None:
        self.progress.begin('finding', None)
        for source in self.sources:
            places.Scan(self.store, run, self.choice, self.progress.add, self.stop).take(source)
        self.progress.end()

    def _find_todo(self, first: bool) -> int:
        """Fills the table `todo` with one place for each content without a result. Returns their number.

        A program that calls others is worked on once for each folder; which programs these are is known after the first round."""
        db = self.store.db
        db.execute('DROP TABLE IF EXISTS temp.todo')
        db.execute('CREATE TEMP TABLE todo (place INTEGER PRIMARY KEY)')
        names = [source.name for source in self.sources]
        group = '' if first else ', f.memory'
        db.execute(f'INSERT INTO todo SELECT MIN(p.place) FROM places p {WITH_RESULT} WHERE p.until IS NULL AND p.content IS NOT NULL '
                   f'AND r.result IS NULL AND p.source IN ({",".join(f":s{i}" for i in range(len(names)))}) GROUP BY p.content, p.asked{group}',
                   {'job': self.number, **{f's{i}': name for i, name in enumerate(names)}})
        return int(self.store.one('SELECT COUNT(*) FROM todo'))

    def _do(self, engine: Engine, todo: int) -> tuple[int, bool]:
        """Returns how many results are new, and whether a program has changed in the meantime."""
        self.progress.begin(self.job.what, todo)
        new, moved = 0, False
        waiting: list[dict[str, Any]] = []
        saved = time.monotonic()
        lonely: list[bytes] = []   # contents that call programs which the worker does not see
        for made in engine.results(self._batches(engine), self.stop):
            self.progress.add(len(made))
            for of in made:
                if of['state'] == 'changed':
                    moved = True
                elif of.pop('lonely', False):
                    lonely.append(of['content'])
                else:
                    waiting.append(of)
            if len(waiting) >= SAVE_RESULTS or time.monotonic() - saved > SAVE_SECONDS:
                new += self.store.add(self.number, waiting)
                waiting, saved = [], time.monotonic()
        new += self.store.add(self.number, waiting)
        if lonely and not self.stop():
            for made in engine.results(self._batches(engine, set(lonely)), self.stop):
                new += self.store.add(self.number, made)
        self.progress.end()
        return new, moved or self.moved

    def _batches(self, engine: Engine, lonely: Optional[set[bytes]] = None) -> Iterator[list[Item]]:
        """Yields batches of about the same size. With `lonely`, only these contents, with the programs of their folder."""
        self.moved = False
        most = engine.batch_programs(int(self.store.one('SELECT COUNT(*) FROM todo')))
        sources = {source.name: source for source in self.sources}
        batch: list[Item] = []
        size = 0
        for source, folder, name, bytes_, content, asked, memory in self._todo():
            if lonely is not None and content not in lonely:
                continue
            of = sources[source]
            path = of.on_disk(folder, name) if engine.sees_files else None
            try:
                text = None if path and bytes_ > MOST_SENT else of.read(folder, name)
            except (OSError, KeyError):
                text = b''
            if text is not None and places.digest(text) != content:
                self.moved = True
                self._read_again(source, folder, name)
                continue
            called = self._folder(of, folder, name) if lonely is not None else {}
            batch.append(Item(content, asked, memory, name, path, text, called, lonely is None and path is None))
            size += bytes_
            if len(batch) >= most or size >= most * BATCH_BYTES:
                yield batch
                batch, size = [], 0
        if batch:
            yield batch

    def _todo(self) -> Iterator[tuple[Any, ...]]:
        """Yields the places of the table `todo`, a page at a time: there may be millions, and results are written meanwhile."""
        last = 0
        while page := self.store.rows(
                'SELECT place, p.source, p.folder, p.name, p.size, p.content, p.asked, f.memory FROM todo JOIN places p USING (place) JOIN folders f '
                'ON f.source = p.source AND f.folder = p.folder AND f.until IS NULL WHERE place > ? ORDER BY place LIMIT 2000', (last,)).fetchall():
            for place, *of in page:
                yield tuple(of)
            last = page[-1][0]

    def _read_again(self, source: str, folder: str, name: str) -> None:
        with self.store.changes():
            self.store.db.execute('UPDATE places SET stamp = 0 WHERE source = ? AND folder = ? AND name = ? AND until IS NULL', (source, folder, name))

    def _folder(self, source: places.Source, folder: str, name: str) -> dict[str, bytes]:
        """Returns the other programs of a folder, for workers that do not see it."""
        found: dict[str, bytes] = {}
        size = 0
        for other, bytes_ in self.store.rows('SELECT name, size FROM places WHERE source = ? AND folder = ? AND until IS NULL AND content IS NOT NULL '
                                             'ORDER BY name', (source.name, folder)).fetchall():
            if other == name or size + bytes_ > MOST_FOLDER:
                continue
            size += bytes_
            try:
                found[other] = source.read(folder, other)
            except (OSError, KeyError):
                pass
        return found


def engine_of(job: Job, workers: int, scheduler: str, scheduler_file: Optional[Path], by_content: bool) -> Engine:
    """Returns the engine that the options name: processes of this computer, or a Dask cluster."""
    if scheduler or scheduler_file:
        from .cluster import Cluster
        return Cluster(job, scheduler, scheduler_file, sees_files=not by_content)
    from .children import Local
    return Local(job, workers)
