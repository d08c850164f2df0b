#!/usr/bin/env python3
"""Tests what a page may do with files: rename, copy, delete to the trash, restore, empty the trash, begin a new program, take an example; and that nothing of
this leaves the folder or replaces a file.

    serve_files.py --kadr PROGRAM
"""
import argparse
import os
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

from page_client.client import PROGRAM, Page, Server, expect, result, seen

OUTSIDE = ('../x.nc', 'sub/../../x.nc', '/tmp/x.nc', 'link/x.nc', 'uplink/x.nc', '.x.nc', '.kadr-trash/x.nc', 'sub/.x.nc', 'a\0b.nc', 'a\nb.nc', '\x1b[31m.nc', '',
           '.', '..', 'x.nc/', 'sub//x.nc')
NOT_ON_WINDOWS = ('CON.nc', 'lpt1.nc', 'a:b.nc', 'a?.nc', 'a*.nc', 'a|b.nc', 'a"b.nc', 'a<b.nc', 'a\\b.nc', ' a.nc')
NOT_NAMED_LIKE_ONE = ('x.sh', 'x.py', 'Makefile', 'key.pem', 'x.html', 'a.nc ', 'a.nc.')


def greeted(server, token=True):
    page = Page(server)
    page.ask('hello', token=server.token if token else '0' * 32, lang='en')
    return page


def all_files(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob('*')) if path.is_file() and not path.is_symlink()}


def everyday(page, folder):
    """What a user does."""
    expect(page.ask('rename', file='part.nc', to='sub/renamed.nc') == {'re': page.number}, 'rename into a folder')
    expect(not (folder / 'part.nc').exists() and (folder / 'sub/renamed.nc').read_text() == PROGRAM, 'the file has moved')
    expect('digest' in page.ask('copy', file='sub/renamed.nc', to='copy.nc') and (folder / 'copy.nc').read_text() == PROGRAM, 'copy')
    expect(page.ask('copy', file='sub/renamed.nc', to='copy.nc')['error'].get('changed'), 'a copy replaces nothing')
    expect(page.ask('rename', file='sub/renamed.nc', to='copy.nc')['error'].get('changed'), 'a new name replaces nothing')
    trash = page.ask('delete', file='sub/renamed.nc')['trash']
    expect(not (folder / 'sub/renamed.nc').exists(), 'delete')
    expect((folder / '.kadr-trash' / trash / 'sub/renamed.nc').read_text() == PROGRAM, 'the file is in the trash')
    expect('error' in page.ask('open', file=f'.kadr-trash/{trash}/sub/renamed.nc'), 'the trash is not served')
    expect(page.ask('restore', trash=trash, file='sub/renamed.nc') == {'re': page.number}, 'restore')
    expect((folder / 'sub/renamed.nc').read_text() == PROGRAM and os.listdir(folder / '.kadr-trash') == [], 'it is back, and its place in the trash is gone')
    expect('error' in page.ask('restore', trash=trash, file='sub/renamed.nc'), 'a second time there is nothing to restore')
    first, second = page.ask('delete', file='copy.nc'), None
    (folder / 'copy.nc').write_text('(another)\n')
    second = page.ask('delete', file='copy.nc')
    expect(first['trash'] != second['trash'], 'two files of one name in the trash')
    page.ask('restore', trash=first['trash'], file='copy.nc')
    expect(page.ask('restore', trash=second['trash'], file='copy.nc')['error'].get('changed'), 'restoring replaces nothing')
    expect((folder / 'copy.nc').read_text() == PROGRAM, 'the first one is back')
    expect('error' not in page.ask('rename', file='copy.nc', to='COPY.NC') and (folder / 'COPY.NC').exists(), 'its own name in capitals')
    page.ask('rename', file='COPY.NC', to='copy.nc')


def trash(page, folder):
    """What is in the trash, put back, and deleted for good."""
    listed = lambda: page.ask('trash')['entries']
    for place in listed():
        page.ask('empty_trash', trash=place['trash'])
    expect(listed() == [] and os.listdir(folder / '.kadr-trash') == [], 'each file deleted for good')
    expect(page.ask('empty_trash')['deleted'] == 0, 'an empty trash is emptied')
    for name in ('a.nc', 'sub/b.nc', 'a.nc'):
        (folder / name).write_text(PROGRAM)
        page.ask('delete', file=name)
    entries = listed()
    expect(sorted(e['file'] for e in entries) == ['a.nc', 'a.nc', 'sub/b.nc'] and all(e['size'] == len(PROGRAM.encode()) and abs(e['deleted'] - time.time()) < 600 for e in entries),
           f'what was deleted, and when: {entries}')
    expect([e['deleted'] for e in entries] == sorted((e['deleted'] for e in entries), reverse=True), 'the latest first')
    b = next(e for e in entries if e['file'] == 'sub/b.nc')
    expect('error' not in page.ask('restore', trash=b['trash'], file=b['file']) and (folder / 'sub/b.nc').exists() and len(listed()) == 2, 'one is put back')
    (folder / 'sub/b.nc').unlink()
    expect(page.ask('empty_trash', trash=entries[0]['trash']) == {'re': page.number, 'deleted': 1}, 'one is deleted for good')
    expect('error' in page.ask('empty_trash', trash=entries[0]['trash']), 'a second time it is not there')
    (folder / '.kadr-trash/notes').mkdir()
    (folder / '.kadr-trash/notes/mine.txt').write_text('x')
    inner = folder / '.kadr-trash' / listed()[0]['trash']
    os.symlink(folder / 'sub', inner / 'link')
    expect(page.ask('empty_trash')['deleted'] == 2 and listed() == [], 'all are deleted for good; of a link only the link')
    expect((folder / 'sub').is_dir() and (folder / '.kadr-trash/notes/mine.txt').exists(), 'and nothing else')
    shutil.rmtree(folder / '.kadr-trash/notes')


def seen_on_disk(page, folder):
    """The page notices what others change."""
    opened, _ = page.open('copy.nc', control='mach3')
    here = lambda **more: page.ask('digest', file='copy.nc', **more)['digest']
    expect(here() == here(known=opened['digest']) == opened['digest'], 'the digest of an unchanged file')
    (folder / 'copy.nc').write_text(PROGRAM + '(more)\n')
    changed = here(known=opened['digest'])
    expect(changed not in (None, opened['digest']), 'of a changed one')
    os.utime(folder / 'copy.nc')
    touched = here(known=changed)
    expect(touched != changed and touched.split('-')[-1] == changed.split('-')[-1], 'of a touched one: the contents are the same')
    page.ask('rename', file='copy.nc', to='moved.nc')
    expect(here() is None, 'of a missing one')
    saved = page.ask('save', file='moved.nc', text='M30\n', digest=touched)
    expect('digest' in saved and (folder / 'moved.nc').read_text() == 'M30\n', 'a renamed program is saved under its new name')
    page.ask('rename', file='moved.nc', to='copy.nc')


def attacks(page, folder, outside):
    before = all_files(folder)
    for name in OUTSIDE + NOT_ON_WINDOWS + NOT_NAMED_LIKE_ONE + ('x' * 300 + '.nc', 'ж' * 120 + '.nc', 'OTHER.NC', 'sub/x/y.nc', 'gone/x.nc'):
        for do in ('rename', 'copy'):
            expect('error' in page.ask(do, file='copy.nc', to=name), f'{do} to {name[:40]!r} is refused')
        expect('error' in page.ask('save', file=name, text='x', digest=None), f'save {name[:40]!r} is refused')
    for name in OUTSIDE + ('sub', 'link', 'filelink.nc', 'key.nc', 'fifo.nc', 'run.sh'):
        for do, more in (('rename', {'to': 'y.nc'}), ('copy', {'to': 'y.nc'}), ('delete', {})):
            expect('error' in page.ask(do, file=name, **more), f'{do} {name!r} is refused')
        expect(page.ask('digest', file=name)['digest'] is None, f'digest of {name!r}')
    for trash in ('..', '.', '', '../..', 'sub', '20260101-000000/..', '/tmp', 'a\0b'):
        expect('error' in page.ask('restore', trash=trash, file='copy.nc'), f'restore from {trash!r} is refused')
        expect(not trash or 'error' in page.ask('empty_trash', trash=trash), f'empty_trash of {trash!r} is refused')
    for name in OUTSIDE:
        expect('error' in page.ask('restore', trash='20260101-000000', file=name), f'restore {name!r} is refused')
    expect('error' in page.ask('save', file='k.nc', text='-----BEGIN PRIVATE KEY-----\nMII\n', digest=None), 'a key is no program')
    expect(all_files(folder) == before, f'nothing has changed {set(all_files(folder)) ^ set(before)}')
    expect(outside.read_text() == 'M30\n' and sorted(os.listdir(outside.parent)) == ['in', 'outside.nc'], 'nor outside of the folder')


def trash_as_link(kadr, folder, outside):
    """Somebody has put a link in the place of the trash."""
    os.symlink(outside.parent, folder / '.kadr-trash')
    server = Server(kadr, folder)
    page = greeted(server)
    expect('error' in page.ask('delete', file='copy.nc') and (folder / 'copy.nc').exists(), 'a trash that is a link is not used')
    expect('error' in page.ask('restore', trash='1', file='outside.nc'), 'nor restored from')
    expect('error' in page.ask('trash') and 'error' in page.ask('empty_trash') and outside.exists(), 'nor listed, nor emptied')
    server.end()
    (folder / '.kadr-trash').unlink()


def token(server, folder):
    page = greeted(server, token=False)
    before = all_files(folder)
    for do, more in (('rename', {'file': 'copy.nc', 'to': 'z.nc'}), ('copy', {'file': 'copy.nc', 'to': 'z.nc'}), ('delete', {'file': 'copy.nc'}),
                     ('restore', {'trash': '1', 'file': 'copy.nc'}), ('empty_trash', {}), ('take_example', {'name': 'cut/plate.nc'})):
        expect('error' in page.ask(do, **more), f'{do} without the token')
    expect(all_files(folder) == before, 'and nothing has changed')


def machine_on(page, folder):
    page.ask('machine', file='copy.nc', control='mach3')
    expect('error' in page.ask('rename', file='copy.nc', to='z.nc') and 'error' in page.ask('delete', file='copy.nc'), 'the program of a machine that is on stays')
    page.ask('press', key='off')
    expect('error' not in page.ask('rename', file='copy.nc', to='z.nc') and 'error' not in page.ask('rename', file='z.nc', to='copy.nc'), 'until it is off')


def beginnings(page, controls, folder):
    """A new program of each control runs without an alarm; each example runs to its end."""
    for control in controls:
        text = page.ask('new_program', control=control)['text']
        page.ask('save', file=f'new_{control}.nc', text=text, digest=None)
        _, done = page.open(f'new_{control}.nc', control=control)
        found = page.ask('check', text=text)['problems']
        expect(done['state'] == 'ended' and not found, f'a new program of {control}: {text!r} {found}')
    expect('error' in page.ask('new_program', control='../x') and 'error' in page.ask('new_program', control='none'), 'of an unknown control')
    examples = page.ask('examples')['examples']
    expect(len(examples) >= 6 and all(e['title'] for e in examples), 'examples')
    for example in examples:
        taken = {k: v for k, v in page.ask('take_example', name=example['name']).items() if k != 're'}
        _, done = page.open(taken.pop('file'), **taken)
        expect(done['state'] == 'ended', f'{example["name"]} runs to its end')
    mine = folder / 'kadr-examples/plate.nc'
    mine.write_text('(mine)\nM30\n')
    page.ask('take_example', name='cut/plate.nc')
    expect(mine.read_text() == '(mine)\nM30\n', 'a copy that the user has changed stays')
    expect('error' in page.ask('take_example', name='../x') and 'error' in page.ask('take_example', name='controls/nct.toml'), 'nothing else of the program is taken')


def read_only(kadr, folder):
    """A folder that may not be written: every change is refused with the reason."""
    there = folder / 'closed'
    there.mkdir()
    (there / 'a.nc').write_text(PROGRAM)
    mounted = os.geteuid() == 0 and subprocess.run(['mount', '--bind', '-o', 'ro', there, there], capture_output=True).returncode == 0
    if mounted:
        subprocess.run(['mount', '-o', 'remount,bind,ro', there], capture_output=True)
    else:
        there.chmod(0o555)
    try:
        server = Server(kadr, there)
        page = greeted(server)
        for do, more in (('rename', {'file': 'a.nc', 'to': 'b.nc'}), ('copy', {'file': 'a.nc', 'to': 'b.nc'}), ('delete', {'file': 'a.nc'}),
                         ('take_example', {'name': 'cut/plate.nc'}), ('save', {'file': 'b.nc', 'text': 'x', 'digest': None})):
            told = page.ask(do, **more)
            expect('error' in told and ('ead-only' in told['error']['text'] or 'ermission' in told['error']['text']), f'{do} in a read-only folder: {told}')
        server.end()
        expect(os.listdir(there) == ['a.nc'], 'nothing is left in it')
    finally:
        if mounted:
            subprocess.run(['umount', there], check=True)
        there.chmod(0o755)


def full_disk(kadr, folder):
    there = folder / 'small'
    there.mkdir()
    if os.geteuid() != 0 or subprocess.run(['mount', '-t', 'tmpfs', '-o', 'size=64k', 'none', there], capture_output=True).returncode != 0:
        return
    try:
        (there / 'a.nc').write_text('G1 X1\n' * 7000)
        server = Server(kadr, there)
        page = greeted(server)
        told = page.ask('copy', file='a.nc', to='b.nc')
        expect('error' in told and 'full' in told['error']['text'], f'a full disk is told ({told})')
        expect(os.listdir(there) == ['a.nc'], 'and nothing is left beside it')
        server.end()
    finally:
        subprocess.run(['umount', there], check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--kadr', required=True)
    kadr = str(Path(parser.parse_args().kadr).resolve())
    with tempfile.TemporaryDirectory() as above:
        outside, folder = Path(above) / 'outside.nc', Path(above) / 'in'
        (folder / 'sub').mkdir(parents=True)
        outside.write_text('M30\n')
        (folder / 'part.nc').write_text(PROGRAM)
        (folder / 'other.nc').write_text(PROGRAM)
        (folder / 'key.nc').write_text('-----BEGIN PRIVATE KEY-----\nMII\n')
        (folder / 'run.sh').write_text('#!/bin/sh\n')
        os.mkfifo(folder / 'fifo.nc')
        os.symlink(folder / 'sub', folder / 'link')
        os.symlink(above, folder / 'uplink')
        os.symlink(outside, folder / 'filelink.nc')
        server = Server(kadr, folder, '--open')
        page = greeted(server)
        everyday(page, folder)
        trash(page, folder)
        seen_on_disk(page, folder)
        attacks(page, folder, outside)
        token(server, folder)
        machine_on(page, folder)
        server.end()
        server = Server(kadr, folder)
        page = Page(server)
        controls = [c['id'] for c in page.ask('hello', token=server.token, lang='en')['controls']]
        beginnings(page, controls, folder)
        server.end()
        shutil.rmtree(folder / '.kadr-trash')
        trash_as_link(kadr, folder, outside)
        read_only(kadr, folder)
        full_disk(kadr, folder)
    expect(all(f'{side}.{do}' in seen for side in ('question', 'answer') for do in ('digest', 'rename', 'copy', 'delete', 'restore', 'trash', 'empty_trash', 'examples', 'take_example', 'new_program')), 'every message was sent')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
