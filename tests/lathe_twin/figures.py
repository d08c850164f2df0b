"""Random figures of the turning cycles: their blocks, and the contour that the blocks mean, corners broken.

A coordinate is a whole number of the program's least steps: Z in steps, X as a diameter in steps. `unit` is the length of a step in mm.
The shape is first drawn in the frame of the cycle (see rough.py): u along the cuts, d towards the first point.
"""
import math

from lathe_twin.shapes import Piece, centre_of, corner, leg_of

STRAIGHT = ('along', 'across', 'slope')


class Grid:
    """The coordinates of a program: whole steps to mm and to words."""

    def __init__(self, inch):
        self.inch = inch
        self.unit, self.decimals = (0.00254, 4) if inch else (0.001, 3)

    def mm(self, z, x):
        """Returns the point (Z, X as a radius) in mm."""
        return z * self.unit, x * self.unit / 2

    def text(self, steps):
        """Returns a length of whole steps as a word's value, with a point."""
        whole, rest = divmod(abs(steps), 10 ** self.decimals)
        digits = f'{rest:0{self.decimals}d}'.rstrip('0')
        return f'{"-" if steps < 0 else ""}{whole}.{digits}'


class Frame:
    """The signs of a cycle: `main` is 'Z' for G71 and 'X' for G72; ahead and down are the signs of u and d on their axes."""

    def __init__(self, main, ahead, down):
        self.main, self.ahead, self.down = main, ahead, down

    def whole(self, start, u, d):
        """Returns (Z, X) in steps, of u and d in steps of their axes."""
        if self.main == 'Z':
            return start[0] + self.ahead * u, start[1] + self.down * d
        return start[0] + self.down * d, start[1] + self.ahead * u

    def into(self, origin):
        """Returns the function from (Z, X) in mm to (u, d), and whether it turns the plane over."""
        if self.main == 'Z':
            return (lambda p: (self.ahead * (p[0] - origin[0]), self.down * (p[1] - origin[1]))), self.ahead * self.down < 0
        return (lambda p: (self.ahead * (p[1] - origin[1]), self.down * (p[0] - origin[0]))), self.ahead * self.down > 0

    def out_of(self, origin):
        """Returns the function from (u, d) to (Z, X) in mm."""
        if self.main == 'Z':
            return lambda p: (origin[0] + self.ahead * p[0], origin[1] + self.down * p[1])
        return lambda p: (origin[0] + self.down * p[1], origin[1] + self.ahead * p[0])


class Step:
    """A piece before it has coordinates: way in u and d in true steps, what it is, and how an arc bulges."""

    def __init__(self, kind, du, dd, radius=None, ccw=False, centre=None):
        self.kind, self.du, self.dd, self.radius, self.ccw, self.centre = kind, du, dd, radius, ccw, centre


def random_steps(chance, count, rising_only, room):
    """Returns random steps; `room`: the deepest point of figures with pockets, true steps."""
    steps, depth = [], room
    for _ in range(count):
        behind_a_wall = not steps or steps[-1].kind == 'across'      # a wall up and down in one place encloses nothing
        kinds = ['along', 'slope', 'slope', 'arc', 'quarter'] + ([] if behind_a_wall else ['across'])
        kind = chance.choice(kinds)
        du = chance.randint(2, 150) * 100 if chance.random() < 0.8 else chance.randint(150, 15000)
        dd = chance.randint(2, 60) * 50 if chance.random() < 0.8 else chance.randint(100, 3000)
        if kind == 'along' or kind == 'across':
            du, dd = (du, 0) if kind == 'along' else (0, dd)
        if kind == 'quarter':
            dd = du = min(du, dd)
        up = rising_only or chance.random() < 0.5
        if not rising_only:
            up, dd = turned_to_fit(up, dd, depth, room)
            if kind == 'quarter':
                du = dd
        dd = -dd if up else dd                             # d shrinks where the figure rises
        if kind in ('arc', 'quarter') and dd:
            steps.append(arc_step(chance, kind, du, dd, rising_only))
        elif du or dd:
            steps.append(Step('slope' if du and dd else 'along' if du else 'across', du, dd))
        depth += dd
    return steps


def turned_to_fit(up, dd, depth, room):
    """Keeps a figure with pockets between the start's level and the deepest point."""
    if up and depth - dd < 0:
        up = False
    if not up and depth + dd > room:
        up = True
    if up and depth - dd < 0:
        dd = depth - depth % 2
    return up, dd


def arc_step(chance, kind, du, dd, rising_only):
    ccw = chance.random() < 0.5
    if kind == 'quarter':
        return Step('quarter', du, dd, du, ccw)
    chord, slope = math.hypot(du, dd), math.atan2(abs(dd), du)
    # An arc turns by the angle asin(chord / 2R) to both sides of its chord, and may not turn back in u, nor in d if it only rises.
    free = min(slope, math.pi / 2 - slope) if rising_only else math.pi / 2 - slope
    least = chord / 2 / math.sin(free)
    return Step('arc', du, dd, math.ceil(least * chance.choice((1, 1.02, 1.3, 2.5))) + 1, ccw)


class Figure:
    """Blocks of text and the contour that they mean, from A' on, in (Z, X) mm."""

    def __init__(self, writer, first_kind, both_axes):
        self.blocks, self.pieces, self.block_of = writer.blocks, writer.pieces, writer.block_of    # block_of: a number a piece
        self.first_kind, self.both_axes = first_kind, both_axes
        self.feeds = {}                                    # F of a block, by its number, mm/rev

    def feeds_from(self, feed):
        """Returns the feeds of the motion to A' and of each piece in G70, where F is `feed` before."""
        of_blocks = []
        for number in range(len(self.blocks)):
            feed = self.feeds.get(number, feed)
            of_blocks.append(feed)
        return [of_blocks[0], *(of_blocks[number] for number in self.block_of)]


class Writer:
    """Writes the blocks of a figure and collects its pieces."""

    def __init__(self, chance, grid, start):
        self.chance, self.grid, self.at = chance, grid, start
        self.blocks, self.pieces, self.block_of, self.code = [], [], [], None

    def words(self, to, both=False):
        """Returns the words of an end point: of the axes that change, absolute or incremental."""
        text = ''
        for axis, absolute, increment in ((1, 'X', 'U'), (0, 'Z', 'W')):
            if to[axis] != self.at[axis] or both:
                by = self.chance.random() < 0.25
                text += f'{increment}{self.grid.text(to[axis] - self.at[axis])} ' if by else f'{absolute}{self.grid.text(to[axis])} '
        return text

    def coded(self, code):
        """Returns the code as a word; now and then nothing where it is in force."""
        if code == self.code and self.chance.random() < 0.6:
            return ''
        self.code = code
        zero = '0' if self.chance.random() < 0.3 else ''
        return f'G{zero}{code} '

    def first(self, code, to, both):
        self.blocks.append(self.coded(code) + self.words(to, both))
        self.at = to

    def line(self, to, corner_word=''):
        self.blocks.append(self.coded(1) + self.words(to) + corner_word)
        self.pieces.append(Piece(self.grid.mm(*self.at), self.grid.mm(*to)))
        self.block_of.append(len(self.blocks) - 1)
        self.at = to

    def arc(self, to, radius, ccw, centre=None):
        """`radius` in true steps; `centre` (Z, X) in mm with whole I and K, else R is written."""
        a, b = self.grid.mm(*self.at), self.grid.mm(*to)
        middle = centre or centre_of(a, b, radius * self.grid.unit, ccw)
        text = self.coded(3 if ccw else 2) + self.words(to)
        if centre:
            i, k = (round((middle[n] - a[n]) / self.grid.unit) for n in (1, 0))
            text += (f'I{self.grid.text(i)} ' if i else '') + (f'K{self.grid.text(k)} ' if k else '')
        else:
            text += f'R{self.grid.text(radius)} '
        self.blocks.append(text)
        self.pieces.append(Piece(a, b, middle, ccw))
        self.block_of.append(len(self.blocks) - 1)
        self.at = to

    def break_corners(self):
        """Breaks some corners between two lines, in the blocks and in the contour."""
        done, blocks = [], []
        waiting = list(zip(self.pieces, self.block_of))
        while waiting:
            piece, block = waiting.pop(0)
            word = self.corner_word(piece, waiting[0][0]) if waiting else None
            added = [piece]
            if word:
                text, kind, value = word
                self.blocks[block] += text
                before, middle, after = corner(piece, waiting[0][0], kind, value)
                added, waiting[0] = [before, middle], (after, waiting[0][1])
            done += added
            blocks += [block] * len(added)
        self.pieces, self.block_of = done, blocks

    def corner_word(self, before, after):
        """Returns (text, kind, value in mm) of a corner between two lines, or None."""
        chance = self.chance
        if before.c or after.c or chance.random() < 0.6:
            return None
        kind = chance.choice('CR')
        shorter = min(before.length(), after.length())
        room = shorter * 0.45 / max(leg_of(before, after, kind, 1.0), 1e-9)
        value = min(int(room / self.grid.unit), 3000)
        if value < 2 or parallel(before, after):
            return None
        value = chance.randint(1, value)
        return self.written(before, after, kind, value), kind, value * self.grid.unit

    def written(self, before, after, kind, value):
        z = abs(before.b[1] - before.a[1]) < 1e-9 and abs(after.b[0] - after.a[0]) < 1e-9      # Z, then X
        x = abs(before.b[0] - before.a[0]) < 1e-9 and abs(after.b[1] - after.a[1]) < 1e-9      # X, then Z
        if not (z or x) or self.chance.random() < 0.4:
            return f',{kind}{self.grid.text(value)} '
        sign = 1 if (after.b[1] > after.a[1] if z else after.b[0] > after.a[0]) else -1
        return f'{"R" if kind == "R" else "I" if z else "K"}{self.grid.text(sign * value)} '


def parallel(before, after):
    return abs((before.b[0] - before.a[0]) * (after.b[1] - after.a[1]) - (before.b[1] - before.a[1]) * (after.b[0] - after.a[0])) < 1e-9


def scaled(frame, steps, axis):
    """Returns true steps as steps of the axis: X counts diameters."""
    return 2 * steps if axis == 'X' else steps


def random_figure(chance, grid, frame, start, two_axes, ahead_of_start=0, code=None, corners=True):
    """Returns a random figure for a start point in steps. `two_axes`: with pockets (type II), ns names both axes; `ahead_of_start`: true
    steps from the start to A' along the cuts, type II only."""
    count = chance.randint(1, 7 if two_axes else 6)
    room = chance.randint(10, 160) * 50
    steps = random_steps(chance, count, not two_axes, room)
    while not any(step.du for step in steps):
        steps = random_steps(chance, count, not two_axes, room)
    high = 0 if two_axes or chance.random() < 0.5 else chance.randint(1, 60) * 50
    deep = room if two_axes else high - sum(step.dd for step in steps)
    across = 'X' if frame.main == 'Z' else 'Z'
    place = lambda u, d: frame.whole(start, scaled(frame, u, frame.main), scaled(frame, d, across))
    writer = Writer(chance, grid, start)
    code = chance.choice((0, 0, 0, 1)) if code is None else code
    u, d = ahead_of_start, deep
    writer.first(code, place(u, d), two_axes)
    flip = frame.into((0, 0))[1]
    for step in steps:
        u, d = u + step.du, d + step.dd
        to = place(u, d)
        if step.kind in STRAIGHT:
            writer.line(to)
        else:
            ccw = step.ccw != flip
            centre = quarter_centre(grid, writer.at, to, ccw) if step.kind == 'quarter' else None
            writer.arc(to, step.radius, ccw, centre)
    if corners:
        writer.break_corners()
    return Figure(writer, 'feed' if code else 'rapid', two_axes)


def quarter_centre(grid, at, to, ccw):
    """Returns the centre of a quarter of a circle, one of the corners of the square between its ends."""
    a, b = grid.mm(*at), grid.mm(*to)
    for c in ((a[0], b[1]), (b[0], a[1])):
        turn = (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])
        if (turn > 0) == ccw:
            return c
    raise AssertionError('no quarter')
