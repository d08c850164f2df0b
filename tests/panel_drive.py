#!/usr/bin/env python3
"""kadr serve --drive: a real machine at its panel, as a page drives it (docs/panel-protocol.md, The panel), against the double of a Grbl
controller behind a pseudo-terminal.

    panel_drive.py --kadr build/release/kadr --double build/release/tests/grbl_double
"""
import argparse
import os
import signal
import tempfile
import time
from pathlib import Path

import drive
from page_client.client import Page, Server, expect, result, seen
from page_client.machine import stands, until

# Of another control than the controller's: a subprogram, a cycle, an arc by its radius.
PROGRAM = 'G21 G90 G17 G54\nG0 X5 Y5 Z2\nG83 X5 Y5 Z-4 R1 Q2 F900\nG80\nM98 P7\nG0 X0 Y0\nM30\nO7\nG1 X15 F2400\nG2 X25 Y15 R10\nM99\n'
LONG = 'G21 G90\nG1 X200 F1500\nM30\n'


def operator(server, file, port, **more):
    page = Page(server)
    page.ask('hello', lang='en', token=server.token)
    on = page.ask('machine', file=file, control='mach3', port=port, **more)
    expect('error' not in on and on['holds'], f'it is on: {on}')
    stands(page)
    return page


def proves(server, machine):
    looker = Page(server)
    looker.ask('hello', lang='en')
    expect('error' in looker.ask('prove', file='part.nc', control='mach3', port=machine.port), 'without the token nothing is connected')
    page = Page(server)
    page.ask('hello', lang='en', token=server.token)
    expect(page.ask('ports')['ports'] == [machine.port], 'the ports of the server')
    expect('error' in page.ask('prove', file='part.nc', control='mach3', port='/dev/null'), 'another port is refused')
    proof = page.ask('prove', file='part.nc', control='mach3', port=machine.port)
    rows = {row['id']: row for row in proof.get('rows', [])}
    expect(rows['version']['verdict'] == 'equal' and rows['feed']['program'] == '2400', f'the proof {proof}')
    expect(proof['lines'] > 8 and proof['first']['to'] == {'X': 5, 'Y': 5, 'Z': 2} and not proof['locked'], f'what it needs {proof}')
    machine.tell('set 32 1')
    proof = page.ask('prove', file='spindle.nc', control='mach3', port=machine.port)
    expect([row['id'] for row in proof['rows'] if row['verdict'] == 'refused'] == ['laser'], f'laser mode {proof}')
    refused = page.ask('machine', file='spindle.nc', control='mach3', port=machine.port, accept=[])
    expect('laser' in refused.get('error', {}).get('text', ''), f'a refused row is not driven: {refused}')
    machine.tell('set 32 0')
    proof = page.ask('prove', file='rotary.nc', control='linuxcnc', port=machine.port)
    refused = page.ask('machine', file='rotary.nc', control='linuxcnc', port=machine.port, accept=['program'])
    expect('error' in refused, f'what the machine does not have cannot be accepted: {proof} {refused}')


def runs(server, machine):
    page = operator(server, 'part.nc', machine.port)
    panel = page.ask('panel')
    expect(panel['real']['port'] == machine.port and panel['real']['state'] == 'Idle' and panel['real']['age'] < 2, f'a real machine {panel["real"]}')
    expect('error' in Page_of(server).ask('machine', file='other.nc', control='mach3', port=machine.port), 'a port has one owner')
    page.ask('press', key='run')
    moving = until(page, lambda p: p['mode'] == 'running' and p['line'] == 10)
    expect(moving['machine']['X'] > 14, f'the executed block {moving}')
    ended = until(page, lambda p: p['mode'] == 'ended')
    expect(abs(ended['machine']['X']) < 0.01 and abs(ended['machine']['Y']) < 0.01, f'at the end {ended["machine"]}')
    page.ask('enter', line='G0 X7')
    until(page, lambda p: p['mode'] in ('ended', 'standing') and abs(p['machine']['X'] - 7) < 0.01)
    expect('error' in page.ask('undo'), 'a real machine cannot go back')
    machine.tell('probe 0.5')
    before = page.ask('panel')['machine']['Z']
    expect('error' in page.ask('probe', axis='Z', way=0.0, feed=100.0), 'a touch that is none')
    expect('error' not in page.ask('probe', axis='Z', way=-4.0, feed=600.0), 'a touch')
    touched = until(page, lambda p: p['mode'] in ('ended', 'standing') and 'touched' in p['told'])
    expect(abs(touched['machine']['Z'] - (before - 2)) < 0.01, f'it stands where it has touched: {touched["machine"]} {touched["told"]}')
    shares = page.ask('switches', rapid=0.4, override=0.5)
    expect('error' not in shares and page.ask('panel')['rapid'] == 0.5, 'the overrides that Grbl has')
    page.ask('press', key='off')
    expect(page.ask('machines')['machines'] == [], 'off')


def Page_of(server):
    page = Page(server)
    page.ask('hello', lang='en', token=server.token)
    return page


def sleeps(server, machine):
    """A page that no longer asks holds the machine; the page that comes back continues."""
    page = operator(server, 'long.nc', machine.port)
    page.ask('press', key='run')
    until(page, lambda p: p['machine']['X'] > 3)
    time.sleep(4.5)
    held = page.ask('panel')
    expect(held['mode'] == 'held' and 'held' in held['told'], f'the page slept: {held["mode"]} {held["told"]}')
    expect(held['machine']['X'] < 190, 'and the machine has stopped')
    page.socket.close()
    page = Page_of(server)
    on = page.ask('machine', file='long.nc')
    expect(on['holds'], 'another page takes over')
    page.ask('press', key='run')
    until(page, lambda p: p['mode'] == 'running' and p['machine']['X'] > held['machine']['X'] + 1)
    page.ask('press', key='emergency')
    stopped = stands(page, 'emergency')
    page.ask('press', key='reset')
    stands(page)
    time.sleep(0.3)
    expect(abs(page.ask('panel')['machine']['X'] - stopped['machine']['X']) < 0.5, 'a stop stands')
    page.ask('press', key='off')


def cable(server, machine):
    page = operator(server, 'long.nc', machine.port)
    page.ask('press', key='run')
    until(page, lambda p: p['machine']['X'] > 3)
    machine.tell('unplug')
    lost = stands(page, 'alarm')
    expect(lost['real']['lost'] and lost['told'], f'a pulled cable is told: {lost["told"]}')
    expect('error' in page.ask('press', key='run'), 'nothing goes on by itself')
    page.ask('press', key='off')


def killed(kadr, folder, machine):
    """The server is killed while the machine moves: the record is complete, and a new server does not move it."""
    server = Server(kadr, folder, '--drive', machine.port, '--drive-log', str(folder / 'killed.log'), '--state', str(folder / 'state'))
    page = operator(server, 'long.nc', machine.port)
    page.ask('press', key='run')
    until(page, lambda p: p['machine']['X'] > 3)
    os.kill(server.process.pid, signal.SIGKILL)
    server.process.wait()
    log = (folder / 'killed.log').read_text()
    expect('> G1X200' in log and '<Run' in log, f'the record: {log[-300:]}')
    server = Server(kadr, folder, '--drive', machine.port, '--drive-log', str(folder / 'killed.log'), '--state', str(folder / 'state'))
    page = Page_of(server)
    busy = page.ask('machine', file='long.nc', control='mach3', port=machine.port)
    expect('error' in busy, f'a machine that still moves is not touched: {busy}')
    end = time.monotonic() + 60
    while 'error' in (on := page.ask('machine', file='long.nc', control='mach3', port=machine.port)) and time.monotonic() < end:
        time.sleep(0.5)
    expect('error' not in on, f'when it stands it is connected again: {on}')
    there = stands(page)
    expect(abs(there['machine']['X'] - 200) < 0.01, f'the controller has executed what it had: {there["machine"]}')
    page.ask('press', key='off')
    server.end()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--kadr', required=True)
    parser.add_argument('--double', required=True)
    options = parser.parse_args()
    drive.DOUBLE = options.double
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / 'part.nc').write_text(PROGRAM)
        (folder / 'other.nc').write_text(PROGRAM)
        (folder / 'long.nc').write_text(LONG)
        (folder / 'spindle.nc').write_text('G21 G90\nM3 S500\nG1 X5 F500\nM30\n')
        (folder / 'rotary.nc').write_text('G21 G90\nG1 A5 F500\nM2\n')
        for part in (proves, runs, sleeps, cable):
            machine = drive.Machine()
            server = Server(options.kadr, folder, '--drive', machine.port, '--drive-log', str(folder / f'{part.__name__}.log'))
            part(server, machine)
            server.end()
            machine.process.kill()
        machine = drive.Machine()
        killed(options.kadr, folder, machine)
        machine.process.kill()
    said = {f'{side}.{do}' for side in ('question', 'answer') for do in ('ports', 'prove', 'probe')}
    expect(not said - seen, f'of the schema never said: {sorted(said - seen)}')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
