#!/usr/bin/env python3
"""Tests kadr serve: restarting in the middle of a program at the panel (docs/panel-protocol.md, Going on in mid program).

    tests/panel_restart.py --kadr build/release/kadr
"""
import argparse
import json
import tempfile
import time
from pathlib import Path

from page_client.client import Page, Server, expect, result, seen
from page_client.machine import FAST, stands, until

PROGRAM = '''%O0001
G21 G90 G17 G54
T5 M6
S800 M3
G0 X10 Y20 Z30
M8
M98 P7 L3
G0 Z30
M30
O0007
G91 G1 Z-1 F6000
G90 X30
Y40
G0 X10 Y20
M99
%
'''
WITH = {'control': 'nct', 'machine': 'fast.toml'}


def find(page, seconds=60, **place):
    end = time.monotonic() + seconds
    while True:
        answer = page.ask('restart', **place)
        if answer.get('ready') or 'error' in answer or time.monotonic() > end:
            return answer
        time.sleep(0.01)


def row(sheet, key):
    return next(r for r in sheet['rows'] if r['key'] == key)


def operator(server):
    page = Page(server)
    page.ask('hello', lang='en', token=server.token)
    expect('error' in page.ask('restart', line=3), 'no machine is looked at')
    page.ask('machine', file='part.nct', **WITH)
    sheet = find(page, line=12, **{'pass': 2}, clearance=40.0, above=3.0, feed=500.0)
    expect(sheet.get('line') == 12 and sheet['text'].strip() == 'G90 X30' and sheet['calls'][0]['line'] == 7, f'the place: {sheet}')
    expect(row(sheet, 'tool:')['wanted'] == 5 and row(sheet, 'tool:')['by'] == 'line' and row(sheet, 'coolant:')['may_be_left'], 'the tool is changed by a line')
    expect(row(sheet, 'machine:Z')['wanted'] == 28 and row(sheet, 'machine:Z')['by'] == 'way', 'the way leads to the second pass')
    expect(row(sheet, 'origin:X')['by'] == '' and sheet['normal'] == 'Z', 'what is as it must be')
    expect([p['rapid'] for p in sheet['way']] == [True, True, True, False] and sheet['way'][0]['to'] == {'Z': 40} and sheet['way'][2]['to'] == {'Z': 31} and sheet['way'][3]['feed'] == 500, f'the way: {sheet["way"]}')
    expect(any('T5' in b and 'M6' in b for b in sheet['blocks']) and sheet['search'] is None, f'as blocks: {sheet["blocks"]}')
    own = find(page, line=12, **{'pass': 2}, by_control=True)
    expect(own['search'] is not None and ('M' in own['search']['forgotten'] or own['search']['carried_out']), f'the search of the control: {own["search"]}')

    expect('reached' in find(page, line=999)['error']['text'] and 'error' in page.ask('restart', wrong=None), 'places that are none')
    expect('error' in page.ask('go_there', line=999, way=[]), 'nor is it gone there')
    sheet = find(page, line=12, **{'pass': 2}, clearance=40.0, feed=6000.0)
    place = {'line': 12, 'pass': 2}
    for bad in ([], sheet['way'][:-1], [{**sheet['way'][0], 'to': {'Q': 1}}], [{**sheet['way'][0], 'to': {'Z': 1e9}}], 'up', [{}], [5]):
        expect('error' in page.ask('go_there', wrong=None, **place, way=bad), f'a way that is none: {bad}')
    expect('error' not in page.ask('go_there', **place, way=sheet['way'], leave=['coolant:', 'nothing']), 'it goes there')
    there = until(page, lambda p: p['mode'] == 'standing' and not p['goes_there'])
    expect(there['why'] == 'restart' and there['line'] == 12 and there['machine']['Z'] == 28 and there['tool'] == 5 and there['rpm'] == 800 and there['calls'][0]['line'] == 7, f'it stands there {there}')
    page.ask('press', key='run')
    end = stands(page, 'ended')
    expect(end['machine']['Z'] == 30 and end['machine']['X'] == 10, f'and goes on to the end {end}')

    # another page controls the machine; the machine runs; an emergency stop during the approach
    other = Page(server)
    other.ask('hello', lang='ru', token=server.token)
    other.ask('machine', file='part.nct', **WITH)
    expect('error' in other.ask('restart', line=12) and 'error' in other.ask('go_there', line=12, way=[]), 'only who holds the controls')
    sheet = find(page, line=12, clearance=200.0, feed=100.0)
    page.ask('go_there', line=12, way=[{**p, 'rapid': False, 'feed': 200.0} for p in sheet['way']])
    until(page, lambda p: p['mode'] == 'running' and p['goes_there'])
    other.ask('press', key='emergency')
    stopped = stands(page, 'emergency')
    expect(not stopped['goes_there'] and 'error' in page.ask('restart', line=12), 'an emergency stop ends it')
    page.ask('press', key='reset')
    until(page, lambda p: p['mode'] == 'standing' and p['line'] == 2)
    page.ask('press', key='off')


CHANNEL_1 = '%O0001\nG21 G90 G94 G54\nT3 M6\nG0 X10\nM501 P12\nG1 X20 F6000\nG4 P0.05\nG1 X30\nM502 P12\nG0 X0\nM30\n%\n'
CHANNEL_2 = 'G21 G90 G94\nT7 M6\nG1 Z50 F6000\nM501 P12\nG0 X5\nM502 P12\nG0 Z0\nM30\n'


def channels(server, folder):
    """Two channels: each has a sheet and an approach, in the requested order; then they continue together, also after a kill."""
    (folder / 'both.nct').write_text(CHANNEL_1)
    (folder / 'both.json').write_text(json.dumps({'parameters': {'N2201': 501, 'N2202': 510}, 'channels': {'2': {'axes': ['X', 'Z'], 'program': CHANNEL_2}}}))
    page = Page(server)
    page.ask('hello', lang='en', token=server.token)
    page.ask('machine', file='both.nct', setup='both.json', **WITH)
    place = {'line': 8}
    sheet = find(page, **place, clearance=40.0, feed=6000.0)
    expect(sheet.get('number') == 1 and len(sheet['beside']) == 1, f'a sheet of each: {sheet}')
    other = sheet['beside'][0]
    expect(other['number'] == 2 and other['line'] == 6 and other['stands'] == 'waits' and 'M502' in other['text'], f'the other waits: {other}')
    expect(row(other, '2/tool:')['wanted'] == 7 and row(other, '2/tool:')['by'] == 'line' and row(sheet, 'tool:')['wanted'] == 3, 'tools of both')
    expect(other['way'] and other['way'][-1]['to'].get('Z', other['way'][0]['to'].get('Z')) == 50, f'its way: {other["way"]}')
    ways = [{'channel': 2, 'way': other['way']}, {'channel': 1, 'way': sheet['way']}]
    for bad in ([], [ways[1]], [{'channel': 3, 'way': []}], [ways[0], ways[0]], 'up', [5], [{'channel': 2}]):
        expect('error' in page.ask('go_there', wrong=None, **place, ways=bad), f'ways that are none: {bad}')
    expect('error' not in page.ask('go_there', **place, ways=ways, leave=['2/tool:']), 'it goes there')
    there = until(page, lambda p: p['mode'] == 'standing' and not p['goes_there'])
    second = there['channels'][1]
    expect(there['why'] == 'restart' and there['line'] == 8 and there['machine']['X'] == 20 and there['tool'] == 3, f'the own channel: {there}')
    expect(second['machine'] == {'X': 5, 'Z': 50} and second['line'] == 6, f'the other: {second}')
    page.ask('press', key='run')
    waits = until(page, lambda p: p['channels'][1]['waits'] or p['mode'] == 'ended')
    expect(waits['mode'] == 'ended' or waits['channels'][1]['waits']['code'] == 502, f'it waits there: {waits["channels"]}')
    end = stands(page, 'ended')
    expect(end['machine']['X'] == 0 and end['channels'][1]['machine'] == {'X': 5, 'Z': 0}, f'and both come to their ends: {end["channels"]}')
    page.ask('press', key='off')


def kept(kadr, folder):
    """After a kill the axes of both channels are where they were, and a restart is offered."""
    options = ('--state', str(folder.parent / 'both.state'))
    server = Server(kadr, folder, *options)
    page = Page(server)
    page.ask('hello', lang='en', token=server.token)
    page.ask('machine', file='both.nct', setup='both.json', **WITH)
    page.ask('stops', line=8)
    page.ask('press', key='run')
    stood = until(page, lambda p: p['mode'] == 'standing' and p['line'] == 8)
    server.process.kill()
    server.process.wait()
    server = Server(kadr, folder, *options)
    page = Page(server)
    page.ask('hello', lang='en', token=server.token)
    on = page.ask('machine', file='both.nct')
    now = page.ask('panel')
    expect([c['machine'] for c in now['channels']] == [c['machine'] for c in stood['channels']], f'all stand where they stood: {now["channels"]}')
    place = {'number': on['stood']['number'], 'line': on['stood']['line']}
    expect(place['line'] == 8, f'it is offered to go on: {on["stood"]}')
    sheet = find(page, **place, clearance=40.0, feed=6000.0)
    expect(sheet.get('ready') and not sheet['way'] and not sheet['beside'][0]['way'], f'nothing is to be gone: {sheet}')
    expect('error' not in page.ask('go_there', **place, ways=[]), 'it stands there')
    until(page, lambda p: p['mode'] == 'standing' and p['why'] == 'restart')
    page.ask('press', key='run')
    end = stands(page, 'ended')
    expect(end['channels'][1]['machine'] == {'X': 5, 'Z': 0}, f'to the end: {end["channels"]}')
    page.ask('press', key='off')
    server.end()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--kadr', required=True)
    kadr = str(Path(parser.parse_args().kadr).resolve())
    with tempfile.TemporaryDirectory() as above:
        folder = Path(above, 'programs')
        folder.mkdir()
        Path(folder, 'part.nct').write_text(PROGRAM)
        Path(folder, 'fast.toml').write_text(FAST)
        server = Server(kadr, folder)
        operator(server)
        channels(server, folder)
        expect(server.process.poll() is None and server.end() == 130, 'the server still stands')
        kept(kadr, folder)
    for name in ('restart', 'go_there'):
        expect(f'answer.{name}' in seen and f'question.{name}' in seen, f'{name} has been held against the schema')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
