#!/usr/bin/env python3
"""Tests `kadr lsp` (docs/lsp.md) as an editor uses it: over standard input and output, with the messages of the Language Server Protocol 3.17.

    lsp.py --kadr build/release/kadr
    KADR_LSP_MESSAGES=1000000 lsp.py --kadr build/release/kadr --only 'random-messages'

Checked are the life cycle with its errors, each feature on small programs of several controls, the same findings as `kadr check`, the same
document after random changes as after opening its text, and random messages: each request gets exactly one answer. Each message of the
server is compared with the shapes of the specification (lsp_shapes.py).
"""
import json
import os
import random
import select
import signal
import subprocess
import sys
import time
from pathlib import Path

import harness
import lsp_shapes
from harness import expect

MESSAGES = int(os.environ.get('KADR_LSP_MESSAGES', 400))
URI = 'file:///work/part.nc'
FIRST = 5000   # the number of the first random request
NOT_FOUND, WRONG_PARAMS, NOT_INITIALIZED, WRONG_REQUEST, CANCELLED, FAILED = -32601, -32602, -32002, -32600, -32800, -32803


ABLE = {'workspace': {'applyEdit': True, 'workspaceEdit': {'documentChanges': True, 'resourceOperations': ['create', 'rename']}},
        'window': {'showDocument': {'support': True}},
        'textDocument': {'codeAction': {'codeActionLiteralSupport': {'codeActionKind': {'valueSet': ['quickfix', 'refactor']}}},
                         'documentSymbol': {'hierarchicalDocumentSymbolSupport': True}, 'hover': {'contentFormat': ['markdown', 'plaintext']}}}


class Editor:
    """An editor that talks with the program under test. `able`: its capabilities; `folders`: those of its workspace, as paths."""

    def __init__(self, kadr, options=None, encodings=('utf-16',), locale='en', begins=True, able=None, folders=None):
        self.process = subprocess.Popen(kadr.command(['lsp', '--stdio']), cwd=kadr.folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.read, self.last, self.notes, self.methods = b'', 0, [], {}
        if begins:
            self.capabilities = self.ask('initialize', {'processId': None, 'rootUri': None, 'locale': locale, 'initializationOptions': options or {},
                                                        **({'workspaceFolders': [folder(path) for path in folders]} if folders else {}),
                                                        'capabilities': {'general': {'positionEncodings': list(encodings)}, **(ABLE if able is None else able)}})
            self.capabilities = self.capabilities['result']['capabilities']
            self.tell('initialized', {})

    def put(self, content):
        data = content if isinstance(content, bytes) else json.dumps(content).encode()
        if isinstance(content, dict) and 'method' in content and 'id' in content:
            self.methods[content['id']] = content['method']
        self.process.stdin.write(b'Content-Length: %d\r\n\r\n%s' % (len(data), data))
        self.process.stdin.flush()

    def get(self):
        """Returns the next message; None at the end of the output."""
        until = time.monotonic() + harness.TIME_LIMIT_S
        while b'\r\n\r\n' not in self.read or len(self.read) < self.end():
            ready, _, _ = select.select([self.process.stdout], [], [], max(0, until - time.monotonic()))
            expect(ready, 'no message within the time limit')
            more = os.read(self.process.stdout.fileno(), 65536)
            if not more:
                return None
            self.read += more
        content = self.read[self.read.index(b'\r\n\r\n') + 4:self.end()]
        self.read = self.read[self.end():]
        message = json.loads(content)
        if message.get('id') is not None:   # an answer to what is no message has the id null
            fault = lsp_shapes.fault_of_message(message, self.methods)
            expect(not fault, f'the shape of a message: {fault}')
        return message

    def end(self):
        head = self.read[:self.read.index(b'\r\n\r\n')]
        return len(head) + 4 + int(head.split(b':')[1])

    def tell(self, method, params):
        self.put({'jsonrpc': '2.0', 'method': method, 'params': params})

    def ask(self, method, params):
        """Sends a request.  returns its answer; notifications before it are kept in `notes`"""
        self.last += 1
        self.put({'jsonrpc': '2.0', 'id': self.last, 'method': method, 'params': params})
        return self.answer(self.last)

    def answer(self, number):
        while True:
            message = self.get()
            expect(message is not None, 'the server has ended')
            if 'method' not in message:
                expect(message.get('id') == number, f'the answer belongs to {message.get("id")}, not to {number}')
                return message
            self.notes.append(message)

    def open(self, text, uri=URI, version=1):
        self.tell('textDocument/didOpen', {'textDocument': {'uri': uri, 'languageId': 'nc', 'version': version, 'text': text}})

    def change(self, text, version, where=None, uri=URI):
        change = {'text': text, **({'range': where} if where else {})}
        self.tell('textDocument/didChange', {'textDocument': {'uri': uri, 'version': version}, 'contentChanges': [change]})

    def findings(self, version=1, uri=URI):
        """Waits for the findings of this version."""
        while True:
            for note in self.notes:
                if note['method'] == 'textDocument/publishDiagnostics' and note['params']['uri'] == uri and note['params'].get('version') == version:
                    return note['params']['diagnostics']
            message = self.get()
            expect(message is not None, 'the server has ended')
            self.notes.append(message)

    def at(self, method, line, character, **more):
        answer = self.ask(f'textDocument/{method}', {'textDocument': {'uri': URI}, 'position': {'line': line, 'character': character}, **more})
        return answer['result'] if 'result' in answer else answer['error']

    def of(self, method, **more):
        return self.ask(f'textDocument/{method}', {'textDocument': {'uri': URI}, **more})['result']

    def asked(self, method):
        """Waits for a request of the server.  returns it; it is not answered yet"""
        while True:
            for i, note in enumerate(self.notes):
                if note['method'] == method:
                    return self.notes.pop(i)
            message = self.get()
            expect(message is not None and 'method' in message, f'{method} expected: {message}')
            self.notes.append(message)

    def until(self, answer):
        """Repeats a request until its answer is not empty: the results of the lines follow the findings."""
        limit = time.monotonic() + harness.TIME_LIMIT_S
        while not (result := answer()):
            expect(time.monotonic() < limit, 'no answer within the time limit')
            time.sleep(0.05)
        return result

    def close(self):
        self.ask('shutdown', None)
        self.tell('exit', None)
        return self.process.wait(harness.TIME_LIMIT_S)


def folder(path):
    return {'uri': f'file://{path}', 'name': Path(path).name}


def position(line, character):
    return {'line': line, 'character': character}


def area(line, begin, end, last=None):
    return {'start': position(line, begin), 'end': position(line if last is None else last, end)}


def applied(text, edits):
    """Returns the text with edits of single lines, from the last to the first."""
    lines = text.split('\n')
    for edit in sorted(edits, key=lambda e: (e['range']['start']['line'], e['range']['start']['character']), reverse=True):
        start, end = edit['range']['start'], edit['range']['end']
        line = lines[start['line']]
        lines[start['line']] = line[:start['character']] + edit['newText'] + line[end['character']:]
    return '\n'.join(lines)


FANUC = '''%
O0001 (PLATE)
N10 G90 G54 G17 G21
(FACE MILL)
T1 M6
N20 G0 X0 Y0 S1200 M3
G43 Z50. H1
#101=5.
G1 Z-1. F200
N30 X#101
IF[#101GT9]GOTO 30
G81 X10. Y10. Z-5. R2. F100
G80
M98 P0200
M30
O0200
G91 G1 X1. F300
M99
%
'''


# ---- life cycle

def check_the_life_cycle(kadr):
    editor = Editor(kadr, begins=False)
    expect(editor.ask('textDocument/hover', {})['error']['code'] == NOT_INITIALIZED, 'a request before initialize')
    editor.tell('textDocument/didOpen', {})
    expect('result' in editor.ask('initialize', {'capabilities': {}}), 'initialize')
    expect(editor.ask('initialize', {'capabilities': {}})['error']['code'] == WRONG_REQUEST, 'initialize twice')
    expect(editor.ask('textDocument/unknown', {})['error']['code'] == NOT_FOUND, 'an unknown method')
    expect(editor.ask('textDocument/hover', {'textDocument': {'uri': 'file:///x'}, 'position': position(0, 0)})['error']['code'] == WRONG_PARAMS, 'not open')
    expect(editor.ask('textDocument/hover', {'textDocument': 5})['error']['code'] == WRONG_PARAMS, 'wrong parameters')
    expect(editor.ask('shutdown', None)['result'] is None, 'shutdown')
    expect(editor.ask('textDocument/hover', {})['error']['code'] == WRONG_REQUEST, 'a request after shutdown')
    editor.tell('exit', None)
    expect(editor.process.wait(harness.TIME_LIMIT_S) == 0, 'exit status after shutdown')


def check_the_end_without_shutdown(kadr):
    for end in (lambda e: e.tell('exit', None), lambda e: e.process.stdin.close()):
        editor = Editor(kadr)
        editor.open(FANUC)
        end(editor)
        expect(editor.process.wait(harness.TIME_LIMIT_S) == 1, 'exit status without shutdown')


def check_interrupt(kadr):
    editor = Editor(kadr)
    editor.process.stdin.write(b'Content-Length: 50\r\n')   # the beginning of a message
    editor.process.stdin.flush()
    editor.process.send_signal(signal.SIGINT)
    expect(editor.process.wait(harness.TIME_LIMIT_S) != 0, 'Ctrl-C')


def check_broken_input(kadr):
    editor = Editor(kadr)
    for content in (b'{', b'[]', b'5', b'{"id":901}', b'{"method":5,"id":902}', b'\xff\xfe', b'{"jsonrpc":"2.0","id":{},"method":"shutdown"}'):
        editor.put(content)
    seen = []
    editor.last += 1
    editor.put({'jsonrpc': '2.0', 'id': editor.last, 'method': 'workspace/symbol', 'params': {'query': ''}})
    while True:
        message = editor.get()
        seen.append(message)
        if message.get('id') == editor.last:
            break
    expect(all('error' in m for m in seen[:-1]) and 'result' in seen[-1], f'broken messages are refused and the next is answered: {seen}')
    editor.process.stdin.write(b'no header at all\r\n\r\n')
    editor.process.stdin.flush()
    expect(editor.process.wait(harness.TIME_LIMIT_S) == 1, 'the end after a broken header')


def check_cancelled_requests(kadr):
    editor = Editor(kadr)
    editor.open(FANUC)
    hover = {'textDocument': {'uri': URI}, 'position': position(2, 5)}
    many = 200
    for number in range(1000, 1000 + many):
        editor.put({'jsonrpc': '2.0', 'id': number, 'method': 'textDocument/hover', 'params': hover})
        editor.tell('$/cancelRequest', {'id': number})
    for number in range(1000, 1000 + many):
        answer = editor.answer(number)   # each has one answer, whether the cancellation came in time or not
        expect('result' in answer or answer['error']['code'] == CANCELLED, f'{answer}')
    expect(editor.close() == 0, 'the end')


# ---- features

def check_findings_like_the_command(kadr):
    for control, text in (('fanuc', FANUC.replace('R2.', 'R')), ('linuxcnc', 'G21\nG1 X10\nG2 X5 I1\nM2\n'), ('grbl', 'G21\nG0 X1\nG99\n'),
                          ('fanuc', 'O1\nG0 X1.\nG2 X10. Y0. R1. F100\nM30\n')):
        path = kadr.file('part.nc', text)
        wanted = json.loads(kadr.call('check', path, '--control', control, '--format', 'json', '--lang', 'en').stdout)
        editor = Editor(kadr, {'control': control})
        uri = f'file://{path}'
        editor.open(text, uri)
        got = editor.findings(uri=uri)
        expect([(d['code'], d['range']['start']['line'] + 1) for d in got] == [(f['id'], f['line']) for f in wanted], f'{control}: {got} {wanted}')
        expect(wanted, 'a program without findings tests nothing')
        editor.close()


def check_findings_follow_the_text(kadr):
    editor = Editor(kadr, {'control': 'linuxcnc'})
    editor.open('G21 F100\nG1 X10 Q\nM2\n')
    first = editor.findings(1)
    expect([d['range']['start']['line'] for d in first if d['severity'] == 1] == [1], f'{first}')
    editor.change('', 2, area(1, 6, 8))
    expect(not [d for d in editor.findings(2) if d['severity'] == 1], 'the fault is mended')
    editor.close()


def check_guess_and_unknown(kadr):
    editor = Editor(kadr)
    editor.open('hello, world\n')
    found = editor.findings()
    expect(len(found) == 1 and found[0]['severity'] == 3, f'a text of no control: {found}')
    expect(editor.of('documentSymbol') == [] and editor.at('hover', 0, 0) is None, 'features without a control')
    editor.change(FANUC, 2)
    expect(all(d.get('code') for d in editor.findings(2)), 'the control is known once the text shows it')
    editor.close()


def check_hover_and_language(kadr):
    for locale, word in (('en', 'drill'), ('ru', 'сверл')):
        editor = Editor(kadr, {'control': 'fanuc'}, locale=locale)
        editor.open(FANUC)
        editor.findings()
        text = editor.at('hover', 11, 1)['contents']['value']
        expect(word in text.lower() and 'G81' in text, f'{locale}: {text}')
        after = editor.until(lambda: editor.at('hover', 8, 30))
        expect(after and 'Z -1' in after['contents']['value'] and 'F 200' in after['contents']['value'], f'the tool after the line: {after}')
        editor.close()


def check_completion_and_signature(kadr):
    editor = Editor(kadr, {'control': 'fanuc'})
    text = FANUC.replace('G80\n', 'G8\n')
    editor.open(text)
    items = editor.at('completion', 12, 2)['items']
    labels = [item['label'] for item in items]
    expect('G81' in labels and 'M3' not in labels, f'codes with G: {labels[:20]}')
    made = applied(text, [next(item for item in items if item['label'] == 'G80')['textEdit']])
    expect(made == FANUC, 'the proposal replaces the word')
    editor.change('#', 2, area(12, 0, 2))
    expect('#101' in [item['label'] for item in editor.at('completion', 12, 1)['items']], 'variables of the program')
    help_ = editor.at('signatureHelp', 11, len('G81 X10. Y10. Z-5. R2'))
    signature = help_['signatures'][0]
    active = signature['parameters'][help_['activeParameter']]
    expect(signature['label'].startswith('G81') and signature['label'][slice(*active['label'])] == 'R', f'{help_}')
    editor.close()


def check_navigation(kadr):
    editor = Editor(kadr, {'control': 'fanuc'})
    editor.open(FANUC)
    expect([one['range'] for one in editor.at('definition', 10, 18)] == [area(9, 1, 3)], 'GOTO 30')
    expect([one['range']['start']['line'] for one in editor.at('definition', 13, 7)] == [15], 'M98 P0200')
    uses = editor.at('references', 7, 2, context={'includeDeclaration': True})
    expect([one['range']['start']['line'] for one in uses] == [7, 9, 10], f'#101: {uses}')
    expect([one['kind'] for one in editor.at('documentHighlight', 7, 2)] == [3, 2, 2], 'written once, read twice')
    expect(editor.at('definition', 0, 0) == [], 'nothing to define')
    editor.close()


FOLDERS = {
    # control: (files of the folder, place of the call, the definition, the places of all references without definition)
    'fanuc': ({'main.nc': 'O1\nG21\nM98 P200\nM98 P300\nM30\n', 'O0200.nc': 'O200\nG0 X1.\nM99\n', 'other.tap': 'O300\nG0 X2.\nM98 P200\nM99\n',
               'second.nc': 'O7\nM98 P200\nM30\nO200\nM99\n'},
              ('main.nc', 2, 6), ('O0200.nc', 0, 1), [('main.nc', 2), ('other.tap', 2)]),
    'linuxcnc': ({'main.ngc': 'G21\no<pocket> call [1]\no1 while [0]\no1 endwhile\nM2\n', 'pocket.ngc': 'o<pocket> sub\nG0 X1\no<pocket> endsub\nM2\n',
                  'more.ngc': 'o<Pocket> call [2]\nM2\n', 'loop.ngc': 'o1 sub\no1 endsub\nM2\n'},
                 ('main.ngc', 1, 4), ('pocket.ngc', 0, 1), [('main.ngc', 1), ('more.ngc', 0), ('pocket.ngc', 2)]),
    'sinumerik': ({'MAIN.MPF': 'G90 G71\nPART(5)\nSTOPRE\nM30\n', 'PART.SPF': 'PROC PART(REAL WIDTH)\nG0 X=WIDTH\nM17\n', 'TWO.MPF': 'N10 MCALL PART\nCALL "PART"\nM30\n'},
                  ('MAIN.MPF', 1, 2), ('PART.SPF', 0, 5), [('MAIN.MPF', 1), ('TWO.MPF', 0), ('TWO.MPF', 1)]),
}


def check_programs_of_the_folder(kadr):
    for control, (files, (name, line, column), (where, first, start), uses) in FOLDERS.items():
        folder = kadr.file(f'{control}/{name}', '').parent
        for other, text in files.items():
            (folder / other).write_text(text)

        def uri(of, folder=folder):
            return f'file://{folder / of}'
        editor = Editor(kadr, {'control': control})
        editor.open(files[name], uri(name))

        def ask(method, of, line, column, **more):
            return editor.ask(f'textDocument/{method}', {'textDocument': {'uri': uri(of)}, 'position': position(line, column), **more})['result']
        found = ask('definition', name, line, column)
        expect([(one['uri'], one['range']['start']) for one in found] == [(uri(where), position(first, start))], f'{control}: {found}')
        uses_found = ask('references', name, line, column, context={'includeDeclaration': False})
        expect(sorted((one['uri'], one['range']['start']['line']) for one in uses_found) == sorted((uri(of), n) for of, n in uses), f'{control}: {uses_found}')
        whole = ask('references', name, line, column, context={'includeDeclaration': True})
        expect(len(whole) == len(uses) + 1, f'{control}: {whole}')
        # An open document stands in the place of its file.
        moved = '\n' + files[where]
        editor.open(moved, uri(where))
        found = ask('definition', name, line, column)
        expect([(one['uri'], one['range']['start']['line']) for one in found] == [(uri(where), first + 1)], f'{control}: {found}')
        back = ask('references', where, first + 1, start + 1, context={'includeDeclaration': False})
        moved_uses = [(uri(of), n + (of == where)) for of, n in uses]
        expect(sorted((one['uri'], one['range']['start']['line']) for one in back) == sorted(moved_uses), f'{control}: {back}')
        editor.tell('textDocument/didClose', {'textDocument': {'uri': uri(where)}})
        (folder / where).write_text('\n\n' + files[where])   # and a file that has changed is read again
        found = ask('definition', name, line, column)
        expect([one['range']['start']['line'] for one in found] == [first + 2], f'{control}: {found}')
        symbols = editor.ask('workspace/symbol', {'query': {'fanuc': '300', 'linuxcnc': 'POCKET', 'sinumerik': 'part'}[control]})['result']
        expect([one['location']['uri'] for one in symbols] == [uri({'fanuc': 'other.tap', 'linuxcnc': 'pocket.ngc', 'sinumerik': 'PART.SPF'}[control])], f'{symbols}')
        if control == 'linuxcnc':
            expect(ask('definition', name, 2, 1) == [], 'a loop is no subprogram of another file')
        if control == 'sinumerik':
            expect(ask('definition', name, 2, 2) == [] and ask('prepareRename', name, 1, 2) is None, 'a name of the control; a program is renamed with its file')
        editor.close()


def check_rename(kadr):
    editor = Editor(kadr, {'control': 'fanuc'})
    editor.open(FANUC)
    expect(editor.at('prepareRename', 9, 7) == {'range': area(9, 6, 9), 'placeholder': '101'}, f'{editor.at("prepareRename", 9, 7)}')
    edits = editor.at('rename', 9, 7, newName='#500')['changes'][URI]
    expect(applied(FANUC, edits) == FANUC.replace('#101', '#500'), 'a variable')
    edits = editor.at('rename', 9, 1, newName='35')['changes'][URI]
    expect(applied(FANUC, edits) == FANUC.replace('N30', 'N35').replace('GOTO 30', 'GOTO 35'), 'a block')
    for name in ('X', '', '20', '#<a>'):
        expect(editor.at('rename', 9, 1, newName=name).get('code') == FAILED, f'N30 becomes {name!r}')
    editor.close()


def check_outline(kadr):
    editor = Editor(kadr, {'control': 'fanuc'})
    editor.open(FANUC)
    editor.findings()
    symbols = editor.of('documentSymbol')
    expect([s['name'] for s in symbols] == ['O1 PLATE', 'O200'], f'{symbols}')
    expect([s['name'] for s in symbols[0]['children']] == ['T1 FACE MILL'], f'{symbols[0]["children"]}')
    expect([s['name'] for s in symbols[0]['children'][0]['children']] == ['G81'], f'{symbols[0]["children"][0]["children"]}')
    found = editor.ask('workspace/symbol', {'query': '200'})['result']
    expect([one['name'] for one in found] == ['O200'], f'{found}')
    folds = [(f['startLine'], f['endLine']) for f in editor.of('foldingRange')]
    expect((1, 14) in folds and (3, 14) in folds, f'{folds}')
    expect(any('min' in lens['command']['title'] for lens in editor.until(lambda: editor.of('codeLens'))), 'the time of an operation')
    hints = editor.of('inlayHint', range=area(0, 0, 0, 12))
    expect(any('X5' in hint['label'] for hint in hints if hint['position']['line'] == 9), f'{hints}')
    editor.close()


def check_folds_of_linuxcnc(kadr):
    editor = Editor(kadr, {'control': 'linuxcnc'})
    editor.open('o1 sub\no2 do\no3 if [#1]\nG0 X1\no3 endif\no2 while [0]\no1 endsub\nM2\n')
    folds = sorted((f['startLine'], f['endLine']) for f in editor.of('foldingRange'))
    expect({(0, 6), (1, 5), (2, 4)} <= set(folds), f'{folds}')
    editor.close()


def tokens_in(data, legend):
    """Returns the tokens of an answer: line, column, length, type, and a star for a definition."""
    line, column, tokens = 0, 0, []
    for i in range(0, len(data), 5):
        line, column = line + data[i], data[i + 1] + (0 if data[i] else column)
        tokens.append((line, column, data[i + 2], legend['tokenTypes'][data[i + 3]] + '*' * data[i + 4]))
    return tokens


def check_tokens(kadr):
    editor = Editor(kadr, {'control': 'fanuc'})
    editor.open('N10 G1 X1. (Ж) M8\n#101=#[#5+1]\nX#101Y[#5*2]F2\nIF[#101GT9]GOTO 10\nO20\nM98 P20\n')
    legend = editor.capabilities['semanticTokensProvider']['legend']
    expect(legend['tokenModifiers'] == ['definition'], f'{legend}')
    tokens = tokens_in(editor.of('semanticTokens/full')['data'], legend)
    expect([t[1:] for t in tokens if t[0] == 0] == [(0, 3, 'label*'), (4, 2, 'keyword'), (7, 3, 'number'), (11, 3, 'comment'), (15, 2, 'function')], f'{tokens}')
    wanted = {1: [(0, 4, 'variable*')], 2: [(0, 1, 'number'), (1, 4, 'variable'), (5, 2, 'number'), (7, 2, 'variable')],
              3: [(3, 4, 'variable'), (16, 2, 'label')], 4: [(0, 3, 'label*')], 5: [(0, 3, 'function'), (4, 1, 'number'), (5, 2, 'label')]}
    for line, some in wanted.items():
        expect(set(some) <= {t[1:] for t in tokens if t[0] == line}, f'line {line}: {tokens}')
    for a, b in zip(tokens, tokens[1:]):
        expect((a[0], a[1] + a[2]) <= (b[0], b[1]), f'tokens in order, without overlap: {a} {b}')
    some = tokens_in(editor.of('semanticTokens/range', range=area(2, 0, 0, 3))['data'], legend)
    expect(some == [t for t in tokens if t[0] in (2, 3)] and some, f'the tokens of a range: {some}')
    editor.close()


def check_control_of_a_program(kadr):
    """An editor that asks for it receives the control of a program, once, and again when it changes."""
    able = {**ABLE, 'experimental': {'kadrControl': True}}
    editor = Editor(kadr, able=able)
    editor.open(FANUC)
    editor.findings()
    told = editor.asked('kadr/control')['params']
    expect(told == {'uri': URI, 'control': 'fanuc', 'guessed': True}, f'{told}')
    editor.change('(A)\n', 2, area(3, 0, 0))
    editor.findings(2)
    editor.tell('workspace/didChangeConfiguration', {'settings': {'kadr': {'control': 'haas'}}})
    told = editor.asked('kadr/control')['params']
    expect(told == {'uri': URI, 'control': 'haas', 'guessed': False}, f'{told}')
    editor.close()
    editor = Editor(kadr)   # another editor is not
    editor.open(FANUC)
    editor.findings()
    expect(editor.of('semanticTokens/full') and not [note for note in editor.notes if note['method'] == 'kadr/control'], f'{editor.notes}')
    editor.close()


def check_folders_of_the_workspace(kadr):
    """Programs of other folders that the editor shows; those of the own folder come first."""
    top = Path(kadr.folder) / 'workspace'
    for name, text in (('parts/main.nc', 'O1\nM98 P200\nM98 P300\nM30\n'), ('parts/O0300.nc', 'O300\nM99\n'), ('common/O0200.nc', 'O200\nM98 P300\nM99\n'),
                       ('common/O0300.nc', 'O300\nM99\n'), ('.hidden/O0400.nc', 'O400\nM99\n')):
        path = top / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding='utf-8')
    main, text = f'file://{top}/parts/main.nc', (top / 'parts/main.nc').read_text(encoding='utf-8')

    def symbols(editor):
        return sorted({one['location']['uri'].removeprefix(f'file://{top}/') for one in editor.ask('workspace/symbol', {'query': 'O'})['result']})

    def defined(editor, line):
        answer = editor.ask('textDocument/definition', {'textDocument': {'uri': main}, 'position': position(line, 7)})['result']
        return [one['uri'].removeprefix(f'file://{top}/') for one in answer]
    for folders, wide in (([top], True), ([f'{top}/common/', top / 'parts'], True), (None, False)):
        editor = Editor(kadr, {'control': 'fanuc'}, folders=folders)
        editor.open(text, main)
        near = ['parts/O0300.nc', 'parts/main.nc']
        expect(symbols(editor) == (['common/O0200.nc', 'common/O0300.nc'] if wide else []) + near, f'{folders}: {symbols(editor)}')
        expect(defined(editor, 1) == (['common/O0200.nc'] if wide else []), f'{folders}: {defined(editor, 1)}')
        expect(defined(editor, 2) == ['parts/O0300.nc'], f'{folders}: {defined(editor, 2)}')
        uses = editor.ask('textDocument/references', {'textDocument': {'uri': main}, 'position': position(2, 7), 'context': {'includeDeclaration': False}})['result']
        expect([one['uri'] for one in uses] == [main], f'common/O0200.nc calls the program of its own folder: {uses}')
        if not wide:
            editor.tell('workspace/didChangeWorkspaceFolders', {'event': {'added': [folder(top)], 'removed': []}})
            expect(defined(editor, 1) == ['common/O0200.nc'], 'a folder that was added')
            editor.tell('workspace/didChangeWorkspaceFolders', {'event': {'added': [], 'removed': [folder(top)]}})
            expect(defined(editor, 1) == [], 'a folder that was removed')
        editor.close()


def check_quick_fix(kadr):
    editor = Editor(kadr, {'control': 'fanuc'})
    text = 'O1\nG21 G90\nG0 X1. Y1. (OPEN\nM30\n'
    editor.open(text)
    found = editor.findings()
    actions = editor.of('codeAction', range=found[0]['range'], context={'diagnostics': []})
    expect(actions and actions[0]['kind'] == 'quickfix', f'{found} {actions}')
    expect(applied(text, actions[0]['edit']['changes'][URI]) == text.replace('(OPEN', '(OPEN)'), f'{actions}')
    editor.close()


def check_actions_of_the_whole_program(kadr):
    editor = Editor(kadr, {'control': 'fanuc'})
    editor.open(FANUC)
    editor.findings()

    def titles(**context):
        return [action['title'] for action in editor.of('codeAction', range=area(2, 0, 0), context={'diagnostics': [], **context})]
    everything = titles()
    expect('Convert to mach3…' in everything and 'Convert to fanuc…' not in everything and everything[0].startswith('Number'), f'{everything}')
    expect(len(titles(only=['refactor.rewrite.renumber'])) == 1 and titles(only=['refactor']) == everything, 'kinds are a hierarchy')
    expect(titles(only=['quickfix']) == [] and titles(triggerKind=2) == [], 'not asked for')
    editor.close()
    for able, count in (({}, 0), ({'workspace': {'applyEdit': True}}, 1)):
        editor = Editor(kadr, {'control': 'fanuc'}, able=able)
        editor.open(FANUC)
        editor.findings()
        actions = editor.of('codeAction', range=area(2, 0, 0), context={'diagnostics': []})
        expect(len(actions) == count and all(isinstance(action['command'], str) for action in actions), f'{able}: {actions}')
        editor.close()


def check_renumber(kadr):
    text = 'O1\nG21 G90\nN7 G0 X1.\nIF[#1GT0]GOTO 7\nM30\n'
    for able in (None, {'workspace': {'applyEdit': True}}):
        editor = Editor(kadr, {'control': 'fanuc'}, able=able)
        editor.open(text, version=4)
        editor.findings(4)
        editor.put({'jsonrpc': '2.0', 'id': 900, 'method': 'workspace/executeCommand', 'params': {'command': 'kadr.renumber', 'arguments': [URI]}})
        asked = editor.asked('workspace/applyEdit')
        edit = asked['params']['edit']
        if able is None:
            expect(edit['documentChanges'][0]['textDocument'] == {'uri': URI, 'version': 4}, f'{edit}')
        edits = edit['documentChanges'][0]['edits'] if able is None else edit['changes'][URI]
        path = kadr.file('part.nc', text)
        wanted = kadr.call('edit', path, '--control', 'fanuc', '--renumber', '10').stdout
        expect(applied(text, edits) == wanted and 'GOTO 20' in wanted, applied(text, edits))
        expect(editor.answer(900)['result'] is None, 'the answer')
        editor.put({'jsonrpc': '2.0', 'id': asked['id'], 'result': {'applied': True}})
        expect('nothing else has changed' in editor.asked('window/showMessage')['params']['message'], 'the proof is told')
        editor.close()


def check_refused_commands(kadr):
    editor = Editor(kadr, {'control': 'fanuc'})
    editor.open('O1\nG21 G90 F100\nG0 X1.\nGOTO #1\nM30\n')
    editor.findings()

    def refusal(command, *arguments):
        return editor.ask('workspace/executeCommand', {'command': command, 'arguments': list(arguments)})['error']
    expect(refusal('kadr.renumber', URI)['code'] == FAILED, 'a computed number cannot be renumbered')
    expect(refusal('kadr.convert', URI, 'nonsense')['code'] == FAILED, 'no such control')
    for command, arguments in (('kadr.nothing', [URI]), ('kadr.renumber', []), ('kadr.renumber', [5]), ('kadr.convert', [URI]), ('kadr.renumber', ['file:///x'])):
        expect(refusal(command, *arguments)['code'] == WRONG_PARAMS, f'{command} {arguments}')
    editor.close()
    editor = Editor(kadr, {'control': 'fanuc'}, able={'workspace': {'applyEdit': True}})
    editor.open(FANUC)
    expect(refusal('kadr.convert', URI, 'mach3')['code'] == FAILED, 'an editor that creates no files')
    editor.close()


def check_convert(kadr):
    text = '%\nO0001\nG90 G54 G17 G21\nT1 M6\nG0 X0 Y0 S1200 M3\nG43 Z50. H1\nG1 Z-1. F200\nX10.\nM30\n%\n'
    path = kadr.file('part.nc', text.replace('\n', '\r\n'))
    uri, wanted = f'file://{path}', f'file://{path}'.replace('.nc', '-linuxcnc.nc')
    editor = Editor(kadr, {'control': 'fanuc'})
    editor.open(text.replace('\n', '\r\n'), uri)
    for name in ('', '-2'):   # an existing file is not overwritten
        convert = {'jsonrpc': '2.0', 'id': 900, 'method': 'workspace/executeCommand', 'params': {'command': 'kadr.convert', 'arguments': [uri, 'linuxcnc']}}
        editor.put(convert)
        asked = editor.asked('workspace/applyEdit')
        create, change = asked['params']['edit']['documentChanges']
        new = wanted.replace('.nc', f'{name}.nc')
        expect(create == {'kind': 'create', 'uri': new} and change['textDocument'] == {'uri': new, 'version': None}, f'{create}')
        converted = kadr.call('convert', path, '--from', 'fanuc', '--to', 'linuxcnc')
        expect(change['edits'] == [{'range': area(0, 0, 0), 'newText': converted.stdout}] and converted.stdout, f'{change}')
        expect(editor.answer(900)['result'] is None, 'the answer')
        editor.put({'jsonrpc': '2.0', 'id': asked['id'], 'result': {'applied': True}})
        shown = editor.asked('window/showDocument')
        expect(shown['params']['uri'] == new, f'{shown}')
        editor.put({'jsonrpc': '2.0', 'id': shown['id'], 'result': {'success': True}})
        expect('equal' in editor.asked('window/showMessage')['params']['message'], 'the proof is told')
        kadr.file('part-linuxcnc.nc', '')
    editor.put(convert)
    asked = editor.asked('workspace/applyEdit')
    expect('result' in editor.answer(900), 'the answer')
    editor.put({'jsonrpc': '2.0', 'id': asked['id'], 'result': {'applied': False, 'failureReason': 'no room'}})
    expect('no room' in editor.asked('window/showMessage')['params']['message'], 'a refusal of the editor is told')
    editor.close()


def check_cancelled_commands(kadr):
    editor = Editor(kadr, {'control': 'fanuc'})
    editor.open(FANUC)
    for number in range(1000, 1010):
        editor.put({'jsonrpc': '2.0', 'id': number, 'method': 'workspace/executeCommand', 'params': {'command': 'kadr.renumber', 'arguments': [URI]}})
    for number in range(1000, 1010):
        editor.tell('$/cancelRequest', {'id': number})
    seen = {}
    while len(seen) < 10:
        message = editor.get()
        if 'method' not in message:
            expect(message['id'] not in seen, f'a second answer: {message}')
            seen[message['id']] = message
    expect(all('result' in m or m['error']['code'] == CANCELLED for m in seen.values()), f'{seen}')
    expect(editor.close() == 0, 'the end')


def check_simple_editors(kadr):
    """What an editor has not stated it is not sent: nested symbols, Markdown, code actions."""
    editor = Editor(kadr, {'control': 'fanuc'}, able={})
    editor.open(FANUC)
    editor.findings()
    symbols = editor.of('documentSymbol')
    expect([s['name'] for s in symbols] == ['O1 PLATE', 'T1 FACE MILL', 'G81', 'O200'] and symbols[1]['containerName'] == 'O1 PLATE' and 'location' in symbols[0], f'{symbols}')
    contents = editor.at('hover', 11, 1)['contents']
    expect(contents['kind'] == 'plaintext' and '`' not in contents['value'], f'{contents}')
    editor.change(FANUC.replace('(FACE MILL)', '(FACE MILL'), 2)
    expect(editor.findings(2) and editor.of('codeAction', range=area(3, 0, 9), context={'diagnostics': []}) == [], 'no quick fix')
    editor.close()


def check_formatting(kadr):
    text = 'N10G1X1.Y2.(A  B)M8\n#1=2+3\nN20   G0 Z5.\n/G1X2.F1\nX1.0 Y2\n'
    wanted = 'N10 G1 X1. Y2. (A  B) M8\n#1=2+3\nN20 G0 Z5.\n/G1 X2. F1\nX1.0 Y2\n'
    editor = Editor(kadr, {'control': 'fanuc'})
    editor.open(text)
    edits = editor.of('formatting', options={'tabSize': 4, 'insertSpaces': True})
    expect(applied(text, edits) == wanted, applied(text, edits))
    editor.close()


def check_columns_of_editors(kadr):
    text = 'G21 F100 (\U0001F529Ж) Q1\nM2\n'   # the sign has one, two or four units
    for encoding, column in (('utf-16', 16), ('utf-8', 19), ('utf-32', 15)):
        editor = Editor(kadr, {'control': 'linuxcnc'}, encodings=(encoding,))
        expect(editor.capabilities['positionEncoding'] == encoding, encoding)
        editor.open(text)
        found = [d for d in editor.findings() if d['range']['start']['line'] == 0]
        expect(found and found[0]['range']['start']['character'] == column - 1, f'{encoding}: {found}')
        editor.close()


# ---- all programs, random changes, random messages

def check_examples(kadr):
    editor = Editor(kadr)
    for path in sorted(path for path in (harness.ROOT / 'examples').rglob('*') if path.suffix in ('.nc', '.ngc', '.tap', '.nct')):
        try:
            text = path.read_text(encoding='utf-8')
        except UnicodeDecodeError:
            continue
        uri = f'file://{path}'
        editor.open(text, uri)
        editor.findings(uri=uri)
        for method in ('documentSymbol', 'foldingRange', 'semanticTokens/full', 'codeLens', 'formatting'):
            answer = editor.ask(f'textDocument/{method}', {'textDocument': {'uri': uri}, 'options': {}})
            expect('result' in answer, f'{path.name}: {method}: {answer}')
        editor.tell('textDocument/didClose', {'textDocument': {'uri': uri}})
        editor.notes.clear()
    expect(editor.close() == 0, 'the end')


def check_random_changes(kadr):
    """After random changes the findings, names and colours are those of a document that is opened with the same text."""
    draw = random.Random(20261129)
    pieces = ['G1 X1.', '\n', '\r\n', 'N10 ', '#101=', '(Ж', ')', 'GOTO 10', 'M98 P5', 'O5', '\U0001F529', ' ', 'T1 M6', 'IF[#1EQ2]']
    for control in ('fanuc', 'linuxcnc', 's2c42', 'sinumerik'):
        editor = Editor(kadr, {'control': control})
        editor.open('G21\n')
        for version in range(2, 14):
            a, b = sorted((draw.randrange(8), draw.randrange(12)) for _ in range(2))
            text = ''.join(draw.choice(pieces) for _ in range(draw.randrange(6)))
            editor.change(text, version, {'start': position(*a), 'end': position(*b)})
        whole = editor.at('rename', 0, 0, newName='x')   # any request: the changes are done in their order
        expect(whole is not None, 'an answer')
        edited = [editor.of('semanticTokens/full'), editor.of('documentSymbol'), [d['message'] for d in editor.findings(13)]]
        editor.close()
        again = Editor(kadr, {'control': control})
        again.open(replayed(control), version=13)
        opened = [again.of('semanticTokens/full'), again.of('documentSymbol'), [d['message'] for d in again.findings(13)]]
        again.close()
        expect(edited == opened, f'{control}: {edited} {opened}')


def replayed(control):
    """Applies the changes of check_random_changes to a text, with Python's own strings."""
    draw = random.Random(20261129)
    pieces = ['G1 X1.', '\n', '\r\n', 'N10 ', '#101=', '(Ж', ')', 'GOTO 10', 'M98 P5', 'O5', '\U0001F529', ' ', 'T1 M6', 'IF[#1EQ2]']
    for of in ('fanuc', 'linuxcnc', 's2c42', 'sinumerik'):
        text = 'G21\n'
        for _ in range(2, 14):
            a, b = sorted((draw.randrange(8), draw.randrange(12)) for _ in range(2))
            new = ''.join(draw.choice(pieces) for _ in range(draw.randrange(6)))
            begin, end = offset(text, a), offset(text, b)
            text = text[:begin] + new + text[max(begin, end):]
        if of == control:
            return text


def offset(text, at):
    """Returns the offset of a position whose columns are units of UTF-16."""
    begin, line = 0, 0
    while line < at[0]:
        ends = [i for i in (text.find('\n', begin), text.find('\r', begin)) if i >= 0]
        if not ends:
            return len(text)
        end = min(ends)
        begin = end + (2 if text.startswith('\r\n', end) else 1)
        line += 1
    units, here = 0, begin
    while here < len(text) and text[here] not in '\r\n':
        units += 2 if ord(text[here]) > 0xFFFF else 1
        if units > at[1]:
            break
        here += 1
    return here


def random_message(draw, number):
    """Returns a message of an editor, right or wrong: a request, a notification, or an answer to nobody."""
    uri = draw.choice(['file:///work/a.nc', 'file:///work/b.nc', 'untitled:c'])
    place = {'line': draw.choice([0, 1, 5, 10 ** 9, -1, 'x']), 'character': draw.choice([0, 3, 10 ** 9, None])}
    params = {'textDocument': {'uri': uri}, 'position': place, 'range': {'start': place, 'end': draw.choice([place, 5])},
              'newName': draw.choice(['5', '', 7]), 'query': draw.choice(['', 'O', 5]), 'context': draw.choice([{}, {'only': ['refactor']}, 7]),
              'command': draw.choice(['kadr.renumber', 'kadr.convert', 'x', 5]), 'arguments': draw.choice([[uri], [uri, 'mach3'], [5], {}])}
    kind = draw.randrange(10)
    if kind == 0:
        text = draw.choice([FANUC, '', 'G0 X1\n' * 50, 'o1 while [1]\n' * 40])
        method, params = 'textDocument/didOpen', {'textDocument': {'uri': uri, 'languageId': 'nc', 'version': number, 'text': text}}
    elif kind == 1:
        change = {'text': draw.choice(['G1', '\n', 7]), 'range': area(draw.randrange(9), 0, 3)}
        method, params = 'textDocument/didChange', {'textDocument': {'uri': uri, 'version': number}, 'contentChanges': [change]}
    elif kind == 2:
        method = draw.choice(['textDocument/didSave', 'textDocument/didClose', 'workspace/didChangeConfiguration', 'workspace/didChangeWatchedFiles',
                              'workspace/didChangeWorkspaceFolders', 'nothing'])
        params['event'] = draw.choice([{'added': [{'uri': 'file:///nowhere'}], 'removed': [{'uri': 'untitled:c'}]}, {'added': [5], 'removed': 5}, 5])
        params['settings'] = {'kadr': {'control': draw.choice(['fanuc', '', 'nonsense'])}}
    elif kind == 3:
        if draw.randrange(2):
            return {'jsonrpc': '2.0', 'id': draw.choice([f'kadr-{draw.randrange(40)}', 5, 'x']), 'result': draw.choice([{'applied': False}, None])}
        method, params = '$/cancelRequest', {'id': draw.choice([number - 1, number - draw.randrange(20), 'x'])}
    else:
        method = draw.choice([*(name for name in lsp_shapes.RESULTS if name != 'shutdown'), 'textDocument/unknown'])
        return {'jsonrpc': '2.0', 'id': number, 'method': method, 'params': draw.choice([params, params, params, None, [], 5])}
    return {'jsonrpc': '2.0', 'method': method, 'params': params}


def expect_little_memory(process):
    """A program with a sanitizer, which reserves terabytes, is not judged."""
    rows = (Path('/proc') / str(process) / 'status').read_text(encoding='utf-8').splitlines()
    reserved, used = (next(int(row.split()[1]) / 1024 for row in rows if row.startswith(name)) for name in ('VmPeak', 'VmHWM'))
    expect(used < 300 or reserved > 2 ** 20, f'memory of the server: {used:.0f} MB')


def check_random_messages(kadr):
    draw = random.Random(7)
    editor = Editor(kadr)
    waiting = {}

    def take(message):
        expect(message is not None, 'the server has ended')
        if 'method' not in message:
            expect(waiting.pop(message['id'], None), f'a second answer, or one to nobody: {message}')
            editor.methods.pop(message['id'])
    most_waiting = 300
    for number in range(FIRST, FIRST + MESSAGES):
        message = random_message(draw, number)
        if 'id' in message and 'method' in message:
            waiting[number] = message['method']
        editor.put(message)
        while len(waiting) > most_waiting or select.select([editor.process.stdout], [], [], 0)[0]:
            take(editor.get())
    while waiting:
        take(editor.get())
    expect(editor.ask('workspace/symbol', {'query': ''})['result'] is not None, 'the server lives')
    expect_little_memory(editor.process.pid)
    expect(editor.close() == 0, 'the end')


def check_the_table_of_shapes(kadr):
    """The check of the shapes finds faults; and each method that the server answers has a shape."""
    for message, wrong in (({'id': 1, 'result': {'contents': {'kind': 'markdown', 'value': ''}}}, False), ({'id': 1, 'result': None}, False),
                           ({'id': 1, 'result': {'contents': {'kind': 'html', 'value': ''}}}, True), ({'id': 1, 'result': {'contents': 5}}, True),
                           ({'id': 1, 'result': {'contents': {'kind': 'markdown', 'value': '', 'more': 1}}}, True), ({'id': 1}, True),
                           ({'method': 'window/showMessage', 'params': {'type': 3, 'message': 'x'}}, False),
                           ({'method': 'window/showMessage', 'params': {'type': 9, 'message': 'x'}}, True), ({'method': 'unknown', 'params': {}}, True)):
        fault = lsp_shapes.fault_of_message({'jsonrpc': '2.0', **message}, {1: 'textDocument/hover'})
        expect(bool(fault) == wrong, f'{message}: {fault}')
    editor = Editor(kadr)
    for method in lsp_shapes.RESULTS:
        if method not in ('initialize', 'shutdown'):
            expect(editor.ask(method, 5)['error']['code'] == WRONG_PARAMS, f'{method} with wrong parameters')
    editor.close()


if __name__ == '__main__':
    sys.exit(harness.main(__doc__, globals()))
