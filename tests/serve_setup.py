#!/usr/bin/env python3
"""Tests kadr serve: the set-up form of a program, and set-up files that the page keeps (docs/panel-protocol.md, setup_form, keep_setup).

    tests/serve_setup.py --kadr build/release/kadr
"""
import argparse
import json
import subprocess
import tempfile
from pathlib import Path

from page_client.client import Page, Server, expect, result, seen

PROGRAM = ('%\nO0001 (PART)\n(T1 D8 R0.5 ENDMILL)\n(T2 SPOT DRILL)\nG21 G90 G54\nT1 M6\nG43 H1 Z50.\nS1000 M3\n/G0 X0 Y0\nG41 D1 G1 X10. Y10. F100.\n'
           'X20.\nG40 X30.\nG0 Z100.\nT2 M6\nG55\nG43 H2 Z50.\nG1 X#500 F100.\nM1\nM30\nG56\n%\n')


def looker(server, token=True):
    page = Page(server)
    page.ask('hello', lang='en', **({'token': server.token} if token else {}))
    return page


def row(form, table, name):
    return [r for r in form['rows'] if r['table'] == table and r['row'] == name]


def first_form(server, folder, kadr):
    page = looker(server)
    expect('error' in page.ask('setup_form') and 'error' in page.ask('keep_setup', file='part.json', digest=None, values={}), 'no program is open')
    page.open('sub/part.nc', control='fanuc')
    form = page.ask('setup_form')
    expect((form['file'], form['digest'], form['in_force'], form['stated']) == ('sub/part.json', None, False, {}), f'a new file beside the program: {form}')
    expect([r['row'] for r in form['rows'] if r['table'] == 'work_offsets'] == ['G54', 'G55'], 'its work zeros')
    radius = [c for r in row(form, 'offsets', '1') for c in r['cells'] if c['key'] == 'radius']
    expect(radius == [{'key': 'radius', 'proposed': 4}], f'the radius by the comment: {row(form, "offsets", "1")}')
    expect([r for r in row(form, 'offsets', '1') if 'by' in r][0]['by'] == {'line': 3, 'text': 'T1 D8 R0.5 ENDMILL'}, 'with its line')
    expect(row(form, 'tool', '2')[0]['unsure']['line'] == 4, 'a comment without a certain size')
    expect(row(form, 'skip', '1')[0]['line'] == 9 and row(form, 'optional_stop', '1')[0]['line'] == 18, 'switches')
    expect(row(form, 'variables', '#500')[0]['line'] == 17, 'a variable that nothing has set')
    expect(form['not_executed'] == [[20, 20]], f'the line after the end: {form["not_executed"]}')
    expect({'key': 'length', 'about': 'length', 'unit': 'mm'} in form['columns'], f'columns in words: {form["columns"][:3]}')
    template = subprocess.run([kadr, 'setup', folder / 'sub/part.nc', '--control', 'fanuc'], capture_output=True, text=True)
    tables = json.loads(template.stdout)
    for table in ('offsets', 'work_offsets'):
        for name, cells in tables[table].items():
            found = {c['key']: c.get('proposed') for r in row(form, table, name) for c in r['cells']}
            expect(found == cells, f'the same as kadr setup writes: {table} {name} {found} {cells}')
    return page, form


def keeping(server, folder):
    page = looker(server)
    page.open('sub/part.nc', control='fanuc')
    for values in ({'offsets': {'1': {'colour': 1}}}, {'work_offsets': {'G54': {'Q': 1}}}, {'nothing': 1}, {'offsets': {'1': {'radius': 'wide'}}}):
        refused = page.ask('keep_setup', file='sub/part.json', digest=None, values=values)
        expect(refused.get('error', {}).get('text'), f'no set-up of this control: {values} {refused}')
    expect('error' in page.ask('keep_setup', file='sub/part.nc', digest=None, values={}) and 'error' in page.ask('keep_setup', file='../part.json', digest=None, values={}), 'only a set-up beneath the folder')
    expect('error' in page.ask('keep_setup', wrong=None, file='sub/part.json', digest=None, values=3), 'values that are none')
    expect(not (folder / 'sub/part.json').exists(), 'nothing has been written')
    kept = page.ask('keep_setup', file='sub/part.json', digest=None, values={'work_offsets': {'G54': {'X': -100, 'Z': -300.5}}, 'offsets': {'1': {'radius': 4}}})
    expect('digest' in kept, f'kept: {kept}')
    expect((folder / 'sub/part.json').read_text() == '{\n  "work_offsets": {\n    "G54": {"X": -100, "Z": -300.5}\n  },\n  "offsets": {\n    "1": {"radius": 4}\n  }\n}\n', 'a line for each row')
    _, ended = page.open('sub/part.nc', control='fanuc', setup='sub/part.json')
    expect(ended['zero'][0] == -100, f'the path follows: {ended["zero"]}')
    form = page.ask('setup_form')
    expect(form['in_force'] and form['digest'] == kept['digest'] and form['stated']['offsets'] == {'1': {'radius': 4}} and form['setups'] == ['sub/part.json'], f'the form shows the file: {form["stated"]}')

    other = looker(server)
    other.open('sub/part.nc', control='fanuc')
    theirs = other.ask('setup_form')
    expect(not theirs['in_force'] and theirs['file'] == 'sub/part.json' and theirs['stated'] == form['stated'], 'the file of the same name is shown, not yet in force')
    expect('digest' in other.ask('keep_setup', file='sub/part.json', digest=theirs['digest'], values={'work_offsets': {'G54': {'Y': 7}}}), 'somebody else keeps it')
    refused = page.ask('keep_setup', file='sub/part.json', digest=form['digest'], values={'work_offsets': {'G54': {'X': 5}}})
    expect(refused.get('error', {}).get('changed') is True, f'a change of somebody else is not overwritten: {refused}')
    expect(page.ask('keep_setup', file='sub/part.json', digest=None, values={'offsets': {'1': {'radius': 9}}}).get('error', {}).get('changed') is True, 'nor as if it were new')
    again = page.ask('setup_form')
    expect('digest' in page.ask('keep_setup', file='sub/part.json', digest=again['digest'], values={'work_offsets': {'G54': {'X': 5, 'Z': None}}, 'skip': [1], 'optional_stop': True}), 'with the state that was seen it is')
    expect(json.loads((folder / 'sub/part.json').read_text()) == {'work_offsets': {'G54': {'X': 5, 'Y': 7}}, 'offsets': {'1': {'radius': 4}}, 'skip': [1], 'optional_stop': True}, 'both changes')

    (folder / 'sub/tools.json').write_text('{"kind": "library"}')
    page.open('sub/tools.nc', control='fanuc')
    expect(page.ask('setup_form')['file'] == 'sub/tools_2.json', 'a file of another kind is left alone')
    watching = looker(server, token=False)
    watching.open('sub/part.nc', control='fanuc')
    expect('error' not in watching.ask('setup_form') and 'error' in watching.ask('keep_setup', file='x.json', digest=None, values={}), 'without the token it looks')


def blank_and_tools(server, folder):
    """The blank by a comment or by the set-up, tools with what is assumed of them; both are kept in files that the next proposals use."""
    page = looker(server)
    page.open('sub/plate.nc', control='fanuc')
    proposals = page.ask('proposals')
    expect(proposals['stock'] == 'box:-40,-30,-20,40,30,0' and proposals['stock_by'] == {'line': 1, 'text': 'PLATE 80X60X20'}, f'by the comment: {proposals["stock"]} {proposals.get("stock_by")}')
    tool = proposals['tools'][0]
    expect(tool['known'] and tool['diameter'] == 10 and tool['holder'] and 'assumed' in tool['from'] and 'line 2' in tool['from'], f'what is assumed: {tool}')
    expect(proposals['keep'] == {'file': 'sub/plate.toml', 'digest': None}, f'its tools file: {proposals["keep"]}')
    for wrong in ({'file': 'sub/plate.json', 'tools': [tool]}, {'file': '../plate.toml', 'tools': [tool]}, {'file': 'sub/plate.toml', 'tools': []}, {'file': 'sub/plate.toml', 'tools': [{'number': 1, 'kind': 'flat'}]}):
        expect('error' in page.ask('keep_tools', digest=None, **wrong), f'not kept: {wrong}')
    kept = page.ask('keep_tools', file='sub/plate.toml', digest=None, tools=[tool])
    expect('digest' in kept and 'diameter = 10\n' in (folder / 'sub/plate.toml').read_text() and 'assumed' not in (folder / 'sub/plate.toml').read_text(), f'kept: {kept}')
    expect('digest' in page.ask('keep_setup', file='sub/plate.json', digest=None, values={'stock': 'box:-50,-50,-30,50,50,0', 'fixtures': ['box:60,0,0,70,10,10']}), 'the blank is kept in the set-up')
    expect(page.ask('keep_tools', file='sub/plate.toml', digest=None, tools=[tool])['error'].get('changed'), 'not as if it were new')
    expect('digest' in page.ask('keep_tools', file='sub/plate.toml', digest=kept['digest'], tools=[{**tool, 'diameter': 12}]), 'another version')
    page.open('sub/plate.nc', control='fanuc', setup='sub/plate.json')
    proposals = page.ask('proposals')
    expect(proposals['stock'] == 'box:-50,-50,-30,50,50,0' and proposals['stock_by'] == {'line': 0, 'text': 'sub/plate.json'} and proposals['fixtures'] == ['box:60,0,0,70,10,10'], f'by the set-up: {proposals["stock"]}')
    expect(proposals['tools'][0]['from'] == 'sub/plate.toml' and proposals['tools'][0]['diameter'] == 12 and proposals['keep']['digest'], f'by the file: {proposals["tools"]}')


def faults(server):
    page = looker(server)
    page.open('faulty.nc', control='fanuc')
    form = page.ask('setup_form')
    expect(form['faults'] == 1 and [r['row'] for r in form['rows']] == ['G54', 'G55'], f'what follows a fault is found too: {form["rows"]}')
    page.open('lathe.nc', control='fanuc-t')
    form = page.ask('setup_form')
    keys = [c['key'] for r in row(form, 'offsets', '1') for c in r['cells']]
    expect(keys[:4] == ['X', 'X_wear', 'Z', 'Z_wear'] and 'tip' in keys, f'geometry and wear of a turning tool: {keys}')


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    kadr = options.parse_args().kadr
    with tempfile.TemporaryDirectory() as above:
        folder = Path(above) / 'programs'
        (folder / 'sub').mkdir(parents=True)
        (folder / 'sub/part.nc').write_text(PROGRAM)
        (folder / 'sub/plate.nc').write_text('(PLATE 80X60X20)\n(T1 10 MM ENDMILL)\nG21 G90 G54\nT1 M6\nS1000 M3\nG0 X-20. Y0 Z5.\nG1 Z-5. F200.\nX20.\nG0 Z5.\nM30\n')
        (folder / 'sub/tools.nc').write_text('G21 G90 G54\nG0 X1.\nM30\n')
        (folder / 'faulty.nc').write_text('G54\nG999\nG55\nM30\n')
        (folder / 'lathe.nc').write_text('G21\nT0101\nG97 S500 M3\nG0 X60. Z2.\nG42 G1 X50. Z0 F0.2\nX40.\nG40 X60.\nM30\n')
        server = Server(kadr, folder, '--open')
        first_form(server, folder, kadr)
        keeping(server, folder)
        blank_and_tools(server, folder)
        faults(server)
        expect(server.process.poll() is None and server.end() == 130, 'the server still stands')
    for name in ('setup_form', 'keep_setup', 'keep_tools'):
        expect(f'answer.{name}' in seen and f'question.{name}' in seen, f'{name} has been held against the schema')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
