#!/usr/bin/env python3
"""Tests kadr serve --state: the server is killed at random moments while a program runs, with edits of tables in between; no confirmed
change is lost, and the panel offers to restart where the program was.

    tests/panel_kills.py --kadr build/release/kadr [--kills 200] [--seed 1]
"""
import argparse
import random
import subprocess
import tempfile
import time
from pathlib import Path

from page_client.client import Page, Server, expect, result
from page_client.machine import FAST, until

PROGRAM = 'G21 G90 G94 G17 G54\nT1 M6\nS900 M3\nG0 X-20 Y-20 Z20\n#1=0\nM98 P7 L400\nG0 Z20\nM30\nO7\n#1=[#1+1]\nG1 Z-1 F9000\nG42 D1 X0 Y0\nX20\nY20\nX0\nY0\nG40 X-20 Y-20\nG0 Z5\nM99\n'
WITH = {'control': 'mach3', 'machine': 'fast.toml', 'setup': 'part.json'}


def find(page, **place):
    end = time.monotonic() + 60
    while True:
        answer = page.ask('restart', **place)
        if answer.get('ready') or 'error' in answer or time.monotonic() > end:
            return answer
        time.sleep(0.005)


class Operator:
    """What the operator has seen and what was confirmed to him."""

    def __init__(self, kadr, folder, chance):
        self.kadr, self.folder, self.chance = kadr, folder, chance
        self.radius, self.zero, self.seen, self.runs, self.logged, self.offers = None, None, 0, 0, 0, 0

    def begin(self):
        self.server = Server(self.kadr, self.folder / 'programs', '--state', str(self.folder / 'shop.state'))
        self.page = Page(self.server)
        self.page.ask('hello', lang='en', token=self.server.token)

    def switch_on(self, first):
        kept = self.page.ask('machines')['machines']
        expect(first or kept == [{'name': 'part.nc', 'mode': 'kept', 'held': False}], f'the machine is kept: {kept}')
        on = self.page.ask('machine', file='part.nc', **(WITH if first else {}))
        expect('error' not in on and on['lasts'] and on['machine'] == 'fast', f'it is on again, as it was: {on}')
        tables = self.page.ask('tables')
        edited = tables['edited']
        expect(edited.get('offsets', {}).get('1', {}).get('radius') == self.radius, f'the radius that was confirmed: {edited} {self.radius}')
        expect(edited.get('work_offsets', {}).get('G54', {}).get('X') == self.zero, f'the zero that was confirmed: {edited} {self.zero}')
        log = self.page.ask('shift')['log']
        expect(sum(e['kind'] == 'edit' for e in log) >= self.logged and sum(e['kind'] == 'run' for e in log) >= self.runs, 'the log of the shift')
        return on['stood']

    def go_on(self, stood):
        expect(stood is not None or self.seen <= 1, f'it is offered to go on: {stood} {self.seen}')
        if stood is None:
            return
        self.offers += 1
        held_back = 2  # motions of a compensated contour: after a restart the first motion is of an earlier block
        expect(stood['number'] >= self.seen - held_back, f'where it was seen last, or later: {stood} {self.seen}')
        sheet = find(self.page, number=stood['number'], line=stood['line'], clearance=20.0, feed=9000.0)
        expect(sheet.get('line') == stood['line'], f'the place is found: {sheet}')
        went = self.page.ask('go_there', number=stood['number'], line=stood['line'], way=sheet['way'])
        expect('error' not in went, f'it goes there: {went}')
        there = until(self.page, lambda p: p['mode'] == 'standing' and not p['goes_there'])
        expect(there['line'] == stood['line'] and there['number'] == stood['number'], f'it stands there: {there["line"]} {there["number"]} {stood}')

    def edit(self):
        if self.chance.random() < 0.5:
            wanted = round(self.chance.uniform(1, 5), 3)
            done = self.page.ask('edit', tables={'offsets': {'1': {'radius': wanted}}})
            if 'error' not in done:
                self.radius, self.logged = wanted, self.logged + 1
        elif self.chance.random() < 0.4:  # by a line entered by hand
            wanted = round(self.chance.uniform(-9, 9), 3)
            before = self.page.ask('panel')['can_undo']
            done = self.page.ask('enter', line=f'G10 L2 P1 X{wanted}')
            entered = until(self.page, lambda p: p['mode'] == 'standing' and p['can_undo'] == before + 1)
            if entered['alarm'] is None:
                self.zero, self.logged = wanted, self.logged + 1
            expect(entered['alarm'] is None or 'compensation' in entered['alarm']['text'], f'a line: {entered["alarm"]}')
        else:
            wanted = round(self.chance.uniform(-9, 9), 3)
            done = self.page.ask('edit', tables={'work_offsets': {'G54': {'X': wanted}}})
            if 'error' not in done:
                self.zero, self.logged = wanted, self.logged + 1
        expect('error' not in done or 'contour' in done['error']['text'], f'an edit: {done}')
        until(self.page, lambda p: p['mode'] == 'standing' and not p['takes_tables'])

    def run_and_kill(self):
        self.seen = 0
        expect('error' not in self.page.ask('press', key='run'), 'run')
        self.runs += 1
        end = time.monotonic() + self.chance.expovariate(1 / 0.25)
        while time.monotonic() < end:
            panel = self.page.ask('panel')
            if panel['mode'] != 'running':
                expect(panel['mode'] == 'standing' and panel['line'] == 1, f'it runs: {panel}')
                break
            self.seen = max(self.seen, panel['number'])
        self.server.process.kill()
        self.server.process.wait()


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    options.add_argument('--kills', type=int, default=12)
    options.add_argument('--seed', type=int, default=1)
    args = options.parse_args()
    with tempfile.TemporaryDirectory() as above:
        folder = Path(above)
        (folder / 'programs').mkdir()
        (folder / 'programs/part.nc').write_text(PROGRAM)
        (folder / 'programs/part.json').write_text('{"offsets": {"1": {"radius": 3}}}')
        (folder / 'programs/fast.toml').write_text(FAST)
        operator = Operator(args.kadr, folder, random.Random(args.seed))
        for kill in range(args.kills):
            operator.begin()
            operator.go_on(operator.switch_on(kill == 0))
            if operator.chance.random() < 0.6:
                operator.edit()
            operator.run_and_kill()
        expect(operator.offers >= args.kills / 3, f'it was gone on {operator.offers} times of {args.kills}')
        sound = subprocess.run([args.kadr, 'state', 'check', str(folder / 'shop.state')], capture_output=True, text=True)
        expect(sound.returncode == 0, f'the state file is sound: {sound.stdout}{sound.stderr}')
        other = subprocess.run([args.kadr, 'run', '--control', 'nct', '--state', str(folder / 'shop.state'), str(folder / 'programs/part.nc')], capture_output=True, text=True)
        expect(other.returncode == 2 and 'panel' in other.stderr, 'it is no state of a control')
        operator.begin()
        operator.switch_on(False)
        operator.page.ask('press', key='off')
        expect(operator.page.ask('machines')['machines'] == [], 'switched off, it is kept no more')
        second = subprocess.run([args.kadr, 'serve', str(folder), '--port', '0', '--no-browser', '--state', str(folder / 'shop.state')], capture_output=True, text=True)
        expect(second.returncode == 2 and 'in use' in second.stderr, 'one server has it open at a time')
        expect(operator.server.end() == 130, 'and it ends')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
