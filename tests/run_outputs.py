#!/usr/bin/env python3
"""Tests what kadr writes: no output destroys an input or another output; files are complete or absent; a program writes only where it may.

    run_outputs.py --kadr build/kadr [--only 'clash*']

Each check_… function is one check and works in a folder of its own.
Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import json
import os
import re
import stat
import subprocess
import sys
import threading
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import harness
from harness import expect

PROGRAM = 'F1000\nG1 X10\nG1 X0\nM30\n'
STOPS = 'F1000\nG1 X10\nG1 Q0\nM30\n'
WRITES = "FOPEN2<{}>\nDPRNT[HELLO]\nFCLOS\nM30\n"
CONTOUR = 'from 0 0\nline 40 0\nline 40 30\nline 0 30\nclose\n'


class Kadr(harness.Kadr):
    language = 'en'

    def run(self, *arguments, **more):
        """Returns what it prints on standard error."""
        return super().run(*arguments, **more).stderr


def everything(folder):
    """Returns name → bytes and type of everything below a folder."""
    return {str(p.relative_to(folder)): (stat.S_IFMT(p.lstat().st_mode), os.readlink(p) if p.is_symlink() else p.read_bytes() if p.is_file() else b'')
            for p in sorted(folder.rglob('*'))}


def refused(kadr, *arguments, word):
    """Checks that the status is 2, that nothing in the folder changes, and that the message contains the word."""
    before = everything(kadr.folder)
    text = kadr.run(*arguments, expected=2)
    expect(word in text, f'{arguments}: the message lacks "{word}": {text!r}')
    expect(everything(kadr.folder) == before, f'{arguments}: files have changed')


# ---- invalid file names

# Options of files that are only read; every other option with FILE in the help of a command is an output.
ONLY_READ = {'--setup', '--setup-a', '--setup-b', '--baseline', '--part', '--tools', '--join', '--settings', '--live'}
WORDS_FOR_NONE = ('off', 'OFF', 'no', 'none', 'None', 'false')


def options_of_outputs(kadr):
    """Yields (command words, option) of all outputs of the program, by its help."""
    listed = kadr.printed('--help')
    commands = [(word,) for word in re.findall(r'^  ([a-z]+) {2,}', listed[listed.index('Commands:'):], re.M)]
    while commands:
        command = commands.pop()
        text = kadr.printed(*command, '--help')
        if 'Commands:' in text:
            commands += [(*command, word) for word in re.findall(r'^  ([a-z]+) {2,}', text[text.index('Commands:'):], re.M)]
        for option in re.findall(r'^ +(?:-\w, )?(--[a-z-]+) FILE', text, re.M):
            if option not in ONLY_READ:
                yield command, option


def check_words_for_none_are_no_file_names(kadr):
    kadr.file('q.nc', PROGRAM)
    outputs = sorted(set(options_of_outputs(kadr)))
    for expected in ((('run',), '--trace'), (('cut',), '--blocks'), (('convert',), '--setup-out'), (('serve',), '--state')):
        expect(expected in outputs, f'{expected} is missing in {outputs}')
    expect(len(outputs) >= 20, f'only {len(outputs)} outputs are found: {outputs}')
    for command, option in outputs:
        for name in WORDS_FOR_NONE:
            refused(kadr, *command, f'{option}={name}', word=f'write ./{name}')
        for name in ('--help', '-q'):
            refused(kadr, *command, f'{option}={name}', word=option)
    kadr.run('run', 'q.nc', '--control', 'mach3', '--trace', './off')
    expect((kadr.folder / 'off').exists(), './off is a name')


# ---- an output that is an input, or another output

OUTPUTS = ('--trace', '--samples', '--plot', '--plot-speed')


def check_clash_with_the_program(kadr):
    for option in OUTPUTS:
        for name in ('q.svg', './q.svg', 'sub/../q.svg', 'link.svg', 'hard.svg', str(kadr.folder / 'q.svg')):
            kadr.file('q.svg', PROGRAM)
            (kadr.folder / 'sub').mkdir(exist_ok=True)
            for made in ('link.svg', 'hard.svg'):
                (kadr.folder / made).unlink(missing_ok=True)
            (kadr.folder / 'link.svg').symlink_to('q.svg')
            os.link(kadr.folder / 'q.svg', kadr.folder / 'hard.svg')
            refused(kadr, 'run', 'q.svg', '--control', 'mach3', option, name, word='would be written over the input')


def check_clash_with_setup_control_machine_state(kadr):
    kadr.file('q.nct', PROGRAM)
    kadr.file('setup.json', '{}')
    kadr.file('own.toml', 'id = "mine"\nextends = "nct"\nname = {en = "x", ru = "x"}\n')
    machine = Path(__file__).resolve().parents[1] / 'machines' / 'generic.toml'
    kadr.file('machine.toml', machine.read_text(encoding='utf-8'))
    kadr.run('run', 'q.nct', '--control', 'nct', '--state', 'state.db')
    files = ('--control', 'own.toml', '--machine', 'machine.toml', '--setup', 'setup.json', '--state', 'state.db')
    for name in ('setup.json', 'own.toml', 'machine.toml', 'state.db'):
        refused(kadr, 'run', 'q.nct', *files, '--trace', name, word='state.db' if name == 'state.db' else 'would be written over the input')
    refused(kadr, 'run', 'q.nct', '--control', 'nct', '--state', 'q.nct', word='q.nct')


def check_clash_of_two_outputs(kadr):
    kadr.file('q.nc', PROGRAM)
    kadr.file('there', 'kept')
    (kadr.folder / 'link').symlink_to('nowhere')
    for a, b in (('a', 'a'), ('a', './a'), ('there', 'there'), ('-', '-'), ('link', 'nowhere')):
        refused(kadr, 'run', 'q.nc', '--control', 'mach3', '--trace', a, '--samples', b, word='the same file as')


def check_devices_may_be_shared(kadr):
    kadr.file('q.nc', PROGRAM)
    kadr.run('run', 'q.nc', '--control', 'mach3', '--trace', '/dev/null', '--samples', '/dev/null', stdout=subprocess.DEVNULL)


def check_clash_with_standard_output(kadr):
    kadr.file('q.nc', PROGRAM)
    with open(kadr.folder / 'out', 'wb') as out:
        text = kadr.run('run', 'q.nc', '--control', 'mach3', '--trace', 'out', stdout=out, expected=2)
        expect('standard output' in text, text)
    with open(kadr.folder / 'q.nc', 'rb') as program:
        kadr.run('run', '-', '--control', 'mach3', '--trace', 'q.nc', stdin=program, expected=2)
    expect((kadr.folder / 'q.nc').read_text() == PROGRAM, 'the program on standard input is destroyed')


def check_clash_with_a_called_file(kadr):
    kadr.file('main.nct', 'G65 P12\nM30\n')
    kadr.file('O0012.nct', 'G0 X1\nM99\n')
    refused(kadr, 'run', 'main.nct', '--control', 'nct', '--trace', 'O0012.nct', word='would be written over the called file')


def check_clash_of_mill_and_tape(kadr):
    kadr.file('c.txt', CONTOUR)
    kadr.file('c.svg', CONTOUR)
    milled = ('--tool-diameter', '8', '--depth', '1', '--control', 'mach3')
    os.link(kadr.folder / 'c.txt', kadr.folder / 'hard.txt')
    for name in ('c.txt', 'hard.txt'):
        refused(kadr, 'mill', 'pocket', 'c.txt', *milled, '--output', name, word='would be written over the input')
    refused(kadr, 'mill', 'pocket', 'c.svg', *milled, '--output', 'o.nc', '--plot', 'c.svg', word='would be written over the input')
    refused(kadr, 'mill', 'pocket', 'c.txt', *milled, '--output', 'o.svg', '--plot', 'o.svg', word='the same file as')
    refused(kadr, 'tape', 'encode', 'c.txt', 'hard.txt', word='would be written over the input')


# ---- complete or absent

def check_usage_errors_touch_nothing(kadr):
    kadr.file('q.nc', PROGRAM)
    kadr.file('t', 'old')
    for wrong in (('--setup', 'missing.json'), ('--machine', 'missing.toml'), ('--plot', 'a.pdf'), ('--samples', 'no/folder/s'),
                  ('--colour', 'speed'), ('--encoding', 'what')):
        before = everything(kadr.folder)
        kadr.run('run', 'q.nc', '--control', 'mach3', '--trace', 't', *wrong, expected=2)
        expect(everything(kadr.folder) == before, f'{wrong}: files have changed')


def check_an_alarm_leaves_complete_files(kadr):
    kadr.file('q.nc', STOPS)
    kadr.file('t', 'old')
    kadr.run('run', 'q.nc', '--control', 'mach3', '--trace', 't', '--plot', 'p.svg', expected=1)
    last = json.loads((kadr.folder / 't').read_text().splitlines()[-1])
    expect(last['do'] == 'alarm', f'the last line: {last}')
    expect((kadr.folder / 'p.svg').read_text().rstrip().endswith('</svg>'), 'the picture is not whole')
    expect(not kadr.left_over(), f'left over: {kadr.left_over()}')


def check_what_cannot_be_written_leaves_all_as_it_was(kadr):
    kadr.file('q.nc', 'F1000\n' + 'G1 X1\nG1 X0\n' * 20_000)
    for option in ('--trace', '--samples'):
        other = '--samples' if option == '--trace' else '--trace'
        kadr.file('old', 'old')
        text = kadr.run('run', 'q.nc', '--control', 'mach3', option, '/dev/full', other, 'old', expected=2)
        expect('/dev/full' in text and 'disk is full' in text, text)
        expect((kadr.folder / 'old').read_text() == 'old', f'{other} was replaced')
    kadr.file('p.nc', PROGRAM)
    with open('/dev/full', 'wb') as full:
        kadr.run('run', 'p.nc', '--control', 'mach3', '--trace', 'old', stdout=full, expected=2)
    expect((kadr.folder / 'old').read_text() == 'old', 'the trace was replaced')
    expect(not kadr.left_over(), f'left over: {kadr.left_over()}')


def check_links_and_rights_stay(kadr):
    kadr.file('q.nc', PROGRAM)
    target = kadr.file('deep/target', 'old')
    target.chmod(0o640)
    (kadr.folder / 'a').symlink_to('b')
    (kadr.folder / 'b').symlink_to('deep/target')
    kadr.run('run', 'q.nc', '--control', 'mach3', '--trace', 'a')
    expect((kadr.folder / 'a').is_symlink() and (kadr.folder / 'b').is_symlink(), 'a link was replaced')
    expect(target.read_text().startswith('{'), 'the trace is not behind the links')
    expect(stat.S_IMODE(target.stat().st_mode) == 0o640, f'rights {target.stat().st_mode:o}')
    kadr.run('run', 'q.nc', '--control', 'mach3', '--trace', 'new')
    mask = int(re.search(r'^Umask:\s*(\d+)', Path('/proc/self/status').read_text(encoding='ascii'), re.M)[1], 8)
    expect(stat.S_IMODE((kadr.folder / 'new').stat().st_mode) == 0o666 & ~mask, 'rights of a new file')


# ECMA-376 part 2, annexes D and F; 3MF Core Specification 1.2, 2.1 and 2.3.2: copied from there, not from what Kadr writes.
PACKAGE = 'http://schemas.openxmlformats.org/package/2006/'
TYPES_3MF = {'rels': 'application/vnd.openxmlformats-package.relationships+xml',
             'model': 'application/vnd.ms-package.3dmanufacturing-3dmodel+xml'}
MODEL_3MF = '{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}'


def check_a_3mf_file_is_what_other_programs_read(kadr):
    kadr.file('q.nc', 'M6 T1\nM3 S1000\nG0 X-10 Y10 Z-1\nG1 X30 F100\nM30\n')
    kadr.file('tools.toml', '[[tool]]\nnumber = 1\nkind = "flat"\ndiameter = 6\nflute_length = 20\nlength = 40\n')
    kadr.run('cut', 'q.nc', '--control', 'mach3', '--stock', 'box:0,0,-5,20,20,0', '--tools', 'tools.toml', '--out', 'part.3mf')
    with zipfile.ZipFile(kadr.folder / 'part.3mf') as package:
        expect(package.testzip() is None, 'a checksum of the package is wrong')
        types = ElementTree.fromstring(package.read('[Content_Types].xml'))
        given = {row.get('Extension'): row.get('ContentType') for row in types.iter(f'{{{PACKAGE}content-types}}Default')}
        expect(given == TYPES_3MF, f'content types: {given}')
        links = list(ElementTree.fromstring(package.read('_rels/.rels')).iter(f'{{{PACKAGE}relationships}}Relationship'))
        expect([link.get('Type') for link in links] == ['http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'], f'relationships: {links}')
        model = ElementTree.fromstring(package.read(links[0].get('Target').lstrip('/')))
    expect(model.tag == f'{MODEL_3MF}model' and model.get('unit') == 'millimeter', f'the model is a {model.tag} in {model.get("unit")}')
    corners = len(list(model.iter(f'{MODEL_3MF}vertex')))
    uses = [int(row.get(key)) for row in model.iter(f'{MODEL_3MF}triangle') for key in ('v1', 'v2', 'v3')]
    expect(corners > 8 and sorted(set(uses)) == list(range(corners)), f'{corners} corners, {len(uses) // 3} triangles')


def check_a_fifo_is_written_straight(kadr):
    kadr.file('q.nc', PROGRAM)
    os.mkfifo(kadr.folder / 'fifo')
    got = []
    reader = threading.Thread(target=lambda: got.append((kadr.folder / 'fifo').read_text()))
    reader.start()
    kadr.run('run', 'q.nc', '--control', 'mach3', '--trace', 'fifo')
    reader.join(harness.TIME_LIMIT_S)
    expect(got and got[0].splitlines()[-1].startswith('{"do":"end"'), f'the FIFO had {got}')
    expect(stat.S_ISFIFO((kadr.folder / 'fifo').stat().st_mode), 'the FIFO was replaced')


def check_a_folder_is_no_output(kadr):
    kadr.file('q.nc', PROGRAM)
    (kadr.folder / 'd.svg').mkdir()
    for option in OUTPUTS:
        refused(kadr, 'run', 'q.nc', '--control', 'mach3', option, 'd.svg', word='d.svg')


def check_full_standard_output(kadr):
    kadr.file('q.nc', PROGRAM)
    kadr.file('bad.nc', STOPS)
    kadr.file('c.txt', CONTOUR)
    kadr.file('t.txt', 'N1 G0\n')
    mill = ('mill', 'pocket', 'c.txt', '--tool-diameter', '8', '--depth', '1', '--control', 'mach3')
    commands = [('run', 'q.nc', '--control', 'mach3'), ('run', 'q.nc', '--control', 'mach3', '--trace', '-'),
                ('check', 'bad.nc', '--control', 'mach3', '--format', 'json'), ('check', 'q.nc', '--control', 'mach3'),
                ('check', 'q.nc', '--control', 'mach3', '--format', 'sarif'), ('explain', 'mach3', 'G1'), ('controls',),
                ('tape', 'encode', 't.txt', '-'), mill]
    for command in commands:
        with open('/dev/full', 'wb') as full:
            text = kadr.run(*command, stdout=full, expected=2)
        expect('disk is full' in text, f'{command}: {text!r}')


# ---- outputs of a part program

def check_by_default_a_program_writes_nothing(kadr):
    for name in ('out.txt', 'a.txt'):
        kadr.file('main.nct', WRITES.format(name))
        before = everything(kadr.folder)
        text = kadr.run('run', 'main.nct', '--control', 'nct')
        expect(everything(kadr.folder) == before, 'a file was written')
        expect(name in text and '7 bytes' in text and '--files' in text, f'not told: {text!r}')


def check_with_files_only_below_it(kadr):
    kadr.file('main.nct', WRITES.format('out.txt'))
    kadr.run('run', 'main.nct', '--control', 'nct', '--files', 'out')
    expect((kadr.folder / 'out' / 'out.txt').read_bytes() == b'HELLO\r\n', 'not written')
    refused(kadr, 'run', 'main.nct', '--control', 'nct', '--files', 'no/folder', word='no/folder')
    refused(kadr, 'run', 'main.nct', '--control', 'nct', '--files', 'main.nct', word='main.nct')


def check_no_hidden_files(kadr):
    for name in ('.bashrc', '.git\\config', 'a\\.x'):
        kadr.file('main.nct', WRITES.format(name))
        before = everything(kadr.folder)
        kadr.run('run', 'main.nct', '--control', 'nct', '--files', '.', expected=1)
        expect(everything(kadr.folder) == before, f'{name}: a file was written')


def check_a_program_cannot_reach_the_run(kadr):
    kadr.file('setup.json', '{}')
    kadr.file('main.nct', 'M30\n')
    kadr.run('run', 'main.nct', '--control', 'nct', '--state', 'a.db')
    for name in ('a.db', 'a.db-wal', 'a.db-shm', 'a.db-journal', 'setup.json', 'trace', 'TRACE', 's.csv', 'main.nct'):
        kadr.file('main.nct', WRITES.format(name))
        before = everything(kadr.folder)
        kadr.run('run', 'main.nct', '--control', 'nct', '--files', '.', '--state', 'a.db', '--setup', 'setup.json', '--trace', 'trace',
                 '--samples', 's.csv', expected=1)
        after = everything(kadr.folder)
        for made in ('trace', 's.csv'):
            before.pop(made, None)
            expect(after.pop(made, (0, b'HELLO'))[1][:5] != b'HELLO', f'{name}: the program wrote {made}')
        expect({k: v for k, v in after.items() if k != 'a.db'} == {k: v for k, v in before.items() if k != 'a.db'}, f'{name}: files have changed')
        expect(after['a.db'][1][:6] == b'SQLite', f'{name}: the state is gone')


if __name__ == '__main__':
    sys.exit(harness.main(__doc__, globals(), Kadr))
