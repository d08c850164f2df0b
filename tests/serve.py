#!/usr/bin/env python3
"""kadr serve, by its protocol (docs/panel-protocol.md), without a browser: what a page may ask, what is refused, what cannot be broken.

    serve.py --kadr PROGRAM
"""
import argparse
import os
import re
import struct
import subprocess
import tempfile
import time
from pathlib import Path

from page_client.client import PROGRAM, SCHEMA, Page, Server, expect, result, seen, vertices


# What other tests see, and what is not served yet.
UNSAID = {'event.closed', 'event.cutting', 'event.finding', 'event.cut', 'answer.cut', 'answer.part', 'answer.proposals', 'answer.sheet',
          'question.cut', 'question.part', 'question.proposals', 'question.sheet'}


def http(server):
    host = f'Host: 127.0.0.1:{server.port}\r\n'
    expect(' 200 ' in server.request(f'GET /health HTTP/1.1\r\n{host}\r\n'), 'health')
    head = server.request(f'HEAD / HTTP/1.1\r\n{host}\r\n')
    expect(re.match(r'HTTP/1.1 (200|503) ', head) and "frame-ancestors 'none'" in head and 'nosniff' in head, 'HEAD of /, with its policy')
    for name, text in {
        'a name that points here is refused': f'GET / HTTP/1.1\r\nHost: evil.example:{server.port}\r\n\r\n',
        'another port is refused': 'GET / HTTP/1.1\r\nHost: 127.0.0.1:1\r\n\r\n',
        'no host is refused': 'GET / HTTP/1.0\r\n\r\n',
        'another origin is refused': f'GET / HTTP/1.1\r\n{host}Origin: http://evil.example\r\n\r\n',
    }.items():
        expect(' 403 ' in server.request(text), name)
    expect(' 405 ' in server.request(f'POST / HTTP/1.1\r\n{host}Content-Length: 0\r\n\r\n'), 'POST is refused')
    for path in ('/../../etc/passwd', '/%2e%2e/etc/passwd', '/part.nc', '//etc/passwd'):
        expect(' 404 ' in server.request(f'GET {path} HTTP/1.1\r\n{host}\r\n'), f'GET {path}')
    expect(' 200 ' not in server.request('GET / HTTP/1.1\r\nX: ' + 'a' * 100000 + '\r\n\r\n'), 'a head that is too long')
    expect(Page(server, Origin='http://evil.example').status == 403, 'a session of another origin is refused')


def session(server, folder):
    page = Page(server, Origin=f'http://127.0.0.1:{server.port}')
    expect(page.status == 101, 'a session opens')
    expect('error' in page.ask('files'), 'the first question is hello')
    hello = page.ask('hello', token=server.token, lang='en')
    expect(hello['may_change'] and any(c['id'] == 'mach3' for c in hello['controls']), 'hello')
    names = [e['name'] for e in page.ask('files', folder='')['entries']]
    expect('part.nc' in names and '.secret' not in names and 'link' not in names, 'files: no dots, no links')
    for name in ('../outside.nc', '/etc/passwd', 'link', 'sub/../../outside.nc', '.secret', 'sublink/outside.nc', 'fifo', '', 'part.nc/x', 'a\0b'):
        expect('error' in page.ask('open', file=name, control='mach3'), f'open {name!r} is refused')
    expect('error' in page.ask('open', file='part.nc', control='../c.toml'), 'a control beyond the folder is refused')

    opened, done = page.open('part.nc', control='mach3')
    expect(opened['text'] == PROGRAM and opened['lines'] == 12 and opened['control']['id'] == 'mach3', 'open: text and control')
    expect(done['state'] == 'ended' and done['extents']['cutting'] == [[0, 0, -2], [50, 20, 5]], 'done: extents')
    rows = [row for frame in page.frames for row in vertices(frame)]
    expect(rows[-1][0] == (0, 0, 5) and rows[-1][2] == 11, 'the path ends where the program does')
    times = [row[1] for row in rows]
    expect(times == sorted(times) and abs(times[-1] - done['seconds']) < 1e-3, 'time goes on along the path')
    expect([row[3] for row in rows[:3]] == [0, 1, 2] and rows[0][4] == 15, 'kinds and levels')
    expect(max(row[0][0] for row in rows) > 49.99, 'the arc is there')
    expect([m['kind'] for m in done['marks']][-1] == 'end' and any(m['kind'] == 'tool' for m in done['marks']), 'marks')

    middle = [row for row in rows if row[2] == 7][0][1] - 1
    state = page.ask('state', at=middle)
    expect(state['line'] == 7 and state['tool'] == 1 and 0 < state['tip'][0] < 40 and state['togo']['X'] > 0, 'state in mid motion')
    expect(any(m['code'] == 'G1' for m in state['modal']), 'state: modal codes')
    expect(page.ask('state', at=0)['line'] <= 5 and page.ask('state', at=1e9)['line'] == 11, 'states at both ends')
    expect(page.ask('passes', line=7)['count'] == 1 and page.ask('passes', line=1)['count'] == 0, 'passes of a line')
    expect(page.ask('source', **{'from': 2, 'count': 2})['lines'] == ['G21 G90 G17', 'T1 M6'], 'lines of the source')
    problems = page.ask('check', text=PROGRAM.replace('G3 X40', 'G3 X41'))['problems']
    expect(len(problems) == 1 and problems[0]['line'] == 8 and problems[0]['hint'], 'check finds the fault with its hint')
    expect(page.ask('check', text=PROGRAM)['problems'] == [], 'check of the good program')

    text = PROGRAM.replace('F600', 'F700')
    saved = page.ask('save', file='part.nc', text=text, digest=opened['digest'])
    expect((folder / 'part.nc').read_text() == text and 'digest' in saved, 'save')
    expect(page.ask('save', file='part.nc', text='x', digest=opened['digest'])['error'].get('changed'), 'what has changed since is not saved over')
    for name in ('../x.nc', '.x.nc', 'link', 'sublink/x.nc', '/tmp/x.nc', 'picture.png'):
        expect('error' in page.ask('save', file=name, text='x', digest=None), f'save {name!r} is refused')
    expect('error' in page.ask('save', file='other.nc', text='x', digest='1'), 'what was not opened is not saved over')
    expect('error' in page.ask('save', file='other.nc', text='x', digest=None), 'a new file is none where there is one')
    expect('digest' in page.ask('save', file='new.nc', text='M30\n', digest=None), 'a new file is saved')
    expect(not [n for n in os.listdir(folder) if n.endswith('.kadr')], 'nothing unfinished is left')
    expect(all('not served yet' in page.ask('part', at=1)['error']['text'] for _ in range(120)), 'what is to come is no mistake')
    page.ask('language', lang='ru')
    russian = page.ask('check', text='G1 X10 F100 G0\nM30\n')['problems']
    expect(russian and any('а' <= c <= 'я' for c in russian[0]['text']), 'Russian')

    other = Page(server)
    expect(not other.ask('hello', token='0' * 32)['may_change'], 'a wrong token may look')
    expect('error' in other.ask('save', file='new2.nc', text='x', digest=None) and not (folder / 'new2.nc').exists(), 'and saves nothing')


def texts(server):
    """explain, read, compare, bounds."""
    page = Page(server)
    page.ask('hello', token=server.token, lang='en')
    opened, _ = page.open('other.nc', control='mach3')
    expect(opened['bounds'] == {'limits': [[None] * 3] * 2, 'zones': []}, 'no limits of a machine that states none')
    words = page.ask('explain', line=8)['words']
    expect([w['code'] for w in words] == ['G3', 'X', 'Y', 'J'] and words[0]['from'] == 1 and words[0]['to'] == 3, 'explain: words and columns')
    expect(all(w['title'] and w['text'] for w in words), 'explain: each says something')
    expect([w['code'] for w in page.ask('explain', line=1, text='G83 Z-5 R2 Q1')['words']] == ['G83', 'Z', 'R', 'Q'], 'explain: the text of the editor')
    expect(page.ask('explain', line=99)['words'] == [] and page.ask('explain', wrong=True, line=-1)['words'] == [], 'explain: no such line')
    expect(len(page.ask('explain', line=1, text='X1' * 500_000)['words']) <= 500, 'explain: a line without end')
    read = page.ask('read', file='other.nc')
    expect(read['text'] == PROGRAM and read['digest'] == opened['digest'], 'read: text and digest')
    for name in ('../outside.nc', '/etc/passwd', 'link', '.secret', 'fifo', '', 'binary'):
        expect('error' in page.ask('read', file=name), f'read {name!r} is refused')
    page.frames = []
    same = page.ask('compare', text=PROGRAM.replace('X40 F600', 'X20 F600\nX40'))
    done = page.until('compared')
    expect(same['same'] and same['differences'] == [] and same['first'] is None and same['moves'][0] == 7, 'compare: a line cut in two is the same')
    expect(done['seconds'] > 0 and page.frames and all(struct.unpack_from('<4I', f)[1] == 1 for f in page.frames), 'compare: the other path')
    other = page.ask('compare', text=PROGRAM.replace('X0\nY0', 'X0 Y22\nY0').replace('F600', 'F700'))
    page.until('compared')
    expect(not other['same'] and {d['kind'] for d in other['differences']} >= {'feed', 'way'}, 'compare: feed and way')
    way = [d for d in other['differences'] if d['kind'] == 'way'][0]
    expect(way['a']['line'] == 9 and 1.5 < way['distance'] <= 2.01 and other['deviation'] == way['distance'], 'compare: where, and how far')
    expect(page.ask('state', number=way['a']['number'])['line'] == 9, 'compare: its number leads to the line')
    expect('error' in page.ask('compare', wrong=True) and 'error' in page.ask('compare', file='../outside.nc'), 'compare: what cannot be')
    comparing = page.begin('compare', file='endless.nc', control='linuxcnc')
    page.begin('stop')
    begun = time.monotonic()
    expect(page.answer(comparing) and time.monotonic() - begun < 5, 'compare: it is stopped')


def extents(server, folder):
    """Of a program with two work offsets: as the picture shows them."""
    (folder / 'two.nc').write_text('G21 G90 F1000\nG10 L2 P2 X100 Y0 Z0\nG54 G1 X10\nG55 X10 Y5\nM2\n')
    page = Page(server)
    page.ask('hello')
    _, done = page.open('two.nc', control='linuxcnc')
    expect(done['extents']['cutting'] == [[0, 0, 0], [110, 5, 0]], f'extents with two work offsets ({done["extents"]})')
    _, done = page.open('two.nc', control='linuxcnc', text='G21 G90 F1000\nG1 X10\nG2 X20 R1\nM2\n')
    alarms = [e for e in page.events if e.get('event') == 'alarm' and e['problem']['severity'] == 'alarm']
    expect(done['state'] == 'stopped' and [a['problem']['line'] for a in alarms] == [3], 'the alarm that stops it is told')


def endless(server):
    """An endless program is stopped at once; other sessions go on meanwhile."""
    page = Page(server)
    page.ask('hello', token=server.token)
    page.ask('open', file='endless.nc', control='linuxcnc')
    other = Page(server)
    started = time.monotonic()
    other.ask('hello')
    other.ask('files', folder='')
    expect(time.monotonic() - started < 2, 'another session is answered meanwhile')
    started = time.monotonic()
    stop = page.begin('stop')
    expect(page.until('done')['state'] == 'cancelled' and time.monotonic() - started < 2, 'stop')
    page.answer(stop)
    _, done = page.open('part.nc', control='mach3')
    expect(done['state'] == 'ended', 'after a stop the next program runs to its end')


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    kadr = options.parse_args().kadr
    with tempfile.TemporaryDirectory() as above:
        folder = Path(above) / 'programs'
        (folder / 'sub').mkdir(parents=True)
        (Path(above) / 'outside.nc').write_text(PROGRAM)
        (folder / 'part.nc').write_text(PROGRAM)
        (folder / 'other.nc').write_text(PROGRAM)
        (folder / '.secret').write_text('x')
        (folder / 'endless.nc').write_text('G90 G21 F1000\no100 while [1]\nG1 X1\nX0\no100 endwhile\nM2\n')
        (folder / 'link').symlink_to('/etc/passwd')
        (folder / 'sublink').symlink_to(above)
        (folder / 'binary').write_bytes(bytes(range(256)))
        os.mkfifo(folder / 'fifo')
        server = Server(kadr, folder)
        for part in (lambda: http(server), lambda: session(server, folder), lambda: texts(server), lambda: extents(server, folder), lambda: endless(server)):
            part()
        expect(server.process.poll() is None, 'the server still stands')
        expect(server.end() == 130, 'Ctrl-C')
        wrong = subprocess.run([kadr, 'serve', str(folder / 'nothing'), '--no-browser'], capture_output=True, text=True, timeout=10)
        expect(wrong.returncode == 2 and wrong.stderr, 'a folder that is not there')
        remote = Server(kadr, folder, '--host', '0.0.0.0')
        page = Page(remote)
        expect('error' in page.ask('hello', token='x') and 'error' in page.ask('files'), 'beyond this machine nothing without the token')
        expect('error' not in Page(remote).ask('hello', token=remote.token), 'with it all')
        remote.end()
    # All that the schema names has been said, so that nothing stands there that is not.
    named = {name for name in SCHEMA['$defs'] if '.' in name}
    expect(not named - seen - UNSAID, f'of the schema never said: {sorted(named - seen - UNSAID)}')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
