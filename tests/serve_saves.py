#!/usr/bin/env python3
"""Tests what kadr serve saves: completely or not at all when killed at any moment, on a full disk, by two pages at once; files that vanish
or change their type while they are served.

    serve_saves.py --kadr PROGRAM
"""
import argparse
import os
import random
import resource
import shutil
import signal
import subprocess
import tempfile
import threading
from pathlib import Path

from page_client.client import PROGRAM, Page, Server, expect, result

KILLS = 30


def greeted(server):
    page = Page(server)
    page.ask('hello', token=server.token, lang='en')
    return page


def text_of(number, size):
    return f'(version {number})\n' + 'G1 X10 Y20 F100\n' * size


def killed(kadr, folder):
    """SIGKILL at random moments of saving: the file is an old text or a new one, complete."""
    chance = random.Random(7)
    file = folder / 'killed.nc'
    file.write_text(text_of(0, 10))
    wrong, last = [], 0
    for kill in range(KILLS):
        server = Server(kadr, folder)
        page = greeted(server)
        opened, _ = page.open('killed.nc', control='mach3')
        texts = {file.read_text()}
        threading.Timer(chance.uniform(0.0, 0.12), server.process.kill).start()
        digest, confirmed = opened['digest'], None
        try:
            while True:
                last += 1
                text = text_of(last, chance.choice((10, 1000, 100_000)))
                texts.add(text)
                digest = page.ask('save', file='killed.nc', text=text, digest=digest)['digest']
                confirmed = last
                texts = {text}
        except (ConnectionError, OSError):
            pass
        server.process.wait()
        now = file.read_text()
        if now not in texts:
            wrong.append((kill, len(now), confirmed))
    expect(not wrong, f'killed while it saved: the old text or the new one ({wrong})')
    server = Server(kadr, folder)
    page = greeted(server)
    names = [e['name'] for e in page.ask('files', folder='')['entries']]
    expect(names == ['killed.nc'], f'what was left unfinished is not shown ({names})')
    opened, _ = page.open('killed.nc', control='mach3')
    expect('digest' in page.ask('save', file='killed.nc', text='M30\n', digest=opened['digest']), 'and it is saved over')
    expect(os.listdir(folder) == ['killed.nc'], f'and taken away ({os.listdir(folder)})')
    server.end()


def two_pages(kadr, folder):
    (folder / 'both.nc').write_text(PROGRAM)
    os.chmod(folder / 'both.nc', 0o640)
    server = Server(kadr, folder)
    pages = [greeted(server), greeted(server)]
    digests = [page.open('both.nc', control='mach3')[0]['digest'] for page in pages]
    expect('digest' in pages[0].ask('save', file='both.nc', text='(first)\nM30\n', digest=digests[0]), 'the first page saves')
    expect(pages[1].ask('save', file='both.nc', text='(second)\nM30\n', digest=digests[1])['error'].get('changed'), 'the second is told that it was changed')
    expect((folder / 'both.nc').read_text() == '(first)\nM30\n', 'and the first text stands')
    expect((folder / 'both.nc').stat().st_mode & 0o777 == 0o640, 'its mode is what it was')
    # Both save at once, each over what it has seen last: a page whose save was confirmed has its text there, or the other page
    # saw it.
    saved = [0, 0]

    def hurry(i):
        for n in range(400):
            if n >= 40 and min(saved) > 0:
                break  # each has had its turn: on a busy machine one of them may wait long
            digest = pages[i].open('both.nc', control='mach3')[0]['digest']
            answer = pages[i].ask('save', file='both.nc', text=f'(page {i} {n})\nM30\n', digest=digest)
            if 'digest' in answer:
                saved[i] += 1
            elif not answer['error'].get('changed'):
                expect(False, f'two at once: {answer}')

    threads = [threading.Thread(target=hurry, args=(i,)) for i in (0, 1)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    expect(min(saved) > 0 and (folder / 'both.nc').read_text().endswith('M30\n'), f'two pages at once: each saves, the text is whole ({saved})')
    new = [page.begin('save', file='new.nc', text=f'({i})\nM30\n', digest=None) for i, page in enumerate(pages)]
    answers = [page.answer(n) for page, n in zip(pages, new)]
    expect(sum('digest' in a for a in answers) == 1, 'one new file of two pages')
    server.end()


def full_disk(kadr, folder):
    """A full disk: reported, and the old text stays."""
    there = folder / 'small'
    there.mkdir()
    mounted = os.geteuid() == 0 and subprocess.run(['mount', '-t', 'tmpfs', '-o', 'size=256k', 'none', there], capture_output=True).returncode == 0
    limit = None if mounted else lambda: (signal.signal(signal.SIGXFSZ, signal.SIG_IGN), resource.setrlimit(resource.RLIMIT_FSIZE, (200_000, 200_000)))
    try:
        (there / 'full.nc').write_text(PROGRAM)
        server = Server(kadr, there, before=limit)
        page = greeted(server)
        opened, _ = page.open('full.nc', control='mach3')
        refused = page.ask('save', file='full.nc', text='G1 X1\n' * 100_000, digest=opened['digest'])
        expect('error' in refused and not refused['error'].get('changed'), f'a full disk is told ({refused})')
        expect((there / 'full.nc').read_text() == PROGRAM, 'the old text stands')
        expect(os.listdir(there) == ['full.nc'], 'and nothing beside it')
        expect('digest' in page.ask('save', file='full.nc', text='M30\n', digest=opened['digest']), 'what has room is saved')
        server.end()
    finally:
        if mounted:
            subprocess.run(['umount', there], check=True)


def changed_under_it(kadr, folder):
    """Files that vanish or become something else, and the folder itself."""
    served = folder / 'served'
    served.mkdir()
    for name in ('fifo.nc', 'gone.nc', 'link.nc', 'shorter.nc', 'folder.nc'):
        (served / name).write_text(PROGRAM)
    (served / 'shorter.nc').write_text(PROGRAM * 50_000)
    server = Server(kadr, served)
    page = greeted(server)
    digests = {name: page.open(name, control='mach3')[0]['digest'] for name in ('fifo.nc', 'gone.nc', 'link.nc', 'folder.nc')}
    for name in digests:
        (served / name).unlink()
    os.mkfifo(served / 'fifo.nc')
    (served / 'folder.nc').mkdir()
    (served / 'link.nc').symlink_to('/etc/passwd')
    for name, digest in digests.items():
        expect('error' in page.ask('open', file=name, control='mach3'), f'{name} is not opened any more')
        expect('error' in page.ask('save', file=name, text='x', digest=digest), f'{name} is not saved over')
        if name != 'gone.nc':
            expect('error' in page.ask('save', file=name, text='x', digest=None), f'{name} is not replaced')
        expect('entries' in page.ask('files', folder=''), f'{name}: nobody is waited for')
    expect(os.readlink(served / 'link.nc') == '/etc/passwd', 'the link is as it was')
    opened, _ = page.open('shorter.nc', control='mach3')
    os.truncate(served / 'shorter.nc', 100)
    expect('lines' in page.ask('source', **{'from': 1000, 'count': 5000}), 'a file that has become shorter: what is there')
    expect('position' in page.ask('state', at=50), 'and a state')
    again, done = page.open('shorter.nc', control='mach3')
    expect(again['size'] == 100 and done['state'] in ('ended', 'stopped'), 'it is opened as it is')
    shutil.rmtree(served)
    expect(page.ask('files', folder='').get('entries', []) == [], 'a folder that is no more')
    expect('error' in page.ask('open', file='shorter.nc', control='mach3'), 'nothing is opened of it')
    expect('error' in page.ask('save', file='new.nc', text='M30\n', digest=None), 'nothing is saved to it')
    served.mkdir()
    (served / 'other.nc').write_text('M30\n')
    expect(page.ask('files', folder='').get('entries', []) == [], 'another one of its name is not it')
    expect(server.process.poll() is None, 'the server still stands')
    server.end()


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    kadr = options.parse_args().kadr
    for part in (killed, two_pages, full_disk, changed_under_it):
        with tempfile.TemporaryDirectory() as folder:
            part(kadr, Path(folder))
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
