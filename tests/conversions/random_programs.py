"""Random programs over the grammar of each control, nearly all of which end without an alarm. Used by tests/convert_random.py.

The program's actions are chosen first, as positions in mm; the control's grammar then decides how they are written: words and their
units, canned cycles, subprograms, loops.
"""
import json

FEW = 14  # pieces of a program


class Dialect:
    """The parts of a control's grammar that the programs use."""
    end, start, number, stop = '', '%', None, 'M30'
    lengths, work, sides, cycles, arcs_by_radius, planes, changes_tools, iso = 'H', ('G54', 'G55', 'G56'), True, True, True, True, True, True
    loop = sub = shift = None
    two_digits = False  # G01
    exact = ('G61', 'G64'), None  # exact stops: a modal code and the code that ends it, a non-modal code
    absolute_centres = False
    dwell = staticmethod(lambda seconds: f'G4 P{plain(seconds)}')

    def length(self, _axis, mm):
        return plain(mm)

    def feed(self, mm_per_min):
        return f'F{mm_per_min}'


def plain(value):
    return f'{value:.3f}'.rstrip('0').rstrip('.') if '.' in f'{value:.3f}' else f'{value:.3f}'


def with_point(value):
    text = plain(value)
    return text if '.' in text else text + '.'


class Mach3(Dialect):
    sub, shift, start = 'O', 'G52', None


class LinuxCnc(Dialect):
    sub, loop, shift = 'o', 'o', 'G92'


class Fanuc(Dialect):
    sub, loop, shift, start = 'O', 'WHILE', 'G52', '%\nO0001'
    exact = ('G61', 'G64'), 'G9'

    def length(self, _axis, mm):
        return with_point(mm)
    dwell = staticmethod(lambda seconds: f'G4 P{round(1000 * seconds)}')


class Haas(Fanuc):
    sub = 'N'

    def feed(self, mm_per_min):
        return f'F{mm_per_min}.'


class Nct(Fanuc):
    dwell = staticmethod(lambda seconds: f'G4 P{plain(seconds)}')


class Grbl(Dialect):
    start, lengths, sides, cycles, changes_tools, stop = None, None, False, False, False, 'M30'
    shift, exact = 'G92', (None, None)


class S2c42(Dialect):
    start, end, number, stop, lengths, cycles, arcs_by_radius, planes, iso = '%7 ПС', ' ПС', 'N{} ', 'M2', 'D', False, False, False, False
    sub, absolute_centres, exact = 'L', True, (None, 'G9')
    dwell = staticmethod(lambda seconds: f'G4 E{round(10 * seconds)}')

    def length(self, _axis, mm):
        return str(round(1000 * mm))


class Gost(Dialect):
    start, end, number, stop, cycles, arcs_by_radius, planes, two_digits, iso = '%7 LF', ' LF', 'N{} ', 'M02', False, False, False, True, False
    exact = None, 'G60'
    dwell = staticmethod(lambda seconds: f'G04 P{round(1000 * seconds)}')

    def length(self, axis, mm):
        return str(round(1000 * mm) if axis in 'XYIJ' else round(100 * mm))


class Correctors(Dialect):
    start, end, number, stop, lengths, cycles, arcs_by_radius, planes, two_digits = '% LF', ' LF', 'N{:03} ', 'M02', None, False, False, False, True
    work, sides, iso, exact = (), False, False, (None, None)
    dwell = None

    def length(self, _axis, mm):
        return with_point(mm)


DIALECTS = {'s2c42': S2c42, 'mach3': Mach3, 'correctors': Correctors, 'gost': Gost, 'nct': Nct, 'linuxcnc': LinuxCnc, 'fanuc': Fanuc, 'haas': Haas, 'grbl': Grbl}
PLANES = {17: ('X', 'Y', 'I', 'J'), 18: ('Z', 'X', 'K', 'I'), 19: ('Y', 'Z', 'J', 'K')}


def setup_of(control):
    """The work offsets, tools and start position that all programs of a control begin with."""
    setup = {'start': {'X': 0, 'Y': 0, 'Z': 100}}
    zeros = [{'X': 12, 'Y': -7.5, 'Z': 3}, {'X': -20, 'Y': 30, 'Z': 0}, {'X': 5, 'Y': 5, 'Z': -4.25}]
    if control == 's2c42':
        setup['zeros'] = {str(i + 1): zero for i, zero in enumerate(zeros)}
    elif control != 'correctors':
        setup['work_offsets'] = {f'G{54 + i}': zero for i, zero in enumerate(zeros)}
    if control not in ('correctors', 'grbl'):
        setup['offsets'] = {'1': {'length': 50, 'radius': 3}, '2': {'length': 62.5, 'radius': 1.5}}
    return json.dumps(setup)


class Program:
    def __init__(self, control, chance):
        self.of, self.chance = DIALECTS[control](), chance
        self.lines, self.tail, self.numbered = [], [], 0
        self.at = {'X': 0.0, 'Y': 0.0, 'Z': 50.0}
        self.plane, self.incremental, self.code, self.feed, self.subs = 17, False, '', 0, 0

    # ---- lines
    def say(self, *words, comment=''):
        text = ' '.join(str(word) for word in words if word)
        if self.of.two_digits:
            text = ' '.join(f'{word[0]}0{word[1]}' if len(word) == 2 and word[0] in 'GM' and word[1].isdigit() else word for word in text.split(' '))
        self.numbered += 5
        self.lines.append((self.of.number or '').format(self.numbered) + text + (f' ({comment})' if comment else '') + self.of.end)

    def word(self, axis, mm):
        return axis + self.of.length(axis, mm)

    def near(self, low=-40, high=40):
        return round(self.chance.uniform(low, high), self.chance.choice((0, 1, 2)))

    def to(self, **places):
        """Words of a motion to that position, by the distance mode in force."""
        words = []
        for axis, mm in places.items():
            words.append(self.word(axis, mm - self.at[axis] if self.incremental else mm))
            self.at[axis] = mm
        return words

    def motion(self, code):
        """Writes G0 and the like where the code changes, and sometimes repeats it."""
        says = code != self.code or self.chance.random() < 0.3
        self.code = code
        return code if says else ''

    def feed_word(self):
        if self.feed and self.chance.random() < 0.6:
            return ''
        self.feed = self.chance.choice((60, 80, 120, 150, 240, 300, 450))
        return self.of.feed(self.feed)

    # ---- pieces
    def begin(self):
        if self.of.start:
            self.lines += self.of.start.split('\n')
        self.say('G90 G17' if isinstance(self.of, Correctors) else 'G90 G17 G40' if self.of.sides or self.of.lengths else 'G21 G90 G17')
        if self.of.iso and self.of.sides:
            self.say('G21 G49 G80 G94' if self.of.cycles else 'G21 G94')
        elif isinstance(self.of, Gost):
            self.say('G80 G49 G94')
        if self.of.work:
            self.say(self.of.work[0])
        self.tool(1)
        self.say(self.motion('G0'), *self.to(X=0.0, Y=0.0))

    def tool(self, number):
        if self.of.changes_tools:
            two = isinstance(self.of, (Correctors, Gost))
            self.say(f'T{number:02}{number:02}' if two else f'T{number}', 'M6')
        self.say(f'S{self.chance.choice((600, 900, 1200))}', self.chance.choice(('M3', 'M3', 'M4')))
        if self.of.lengths:
            letter = self.of.lengths
            height = {'Z': 40.0 + number}
            number_word = f'{letter}{number:02}' if isinstance(self.of, Gost) else f'{letter}{number}'
            self.incremental_off()
            self.say(self.motion('G0'), 'G43', *(() if isinstance(self.of, S2c42) else (number_word,)), *self.to(**height), *((number_word,) if isinstance(self.of, S2c42) else ()))
        else:
            self.incremental_off()
            self.say(self.motion('G0'), *self.to(Z=40.0 + number))

    def incremental_off(self):
        if self.incremental:
            self.incremental = False
            self.say('G90')

    def line(self):
        code = self.chance.choice(('G0', 'G1', 'G1', 'G1'))
        axes = self.chance.sample('XYZ', self.chance.choice((1, 1, 2, 3)))
        words = self.to(**{axis: self.near() if axis != 'Z' else self.near(5, 30) for axis in sorted(axes)})
        self.say(self.motion(code), *words, self.feed_word() if code == 'G1' else '')

    def exact_stops(self):
        """Lines with an exact stop at their end, and one without."""
        mode, block = self.of.exact
        if not (mode or block):
            return
        by_mode = mode and (not block or self.chance.random() < 0.5)
        if by_mode:
            self.say(mode[0])
        for _ in range(self.chance.choice((1, 2, 3))):
            self.say('' if by_mode else block, self.motion('G1'), *self.to(X=self.near(), Y=self.near()), self.feed_word())
        if by_mode:
            self.say(mode[1])
        self.say(self.motion('G1'), *self.to(Z=self.near(5, 30)), self.feed_word())

    def distance_mode(self):
        self.incremental = not self.incremental
        self.say('G91' if self.incremental else 'G90')

    def arc(self):
        """Quarter, half and full circles: their ends are exact in any format."""
        if self.of.planes and self.chance.random() < 0.3:
            self.plane = self.chance.choice((17, 18, 19))
            self.say(f'G{self.plane}')
        first, second, i, j = PLANES[self.plane]
        radius = float(self.chance.choice((2, 5, 7.5, 12)))
        begin, quarters, clockwise = self.chance.randrange(4), self.chance.choice((1, 2, 3, 4)), self.chance.random() < 0.5
        unit = [(1, 0), (0, 1), (-1, 0), (0, -1)]
        centre = self.at[first] - radius * unit[begin][0], self.at[second] - radius * unit[begin][1]
        last = unit[(begin + (-quarters if clockwise else quarters)) % 4]
        end = {first: centre[0] + radius * last[0], second: centre[1] + radius * last[1]}
        from_here = centre[0] - self.at[first], centre[1] - self.at[second]
        if self.plane != 17:
            end = dict(sorted(end.items()))
        base = centre if self.of.absolute_centres and not self.incremental else from_here
        third = ({'X', 'Y', 'Z'} - {first, second}).pop()
        helix = {third: self.at[third] + 2} if quarters != 4 and not isinstance(self.of, S2c42) and self.chance.random() < 0.2 else {}
        words = self.to(**end, **helix)
        if self.of.arcs_by_radius and quarters in (1, 2, 3) and self.chance.random() < 0.3:
            by = [self.word('R', -radius if quarters == 3 else radius)]
        else:
            by = [self.word(i, base[0]), self.word(j, base[1])]
            by.sort()
        self.say(self.motion('G2' if clockwise else 'G3'), *words, *by, self.feed_word())

    def dwell(self):
        if self.of.dwell:
            self.say(self.of.dwell(self.chance.choice((0.2, 0.5, 1, 2.5))))

    def switch(self):
        code = self.chance.choice(('M8', 'M9', 'M3', 'M4', 'M5', 'M0', 'M1'))
        self.say(code)
        if code == 'M5':
            self.say(f'S{self.chance.choice((500, 800))}', 'M3')

    def comment(self):
        self.say(f'({self.chance.choice(("ROUGHING", "Finish, 0.2 left", "SEE DRAWING 7-12"))})')
        if self.of.number:
            self.lines[-1] = self.lines[-1].replace('  ', ' ')

    def change(self):
        if self.of.changes_tools:
            self.safe()
            self.tool(self.chance.choice((1, 2)))

    def work_zero(self):
        if len(self.of.work) > 1:
            self.safe()
            self.say(self.chance.choice(self.of.work))
            # The coordinates of this position have changed: the tool moves there again.
            self.say(self.motion('G0'), *self.to(X=self.near(), Y=self.near()))
            self.say(*self.to(Z=self.near(10, 30)))

    def safe(self):
        self.incremental_off()
        self.say(self.motion('G0'), *self.to(Z=60.0))

    def plane_xy(self):
        if self.plane != 17:
            self.plane = 17
            self.say('G17')

    def cycle(self):
        if not self.of.cycles:
            return
        self.incremental_off()
        self.plane_xy()
        kind = self.chance.choice(('G81', 'G82', 'G83', 'G73'))
        level = self.chance.choice(('G98', 'G99'))
        self.say('G0', *self.to(Z=30.0))
        depth, clear = self.near(-12, -2), self.near(2, 6)
        more = {'G82': [self.of.dwell(0.5).split()[1]], 'G83': [self.word('Q', 2)], 'G73': [self.word('Q', 1.5)]}.get(kind, [])
        places = [(self.near(), self.near()) for _ in range(self.chance.choice((1, 2, 4)))]
        self.say(level, kind, self.word('X', places[0][0]), self.word('Y', places[0][1]), self.word('Z', depth), self.word('R', clear), *more, self.of.feed(120))
        for x, y in places[1:]:
            self.say(self.word('X', x), self.word('Y', y))
        self.at.update(X=places[-1][0], Y=places[-1][1], Z=30.0 if level == 'G98' else clear)
        self.feed, self.code = 120, ''
        self.say('G80')
        self.say(self.motion('G0'), *self.to(Z=40.0))

    def contour(self):
        if not self.of.sides:
            return
        self.incremental_off()
        self.plane_xy()
        wide, high = float(self.chance.choice((20, 30))), float(self.chance.choice((16, 25)))
        left = self.chance.random() < 0.5
        x, y = self.near(-20, 0), self.near(-20, 0)
        self.safe()
        self.say(self.motion('G0'), *self.to(X=x - 15, Y=y - 15))
        self.say(*self.to(Z=5.0))
        self.say(self.motion('G1'), *self.to(Z=-2.0), self.feed_word())
        d = '' if isinstance(self.of, S2c42) else 'D01' if isinstance(self.of, Gost) else 'D1'
        corners = [(x, y + high), (x + wide, y + high), (x + wide, y)] if left else [(x + wide, y), (x + wide, y + high), (x, y + high)]
        self.say('G41' if left else 'G42', d, *self.to(X=x, Y=y), *(['D1'] if isinstance(self.of, S2c42) else []))
        for corner in corners:
            self.say(*self.to(X=corner[0], Y=corner[1]), self.feed_word())
        self.say(*self.to(X=x, Y=y))
        self.say('G40', *self.to(X=x - 15, Y=y - 15))
        if isinstance(self.of, S2c42):  # it cancels tool lengths as well (spec/s2c42 6)
            self.say(self.motion('G0'), 'G43', *self.to(Z=50.0), 'D1')
        self.safe()

    def body(self, axis='X'):
        """Steps that begin and end in the same modes, used in subprograms and loops."""
        return [f'G91 G1 {self.word(axis, 3)} {self.of.feed(150)}', f'{self.word("Z", -1)}', f'{self.word("Z", 1)}', 'G90']

    def repeated(self, times, axis):
        self.at[axis] += 3 * times
        self.code, self.feed, self.incremental = 'G1', 150, False

    def subprogram(self):
        kind, times = self.of.sub, self.chance.choice((1, 2, 3))
        if not kind:
            return
        self.subs += 1
        axis, number = self.chance.choice('XY'), 100 + self.subs
        if kind == 'L':
            lines = [f'N{self.subs:02}{i + 1:03} {text} ПС' for i, text in enumerate(self.body(axis) + ['M17'])]
            self.tail = self.tail + lines
            self.say(f'L{self.subs:02}{times:02}')
        elif kind == 'o':
            at = 1 if self.lines and self.lines[0] == '%' else 0
            self.lines[at:at] = [f'o{number} sub'] + [f'  {text}' for text in self.body(axis)] + [f'o{number} endsub']
            for _ in range(times):
                self.say(f'o{number} call')
        elif kind == 'N':
            self.tail += [f'N{number}'] + self.body(axis) + ['M99']
            self.say(f'M97 P{number}', f'L{times}')
        else:
            self.tail += [f'O{number}'] + self.body(axis) + ['M99']
            self.say(f'M98 P{number}', f'L{times}')
        self.repeated(times, axis)

    def loop(self):
        times, axis = self.chance.choice((2, 3)), self.chance.choice('XY')
        if self.of.loop == 'WHILE':
            self.lines += ['#101=0', f'WHILE[#101LT{times}]DO1', f'G1 G91 {axis}3. F150.', f'Z[#101-{times}]', f'Z[{times}-#101]', 'G90', '#101=#101+1', 'END1']
        elif self.of.loop == 'o':
            self.lines += ['#<n> = 0', f'o{10 + len(self.lines)} repeat [{times}]']
            label = self.lines[-1].split()[0]
            self.lines += [f'  {text}' for text in self.body(axis)] + ['  #<n> = [#<n> + 1]', f'{label} endrepeat']
        else:
            return
        self.repeated(times, axis)

    def shift(self):
        if not self.of.shift:
            return
        self.safe()
        if self.of.shift == 'G52':
            self.say('G52', self.word('X', 5), self.word('Y', -3))
            self.say(self.motion('G0'), *self.to(X=self.near(), Y=self.near()))
            self.say('G52', self.word('X', 0), self.word('Y', 0))
        else:
            self.say('G92', self.word('X', 5), self.word('Y', -3))
            self.at.update(X=5.0, Y=-3.0)
            self.say(self.motion('G0'), *self.to(X=self.near(), Y=self.near()))
            self.say('G92.1')
        self.say(self.motion('G0'), *self.to(X=self.near(), Y=self.near()))

    def end(self):
        self.safe()
        if self.chance.random() < 0.8:  # else the end of the program cancels it, or nothing does
            self.say('M5')
        self.say(self.of.stop)

    def text(self):
        pieces = [self.line] * 5 + [self.arc] * 3 + [self.distance_mode, self.dwell, self.switch, self.comment, self.change, self.work_zero, self.cycle, self.cycle,
                                                     self.contour, self.subprogram, self.loop, self.shift, self.exact_stops, self.exact_stops]
        self.begin()
        for _ in range(self.chance.randrange(3, FEW)):
            self.chance.choice(pieces)()
        self.end()
        if isinstance(self.of, S2c42) and self.tail:
            self.lines = ['L ПС'] + self.tail + [f'N{self.subs:02}006 M2 ПС'] + self.lines
        else:
            self.lines += self.tail
        return '\n'.join(self.lines) + '\n' + ('%\n' if self.of.start == '%' and isinstance(self.of, LinuxCnc) else '')


def program(control, chance):
    return Program(control, chance).text()
