#!/usr/bin/env python3
"""Tests the extents in the summary and the picture of `kadr run --plot`: they agree; work systems, inches and rotary axes are
distinguished; no part of the contour is cropped; strokes name their lines; any file name gives a well-formed SVG. Expected numbers are
worked out by hand.

    run_pictures.py --kadr build/kadr [--only 'inch*']

Each check_… function is one check and works in a folder of its own.
Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import os
import re
import sys
import xml.etree.ElementTree as ET

import harness
from harness import Failure, expect

NS = '{http://www.w3.org/2000/svg}'
HEAD = 'G21 G90 G17 G40 G54\n'


class Picture:
    """A parsed SVG."""

    def __init__(self, path):
        self.root = ET.parse(path).getroot()
        self.size = path.stat().st_size
        self.texts = [''.join(e.itertext()) for e in self.root.iter(NS + 'text')]
        self.title = self.root.findtext(NS + 'title')
        self.description = self.root.findtext(NS + 'desc')

    def view(self, name):
        return next((g for g in self.root.iter(NS + 'g') if g.get('id') == 'view-' + name), None)

    def strokes(self, view, kind):
        """Each path of that type: its line, and its points."""
        found = []
        for group in self.view(view).iter(NS + 'g'):
            if group.get('class') == kind:
                found += [(path.get('data-line'), points_of(path)) for path in group.findall(NS + 'path')]
        return found

    def field(self, view):
        """The rectangle that the view is clipped to."""
        rect = next(self.view(view).iter(NS + 'clipPath')).find(NS + 'rect')
        x, y, w, h = (float(rect.get(k)) for k in ('x', 'y', 'width', 'height'))
        return x, y, x + w, y + h


def points_of(path):
    numbers = [float(n) for n in re.findall(r'-?[0-9.]+', path.get('d'))]
    return list(zip(numbers[::2], numbers[1::2]))


class Kadr(harness.Kadr):
    def run(self, text, *options, control='mach3', name='p.nc', lang='en', status=0, plot='out.svg'):
        """Returns the summary as lines, and the picture."""
        path = os.path.join(os.fsencode(self.folder), os.fsencode(name))
        with open(path, 'wb') as file:
            file.write(text.encode())
        done = super().run('run', path, '--control', control, '--lang', lang, '--plot', self.folder / plot, *options, expected=status)
        picture = Picture(self.folder / plot) if plot.endswith('.svg') else None
        return [' '.join(line.split()) for line in done.stdout.splitlines()], picture


def has_lines(summary, *lines):
    for line in lines:
        expect(line in summary, f'no line "{line}" in {summary}')


PLATE = HEAD + 'G0 X5 Y5 Z2\nG1 Z-3 F200\nX45 F600\nG3 X45 Y25 I0 J10\nG1 X5\nG0 Z50\nM30\n'


def check_summary_and_caption_are_the_same(kadr):
    """The half circle about (45, 15) of radius 10 reaches X 55, to the last digit."""
    summary, picture = kadr.run(PLATE)
    has_lines(summary, 'cutting, mm X 5 … 55 Y 5 … 25 Z -3 … 2', 'all, mm X 0 … 55 Y 0 … 25 Z -3 … 50')
    captions = [' '.join(t.split()) for t in picture.texts]
    expect(any(c.endswith('cutting, mm: X 5 … 55 Y 5 … 25 Z -3 … 2') for c in captions), captions[:4])
    for size in ('X 5 … 55', 'Y 5 … 25', 'Z -3 … 2'):
        expect(size in captions, f'{size} at the edges of the box: {captions}')


def check_a_probe_does_not_cut(kadr):
    program = HEAD + 'G0 Z5\nG31 Z-20 F100\nG0 Z5\nG1 X10 F100\nM30\n'
    (kadr.folder / 's.json').write_text('{"probe": [{"at": {"Z": -7}}]}')
    try:
        summary, _ = kadr.run(program, '--setup', 's.json')
    except Failure:
        summary, _ = kadr.run(program.replace('G31 Z-20 F100\n', 'G0 Z-7\n'))
    has_lines(summary, 'cutting, mm X 0 … 10 Y 0 … 0 Z 5 … 5', 'all, mm X 0 … 10 Y 0 … 0 Z -7 … 5')


def check_work_systems_are_told_apart(kadr):
    """No set-up states a work offset: both systems coincide, but the drawing shows two."""
    part = 'G0 X0 Y0 Z5\nG1 Z-2 F200\nX{}\nG0 Z5\n'
    program = 'G21 G90\nG54\n' + part.format(30) + 'G55\n' + part.format(70) + 'M30\n'
    for options in ((), ('--zero', 'G55=X200,Y0,Z0')):
        summary, picture = kadr.run(program, *options)
        has_lines(summary, 'cutting, mm G54 X 0 … 30 Y 0 … 0 Z -2 … 5', 'G55 X 0 … 70 Y 0 … 0 Z -2 … 5')
        caption = next(' '.join(t.split()) for t in picture.texts if 'G55' in t)
        expect('G54 X 0 … 30' in caption and 'G55 X 0 … 70' in caption, caption)
    summary, _ = kadr.run('G54.1 P7\n' + part.format(9) + 'G54\n' + part.format(8) + 'M30\n', control='nct')
    has_lines(summary, 'cutting, mm G54.1 P7 X 0 … 9 Y 0 … 0 Z -2 … 5', 'G54 X 0 … 8 Y 0 … 0 Z -2 … 5')
    summary, _ = kadr.run(program.replace('G55', 'G59 P40'))
    has_lines(summary, 'G59 P40 X 0 … 70 Y 0 … 0 Z -2 … 5')
    summary, _ = kadr.run('G90 G54\n' + part.format(9) + 'M30\n', control='nct')
    has_lines(summary, 'cutting, mm X 0 … 9 Y 0 … 0 Z -2 … 5')


def check_inch_programs_are_told_in_inches(kadr):
    """2 in along X, 1.5 in along Y, 1.1 in down; up again 1.1 in at rapid."""
    program = 'G20 G90 G17 G54\nG0 X0 Y0 Z1\nG1 Z-.1 F10\nX2\nY1.5\nG0 Z1\nM30\n'
    summary, picture = kadr.run(program)
    has_lines(summary, 'path, in cutting 4.6, rapid 2.1', 'cutting, in X 0 … 2 Y 0 … 1.5 Z -0.1 … 1', 'all, in X 0 … 2 Y 0 … 1.5 Z -0.1 … 1')
    expect(any(re.fullmatch(r'[0-9.]+ in', t) for t in picture.texts), picture.texts)
    expect('1.5' in picture.texts and '50' not in picture.texts, picture.texts)
    summary, _ = kadr.run(program, lang='ru')
    has_lines(summary, 'путь, дюймы резание 4.6, быстрый ход 2.1')
    summary, _ = kadr.run(program.replace('G20', 'G20 G43 H1').replace('G43 H1 ', ''), control='nct')
    has_lines(summary, 'cutting, in X 0 … 2 Y 0 … 1.5 Z -0.1 … 1')
    _, picture = kadr.run(program, '--plot-speed', 'speed.svg')
    texts = Picture(kadr.folder / 'speed.svg').texts
    expect('speed along the path, in/min' in texts and '10' in texts, texts)


def check_mixed_units_are_said(kadr):
    program = 'G20 G90 G17\nG1 X1 F10\nG21\nG1 X30 F300\nM30\n'
    summary, _ = kadr.run(program)
    has_lines(summary, 'units mm; the program cuts both in inches and in millimetres', 'cutting, mm X 0 … 30 Y 0 … 0 Z 0 … 0')
    summary, _ = kadr.run(program, lang='ru')
    has_lines(summary, 'единицы мм; УП режет и в дюймах, и в миллиметрах')
    summary, _ = kadr.run('G20 G0 X1\nG21\nG1 X30 F300\nM30\n')
    expect(not any('units' in line for line in summary), f'only millimetres cut: {summary}')


def check_rotary_axes_have_ranges(kadr):
    program = HEAD + 'G0 X0 A-10\nG1 X10 A90 F500\nG0 A360\nM30\n'
    summary, _ = kadr.run(program)
    has_lines(summary, 'cutting, mm X 0 … 10 Y 0 … 0 Z 0 … 0 A -10 … 90°', 'all, mm X 0 … 10 Y 0 … 0 Z 0 … 0 A -10 … 360°')


def check_start_end_and_stop(kadr):
    _, picture = kadr.run(PLATE)
    for view in ('isometric', 'xy', 'xz', 'yz'):
        expect(picture.strokes(view, 'end') and picture.strokes(view, 'start') and not picture.strokes(view, 'stop'), view)
    expect('start' in picture.texts and 'end' in picture.texts, picture.texts)
    _, picture = kadr.run(HEAD + 'G1 X20 F300\nY10\nG2 X900 Y0 I3 J0\nM30\n', status=1)
    expect([line for line, _ in picture.strokes('xy', 'stop')] == ['4'] * 4 and not picture.strokes('xy', 'end'), 'stop at line 4')
    expect('stopped by an alarm: line 4' in picture.texts and 'end' not in picture.texts, picture.texts)
    # position: the end of line 3, the upper right corner of the path
    corner = [p for line, points in picture.strokes('xy', 'feed') if line == '3' for p in points][-1]
    cross = [p for _, points in picture.strokes('xy', 'stop') for p in points]
    middle = [sum(p[k] for p in cross) / len(cross) for k in (0, 1)]
    expect(max(abs(middle[k] - corner[k]) for k in (0, 1)) < 0.02, f'{middle} is not {corner}')
    _, picture = kadr.run('G1 Q5\nM30\n', status=1, lang='ru')
    expect('останов по ошибке: строка 1' in picture.texts and 'нет движений' in picture.texts, picture.texts)


def check_nothing_of_the_contours_is_cut_off(kadr):
    square = 'G0 Z50\nG0 X{0} Y{0}\nG1 Z-5 F200\n{1} D1 X0 Y0\nX40\nY40\nX0\nY0\nG40 X{0} Y{0}\nG0 Z50\nX{2} Y{2}\nM30\n'
    for side, away, radius, far in (('G42', -40, 2, 0), ('G42', -90, 30, 60), ('G41', 20, 5, 60), ('G41', 20, 5, 900)):
        _, picture = kadr.run(HEAD + square.format(away, side, far), '--tool', f'1:r{radius}')
        kinds = ('contour', 'feed', 'arc') + (('rapid',) if far < 100 else ())
        for view in ('isometric', 'xy', 'xz', 'yz'):
            left, top, right, bottom = picture.field(view)
            for kind in kinds if far < 100 or view != 'isometric' else kinds:
                strokes = picture.strokes(view, kind)
                expect(strokes or kind == 'arc', f'{side} {view}: no {kind}')
                outside = [p for _, points in strokes for p in points if not (left <= p[0] <= right and top <= p[1] <= bottom)]
                expect(not outside, f'{side} r{radius} far {far}, {view} {kind}: {outside[:3]} beyond {left} {top} {right} {bottom}')
        expect(('rapid motion goes on beyond the picture' in picture.texts) == (far > 100), f'far {far}: {picture.texts[-4:]}')


def check_strokes_tell_their_lines(kadr):
    _, picture = kadr.run(HEAD + 'G0 Z5\nG1 X40 F600\nY20\nX0\nM98 P100 L2\nM30\nO100\nG1 Y0\nX9\nM99\n')
    by_line = {line: points for line, points in picture.strokes('xy', 'feed')}
    expect(set(by_line) == {'3', '4', '5', '9', '10'}, set(by_line))

    def way(line):
        (x, y), (u, v) = by_line[line][0], by_line[line][-1]
        return ((u - x) ** 2 + (v - y) ** 2) ** 0.5
    expect(abs(way('3') - 2 * way('4')) < 0.1, f"line 3 is 40 long, line 4 20: {way('3')}, {way('4')}")
    ids = [e.get('id') for e in picture.root.iter() if e.get('id')]
    expect(len(ids) == len(set(ids)), 'an id stands twice')
    expect({'l2', 'l3', 'l4', 'l5', 'l9', 'l10'} <= set(ids), ids)
    (kadr.folder / 'O77').write_text('%\nO77\nG1 X5 F100\nM99\n%\n')
    (kadr.folder / 'O0077.nc').write_text('%\nO0077\nG1 X5 F100\nM99\n%\n')
    _, picture = kadr.run('G90 G1 Y9 F100\nM98 P77\nM30\n', control='nct')
    called = [e for e in picture.root.iter(NS + 'path') if e.get('data-file')]
    expect(called and called[0].get('data-file') in ('O77', 'O0077.nc') and called[0].get('data-line') == '3', 'the line of a called file')
    expect(any(re.fullmatch('s[1-9][0-9]*l3', e.get('id', '')) for e in picture.root.iter()), 'its id')


def check_long_programs(kadr):
    """Up to 10,000 strokes name their lines; with more none does, and a message says so; the file stays small."""
    def zigzag(n):
        return HEAD + ''.join(f'G1 X{i % 2 * 50} Y{i * 0.01:.2f} F900\n' for i in range(n)) + 'M30\n'
    _, picture = kadr.run(zigzag(9000), '-q')
    expect(sum(1 for line, _ in picture.strokes('xy', 'feed') if line) == 9000 and 'data-line' in picture.description, 'lines of 9,000')
    _, picture = kadr.run(zigzag(60000), '-q')
    expect(not any(e.get('data-line') for e in picture.root.iter(NS + 'path') if e.get('class') != 'start' and e.get('id')), 'no ids')
    expect(not any(line for line, _ in picture.strokes('xy', 'feed')) and 'too many' in picture.description, picture.description)
    expect(picture.size < 8e6, f'{picture.size} bytes')


def check_any_file_name(kadr):
    """A name of bytes: control characters, XML markup, invalid UTF-8, characters that XML forbids."""
    names = {b'a<b>&"c\'.nc': 'a<b>&"c\'.nc', b'bell\x07\x1b[1m.nc': 'bell␇␛[1m.nc', b'\xff\xfe\xc0\x80.nc': '����.nc',
             b'\xed\xa0\x80.nc': '�.nc', b'\xef\xbf\xbf.nc': '�.nc', 'деталь №1.nc'.encode(): 'деталь №1.nc', b'two\nlines.nc': 'two␊lines.nc'}
    for name, shown in names.items():
        _, picture = kadr.run(PLATE, name=name)
        expect(picture.title == shown and picture.texts[0] == shown, f'{name}: {picture.title!r}, {picture.texts[0]!r}, expected {shown!r}')
        kadr.run(PLATE, name=name, plot='out.png')
        head = (kadr.folder / 'out.png').read_bytes()
        expect(head[:4] == b'\x89PNG' and len(head) > 20_000, f'{name}: the PNG is empty ({len(head)} bytes)')


def check_texts_in_both_languages(kadr):
    contour = PLATE.replace('G1 X5\nG0 Z50', 'G1 G41 D1 X20\nX5\nG40 Y0\nG0 Z50')
    words = {'en': ('rapid', 'feed', 'arc', 'plunge', 'contour as programmed', 'work zero', 'start', 'end'),
             'ru': ('быстрый ход', 'рабочая подача', 'дуга', 'врезание', 'контур по УП', 'нуль детали', 'начало', 'конец')}
    for lang, all_of in words.items():
        _, picture = kadr.run(contour, '--tool', '1:r1', lang=lang)
        for word in all_of:
            expect(word in picture.texts, f'{lang}: no "{word}" in {picture.texts}')
        expect(picture.root.get('{http://www.w3.org/XML/1998/namespace}lang') == lang, 'the language of the page')


if __name__ == '__main__':
    sys.exit(harness.main(__doc__, globals(), Kadr))
