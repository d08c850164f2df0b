"""What is done with one program: Kadr itself does it, by its module or its program."""
from __future__ import annotations

import contextlib
import hashlib
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple, Optional

import kadr
from kadr import _kadr

CALLS = {'program_missing', 'file_missing', 'subprogram_missing'}   # findings after which the folder decides what the program does
MOST_TEXT = 2000                                                    # characters of a text that is kept of a finding


@dataclass(frozen=True)
class Job:
    """All that decides a result, except the program, its control and the files that it calls."""

    what: str                    # check, run, convert
    machine: str = 'generic'     # id, or the text of a machine file
    setup: str = ''              # JSON
    to: str = ''                 # convert: the other control
    controls: dict[str, str] = field(default_factory=dict)   # key of an own control: text of its file
    most_seconds: float = 60
    most_bytes: int = 2 << 30
    build: str = ''              # version and digest of the client's build; empty: any


class Item(NamedTuple):
    """A program to work on."""

    content: bytes               # its digest
    asked: str
    memory: bytes                # digest of its folder
    name: str                    # of the file
    path: Optional[str]          # where the file is, if the workers see it
    text: Optional[bytes]        # its bytes; None: read them from `path`
    folder: dict[str, bytes]     # the programs that it may call, if the workers do not see them
    alone: bool = False          # the worker sees no folder: a program that calls others is sent again, with its folder


def build() -> str:
    """Returns the version of Kadr and the digest of its extension: two builds of a version may differ."""
    return f'{kadr.__version__}+{hashlib.sha256(Path(_kadr.__file__).read_bytes()).hexdigest()[:12]}'


def kadr_program() -> str:
    """Returns the path of the program `kadr`: $KADR, next to this package's build, or in the PATH."""
    named = os.environ.get('KADR')
    near = Path(_kadr.__file__).resolve().parents[2] / 'kadr'
    found = named or (str(near) if near.is_file() else shutil.which('kadr'))
    if not found:
        raise FileNotFoundError('the program kadr was not found: set KADR, or install it')
    return found


def result(item: Item, state: str, reason: str = '', control: str = '', **more: Any) -> dict[str, Any]:
    """Returns a result as Store.add() keeps it. `memory` is empty until the program has called another file."""
    return {'content': item.content, 'asked': item.asked, 'memory': b'', 'control': control, 'state': state, 'alarms': 0, 'warnings': 0, 'advices': 0,
            'reason': reason[:MOST_TEXT], 'findings': [], **more}


def prefix_of(process: int) -> str:
    """Returns how the names of a process's temporary folders begin."""
    return f'kadr-archive-{process}-'


def remove_folders(process: int) -> None:
    """Removes the temporary folders that a killed process has left."""
    for left in Path(tempfile.gettempdir()).glob(f'{prefix_of(process)}*'):
        shutil.rmtree(left, ignore_errors=True)


def done(item: Item, job: Job) -> dict[str, Any]:
    """Does the job with a program and returns the result."""
    text = item.text
    if text is None:
        try:
            text = Path(item.path or '').read_bytes()
        except OSError as error:
            return result(item, 'changed', str(error))
        if hashlib.sha256(text).digest() != item.content:
            return result(item, 'changed', 'the file has changed since it was found')
    needs_files = item.folder or not item.path or '\n' in job.machine or item.asked in job.controls or job.what != 'check'
    with tempfile.TemporaryDirectory(prefix=prefix_of(os.getpid())) if needs_files else contextlib.nullcontext('/nowhere') as folder:
        asked, machine = _files_of(item, job, folder)
        name = item.path or f'{folder}/memory/{item.name}'
        if item.folder or not item.path:
            _write_memory(item, Path(folder, 'memory'))
        try:
            spec = _kadr.Spec(file=os.fsencode(name), text=text, control=asked, machine=machine, setup_file=b'', setup_json=job.setup, lang='en')
        except kadr.Error as error:
            return result(item, 'refused' if asked else 'unknown', _without(str(error), name, folder))
        of = DO[job.what](item, job, spec, _Place(name, folder, text, asked or spec.control, machine))
        of['control'] = spec.control
        of['lonely'] = item.alone and bool(of['memory'])
        return of


class _Place(NamedTuple):
    name: str       # under which the program's text is known
    folder: str     # temporary
    text: bytes
    control: str
    machine: str


def _files_of(item: Item, job: Job, folder: str) -> tuple[str, str]:
    """Writes an own control and an own machine to files. Returns what names them."""
    asked, machine = item.asked, job.machine
    if asked in job.controls:
        asked = f'{folder}/{asked.rpartition(":")[0]}'
        Path(asked).write_text(job.controls[item.asked], encoding='utf-8')
    if '\n' in machine:
        machine = f'{folder}/machine.toml'
        Path(machine).write_text(job.machine, encoding='utf-8')
    return asked, machine


def _write_memory(item: Item, folder: Path) -> None:
    folder.mkdir()
    for name, content in item.folder.items():
        if '/' not in name and name not in ('', '.', '..'):
            (folder / name).write_bytes(content)


def _without(text: str, name: str, folder: str) -> str:
    """Removes the places of this computer from a text: the same program has the same result everywhere."""
    for place in (name, f'{folder}/memory/', f'{folder}/', os.path.dirname(name) + '/'):
        text = text.replace(f'{place}: ', '') if place == name else text.replace(place, '')
    return text.replace(name, os.path.basename(name))


def _finding(of: dict[str, Any], place: _Place) -> tuple[Any, ...]:
    file = '' if of['file'] == place.name else os.path.basename(of['file'])
    text, hint = (_without(of[key], place.name, place.folder)[:MOST_TEXT] for key in ('text', 'hint'))
    return of['severity'], of['id'], file, of['line'], of['column'], of['block'], of['number'], text, hint


def _check(item: Item, job: Job, spec: Any, place: _Place) -> dict[str, Any]:
    try:
        findings, files = spec.check_file()
    except kadr.Error as error:
        return result(item, 'refused', _without(str(error), place.name, place.folder))
    counts = [sum(of['severity'] == severity for of in findings) for severity in ('alarm', 'warning', 'advice')]
    of = result(item, 'alarm' if counts[0] else 'ok', findings=[_finding(of, place) for of in findings])
    of['alarms'], of['warnings'], of['advices'] = counts
    if files or any(f['id'] in CALLS for f in findings):
        of['memory'] = item.memory
    return of


def _command(job: Job, place: _Place, *arguments: str) -> subprocess.CompletedProcess[bytes]:
    """Runs the program kadr on the program. It reads the file where it is, or a copy in the temporary folder."""
    file = place.name
    if not _is(file, place.text):
        os.makedirs(f'{place.folder}/copy')
        file = f'{place.folder}/copy/{os.path.basename(place.name)}'
        Path(file).write_bytes(place.text)
    if job.setup:
        setup = f'{place.folder}/setup.json'
        Path(setup).write_text(job.setup, encoding='utf-8')
        arguments += ('--setup', setup)
    memory = os.path.dirname(place.name)
    if file != place.name and os.path.isdir(memory):
        for other in os.scandir(memory):
            if other.name != os.path.basename(file) and other.is_file():
                os.symlink(os.path.abspath(other.path), f'{place.folder}/copy/{other.name}')
    seconds = int(job.most_seconds) + 1   # if the child dies, this process does not run endlessly
    return subprocess.run([kadr_program(), arguments[0], file, *arguments[1:], '--machine', place.machine, '--lang', 'en'], capture_output=True,
                          stdin=subprocess.DEVNULL, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5)))


def _is(file: str, text: bytes) -> bool:
    try:
        return Path(file).read_bytes() == text
    except OSError:
        return False


ALARM = re.compile(r'^(?P<file>.*?):(?P<line>\d+):(?P<column>\d+): (?P<severity>alarm|warning) (?P<id>[a-z0-9_]+): (?P<text>.*)$')


def _run(item: Item, job: Job, spec: Any, place: _Place) -> dict[str, Any]:
    """Times, tools and extents are those of `kadr run --json`; the findings are those of the run, not of a check."""
    ran = _command(job, place, 'run', '--control', place.control, '--json')
    said = _without(ran.stderr.decode('utf-8', 'replace'), place.name, place.folder)
    if ran.returncode not in (0, 1):
        return _failed(item, job, ran.returncode, said)
    summary = json.loads(ran.stdout)
    summary['program'] = item.name
    channels = summary['channels']
    of = result(item, 'ok' if summary['complete'] else 'alarm', seconds=summary['machining_time'], summary=json.dumps(summary, separators=(',', ':')))
    of['alarms'] = sum(channel['alarms'] for channel in channels)
    of['warnings'] = sum(channel['warnings'] for channel in channels)
    tools: dict[int, float] = {}
    for use in (use for channel in channels for use in channel['tools'] if isinstance(use['tool'], int)):
        tools[use['tool']] = tools.get(use['tool'], 0) + (use['cutting'] or 0)
    of['tools'] = sorted(tools.items())
    found = [match for match in map(ALARM.match, said.splitlines()) if match]
    of['findings'] = [(f['severity'], f['id'], '', int(f['line']), int(f['column']), '', '', f['text'][:MOST_TEXT], '') for f in found]
    of['memory'] = item.memory if _calls(spec) else b''
    return of


def _convert(item: Item, job: Job, spec: Any, place: _Place) -> dict[str, Any]:
    """The new program is the one that `kadr convert` has proven; a refusal has its reason."""
    converted = _command(job, place, 'convert', '--from', place.control, '--to', job.to)
    said = _without(converted.stderr.decode('utf-8', 'replace'), place.name, place.folder)
    if converted.returncode not in (0, 1):
        return _failed(item, job, converted.returncode, said)
    of = result(item, 'ok' if converted.returncode == 0 else 'alarm', '' if converted.returncode == 0 else said.removeprefix('kadr: '),
                output=converted.stdout if converted.returncode == 0 else None)
    of['alarms'] = converted.returncode
    of['memory'] = item.memory if _calls(spec) else b''
    return of


def _failed(item: Item, job: Job, code: int, said: str) -> dict[str, Any]:
    if code < 0:
        if -code == signal.SIGXCPU:
            return result(item, 'time', f'longer than {job.most_seconds:g} s')
        os.kill(os.getpid(), -code)   # the process did not survive the program: its parent counts it
    return result(item, 'refused', said.removeprefix('kadr: '))


def _calls(spec: Any) -> bool:
    """Returns whether the program calls files of its folder, or wants to."""
    findings, files = spec.check_file()
    return bool(files) or any(of['id'] in CALLS for of in findings)


DO = {'check': _check, 'run': _run, 'convert': _convert}
