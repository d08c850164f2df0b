"""Cycles with nose radius compensation, G41 or G42 before the block of the cycle (spec/fanuc-t 7, 9.11): what the nose leaves, whatever path
the control has found.

Checked of G71, G72 and G70: the nose never cuts into the figure with its allowance; the last pass touches each place of it that the nose
can reach; the passes of a roughing are those of the slow reference for the figure of the last pass.
"""
import itertools
import math

from lathe_twin import programs, rough
from lathe_twin.figures import Frame, Grid, random_figure
from lathe_twin.shapes import EPS, Piece

TIPS = {(1, 1): 1, (-1, 1): 2, (-1, -1): 3, (1, -1): 4}    # signs of the tip from the nose's centre along Z, X
TOLERANCE = 2e-5
REFUSED = (33, 39, 41)      # no intersection, a corner at the start-up, interference: the figure has no room for the nose
SAMPLES = 10                # places a piece


class NoseProgram:
    """A program of one cycle in G41 or G42, and what is known of it."""

    def __init__(self, chance):
        grid, self.radius = Grid(chance.random() < 0.2), chance.choice((0.2, 0.4, 0.8))
        self.two_axes, self.finishing = chance.random() < 0.4, chance.random() < 0.3
        main = 'Z' if self.two_axes or chance.random() < 0.6 else 'X'
        while True:
            self.frame = Frame(main, chance.choice((1, -1)), chance.choice((1, -1)))
            start = (chance.randint(-20, 20) * 100, chance.randint(300, 900) * 200)
            self.figure = random_figure(chance, grid, self.frame, start, self.two_axes, code=0)
            to_frame, self.over = self.frame.into(grid.mm(*start))
            pieces = [piece.mapped(to_frame, self.over) for piece in self.figure.pieces]
            high = programs.lowest(pieces) >= -EPS and programs.lowest(self.figure.pieces) > 1
            if high and pieces[0].a[1] > 3 * self.radius and room_for(pieces, self.radius):
                break
        self.crest = programs.lowest(pieces)
        ahead_down = (self.frame.ahead, self.frame.down) if main == 'Z' else (self.frame.down, self.frame.ahead)
        tip = TIPS[ahead_down] if chance.random() < 0.8 else chance.choice((0, 9))
        self.tip = tuple(self.radius * sign for sign in ahead_down) if tip in TIPS.values() else (0.0, 0.0)
        setup = {**programs.set_up({}), 'offsets': {'1': {'radius': self.radius, 'tip': tip}}}
        self.program = p = programs.Program(chance, grid, setup, {})
        p.lines += ['G20' if grid.inch else 'G21', 'T0101']
        p.position(*start)
        p.lines.append('G41' if self.over else 'G42')      # the tool is on the shallow side: right of the cut unless the plane is turned over
        self.start = p.here()
        (self.write_finishing if self.finishing else self.write_roughing)(chance, p, main, programs.deepest(pieces))
        if not self.finishing:
            p.lines.append('G40')

    def write_roughing(self, chance, p, main, deep):
        step, escape = max(2, int(deep / p.grid.unit / chance.uniform(0.8, 6))), chance.randint(1, 12) * 50
        w, u = (chance.choice((0, sign * chance.randint(1, 10) * 20)) for sign in (-self.frame_sign('Z'), -self.frame_sign('X')))
        self.step = programs.write_roughing(p, main, self.figure, step, escape, (w, u))
        self.escape = p.parameters[5133]
        self.allowance = p.mm(w), p.mm(u) / 2

    def write_finishing(self, _, p, _main, _deep):
        ns, nf = p.numbers(self.figure)
        p.lines += [f'G70 P{ns} Q{nf} {p.feed_word(always=True)}', 'G40', 'M30']
        p.figure_text(self.figure)
        p.names.append('G70')
        self.allowance = 0.0, 0.0

    def frame_sign(self, axis):
        return self.frame.ahead if self.frame.main == axis else self.frame.down

    def may_be_refused(self):
        """Returns the numbers of the alarms that the program may end with: PS0322, PS0328 if the nose, but not the figure, passes S."""
        return (*REFUSED, 322, 328) if self.crest < 2 * self.radius else REFUSED

    def faults(self, motions):
        """Returns what is wrong with the motions (kind, (Z, X), centre, ccw, action) of a run."""
        begin = next((n for n, one in enumerate(motions) if math.dist(one[1], self.start) < 1e-6), None)
        if begin is None or math.dist(motions[-1][1], self.start) > 1e-6:
            return ['the start of the cycle is not reached twice']
        ours = motions[begin:]
        wanted = [piece.mapped(lambda p: (p[0] + self.allowance[0], p[1] + self.allowance[1]), False) for piece in self.figure.pieces]
        path = [Piece(self.nose(a[1]), self.nose(b[1]), b[2] and self.nose(b[2]), b[3]) for a, b in zip(ours, ours[1:])]
        return self.cuts_into(path, wanted, self.last_pass(ours)[0] - 1) or self.leaves(path, ours, wanted) or self.other_passes(ours)

    def nose(self, tip):
        return tip[0] - self.tip[0], tip[1] - self.tip[1]

    def cuts_into(self, path, wanted, start_up):
        """Checks each motion; the way home only against the figure itself, as S may lie inside the allowance, and not at all of G70; nor
        the start-up, which leads from where the program puts the tool."""
        for number, piece in enumerate(path):
            if number == start_up:
                continue
            home = number == len(path) - 1
            if home and self.finishing:
                break
            wanted = self.figure.pieces if home else wanted
            for n in range(SAMPLES + 1):
                at = piece.at(n / SAMPLES)
                near = min(distance(at, one) for one in wanted)
                if near < self.radius - TOLERANCE:
                    return [f'motion {number}: the nose is {self.radius - near:.5f} in the figure at Z{at[0]:.4f} X{at[1]:.4f}']
        return []

    def leaves(self, path, ours, wanted):
        """Checks the last pass: each place of the figure that the nose can reach is touched."""
        last = path[self.last_pass(ours)[0]:self.last_pass(ours)[1]]
        for piece in wanted:
            for n in range(SAMPLES + 1):
                at, away = piece.at(n / SAMPLES), self.outwards(piece, n / SAMPLES)
                centre = at[0] + self.radius * away[0], at[1] + self.radius * away[1]
                if min(distance(centre, one) for one in wanted) < self.radius - 1e-6:
                    continue                               # the nose cannot be there
                near = min(distance(at, one) for one in last)
                if near > self.radius + TOLERANCE:
                    return [f'the nose stays {near - self.radius:.5f} off the figure at Z{at[0]:.4f} X{at[1]:.4f}']
        return []

    def outwards(self, piece, t):
        """Returns the normal of a piece on the side of the tool."""
        if piece.c is None:
            x, y = piece.b[0] - piece.a[0], piece.b[1] - piece.a[1]
        else:
            at = piece.at(t)
            x, y = at[1] - piece.c[1], piece.c[0] - at[0]
            if piece.ccw:
                x, y = -x, -y
        size = math.hypot(x, y)
        return (-y / size, x / size) if self.over else (y / size, -x / size)

    @staticmethod
    def last_pass(ours):
        """Returns the first and the last of the pieces of the pass along the figure, one behind the last."""
        end = len(ours) - 1
        while end > 0 and ours[end][0] == 'rapid':
            end -= 1
        begin = end
        while begin > 0 and ours[begin][0] != 'rapid':
            begin -= 1
        return begin, end

    def other_passes(self, ours):
        """Compares a roughing with the reference's for the figure of the last pass."""
        if self.finishing:
            return []
        origin = tuple(a + b for a, b in zip(self.start, self.allowance))
        to_frame, over = self.frame.into(origin)
        begin, end = self.last_pass(ours)
        figure = [Piece(to_frame(a[1]), to_frame(b[1]), b[2] and to_frame(b[2]), b[3] != over) for a, b in zip(ours[begin:end], ours[begin + 1:end + 1])]
        figure = joined(figure)
        if on_a_level(figure, self.step):
            return []                                      # the last digit of the trace would decide
        home = to_frame(self.start)
        made = rough.TypeTwo(figure, self.step, self.escape, 'rapid').all(home=home) if self.two_axes \
            else rough.type_one(figure, self.step, self.escape, 'rapid', home=home)
        mapped = [(kind, to_frame(to), centre and to_frame(centre), ccw != over) for kind, to, centre, ccw, _ in ours[1:-1]]
        got, want = as_one([('rapid', (0.0, 0.0), None, False), *mapped]), as_one([('rapid', (0.0, 0.0), None, False), *made])
        for number, (have, one) in enumerate(itertools.zip_longest(got, want)):
            if not have or not one or have[0] != one[0] or math.dist(have[1], one[1]) > 5e-5:
                return [f'pass motion {number}: {have}, wanted {one}']
        return []


def as_one(moves):
    """Leaves out moves of no length, and joins the parts of an arc. The first move counts as made."""
    done = moves[:1]
    for kind, to, centre, ccw in moves[1:]:
        before = done[-1]
        if kind != 'arc' and math.dist(to, before[1]) < 1e-7:
            continue
        goes_on = kind == 'arc' == before[0] and math.dist(centre, before[2]) < 1e-5 and ccw == before[3]
        done[len(done) - goes_on:] = [(kind, to, centre, ccw)]
    return done


def on_a_level(pieces, step):
    """True if the figure turns or begins at the depth of a level, or of C."""
    depths = [piece.at(t)[1] for piece in pieces for t in (0, *piece.extreme_shares(1))]
    return any(abs(depth - step * round(depth / step)) < 1e-6 for depth in depths)


def joined(pieces):
    """Joins the parts of an arc."""
    done = []
    for piece in pieces:
        before = done[-1] if done else None
        if before and piece.c and before.c and math.dist(piece.c, before.c) < 1e-6 and piece.ccw == before.ccw:
            done[-1] = Piece(before.a, piece.b, before.c, before.ccw)
        else:
            done.append(piece)
    return done


def room_for(pieces, radius):
    """True if no piece is so short, no arc so narrow and no corner so sharp that the nose would not fit between its neighbours. Nor may the
    figure begin with a pocket: the nose cannot reach its edge A' and, in the same pass, its wall."""
    if pieces[0].at(1e-4)[1] > pieces[0].a[1] + 1e-9:
        return False
    sharp = any(cosine(a.at(1 - 1e-6), a.b, b.at(1e-6)) < -0.5 for a, b in zip(pieces, pieces[1:]))
    return not sharp and all(piece.length() > 2.5 * radius and (piece.c is None or piece.radius() > 2 * radius) for piece in pieces)


def cosine(before, at, behind):
    """Returns the cosine of the angle by which a path turns."""
    one, two = (at[0] - before[0], at[1] - before[1]), (behind[0] - at[0], behind[1] - at[1])
    return (one[0] * two[0] + one[1] * two[1]) / math.hypot(*one) / math.hypot(*two)


def distance(point, piece):
    """Returns the distance of a point from a piece."""
    ends = min(math.dist(point, piece.a), math.dist(point, piece.b))
    if piece.c is None:
        x, y = piece.b[0] - piece.a[0], piece.b[1] - piece.a[1]
        square = x * x + y * y
        t = ((point[0] - piece.a[0]) * x + (point[1] - piece.a[1]) * y) / square if square else 0
        return ends if not 0 < t < 1 else math.dist(point, (piece.a[0] + t * x, piece.a[1] + t * y))
    first, sweep = piece.angles()
    angle = math.atan2(point[1] - piece.c[1], point[0] - piece.c[0])
    turned = (angle - first) % (2 * math.pi) if sweep > 0 else (first - angle) % (2 * math.pi)
    return min(ends, abs(math.dist(point, piece.c) - piece.radius())) if turned < abs(sweep) else ends
