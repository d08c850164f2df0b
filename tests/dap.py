#!/usr/bin/env python3
"""Tests `kadr dap` (docs/lsp.md) as the debugger of an editor uses it: the messages of the Debug Adapter Protocol over standard input and
output.

    dap.py --kadr build/release/kadr
    KADR_DAP_MESSAGES=1000000 dap.py --kadr build/release/kadr --only 'random-requests'

Checked are breakpoints of every kind, steps into, over and out of calls, steps back, values, lines of the operator, pause, alarms, and that
each request gets one response, also a wrong one.
"""
import json
import os
import random
import select
import subprocess
import sys
import time
from pathlib import Path

import harness
from harness import expect

MESSAGES = int(os.environ.get('KADR_DAP_MESSAGES', 600))
PROGRAM = '''O0001
G21 G90 G54
#101=0
N10 #101=#101+1
G1 X#101 F100
M98 P0200
IF[#101LT5]GOTO 10
G0 Z50.
M30
O0200
G91
#102=#101*2
G90
M99
'''


class Client:
    """The debugger of an editor, with one program."""

    def __init__(self, kadr):
        self.process = subprocess.Popen(kadr.command(['dap']), cwd=kadr.folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.read, self.last, self.events = b'', 0, []
        self.path = None

    def put(self, message):
        data = json.dumps(message).encode()
        self.process.stdin.write(b'Content-Length: %d\r\n\r\n%s' % (len(data), data))
        self.process.stdin.flush()

    def get(self):
        until = time.monotonic() + harness.TIME_LIMIT_S
        while True:
            head = self.read.find(b'\r\n\r\n')
            if head >= 0:
                end = head + 4 + int(self.read[:head].split(b':')[1])
                if len(self.read) >= end:
                    content, self.read = self.read[head + 4:end], self.read[end:]
                    return json.loads(content)
            ready, _, _ = select.select([self.process.stdout], [], [], max(0, until - time.monotonic()))
            expect(ready, f'no message within the time limit; events {self.events[-3:]}')
            more = os.read(self.process.stdout.fileno(), 65536)
            expect(more, 'the adapter has ended')
            self.read += more

    def request(self, command, arguments=None):
        self.last += 1
        self.put({'seq': self.last, 'type': 'request', 'command': command, **({} if arguments is None else {'arguments': arguments})})
        return self.last

    def ask(self, command, **arguments):
        """Sends a request.  returns its response; events before it are kept"""
        number = self.request(command, arguments)
        while True:
            message = self.get()
            if message['type'] == 'response':
                expect(message['request_seq'] == number and message['command'] == command, f'{message}')
                return message
            self.events.append(message)

    def body(self, command, **arguments):
        answer = self.ask(command, **arguments)
        expect(answer['success'], f'{command} {arguments}: {answer}')
        return answer.get('body', {})

    def wait(self, *names):
        """Waits for one of these events.  returns it; the events before it are dropped"""
        while True:
            while self.events:
                event = self.events.pop(0)
                if event['event'] in names:
                    return event
            self.events.append(self.get())

    def begin(self, kadr, text=PROGRAM, control='fanuc', **more):
        self.path = str(kadr.file('part.nc', text))
        self.body('initialize', adapterID='kadr', linesStartAt1=True)
        self.body('launch', program=self.path, control=control, **more)
        self.wait('initialized')
        return self

    def points(self, *points, path=None):
        return self.body('setBreakpoints', source={'path': path or self.path}, breakpoints=[p if isinstance(p, dict) else {'line': p} for p in points])['breakpoints']

    def start(self):
        self.body('configurationDone')
        return self.stop()

    def stop(self):
        """Waits until the program is held or over.  returns the reason and the line"""
        event = self.wait('stopped', 'terminated')
        if event['event'] == 'terminated':
            return 'terminated', 0
        return event['body']['reason'], self.line()

    def line(self):
        return self.body('stackTrace', threadId=1)['stackFrames'][0]['line']

    def go(self, command='continue', **more):
        self.body(command, threadId=1, **more)
        return self.stop()

    def value(self, expression):
        return self.body('evaluate', expression=expression, context='watch')['result']

    def end(self):
        self.body('disconnect')
        return self.process.wait(harness.TIME_LIMIT_S)


def check_entry_and_end(kadr):
    client = Client(kadr).begin(kadr)
    reason, line = client.start()
    expect(reason == 'entry' and line in (1, 2), f'{reason} {line}')
    expect(client.body('threads')['threads'][0]['id'] == 1, 'one thread')
    expect(client.go() == ('terminated', 0), 'the end')
    expect(client.end() == 0, 'exit status')


def check_terminate(kadr):
    client = Client(kadr).begin(kadr, 'G21 F100\no1 while [1]\nG1 X[#1]\n#1=[#1+1]\no1 endwhile\nM2\n', 'linuxcnc')
    client.start()
    client.body('continue', threadId=1)
    client.body('terminate')
    client.wait('terminated')
    for command in ('continue', 'stepBack', 'configurationDone'):
        expect(not client.ask(command, threadId=1)['success'], f'{command} after the end')
    expect(client.end() == 0, 'exit status')


def check_breakpoints(kadr):
    client = Client(kadr).begin(kadr)
    expect(all(p['verified'] for p in client.points(5, {'line': 8, 'condition': '#101 GT 4'}, {'line': 12, 'hitCondition': '3'})), 'verified')
    client.start()
    seen = []
    while (stop := client.go())[0] != 'terminated':
        seen.append((stop[0], stop[1], client.value('#101')))
    wanted = [('breakpoint', 5, '1'), ('breakpoint', 5, '2'), ('breakpoint', 5, '3'), ('breakpoint', 12, '3'), ('breakpoint', 5, '4'), ('breakpoint', 5, '5'),
              ('breakpoint', 8, '5')]
    expect(seen == wanted, f'{seen}')
    client.end()


def check_refused_breakpoints(kadr):
    client = Client(kadr).begin(kadr)
    points = client.points({'line': 5, 'condition': '#101 GT'}, {'line': 5, 'hitCondition': 'x'}, 6)
    expect([p['verified'] for p in points] == [False, False, True] and points[0]['message'], f'{points}')
    expect(not client.ask('setBreakpoints', source={'path': client.path}, breakpoints=[{'line': -3}])['success'], 'a line that cannot be')
    client.end()


def check_log_points(kadr):
    client = Client(kadr).begin(kadr)
    client.points({'line': 5, 'logMessage': 'pass {#101} of {#101*2}'})
    client.start()
    client.body('continue', threadId=1)
    texts = []
    while (event := client.wait('output', 'terminated'))['event'] == 'output':
        texts.append(event['body']['output'])
    expect([t for t in texts if t.startswith('pass')] == [f'pass {n} of {2 * n}\n' for n in range(1, 6)], f'{texts}')
    client.end()


def check_steps(kadr):
    client = Client(kadr).begin(kadr)
    client.points(6)
    client.start()
    expect(client.go()[1] == 6, 'the call')
    expect(client.go('stepIn')[1] in (10, 11), 'into the subprogram')
    frames = client.body('stackTrace', threadId=1)['stackFrames']
    expect(len(frames) == 2 and frames[1]['line'] == 6 and frames[0]['source']['path'] == client.path, f'{frames}')
    part = client.body('stackTrace', threadId=1, startFrame=1, levels=5)
    expect(part['stackFrames'] == frames[1:] and part['totalFrames'] == 2, f'a part of the stack: {part}')
    expect(client.go('stepOut')[1] == 7, 'out of it')
    client.points()
    expect(client.go('next')[1] == 4, 'the jump')
    client.go('next'), client.go('next')
    expect(client.line() == 6 and client.go('next')[1] == 7, 'over the call')
    client.end()


def check_steps_back(kadr):
    client = Client(kadr).begin(kadr)
    client.start()
    lines = [client.line()]
    while (stop := client.go('stepIn'))[0] != 'terminated':
        lines.append(stop[1])
    back = []
    for _ in lines:
        back.append(client.go('stepBack')[1])
    expect(back == lines[::-1], f'{back} {lines[::-1]}')
    expect(client.value('#101') in ('empty', '0'), 'the variable of the beginning')
    expect(client.go('stepIn')[1] == lines[1], 'forward again')
    expect(client.go('restart') == ('entry', lines[0]), 'from the beginning')
    client.end()


def check_steps_back_in_a_long_run(kadr):
    """The history has snapshots at a distance; each block before the present one can be reached."""
    text = 'G21\no1 repeat [20000]\n#1=[#1+1]\no1 endrepeat\nM2\n'
    client = Client(kadr).begin(kadr, text, 'linuxcnc')
    client.points(5)
    client.start()
    expect(client.go()[1] == 5, 'the end of the loop')
    for wanted in range(20000, 19990, -1):
        while client.go('stepBack')[1] != 3:
            pass
        expect(client.value('#1') == str(wanted - 1), f'{client.value("#1")} {wanted}')
    client.end()


def check_values(kadr):
    client = Client(kadr).begin(kadr)
    client.points(8)
    client.start()
    client.go()
    scopes = {s['name']: s['variablesReference'] for s in client.body('scopes', frameId=0)['scopes']}
    expect(list(scopes) == ['Positions, mm', 'In force', 'Variables', 'Local variables'], f'no local variable has a value yet: {scopes}')
    values = {name: {v['name']: v['value'] for v in client.body('variables', variablesReference=reference)['variables']} for name, reference in scopes.items()}
    expect(values['Positions, mm']['X'] == '5', f'{values}')
    expect('G90' in values['In force'].values() and values['In force']['F'] == '100', f'{values}')
    expect(values['Variables']['#101'] == '5' and values['Variables']['#102'] == '10', f'{values}')
    expect(client.body('setVariable', variablesReference=scopes['Variables'], name='#101', value='42')['value'] == '42' and client.value('#101') == '42', 'set')
    expect(not client.ask('setVariable', variablesReference=scopes['Variables'], name='#101', value='[')['success'], 'a wrong value')
    expect(not client.ask('setVariable', variablesReference=scopes['In force'], name='F', value='1')['success'], 'a mode is not set')
    expect(not client.ask('evaluate', expression='G0 X1', context='watch')['success'], 'a line is no expression')
    client.body('evaluate', expression='G0 X77.', context='repl')
    position = {v['name']: v['value'] for v in client.body('variables', variablesReference=scopes['Positions, mm'])['variables']}
    expect(position['X'] == '77' and client.line() == 8, f'a line of the operator: {position}')
    expect(not client.ask('evaluate', expression='G2 R', context='repl')['success'], 'a wrong line')
    client.end()


def check_watched_value(kadr):
    client = Client(kadr).begin(kadr)
    client.points(5)
    client.start()
    client.go()
    client.points()
    info = client.body('dataBreakpointInfo', name='#102')
    expect(info['dataId'] == '#102' or info['dataId'] is None, f'{info}')
    info = client.body('dataBreakpointInfo', name='#101')
    expect(client.body('setDataBreakpoints', breakpoints=[{'dataId': info['dataId']}])['breakpoints'][0]['verified'], 'verified')
    expect([client.go() + (client.value('#101'),) for _ in range(3)] == [('data breakpoint', 5, str(n)) for n in (2, 3, 4)], 'each change')
    client.end()


def check_breakpoint_on_a_call(kadr):
    client = Client(kadr).begin(kadr, 'o100 sub\nG0 X1\no100 endsub\no100 call\no100 call\nM2\n', 'linuxcnc')
    client.body('setFunctionBreakpoints', breakpoints=[{'name': 'O100'}])
    client.start()
    expect([client.go()[:2] for _ in range(2)] == [('breakpoint', 2)] * 2, 'both calls')
    client.end()


def check_alarm(kadr):
    client = Client(kadr).begin(kadr, 'G21 G90\nG1 X1 F100\nG2 X9 I1 J0\nM2\n', 'linuxcnc')
    client.start()
    client.body('continue', threadId=1)
    event = client.wait('stopped')
    expect(event['body']['reason'] == 'exception' and event['body']['text'], f'{event}')
    expect(client.go('stepBack')[0] == 'step', 'back from an alarm')
    client.end()


def check_pause(kadr):
    client = Client(kadr).begin(kadr, 'G21 F100\no1 while [1]\nG1 X[#1]\n#1=[#1+1]\no1 endwhile\nM2\n', 'linuxcnc')
    client.start()
    client.body('continue', threadId=1)
    client.body('pause', threadId=1)
    reason, line = client.stop()
    expect(reason == 'pause' and line in (2, 3, 4, 5), f'{reason} {line}')
    client.body('continue', threadId=1)
    expect(client.end() == 0, 'the end of a program that runs')


def check_pause_without_motions(kadr):
    """A loop that computes is held between two blocks; messages that are executed meanwhile do not end its step."""
    text = 'G21 F100\no1 while [1]\n#1=[#1+1]\n#1=[#1-1]\no1 endwhile\nM2\n'
    client = Client(kadr).begin(kadr, text, 'linuxcnc')
    client.start()
    for command in ('continue', 'next', 'stepOut'):
        client.body(command, threadId=1)
        if command == 'next':
            expect(client.stop()[0] == 'step', 'a step')
            continue
        expect(client.body('evaluate', expression='1+1', context='watch')['result'] == '2', 'the adapter answers while the program runs')
        client.body('pause', threadId=1)
        expect(client.stop()[0] == 'pause', 'the pause')
    client.end()


def check_step_over_a_long_call(kadr):
    """Requests during a step over a call do not end it elsewhere."""
    text = 'o1 sub\no2 repeat [60000]\n#<_n>=[#<_n>+1]\no2 endrepeat\no1 endsub\nG21\no1 call\nG4 P0\nM2\n'
    client = Client(kadr).begin(kadr, text, 'linuxcnc')
    client.points(7)
    client.start()
    expect(client.go()[1] == 7, 'the call')
    client.body('next', threadId=1)
    for _ in range(20):
        client.ask('threads')
    expect(client.stop() == ('step', 8) and client.value('#<_n>') == '60000', 'after the whole call')
    client.end()


def check_reverse(kadr):
    client = Client(kadr).begin(kadr)
    client.points(5, {'line': 12, 'condition': '#102 EQ 4'}, {'line': 4, 'logMessage': 'no stop'})
    client.start()
    forward = []
    while (stop := client.go())[0] != 'terminated':
        forward.append((stop[0], stop[1], client.value('#101')))
    backward = []
    while (stop := client.go('reverseContinue'))[0] != 'entry':
        backward.append((stop[0], stop[1], client.value('#101')))
    expect(len(forward) == 6 and backward == forward[::-1], f'{forward} {backward}')
    client.end()
    client = Client(kadr).begin(kadr)
    client.start()
    client.points(8)
    client.go()
    client.points()
    expect(client.body('setDataBreakpoints', breakpoints=[{'dataId': '#102'}])['breakpoints'][0]['verified'], 'verified')
    expect([client.go('reverseContinue')[:2] + (client.value('#102'),) for _ in range(2)] == [('data breakpoint', 12, '8'), ('data breakpoint', 12, '6')], 'changes')
    client.end()


def check_reverse_in_a_long_run(kadr):
    text = 'G21\no1 repeat [30000]\n#1=[#1+1]\no1 endrepeat\nG4 P0\nM2\n'
    client = Client(kadr).begin(kadr, text, 'linuxcnc')
    client.points(5, {'line': 3, 'condition': '#1 == 1234'}, {'line': 3, 'hitCondition': '22000'})
    client.start()
    expect([client.go()[1] for _ in range(3)] == [3, 3, 5], 'forward')
    back = [client.go('reverseContinue') + (client.value('#1'),) for _ in range(3)]
    expect(back == [('breakpoint', 3, '21999'), ('breakpoint', 3, '1234'), ('entry', 1, '0')], f'{back}')
    client.points(5)
    client.go()
    client.points({'line': 1, 'condition': '#1 == 77'})   # nowhere: the whole run is searched
    client.body('reverseContinue')
    client.body('pause')
    client.wait('stopped')
    value = int(client.value('#1'))
    expect(0 <= value <= 30000 and client.go('stepIn')[0] == 'step', f'held in the middle of the way back: {value}')
    client.end()


LOCALS = {
    'linuxcnc': ('o1 sub\n#<a>=[#1*2]\no2 call [#<a>]\no1 endsub\no2 sub\n#2=[#1+1]\nG4 P0\no2 endsub\n#<a>=7\n#1=3\no1 call [5]\nM2\n', 7,
                 [{'#1': '10', '#2': '11'}, {'#1': '5', '#<a>': '10'}, {'#1': '3', '#<a>': '7'}], '#1+1', ['11', '6', '4']),
    'fanuc': ('O1\nG21 G90\n#1=3\n#101=1\nG65 P2 A5.\nM30\nO2\n#2=#1*2\nG65 P3 B#2\nM99\nO3\nG4 P0\nM99\n', 12,
              [{'#2': '10'}, {'#1': '5', '#2': '10'}, {'#1': '3'}], '#1+#101', ['1', '6', '4']),
    'sinumerik': ('%_N_MAIN_MPF\nDEF REAL WIDTH=3\nG90 G71\nPART(5)\nM30\n%_N_PART_SPF\nPROC PART(REAL WIDTH)\nDEF INT COUNT=2\nG4 F0.1\nM17\n', 9,
                  [{'WIDTH': '5', 'COUNT': '2'}, {'WIDTH': '3'}], None, None),
}


def check_local_variables_of_each_frame(kadr):
    for control, (text, line, wanted, expression, values) in LOCALS.items():
        client = Client(kadr).begin(kadr, text, control)
        client.points(line)
        client.start()
        expect(client.go() == ('breakpoint', line), f'{control}: the innermost call')
        frames = client.body('stackTrace', threadId=1)['stackFrames']
        found = []
        for frame in frames:
            scopes = {s['name']: s['variablesReference'] for s in client.body('scopes', frameId=frame['id'])['scopes']}
            found.append({v['name']: v['value'] for v in client.body('variables', variablesReference=scopes['Local variables'])['variables']})
            expect((list(scopes)[0] == 'Local variables') == bool(found[-1]), f'editors open the first scope: {scopes} {found[-1]}')
        expect(found == wanted, f'{control}: {found}')
        if expression:
            got = [client.body('evaluate', expression=expression, frameId=frame['id'], context='watch')['result'] for frame in frames]
            expect(got == values, f'{control}: {got}')
            expect(not client.ask('evaluate', expression='#[1]', frameId=1, context='watch')['success'], 'a computed number')
        for frame in (99, -1, 'x'):
            expect(not client.ask('scopes', frameId=frame)['success'], f'frame {frame}')
        expect(not client.ask('variables', variablesReference=77)['success'], 'no such reference')
        client.end()


def check_without_stop_on_entry(kadr):
    client = Client(kadr).begin(kadr, stopOnEntry=False)
    client.points(8)
    expect(client.start() == ('breakpoint', 8), 'the first breakpoint')
    client.end()


def check_wrong_requests(kadr):
    client = Client(kadr)
    for command, arguments in (('stackTrace', {}), ('continue', {}), ('setBreakpoints', {'source': {'path': 'x'}, 'breakpoints': [{'line': 1}]}), ('launch', {}),
                               ('launch', {'program': 'missing.nc'}), ('unknown', {}), ('variables', {'variablesReference': 1}), ('evaluate', {'expression': 5})):
        answer = client.ask(command, **arguments)
        expect(not answer['success'] and answer['message'], f'{command}: {answer}')
    client.put(['no', 'message'])
    client.put({'type': 'request', 'command': 'threads'})
    expect(client.ask('threads')['success'], 'the adapter lives')
    expect(client.end() == 0, 'exit status')
    client = Client(kadr).begin(kadr)
    client.start()
    client.process.stdin.close()
    expect(client.process.wait(harness.TIME_LIMIT_S) == 1, 'the end of the input')


def check_line_that_never_ends(kadr):
    """An entered line that calls an endless program is given up; the program goes on."""
    client = Client(kadr).begin(kadr, 'G21 F100\nM2\no1 sub\no2 while [1]\nG1 X[#1]\n#1=[#1+1]\no2 endwhile\no1 endsub\n', 'linuxcnc')
    client.start()
    answer = client.ask('evaluate', expression='o1 call', context='repl')
    expect(not answer['success'] and answer['message'], f'{answer}')
    expect(client.go('stepIn') == ('step', 2), 'the next block')
    client.end()


def random_arguments(draw, path):
    return {'threadId': 1, 'expression': draw.choice(['#101', 'G0 X1', '[', 5, 'M98 P200']), 'context': draw.choice(['repl', 'watch']),
            'name': draw.choice(['#101', 'F', 7]), 'value': draw.choice(['1', '[']), 'frameId': draw.choice([0, 0, 1, 9, 'x']),
            'variablesReference': draw.choice([1, 2, 3, 100, 101, -1, 'x']), 'source': {'path': draw.choice([path, '/x', 4])},
            'program': draw.choice([path, 5]), 'breakpoints': draw.choice([[], [{'line': 5}], [{'line': 'x'}], [{'name': 'O200', 'dataId': '#101'}], 5])}


def check_random_requests(kadr):
    """Each request gets one response, in any order, from programs that end and from those that do not."""
    draw = random.Random(3)
    commands = ['stackTrace', 'scopes', 'variables', 'evaluate', 'setVariable', 'continue', 'next', 'stepIn', 'stepOut', 'stepBack', 'reverseContinue', 'pause',
                'restart', 'setBreakpoints', 'setFunctionBreakpoints', 'setDataBreakpoints', 'dataBreakpointInfo', 'threads', 'launch', 'nothing', 'initialize',
                'setExceptionBreakpoints', 'configurationDone']
    endless = 'O1\nG21 G90\nN10 #101=#101+1\nG1 X[#101-FIX[#101/50]*50] F9000\nM98 P200\nGOTO 10\nO200\nM99\n'
    for text in (PROGRAM, endless):
        client = Client(kadr)
        path = str(kadr.file('part.nc', text))
        waiting = {}

        def take(client=client, waiting=waiting):
            message = client.get()
            if message['type'] == 'response':
                expect(waiting.pop(message['request_seq'], None) == message['command'], f'a second response: {message}')
                expect(message['success'] or message['message'], f'a refusal says why: {message}')
        most_waiting = 50
        for n in range(MESSAGES // 2):
            command = draw.choice(commands) if n > 40 else draw.choice(['initialize', 'launch', 'configurationDone', 'threads'])
            waiting[client.request(command, draw.choice([random_arguments(draw, path)] * 3 + [{}, 5]))] = command
            while len(waiting) > most_waiting or select.select([client.process.stdout], [], [], 0)[0]:
                take()
        while waiting:
            take()
        rows = (Path('/proc') / str(client.process.pid) / 'status').read_text(encoding='utf-8').splitlines()
        reserved, used = (next(int(row.split()[1]) / 1024 for row in rows if row.startswith(name)) for name in ('VmPeak', 'VmHWM'))
        expect(used < 300 or reserved > 2 ** 20, f'memory of the adapter: {used:.0f} MB')
        client.request('disconnect')
        expect(client.process.wait(harness.TIME_LIMIT_S) == 0, 'the end')


if __name__ == '__main__':
    sys.exit(harness.main(__doc__, globals()))
