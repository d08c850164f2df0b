#!/usr/bin/env python3
"""Tests the extension for VS Code (editors/vscode) without an editor: its unit tests by node, with the packages that the build of the page
has installed, and the grammars of dev/grammars against what the program knows.

    vscode_extension.py --kadr build/release/kadr

`dev/vsix --test` runs the rest, which needs packages of its own: the grammars as an editor reads them, and `kadr dap` with the public client
for tests of debug adapters. If `dev/vsix` has installed them in build/vsix, that client is used here too.
"""
import json
import os
import re
import shutil
import subprocess
import sys

import harness
from harness import ROOT, expect

EXTENSION = ROOT / 'editors' / 'vscode'
ALONE = ['settings', 'follow', 'package', 'report']   # test/NAME.test.ts that need no package


def modules(kadr, package):
    """Returns the first folder node_modules of a build that has the package; None if there is none, or no node."""
    folders = [harness.Path(kadr.program).resolve().parent / 'web' / 'node_modules', ROOT / 'build' / 'vsix' / 'vscode' / 'node_modules']
    return next((folder for folder in folders if (folder / package).exists() and shutil.which('node')), None)


def node_tests(kadr, folder, names):
    command = ['node', EXTENSION / 'test' / 'run.mjs', *(f'{name}.test.ts' for name in names)]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=harness.TIME_LIMIT_S, check=False,
                          env={**os.environ, 'MODULES': str(folder), 'KADR': kadr.program})
    expect(done.returncode == 0, f'{names}: {done.stdout[-3000:]} {done.stderr[-1000:]}')
    ran = re.search(r'^(?:#|ℹ) pass (\d+)', done.stdout, re.M)
    expect(ran and int(ran[1]) >= len(names), f'nothing has been tested: {done.stdout[-500:]}')


def check_the_units(kadr):
    folder = modules(kadr, 'esbuild')
    if not folder:
        harness.skipped('node or its package esbuild is missing: the page was not built')
        return
    node_tests(kadr, folder, ALONE)


def check_the_debugger(kadr):
    folder = modules(kadr, '@vscode/debugadapter-testsupport')
    if not folder:
        harness.skipped('the client for tests of debug adapters is not installed (dev/vsix installs it)')
        return
    node_tests(kadr, folder, ['debugger'])


def check_the_grammars(kadr):
    out = kadr.folder / 'out'
    out.mkdir()
    shutil.copy(EXTENSION / 'package.json', out)
    subprocess.run([sys.executable, ROOT / 'dev' / 'grammars', out], check=True, timeout=harness.TIME_LIMIT_S)
    contributes = json.loads((out / 'package.json').read_text(encoding='utf-8'))['contributes']
    languages = {one['id'] for one in contributes['languages']}
    expect(languages == {'nc', *(f'nc-{name}' for name in harness.CONTROLS)}, f'languages: {languages}')
    for one in contributes['grammars'] + [{'path': row['configuration']} for row in contributes['languages']]:
        expect((out / one['path']).is_file(), f'{one["path"]} is missing')
    for name in harness.CONTROLS:
        rules = json.loads((out / f'syntaxes/nc-{name}.tmLanguage.json').read_text(encoding='utf-8'))['patterns']
        known = {rule['name']: re.compile(rule['match']) for rule in rules if re.search('preparatory|auxiliary', rule.get('name', ''))}
        for code in re.findall(r'^  ([GM]\d+(?:\.\d+)?) ', kadr.printed('controls', name), re.M):
            scope = 'keyword.control.preparatory.nc' if code[0] == 'G' else 'support.function.auxiliary.nc'
            found = scope in known and known[scope].match(f'{code} X1')
            expect(found and found[0] == code, f'{name}: {code} has no colour')


def check_the_commands(kadr):
    """A client registers the commands of the server too: a name that the extension has as well keeps the server from starting."""
    text = json.dumps({'jsonrpc': '2.0', 'id': 1, 'method': 'initialize', 'params': {'capabilities': {}}}).encode()
    done = kadr.call('lsp', binary=True, input=b'Content-Length: %d\r\n\r\n%s' % (len(text), text))
    server = json.loads(done.stdout.split(b'\r\n\r\n', 1)[1])['result']['capabilities'].get('executeCommandProvider', {}).get('commands', [])
    own = [one['command'] for one in json.loads((EXTENSION / 'package.json').read_text(encoding='utf-8'))['contributes']['commands']]
    expect(own and server and not set(own) & set(server), f'extension {own}, server {server}')


def check_wrong_usage(_kadr):
    done = subprocess.run([sys.executable, ROOT / 'dev' / 'grammars'], capture_output=True, text=True, check=False)
    expect(done.returncode == 2 and 'dev/grammars OUT' in done.stderr, f'{done}')


if __name__ == '__main__':
    sys.exit(harness.main(__doc__, globals()))
