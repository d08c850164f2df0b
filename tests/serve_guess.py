#!/usr/bin/env python3
"""Tests that the page guesses the same control as `kadr check FILE` does, and gives the same reason: by the program's text, its name, the
files next to it, a control file or a .kadr.toml of the folder. The commands are the oracle; tests/guess.py is their oracle.

    serve_guess.py --kadr PROGRAM                 the folders of tests/guess.py, tests/guess_cases and examples
    serve_guess.py --kadr PROGRAM --folder PATH   the programs of that folder instead
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import guess
import harness
from page_client.client import Page, Server, expect, result

# Besides the folders of tests/guess.py: folders whose contents the page must treat like the command, or not see at all.
FOLDERS = [
    {'a.nc': 'G154 P3\nG0 X0.\n', '.b.nc': '$H\nG0 X1\n', 'c.nc': 'G0 X1.5\nG1 Z-2. F100.\n'},
    {'.kadr.toml': '[control_for]\n"a*" = "grbl"\n', 'a.nc': 'G0 X1.5\n', 'b.nc': 'G154 P3\nG0 X0.\n', 'c.nc': 'G0 X1.5\nG1 Z-2. F100.\n'},
    {'.kadr.toml': 'control = "fanuc"\n', 'a.nc': guess.LATHE, 'sub/b.nc': guess.MILL},
    {'a.nc': guess.ROUGH, 'b.nc': guess.SYSTEM_B, 'c.nc': 'O9020\nG0 X5. Z1.\nM99\n', 'd.nc': guess.DENFORD, 'e.nc': guess.LATHE},
    {'a.nc': '%00000\nN0 T1.1\nN1 M6\n', 'b.nc': '%00001\nN0 T2.2\nN1 M6\n', 'c.nc': 'N1 G0 X5 Y5\n'},
    {'O1001': '%\nO1001\nG187 P1\nG0 X0.\nM30\n%\n', 'O1002': '%\nO1002\nG0 X0.\nM30\n%\n', 'notes.txt': 'G154 P3\n'},
    {f'p{n:02}.nc': 'G0 X1.5\nG1 Z-2. F100.\n' for n in range(30)} | {'p20x.nc': 'G154 P3\nG0 X0.\n'},
]
SAID = re.compile(r'(?:looks like (?P<own>\S+) \((?P<mark>.*)\)|perhaps (?P<weak>\S+): a weak guess, nothing decides \((?P<little>.*)\)(?:; next comes \S+)?'
                  r'|perhaps (?P<as>\S+), (?P<beside>as .* is \(.*\); nothing of its own decides)'
                  r'|perhaps (?P<folder>\S+), (?P<whole>like its folder as a whole): a weak guess); otherwise: --control$')


def by_command(kadr, folder, file):
    """Returns control and reason; a named control has no reason, and a program of no control has no control."""
    done = subprocess.run([kadr, 'check', file, '--lang', 'en', '--max-blocks', '100'], cwd=folder, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=harness.TIME_LIMIT_S)
    for line in done.stderr.splitlines():
        if found := SAID.match(line.removeprefix('kadr: ').removeprefix(f'{file}: ')):
            control = found['own'] or found['weak'] or found['as'] or found['folder']
            why = found['mark'] or found['little'] or found['beside'] or found['whole']
            return control, re.sub(r'^as (?:.*/)?([^/]*) is \(', r'as \1 is (', why)   # the page shows names without folders
        if f'{file}: unknown, no program' in line or f'{file}: a lathe' in line:
            return None, None
    return 'named', ''


def by_page(page, file):
    opened, _ = page.open(file)
    if 'error' in opened:
        return None, None
    control = opened['control']
    return control['id'] if control['guessed'] else 'named', control['why']


def compare(kadr, folder, files):
    server = Server(kadr, folder)
    page = Page(server)
    page.ask('hello', token=server.token, lang='en')
    for file in files:
        control, why = by_command(kadr, folder, file)
        if control and control.endswith('.toml'):
            control = re.search(r'^id *= *"(.*)"', (folder / control).read_text(), re.M)[1]
        shown = by_page(page, file)
        expect(shown == (control, why), f'{folder.name}/{file}: the command says {control}, {why!r}; the page {shown[0]}, {shown[1]!r}')
    server.end()


def programs_of(folder):
    return sorted(str(path.relative_to(folder)) for path in folder.rglob('*')
                  if path.is_file() and not any(part.startswith('.') for part in path.relative_to(folder).parts)
                  and path.suffix in ('.nc', '.tap', '.ngc', '.nct', '.gcode', '.cnc', '.prg', '.mpf', ''))


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--folder', type=Path, help='a folder of programs to run instead of all')
    options = harness.parsed(parser)
    if options.folder:
        compare(options.kadr, options.folder.resolve(), programs_of(options.folder))
        return result()
    with tempfile.TemporaryDirectory() as name:
        for n, files in enumerate([*(files for files, _ in guess.FOLDERS), *FOLDERS]):
            folder = Path(name, f'folder{n}')
            guess.laid_out(folder, files)
            compare(options.kadr, folder, programs_of(folder))
    compare(options.kadr, harness.ROOT / 'examples', [file for file in programs_of(harness.ROOT / 'examples')])
    return result()


if __name__ == '__main__':
    sys.exit(main())
