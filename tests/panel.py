#!/usr/bin/env python3
"""kadr serve: a machine at its panel, as a page drives it (docs/panel-protocol.md, The panel).

    tests/panel.py --kadr build/release/kadr
"""
import argparse
import json
import tempfile
import time
from pathlib import Path

from page_client.client import SCHEMA, Page, Server, expect, result, seen
from page_client.machine import FAST, stands, until

PROGRAM = 'G21 G90 G94\nG0 X10\nG1 X200 F3000\nM0\nG1 Y50\nM30\n'
WITH = {'control': 'mach3', 'machine': 'fast.toml'}


def looker(server, token=True):
    page = Page(server)
    page.ask('hello', lang='en', **({'token': server.token} if token else {}))
    return page


def operator(server):
    page = looker(server)
    expect('error' in page.ask('panel') and 'error' in page.ask('press', key='run'), 'no machine is looked at')
    on = page.ask('machine', file='part.nc', **WITH)
    expect('error' not in on, f'it is on: {on}')
    expect(on['holds'] and on['axes'][:3] == ['X', 'Y', 'Z'] and on['machine'] == 'fast', f'it is on: {on}')
    panel = page.ask('panel')
    expect(panel['mode'] == 'standing' and panel['line'] == 1 and panel['holds'], 'it stands before the first block')

    expect('error' not in page.ask('press', key='run'), 'run')
    moving = until(page, lambda p: p['mode'] == 'running' and p['line'] == 3 and p['machine']['X'] > 20)
    expect(abs(moving['togo']['X'] + moving['position']['X'] - 200) < 1e-6 and moving['speed'] > 0 and moving['feed'] == 3000, f'on its way {moving}')
    expect(any(m['code'] == 'G1' for m in moving['modal']), 'codes in force')
    expect('error' in page.ask('enter', line='G0 X0') and 'error' in page.ask('jog', axis='X', way=1.0), 'nothing else while it runs')
    page.ask('press', key='hold')
    held = stands(page, 'held')
    time.sleep(0.05)
    again = page.ask('panel')
    expect(again['machine'] == held['machine'] and again['speed'] == 0 and 20 < held['machine']['X'] < 200, 'a feed hold stands')
    page.ask('switches', override=0.5)
    page.ask('press', key='run')
    stopped = until(page, lambda p: p['mode'] == 'standing' and p['line'] == 5)
    expect(stopped['machine']['X'] == 200 and stopped['why'] == 'M0', 'M0 stands')
    page.ask('switches', override=1.0, single=True, optional_stop=True)
    page.ask('switches', skip=3, on=True)
    expect(page.ask('panel')['skip'] == [3], 'skip')
    page.ask('press', key='run')
    until(page, lambda p: p['mode'] == 'standing' and p['line'] == 6 and p['machine']['Y'] == 50)

    page.ask('enter', line='G91 G0 Z-4')
    until(page, lambda p: p['mode'] == 'standing' and p['machine']['Z'] == -4 and p['can_undo'] == 1)
    page.ask('undo')
    back = page.ask('panel')
    expect(back['machine']['Z'] == 0 and back['can_undo'] == 0 and any(m['code'] == 'G90' for m in back['modal']), 'undone')
    page.ask('enter', line='G0 X5 X6')
    alarm = until(page, lambda p: p['alarm'] is not None and p['mode'] == 'standing')
    expect(alarm['alarm']['hint'] and alarm['mode'] == 'standing', f'a faulty line is told {alarm["alarm"]}')
    expect(all('error' in page.ask('enter', wrong=None, line=line) for line in ('', 'G0 X1\nG0 X2', 'X' * 2000, 7)), 'what is no line')
    page.ask('jog', axis='Y', way=-10.0, feed=6000.0)
    until(page, lambda p: p['mode'] == 'standing' and p['machine']['Y'] == 40 and p['position']['Y'] == 40)
    expect(all('error' in page.ask('jog', wrong=None, **{'axis': 'X', **bad}) for bad in ({'way': 1e9}, {'way': 400.0}, {'axis': 'Q', 'way': 1.0}, {'way': 'x'}, {})), 'jogs that are none')

    page.ask('press', key='reset')
    fresh = until(page, lambda p: p['mode'] == 'standing' and p['line'] == 1)
    expect(fresh['machine']['Y'] == 40 and fresh['single'], 'a reset leaves the axes and the switches')
    page.ask('switches', single=False)
    number = page.ask('stops', condition='#5221 < 1')
    expect('error' in page.ask('stops', condition='#1 >') and 'error' in page.ask('stops', wrong=None) and 'error' in page.ask('stops', remove=99), 'stop points that are none')
    expect(page.ask('panel')['stops'][0]['condition'] == '#5221 < 1', 'a stop point')
    page.ask('stops', remove=number['number'])
    line = page.ask('stops', line=5)
    page.ask('press', key='run')
    until(page, lambda p: p['mode'] == 'standing' and p['line'] == 5)
    expect('error' not in line and 'error' in page.ask('press', wrong=None, key='dance'), 'keys')
    return page


def many(server, first):
    """Two pages on one machine, a page that may only watch, and the emergency stop."""
    second = looker(server)
    on = second.ask('machine', file='part.nc')
    expect(not on['holds'] and second.ask('panel')['line'] == 5, 'another page sees the same machine')
    expect('controls' in second.ask('press', key='run')['error']['text'], 'and has no hand on it')
    second.ask('press', key='take')
    expect(second.ask('panel')['holds'] and not first.ask('panel')['holds'] and 'error' in first.ask('press', key='run'), 'unless it takes the controls')
    third = looker(server, token=False)
    expect('error' not in third.ask('machine', file='part.nc') and 'error' in third.ask('press', key='take') and 'error' in third.ask('press', key='run'), 'without the token it looks')
    expect('error' in third.ask('machine', file='other.nc', **WITH), 'and switches nothing on')

    second.ask('press', key='reset')
    until(second, lambda p: p['mode'] == 'standing' and p['line'] == 1)
    second.ask('enter', line='G0 X0 Y0')
    until(second, lambda p: p['mode'] == 'standing' and p['machine']['X'] == 0)
    second.ask('press', key='run')
    until(second, lambda p: p['machine']['X'] > 30)
    first.ask('press', key='emergency')  # by any page, with or without control of the machine
    there = stands(second, 'emergency')
    expect(there['machine']['X'] < 200 and 'error' in second.ask('press', key='run') and 'error' in second.ask('enter', line='G0 X0'), 'an emergency stop stands')
    second.ask('press', key='reset')
    expect(stands(second)['machine'] == there['machine'], 'until the reset')
    second.ask('press', key='run')
    for page in (first, second, third):
        page.socket.close()
    page = looker(server)
    expect(page.ask('machines')['machines'][0]['name'] == 'part.nc', 'it is on though nobody looks')
    expect(page.ask('machine', file='part.nc')['holds'], 'the controls are free again')
    until(page, lambda p: p['mode'] == 'standing' and p['line'] == 4 or p['line'] == 5)
    page.ask('press', key='off')
    expect(page.ask('machines')['machines'] == [] and 'error' in page.ask('panel'), 'off')


def endless(server):
    page = looker(server)
    page.ask('machine', file='endless.nc', control='linuxcnc', machine='fast.toml')
    page.begin('press', key='run')
    stop = page.ask('press', key='emergency')  # the program never ends: waiting for its end would never end
    expect('error' not in stop, 'an emergency stop does not wait for a busy control')
    stands(page, 'emergency')
    page.ask('press', key='reset')
    stands(page)
    expect('error' in page.ask('machine', file='nothing.nc', **WITH), 'a program that is not there')
    expect('error' in page.ask('machine', file='../outside.nc', **WITH), 'a program beyond the folder')


def by_hand(server):
    """An axis that a held key moves, an override above 100 %, the line of an M0."""
    page = looker(server)
    page.ask('machine', file='part.nc', **WITH)
    expect('error' not in page.ask('jog', axis='X', way=1.0, feed=6000.0, held=True), 'a key is held')
    for _ in range(6):
        time.sleep(0.1)
        expect(page.ask('jogging', on=True)['moves'], 'it is still held')
    expect(page.ask('jogging', on=False)['moves'], 'it is released')
    there = stands(page)
    expect(30 < there['machine']['X'] < 190 and there['line'] == 1, f'the axis has moved: {there}')
    expect(not page.ask('jogging', on=True)['moves'], 'nothing moves by a key')
    expect('error' in page.ask('jog', axis='X', way=0.0, held=True) and 'error' in page.ask('jog', axis='Q', way=1.0, held=True), 'keys that are none')
    page.ask('jog', axis='X', way=-1.0, feed=6000.0, held=True)
    page.socket.close()  # the page dies with the key held
    page = looker(server)
    page.ask('machine', file='part.nc', **WITH)
    dead = stands(page)
    expect(dead['machine']['X'] > there['machine']['X'] - 60, f'the machine stops by itself: {dead}')
    page.ask('enter', line='G0 X0 Y0')
    until(page, lambda p: p['mode'] == 'standing' and p['machine']['X'] == 0)
    expect('error' in page.ask('switches', wrong=True, override=2.1) and 'error' in page.ask('switches', rapid=1.1), 'overrides beyond the limits')
    expect('error' not in page.ask('switches', override=1.5), 'an override above 100 %')
    page.ask('press', key='run')
    fast = until(page, lambda p: p['line'] == 3 and p['speed'] > 4400)
    expect(fast['override'] == 1.5 and fast['share'] > 1.4 and fast['feed'] == 3000, f'150 % {fast}')
    stop = until(page, lambda p: p['mode'] == 'standing' and p['why'] == 'M0')
    expect(stop['stop_line'] == 4 and stop['stop_text'] == 'M0', f'the line of M0 {stop}')
    page.ask('press', key='off')


def saved_meanwhile(server, folder):
    """The machine runs the text it started with, with the line numbers of that text, until it starts again; its tables and positions
    likewise."""
    page = looker(server)
    file = folder / 'saved.nc'
    file.write_text(PROGRAM)
    page.ask('machine', file='saved.nc', **WITH)
    first = page.ask('machine_source')
    expect(first['text'] == PROGRAM and first['digest'] == page.ask('panel')['digest'], f'its text {first}')
    page.ask('press', key='run')
    held = until(page, lambda p: p['mode'] == 'standing' and p['why'] == 'M0')
    new = PROGRAM.replace('G0 X10', 'G1 Z-99 F500\nG1 Z-98\nG0 X10')
    file.write_text(new)
    expect(page.ask('panel')['line'] == 5 and page.ask('machine_source') == {**first, 're': page.ask('machine_source')['re'] - 1}, 'as it began')
    while not (sheet := page.ask('restart', line=3)).get('ready') and 'error' not in sheet:
        time.sleep(0.01)
    expect(sheet.get('text', '').startswith('G1 X200'), f'places are those of its text: {sheet}')
    expect('error' not in page.ask('edit', tables={'work_offsets': {'G55': {'X': 7}}}), 'tables are edited')
    until(page, lambda p: not p['takes_tables'])
    page.ask('press', key='run')
    end = until(page, lambda p: p['mode'] == 'ended')
    expect(end['machine'] == {**held['machine'], 'Y': 50} and end['line'] == 5 and end['text'] == 'G1 Y50', f'it ends as it began {end}')
    page.ask('switches', single=True)
    page.ask('press', key='run')
    until(page, lambda p: p['mode'] == 'standing' and p['line'] == 2)
    expect(page.ask('machine_source')['text'] == new and page.ask('panel')['digest'] != first['digest'], 'from its next start on it is the new one')
    file.unlink()
    page.ask('press', key='reset')
    until(page, lambda p: p['mode'] == 'ended')
    expect('error' in page.ask('machine_source') and page.ask('panel')['digest'] == '', 'gone')
    page.ask('press', key='off')


AT_REST = 'G21 G90 G94 F3000\nT1 M6\nG43 H1\nS1200 M3\nM8\nM98 P7\nG0 X1\nM30\nO0007\nG55\nG1 X12\nM99\n%\n'
AT_REST_SETUP = {'offsets': {'1': {'length': 50}}, 'work_offsets': {'G55': {'X': 7}}}


def at_rest(server):
    """Changes by blocks and lines without a motion are displayed too; refused edits are not kept; stop points keep their numbers."""
    page = looker(server)
    page.ask('machine', file='rest.nct', control='nct', machine='fast.toml', setup='rest.json')

    def codes(panel):
        return {m['code'] for m in panel['modal']}

    page.ask('enter', line='S700 M3')
    until(page, lambda p: p['rpm'] == 700 and 'M3' in codes(p))
    page.ask('enter', line='T4 M6')
    until(page, lambda p: p['tool'] == 4)
    page.ask('enter', line='G55')
    until(page, lambda p: 'G55' in codes(p) and p['zero']['X'] == 7 and p['position']['X'] == -7)
    page.ask('enter', line='G10 L2 P2 X8')
    until(page, lambda p: p['zero']['X'] == 8 and p['position']['X'] == -8)
    page.ask('undo')
    until(page, lambda p: p['zero']['X'] == 7)
    page.ask('enter', line='M99')  # no program has called it
    alarm = until(page, lambda p: p['alarm'] is not None and p['mode'] == 'standing')
    expect(alarm['machine']['X'] == 0 and alarm['mode'] == 'standing', f'a line does not end the program: {alarm}')

    page.ask('press', key='reset')
    stands(page)
    page.ask('switches', single=True)
    for done, is_so in (('G21', lambda p: 'G94' in codes(p)), ('T1', lambda p: p['tool'] == 1), ('G43', lambda p: p['offsets']['H'] == 1), ('S1200', lambda p: p['rpm'] == 1200 and 'M3' in codes(p)), ('M8', lambda p: 'M8' in codes(p)), ('M98', lambda p: [c['line'] for c in p['calls']] == [6])):
        page.ask('press', key='run')
        until(page, lambda p: p['mode'] == 'standing' and is_so(p), 10)
        expect(True, done)
    page.ask('switches', single=False)

    expect('error' in page.ask('edit', tables={'variables': {'#5021': 1}}), 'a variable that cannot be given')
    expect('error' in page.ask('edit', tables={'axes': {}}), 'a table that is none')
    expect(page.ask('tables')['edited'].get('variables') is None, 'what is refused is not kept')
    page.ask('press', key='reset')
    stands(page)
    expect('error' not in page.ask('edit', tables={'offsets': {'2': {'length': 5}}}), 'the next one is taken')

    for line in (3, 5):
        page.ask('stops', line=line)
    page.ask('stops', remove=1)
    page.ask('press', key='reset')
    numbers = [stop['number'] for stop in stands(page)['stops']]
    expect(numbers == [2] and 'error' not in page.ask('stops', remove=2), f'stop points keep their numbers: {numbers}')
    expect(page.ask('panel')['stops'] == [], 'and are removed by them')
    page.ask('press', key='off')


def gone(server, folder):
    """The program file is deleted while its machine is on."""
    page = looker(server)
    (folder / 'gone.nc').write_text(PROGRAM)
    page.ask('machine', file='gone.nc', **WITH)
    (folder / 'gone.nc').unlink()
    page.ask('press', key='emergency')
    stands(page, 'emergency')
    expect('error' in page.ask('press', key='reset'), 'the program is not there any more')
    stands(page, 'ended')
    expect('error' not in page.ask('jog', axis='Z', way=7.0), 'but the tool can be lifted')
    until(page, lambda p: p['machine']['Z'] == 7 and p['mode'] in ('ended', 'standing'))
    page.ask('press', key='off')


HOLES = {'a.nct': ('nct', 'G21 G90 G94 F3000\nG0 X10 Y10 Z20\nG81 X10 Y10 Z-5 R2\nX20\nG80\nM30\n', {1: 10}),
         'b.ngc': ('linuxcnc', 'G21 G90 G94 F3000\nG0 X10 Y10 Z20\nG91 G81 X5 Y0 Z-15 R-5 L3\nG80 G90\nM2\n', {1: 15, 2: 20, 3: 25, 4: None}),
         'c.nc': ('mach3', 'G21 G90 G94 F3000\nG0 X10 Y10 Z20\nG81 X10 Y10 Z-5 R2\nG80\nM30\n', {1: 10, 2: None}),
         'd.nct': ('nct', 'G21 G90 G94 F3000\nG0 X0 Y10 Z20\nG91 G81 X5 Z-15 R-18 L3\nG80\nM30\n', {1: 5, 2: 10, 3: 15, 4: None})}


def holes(server):
    """Restarts at a drilled hole: the tool may already be over the first one."""
    page = looker(server)
    for name, (control, _, places) in HOLES.items():
        expect('error' not in page.ask('machine', file=name, control=control, machine='fast.toml'), f'{name} is on')
        for hole, x in places.items():
            while not (sheet := page.ask('restart', line=3, hole=hole)).get('ready') and 'error' not in sheet:
                time.sleep(0.01)
            there = next((row['wanted'] for row in sheet.get('rows', []) if row['key'] == 'machine:X'), None)
            expect((there is None) == (x is None) and (x is None or float(there) == x) or (x == 0 and 'error' not in sheet), f'{name}, hole {hole}: {there}, not {x}: {sheet.get("error")}')
        page.ask('press', key='off')


TWO = {'parameters': {'N2201': 501, 'N2202': 510}, 'channels': {'2': {'axes': ['X', 'Z'], 'program': 'G90 G94\nG1 Z50 F3000\nM501 P12\nG0 X5\nM30'}}}


def channels(server):
    """Two channels that wait for each other; a motion by hand."""
    page = looker(server)
    expect('error' not in page.ask('machine', file='two.nct', control='nct', machine='fast.toml', setup='two.json'), 'two channels are on')
    both = page.ask('panel')['channels']
    expect([c['number'] for c in both] == [1, 2] and both[1]['axes'] == ['X', 'Z'] and both[0]['waits'] is None, f'side by side {both}')
    page.ask('press', key='run')
    waits = until(page, lambda p: p['channels'][0]['waits'])
    expect(waits['channels'][0]['waits'] == {'code': 501, 'channels': [1, 2], 'here': [1]} and waits['channels'][1]['moves'], f'who waits for whom {waits["channels"]}')
    expect(waits['channels'][1]['machine']['Z'] < 50 and waits['mode'] == 'running', 'the other is on its way')
    end = until(page, lambda p: p['mode'] == 'ended')
    expect(end['channels'][0]['machine']['X'] == 20 and end['channels'][1]['machine'] == {'X': 5, 'Z': 50}, f'both have come {end["channels"]}')
    page.ask('jog', axis='Z', way=-2.0, channel=2)
    until(page, lambda p: p['mode'] in ('ended', 'standing') and p['channels'][1]['machine']['Z'] == 48)
    expect('error' in page.ask('jog', axis='Y', way=1.0, channel=2) and 'error' in page.ask('jog', axis='X', way=1.0, channel=7), 'axes and channels that there are not')
    while not (sheet := page.ask('restart', line=3)).get('ready') and 'error' not in sheet:
        time.sleep(0.01)
    expect([b['number'] for b in sheet.get('beside', [])] == [2], f'going on in mid program, a sheet of each: {sheet}')
    way = [{'rapid': True, 'to': {'Z': 10.0}, 'feed': 0}, {'rapid': False, 'to': {'X': 30.0, 'Y': 5.0}, 'feed': 6000.0}]
    expect('error' not in page.ask('lead', way=way), 'a way by hand')
    until(page, lambda p: p['mode'] in ('ended', 'standing') and p['machine'] == {'X': 30, 'Y': 5, 'Z': 10})
    bad = [[], [{'rapid': True, 'to': {'X': 1e6}, 'feed': 0}], [{'rapid': False, 'to': {'X': 1.0}, 'feed': 0}], [{'rapid': True, 'to': {'Q': 1.0}, 'feed': 0}]]
    expect(all('error' in page.ask('lead', way=one) for one in bad), 'ways that are none')
    page.ask('press', key='off')


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    kadr = options.parse_args().kadr
    with tempfile.TemporaryDirectory() as above:
        folder = Path(above) / 'programs'
        folder.mkdir()
        (folder / 'part.nc').write_text(PROGRAM)
        (folder / 'other.nc').write_text(PROGRAM)
        (folder / 'fast.toml').write_text(FAST)
        (folder / 'two.nct').write_text('G90 G94\nG0 X10\nM501 P12\nG0 X20\nM30\n')
        (folder / 'two.json').write_text(json.dumps(TWO))
        (folder / 'rest.nct').write_text(AT_REST)
        (folder / 'rest.json').write_text(json.dumps(AT_REST_SETUP))
        for name, (_, text, _) in HOLES.items():
            (folder / name).write_text(text)
        (folder / 'endless.nc').write_text('G90 G21\no100 while [1]\n#1=[#1+1]\no100 endwhile\nM2\n')
        (Path(above) / 'outside.nc').write_text(PROGRAM)
        server = Server(kadr, folder, '--open')
        many(server, operator(server))
        endless(server)
        by_hand(server)
        channels(server)
        at_rest(server)
        holes(server)
        gone(server, folder)
        saved_meanwhile(server, folder)
        expect(server.process.poll() is None and server.end() == 130, 'the server still stands, and ends with machines that are on')
    said = {name for name in seen if '.' in name}
    named = {n for n in SCHEMA['$defs'] if n.split('.')[-1] in ('machines', 'machine', 'panel', 'machine_source', 'press', 'switches', 'enter', 'undo', 'jog', 'lead', 'jogging', 'stops') and '.' in n}
    expect(not named - said, f'of the schema never said: {sorted(named - said)}')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
