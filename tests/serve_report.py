#!/usr/bin/env python3
"""Tests the report that the page makes: it is what kadr report writes for the same program, byte for byte; with the part that the page cut.

    serve_report.py --kadr PROGRAM

If the program was built without its page, the test checks the message about that.
"""
import argparse
import shutil
import tempfile
from pathlib import Path

import harness
from page_client.client import Page, Server, expect, result, seen
from report import content

CUT = harness.ROOT / 'examples' / 'cut'
BLANK = 'box:-40,-30,-20,40,30,0'
WRONG = 'G21 G90\nG0 X0\nG1 X10\nM30\n'


def written(kadr, folder, *words):
    """Returns what kadr report writes."""
    out = folder / 'command.html'
    kadr.call('report', *words, '--out', out, '--lang', 'en')
    return out.read_bytes() if out.exists() else b''


def made(page, folder):
    """Asks for the report, and returns it as a file."""
    answer = page.ask('report')
    expect('html' in answer, f'the report is made: {answer.get("error")}')
    file = folder / 'page.html'
    file.write_bytes(answer.get('html', '').encode())
    return answer.get('name'), file


def check(kadr, page, folder):
    expect('error' in page.ask('report'), 'without a program there is no report')
    page.open('plate.nc', control='mach3')
    name, file = made(page, folder)
    expect(name == 'plate.html', f'its name: {name}')
    expect(file.read_bytes() == written(kadr, folder, folder / 'plate.nc', '--control', 'mach3'), 'it is what kadr report writes')
    page.open('wrong.nc', control='fanuc')
    _, file = made(page, folder)
    expect(file.read_bytes() == written(kadr, folder, folder / 'wrong.nc', '--control', 'fanuc'), 'with an alarm too')
    _, data, _ = content(file)
    expect(any(p['severity'] == 'alarm' and p['line'] == 3 for p in data['en']['problems']), 'the alarm is inside')
    page.open('plate.nc', control='mach3', text=WRONG)
    _, file = made(page, folder)
    expect(content(file)[1]['sources'][0]['text'].startswith('G21 G90\nG0 X0'), 'the text in the editor')
    page.open('crash.nc', control='mach3')
    page.ask('cut', tools='tools.toml', stock=BLANK, resolution=1)
    page.until('cut')
    _, file = made(page, folder)
    written(kadr, folder, folder / 'crash.nc', '--control', 'mach3', '--tools', folder / 'tools.toml', '--stock', BLANK, '--resolution', 1)
    _, data, pieces = content(file)
    _, wanted, wanted_pieces = content(folder / 'command.html')
    expect([p for k, p in pieces if k == 3] == [p for k, p in wanted_pieces if k == 3] != [], 'the part')
    expect(data['en']['findings'] == wanted['en']['findings'] != [] and data['en']['cut'] == wanted['en']['cut'], 'what is hit')


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    program = str(Path(options.parse_args().kadr).resolve())
    with tempfile.TemporaryDirectory() as above:
        folder = Path(above)
        for file in ('plate.nc', 'crash.nc', 'tools.toml'):
            shutil.copy(CUT / file, folder)
        (folder / 'wrong.nc').write_text(WRONG)
        kadr = harness.Kadr(program, folder)
        server = Server(program, folder, '--open')
        page = Page(server)
        page.ask('hello', token=server.token, lang='en')
        page.open('plate.nc', control='mach3')
        answer = page.ask('report')
        if 'npm' in answer.get('error', {}).get('text', ''):
            print('built without the page')
            return result()
        server.end()
        server = Server(program, folder, '--open')
        page = Page(server)
        page.ask('hello', token=server.token, lang='en')
        check(kadr, page, folder)
        server.end()
    expect({'question.report', 'answer.report'} <= seen, 'the messages were sent')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
