#!/usr/bin/env python3
"""Tests the checklist with the tools file of a program (docs/checklist.md): which file is read, for what, and that `kadr check`, the page
and the report give the same findings.

    tool_tables.py --kadr PROGRAM
"""
import json
import sys
import tempfile
from pathlib import Path

import harness
from page_client.client import Page, Server, expect, result

IDS = ('tool_not_in_table', 'table_tools_unused')
OWN = 'extends = "fanuc"\nid = "own"\nname = { en = "own", ru = "own" }\n'


def program(*tools):
    """Line 3 + 7n calls the n-th tool."""
    lines = ['%', 'O0001 (T77 IS A COMMENT)']
    for t in tools:
        lines += [f'T{t} M6', 'G90 G54 G0 X0. Y0. S1000 M3', f'G43 H{t} Z50.', 'G0 Z2.', 'G1 Z-1. F100.', 'X20.', 'G0 Z50.']
    return '\n'.join([*lines, 'G91 G28 Z0.', 'G90', 'M30', '%', ''])


def toml(*tools):
    return '\n'.join(f'[[tool]]\nnumber = {t}\nkind = "flat"\ndiameter = 8\nflute_length = 20\nlength = 50\n' for t in tools)


def tbl(*tools):
    return ''.join(f'T{t} P{t} D8 ; mill\n' for t in tools)


# Case: files, more arguments of check, findings of p.nc as (line, id); whether the page and the report, which have no --tools,
# give the same.
CASES = {
    'no file': ({'p.nc': program(1, 2)}, [], [], True),
    'its own file, all there': ({'p.nc': program(1, 2), 'p.toml': toml(1, 2)}, [], [], True),
    'its own file, one missing': ({'p.nc': program(1, 2), 'p.toml': toml(1)}, [], [(10, 'tool_not_in_table')], True),
    'its own file, one too many': ({'p.nc': program(1, 2), 'p.toml': toml(1, 2, 9)}, [], [(3, 'table_tools_unused')], True),
    'its own file, a wrong number': ({'p.nc': program(1, 2), 'p.toml': toml(1, 3)}, [], [(3, 'table_tools_unused'), (10, 'tool_not_in_table')], True),
    'called twice, told once': ({'p.nc': program(1, 2, 1, 2), 'p.toml': toml(1)}, [], [(10, 'tool_not_in_table')], True),
    'a magazine': ({'p.nc': program(1, 2), 'p.toml': toml(*range(1, 41))}, [], [], True),
    'a table of LinuxCNC': ({'p.nc': program(1, 2), 'p.tbl': tbl(1)}, [], [(10, 'tool_not_in_table')], True),
    'its own before that of the folder': ({'p.nc': program(1, 2), 'p.toml': toml(1, 2), 'tools.toml': toml(1)}, [], [], True),
    'that of the folder, one missing': ({'p.nc': program(1, 2), 'tools.toml': toml(1, 5)}, [], [(10, 'tool_not_in_table')], True),
    'that of the folder, of other work': ({'p.nc': program(1, 2, 3), 'tools.toml': toml(1, 5)}, [], [], True),
    'of another program': ({'p.nc': program(1, 2), 'q.toml': toml(1)}, [], [], True),
    'no tools file': ({'p.nc': program(1, 2), 'p.toml': OWN, 'tools.toml': '[[tool]\n'}, [], [], True),
    'a file without tools': ({'p.nc': program(1, 2), 'p.tbl': ''}, [], [], True),
    'named': ({'p.nc': program(1, 2), 'p.toml': toml(1, 2), 'q.toml': toml(1, 3)}, ['--tools', 'q.toml'],
              [(3, 'table_tools_unused'), (10, 'tool_not_in_table')], False),
    'named, of several programs': ({'p.nc': program(1, 2), 'q.nc': program(3), 'q.toml': toml(1, 3)}, ['q.nc', '--tools', 'q.toml'],
                                   [(10, 'tool_not_in_table')], False),
    'switched off': ({'p.nc': program(1, 2), 'p.toml': toml(1, 3)}, ['--disable', 'table_tools_unused'], [(10, 'tool_not_in_table')], False),
}


def laid_out(folder, files):
    for name, text in files.items():
        (folder / name).write_text(text)


def of_page(kadr, folder):
    """Returns the findings when the page opens the program, and when it checks the text."""
    server = Server(kadr, folder)
    page = Page(server)
    page.ask('hello', token=server.token, lang='en')
    page.open('p.nc', control='fanuc')
    told = [(e['problem']['line'], e['problem']['id']) for e in page.events if e.get('event') == 'alarm']
    problems = page.ask('check', text=(folder / 'p.nc').read_text())['problems']
    server.end()
    return told, [(p['line'], p['id']) for p in problems]


def ours(findings):
    return sorted(f for f in findings if f[1] in IDS)


def main():
    options = harness.parsed(harness.arguments(__doc__))
    for what, (files, more, wanted, everywhere) in CASES.items():
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            laid_out(folder, files)
            bench = harness.Kadr(options.kadr, folder)
            done = bench.call('check', 'p.nc', *more, '--control', 'fanuc', '--format', 'json', '--lang', 'en')
            found = [(f['line'], f['id']) for f in json.loads(done.stdout) if Path(f['file']).name == 'p.nc']
            expect(ours(found) == wanted, f'{what}: check says {ours(found)}, not {wanted}')
            if not everywhere:
                continue
            for side, got in zip(('the page', "the page's check"), of_page(options.kadr, folder)):
                expect(ours(got) == wanted, f'{what}: {side} says {ours(got)}, not {wanted}')
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        laid_out(folder, {'p.nc': program(1, 2), 'p.toml': toml(1, 2), 'q.toml': toml(1, 3)})
        bench = harness.Kadr(options.kadr, folder)
        for more, wanted in (([], ()), (['--tools', 'q.toml'], IDS)):
            done = bench.call('report', 'p.nc', '--control', 'fanuc', '--lang', 'en', '--out', f'r{len(more)}.html', '-q', *more)
            if 'built without its page' in done.stderr:
                break
            said = tuple(sorted(i for i in IDS if i in done.stderr))
            expect(said == tuple(sorted(wanted)), f'report {more} says {said}: {done.stderr}')
        done = bench.call('check', 'p.nc', '--tools', 'nowhere.toml', '--lang', 'en')
        expect(done.returncode == 2 and 'nowhere.toml' in done.stderr, 'a tools file that is not there')
    return result()


if __name__ == '__main__':
    sys.exit(main())
