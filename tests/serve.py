#!/usr/bin/env python3
"""Tests kadr serve by its protocol (docs/panel-protocol.md), without a browser: what a page may request, what is refused, what must not
break.

    serve.py --kadr PROGRAM
"""
import argparse
import json
import math
import os
import re
import struct
import subprocess
import tempfile
from pathlib import Path

import harness
from page_client.client import PROGRAM, SCHEMA, Page, Server, expect, result, seen, vertices


# Messages that other tests cover.
UNSAID = {'event.closed'} | {f'{side}.{do}' for side in ('question', 'answer')
                             for do in ('machines', 'machine', 'panel', 'machine_source', 'press', 'switches', 'enter', 'undo', 'jog', 'jogging', 'stops', 'answer', 'watch', 'restart', 'go_there', 'lead',
                                        'tables', 'edit', 'keep_tables', 'shift', 'mill', 'tape', 'convert',
                                        'setup_form', 'keep_setup', 'keep_tools', 'digest', 'rename', 'copy', 'delete', 'restore', 'examples', 'take_example',
                                        'new_program', 'edit_program', 'write_blocks', 'trash', 'empty_trash', 'report', 'ports', 'prove', 'probe')}  # tests/panel*.py, tests/serve_making.py, tests/serve_convert.py, tests/serve_files.py, tests/serve_setup.py, tests/serve_edit.py, tests/serve_report.py send them


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
    sheet = page.ask('sheet')
    expect(sheet['program'] == 'part.nc' and [t['number'] for t in sheet['tools']] == [1] and sheet['extents']['cutting'][0] == [0, 0, -2], 'the set-up sheet')
    expect(page.ask('source', **{'from': 2, 'count': 2})['lines'] == ['G21 G90 G17', 'T1 M6'], 'lines of the source')
    sheet = page.ask('sheet')
    expect(sheet['program'] == 'part.nc' and sheet['comments'][0] == {'line': 1, 'text': '</script><img src=x onerror=alert`1`>'}, f'the sheet: its notes {sheet}')
    expect([(t['number'], t['lines']) for t in sheet['tools']] == [(1, [3])] and sheet['extents'] == done['extents'], 'its tools')
    expect(done['tools'][0]['from'] == next(m['at'] for m in done['marks'] if m['kind'] == 'tool'), 'the instant of the first use of a tool')
    expect(sheet['seconds'] == done['seconds'] and len(sheet['date']) == 10, 'its time')
    problems = page.ask('check', text=PROGRAM.replace('G3 X40', 'G3 X41'))['problems']
    expect(len(problems) == 1 and problems[0]['line'] == 8 and problems[0]['hint'], 'check finds the fault with its hint')
    expect(page.ask('check', text=PROGRAM)['problems'] == [], 'check of the good program')

    text = PROGRAM.replace('F600', 'F700')
    saved = page.ask('save', file='part.nc', text=text, digest=opened['digest'])
    expect((folder / 'part.nc').read_text() == text and 'digest' in saved, 'save')
    expect(page.ask('save', file='part.nc', text='x', digest=opened['digest'])['error'].get('changed'), 'what has changed since is not saved over')
    for name in ('../x.nc', '.x.nc', 'link', 'sublink/x.nc', '/tmp/x.nc', 'picture.png', 'new.sh', 'X', 'Makefile', 'a\nb.nc', 'a\x1b[31m.nc', 'key.pem', 'id_rsa', ''):
        expect('error' in page.ask('save', file=name, text='x', digest=None), f'save {name!r} is refused')
    expect('error' in page.ask('save', file='other.nc', text='x', digest='1'), 'what was not opened is not saved over')
    expect('error' in page.ask('save', file='other.nc', text='x', digest=None), 'a new file is none where there is one')
    expect('digest' in page.ask('save', file='new.nc', text='M30\n', digest=None), 'a new file is saved')
    for name in ('O1234', '1.001', 'new.json', 'new.toml'):
        expect('digest' in page.ask('save', file=name, text='M30\n', digest=None), f'a new file {name} is saved')
        (folder / name).unlink()
    expect(not [n for n in os.listdir(folder) if n.endswith('.kadr')], 'nothing unfinished is left')
    for name, content in KEYS.items():
        (folder / name).write_text(content)
        refused = [page.ask('read', file=name), page.ask('open', file=name), page.ask('open', file='part.nc', setup=name), page.ask('compare', file=name)]
        expect(all('error' in answer and 'BEGIN' not in str(answer) for answer in refused), f'{name} is not served')
        (folder / name).unlink()
    page.ask('open', file='part.nc')
    expect(all('error' in page.ask(do, wrong=True) for do in ('cut', 'part') * 60), 'a question that is refused is no mistake')
    page.ask('language', lang='ru')
    russian = page.ask('check', text='G1 X10 F100 G0\nM30\n')['problems']
    expect(russian and any('а' <= c <= 'я' for c in russian[0]['text']), 'Russian')

    other = Page(server)
    greeting = other.ask('hello', token='0' * 32)
    expect(not greeting['may_change'], 'a wrong token may look')
    expect(hello['last'] is None and greeting['last'] == 'part.nc', 'the file that was opened last')
    expect('error' in other.ask('save', file='new2.nc', text='x', digest=None) and not (folder / 'new2.nc').exists(), 'and saves nothing')


KEY = '-----BEGIN PRIVATE KEY-----\nMIIEvQIBADANBgkqhkiG9w0BAQEFAASCBKcwggSjAgEAAoIBAQC7\n-----END PRIVATE KEY-----\n'
KEYS = {'key.pem': KEY, 'id_rsa': KEY, 'key.nc': KEY, 'key.txt': KEY, 'key.json': KEY, '1': KEY, 'passwords': 'bank: 1234 house\nmail: another word\n', 'run.sh': '#!/bin/sh\necho secret words\n'}
TOOLS = [{'number': 1, 'kind': 'flat', 'diameter': 8, 'flute_length': 20, 'length': 30, 'from': 'here', 'known': True}]
BLOCK = 'box:-10,-10,-10,60,30,0'


def part_points(frame):
    """Returns points, tools and lines of a frame of kind 3."""
    kind, which, count, triangles = struct.unpack_from('<4I', frame)
    expect(kind == 3 and which == 0 and len(frame) == 16 + 20 * count + 12 * triangles, 'the size of a frame of the part')
    at = struct.unpack_from(f'<{3 * count}f', frame, 16)
    corners = struct.unpack_from(f'<{3 * triangles}I', frame, 16 + 12 * count)
    made = struct.unpack_from(f'<{2 * count}H', frame, 16 + 12 * count + 12 * triangles)
    lines = struct.unpack_from(f'<{count}I', frame, 16 + 16 * count + 12 * triangles)
    expect(not corners or max(corners) < count, 'triangles between points that are there')
    return [at[3 * i:3 * i + 3] for i in range(count)], made[::2], lines


def cut_by_command(kadr, folder, *more):
    words = [kadr, 'cut', str(folder / 'part.nc'), '--control', 'mach3', '--stock', BLOCK, '--tools', str(folder / 'tools.toml'), '--json', '-', '-q', *more]
    return json.loads(subprocess.run(words, capture_output=True, text=True, timeout=harness.TIME_LIMIT_S).stdout)


def cut(page, **more):
    """Returns the answer to `cut`, and its event."""
    answer = page.ask('cut', wrong=None, **{'stock': BLOCK, 'tools': TOOLS, **more})
    return answer, (None if 'error' in answer else page.until('cut'))


def shown(page, instant):
    """Returns the answer to `part`, and its frame."""
    page.frames = []
    answer = page.ask('part', at=instant)
    return answer, (page.frames[-1] if page.frames else None)


def the_part(kadr, server, folder):
    (folder / 'tools.toml').write_text('[[tool]]\nnumber = 1\nkind = "flat"\ndiameter = 8\nflute_length = 20\nlength = 30\n')
    (folder.parent / 'outside.toml').write_text((folder / 'tools.toml').read_text())
    (folder / 'part.nc').write_text(PROGRAM)
    page = Page(server)
    page.ask('hello', token=server.token, lang='en')
    expect('error' in page.ask('cut', stock=BLOCK, tools=TOOLS) and 'error' in page.ask('part', at=1), 'without a program nothing is cut')
    _, done = page.open('part.nc', control='mach3')
    expect('error' in page.ask('part', at=1), 'a part before a cut')

    proposed = page.ask('proposals')
    keys = set(SCHEMA['$defs']['tool']['properties'])
    told = re.search(r'^`Tool`: `\{([^}]*)\}`', (harness.ROOT / 'docs/panel-protocol.md').read_text(encoding='utf-8'), re.M)[1]
    expect({key.strip(' ?\n') for key in told.split(',')} == keys, f'the keys of a tool are those of the schema: {told}')
    row = re.search(r'tool_keys\[\] = \{(.*?)\}', (harness.ROOT / 'src/config/tools/tool_library.cpp').read_text(encoding='utf-8'), re.S)
    expect(set(re.findall(r'"(\w+)"', row[1])) == keys - {'from', 'known', 'by_offset'}, 'and those of a tools file, as they are called now')
    expect(all('flute_length' in tool for tool in proposed['tools']), f'tools are proposed as a tools file has them: {proposed["tools"]}')
    _, by_proposal = cut(page, tools=proposed['tools'])
    expect(by_proposal['notes'] == [], f'nothing is to be said of what was proposed: {by_proposal["notes"]}')
    expect(proposed['stock'] == 'box:-5,-5,-5,55,25,0', f'a blank is proposed: {proposed["stock"]}')
    expect(proposed['files'] == ['tools.toml'] and [t['number'] for t in proposed['tools']] == [1], 'tools are proposed')
    expect(proposed['tools'][0]['from'] == 'tools.toml' and proposed['tools'][0]['known'] and proposed['tools'][0]['diameter'] == 8, 'by the file beside')
    expect('error' in page.ask('proposals', tools='../outside.toml'), 'proposals by a file beyond the folder')

    answer, result = cut(page)
    expect('error' not in answer and 'error' not in result, 'cut')
    wanted = cut_by_command(kadr, folder)
    for key in ('stock', 'left', 'removed', 'error_bound', 'resolution', 'seconds', 'tools', 'collisions', 'heaviest', 'emptiest', 'alarms', 'warnings'):
        expect(result[key] == wanted[key], f'the same {key} as kadr cut')
    answer, frame = shown(page, 1e9)
    points, tools, lines = part_points(frame)
    expect(abs(answer['left'] - wanted['left']) < 2 * wanted['error_bound'] + 1 and answer['triangles'] > 1000, 'at the end what kadr cut leaves')
    expect(max(p[0] for p in points) > 59.9 and min(p[2] for p in points) < -9.9, 'where it lies')
    expect(set(tools) == {1, 65535} and {0, 7, 8, 9} <= set(lines) and all((t == 65535) == (n == 0) for t, n in zip(tools, lines)), 'who made it')
    for share in (0, 0.3, 0.55, 0.8):
        instant = share * done['seconds']
        answer, frame = shown(page, instant)
        until = cut_by_command(kadr, folder, '--until', f'{instant}s', '--resolution', str(answer['cell']))
        expect(abs(answer['left'] - until['left']) < 0.2 and abs(answer['seconds'] - instant) < 1e-9, f'at {instant} s what a cut until then leaves')
    expect(shown(page, -1e300)[0]['left'] > 0.99 * wanted['stock'] and 'error' not in shown(page, 1e300)[0], 'instants beyond both ends')
    for at in (None, 'x', [1], {}):
        page.ask('part', wrong=None, at=at)

    _, by_file = cut(page, tools='tools.toml')
    expect(by_file['left'] == wanted['left'], 'tools by a file')
    _, finer = cut(page, resolution=0.25)
    expect(finer['resolution'] == 0.25 and shown(page, 1e9)[0]['cell'] == 0.5, 'a finer cell, and what is shown')
    hit = dict(TOOLS[0], flute_length=1)
    page.events = []
    _, result = cut(page, tools=[hit], fixtures=['box:30,-10,-10,60,30,-1'])
    findings = [e for e in page.events if e.get('event') == 'finding']
    expect({f['id'] for f in findings} >= {'fixture', 'shank_in_stock'} or {f['id'] for f in findings} >= {'fixture', 'beyond_flutes'}, 'findings')
    expect(len(result['marks']) == len(findings) == len(result['collisions']), 'a mark for each finding')
    expect(all(0 < f['at'] < done['seconds'] and len(f['place']) == 3 and f['line'] > 0 and f['text'] for f in findings), 'findings have their instant')
    for name, more in {
        'a tools file beyond the folder': {'tools': '../outside.toml'}, 'an absolute one': {'tools': '/etc/passwd'}, 'a link': {'tools': 'link'},
        'a tools file that is none': {'tools': 'part.nc'}, 'no tools': {'tools': []}, 'tools that are none': {'tools': [1]}, 'a tools number': {'tools': 7},
        'a tool without a diameter': {'tools': [{'number': 1, 'kind': 'flat', 'flute_length': 5}]}, 'a huge tool': {'tools': [dict(TOOLS[0], diameter=1e300)]},
        'a tool twice': {'tools': TOOLS + TOOLS}, 'another tool alone': {'tools': [dict(TOOLS[0], number=2)]},
        'a tool that is no number': {'tools': [dict(TOOLS[0], diameter=None)]}, 'an unknown key': {'tools': [dict(TOOLS[0], size=1)]},
        'no blank': {'stock': ''}, 'a flat blank': {'stock': 'box:0,0,0,1,1,0'}, 'a blank without end': {'stock': 'box:0,0,0,1,1,1e300'},
        'a blank that is no number': {'stock': 'box:0,0,0,1,1,nan'}, 'a mesh beyond the folder': {'stock': '../a.stl'}, 'no mesh': {'stock': 'part.stl'},
        'a fixture beyond the folder': {'fixtures': ['/tmp/a.stl']}, 'fixtures that are none': {'fixtures': 'box'}, 'too many': {'fixtures': [BLOCK] * 101},
        'no cell': {'resolution': 0}, 'a cell below': {'resolution': -1}, 'a tiny one': {'resolution': 1e-9}, 'a huge one': {'resolution': 1e300},
        'a cell that is none': {'resolution': 'x'}, 'more memory than there may be': {'stock': 'box:0,0,0,1000,1000,1000', 'resolution': 0.1},
    }.items():
        answer, _ = cut(page, **more)
        expect('error' in answer and answer['error']['text'], f'cut with {name} is refused')
    expect('error' in page.ask('part', at=1), 'after a refusal nothing is cut')
    _, result = cut(page, stock='box:-1e5,-1e5,-1e5,1e5,1e5,1e5')
    expect('error' not in result and result['resolution'] >= 250, 'a huge blank gets a huge cell')

    # Two cuts at once: one runs after the other.
    page.begin('cut', stock=BLOCK, tools=TOOLS)
    page.answer(page.begin('cut', stock=BLOCK, tools=TOOLS))
    expect(page.until('cut')['left'] == wanted['left'] and page.until('cut')['left'] == wanted['left'], 'two cuts, one after the other')

    # A cut that is stopped in the middle ends at once, and the next one works.
    (folder / 'long.nc').write_text('G21 G90\nT1 M6\nS1000 M3\nG0 X0 Y0 Z5\nG1 Z-2 F500\n' +
                                    ''.join(f'G1 X{n % 50} Y{n // 50 % 20} Z{-2 - n % 7 / 10}\n' for n in range(300_000)) + 'M30\n')
    page.open('long.nc', control='mach3')
    expect('error' not in page.ask('cut', stock=BLOCK, tools=TOOLS, resolution=0.1), 'a long cut begins')
    while not any(e.get('event') == 'cutting' for e in page.events):
        message = page.take()
        page.events += [message] if message else []
    before = server.spent()
    stopping = page.begin('stop')
    stopped = page.until('cut')
    took = server.spent() - before
    expect(stopped.get('error') and took < 3, f'a cut is stopped, {took:.1f} s of work later')
    page.answer(stopping)
    expect('error' in page.ask('part', at=1), 'of a cut that was stopped nothing is shown')
    page.open('part.nc', control='mach3')
    expect('error' in page.ask('part', at=1), 'a program that is opened has not been cut')
    expect(cut(page)[1]['left'] == wanted['left'], 'after that the next cut')
    page.ask('language', lang='ru')
    expect('инструмент' in page.ask('cut', stock=BLOCK, tools=[dict(TOOLS[0], number=2)])['error']['text'], 'what is refused in Russian')


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
    expect(page.ask('outline')['entries'][0]['kind'] == 'program', 'outline: more in serve_outline.py')
    fixes = [p.get('fix') for p in page.ask('check', text='G21 G90\nG1 X1 X2 F100\nM30\n')['problems']]
    expect(len(fixes) == 1 and fixes[0] and fixes[0]['line'] == 2 and fixes[0]['insert'] == '' and 'X2' in fixes[0]['text'], 'a quick fix')
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
    expect(page.answer(comparing), 'compare: it is stopped')  # else it never ends


def channels(kadr):
    """A program of several channels: the paths of all channels, and the states of its own."""
    server = Server(kadr, Path(__file__).resolve().parent.parent / 'examples' / 'two-channels')
    page = Page(server)
    page.ask('hello', token=server.token, lang='en')
    opened, done = page.open('milling.nct', control='nct', setup='milling.json')
    expect(done is not None and done['state'] == 'ended', f'two channels: {opened.get("error")}')
    numbers = {struct.unpack_from('<4I', frame)[3] for frame in page.frames}
    expect(numbers == {0, 1}, f'two channels: paths of both, {numbers}')
    for part in (0.1, 0.5, 0.9, 0.3):
        state = page.ask('state', at=done['seconds'] * part)
        expect(state.get('line', 0) > 0 and state['modal'], f'two channels: a state, {state}')
    expect('several channels' in page.ask('compare', text='G0 X1\nM30\n')['error']['text'], 'two channels are not compared')
    server.end()


def turned(point, joint, position):
    """Returns a point moved by a joint (docs/panel-protocol.md, frames of kind 4)."""
    if not joint['turns']:
        return [p + position * d for p, d in zip(point, joint['direction'])]
    angle, k = math.radians(position), joint['direction']
    v = [p - t for p, t in zip(point, joint['through'])]
    along = sum(a * b for a, b in zip(k, v))
    across = [k[1] * v[2] - k[2] * v[1], k[2] * v[0] - k[0] * v[2], k[0] * v[1] - k[1] * v[0]]
    return [t + math.cos(angle) * a + math.sin(angle) * b + (1 - math.cos(angle)) * along * c for t, a, b, c in zip(joint['through'], v, across, k)]


def five_axes(kadr):
    """Rotary tables: transformed back to the machine, the tool's tip is below where X and Y are."""
    server = Server(kadr, Path(__file__).resolve().parent.parent / 'examples' / 'five-axes')
    page = Page(server)
    page.ask('hello', token=server.token, lang='en')
    _, done = page.open('trunnion_drilling.nct', control='nct', machine='table-table', setup='trunnion_drilling.json')
    joints = done['joints']
    expect([j['axis'] for j in joints] == ['A', 'C'] and all(j['turns'] for j in joints), f'five axes: joints {joints}')
    heads = [struct.unpack_from('<4I', frame) for frame in page.frames]
    expect([h[0] for h in heads[:3]] == [1, 2, 4] and heads[2][2] == heads[0][2] and len(page.frames[2]) == 16 + 8 * heads[0][2], f'five axes: positions of each vertex {heads}')
    rows, positions = vertices(page.frames[0]), [struct.unpack_from('<2f', page.frames[2], 16 + 8 * i) for i in range(heads[2][2])]
    leant = 0
    for i in range(1, len(rows)):
        if rows[i][1] <= rows[i - 1][1] or (i + 1 < len(rows) and rows[i + 1][1] <= rows[i][1]):
            continue
        state, point = page.ask('state', at=rows[i][1]), rows[i][0]
        for joint, position in list(zip(joints, positions[i]))[::-1]:
            point = turned(point, joint, position)
        machine = state['machine']
        if abs(machine['A'] - positions[i][0]) > 1e-3 or abs(machine['C'] - positions[i][1]) > 1e-3:
            continue  # the state is that at the end of its block, which continues
        expect(math.hypot(point[0] - machine['X'], point[1] - machine['Y']) < 0.01, f'five axes: vertex {i} is at {point} on the machine, the axes at {machine}')
        leant += abs(positions[i][0]) > 1
    expect(leant > 10, f'five axes: only {leant} places with a turned part were looked at')
    server.end()


def extents(server, folder):
    """The extents of a program with two work offsets agree with the picture."""
    (folder / 'two.nc').write_text('G21 G90 F1000\nG10 L2 P2 X100 Y0 Z0\nG54 G1 X10\nG55 X10 Y5\nM2\n')
    page = Page(server)
    page.ask('hello')
    _, done = page.open('two.nc', control='linuxcnc')
    expect(done['extents']['cutting'] == [[0, 0, 0], [110, 5, 0]], f'extents with two work offsets ({done["extents"]})')
    _, done = page.open('two.nc', control='linuxcnc', text='G21 G90 F1000\nG1 X10\nG2 X20 R1\nM2\n')
    alarms = [e for e in page.events if e.get('event') == 'alarm' and e['problem']['severity'] == 'alarm']
    expect(done['state'] == 'stopped' and [a['problem']['line'] for a in alarms] == [3], 'the alarm that stops it is told')


def remembered(server):
    """A .kadr.toml that names the control has priority over a guess; a fault in it is reported."""
    page = Page(server)
    page.ask('hello', token=server.token, lang='en')
    opened, done = page.open('shop/part.nc')
    expect(opened['control']['id'] == 'gost' and not opened['control']['guessed'], f'the folder remembers: {opened["control"]}')
    opened, done = page.open('shop/below/part.ngc')
    expect(opened['control']['id'] == 'linuxcnc', f'a folder below, by its pattern: {opened["control"]}')
    opened, done = page.open('shop/part.nc', control='mach3')
    expect(opened['control']['id'] == 'mach3', 'a control that is named counts before it')
    answer = page.ask('open', file='wrong/part.nc')
    expect('.kadr.toml' in str(answer.get('error')), f'a wrong one is told: {str(answer)[:200]}')
    expect('error' in page.ask('open', file='shop/.kadr.toml', control='gost'), 'it is no program')


def endless(server):
    """An endless program is stopped at once; other sessions continue meanwhile."""
    page = Page(server)
    page.ask('hello', token=server.token)
    page.ask('open', file='endless.nc', control='linuxcnc')
    other = Page(server)
    other.ask('hello')
    expect('entries' in other.ask('files', folder=''), 'another session is answered meanwhile')  # the program never ends
    stop = page.begin('stop')
    expect(page.until('done')['state'] == 'cancelled', 'stop')
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
        for name, text in (('shop', 'control = "gost"\n[control_for]\n"*.ngc" = "linuxcnc"\n'), ('wrong', 'control = \n')):
            (folder / name / 'below').mkdir(parents=True)
            (folder / name / '.kadr.toml').write_text(text)
            (folder / name / 'part.nc').write_text(PROGRAM)
            (folder / name / 'below' / 'part.ngc').write_text(PROGRAM)
        server = Server(kadr, folder, '--open')
        for part in (lambda: http(server), lambda: session(server, folder), lambda: texts(server), lambda: extents(server, folder), lambda: the_part(kadr, server, folder), lambda: remembered(server), lambda: endless(server)):
            part()
        expect(server.process.poll() is None, 'the server still stands')
        expect(server.end() == 130, 'Ctrl-C')
        channels(kadr)
        five_axes(kadr)
        wrong = subprocess.run([kadr, 'serve', str(folder / 'nothing'), '--no-browser'], capture_output=True, text=True, timeout=harness.TIME_LIMIT_S)
        expect(wrong.returncode == 2 and wrong.stderr, 'a folder that is not there')
        alone = Server(kadr, folder)
        page = Page(alone)
        expect('error' in page.ask('hello') and 'error' in page.ask('files'), 'nor on this machine, unless it is open')
        alone.end()
        remote = Server(kadr, folder, '--host', '0.0.0.0', '--open')
        page = Page(remote)
        expect('error' in page.ask('hello', token='x') and 'error' in page.ask('files'), 'beyond this machine nothing without the token')
        expect('error' not in Page(remote).ask('hello', token=remote.token), 'with it all')
        remote.end()
    # Every message that the schema names has occurred, so that the schema has no unused definitions.
    named = {name for name in SCHEMA['$defs'] if '.' in name}
    expect(not named - seen - UNSAID, f'of the schema never said: {sorted(named - seen - UNSAID)}')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
