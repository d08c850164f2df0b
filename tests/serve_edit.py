#!/usr/bin/env python3
"""Tests kadr serve: editing a program by the protocol (edit_program). The page gets the text that kadr edit writes and the sentence that it
prints, or the reasons of a refusal with their lines; nothing is written to the disk.

    serve_edit.py --kadr PROGRAM
"""
import argparse
import subprocess
import tempfile
from pathlib import Path

import harness
from page_client.client import Page, Server, expect, result

PART = ('G21 G90 G54 G17\nT1 M6\nS1000 M3\nG0 X0 Y0\nG43 H1 Z5\nG1 Z-1 F100\nX20 F200\nG2 X30 Y10 I10 J0\nG1 X0 Y0\nG0 Z50\n'
        'T3 M6\nG0 X5 Y5\nG43 H3 Z5\nG1 Z-2 F80\nX10 F160\nG0 Z50\nM2\n')
EDITS = [{'feed': ['T3=80%']}, {'speed': '90%'}, {'mirror': 'X=5'}, {'rotate': '90@1,2'}, {'rotate': '30'}, {'shift': ['X1', 'Z-0.5']}, {'renumber': '10'},
         {'strip': ['spaces'], 'feed': '50%'}, {'replace-tool': ['3=4']}, {'replace-zero': ['G54=G55']}, {'copy': '2x1:50,0'}, {'reverse': '7-9'}]
# edits, a part of the reason, its line
REFUSED = [({'replace-tool': ['7=8']}, 'does not use tool 7', 0), ({'copy': '2x1:50,0', 'lines': '4-11'}, 'cannot be repeated', 11), ({'reverse': '6-8'}, 'Z-1', 6)]
# edits that are no edits, a part of the answer
WRONG = [({}, 'nothing to change'), ({'feed': '80'}, 'want a percentage'), ({'turn': '90'}, 'no such edit'), 
         ({'mirror': 'X', 'rotate': '90'}, 'one at a time')]


def by_command(kadr, folder, edits):
    words = [kadr, 'edit', 'part.ngc', '--control', 'linuxcnc', '--lang', 'en']
    for name, value in edits.items():
        for word in value if isinstance(value, list) else [value]:
            words += [f'--{name}', word]
    return subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=harness.TIME_LIMIT_S, check=False)


def check(kadr, page, folder):
    for edits in EDITS:
        wanted = by_command(kadr, folder, edits)
        answer = page.ask('edit_program', file='part.ngc', control='linuxcnc', edits=edits)
        what = f'{edits}: {str(answer)[:300]} {wanted.stderr[:300]}'
        expect(wanted.returncode == 0 and answer.get('text') == wanted.stdout and answer['refused'] == [], f'the text of kadr edit: {what}')
        expect(answer.get('told', '-') in wanted.stderr and answer.get('lines', -1) > 0, f'its sentence: {what}')
    for edits, why, line in REFUSED:
        answer = page.ask('edit_program', file='part.ngc', control='linuxcnc', edits=edits)
        expect(answer.get('text') == '' and answer['refused'][0]['line'] == line and why in answer['refused'][0]['text'], f'{edits}: {str(answer)[:300]}')
    for edits, why in WRONG:
        answer = page.ask('edit_program', file='part.ngc', control='linuxcnc', edits=edits)
        expect(why in answer.get('error', {}).get('text', ''), f'{edits}: {str(answer)[:300]}')
    answer = page.ask('edit_program', file='part.ngc', control='linuxcnc', edits={'mirror': 'X'}, text='G21 G90\nG0 X1 Y2\nM2\n')
    expect(answer.get('text') == 'G21 G90\nG0 X-1 Y2\nM2\n', f'the text of the editor instead of the file: {str(answer)[:300]}')
    answer = page.ask('edit_program', file='part.ngc', control='linuxcnc', edits={'mirror': 'X'}, text='G21 G90\nG999\nM2\n')
    expect(answer.get('text') == '' and any(one['line'] == 2 for one in answer['refused']), f'a program that stops: {str(answer)[:300]}')
    page.ask('language', lang='ru')
    answer = page.ask('edit_program', file='part.ngc', control='linuxcnc', edits={'feed': ['T3=80%']})
    expect('больше ничего не изменилось' in answer.get('told', ''), f'in Russian: {str(answer)[:300]}')


def blocks(page):
    """The blocks of a control from figures: the control runs them, and its course is that of the figures."""
    page.open('part.ngc', control='linuxcnc')
    table = page.ask('write_blocks', what='cycles')
    codes = {one['code']: {w['letter']: w['needed'] for w in one['words']} for one in table.get('cycles', [])}
    expect({'G81', 'G83', 'G84'} <= set(codes) and 'Q' in codes.get('G83', {}) and 'Q' not in codes.get('G81', {}) and codes['G81']['Z'] is True, f'the cycles of the control: {str(codes)[:300]}')
    expect([one['code'] for one in table.get('retract', [])] == ['G98', 'G99'], f'its levels: {table.get("retract")}')
    drilled = page.ask('write_blocks', what='cycle', code='G83', retract='G98', values={'Z': -12, 'R': 2, 'Q': 3, 'F': 80}, holes=[[10, 20], [30, 20]], unit='mm')
    expect([words_in(line) for line in drilled['lines']] == [{'G': [90, 98, 83], 'X': [10], 'Y': [20], 'Z': [-12], 'R': [2], 'Q': [3], 'F': [80]}, {'X': [30], 'Y': [20]}, {'G': [80]}],
           f'a cycle: {drilled}')
    arc = page.ask('write_blocks', what='arc', **{'from': [0, 0], 'through': [10, 10], 'to': [20, 0]}, unit='mm')
    expect([words_in(line) for line in arc['lines']] == [{'G': [90, 2], 'X': [20], 'Y': [0], 'I': [10], 'J': [0]}], f'an arc over the top is clockwise: {arc}')
    left = page.ask('write_blocks', what='arc', **{'from': [0, 0], 'through': [10, -10], 'to': [20, 0]}, unit='mm')
    expect(words_in(left['lines'][0])['G'] == [90, 3], f'an arc below is counter-clockwise: {left}')
    for kind, wanted in (('chamfer', [{'G': [90, 1], 'X': [0], 'Y': [15]}, {'X': [5], 'Y': [20]}, {'X': [30], 'Y': [20]}]),
                         ('rounding', [{'G': [90, 1], 'X': [0], 'Y': [15]}, {'G': [2], 'X': [5], 'Y': [20], 'I': [5], 'J': [0]}, {'G': [1], 'X': [30], 'Y': [20]}])):
        made = page.ask('write_blocks', what='corner', kind=kind, size=5, **{'from': [0, 0], 'corner': [0, 20], 'to': [30, 20]}, unit='mm')
        expect([words_in(line) for line in made['lines']] == wanted, f'a {kind}: {made}')
    corner = {'what': 'corner', 'kind': 'chamfer', 'size': 5, 'from': [0, 0], 'corner': [0, 20], 'to': [30, 20], 'unit': 'mm'}
    ended = page.ask('write_blocks', **corner, motion='G0', after=2)
    expect(ended['lines'][-1] == 'G0' and not any(line.startswith('N') for line in ended['lines']), f'the motion code is in force again: {ended}')
    expect('motion' in page.ask('write_blocks', **corner, motion='M30').get('error', {}).get('text', ''), 'another code than that of a motion')
    page.open('old.nc', control='s2c42')
    old = page.ask('write_blocks', **corner, motion='G01', after=3)['lines']
    expect([line.split()[0] for line in old] == ['N003', 'N004', 'N011', 'N012'][:len(old)] and all(line.endswith(' ПС') for line in old), f'numbers and marks as the program has them: {old}')
    page.open('part.ngc', control='linuxcnc')
    for question, why in (({'what': 'arc', 'from': [0, 0], 'through': [5, 0], 'to': [9, 0]}, 'on one line'), ({'what': 'cycle', 'code': 'G99', 'holes': [[0, 0]], 'values': {}}, 'code'),
                          ({'what': 'corner', 'kind': 'chamfer', 'size': 50, 'from': [0, 0], 'corner': [0, 20], 'to': [30, 20]}, 'does not fit')):
        answer = page.ask('write_blocks', **question)
        expect(why in answer.get('error', {}).get('text', ''), f'{question}: {answer}')


def words_in(line):
    words = {}
    for word in line.split():
        words.setdefault(word[0], []).append(float(word[1:]))
    return words


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    kadr = str(Path(options.parse_args().kadr).resolve())
    with tempfile.TemporaryDirectory() as above:
        folder = Path(above)
        (folder / 'part.ngc').write_text(PART)
        (folder / 'old.nc').write_text('%\nN001 G90 ПС\nN002 G00 X+10000 ПС\nN005 M00 ПС\nN010 M02 ПС\n')
        server = Server(kadr, folder, '--open')
        page = Page(server)
        page.ask('hello', token=server.token, lang='en')
        check(kadr, page, folder)
        page.ask('language', lang='en')
        blocks(page)
        expect((folder / 'part.ngc').read_text() == PART and sorted(p.name for p in folder.iterdir()) == ['old.nc', 'part.ngc'], 'nothing is written')
        onlooker = Page(server)
        onlooker.ask('hello', lang='en')
        expect(onlooker.ask('edit_program', file='part.ngc', control='linuxcnc', edits={'feed': '80%'}).get('lines', 0) > 0, 'who may not change may look')
        expect(server.end() == 130, 'the server stands to the end')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
