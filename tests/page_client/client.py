"""A page without a browser: starts kadr serve, talks to it over a WebSocket, and checks each message in both directions against
docs/panel-protocol.schema.json. Used by tests/serve*.py and bench/serve_time."""
import base64
import json
import os
import re
import signal
import socket
import struct
import subprocess
from pathlib import Path

import jsonschema

import harness

SCHEMA = json.loads((Path(__file__).resolve().parent.parent.parent / 'docs/panel-protocol.schema.json').read_text(encoding='utf-8'))
VALIDATORS = {}
seen = set()  # 'answer.open', 'event.done': definitions of the schema that some message has matched

tally = harness.Tally()
expect, result = tally.expect, tally.result  # result: prints the last line of a runner, returns its exit status


def fault_of(message, form):
    """Returns why a message does not match that definition of the schema; None if it does."""
    if form not in SCHEMA['$defs']:
        return f'{form} is no form of the schema'
    if form not in VALIDATORS:
        VALIDATORS[form] = jsonschema.Draft202012Validator({'$defs': SCHEMA['$defs'], '$ref': f'#/$defs/{form}'})
    fault = jsonschema.exceptions.best_match(VALIDATORS[form].iter_errors(message))
    if fault is None:
        seen.add(form)
        return None
    return f'{"/".join(map(str, fault.absolute_path))}: {fault.message[:200]}'


def hold(message, form):
    fault = fault_of(message, form)
    expect(fault is None, f'{form}: {fault}')


class Server:
    def __init__(self, kadr, folder, *options, before=None):
        self.process = subprocess.Popen([kadr, 'serve', str(folder), '--port', '0', '--no-browser', '--lang', 'en', *options],
                                        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, preexec_fn=before)
        self.line = self.process.stdout.readline()
        found = re.search(r'http://([^:]+):(\d+)/#token=([0-9a-f]{32})', self.line)
        self.port, self.token = int(found[2]), found[3]

    def request(self, text):
        """Returns the answer; the part received so far if the server has closed the connection."""
        got = b''
        try:
            with socket.create_connection(('127.0.0.1', self.port), timeout=harness.TIME_LIMIT_S) as s:
                s.sendall(text.encode('latin-1'))
                s.shutdown(socket.SHUT_WR)
                while piece := s.recv(65536):
                    got += piece
        except OSError:
            pass
        return got.decode('latin-1')

    def end(self):
        self.process.send_signal(signal.SIGINT)
        return self.process.wait(timeout=harness.TIME_LIMIT_S)

    def spent(self):
        """Processor time of the server, s."""
        return harness.spent(self.process)

    def works(self, seconds=0.3):
        """Waits until the server has spent that much more processor time on a request that was sent before.  returns whether it has"""
        end = self.spent() + seconds
        return harness.until(lambda: self.spent() >= end)


class Page:
    """A WebSocket client: the part of RFC 6455 that the protocol needs."""

    def __init__(self, server, **headers):
        self.socket = socket.create_connection(('127.0.0.1', server.port), timeout=harness.TIME_LIMIT_S)
        fields = {'Host': f'127.0.0.1:{server.port}', 'Upgrade': 'websocket', 'Connection': 'Upgrade',
                  'Sec-WebSocket-Key': base64.b64encode(os.urandom(16)).decode(), 'Sec-WebSocket-Version': '13', **headers}
        self.socket.sendall(('GET /session HTTP/1.1\r\n' + ''.join(f'{k}: {v}\r\n' for k, v in fields.items()) + '\r\n').encode())
        head = b''
        while b'\r\n\r\n' not in head:
            piece = self.socket.recv(1)
            if not piece:
                break
            head += piece
        self.status = int(head.split()[1])
        self.number = 0
        self.events, self.frames = [], []
        self.asked = {}  # unanswered requests, by number

    def send(self, data, opcode=1):
        mask = os.urandom(4)
        n = len(data)
        head = bytes([0x80 | opcode]) + (bytes([0x80 | n]) if n < 126 else bytes([0xFE]) + struct.pack('>H', n) if n < 65536
                                         else bytes([0xFF]) + struct.pack('>Q', n))
        repeated = (mask * (n // 4 + 1))[:n]
        body = (int.from_bytes(data, 'big') ^ int.from_bytes(repeated, 'big')).to_bytes(n, 'big') if n else b''
        self.socket.sendall(head + mask + body)

    def exactly(self, n):
        got = bytearray(n)
        rest = memoryview(got)
        while rest:
            count = self.socket.recv_into(rest)
            if not count:
                raise ConnectionError
            rest = rest[count:]
        return bytes(got)

    def receive(self):
        """Returns (opcode, bytes) of the next message, its fragments joined."""
        message, kind = bytearray(), 0
        while True:
            first, second = self.exactly(2)
            n = second & 127
            if n == 126:
                n = struct.unpack('>H', self.exactly(2))[0]
            elif n == 127:
                n = struct.unpack('>Q', self.exactly(8))[0]
            data, opcode = self.exactly(n), first & 15
            if opcode == 9:
                self.send(data, 10)
                continue
            if opcode == 8:
                raise ConnectionError(struct.unpack('>H', data[:2])[0] if len(data) >= 2 else None)
            kind = kind or opcode
            message += data
            if first & 0x80:
                return kind, bytes(message)

    def take(self):
        """Returns the next message; None if it is a frame."""
        kind, data = self.receive()
        if kind == 2:
            self.frames.append(data)
            return None
        message = json.loads(data)
        if 'event' in message:
            hold(message, 'event.' + str(message['event']))
        else:
            do = self.asked.pop(message.get('re'), None)
            hold(message, 'answer.error' if 'error' in message or do is None else 'answer.' + do)
        return message

    @staticmethod
    def forms():
        return SCHEMA['$defs']

    def begin(self, do, wrong=False, **more):
        """Sends a request without waiting. `wrong`: True if the schema must not match the request; None: it may match.
        returns  its number"""
        self.number += 1
        question = {'id': self.number, 'do': do, **more}
        if wrong:
            expect(fault_of(question, 'question.' + do) is not None, f'{question} is wrong')
        elif wrong is not None:
            hold(question, 'question.' + do)
        self.asked[self.number] = do
        self.send(json.dumps(question).encode())
        return self.number

    def ask(self, do, wrong=False, **more):
        return self.answer(self.begin(do, wrong, **more))

    def answer(self, number):
        while True:
            message = self.take()
            if message is None:
                continue
            if message.get('re') == number:
                return message
            self.events.append(message)

    def until(self, event):
        while True:
            for i, message in enumerate(self.events):
                if message.get('event') == event:
                    return self.events.pop(i)
            message = self.take()
            if message is not None:
                self.events.append(message)

    def open(self, file, **more):
        self.events, self.frames = [], []
        answer = self.ask('open', file=file, **more)
        return answer, (None if 'error' in answer else self.until('done'))


def vertices(frame):
    """Returns the rows of a frame of the path: x, y, z, time, line, kind, level."""
    kind, which, count, channel = struct.unpack_from('<4I', frame)
    begins = struct.unpack_from('<d', frame, 16)[0]
    at = 96
    xyz = struct.unpack_from(f'<{3 * count}f', frame, at)
    times = struct.unpack_from(f'<{count}f', frame, at + 12 * count)
    lines = struct.unpack_from(f'<{count}I', frame, at + 16 * count)
    kinds = frame[at + 36 * count:]
    return [(xyz[3 * i:3 * i + 3], begins + times[i], lines[i], kinds[4 * i], kinds[4 * i + 1]) for i in range(count)]


PROGRAM = """(</script><img src=x onerror=alert`1`>)
G21 G90 G17
T1 M6
S1000 M3
G0 X0 Y0 Z5
G1 Z-2 F200
X40 F600
G3 X40 Y20 J10
G1 X0
Y0
G0 Z5
M30
"""
