#!/usr/bin/env python3
"""Tests `kadr diff --plot`: what both programs do, what only one does, what is changed, numbers and lines as in the text; enlargements of
tiny differences; output files treated as by any command. The test parses the pictures as SVG.

    diff_plot.py --kadr PROGRAM [--mutations N]
"""
import fnmatch
import os
import random
import re
import signal
import subprocess
import sys
import xml.etree.ElementTree as ET

import harness

EXAMPLES = harness.ROOT / 'examples'
NS = '{http://www.w3.org/2000/svg}'
tally = harness.Tally()
expect = tally.expect


class Picture:
    def __init__(self, path):
        self.root = ET.parse(path).getroot()
        self.texts = [''.join(e.itertext()) for e in self.root.iter(NS + 'text')]
        self.description = self.root.findtext(NS + 'desc')

    def part(self, name):
        return next((g for g in self.root.iter(NS + 'g') if g.get('id') == name), None)

    def texts_of(self, name):
        part = self.part(name)
        return [] if part is None else [''.join(e.itertext()) for e in part.iter(NS + 'text')]

    def numbers(self, name):
        """The numbers at positions of a view."""
        part = self.part(name)
        return [] if part is None else [e.text for e in part.iter(NS + 'text') if e.get('font-weight') == 'bold' and e.get('fill') == '#ffffff']

    def strokes(self, name, kind):
        """Each path of that type: its line, its file, its points."""
        part = self.part(name)
        found = []
        for group in [] if part is None else part.iter(NS + 'g'):
            if group.get('class') == kind:
                found += [(p.get('data-line'), p.get('data-file'), points_of(p), group) for p in group.findall(NS + 'path')]
        return found

    def lines(self, name, kind):
        return {int(line) for line, _, _, _ in self.strokes(name, kind)}

    def size(self, name, kind):
        """Greatest extent of the drawing, in units of the page."""
        points = [p for _, _, stroke, _ in self.strokes(name, kind) for p in stroke]
        return max(max(c) - min(c) for c in zip(*points)) if points else 0


def points_of(path):
    numbers = [float(n) for n in re.findall(r'-?[0-9.]+', path.get('d'))]
    return list(zip(numbers[::2], numbers[1::2]))


class Kadr(harness.Kadr):
    def run(self, *arguments, **more):
        return self.call('diff', *arguments, **more)

    def picture(self, a, b, *options, lang='en', control='linuxcnc'):
        """Returns the output, its status, the picture."""
        for name, text in (('a.nc', a), ('b.nc', b)):
            (self.folder / name).write_text(text)
        plot = self.folder / 'd.svg'
        plot.unlink(missing_ok=True)
        got = self.run('a.nc', 'b.nc', '--control', control, '--lang', lang, '--plot', 'd.svg', *options)
        return got, Picture(plot) if plot.exists() else None


BASE = 'G21 G90 G17\nS1000 M3\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX10\nY10\nG2 X0 Y10 I-5 J0\nG1 X0\nY0\nG0 Z5\nM30\n'
VIEWS = ('view-isometric', 'view-xy')


def changed(*pairs):
    text = BASE
    for before, after in pairs:
        assert before in text, before
        text = text.replace(before, after, 1)
    return text


def check_equal(kadr):
    got, picture = kadr.picture(BASE, BASE)
    expect(got.returncode == 0 and got.stdout.startswith('equal'), f'equal: {got.stdout}{got.stderr}')
    expect(any(t.startswith('equal: 7 motions') for t in picture.texts), 'the picture says that they are equal')
    expect(picture.lines('view-xy', 'same') >= {5, 6, 7, 9}, f'the way in common: {picture.lines("view-xy", "same")}')
    expect(all(not picture.strokes(v, k) for v in VIEWS for k in ('a', 'b', 'changed')), 'nothing differs')
    expect(picture.part('differences') is None or not picture.texts_of('differences'), 'no list')
    _, picture = kadr.picture(BASE, BASE, lang='ru')
    expect(any(t.startswith('одинаковы') for t in picture.texts) and 'обе' in picture.texts_of('legend'), 'equal, in Russian')


def check_another_way(kadr):
    got, picture = kadr.picture(BASE, changed(('Y10\n', 'X10.5 Y5\nX10 Y10\n')))
    first = '1. a.nc:6 | b.nc:6-7: another way, up to 0.5 mm apart\n'
    expect(got.returncode == 1 and got.stdout.startswith(first), f'the number in the text: {got.stdout}')
    for view in VIEWS:
        expect(picture.lines(view, 'a') == {6}, f'{view}: the way of a: {picture.lines(view, "a")}')
        expect(picture.lines(view, 'b') == {6, 7}, f'{view}: the way of b: {picture.lines(view, "b")}')
        expect({f for _, f, _, _ in picture.strokes(view, 'b')} == {'b.nc'}, f'{view}: whose lines')
        expect({f for _, f, _, _ in picture.strokes(view, 'a')} == {None}, f'{view}: whose lines are the first one\'s')
        expect(6 not in picture.lines(view, 'same') and {5, 7} <= picture.lines(view, 'same'), f'{view}: in common')
        expect(picture.numbers(view) == ['1'], f'{view}: numbers {picture.numbers(view)}')
    expect({'a.nc', 'b.nc', 'both'} <= set(picture.texts_of('legend')), f'legend: {picture.texts_of("legend")}')
    expect(picture.texts_of('differences') == ['1', first[3:-1]], f'list: {picture.texts_of("differences")}')
    inks = {k: picture.strokes('view-xy', k)[0][3].get('stroke') for k in ('a', 'b', 'same')}
    expect(len(set(inks.values())) == 3, f'three colours: {inks}')
    ids = [e.get('id') for e in picture.root.iter() if e.get('id')]
    expect(len(ids) == len(set(ids)) and 'l6' in ids, 'each name is there once')
    _, picture = kadr.picture(BASE, changed(('Y10\n', 'X10.5 Y5\nX10 Y10\n')), lang='ru')
    expect(any('другой путь, расходятся до 0.5 мм' in t for t in picture.texts_of('differences')), 'the list in Russian')


def check_changed(kadr):
    for what, before, after, holds in (('feed', 'Y0\nG0', 'Y0 F150\nG0', 'feed: F100 mm/min — F150'), ('spindle', 'Y0\nG0', 'S500 Y0\nG0', 'spindle'),
                                       ('coolant', 'Y0\nG0', 'M8 Y0\nM9 G0', 'coolant'), ('rapid', 'Y0\nG0', 'G0 Y0\nG0', 'kind of motion')):
        got, picture = kadr.picture(BASE, changed((before, after)))
        expect(got.returncode == 1 and holds in got.stdout, f'{what}: {got.stdout}')
        lines = picture.lines('view-xy', 'changed')
        expect(9 in lines and lines <= {9, 10}, f'{what}: marked {lines}')
        expect(not picture.strokes('view-xy', 'a') and not picture.strokes('view-xy', 'b'), f'{what}: no way of its own')
        expect('1' in picture.numbers('view-xy'), f'{what}: its number')
        expect(any(t.startswith('both, with another feed') for t in picture.texts_of('legend')), f'{what}: legend')


def check_acts(kadr):
    got, picture = kadr.picture(BASE, changed(('Y10\n', 'Y10\nG4 P1.5\n'), ('G0 Z5\nM30', 'M0\nG0 Z5\nM30')))
    expect(got.stdout.count('what is done between') == 2, f'acts: {got.stdout}')
    for view in VIEWS:
        expect(sorted(picture.numbers(view)) == ['1', '2'], f'{view}: numbers {picture.numbers(view)}')
    expect('done between motions' in picture.texts_of('legend'), f'legend: {picture.texts_of("legend")}')
    expect(not picture.strokes('view-xy', 'a') and not picture.strokes('view-xy', 'changed'), 'the way is the same')


def zigzag(lines=150):
    text = ['G21 G90 G17', 'S8000 M3', 'G0 X0 Y0 Z5', 'G1 Z-1 F800']
    for i in range(lines):
        text += [f'X{300 if i % 2 == 0 else 0} Y{2 * i}', f'Y{2 * i + 2}']
    return text + ['G0 Z50', 'M30', '']


def check_tiny(kadr):
    """A difference of 0.02 mm in 300 mm is shown enlarged, at its position."""
    a = zigzag()
    b = list(a)
    b[104] = b[104].replace('X300', 'X300.02')
    got, picture = kadr.picture('\n'.join(a), '\n'.join(b))
    expect(got.returncode == 1 and 'up to 0.02 mm apart' in got.stdout, got.stdout)
    closeup = picture.part('closeup-1')
    expect(closeup is not None and picture.texts_of('closeup-1')[0].startswith('1   a.nc:'), 'it is shown close up')
    of_a, of_b = ([p for _, _, s, _ in picture.strokes('closeup-1', k) for p in s if abs(p[0]) < 3000] for k in 'ab')
    apart = max(x for x, _ in of_b) - max(x for x, _ in of_a)
    expect(apart > 15, f'units of the page between them: {apart}')
    expect(picture.numbers('closeup-1') == ['1'], 'its number close up')
    marks = [float(t) for t in picture.texts_of('closeup-1') if re.fullmatch(r'-?[0-9.]+', t)]
    expect(any(299 < m < 301 for m in marks), f'coordinates close up: {marks}')


def check_long(kadr):
    """Paths that are simplified: the whole is still drawn, and the enlargement is exact."""
    a = zigzag(70_000)
    b = list(a)
    b[90_004] = b[90_004].replace('X300', 'X300.02').replace('X0', 'X0.02')
    before = harness.spent_by_children()
    got, picture = kadr.picture('\n'.join(a), '\n'.join(b))
    took = harness.spent_by_children() - before
    expect(got.returncode == 1 and took < 30, f'140,000 lines: {took:.1f} s of processor time, {got.stdout}{got.stderr}')
    expect(any(t.startswith('thinned') for t in picture.texts_of('legend')), 'it says that it is thinned')
    expect(picture.lines('closeup-1', 'a') and picture.lines('closeup-1', 'b'), 'both are there close up')
    expect(picture.lines('closeup-1', 'a') <= set(range(90_000, 90_010)), f'lines close up {picture.lines("closeup-1", "a")}')
    expect(not picture.root.findall(f'.//*[@data-line="-1"]'), 'lines')


def check_many(kadr):
    text = BASE.replace('Y10\nG2', ''.join(f'Y{i / 8} F{100 + i}\n' for i in range(1, 79)) + 'Y10\nG2')
    other = re.sub(r'F(1\d\d)', lambda m: f'F{int(m[1]) + 1}', text)
    got, picture = kadr.picture(text, other)
    listed = [t for t in picture.texts_of('differences') if t.isdigit()]
    expect(listed == [str(i) for i in range(1, 21)], f'the first twenty: {listed}')
    expect(any(re.fullmatch(r'… and \d+ more', t) for t in picture.texts_of('differences')), 'how many more')
    expect(sorted(map(int, picture.numbers('view-isometric'))) == list(range(1, 21)), f'their numbers: {picture.numbers("view-isometric")}')
    _, picture = kadr.picture(text, other, '--all')
    expect(len(picture.numbers('view-isometric')) > 40, 'numbers of all, as far as there is room')


def check_stopped(kadr):
    got, picture = kadr.picture(BASE, changed(('G1 X0\n', 'G1 X0 X1\n')))
    expect(got.returncode == 1 and any('stopped by an alarm: b.nc:8' in t for t in picture.texts_of('legend')), f'{picture.texts_of("legend")}')
    got, picture = kadr.picture('', '')
    expect(picture is not None and 'no motion' in picture.texts, 'no motion at all')
    got, picture = kadr.picture(BASE, '')
    expect(got.returncode == 1 and picture.lines('view-xy', 'a'), 'one does nothing')
    far = BASE.replace('X0', 'X400').replace('X10', 'X430').replace('Y0', 'Y70')
    got, picture = kadr.picture(BASE, far)
    expect(got.returncode == 1 and picture.lines('view-xy', 'a') and picture.lines('view-xy', 'b'), f'elsewhere: {got.stdout}')


def check_rotary(kadr):
    """The tool's positions in the axes are the same; only the table differs."""
    text = 'G21 G90\nG0 X0 Y0 Z5 A0\nG1 X10 A0 F100\nX20 A{}\nX30 A0\nM2\n'
    got, picture = kadr.picture(text.format(0), text.format(5))
    expect(got.returncode == 1 and picture.lines('view-xy', 'a') and picture.lines('view-xy', 'b'), f'a rotary axis: {got.stdout}')
    widths = [float(picture.strokes('view-xy', k)[0][3].get('stroke-width')) for k in 'ab']
    expect(widths[0] > 2 * widths[1], f'both are seen where one covers the other: {widths}')


def check_work_zero(kadr):
    """Coordinates are those of the program, not of the machine."""
    (kadr.folder / 'setup.json').write_text('{"work_offsets": {"G54": {"X": -300, "Y": -200, "Z": -100}}}')
    got, picture = kadr.picture('G54\n' + BASE, 'G54\n' + changed(('X10\n', 'X11\n')), '--setup', 'setup.json')
    expect(got.returncode == 1 and any(re.match(r'X +0 … 11', t) for t in picture.texts_of('view-isometric')),
           f'{got.stderr} {picture and picture.texts_of("view-isometric")}')


def check_names(kadr):
    """Names have no folders, unless the file names are the same."""
    for folder in ('old', 'new'):
        (kadr.folder / folder).mkdir()
        (kadr.folder / folder / 'p.nc').write_text(BASE if folder == 'old' else changed(('X10\n', 'X11\n')))
    (kadr.folder / 'new' / ('long' * 40 + '.nc')).write_text(BASE)
    for other, names in (('new/p.nc', ['old/p.nc', 'new/p.nc']), ('new/' + 'long' * 40 + '.nc', [])):
        kadr.run('old/p.nc', other, '--control', 'linuxcnc', '--lang', 'en', '--plot', 'n.svg')
        picture = Picture(kadr.folder / 'n.svg')
        expect(set(names) <= set(picture.texts_of('legend')), f'names: {picture.texts_of("legend")}')
        expect(all(len(t) < 200 for t in picture.texts), 'no text leaves the page')
    kadr.run('old/p.nc', str(kadr.folder / 'new' / 'p.nc'), '--control', 'linuxcnc', '--plot', 'n.svg')


def check_files(kadr):
    """Input files are never overwritten; the picture is written completely or not at all."""
    for name in ('a.nc', 'b.nc'):
        (kadr.folder / name).write_text(BASE)
    for plot, word in (('a.pdf', 'a plot is .svg or .png'), ('no/folder/d.svg', 'no/folder'), ('d', 'a plot is')):
        got = kadr.run('a.nc', 'b.nc', '--control', 'linuxcnc', '--lang', 'en', '--plot', plot)
        expect(got.returncode == 2 and word in got.stderr, f'{plot}: {got.returncode} {got.stderr}')
    (kadr.folder / 'a.svg').write_text(BASE)
    os.link(kadr.folder / 'a.svg', kadr.folder / 'hard.svg')
    for first, second, plot in (('a.svg', 'b.nc', 'a.svg'), ('b.nc', 'a.svg', './a.svg'), ('a.svg', 'b.nc', 'hard.svg')):
        got = kadr.run(first, second, '--control', 'linuxcnc', '--lang', 'en', '--plot', plot)
        expect(got.returncode == 2 and 'would be written over the input' in got.stderr, f'{plot}: {got.returncode} {got.stderr}')
    expect((kadr.folder / 'a.svg').read_text() == BASE, 'the program is as it was')
    (kadr.folder / 'main.nct').write_text('G65 P12\nM30\n')
    (kadr.folder / 'O0012.nct').write_text('G0 X1\nM99\n')
    os.link(kadr.folder / 'O0012.nct', kadr.folder / 'called.svg')
    got = kadr.run('main.nct', 'main.nct', '--control', 'nct', '--lang', 'en', '--plot', 'called.svg')
    expect(got.returncode == 2 and 'would be written over the called file' in got.stderr, f'called: {got.returncode} {got.stderr}')
    expect((kadr.folder / 'O0012.nct').read_text() == 'G0 X1\nM99\n', 'the called file is as it was')
    if os.path.exists('/dev/full'):
        with open('/dev/full', 'w') as full:
            got = kadr.run('a.nc', 'b.nc', '--control', 'linuxcnc', '--plot', 'full.svg', stdout=full)
        expect(got.returncode == 2 and not (kadr.folder / 'full.svg').exists(), f'a full disk: {got.returncode}')
    got = kadr.run('a.nc', '-', '--control', 'linuxcnc', '--plot', 'd.PNG', input=BASE)
    expect(got.returncode == 0 and (kadr.folder / 'd.PNG').read_bytes()[:4] == b'\x89PNG', f'standard input, PNG: {got.stderr}')
    (kadr.folder / 'endless.nc').write_text('G21 G90 F1000\no100 while [1]\nG1 X1\nX0\no100 endwhile\nM2\n')
    process = kadr.start('diff', 'endless.nc', 'endless.nc', '--control', 'linuxcnc', '--max-blocks', '1000000000000', '--plot', 'e.svg',
                         stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    begun = harness.at_work(process)
    harness.spent_after(process, signal.SIGINT)
    expect(begun and process.returncode == 130 and not list(kadr.folder.glob('*e.svg*')), 'Ctrl-C leaves nothing')


def mutations(kadr, count):
    """Examples of all controls with a number changed: each picture lists as many numbers as the text."""
    random_ = random.Random(20261126)
    programs = [f for control in ('mach3', 'linuxcnc', 'nct', 's2c42', 'gost', 'correctors', 'fanuc', 'haas', 'grbl')
                for f in sorted((EXAMPLES / control).glob('*')) if f.suffix not in ('.json', '.toml', '.md', '.tbl', '.txt', '.svg', '.png')]
    made = 0
    while made < count:
        file = random_.choice(programs)
        try:
            text = file.read_text()
        except UnicodeDecodeError:
            continue
        numbers = list(re.finditer(r'(?<=[XYZABCF])-?\d+(\.\d+)?', text))
        if not numbers:
            continue
        m = random_.choice(numbers)
        other = kadr.folder / f'mutant{file.suffix}'
        other.write_text(text[:m.start()] + f'{float(m[0]) + random_.choice((0.01, 0.5, -30)):.3f}' + text[m.end():])
        setup = file.with_suffix('.json')
        plot = kadr.folder / 'm.svg'
        plot.unlink(missing_ok=True)
        got = kadr.run(file, other, '--control', file.parent.name, '--lang', 'en', '--plot', 'm.svg', *(['--setup', setup] if setup.exists() else []))
        name = f'{file.name} with {m[0]} at {m.start()} changed'
        expect(got.returncode in (0, 1) or (got.returncode == 2 and got.stderr), f'{name}: {got.returncode} {got.stderr[-300:]}')
        if got.returncode == 2:
            continue
        made += 1
        picture = Picture(plot)
        told = [line.split('.')[0] for line in got.stdout.splitlines() if re.match(r'\d+\. ', line)]
        expect([t for t in picture.texts_of('differences') if t.isdigit()] == told, f'{name}: numbers of the list')


def main():
    options = harness.arguments(__doc__)
    options.add_argument('--mutations', type=int, default=40)
    options.add_argument('--only', default='*', help='only checks whose name matches')
    args = harness.parsed(options)
    checks = {**harness.checks_of(globals()), 'mutations': lambda kadr: mutations(kadr, args.mutations)}
    for name, check in checks.items():
        if fnmatch.fnmatch(name, args.only):
            for fault in harness.in_a_folder(check, args.kadr, Kadr):
                expect(False, name, fault)
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
