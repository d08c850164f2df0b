#!/usr/bin/env python3
"""Tests that `kadr check` and the page's check report the same list for the same text: (id, line, column), in the same order. It covers the
examples and the faulty programs (tests/faulty), each with its set-up if it has one. Not covered: programs that need options which a page
does not have, and files with several programs, of which a page shows one.

    same_check.py --kadr PROGRAM [--only 'nct/*'] [--every N]

Each example is also checked with a line removed and with a setting switched off, so that no list can come from an earlier check.
"""
import fnmatch
import json
import shutil
import tempfile
from pathlib import Path

import harness
from commands.programs import CONTROLS, EXAMPLES, PROGRAMS
from page_client.client import Page, Server, result, tally
from run_faulty import ROOT as FAULTY
from run_faulty import Expected

EVERY = 5   # every 5th faulty program, so that the test needs some ten seconds of processor time


def of_examples():
    """Yields (name, path, control, its set-up or '')."""
    for control in CONTROLS:
        for path in sorted((EXAMPLES / control).glob('*')):
            if path.suffix in PROGRAMS and path.suffix != '.tape':
                beside = path.with_suffix('.json')
                yield f'{control}/{path.name}', path, control, beside.name if beside.exists() else ''


def of_faulty():
    for control in CONTROLS:
        for path in sorted((FAULTY / control).glob('*.nc')):
            words = Expected(path.with_suffix('.expect')).args
            if not words or (len(words) == 2 and words[0] == '--setup'):
                yield f'faulty/{control}/{path.name}', path, control, words[1] if words else ''


def by_command(kadr, file, control, setup):
    done = harness.Kadr(kadr, file.parent).call('check', file.name, '--control', control, '--lang', 'en', '--format', 'json', *(['--setup', setup] if setup else []))
    return [(f['id'], f['line'], f['column']) for f in json.loads(done.stdout)]


def by_page(page, folder, file, control, setup, text=None):
    """Returns the page's findings for the file's text, or for another text in the editor."""
    beneath = file.relative_to(folder).as_posix()
    opened, _ = page.open(beneath, control=control, **({'setup': str(Path(beneath).parent / setup)} if setup else {}))
    if 'error' in opened:
        return opened['error']['text']
    answer = page.ask('check', text=opened['text'] if text is None else text)
    return [(p['id'], p['line'], p['column']) for p in answer['problems']] if 'problems' in answer else answer['error']['text']


def several(file, control):
    """True if the tape has several programs, between signs %."""
    return control in ('s2c42', 'gost', 'correctors') and file.read_bytes().count(b'%') > 1


def compare(kadr, page, folder, name, file, control, setup):
    tally.same(name, by_page(page, folder, file, control, setup), by_command(kadr, file, control, setup))


def without_a_line(kadr, page, folder, name, file, control, setup):
    """The editor's text differs from the file's: a line in the middle is missing."""
    lines = file.read_bytes().split(b'\n')
    try:
        text = b'\n'.join(lines[:len(lines) // 2] + lines[len(lines) // 2 + 1:]).decode('utf-8')
    except UnicodeDecodeError:
        return  # the page's text is always UTF-8, the file's bytes would differ
    shown = by_page(page, folder, file, control, setup, text)
    file.write_text(text, encoding='utf-8', newline='')
    tally.same(f'{name} without a line', shown, by_command(kadr, file, control, setup))


def switched_off(kadr, page, folder, name, file, control, setup):
    """Neither of them reports what a set-up disables."""
    told = by_command(kadr, file, control, setup)
    if not told:
        return
    path = file.with_name('off.json')
    path.write_text(json.dumps({**(json.loads((file.parent / setup).read_text()) if setup else {}), 'disable': [told[-1][0]]}))
    compare(kadr, page, folder, f'{name} without {told[-1][0]}', file, control, path.name)


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--only', default='*', help="programs of that name, e.g. 'nct/*'")
    parser.add_argument('--every', type=int, default=EVERY, help='runs every Nth faulty program')
    options = harness.parsed(parser)
    programs = [p for p in [*of_examples(), *list(of_faulty())[::options.every]] if fnmatch.fnmatch(p[0], options.only)]
    if not programs:
        parser.error('nothing has that name')
    with tempfile.TemporaryDirectory(prefix='kadr-check-') as place:
        folder = Path(place).resolve()
        shutil.copytree(EXAMPLES, folder / 'examples')
        shutil.copytree(FAULTY, folder / 'faulty')
        server = Server(options.kadr, folder)
        page = Page(server)
        page.ask('hello', token=server.token, lang='en')
        for name, path, control, setup in programs:
            file = folder / ('faulty' if FAULTY in path.parents else 'examples') / control / path.name
            if several(file, control):
                continue
            compare(options.kadr, page, folder, name, file, control, setup)
            if FAULTY not in path.parents:
                switched_off(options.kadr, page, folder, name, file, control, setup)
                without_a_line(options.kadr, page, folder, name, file, control, setup)
        server.end()
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
