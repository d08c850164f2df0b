#!/usr/bin/env python3
"""Tests kadr serve with a lathe's program: diameters, the modes of a lathe, the exact cut of a turned part, as `kadr cut` does it.

    serve_lathe.py --kadr PROGRAM
"""
import argparse
import json
import math
import subprocess
import sys

import harness
from page_client.client import Page, Server, expect, result
from serve import part_points, shown

EXAMPLES = harness.ROOT / 'examples' / 'cut'
BAR = 'cylinder:0,0,-80,1,50'
CHUCK = 'cylinder:0,0,-130,-65,120,50'


def area(polygon):
    """Returns the signed area of a polygon of [radius, z]."""
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(polygon, polygon[1:] + polygon[:1])) / 2


def volume(polygons):
    """Returns the volume of the body of revolution, mm³ (Pappus)."""
    return sum(math.pi / 3 * (a[0] + b[0]) * (a[0] * b[1] - b[0] * a[1]) for p in polygons for a, b in zip(p, p[1:] + p[:1]))


def modes(page, done):
    expect(done['diameters'] == ['X'], f'X is a diameter: {done["diameters"]}')
    states = [page.ask('state', at=done['seconds'] * i / 200) for i in range(201)]
    expect(all(s['diameters'] == ['X'] for s in states[5:]), 'in each state')
    with_surface = [s for s in states if s['surface']]
    expect({s['surface']['speed'] for s in with_surface} == {180, 220}, 'both surface speeds')
    expect({s['surface']['most'] for s in with_surface} == {2500}, 'the limit of G50')
    for s in with_surface:
        radius = abs(s['position']['X'])
        wanted = min(2500, 1000 * s['surface']['speed'] / (2 * math.pi * radius)) if radius > 0 else 2500
        expect(math.isclose(s['rpm'], wanted, rel_tol=1e-3), f'{s["line"]}: {s["rpm"]} rev/min at a radius of {radius}, not {wanted}')
    expect(any(s['feed_per_turn'] == 0.25 for s in states) and any(s['rpm'] == 800 and not s['surface'] for s in states), 'feed per revolution, G97')
    offsets = [s['tool_offset'] for s in states if s['tool_offset']]
    expect({(o['row'], o['radius'], o['tip']) for o in offsets} >= {(1, 0.8, 3), (2, 0.4, 3)}, f'rows of the offset table: {offsets[:2]}')


def the_part(kadr, page, done):
    proposed = page.ask('proposals')
    expect(proposed['stock'].startswith('cylinder:0,0,'), f'a bar is proposed: {proposed["stock"]}')
    by_number = {tool['number']: tool for tool in proposed['tools']}
    expect(by_number[1]['kind'] == 'turning' and by_number[1]['by_offset'] and by_number[1]['corner'] == 0.8, f'an insert of the offset table: {by_number[1]}')
    expect({i['tool'] for i in proposed['inserts']} >= {1, 2}, 'outlines of inserts')
    expect(min(p[0] for i in proposed['inserts'] if i['tool'] == 1 for p in i['outline']) == 0, 'the tip is the programmed point')

    answer = page.ask('cut', stock=BAR, tools='lathe.toml', fixtures=[CHUCK])
    expect('error' not in answer, f'cut: {answer}')
    cut = page.until('cut')
    words = [kadr, 'cut', str(EXAMPLES / 'lathe.nc'), '--control', 'fanuc-t', '--setup', str(EXAMPLES / 'lathe.json'), '--stock', BAR, '--tools',
             str(EXAMPLES / 'lathe.toml'), '--fixture', CHUCK, '--json', '-', '-q']
    wanted = json.loads(subprocess.run(words, capture_output=True, text=True, timeout=harness.TIME_LIMIT_S).stdout)
    expect(all(cut[key] == wanted[key] for key in wanted), f'the figures of the command: {[key for key in wanted if cut.get(key) != wanted[key]]}')
    expect(cut['turned']['surface'] > 0 and {i['tool'] for i in cut['inserts']} == {1, 2, 3}, 'cut exactly, with all inserts')

    end, frame = shown(page, done['seconds'] * 2)
    expect(abs(end['left'] - cut['left']) < 1e-3, f'the part at the end: {end["left"]}, {cut["left"]}')
    expect(abs(volume(end['section']) - cut['left']) < 1e-4 * cut['left'], 'the section has the volume of the part')
    expect(all(area(p) > 0 for p in end['section']) and len(end['edges']) > 4, 'outer polygons, edges')
    points, tools, lines = part_points(frame)
    expect(set(tools) == {2, 3, 65535}, f'who made the surface, after the finishing cut: {set(tools)}')
    begin, _ = shown(page, 0)
    expect(abs(begin['left'] - cut['stock']) < 1e-3, 'the bar at the beginning')
    before = cut['stock']
    for i in range(21):
        now, _ = shown(page, cut['seconds'] * i / 20)
        expect(now['left'] <= before + 1e-3, f'{i}: what is left never grows')
        before = now['left']

    described = [{key: value for key, value in tool.items() if key != 'by_offset'} for tool in proposed['tools']]
    page.ask('cut', stock=BAR, tools=described, resolution=0.5)
    lattice = page.until('cut')
    expect('error' not in lattice and 'turned' not in lattice and abs(lattice['left'] - cut['left']) < 0.02 * cut['left'], 'with a cell on a lattice')
    expect('section' not in page.ask('part', at=1), 'which has no exact sections')


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    kadr = options.parse_args().kadr
    server = Server(kadr, EXAMPLES, '--open')
    page = Page(server)
    page.ask('hello', token=server.token, lang='en')
    opened, done = page.open('lathe.nc', control='fanuc-t', setup='lathe.json')
    expect(opened['control']['lathe'] and done['state'] == 'ended', f'a lathe: {opened["control"]}')
    modes(page, done)
    the_part(kadr, page, done)
    sheet = page.ask('sheet')
    expect(sheet['diameters'] == ['X'], 'the sheet')
    server.end()
    return result()


if __name__ == '__main__':
    sys.exit(main())
