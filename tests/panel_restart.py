#!/usr/bin/env python3
"""kadr serve: going on in mid program at the panel (docs/panel-protocol.md, Going on in mid program).

    tests/panel_restart.py --kadr build/release/kadr
"""
import argparse
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

    # another page has the controls; it runs; an emergency stop on the way
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


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--kadr', required=True)
    kadr = str(Path(parser.parse_args().kadr).resolve())
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, 'part.nct').write_text(PROGRAM)
        Path(folder, 'fast.toml').write_text(FAST)
        server = Server(kadr, folder)
        operator(server)
        expect(server.process.poll() is None and server.end() == 130, 'the server still stands')
    for name in ('restart', 'go_there'):
        expect(f'answer.{name}' in seen and f'question.{name}' in seen, f'{name} has been held against the schema')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
