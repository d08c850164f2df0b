"""Finds the programs of an archive: in folders, zip files and lists. Reads only what has changed since the last run."""
from __future__ import annotations

import fnmatch
import hashlib
import os
import stat
import time
import zipfile
import zlib
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable, Iterator, NamedTuple, Optional, Union

from kadr import _kadr

from . import texts
from .store import Store

MOST_BYTES = 256 << 20    # a longer file is no part program that a control could load
FRESH_NS = 2_000_000_000  # a file that changed so shortly before may change again within the same time stamp
WHY_LONG = f'longer than {MOST_BYTES >> 20} MB'


class Entry(NamedTuple):
    """A file of an archive, before its content is known."""

    name: str
    size: int
    stamp: int
    read: Callable[[], bytes]


class Content(NamedTuple):
    """What is stored of a place."""

    size: int
    stamp: int
    content: Optional[bytes]
    fault: Optional[str]
    asked: str


@dataclass
class Choice:
    """Which files are taken, and which control they have."""

    exclude: list[str] = field(default_factory=list)
    control: str = ''
    control_for: list[tuple[str, str]] = field(default_factory=list)
    named: Callable[[str], str] = lambda control: control   # the key of a control: its id, or the digest of its file
    remembered: _kadr.Remembered = field(default_factory=_kadr.Remembered)

    def takes(self, path: str) -> bool:
        return not any(like(path, pattern) for pattern in self.exclude)

    def asked(self, path: str, on_disk: Optional[str]) -> str:
        """Returns the control that the command line or .kadr.toml names for a program; empty: Kadr guesses it from the text."""
        for pattern, control in self.control_for:
            if like(path, pattern):
                return self.named(control)
        if self.control:
            return self.named(self.control)
        return self.named(self.remembered.of(os.fsencode(on_disk))) if on_disk else ''


def like(path: str, pattern: str) -> bool:
    """As `--exclude` of kadr check: the pattern is a path relative to the folder, or a name."""
    return fnmatch.fnmatchcase(path, pattern) or fnmatch.fnmatchcase(path.rpartition('/')[2], pattern)


LOST = {byte: 0xF700 + byte - 0xDC00 for byte in range(0xDC80, 0xDD00)}   # bytes of names that are no UTF-8: SQLite stores text only
FOUND = {text: byte for byte, text in LOST.items()}


def as_text(name: str) -> str:
    return name if name.isascii() else name.translate(LOST)


def as_path(name: str) -> str:
    return name if name.isascii() else name.translate(FOUND)


def stamp_of(file: os.stat_result) -> int:
    """Returns the time of the last change, ns: of the content, or of the file itself, which a copy with the old time replaces."""
    return max(file.st_mtime_ns, file.st_ctime_ns)


def digest(content: bytes) -> bytes:
    return hashlib.sha256(content).digest()


# ---- the kinds of sources: each yields (folder, entries)

class Folder:
    """A folder with all its sub-folders. Links to folders are not followed; hidden files are passed over."""

    def __init__(self, path: Path) -> None:
        self.name = str(path.resolve())
        self.faults: list[str] = []
        self.lost: list[str] = []   # folders that could not be read: nothing is known of their programs

    def folders(self) -> Iterator[tuple[str, list[Entry]]]:
        waiting = ['']
        while waiting:
            folder = waiting.pop()
            entries, below = [], []
            try:
                with os.scandir(os.path.join(self.name, as_path(folder))) as found:
                    for at in found:
                        if at.name.startswith('.'):
                            continue
                        if at.is_dir(follow_symlinks=False):
                            below.append(f'{folder}{as_text(at.name)}/')
                        elif at.is_file():
                            of = at.stat()
                            entries.append(Entry(as_text(at.name), of.st_size, stamp_of(of), lambda path=at.path: Path(path).read_bytes()))
            except OSError as error:
                self.faults.append(texts.reason(error))
                self.lost.append(folder)
                continue
            waiting += sorted(below, reverse=True)
            yield folder, sorted(entries)

    def on_disk(self, folder: str, name: str) -> Optional[str]:
        return os.path.join(self.name, as_path(folder + name))

    def read(self, folder: str, name: str) -> bytes:
        return Path(self.name, as_path(folder + name)).read_bytes()

    def close(self) -> None:
        pass


class Zip:
    """A zip file. A member counts as unchanged if its checksum and its size are the same."""

    def __init__(self, path: Path) -> None:
        self.name = str(path.resolve())
        self.faults: list[str] = []
        self.lost: list[str] = []
        try:
            self.zip = zipfile.ZipFile(path)
        except (zipfile.BadZipFile, NotImplementedError) as error:
            raise OSError(f'{path}: {error}') from None

    def folders(self) -> Iterator[tuple[str, list[Entry]]]:
        by_folder: dict[str, dict[str, Entry]] = {}
        for of in self.zip.infolist():
            folder, _, name = of.filename.rpartition('/')
            hidden = any(part.startswith('.') for part in of.filename.split('/'))
            if of.is_dir() or hidden:
                continue
            folder += '/' if folder else ''
            by_folder.setdefault(folder, {})[name] = Entry(name, of.file_size, of.CRC + 1, lambda of=of: self._content(of))
        for folder in sorted(by_folder):
            yield folder, [by_folder[folder][name] for name in sorted(by_folder[folder])]

    def _content(self, of: zipfile.ZipInfo) -> bytes:
        try:
            with self.zip.open(of) as member:
                content = member.read(MOST_BYTES + 1)   # the size in the directory may be wrong, on purpose too
        except (zipfile.BadZipFile, RuntimeError, NotImplementedError, EOFError, zlib.error) as error:
            raise OSError(f'{of.filename}: {error}') from None
        if len(content) > MOST_BYTES:
            raise OSError(f'{of.filename}: {WHY_LONG}')
        return content

    def on_disk(self, folder: str, name: str) -> Optional[str]:
        return None

    def read(self, folder: str, name: str) -> bytes:
        return self._content(self.zip.getinfo(folder + name))

    def close(self) -> None:
        self.zip.close()


class List:
    """A text file with the path of a program in each line, relative to the list's folder; empty lines and lines with # are passed over."""

    def __init__(self, path: Path) -> None:
        self.name = str(path.resolve())
        self.root = path.resolve().parent
        self.faults: list[str] = []
        self.lost: list[str] = []
        lines = path.read_text(encoding='utf-8', errors='surrogateescape').splitlines()
        self.files = sorted({os.path.normpath(line.strip()) for line in lines if line.strip() and not line.startswith('#')})

    def folders(self) -> Iterator[tuple[str, list[Entry]]]:
        by_folder: dict[str, list[Entry]] = {}
        for file in self.files:
            folder, name = os.path.split(file)
            path = self.root / file
            try:
                of = path.stat()
                if not stat.S_ISREG(of.st_mode):
                    raise OSError(f'{path}: no regular file')
            except OSError as error:
                self.faults.append(texts.reason(error))
                continue
            by_folder.setdefault(as_text(f'{folder}/' if folder else ''), []).append(Entry(as_text(name), of.st_size, stamp_of(of), path.read_bytes))
        yield from sorted(by_folder.items())

    def on_disk(self, folder: str, name: str) -> Optional[str]:
        return str(self.root / as_path(folder + name))

    def read(self, folder: str, name: str) -> bytes:
        return (self.root / as_path(folder + name)).read_bytes()

    def close(self) -> None:
        pass


Source = Union[Folder, Zip, List]


def source_of(path: Path) -> Source:
    """Opens a folder, a zip file or a list. Raises OSError or ValueError with a sentence for people."""
    if path.is_dir():
        return Folder(path)
    if not path.exists():
        raise OSError(f'{path}: no such file or folder')
    if zipfile.is_zipfile(path):
        return Zip(path)
    with open(path, 'rb') as beginning:
        if b'\0' in beginning.read(4096):
            raise ValueError(f'{path}: neither a folder, nor a zip file, nor a list of programs')
    return List(path)


def is_program_name(name: str) -> bool:
    return bool(_kadr.name_verdict(os.fsencode(as_path(name))) != 'other')


# ---- what has changed

class Scan:
    """Brings the table `places` up to date with a source, a folder at a time."""

    def __init__(self, store: Store, run: int, choice: Choice, seen: Callable[[int], None], stop: Callable[[], bool]) -> None:
        self.store = store
        self.run = run
        self.choice = choice
        self.seen = seen
        self.stop = stop

    def take(self, source: Source) -> None:
        """Reads the source. Folders that are not there any more are closed at the end; those that cannot be read are left as they were."""
        known = {folder for folder, in self.store.rows('SELECT DISTINCT folder FROM places WHERE source = ? AND until IS NULL', (source.name,))}
        waiting: list[tuple[str, list[Entry]]] = []
        for folder, entries in source.folders():
            known.discard(folder)
            waiting.append((folder, entries))
            if sum(len(of) for _, of in waiting) >= 2000:   # many small folders share a transaction
                self._take_folders(source, waiting)
                waiting = []
            if self.stop():
                return
        self._take_folders(source, waiting)
        known = {folder for folder in known if not any(folder.startswith(lost) for lost in source.lost)}
        with self.store.changes():
            for folder in known:
                self._take_folder(source, folder, [])

    def _take_folders(self, source: Source, waiting: list[tuple[str, list[Entry]]]) -> None:
        with self.store.changes():
            for folder, entries in waiting:
                self._take_folder(source, folder, entries)

    def _take_folder(self, source: Source, folder: str, entries: list[Entry]) -> None:
        db = self.store.db
        before = {name: Content(*of) for name, *of in db.execute(
            'SELECT name, size, stamp, content, fault, asked FROM places WHERE source = ? AND folder = ? AND until IS NULL', (source.name, folder))}
        changed = False
        for entry in entries:
            path = folder + entry.name
            if not is_program_name(entry.name) or not self.choice.takes(path):
                continue
            old = before.pop(entry.name, None)
            asked = self.choice.asked(path, source.on_disk(folder, entry.name))
            if old and old.fault is None and (old.size, old.stamp, old.asked) == (entry.size, entry.stamp, asked):
                self.seen(1)
                continue
            new = self._content(entry, asked)
            self.seen(1)
            if old and (old.content, old.fault, old.asked) == (new.content, new.fault, new.asked):
                db.execute('UPDATE places SET size = ?, stamp = ? WHERE source = ? AND folder = ? AND name = ? AND until IS NULL',
                           (new.size, new.stamp, source.name, folder, entry.name))
                continue
            changed = True
            self._close(source, folder, entry.name)
            db.execute('INSERT INTO places (source, folder, name, size, stamp, content, fault, asked, since) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)',
                       (source.name, folder, entry.name, *new, self.run))
        for name in before:
            changed = True
            self._close(source, folder, name)
        if changed:
            self._remember_folder(source, folder)

    def _content(self, entry: Entry, asked: str) -> Content:
        try:
            if entry.size > MOST_BYTES:
                raise OSError(WHY_LONG)
            content = entry.read()
        except OSError as error:
            return Content(entry.size, 0, None, texts.reason(error), asked)
        stamp = 0 if entry.stamp > time.time_ns() - FRESH_NS or len(content) != entry.size else entry.stamp
        return Content(len(content), stamp, digest(content), None, asked)

    def _close(self, source: Source, folder: str, name: str) -> None:
        where = 'source = ? AND folder = ? AND name = ? AND until IS NULL'
        # seen first by this very run, which was interrupted and goes on: it never was in a state that anyone could ask for
        self.store.db.execute(f'DELETE FROM places WHERE {where} AND since = ?', (source.name, folder, name, self.run))
        self.store.db.execute(f'UPDATE places SET until = ? WHERE {where}', (self.run, source.name, folder, name))

    def _remember_folder(self, source: Source, folder: str) -> None:
        """Stores the digest of the folder's programs: results of programs that call others are valid for it only."""
        memory = hashlib.sha256()
        for name, content in self.store.rows('SELECT name, content FROM places WHERE source = ? AND folder = ? AND until IS NULL ORDER BY name',
                                             (source.name, folder)):
            memory.update(name.encode('utf-8', 'surrogateescape') + b'\0' + (content or b'') + b'\0')
        where = 'source = ? AND folder = ? AND until IS NULL'
        self.store.db.execute(f'DELETE FROM folders WHERE {where} AND since = ?', (source.name, folder, self.run))
        self.store.db.execute(f'UPDATE folders SET until = ? WHERE {where}', (self.run, source.name, folder))
        self.store.db.execute('INSERT INTO folders VALUES (?, ?, ?, NULL, ?)', (source.name, folder, self.run, memory.digest()))
