"""Random programs of turning cycles for the control fanuc-t, system A, each with the moves that spec/fanuc-t demands of it.

A program is a few cycles one after another, so that the data that a cycle leaves behind (parameters, feed, values held) count too. What
each cycle leaves on the part is checked by stock.py, for which a Part is kept.
"""
import json
from dataclasses import dataclass, field

from lathe_twin import rough, straight
from lathe_twin.figures import Frame, Grid, random_figure
from lathe_twin.shapes import EPS


@dataclass
class Expected:
    """A move that must come: kind, end point (Z, X) mm, centre, sense, and where they are stated feed (mm/rev) and lead (mm)."""
    kind: str
    to: tuple
    centre: tuple = None
    ccw: bool = False
    feed: float = None
    lead: float = None


@dataclass
class Part:
    """A roughing in its frame, for the checks of stock.py: the first and last of its moves, the figure with the allowance, depth of a cut."""
    name: str
    first: int
    last: int
    pieces: list
    to_frame: object
    step: float
    whole: bool = True


@dataclass
class Program:
    chance: object
    grid: Grid
    setup: dict
    parameters: dict                                       # by number, mm or plain
    at: tuple = (0, 0)                                     # (Z, X) in steps
    feed: float = None
    lines: list = field(default_factory=list)
    moves: list = field(default_factory=list)
    parts: list = field(default_factory=list)
    names: list = field(default_factory=list)
    label: int = 0
    data_given: bool = False                               # the first block of G71 or G72 was there

    def text(self):
        return '\n'.join([*self.lines, 'M30', ''])

    def setup_text(self):
        return json.dumps(self.setup)

    # ---- writing

    def mm(self, steps):
        return steps * self.grid.unit

    def here(self):
        return self.grid.mm(*self.at)

    def word(self, letter, steps):
        return f'{letter}{self.grid.text(steps)} '

    def raw(self, letter, steps):
        """A word whose value has no point: P, Q, D count steps."""
        return f'{letter}{steps} '

    def position(self, z, x):
        """Goes to the start of a cycle."""
        self.lines.append(f'G0 {self.word("X", x)}{self.word("Z", z)}')
        self.at = (z, x)
        self.add([('rapid', self.here(), None, False)])

    def feed_word(self, always=False):
        """Writes an F, or leaves the one in force."""
        if self.feed is not None and not always and self.chance.random() < 0.3:
            return ''
        steps = self.chance.randint(5, 60) * (10 if not self.grid.inch else 4)
        self.feed = self.mm(steps)
        return self.word('F', steps)

    def add(self, moves, feed=None, lead=None, changed=None):
        """Adds moves that must come; `changed`: function from a point of the moves' frame to (Z, X), and whether the plane turns over."""
        function, over = changed or ((lambda p: p), False)
        for kind, to, centre, ccw in moves:
            self.moves.append(Expected(kind, function(to), centre and function(centre), ccw != over,
                                       feed if kind in ('feed', 'arc') else None, lead if kind == 'thread' else None))

    def signed(self, low, high):
        return self.chance.choice((1, -1)) * self.chance.randint(low, high)

    def target(self, letter, increment, now, to):
        """Writes the end of a move on one axis, absolute or incremental."""
        return self.word(increment, to - now) if self.chance.random() < 0.3 else self.word(letter, to)

    # ---- figures

    def figure_text(self, figure):
        """Writes the blocks of a figure with N numbers at both ends.  returns ns, nf"""
        ns, nf = self.label + 10, self.label + 10 * len(figure.blocks)
        self.label = nf
        for number, block in enumerate(figure.blocks):
            name = f'N{ns if number == 0 else nf} ' if number in (0, len(figure.blocks) - 1) else ''
            idle = ''
            if self.chance.random() < 0.15:
                steps = self.chance.randint(50, 400)
                idle, figure.feeds[number] = self.word('F', steps), self.mm(steps)
            self.lines.append(f'{name}{block}{idle}'.rstrip())
        return ns, nf

    def numbers(self, figure):
        """Returns ns and nf that figure_text will write."""
        return self.label + 10, self.label + 10 * len(figure.blocks)


def lowest(pieces):
    return min(piece.at(t)[1] for piece in pieces for t in (0, 1, *piece.extreme_shares(1)))


def deepest(pieces):
    return max(piece.at(t)[1] for piece in pieces for t in (0, 1, *piece.extreme_shares(1)))


def set_up(parameters):
    return {'axes': ['X', 'Z'], 'start': {'X': 300, 'Z': 100}, 'parameters': parameters, 'spindle': {'1': {'rpm': 1000, 'dir': 'cw'}}}


def roughing(p, main, two_axes):
    """Adds G71 or G72; type II with two_axes."""
    chance, grid = p.chance, p.grid
    while True:
        frame = Frame(main, chance.choice((1, -1)), chance.choice((1, -1)))
        start = (chance.randint(-20, 20) * 100, chance.randint(300, 900) * 200)
        ahead = chance.randint(1, 40) * 50 if two_axes and chance.random() < 0.15 else 0
        figure = random_figure(chance, grid, frame, start, two_axes, ahead)
        to_frame, over = frame.into(grid.mm(*start))
        pieces = [piece.mapped(to_frame, over) for piece in figure.pieces]
        if lowest(pieces) >= -EPS and lowest(figure.pieces) > 1:
            break
    p.position(*start)
    step = max(2, int(deepest(pieces) / grid.unit / chance.uniform(0.8, 9)))
    escape = chance.choice((0, 1, chance.randint(1, 12) * 50))
    allowance = tuple(chance.choice((0, sign * chance.randint(1, 10) * 50)) for sign in (chance.choice((1, 1, -1)), chance.choice((1, -1))))
    step = write_roughing(p, main, figure, step, escape, allowance)
    escape = p.parameters[5133]
    infeed = figure.first_kind
    delta = (p.mm(allowance[0]), p.mm(allowance[1]) / 2)
    origin = tuple(a + b for a, b in zip(grid.mm(*start), delta))
    last_pass = not p.parameters.get('N5105#2' if two_axes else 'N5105#1')
    p.add([('rapid', origin, None, False)])
    first = len(p.moves)
    home = frame.into(origin)[0](grid.mm(*start))
    made = rough.TypeTwo(pieces, step, escape, infeed).all(last_pass, home) if two_axes \
        else rough.type_one(pieces, step, escape, infeed, last_pass, home)
    p.add(made, p.feed, changed=(frame.out_of(origin), over))
    p.parts.append(Part(p.names[-1], first, len(p.moves), pieces, frame.into(origin), step, last_pass))
    p.add([('rapid', grid.mm(*start), None, False)])
    finish(p, figure)


def write_roughing(p, main, figure, step, escape, allowance):
    """Writes the cycle in one of its forms and the figure, and sets the data that stay."""
    chance = p.chance
    code = 'G71' if main == 'Z' else 'G72'
    ns, nf = p.numbers(figure)
    form = chance.random()
    depth, one_block = '', form < 0.25
    if form < 0.12 and p.data_given and p.mm(step) / 12 < p.parameters[5132]:
        one_block = False                                  # the data of the cycle before
    elif one_block:
        depth = p.raw('D', step) if chance.random() < 0.5 else p.word('D', step)
        p.data_given = False
    else:
        p.lines.append(f'{code} {p.word("U" if main == "Z" else "W", step)}{p.word("R", escape)}')
        p.parameters.update({5132: p.mm(step), 5133: p.mm(escape)})
        p.data_given = True
    step = p.mm(step) if one_block else p.parameters[5132]
    p.parameters.setdefault(5133, 0.0)
    rest = f'{p.word("I", 100)}{p.word("K", 50)}' if one_block and chance.random() < 0.3 else ''
    u = p.word('U', allowance[1]) if allowance[1] or chance.random() < 0.5 else ''
    w = p.word('W', allowance[0]) if allowance[0] or chance.random() < 0.5 else ''
    p.lines.append(f'{code} P{ns} Q{nf} {u}{w}{rest}{depth}{p.feed_word()}')
    p.names.append(f'{code} type {"II" if figure.both_axes else "I"}{" in one block" if one_block else ""}')
    p.figure_text(figure)
    return step


def finish(p, figure):
    """Adds G70 behind a cycle, with the feeds of the figure."""
    if p.chance.random() < 0.5:
        return
    nf = p.label
    ns = nf - 10 * (len(figure.blocks) - 1)
    p.lines.append(f'G70 P{ns} Q{nf} {p.feed_word(always=True)}')
    p.names.append('G70')
    made = rough.finishing(figure.first_kind, figure.pieces, p.here())
    for move, feed in zip(made[:-1], figure.feeds_from(p.feed)):
        p.add([move], feed)
    p.add(made[-1:])
    p.feed = None


def repeating(p):
    """Adds G73, and G70 at times."""
    chance, grid = p.chance, p.grid
    frame = Frame(chance.choice('ZX'), chance.choice((1, -1)), chance.choice((1, -1)))
    start = (chance.randint(-20, 20) * 100, chance.randint(300, 900) * 200)
    two = chance.random() < 0.7
    figure = random_figure(chance, grid, frame, start, two, chance.randint(1, 40) * 50 if two else 0)
    p.position(*start)
    count, relief, allowance = write_repeating(p, figure)
    made = rough.pattern(figure.first_kind, figure.pieces, p.here(), allowance, relief, count)
    p.add(made, p.feed)
    finish(p, figure)


def write_repeating(p, figure):
    chance = p.chance
    ns, nf = p.numbers(figure)
    count = chance.randint(1, 5)
    i, k, du, dw = (chance.choice((0, p.signed(1, 30) * 50)) for _ in range(4))
    if chance.random() < 0.3:
        data = f'{p.word("I", i)}{p.word("K", k)}'
        tail = f'D{count} '
        p.names.append('G73 in one block')
    else:
        form = chance.choice((f'{count}', f'{count}.', f'0.00{count}'))
        p.lines.append(f'G73 {p.word("U", i)}{p.word("W", k)}R{form}')
        data, tail = '', ''
        p.names.append('G73')
    p.lines.append(f'G73 P{ns} Q{nf} {data}{p.word("U", du)}{p.word("W", dw)}{tail}{p.feed_word()}')
    p.figure_text(figure)
    return count, (p.mm(k), p.mm(i)), (p.mm(dw), p.mm(du) / 2)


SEGMENTS = ((lambda p: roughing(p, 'Z', False), 5), (lambda p: roughing(p, 'Z', True), 6), (lambda p: roughing(p, 'X', False), 4), (lambda p: roughing(p, 'X', True), 2),
            (repeating, 3), (straight.single, 3), (straight.pecking, 3), (straight.multiple, 3))


def random_program(chance, only=None):
    """Returns a random program of one to three cycles; `only`: the number of a row of SEGMENTS."""
    grid = Grid(chance.random() < 0.25)
    parameters = {}
    for number, low, high in ((5133, 0, 500), (5139, 0, 300)):
        if chance.random() < 0.3:
            parameters[number] = chance.randint(low, high) * 0.001
    if chance.random() < 0.3:
        parameters[5130], parameters[5131] = chance.randint(1, 20), chance.choice((0, 30, 45, 60))
    setup = {f'N{number}': value for number, value in parameters.items()}
    for name in ('N5105#1', 'N5105#2'):
        if chance.random() < 0.05:
            setup[name] = parameters[name] = 1
    p = Program(chance, grid, set_up(setup), parameters)
    p.lines.append('G20' if grid.inch else 'G21')
    for _ in range(chance.choice((1, 1, 1, 2, 3))):
        work = SEGMENTS[only][0] if only is not None else chance.choices([s[0] for s in SEGMENTS], [s[1] for s in SEGMENTS])[0]
        work(p)
    return p
