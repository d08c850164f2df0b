#!/usr/bin/env python3
"""Tests kadr serve against hostile clients: broken HTTP and WebSocket, floods, idle connections, programs and set-ups that name
files outside the folder, a page that does not read what it is sent.

    serve_attacks.py --kadr PROGRAM
"""
import argparse
import os
import shutil
import signal
import socket
import struct
import tempfile
import time
from pathlib import Path

import harness
from page_client.client import PROGRAM, Page, Server, expect, result

SECRET = 'SECRET-7391'


def closed(page):
    """Checks that the server closes the connection; messages before that are ignored."""
    try:
        while True:
            page.receive()
    except (ConnectionError, OSError):
        return True


def raw(page, first, data, mask=True, length=None):
    """Sends a frame with exactly that first byte."""
    n = len(data) if length is None else length
    head = bytes([first]) + (bytes([n | 0x80 * mask]) if n < 126 else bytes([126 | 0x80 * mask]) + struct.pack('>H', n) if n < 65536
                             else bytes([127 | 0x80 * mask]) + struct.pack('>Q', n))
    try:
        page.socket.sendall(head + (b'\0\0\0\0' if mask else b'') + data)
    except OSError:
        pass


def greeted(server, **more):
    page = Page(server)
    page.ask('hello', token=server.token, lang='en', **more)
    return page


def no_memory_for(page):
    """Checks that a program is not opened, or that what grows with it is closed, either with a message."""
    page.begin('open', file='long.nc', control='mach3')
    try:
        while True:
            message = page.take()
            if message is not None and 'memory' in message.get('error', message).get('text', ''):
                return True
            if message is not None and message.get('event') == 'done':
                return False
    except (ConnectionError, OSError):
        return False   # no message


def crowded(kadr, folder):
    """Pages that open a long program and do not read: all together use the allowed memory, and then none gets more."""
    (folder / 'long.nc').write_text('F1000\n' + ''.join(f'G1 X{i % 1000} Y{i % 777}\n' for i in range(300_000)))
    server = Server(kadr, folder, '--max-memory', '200')
    pages = []
    for _ in range(24):
        page = greeted(server)
        page.begin('open', file='long.nc', control='mach3')
        pages.append(page)
    harness.expect(harness.stands(server.process), 'it comes to rest')
    megabytes = int(Path(f'/proc/{server.process.pid}/statm').read_text().split()[1]) * os.sysconf('SC_PAGE_SIZE') / 1e6
    expect(megabytes < 300, f'24 pages hold {megabytes:.0f} MB')
    expect(no_memory_for(greeted(server)), 'and the next one gets none')
    last = greeted(server)
    expect('entries' in last.ask('files', folder=''), 'it may look at the folder')
    for page in pages:
        page.socket.close()
    expect(harness.until(lambda: not no_memory_for(greeted(server))), 'when they have gone there is room again')
    server.end()
    (folder / 'long.nc').unlink()


def messages(server):
    """Bad messages are answered, a flood ends the session, and other sessions are not affected."""
    good = greeted(server)
    bad = Page(server)
    said = []
    try:
        for text in [b'', b'{', b'[]', b'1', b'{"id":1}', b'{"id":1,"do":7}', b'{"do":"hello"}', b'[' * 5000, b'{"id":"1","do":"hello"}'] * 15:
            bad.send(text)
            said.append(bad.take())
        expect(False, 'a hundred messages that are no questions end the session')
    except (ConnectionError, OSError):
        expect(99 <= len(said) <= 101 and said[-1].get('event') == 'closed', 'a hundred messages that are no questions end the session, and it says why')
    numbers = greeted(server)
    numbers.open('part.nc', control='mach3')
    for at in (1e308, -1e308, -1):
        numbers.ask('state', at=at)
    for more in ({'at': 'x'}, {'at': None}, {'at': []}, {}):
        numbers.ask('state', wrong=True, **more)
    for more in ({'from': -1, 'count': 1e18}, {'from': 'a'}, {'count': {}}):
        numbers.ask('source', wrong=True, **more)
    numbers.ask('source', **{'from': 10**18, 'count': 1})
    expect('error' in numbers.ask('source', file=70000), 'no such file')
    for do in ('open', 'save', 'check', 'files', 'language', 'hello', 'passes', 'explain', 'compare'):
        for value in (None, 1, [], {}, [[[]]], True):
            key = {'files': 'folder', 'language': 'lang', 'hello': 'token', 'check': 'text', 'passes': 'line', 'explain': 'line'}.get(do, 'file')
            numbers.begin(do, wrong=None, **{key: value})
            numbers.answer(numbers.number)
    numbers.begin('open', file='part.nc', control='../' * 1000)
    numbers.answer(numbers.number)
    expect('entries' in good.ask('files', folder=''), 'another session knows nothing of it')
    many = [Page(server) for _ in range(40)]
    expect(many[-1].status == 503, 'no more sessions than the limit')
    for one in many:
        one.socket.close()


def frames(server):
    """RFC 6455 violated on purpose."""
    for name, first, data, more in (
            ('an opcode that is none', 0x83, b'x', {}), ('a control opcode that is none', 0x8B, b'x', {}),
            ('what goes on where nothing has begun', 0x80, b'x', {}), ('a reserved bit', 0xC1, b'{}', {}), ('no mask', 0x81, b'{}', {'mask': False}),
            ('a ping in pieces', 0x09, b'x', {}), ('a ping that is too long', 0x89, b'x' * 126, {}),
            ('a message above the limit, said', 0x81, b'', {'length': 1 << 40}), ('a length beyond all', 0x81, b'', {'length': (1 << 63) - 1}),
            ('text that is no UTF-8', 0x81, b'\xff\xfe', {}), ('a close of one byte', 0x88, b'x', {}), ('a close with a code that is none', 0x88, b'\x00\x01', {})):
        page = greeted(server)
        raw(page, first, data, **more)
        expect(closed(page), name)
    page = greeted(server)
    raw(page, 0x01, b'x')
    raw(page, 0x81, b'x')
    expect(closed(page), 'a message within a message')
    page = Page(server)
    try:
        page.send(b'x' * (17 << 20))
    except OSError:
        pass
    expect(closed(page), 'a message above the limit')

    page = greeted(server)
    raw(page, 0x01, b'{"id":77,"d')
    raw(page, 0x89, b'beat')
    raw(page, 0x00, b'o":"fil')
    raw(page, 0x80, b'es"}')
    pong = page.exactly(6)
    page.asked[77] = 'files'
    expect(pong == b'\x8a\x04beat' and 'entries' in page.answer(77), 'a message in pieces with a ping between them')
    for _ in range(2000):
        raw(page, 0x8A, b'')
    raw(page, 0x88, struct.pack('>H', 1000))
    expect(page.exactly(2)[0] == 0x88, 'a close is answered')


def requests(server):
    host = f'Host: 127.0.0.1:{server.port}\r\n'
    get = f'GET /health HTTP/1.1\r\n{host}\r\n'
    expect(server.request(get * 3).count(' 200 ') == 3, 'three requests at once')
    for name, text in {
        'no HTTP': '\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03' * 20, 'NUL bytes': 'GET /\0/../etc HTTP/1.1\r\n' + host + '\r\n',
        'a target without end': 'GET /' + 'a' * 200_000, 'a line break in a field': f'GET / HTTP/1.1\r\n{host}X: a\rb\r\n\r\n',
        'two lengths': f'GET / HTTP/1.1\r\n{host}Content-Length: 1\r\nContent-Length: 2\r\n\r\nab',
        'a body that is too long': f'GET / HTTP/1.1\r\n{host}Content-Length: 999999999999\r\n\r\n', 'a negative length': f'GET / HTTP/1.1\r\n{host}Content-Length: -1\r\n\r\n',
        'ten thousand fields': f'GET / HTTP/1.1\r\n{host}' + 'X: 1\r\n' * 10_000 + '\r\n', 'an address as target': f'GET http://evil.example/ HTTP/1.1\r\n{host}\r\n',
        'CONNECT': f'CONNECT 127.0.0.1:1 HTTP/1.1\r\n{host}\r\n', 'two hosts': f'GET / HTTP/1.1\r\nHost: evil.example\r\n{host}\r\n',
        'a chunk without end': f'GET / HTTP/1.1\r\n{host}Transfer-Encoding: chunked\r\n\r\nffffffffffffffff\r\n',
    }.items():
        expect(' 200 ' not in server.request(text), name)
    for field in ('Sec-WebSocket-Version: 7', 'Sec-WebSocket-Version:'):
        upgrade = f'GET /session HTTP/1.1\r\n{host}Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: x\r\n{field}\r\n\r\n'
        expect(' 101 ' not in server.request(upgrade), 'a handshake with ' + field)
    elsewhere = f'GET /session/../session HTTP/1.1\r\n{host}Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n\r\n'
    expect(' 101 ' not in server.request(elsewhere), 'a session has one place')


def shown_out(one):
    """True if the server has closed that connection."""
    one.setblocking(False)
    try:
        return one.recv(1) == b''
    except BlockingIOError:
        return False
    except OSError:
        return True


def sleepers(server):
    """Connections that send nothing, or one byte a second, block nobody, and are closed."""
    asleep = [socket.create_connection(('127.0.0.1', server.port)) for _ in range(100)]
    for one in asleep[50:]:
        one.sendall(b'GET / HT')
    expect(' 200 ' in server.request(f'GET /health HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n\r\n'), 'others are answered beside a hundred that sleep')
    left = [one for one in asleep if not shown_out(one)]
    expect(left, 'at once: before those are shown out')
    began, spoken = time.monotonic(), time.monotonic()
    while left and time.monotonic() - began < harness.TIME_LIMIT_S:
        time.sleep(0.1)
        if time.monotonic() - spoken >= 1:
            spoken = time.monotonic()
            for one in asleep[50:]:
                try:
                    one.sendall(b'T')
                except OSError:
                    pass
        left = [one for one in left if not shown_out(one)]
    expect(not left, f'after ten seconds they are shown out ({len(left)} of 100 are not)')
    for one in asleep:
        one.close()
    half = greeted(server)
    half.socket.shutdown(socket.SHUT_WR)
    expect(closed(half), 'a page that only listens is over')


def beyond(server, above, folder):
    """Files that programs, set-ups and control files name are read inside the folder or not at all."""
    (above / 'outside.nc').write_text(f'O9\n({SECRET})\nG1 X99 F100\nM99\n')
    (above / 'outside.ngc').write_text(f'o<outside> sub\n({SECRET})\nG1 X99 F100\no<outside> endsub\n')
    (above / 'outside.ini').write_text(f'[RS274NGC]\nPARAMETER_FILE = {above}/outside.var\n[{SECRET}\n')
    (above / 'outside.var').write_text('5161 1\n5162 nothing ' + SECRET + '\n')
    (above / 'outside.toml').write_text(f'id = "outside"\n{SECRET}\n')
    inside = folder / 'calls'
    inside.mkdir()
    (inside / 'good.nc').write_text('G1 X5 F100\nM99\n')
    (inside / 'O0030.nc').symlink_to('../../outside.nc')
    (inside / 'link.nc').symlink_to(above / 'outside.nc')
    (inside / 'inner.nc').symlink_to('good.nc')
    (inside / 'outside.ngc').symlink_to(above / 'outside.ngc')
    os.mkfifo(inside / 'pipe.nc')
    os.mkfifo(inside / 'O0031.nc')
    page = greeted(server)

    def run(name, text, control, **more):
        (inside / 'main.nc').write_text(text)
        answer, done = page.open('calls/main.nc', control=control, **more)
        everything = repr(answer) + repr(page.events) + repr(done)
        expect(SECRET not in everything, f'{name}: nothing of it is told')
        return answer, done

    def vertex_count(frames):
        return sum(struct.unpack_from('<4I', f)[2] for f in frames)

    _, done = run('a file beside it', 'M98 <good.nc>\nM30\n', 'nct')
    expect(done['state'] == 'ended' and vertex_count(page.frames) > 1, 'a file beside it is called')
    called = page.ask('source', **{'from': 1, 'count': 9}, file=2)
    expect(called['lines'] == ['G1 X5 F100', 'M99'] and called['count'] == 2 and called['name'] == 'calls/good.nc', 'its lines')
    expect('error' in page.ask('source', file=1) and 'error' in page.ask('source', file=3), 'what is no file has none')
    (inside / 'bad.nc').write_text('G1 X5 F100\nG1 X5 X6\nM99\n')
    run('a fault in it', 'M98 <bad.nc>\nM30\n', 'nct')
    problems = [e['problem'] for e in page.events if e.get('event') == 'alarm']
    expect([(p['file'], p.get('file_name'), p['line']) for p in problems] == [(2, 'calls/bad.nc', 2)], f'a fault in it has its file ({problems})')
    for name, call in {'a file above': 'M98 <..\\..\\outside.nc>', 'the password file': 'M98 <' + '..\\' * 12 + 'etc\\passwd>', 'a link by name': 'M98 <link.nc>',
                       'a link by number': 'M98 P30', 'a pipe': 'M98 <pipe.nc>', 'a pipe by number': 'M98 P31', 'a link within': 'M98 <inner.nc>'}.items():
        _, done = run(name, call + '\nM30\n', 'nct')
        expect(done['state'] == 'stopped' and not vertex_count(page.frames), f'{name} is not read')
    _, done = run('a link to a subprogram', 'o<outside> call\nM2\n', 'linuxcnc')
    expect(done['state'] == 'stopped' and not vertex_count(page.frames), 'a link to a subprogram is not read')
    for ini in ('../../outside.ini', str(above / 'outside.ini'), '/etc/passwd'):
        (inside / 'setup.json').write_text('{"ini": "%s"}' % ini)
        answer, _ = run(ini, 'G1 X1 F100\nM2\n', 'linuxcnc', setup='calls/setup.json')
        expect('error' in answer, f'{ini} is refused as an ini file')
    (inside / 'own.ini').write_text(f'[RS274NGC]\nPARAMETER_FILE = ../../outside.var\n')
    (inside / 'setup.json').write_text('{"ini": "own.ini"}')
    run('a parameter file above', '#1=#5161\nG1 X#1 F100\nM2\n', 'linuxcnc', setup='calls/setup.json')
    for base in ('../../outside.toml', str(above / 'outside.toml'), '/etc/passwd'):
        (inside / 'own.toml').write_text(f'id = "own"\nextends = "{base}"\n')
        answer, _ = run(base, 'M30\n', 'calls/own.toml')
        expect('error' in answer, f'{base} is not extended')
    (inside / 'own.toml').write_text('id = "own"\nname = {en = "Own", ru = "Своя"}\nextends = "mach3"\n')
    answer, _ = run('a control of its own', 'G1 X1 F100\nM30\n', 'calls/own.toml')
    expect(answer.get('control', {}).get('id') == 'own', 'a control file of the folder')
    bodies_beyond(page, above, inside)


def bodies_beyond(page, above, inside):
    """Meshes of a machine's bodies, and files that a cut names."""
    example = Path(__file__).resolve().parent.parent / 'examples' / 'cut'
    shutil.copy(example / 'step.stl', above / 'outside.stl')
    shutil.copy(example / 'step.stl', inside / 'good.stl')
    (inside / 'link.stl').symlink_to(above / 'outside.stl')
    (inside / 'tools.toml').write_text('[[tool]]\nnumber = 1\nkind = "flat"\ndiameter = 8\nflute_length = 20\nlength = 30\n')
    (inside / 'cut.nc').write_text('G21 G90\nT1 M6\nM3 S1000\nG0 X0 Y0 Z5\nG1 Z-1 F300\nX5\nG0 Z50\nM30\n')
    machine = (example / 'trunnion.toml').read_text().replace('cylinder = [0, 0, -420, -400, 300]', 'file = "%s"')
    for mesh, reads in {'good.stl': True, '../../outside.stl': False, str(above / 'outside.stl'): False, 'link.stl': False}.items():
        (inside / 'machine.toml').write_text(machine % mesh)
        answer, _ = page.open('calls/cut.nc', control='mach3', machine='calls/machine.toml')
        expect('error' not in answer, f'a machine with a body of {mesh} is opened ({answer.get("error")})')
        cut = page.ask('cut', stock='box:-5,-5,-5,15,15,0', tools='calls/tools.toml')
        expect(('error' not in cut) == reads, f'a body of {mesh}: {cut}')
        if reads:
            page.until('cut')


def unread(server):
    """A page that does not read blocks its own run, which can still be stopped."""
    page = greeted(server)
    page.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 16)
    opened = page.begin('open', file='endless.nc', control='linuxcnc')
    expect(harness.stands(server.process, 2), 'the run waits for the page')
    stop = page.begin('stop')
    expect(harness.stands(server.process, 2), 'and is over')
    page.answer(opened)
    before, taken = server.spent(), None
    while taken is None:  # frames that had been sent before
        message = page.take()
        if message is not None and message.get('event') == 'done':
            taken = message
    took = server.spent() - before
    expect(took < 0.3, f'behind what had been sent it says so at once, after {took:.2f} s of work')
    page.answer(stop)
    expect(taken['state'] == 'cancelled' and len(page.frames) < 100, f'it is stopped ({len(page.frames)} frames)')
    _, done = page.open('part.nc', control='mach3')
    expect(done['state'] == 'ended', 'and the session goes on')
    for _ in range(3):
        greeted(server).begin('open', file='endless.nc', control='linuxcnc')
    harness.stands(server.process, 2)
    took = harness.spent_after(server.process, signal.SIGINT)
    expect(server.process.returncode == 130 and took < 0.5, f'Ctrl-C while sessions wait: status {server.process.returncode}, {took:.2f} s of work')


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    kadr = options.parse_args().kadr
    with tempfile.TemporaryDirectory() as top:
        above = Path(top).resolve()
        folder = above / 'programs'
        folder.mkdir()
        (folder / 'part.nc').write_text(PROGRAM)
        (folder / 'endless.nc').write_text('G90 G21 F1000\no100 while [1]\nG1 X1\nX0\no100 endwhile\nM2\n')
        crowded(kadr, folder)
        server = Server(kadr, folder)
        messages(server)
        frames(server)
        requests(server)
        sleepers(server)
        beyond(server, above, folder)
        expect(server.process.poll() is None, 'the server still stands')
        unread(server)
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
