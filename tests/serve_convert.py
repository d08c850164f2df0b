#!/usr/bin/env python3
"""Tests kadr serve: a program for another control (convert), and saving it. The page gets what kadr convert writes and reports, byte
for byte; a conversion is stopped when no page needs it any more, and blocks no page.

    serve_convert.py --kadr PROGRAM
"""
import argparse
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

import harness
from page_client.client import Page, Server, expect, result

EXAMPLES = Path(__file__).resolve().parent.parent / 'examples'
FLANGE = {'file': 'flange.nc', 'control': 's2c42', 'setup': 'flange.json', 'to': 'mach3'}
CIRCLE = {'file': 'bolt_circle.tap', 'control': 'mach3', 'setup': 'bolt_circle.json', 'to': 'correctors'}
LOCAL = {'file': 'local_subprogram.nc', 'control': 'haas', 'setup': 'local_subprogram.json', 'to': 'nct'}
TAPS = {'file': 'flange_taps.nc', 'control': 'fanuc', 'setup': 'flange_taps.json', 'to': 'haas'}
PROBE = {'file': 'probe_hole.tap', 'control': 'mach3', 'setup': 'probe_hole.json', 'to': 's2c42'}
MARK = {'en': '(NOT PROVEN EQUAL: SEE kadr convert)\n', 'ru': '(НЕ ДОКАЗАНО: СМ. kadr convert)\n'}


def by_command(kadr, folder, question, lang='en'):
    """Returns the result of kadr convert for the same question: its status, program, set-up, messages."""
    out, setup = folder / 'by_command.out', folder / 'by_command.json'
    words = [kadr, 'convert', question['file'], '--from', question['control'], '--to', question['to'], '--out', out.name, '--setup-out', setup.name, '--lang', lang]
    words += ['--setup', question['setup']] if question.get('setup') else []
    words += ['--explain'] + [f'--{key}' for key in ('flat', 'force') if question.get(key)]
    run = subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=harness.TIME_LIMIT_S, check=False)
    made = run.returncode, *(p.read_text() if p.exists() else None for p in (out, setup)), run.stderr
    for p in (out, setup):
        p.unlink(missing_ok=True)
    return made


def place(one, file):
    """Returns the location as the command writes it before the reason."""
    if not one['line']:
        return '' if not one['written_line'] else one['written_line']
    return f'{file}:{one["line"]}' + (f' | {one["written_line"]}' if one['written_line'] else '')


def same_as_the_command(kadr, page, folder):
    proven = refused = 0
    for lang in ('en', 'ru'):
        page.ask('language', lang=lang)
        for name, question in {'flange': FLANGE, 'flat': {**FLANGE, 'flat': True}, 'circle': CIRCLE, 'forced': {**CIRCLE, 'force': True}, 'local': LOCAL, 'written out': {**LOCAL, 'flat': True},
                               'taps': TAPS, 'probe': PROBE, 'nothing to be forced': {**PROBE, 'force': True}, 'to itself': {**FLANGE, 'to': 's2c42'}, 'force is not needed': {**FLANGE, 'force': True}}.items():
            status, program, setup, told = by_command(kadr, folder, question, lang)
            answer = page.ask('convert', **question)
            what = f'{lang}, {name}: {str(answer)[:300]} {told[:300]}'
            if 'error' in answer:
                expect(False, what)
                continue
            written = answer['written']
            lines = told.splitlines()
            if status == 0:
                proven += 1
                expect(written['proven'] and written['program'] == program and written['setup'] == setup, what)
                expect(lines[0] == answer['text'] and lines[1].endswith(f': {written["way"]}'), what)
                expect(not written['note'] or f'  {written["note"]}' in lines, what)
                for out in written['written_out']:
                    expect(any(f':{out["from"]}{"-" + str(out["to"]) if out["to"] > out["from"] else ""}: ' in line and line.endswith(f': {out["text"]}') for line in lines[2:]), f'{what}\n{out}')
            else:
                refused += 1
                expect(status == 1 and lines[0] == f'kadr: {answer["text"]}', what)
            for one in answer['tries']:
                expect(any((f' {one["way"]}: ' in line or f' {one["way"]}, ' in line) and str(place(one, question['file'])) in line and line.endswith(f': {one["text"]}') for line in lines[1:]), f'{what}\n{one}')
            if status == 0:
                continue
            if program is None:
                expect(written is None, what)
            else:
                expect(question.get('force') and not written['proven'] and written['program'] == program and written['setup'] == setup and program.startswith(MARK[lang]), what)
    page.ask('language', lang='en')
    expect(proven >= 10 and refused >= 4, f'{proven} proven, {refused} refused')


def places(page, folder):
    """For each method that failed: the line of the program as it is there."""
    lines = (folder / CIRCLE['file']).read_text().splitlines()
    answer = page.ask('convert', **CIRCLE)
    expect([one['as'] for one in answer['tries']][0] == 'as_it_stands' and len(answer['tries']) >= 4 and answer['written'] is None and 'not converted' in answer['text'], f'all ways: {answer}')
    for one in answer['tries']:
        expect(one['line'] > 0 and one['file'] == 0 and one['line_text'] == lines[one['line'] - 1], f'its line: {one}')
    expect(any('no code for G4 (dwell' in one['text'] for one in answer['tries']), 'the dwell')
    page.ask('language', lang='ru')
    told = page.ask('convert', **CIRCLE)
    expect(not any(re.search('[a-z]{4,}', one['way']) for one in told['tries']) and any('G4 (выдержка' in one['text'] for one in told['tries']), f'in Russian: {told}')
    page.ask('language', lang='en')
    taken = page.ask('convert', **FLANGE)
    expect(taken['written']['proven'] and taken['tries'] and taken['tries'][0]['as'] == 'as_it_stands' and taken['tries'][0]['line'] > 0, 'why it is not as it stands')
    expect(0 < taken['tolerance'] < 0.01 and re.match(r'equal: \d+ motions', taken['text']), 'how equal it is')
    (folder / 'O1000.nc').write_text('O1000\nG1 X5 F100\nG4 P100\nM99\n')
    (folder / 'calls.nc').write_text('%\nO0001\nG21 G90 G0 X0 Y0 Z5\nM98 P1000\nM30\n%\n')
    called = page.ask('convert', file='calls.nc', control='fanuc', to='correctors')
    expect(any(one['file'] > 0 and one['line'] == 3 and one['line_text'] == '' for one in called['tries']), f'a place in a called file: {called}')
    alarm = page.ask('convert', file='calls.nc', control='fanuc', to='haas', text='G21 G90 G0 X0. Y0.\nG1 X5. F100.\nG1 X[1/0]\nM30\n')
    expect(alarm['written'] is None and any('own control' in one['text'] and one['line'] == 3 and one['line_text'] == 'G1 X[1/0]' for one in alarm['tries']), f'an alarm of its own: {alarm}')
    forced = page.ask('convert', file='calls.nc', control='fanuc', to='haas', text='M30 (' + 'я' * 200 + ')\nG1 X1\n' * 2)
    expect('tries' in forced, 'long lines')


def wishes(page, folder):
    """Text of the editor, tables of the machine, a guessed control, a control of the folder."""
    text = (folder / FLANGE['file']).read_bytes().decode('utf-8')
    changed = text.replace('X0', 'X1', 1)
    expect(page.ask('convert', **FLANGE, text=changed)['written']['program'] != page.ask('convert', **FLANGE)['written']['program'], 'the text as it stands in the editor')
    tables = page.ask('convert', **FLANGE, tables={'offsets': {'77': {'length': 7.5}}})
    expect('77' in tables['written']['setup'], 'the tables of the machine')
    guessed = {key: value for key, value in FLANGE.items() if key != 'control'}
    expect(page.ask('convert', **guessed)['written']['proven'], 'a control that is guessed')
    own = page.ask('convert', **{**FLANGE, 'to': 'own.toml'})
    expect(own['written']['proven'] and own['written']['name'] == 'flange-own.nc', f'a control of the folder: {str(own)[:300]}')
    bare = page.ask('convert', file='calls.nc', control='fanuc', to='haas')
    expect(bare['written']['setup'] == '{}\n', f'without a set-up it needs none: {bare}')


def refused(page, folder):
    for name, more in {'beyond the folder': {'file': '../outside.nc'}, 'an absolute one': {'file': '/etc/passwd'}, 'a link': {'file': 'link.nc'}, 'none': {'file': 'nothing.nc'}, 'no file': {'file': ''}, 'a folder': {'file': 'sub'}, 'no such control': {'to': 'okuma'},
                       'a control beyond the folder': {'to': '../own.toml'}, 'no control': {'to': ''}, 'a set-up beyond': {'setup': '../outside.json'}, 'an encoding': {'encoding': 'klingon'}, 'tables': {'tables': {'nothing': 1}}, 'a file that is no control': {'to': 'bad.toml'}}.items():
        answer = page.ask('convert', **{**FLANGE, **more})
        expect(answer.get('error', {}).get('text'), f'{name}: refused: {str(answer)[:200]}')
    for name, more in {'flat': {'flat': 'yes'}, 'force': {'force': 1}, 'to': {'to': 5}, 'to null': {'to': None}, 'a list': {'to': ['mach3']}, 'file': {'file': {}}, 'text': {'text': 7}, 'tables': {'tables': []}, 'control': {'control': 3}}.items():
        answer = page.ask('convert', wrong=True, **{**FLANGE, **more})
        expect('not understood' in answer.get('error', {}).get('text', ''), f'{name}: refused: {str(answer)[:200]}')
    expect('error' in page.ask('convert', wrong=True, file=FLANGE['file']), 'no target')
    expect('written' in page.ask('convert', **{**FLANGE, 'text': ''}), 'an empty text is a program too')
    garbage = page.ask('convert', **{**FLANGE, 'text': '\u0000\u0001\ufffd((((\nG1 X\n'})
    expect('error' in garbage or garbage['written'] is None, f'garbage: {str(garbage)[:200]}')
    (folder / 'channels.json').write_text('{"channels": {"1": {"axes": ["X", "Y", "Z"]}, "2": {"axes": ["X", "Y", "Z"], "program": "calls.nc"}}}')
    channels = page.ask('convert', file='calls.nc', control='nct', setup='channels.json', to='haas')
    expect('error' in channels, f'channels: {str(channels)[:300]}')


def long_program(lines):
    return '%\nO0001\nG21 G90 G54\n' + ''.join(f'G1 X{i % 997 / 10:.1f} Y{i % 613 / 10:.1f} Z{-(i % 7) / 10:.1f} F{100 + i % 50}.\n' for i in range(lines)) + 'M30\n%\n'


def stopped(server, page, folder):
    """Other pages work during a long conversion; it is stopped by the question and by closing the page."""
    (folder / 'long.nc').write_text('%\nO0001\nG21 G90 G0 X0. Y0.\n#1=0\nWHILE[#1 LT 1000000]DO1\nG1 X#1 F100.\nX2.\n#1=#1+0.001\nEND1\nM30\n%\n')
    question = {'file': 'long.nc', 'control': 'fanuc', 'to': 'haas'}
    beside = Page(server)
    beside.ask('hello', lang='en')
    number = page.begin('convert', **question)
    expect(server.works(), 'the conversion is at work')
    for _ in range(20):
        expect('entries' in beside.ask('files', folder=''), 'another page is answered')
    before = server.spent()
    page.begin('stop')
    answer = page.answer(number)
    took = server.spent() - before
    expect(answer.get('error', {}).get('text') == 'interrupted', f'it is stopped, so the others were answered meanwhile: {str(answer)[:300]}')
    expect(took < 5, f'soon: {took:.1f} s of work later')
    expect(page.ask('convert', **FLANGE)['written']['proven'], 'the next one is not')
    leaves = Page(server)
    leaves.ask('hello', lang='en')
    leaves.begin('convert', **question)
    server.works()
    leaves.socket.close()
    expect(harness.stands(server.process), 'a page that has gone leaves no work')
    big = long_program(400_000)
    (folder / 'huge.nc').write_text(big)
    before = server.spent()
    answer = page.ask('convert', **{**question, 'file': 'huge.nc'})
    took = server.spent() - before
    expect(len(big) > 8 << 20 and 'too long' in answer['error']['text'] and took < 5, f'{len(big)} bytes are refused at once: {str(answer)[:200]}')


def saved(page, folder):
    made = page.ask('convert', **FLANGE)['written']
    expect(made['name'] == 'flange-mach3.nc', 'the name that is proposed')
    expect('digest' in page.ask('save', file=made['name'], text=made['program'], digest=None), 'the program is saved')
    expect('digest' in page.ask('save', file='flange-mach3.json', text=made['setup'], digest=None), 'its set-up is saved')
    expect((folder / made['name']).read_text() == made['program'] and (folder / 'flange-mach3.json').read_text() == made['setup'], 'as they were made')
    expect(page.ask('convert', **FLANGE)['written']['name'] == 'flange-mach3_2.nc', 'the next name is of no file that is there')
    opened, done = page.open(made['name'], control='mach3', setup='flange-mach3.json')
    expect(opened['control']['id'] == 'mach3' and done['state'] == 'ended', 'it opens and runs with it')

def onlookers(server):
    page = Page(server)
    page.ask('hello', lang='en')
    expect(page.ask('convert', **FLANGE)['written']['proven'], 'who may not change may look')
    expect('error' in page.ask('save', file='theirs.nc', text='x', digest=None), 'and saves nothing')


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    kadr = str(Path(options.parse_args().kadr).resolve())
    with tempfile.TemporaryDirectory() as above:
        folder = Path(above) / 'programs'
        (folder / 'sub').mkdir(parents=True)
        (Path(above) / 'outside.nc').write_text('G1 X1\nM30\n')
        (Path(above) / 'outside.json').write_text('{}')
        for where in (Path(above), folder):
            (where / 'own.toml').write_text('id = "own"\nextends = "mach3"\nname = {en = "O", ru = "О"}\n')
        (folder / 'bad.toml').write_text('id = 5\n')
        (folder / 'link.nc').symlink_to('../outside.nc')
        for question in (FLANGE, CIRCLE, LOCAL, TAPS, PROBE):
            for name in (question['file'], question['setup']):
                shutil.copy(EXAMPLES / question['control'] / name, folder / name)
        server = Server(kadr, folder, '--open')
        page = Page(server)
        page.ask('hello', token=server.token, lang='en')
        before = sorted(p.name for p in folder.iterdir())
        same_as_the_command(kadr, page, folder)
        expect(sorted(p.name for p in folder.iterdir()) == before, 'nothing is written that nobody asked for')
        places(page, folder)
        wishes(page, folder)
        refused(page, folder)
        stopped(server, page, folder)
        saved(page, folder)
        onlookers(server)
        expect(server.end() == 130, 'the server stands to the end')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
