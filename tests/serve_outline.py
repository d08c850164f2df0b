#!/usr/bin/env python3
"""Tests kadr serve: the outline of a program (outline), of the file and of the text in the editor, for several controls, in two
languages; a long program has the outline of its first 5,000 entries.

    serve_outline.py --kadr PROGRAM
"""
import argparse
import shutil
import tempfile
from pathlib import Path

from page_client.client import Page, Server, expect, result

EXAMPLES = Path(__file__).resolve().parent.parent / 'examples'
# Program, control, and of each entry: depth, kind, name, line.
OUTLINES = [
    ('bearing_plate.h', 'heidenhain', [
        (0, 'program', 'BEARING_PLATE', 1), (1, 'cycle', 'CYCL DEF 247 DATUM SETTING', 5), (1, 'tool', 'T1 Outline in three levels, end mill 16', 7),
        (2, 'label', 'LBL LEVEL', 12), (1, 'tool', 'T2 Bearing seat, end mill 10', 28), (2, 'cycle', 'CYCL DEF 252 CIRCULAR POCKET', 30),
        (1, 'tool', 'T3 Bolt circle, drill 6.8', 51), (2, 'cycle', 'CYCL DEF 203 UNIVERSAL DRILLING', 54)]),
    ('hole_flange.mpf', 'sinumerik', [
        (0, 'program', 'program', 1), (1, 'tool', 'T1 SPOT, TEN HOLES', 3), (2, 'cycle', 'CYCLE82', 7), (2, 'label', 'CORNERS', 8), (2, 'cycle', 'HOLES1', 8),
        (2, 'cycle', 'HOLES1', 9), (2, 'label', 'CIRCLE6', 11), (2, 'cycle', 'HOLES2', 11), (1, 'tool', 'T2 DRILL 6.8, SIX HOLES', 14), (2, 'cycle', 'CYCLE83', 18),
        (1, 'tool', 'T3 TAP M8', 21), (2, 'cycle', 'CYCLE84', 25), (1, 'tool', 'T4 DRILL 9, FOUR HOLES', 28), (2, 'cycle', 'CYCLE81', 32)]),
    ('flange_taps.nc', 'fanuc', [
        (0, 'program', 'O10 HOLES ON A CIRCLE BY A MACRO', 2), (1, 'tool', 'T1', 4), (2, 'cycle', 'G84', 11),
        (0, 'program', 'O9100 BOLT CIRCLE: X Y CENTRE, I RADIUS, H HOLES, Z R F AS G81', 14), (1, 'cycle', 'G81', 19)]),
    ('bolt_circles.ngc', 'linuxcnc', [(0, 'program', 'program', 1), (1, 'tool', 'T2 drill 6.8', 5), (2, 'cycle', 'G83', 15)]),
]


def of_examples(page):
    for file, control, wanted in OUTLINES:
        opened, _ = page.open(file, control=control)
        found = page.ask('outline')
        entries = [(e['depth'], e['kind'], e['name'], e['line']) for e in found['entries']]
        expect(entries[:len(wanted)] == wanted, f'{file}: {entries}')
        expect(not found['more'] and all(e['line'] <= e['last'] <= opened['lines'] for e in found['entries']), f'{file}: lines {found}')
        titles = {e['name']: e.get('title') for e in found['entries'] if e['kind'] == 'cycle'}
        expect(all(titles.values()), f'{file}: what each cycle does: {titles}')
        expect(page.ask('outline', text=opened['text'])['entries'] == found['entries'], f'{file}: the same of its text')


def of_text(page):
    page.open('flange_taps.nc', control='fanuc')
    names = [e['name'] for e in page.ask('outline', text='O5\r\nT7 M6\rG83 X1 Z-5 R2 Q1\nG80')['entries']]
    expect(names == ['O5', 'T7', 'G83'], f'the text of the editor, whatever ends its lines: {names}')
    expect(page.ask('outline', text='')['entries'] == [], 'nothing in nothing')
    page.ask('language', lang='ru')
    found = page.ask('outline', text='T7 M6\nG81 X1 Z-5 R2')['entries']
    expect(found[0]['name'] == 'программа' and 'сверл' in found[2]['title'].lower(), f'in Russian: {found}')
    page.ask('language', lang='en')
    long = page.ask('outline', text=''.join(f'T{n % 50 + 1} M6\nG1 X{n}\n' for n in range(20_000)))
    expect(len(long['entries']) == 5000 and long['more'], f'{len(long["entries"])} entries')


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    kadr = str(Path(options.parse_args().kadr).resolve())
    with tempfile.TemporaryDirectory() as folder:
        for file, control, _ in OUTLINES:
            shutil.copy(EXAMPLES / control / file, folder)
        server = Server(kadr, Path(folder), '--open')
        page = Page(server)
        page.ask('hello', token=server.token, lang='en')
        expect('error' in page.ask('outline'), 'without a program')
        of_examples(page)
        of_text(page)
        expect(server.end() == 130, 'the server stands to the end')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
