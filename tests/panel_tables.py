#!/usr/bin/env python3
"""Tests kadr serve: the tables of a machine at its panel, its log, watches, answers to questions of the program (docs/panel-protocol.md,
The panel).

    tests/panel_tables.py --kadr build/release/kadr
"""
import argparse
import json
import tempfile
from pathlib import Path

from page_client.client import Page, Server, expect, result, seen
from page_client.machine import FAST, stands, until

PROGRAM = '%O0001\nG21 G90 G17 G54\n#100=5\nG0 X10\nM0\nG10 L2 P1 Y7\n#3107=200(GO ON? YES NO)\n#101=#3107\nG0 X20\nM30\n%\n'
WITH = {'control': 'nct', 'machine': 'fast.toml'}


def looker(server, token=True):
    page = Page(server)
    page.ask('hello', lang='en', **({'token': server.token} if token else {}))
    return page


def operator(server, folder):
    page = looker(server)
    expect('error' in page.ask('tables') and 'error' in page.ask('edit', tables={}) and 'error' in page.ask('shift') and 'error' in page.ask('watch', expressions=['1']), 'no machine is looked at')
    on = page.ask('machine', file='part.nct', **WITH)
    expect(on['stood'] is None and not on['lasts'], f'nothing is kept without a file: {on}')
    tables = page.ask('tables')
    expect('offsets' in tables['sections'] and 'parameters' in tables['sections'] and 'correctors' not in tables['sections'] and tables['edited'] == {} and tables['setup'] == '', f'tables of this control: {tables["sections"]}')
    for wrong in ({'offsets': {'1': {'radius': 'wide'}}}, {'offsets': {'1': {'colour': 1}}}, {'no_table': {}}, {'work_offsets': {'G54': {'Q': 1}}}, {'correctors': {'1': 1}}, {'offsets': 5}):
        refused = page.ask('edit', wrong=None, tables=wrong)
        expect('error' in refused and refused['error']['text'], f'tables that are none: {wrong} {refused}')
    expect('error' in page.ask('edit', wrong=None, tables='x') and page.ask('tables')['edited'] == {}, 'nothing of that was taken')
    done = page.ask('edit', tables={'work_offsets': {'G54': {'X': 100}}, 'offsets': {'1': {'radius': 4}}, 'variables': {'#500': 3}})
    expect(done['edited']['work_offsets'] == {'G54': {'X': 100}}, f'edited: {done}')
    until(page, lambda p: p['mode'] == 'standing' and not p['takes_tables'] and p['zero'].get('X') == 100)
    done = page.ask('edit', tables={'offsets': None})
    expect('offsets' not in done['edited'], 'an edit is taken back')

    opened, ended = page.open('part.nct', tables={'work_offsets': {'G54': {'X': 100}}}, **WITH)
    expect('error' not in opened and ended['extents']['all'][1][0] + ended['zero'][0] == 120, f'the path is by these tables {ended}')
    expect('error' in page.ask('open', file='part.nct', tables={'offsets': {'1': {'radius': 'x'}}}, **WITH), 'and not by wrong ones')

    page.ask('press', key='run')
    first = until(page, lambda p: p['mode'] == 'standing' and p['line'] == 6)
    expect(first['machine']['X'] == 110 and first['why'] == 'M0', f'by the zero that was edited: {first["machine"]}')
    variables = {v['name']: (v['value'], v['line']) for v in page.ask('tables')['variables']}
    expect(variables.get('#100') == (5, 3) and variables.get('#500') == (3, 0), f'which line set them: {variables}')
    values = page.ask('watch', expressions=['#100+1', '#100+', '#777'])['values']
    expect([v['value'] for v in values] == [6, None, None], f'watches {values}')
    page.ask('press', key='run')
    asked = until(page, lambda p: p['mode'] == 'standing' and p['asks'])
    expect('GO ON' in asked['told'] and 'error' in page.ask('press', key='run') and 'error' in page.ask('answer', wrong=None, answer=9), f'a question: {asked["told"]}')
    expect(page.ask('tables')['now']['work_offsets']['G54']['Y'] == 7, 'what the program has made of a table')
    expect('error' not in page.ask('answer', answer=2), 'answered')
    stands(page, 'ended')
    expect('error' not in page.ask('switches', rapid=0.5, spindle=1.1, dry_feed=500.0) and 'error' in page.ask('switches', wrong=None, spindle=3.0) and 'error' in page.ask('switches', wrong=None, rapid=7.0), 'switches')
    panel = page.ask('panel')
    expect((panel['rapid'], panel['spindle'], panel['dry_feed']) == (0.5, 1.1, 500), f'switches are shown: {panel["rapid"]}')
    tool = page.ask('stops', tool=3)
    expect(any(s['tool'] == 3 for s in page.ask('panel')['stops']), 'a stop by tool')
    page.ask('stops', remove=tool['number'])

    log = page.ask('shift')['log']
    kinds = [e['kind'] for e in log]
    expect(kinds[0] == 'on' and 'edit' in kinds and kinds.count('run') == 2 and 'stopped' in kinds and 'ended' in kinds and 'override' in kinds, f'the log: {kinds}')
    expect(len(page.ask('shift', count=2)['log']) == 2 and all(e['at'].endswith('Z') for e in log), 'its end')

    expect('error' in page.ask('keep_tables', wrong=None, setup='part.nct') and 'error' in page.ask('keep_tables', setup='../out.json'), 'no set-up file')
    expect('error' not in page.ask('keep_tables', setup='part.json'), 'kept as a set-up file')
    expect(json.loads((folder / 'part.json').read_text()) == {'work_offsets': {'G54': {'X': 100}}, 'variables': {'#500': 3}}, 'what stands in it')
    expect('error' in page.ask('keep_tables', setup='part.json'), 'not over one that is there already')
    page.ask('press', key='off')

    page.ask('machine', file='part.nct', setup='part.json', **WITH)
    page.ask('edit', tables={'work_offsets': {'G54': {'Z': -3}}})
    tables = page.ask('tables')
    expect(tables['file']['work_offsets'] == {'G54': {'X': 100}} and tables['edited'] == {'work_offsets': {'G54': {'Z': -3}}} and tables['setup'] == 'part.json', f'beside the file: {tables["file"]}')
    expect('error' not in page.ask('keep_tables', setup='part.json'), 'kept in the file of the machine')
    expect(json.loads((folder / 'part.json').read_text())['work_offsets'] == {'G54': {'X': 100, 'Z': -3}}, 'both together')
    other = looker(server, token=False)
    other.ask('machine', file='part.nct')
    expect('error' not in other.ask('tables') and 'error' in other.ask('edit', tables={}) and 'error' in other.ask('keep_tables', setup='x.json'), 'without the token it looks')
    page.ask('enter', line='G1 X300 F500')
    expect('error' in page.ask('edit', tables={'offsets': {'1': {'radius': 1}}}), 'not while it runs')
    page.ask('press', key='emergency')
    page.ask('press', key='off')


def by_hand(server, folder):
    """G10 entered by hand acts like an edit: kept, shown under Tables, in force after edits, resets, and switching on again."""
    page = looker(server)
    for control, lines in (('nct', ('G10 L2 P2 X4 Y0', 'G10 L12 P3 R2.5')), ('mach3', ('G10 L2 P2 X4', 'G10 L1 P3 R2.5')), ('linuxcnc', ('G10 L2 P2 X4', 'G10 L1 P3 R2.5'))):
        name, ending = f'hand-{control}', '.ngc' if control == 'linuxcnc' else '.nc'
        (folder / (name + ending)).write_text('G21 G90 G17 G55\nG0 X10\nM0\nG0 Y5\nM30\n')
        (folder / f'{name}.json').write_text('{"offsets": {"3": {"radius": 1, "length": 20}}, "work_offsets": {"G55": {"X": 1, "Y": 2}}}')
        page.ask('machine', file=name + ending, control=control, machine='fast.toml', setup=f'{name}.json')
        page.ask('press', key='run')
        until(page, lambda p: p['mode'] == 'standing' and p['why'] == 'M0')
        for count, line in enumerate(lines):
            expect('error' not in page.ask('enter', line=line), f'{control}: {line}')
            until(page, lambda p: p['mode'] == 'standing' and p['can_undo'] == count + 1)
        edited = page.ask('tables')['edited']
        expect(edited['work_offsets']['G55']['X'] == 4 and edited.get('offsets') == {'3': {'radius': 2.5}}, f'{control}: what was entered stands among the edits: {edited}')
        expect('error' not in page.ask('edit', tables={'offsets': {'4': {'radius': 7}}}), f'{control}: another edit')
        until(page, lambda p: p['mode'] == 'standing' and not p['takes_tables'] and p['zero'].get('X') == 4)
        page.ask('press', key='reset')
        reset = until(page, lambda p: p['mode'] == 'standing' and p['line'] == 1)
        expect(page.ask('tables')['edited']['work_offsets']['G55']['X'] == 4, f'{control}: after a reset')
        page.ask('press', key='run')
        until(page, lambda p: p['mode'] == 'standing' and p['why'] == 'M0')
        expect(page.ask('panel')['machine']['X'] == 14, f'{control}: it runs by it: {page.ask("panel")["machine"]} {reset["zero"]}')
        expect(any(e['kind'] == 'edit' for e in page.ask('shift')['log']), f'{control}: it stands in the log')
        page.ask('press', key='off')


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    kadr = options.parse_args().kadr
    with tempfile.TemporaryDirectory() as above:
        folder = Path(above) / 'programs'
        folder.mkdir()
        (folder / 'part.nct').write_text(PROGRAM)
        (folder / 'fast.toml').write_text(FAST)
        server = Server(kadr, folder, '--open')
        operator(server, folder)
        by_hand(server, folder)
        expect(server.process.poll() is None and server.end() == 130, 'the server still stands')
        expect(not (Path(above) / 'out.json').exists(), 'nothing is written outside')
    for name in ('tables', 'edit', 'keep_tables', 'shift', 'watch', 'answer'):
        expect(f'answer.{name}' in seen and f'question.{name}' in seen, f'{name} has been held against the schema')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
