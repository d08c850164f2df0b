#!/usr/bin/env python3
"""Tests kadr serve: programs from drawings (mill), reading and writing punched tape (tape), and saving them. The page gets what the
commands kadr mill and kadr tape write, byte for byte.

    serve_making.py --kadr PROGRAM
"""
import argparse
import base64
import subprocess
import tempfile
from pathlib import Path

import harness
from page_client.client import PROGRAM, Page, Server, expect, result

EXAMPLES = Path(__file__).resolve().parent.parent / 'examples' / 'mill'
COVER = {'drawing': 'cover.txt', 'control': 's2c42', 'task': 'pocket', 'tool_diameter': 12, 'depth': 8}
ZONE = 'from 0 0\nline 60 0\nline 60 40\nline 0 40\nclose\n'


def command(kadr, folder, *words, **more):
    return subprocess.run([kadr, *map(str, words)], cwd=folder, capture_output=True, timeout=harness.TIME_LIMIT_S, **more)


def by_command(kadr, folder, question, lang='en'):
    """Returns the result of kadr mill for the same question: program, picture, lines of its summary."""
    words = ['mill', question['task'], question['drawing'], '--control', question['control'], '--output', 'by_command.out', '--plot', 'by_command.svg', '--lang', lang]
    for key, value in question.items():
        if key in ('task', 'drawing', 'control'):
            continue
        words += ['--' + key.replace('_', '-')] + ([] if value is True else list(value) if isinstance(value, list) else [value])
    run = command(kadr, folder, *words)
    program, picture = folder / 'by_command.out', folder / 'by_command.svg'
    made = run.returncode, *(p.read_text() if p.exists() else None for p in (program, picture)), run.stdout.decode()
    for p in (program, picture):
        p.unlink(missing_ok=True)
    return made


def same_as_the_command(kadr, page, folder):
    for name, more in {
        'a pocket': {'pass': 4}, 'rows': {'scheme': '1zigzag', 'angle': 30, 'stepover': '40%', 'feed': 900, 'plunge_feed': 77}, 'by its printed name': {'scheme': 'АСПИР ЧС'},
        'a face': {'task': 'face', 'control': 'mach3', 'top': 1.5, 'overrun': 3}, 'a hole': {'plunge': 'hole', 'control': 'nct', 'hole': [60, 30]},
        'technology': {'control': 'linuxcnc', 'speed': 3000, 'tool': 7, 'coolant': True, 'allowance': 0.25}, 'a mark': {'mark': 'ПС', 'plunge': 'tangential', 'clearance': 9},
        'a slot': {'drawing': 'groove.txt', 'task': 'slot', 'tool_diameter': 6, 'width': 9, 'depth': -3, 'control': 'gost'}, 'DXF': {'drawing': 'lever.dxf', 'tool_diameter': 6, 'ramp_angle': 5, 'control': 'haas'},
    }.items():
        question = {**COVER, **more}
        status, program, picture, told = by_command(kadr, folder, question)
        answer = page.ask('mill', **question)
        if status != 0:
            expect(answer.get('problem'), f'{name}: the command makes none either')
            continue
        expect(answer.get('text') == program, f'{name}: the program of the command')
        expect(answer.get('picture') == picture, f'{name}: its picture')
        expect(''.join(f'{line["name"]:<17}{line["value"]}\n' for line in answer.get('summary', [])) == told, f'{name}: its summary')
    page.ask('language', lang='ru')
    _, _, _, told = by_command(kadr, folder, COVER, 'ru')
    answer = page.ask('mill', **COVER)
    expect(''.join(f'{line["name"]:<17}{line["value"]}\n' for line in answer['summary']) == told, 'the summary in Russian')
    page.ask('language', lang='en')


def refused(page):
    for name, more in {
        'beyond the folder': {'drawing': '../outside.txt'}, 'an absolute one': {'drawing': '/etc/passwd'}, 'a link': {'drawing': 'link.txt'}, 'hidden': {'drawing': '.hidden.txt'}, 'none': {'drawing': 'nothing.txt'}, 'a folder': {'drawing': 'sub'},
        'no such control': {'control': 'okuma'}, 'a control beyond the folder': {'control': '../own.toml'}, 'no control': {'control': ''},
    }.items():
        expect(page.ask('mill', **{**COVER, **more}).get('error'), f'{name}: refused')
    for name, more in {'a text for a number': {'depth': '8'}, 'null': {'feed': None}, 'a misspelt word': {'plunge-feed': 5}, 'a task': {'task': 'drill'}, 'a half tool': {'tool': 1.5}, 'a tool below zero': {'tool': -1}, 'a tool too great': {'tool': 2**32},
                       'half a hole': {'hole': [1]}, 'a hole of texts': {'hole': ['1', '2']}, 'coolant': {'coolant': 1}, 'a mark': {'mark': '\nM30'}, 'a list': {'scheme': ['zigzag']}}.items():
        answer = page.ask('mill', wrong=True, **{**COVER, **more})
        expect(answer.get('error') and 'mill' in answer['error']['text'], f'{name}: refused')
    for word, values in {'depth': (0, 1e300, -1e300), 'tool_diameter': (0, -1, 1e9, 1e-300), 'pass': (0, 1e-9, 0.001), 'allowance': (-1, 1e300), 'top': (1e300,), 'clearance': (0, -5), 'overrun': (-1,), 'angle': (1e300,), 'ramp_angle': (0, 90), 'width': (1,),
                         'feed': (0, -5, 1e300), 'plunge_feed': (0,), 'speed': (-1,), 'hole': ([1e300, 0],), 'scheme': ('round',), 'direction': ('left',), 'plunge': ('fall',), 'stepover': ('0', 'x', '-5%', '1e99')}.items():
        for value in values:
            answer = page.ask('mill', **{**COVER, word: value})
            expect('problem' in answer and answer['word'] == word and answer['problem']['text'], f'{word} {value}: {str(answer)[:120]}')
    number = page.number + 1  # not JSON
    page.number += 1
    page.send(f'{{"id":{number},"do":"mill","drawing":"cover.txt","control":"s2c42","task":"pocket","tool_diameter":NaN,"depth":8}}'.encode())
    message = page.take()
    expect(message['re'] is None and 'error' in message, 'NaN is no question')


def drawings(server, page, folder):
    for name, text, line in (('torn', 'from 0 0\nline 60 0\nline 60 40\n', 3), ('no drawing', PROGRAM, 1), ('bytes', '\0\1\2', 1), ('empty', '', 0), ('far', ZONE.replace('60', '1e30'), 2), ('crossing', 'from 0 0\nline 60 0\nline 0 40\nline 60 40\nclose\n', None)):
        (folder / 'try.txt').write_text(text)
        answer = page.ask('mill', **{**COVER, 'drawing': 'try.txt', 'tool_diameter': 4})
        problem = answer.get('problem', {})
        expect(problem.get('text') and answer['word'] == '' and (line is None or problem['line'] == line), f'{name}: {str(answer)[:200]}')
        if line == 3:
            expect(answer['line_text'] == 'line 60 40' and problem['hint'], f'{name}: its line, and what to do')
    (folder / 'try.txt').write_text(ZONE)
    expect('text' not in page.ask('mill', **{**COVER, 'drawing': 'try.txt', 'tool_diameter': 100}), 'the tool does not fit')
    (folder / 'try.txt').write_text('circle 0 0 5.1\n')
    answer = page.ask('mill', **{**COVER, 'drawing': 'try.txt', 'tool_diameter': 10, 'control': 'mach3'})
    expect('text' in answer and 'drill before' in answer['warning'], 'holes are told')
    (folder / 'try.txt').write_text(''.join(f'from {x} {y}\nline {x + 4} {y}\nline {x + 4} {y + 4}\nline {x} {y + 4}\nclose\n' for x in range(0, 350, 5) for y in range(0, 350, 5)))
    long = page.begin('mill', **{**COVER, 'drawing': 'try.txt', 'tool_diameter': 1, 'stepover': '1%'})
    begun, before = server.works(), server.spent()
    page.begin('stop')
    answer = page.answer(long)
    took = server.spent() - before
    expect(begun and answer.get('error', {}).get('text') == 'interrupted' and took < 10, f'a long one is stopped, {took:.1f} s of work later: {str(answer)[:200]}')
    (folder / 'try.txt').unlink()


def saved(page, folder):
    answer = page.ask('mill', **COVER)
    expect(answer['name'] == 'cover.nc', 'the name that is proposed')
    expect('digest' in page.ask('save', file=answer['name'], text=answer['text'], digest=None), 'it is saved')
    expect((folder / 'cover.nc').read_text() == answer['text'], 'as it was made')
    expect(page.ask('mill', **COVER)['name'] == 'cover_2.nc', 'the next name is of no file that is there')
    again = page.ask('save', file='cover.nc', text='x', digest=None)
    expect(again['error'].get('changed') and (folder / 'cover.nc').read_text() == answer['text'], 'nothing is written over')
    opened, done = page.open('cover.nc', control='s2c42')
    expect(opened['text'].rstrip('\n') == answer['text'].rstrip('\n') and done['state'] == 'ended' and done['extents']['cutting'][0][2] == -8, 'it opens and runs')


def tape(kadr, page, folder):
    for code, text, leader in (('iso', PROGRAM.split('\n', 1)[1], 100), ('eia', 'N1 G0 X5\nN2 M30\n', 7), ('iso', '%\r\nN1 G0 X5 ПС\r\nN2 (ОТВ.)\r\n', 0)):
        (folder / 'p.nc').write_bytes(text.encode())
        command(kadr, folder, 'tape', 'encode', 'p.nc', 'by_command.tape', '--code', code, '--leader', leader)
        punched = page.ask('tape', way='out', file='p.nc', code=code, leader=leader)
        rows = base64.b64decode(punched['bytes'])
        expect(rows == (folder / 'by_command.tape').read_bytes() and punched['rows'] == len(rows), f'{code}: the rows of the command')
        expect('digest' in page.ask('save', file=f'{code}{leader}.tape', bytes=punched['bytes'], digest=None), f'{code}: saved')
        expect((folder / f'{code}{leader}.tape').read_bytes() == rows, f'{code}: as they are')
        read = page.ask('tape', way='in', file=f'{code}{leader}.tape')
        expect(read['code'] == code and read['lies'] == '' and read['faults'] == [] and read['name'] == f'{code}{leader}.nc', f'{code}: read: {str(read)[:200]}')
        expect(read['text'] == command(kadr, folder, 'tape', 'decode', f'{code}{leader}.tape').stdout.decode(), f'{code}: the text of the command')
        expect(code == 'iso' and 'ПС' in text or read['text'] == text.replace('\r', ''), f'{code}: out and in is the same')
    edited = page.ask('tape', way='out', file='p.nc', text='N1 G1 X7\n')
    expect(base64.b64decode(edited['bytes'])[100:] != b'' and edited['rows'] == 209, 'the text as it stands in the editor')
    missing = page.ask('tape', way='out', file='p.nc', text='N1\nN2 (€)\n')
    expect("p.nc:2: '€' has no ISO-7 code" in missing['error']['text'], f'a character without a code: {missing}')
    rows = bytearray((folder / 'iso100.tape').read_bytes())
    (folder / 'turned.tape').write_bytes(rows[::-1])
    expect('wrong end' in page.ask('tape', way='in', file='turned.tape')['lies'], 'a tape that lies wrongly')
    rows[110] ^= 1
    (folder / 'torn.tape').write_bytes(rows)
    torn = page.ask('tape', way='in', file='torn.tape')
    expect(len(torn['faults']) == 1 and 'row 111: parity error' in torn['faults'][0] and torn['more'] == 0, f'a torn row: {torn["faults"]}')
    for name, more in {'no tape': {'way': 'in', 'file': 'p.nc'}, 'beyond': {'way': 'in', 'file': '../outside.txt'}, 'beyond, out': {'way': 'out', 'file': '/etc/passwd'}, 'empty': {'way': 'out', 'file': 'p.nc', 'text': ' \n'}}.items():
        expect('error' in page.ask('tape', **more), f'tape, {name}: refused')
    for name, more in {'no way': {'file': 'p.nc'}, 'a code': {'way': 'in', 'file': 'iso100.tape', 'code': 'ascii'}}.items():
        expect('error' in page.ask('tape', wrong=True, **more), f'tape, {name}: refused')
    for name, more in {'no base64': {'bytes': 'a'}, 'left over': {'bytes': 'QQ='}, 'letters': {'bytes': 'Q!=='}, 'bits': {'bytes': 'QR=='}}.items():
        expect('error' in page.ask('save', file='new.tape', digest=None, **more) and not (folder / 'new.tape').exists(), f'save, {name}: refused')
    expect('error' in page.ask('save', wrong=True, file='new.tape', digest=None, text='x', bytes='QQ=='), 'save: text and bytes')


def onlookers(server):
    page = Page(server)
    page.ask('hello', lang='en')
    expect('text' in page.ask('mill', **COVER) and 'bytes' in page.ask('tape', way='out', file='p.nc', text='N1\n'), 'who may not change may look')
    expect('error' in page.ask('save', file='theirs.tape', bytes='QQ==', digest=None), 'and saves nothing')


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    kadr = str(Path(options.parse_args().kadr).resolve())
    with tempfile.TemporaryDirectory() as above:
        folder = Path(above) / 'drawings'
        (folder / 'sub').mkdir(parents=True)
        (Path(above) / 'outside.txt').write_text(ZONE)
        (Path(above) / 'own.toml').write_text('id = "own"\nextends = "mach3"\nname = {en = "O", ru = "О"}\n')
        (folder / '.hidden.txt').write_text(ZONE)
        (folder / 'link.txt').symlink_to('../outside.txt')
        for name in ('cover.txt', 'groove.txt', 'lever.dxf'):
            (folder / name).write_bytes((EXAMPLES / name).read_bytes())
        server = Server(kadr, folder, '--open')
        page = Page(server)
        page.ask('hello', token=server.token, lang='en')
        before = sorted(p.name for p in folder.iterdir())
        same_as_the_command(kadr, page, folder)
        refused(page)
        drawings(server, page, folder)
        expect(sorted(p.name for p in folder.iterdir()) == before, 'nothing is written that nobody asked for')
        saved(page, folder)
        tape(kadr, page, folder)
        onlookers(server)
        expect(server.end() == 130, 'the server stands to the end')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
