#!/usr/bin/env python3
"""Tests kadr serve with messages derived at random from those in fuzz/corpus/page: values of other types, missing keys, wrong bytes. Each
question has one answer, each answer matches the schema, and the server keeps running. This is a short form of what dev/fuzz page does
longer.

    serve_chance.py --kadr PROGRAM [--rounds N] [--seed N]
"""
import argparse
import json
import random
import tempfile
import time
from pathlib import Path

from page_client.client import PROGRAM, Page, Server, expect, result

SEEDS = Path(__file__).resolve().parent.parent / 'fuzz/corpus/page'
VALUES = [None, True, 0, -1, 1, 2, 7, 1.5, 1e308, -1e308, 4294967296, 2**63, '', 'x', '\0', '../..', '/etc/passwd', 'part.nc', 'call.nc', 'turn.nc', 'faulty.nc',
          'endless.nc', 'setup.json', 'tools.toml', 'own.toml', 'sub', '.', 'mach3', 'nct', 'linuxcnc', 'fanuc', 'grbl', 's2c42', 'gost', 'utf-16', 'cp1251', 'ru',
          'box:0,0,-5,9,9,0', 'box:-1e9,-1e9,-1e9,1e9,1e9,1e9', 'cylinder:1e-9,1', [], {}, [[]], {'a': 1}, 'G1 X1e30 F1\n' * 50, '(' * 3000, '\ud83d\ude00', 'G65 P30\n' * 9]
FILES = {'part.nc': PROGRAM, 'call.nc': 'M98 P30\nG65 P30 A5\nG83 X5 Y5 Z-5 R2 Q1 F100\nM30\n', 'O0030.nc': '#1=#1+1\nG1 X#1 F100\nM99\n',
         'endless.nc': 'G90 F1000\no100 while [1]\nG1 X1\nX0\no100 endwhile\nM2\n', 'turn.nc': 'G18 G95 G96 S120 M3\nG0 X40 Z2\nG1 Z-20 F0.2\nX42\nM30\n',
         'faulty.nc': 'G1 X10\nG2 X5 R1\nG99 Y\n(\nG41 X\nM98 P7\nM30\n', 'setup.json': '{"offsets": {"1": {"radius": 5, "length": 50}}}',
         'zone.txt': 'from 0 0\nline 30 0\nline 30 20\nline 0 20 open\nclose\n',
         'tools.toml': '[[tool]]\nnumber = 1\nkind = "end"\ndiameter = 10\nlength = 40\n', 'own.toml': 'id = "own"\nextends = "nct"\nname = {en = "O", ru = "О"}\n'}


def made_of(question, chance):
    """Returns the question with some of its values and keys changed."""
    made = dict(question)
    for key in list(made):
        if key != 'id' and chance.random() < 0.2:
            made[key] = chance.choice(VALUES)
        if key not in ('id', 'do') and chance.random() < 0.05:
            del made[key]
    if chance.random() < 0.1:
        made[chance.choice(('file', 'text', 'at', 'number', 'line', 'from', 'count', 'setup', 'tools', 'control', 'nothing'))] = chance.choice(VALUES)
    return made


def one_session(server, seeds, chance, said):
    """`said` collects the questions."""
    page = Page(server)
    page.ask('hello', token=server.token, lang=chance.choice(('en', 'ru')))
    questions = list(chance.choice(seeds))
    if chance.random() < 0.7:  # something is open
        questions = chance.choice([s for s in seeds if s[0]['do'] == 'open'])[:1] + questions
    for question in questions[:12]:
        made = made_of(question, chance)
        said.append(made)
        page.number += 1
        made['id'] = page.number
        if isinstance(made.get('do'), str) and 'answer.' + made['do'] in page.forms():
            page.asked[page.number] = made['do']
        page.send(json.dumps(made).encode())
        asked = page.number
        if 'endless' in json.dumps(made) or chance.random() < 0.2:
            page.begin('stop')  # sent without waiting for the answer
        expect(page.answer(asked)['re'] == asked, f'answered: {made}')  # else the socket's time limit ends it
    if chance.random() < 0.3:
        text = bytearray(json.dumps({**questions[0], 'id': 1}).encode())
        for _ in range(chance.randrange(1, 6)):
            text[chance.randrange(len(text))] = chance.randrange(128)
        page.send(bytes(text))
    page.socket.close()


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    options.add_argument('--rounds', type=int, default=60)
    options.add_argument('--seed', type=int, default=1)
    given = options.parse_args()
    chance = random.Random(given.seed)
    seeds = []
    for file in sorted(SEEDS.iterdir()):
        rows = [json.loads(row) for row in file.read_text().splitlines() if row.startswith('{"id"') and '1e400' not in row]
        rows = [row for row in rows if isinstance(row.get('do'), str)]
        if rows:
            seeds.append(rows)
    with tempfile.TemporaryDirectory() as folder:
        for name, text in FILES.items():
            (Path(folder) / name).write_text(text)
        (Path(folder) / 'sub').mkdir()
        server = Server(given.kadr, folder, '--open')
        for round_number in range(given.rounds):
            said = []
            try:
                one_session(server, seeds, chance, said)
            except (ConnectionError, OSError) as error:
                expect(False, f'round {round_number} (seed {given.seed}): {error!r} after {said[-3:]}')
                time.sleep(0.2)
            if server.process.poll() is not None:
                expect(False, f'round {round_number} (seed {given.seed}): the server is gone, status {server.process.poll()}')
                server = Server(given.kadr, folder, '--open')
        expect('entries' in one_ask(server), 'the server still stands')
        server.end()
    return result()


def one_ask(server):
    page = Page(server)
    page.ask('hello')
    return page.ask('files', folder='')


if __name__ == '__main__':
    raise SystemExit(main())
