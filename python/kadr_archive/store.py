"""The results of an archive in one SQLite file (docs/archive.md, "The file").

Every change is a transaction, so the file is consistent after a kill at any time: a result is there completely or not at all.
"""
from __future__ import annotations

import json
import sqlite3
import time
from pathlib import Path
from typing import Any, Iterable, Iterator, Optional

VERSION = 1
TABLES = '''
CREATE TABLE archive (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE jobs (
  job INTEGER PRIMARY KEY,
  what TEXT NOT NULL,           -- check, run, convert
  kadr TEXT NOT NULL,           -- version of Kadr, and the digest of its build
  machine TEXT NOT NULL,        -- id of the machine, or the digest of its file
  setup TEXT NOT NULL,          -- the set-up as JSON; empty: none
  options TEXT NOT NULL,        -- other options that decide the result, as JSON
  UNIQUE (what, kadr, machine, setup, options));
CREATE TABLE runs (
  run INTEGER PRIMARY KEY,
  job INTEGER NOT NULL REFERENCES jobs,
  begun REAL NOT NULL,          -- seconds since 1970
  ended REAL,                   -- NULL: interrupted
  sources TEXT NOT NULL         -- folders, zip files and lists, a JSON list
  );
CREATE TABLE places (
  place INTEGER PRIMARY KEY,
  source TEXT NOT NULL,         -- folder or zip file; of a list its name
  folder TEXT NOT NULL,         -- folder of the program within the source, ends in /; empty: the source itself
  name TEXT NOT NULL,
  size INTEGER NOT NULL,
  stamp INTEGER NOT NULL,       -- time of the last change of content or file, ns; in a zip file the checksum; 0: the content is read again next time
  content BLOB,                 -- SHA-256 of the bytes; NULL: unreadable
  fault TEXT,                   -- why it is unreadable
  asked TEXT NOT NULL,          -- control that the user or .kadr.toml names; empty: Kadr guesses it from the text
  since INTEGER NOT NULL,       -- first run that saw this content here
  until INTEGER                 -- first run that did not; NULL: it is still there
  );
CREATE UNIQUE INDEX places_now ON places (source, folder, name) WHERE until IS NULL;
CREATE INDEX places_content ON places (content);
CREATE TABLE folders (
  source TEXT NOT NULL,
  folder TEXT NOT NULL,
  since INTEGER NOT NULL,       -- as in places
  until INTEGER,
  memory BLOB NOT NULL,         -- SHA-256 of the names and contents of the folder's programs
  PRIMARY KEY (source, folder, since)) WITHOUT ROWID;
CREATE TABLE results (
  result INTEGER PRIMARY KEY,
  job INTEGER NOT NULL REFERENCES jobs,
  content BLOB NOT NULL,
  asked TEXT NOT NULL,
  memory BLOB NOT NULL,         -- folders.memory, if the program calls files of its folder; empty: it calls none
  control TEXT NOT NULL,        -- the control that was used; empty: none was found
  state TEXT NOT NULL,          -- ok, alarm, unknown, refused, time, memory, killed
  alarms INTEGER NOT NULL,
  warnings INTEGER NOT NULL,
  advices INTEGER NOT NULL,
  reason TEXT NOT NULL,         -- for unknown, refused, time, memory, killed
  seconds REAL,                 -- run: machining time, s
  summary TEXT,                 -- run: the summary as `kadr run --json` prints it
  output BLOB,                  -- convert: the new program
  UNIQUE (job, content, asked, memory));
CREATE TABLE findings (
  result INTEGER NOT NULL REFERENCES results,
  number INTEGER NOT NULL,      -- from 1, in the order in which Kadr reports them
  severity TEXT NOT NULL,       -- alarm, warning, advice, note
  id TEXT NOT NULL,
  file TEXT NOT NULL,           -- empty: the program itself; otherwise the called file
  line INTEGER NOT NULL,
  "column" INTEGER NOT NULL,
  block TEXT NOT NULL,
  alarm TEXT NOT NULL,          -- the control's own number
  text TEXT NOT NULL,
  hint TEXT NOT NULL,
  PRIMARY KEY (result, number)) WITHOUT ROWID;
CREATE INDEX findings_id ON findings (id);
CREATE TABLE tools (
  result INTEGER NOT NULL REFERENCES results,
  tool INTEGER NOT NULL,
  cutting REAL NOT NULL,        -- s
  PRIMARY KEY (result, tool)) WITHOUT ROWID;
CREATE VIEW present AS          -- every program that is there now, with its last result of each job
  SELECT p.place, p.source, p.folder, p.name, p.size, p.fault, r.job, j.what, j.machine, r.result, r.control, r.state, r.alarms, r.warnings,
         r.advices, r.reason, r.seconds
  FROM places p
  LEFT JOIN folders f ON f.source = p.source AND f.folder = p.folder AND f.until IS NULL
  LEFT JOIN results r ON r.content = p.content AND r.asked = p.asked AND (r.memory = x'' OR r.memory = f.memory)
  LEFT JOIN jobs j ON j.job = r.job
  WHERE p.until IS NULL;
'''

# a result counts for a place if both have the same content and control, and the called files are the same
OF_PLACE = "r.job = :job AND r.content = p.content AND r.asked = p.asked AND (r.memory = x'' OR r.memory = f.memory)"
WITH_RESULT = f'LEFT JOIN folders f ON f.source = p.source AND f.folder = p.folder AND f.until IS NULL LEFT JOIN results r ON {OF_PLACE}'


class WrongFile(Exception):
    """The file is not an archive of this version."""


class Store:
    """The SQLite file."""

    def __init__(self, file: Path, *, new: bool = True) -> None:
        if not new and not file.is_file():
            raise WrongFile(f'{file}: no such file')
        self.file = file
        try:
            self.db = sqlite3.connect(file, isolation_level=None, timeout=60)
            self.db.execute('PRAGMA journal_mode = WAL')
            self.db.execute('PRAGMA synchronous = NORMAL')   # a power cut may lose the last batches, but never damages the file
            self.db.execute('PRAGMA cache_size = -16000')
            self._open()
        except sqlite3.DatabaseError as error:
            raise WrongFile(f'{file}: {error}') from None

    def _tables(self) -> set[str]:
        return {name for name, in self.db.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}

    def _open(self) -> None:
        tables = self._tables()
        if not tables:
            with self.changes():
                if not self._tables():   # another client may have made them meanwhile
                    for statement in TABLES.split(';\n'):
                        if statement.strip():
                            self.db.execute(statement)
                    self.db.execute('INSERT INTO archive VALUES (?, ?)', ('version', str(VERSION)))
            tables = self._tables()
        if 'archive' not in tables:
            raise WrongFile(f'{self.file}: an SQLite file, but not one of kadr-archive')
        version, = self.db.execute("SELECT value FROM archive WHERE key = 'version'").fetchone()
        if version != str(VERSION):
            raise WrongFile(f'{self.file}: version {version} of the tables; this program reads {VERSION}')

    def changes(self) -> Transaction:
        """Returns a context: its changes are kept together or not at all."""
        return Transaction(self.db)

    def rows(self, query: str, values: Any = ()) -> Iterator[tuple[Any, ...]]:
        return self.db.execute(query, values)

    def one(self, query: str, values: Any = ()) -> Any:
        row = self.db.execute(query, values).fetchone()
        return None if row is None else row[0]

    def close(self) -> None:
        self.db.close()

    # ---- jobs and runs

    def job(self, what: str, kadr: str, machine: str, setup: str, options: dict[str, Any]) -> int:
        """Returns the number of the job. All that decides a result, except the program and its control, is in its key."""
        key = (what, kadr, machine, setup, json.dumps(options, sort_keys=True))
        with self.changes():
            self.db.execute('INSERT OR IGNORE INTO jobs (what, kadr, machine, setup, options) VALUES (?, ?, ?, ?, ?)', key)
        return self.one('SELECT job FROM jobs WHERE what = ? AND kadr = ? AND machine = ? AND setup = ? AND options = ?', key)

    def begin(self, job: int, sources: Iterable[str]) -> int:
        with self.changes():
            made = self.db.execute('INSERT INTO runs (job, begun, sources) VALUES (?, ?, ?)', (job, time.time(), json.dumps(list(sources))))
        return int(made.lastrowid or 0)

    def end(self, run: int) -> None:
        with self.changes():
            self.db.execute('UPDATE runs SET ended = ? WHERE run = ?', (time.time(), run))

    def last_run(self, run: Optional[int] = None, what: Optional[str] = None) -> Optional[tuple[int, int, str]]:
        """Returns (run, job, sources) of a run: by default of the last one."""
        where = 'r.run = :run' if run is not None else 'j.what = :what' if what else '1'
        return self.db.execute(f'SELECT r.run, r.job, r.sources FROM runs r JOIN jobs j USING (job) WHERE {where} ORDER BY r.run DESC LIMIT 1',
                               {'run': run, 'what': what}).fetchone()

    # ---- results

    def add(self, job: int, results: Iterable[dict[str, Any]]) -> int:
        """Keeps results in one transaction. A result that is there already is passed over. Returns how many are new."""
        new = 0
        with self.changes():
            for of in results:
                made = self.db.execute(
                    'INSERT OR IGNORE INTO results (job, content, asked, memory, control, state, alarms, warnings, advices, reason, seconds, summary,'
                    ' output) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)',
                    (job, of['content'], of['asked'], of['memory'], of['control'], of['state'], of['alarms'], of['warnings'], of['advices'],
                     of['reason'], of.get('seconds'), of.get('summary'), of.get('output')))
                if made.rowcount != 1:
                    continue
                new += 1
                result = made.lastrowid
                self.db.executemany('INSERT INTO findings VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)',
                                    ((result, i, *finding) for i, finding in enumerate(of['findings'], 1)))
                self.db.executemany('INSERT INTO tools VALUES (?, ?, ?)', ((result, tool, s) for tool, s in of.get('tools', ())))
        return new

    def forget(self, job: int, states: Iterable[str]) -> None:
        """Removes results of these states, so that they are computed again."""
        with self.changes():
            for state in states:
                which = 'SELECT result FROM results WHERE job = ? AND state = ?'
                self.db.execute(f'DELETE FROM findings WHERE result IN ({which})', (job, state))
                self.db.execute(f'DELETE FROM tools WHERE result IN ({which})', (job, state))
                self.db.execute('DELETE FROM results WHERE job = ? AND state = ?', (job, state))


class Transaction:
    """BEGIN IMMEDIATE … COMMIT; ROLLBACK if an exception leaves the context."""

    def __init__(self, db: sqlite3.Connection) -> None:
        self.db = db

    def __enter__(self) -> None:
        self.db.execute('BEGIN IMMEDIATE')

    def __exit__(self, kind: Any, *_: Any) -> None:
        self.db.execute('ROLLBACK' if kind else 'COMMIT')
