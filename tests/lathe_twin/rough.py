"""The slow reference of the roughing cycles, written from the language's description alone (spec/fanuc-t 9.2 to 9.6). It knows nothing of
the program under test.

The roughing of G71 and G72 is worked out in its own frame: C, the start of the cycle moved by the allowance, is (0, 0); u runs along the
cuts, d towards the figure's first point. A move is (kind, point, centre, ccw): kind 'rapid', 'feed' or 'arc'.
"""
from lathe_twin.shapes import EPS, Path

DEEPEST = 10_000      # levels; it only ends a faulty reference


class Moves:
    """A list of moves that knows where it stands."""

    def __init__(self, at):
        self.at, self.list = at, []

    def go(self, kind, u=None, d=None):
        self.at = (self.at[0] if u is None else u, self.at[1] if d is None else d)
        self.list.append((kind, self.at, None, False))

    def along(self, pieces):
        for piece in pieces:
            self.at = piece.b
            self.list.append(('feed' if piece.c is None else 'arc', piece.b, piece.c, piece.ccw))

    def along_the_figure(self, path, infeed, home):
        """The pass along the figure. Beyond the words of 9.2, the tool first moves out to C where the straight way to S, `home`, would lead
        through a crest of the figure, or through the stock behind a figure that ends before S."""
        self.go(infeed, *path.point(path.first()))
        self.along(path.pieces)
        crest = path.point(path.ridge(path.first(), path.last()))[1] < self.at[1] - EPS
        if (crest or self.at[0] < home[0]) and self.at[1] > 0:
            self.go('rapid', d=0.0)


def type_one(pieces, step, escape, infeed, last_pass=True, home=(0.0, 0.0)):
    """Returns the moves of a figure that rises only, from C to the last before the rapid to S, `home`."""
    path, moves = Path(pieces), Moves((0.0, 0.0))
    before, deepest = infeed_place(path)
    for n in range(1, DEEPEST):
        level = n * step
        if level >= deepest - EPS:
            break
        place = path.reaches(level, path.first(), path.last()) or path.last()
        moves.go(infeed, before, level)
        moves.go('feed', u=path.point(place)[0])
        moves.go('feed', u=moves.at[0] - escape, d=level - escape)
        moves.go('rapid', u=before)
    if last_pass:
        moves.along_the_figure(path, infeed, home)
    return moves.list


def infeed_place(path):
    """Returns u of the infeed, and the depth of A'. It is C's u, but for a figure whose A' lies before C, as that of a nose may: A's."""
    u, d = path.point(path.first())
    return min(0.0, u), d


class TypeTwo:
    """The passes of a figure with pockets. Beyond the words of 9.3, the tool never goes aside at rapid below a crest of the figure, nor down
    to what is not yet cut: it first moves out to e above the crest. Only figures with a crest behind their last pocket need it."""

    def __init__(self, pieces, step, escape, infeed):
        self.path, self.moves = Path(pieces), Moves((0.0, 0.0))
        self.step, self.escape, self.infeed = step, escape, infeed
        self.pockets, self.left = False, self.path.first()
        self.before = infeed_place(self.path)[0]

    def all(self, last_pass=True, home=(0.0, 0.0)):
        """Returns the moves from C to the last before the rapid to S, `home`."""
        path, moves = self.path, self.moves
        for one, two in path.deeper_than(0.0, path.first(), path.last()):
            self.stretches_inside(one, two, 1)
        self.out_to(0.0 if self.pockets else self.clear(path.first()))
        moves.go('rapid', u=self.before)
        if last_pass:
            moves.along_the_figure(path, self.infeed, home)
        return moves.list

    def stretches_inside(self, begin, end, n):
        """Cuts level n of a stretch of the level before, and what lies below it."""
        path, level = self.path, n * self.step
        found = path.deeper_than(level, begin, end)
        for number, (one, two) in enumerate(found):
            ridge_before = path.ridge(found[number - 1][1], one) if number else None
            ridge_behind = path.ridge(two, found[number + 1][0]) if number + 1 < len(found) else None
            if one == path.first():
                self.out_to(self.clear(path.first()))
                self.moves.go('rapid', u=self.before)
                self.moves.go(self.infeed, d=level)
            else:
                self.pockets = True
                self.go_into(ridge_before or begin, one, path.point(ridge_before)[1] if ridge_before else level - self.step)
            self.moves.go('feed', u=path.point(two)[0])
            self.left = two
            self.climb(two, ridge_behind or path.last(), level - self.step)
            self.moves.go('feed', d=self.moves.at[1] - self.escape)
            self.stretches_inside(one, two, n + 1)

    def go_into(self, entry, place, cut):
        """Goes to a pocket's entry, where the stock is cut down to `cut`, at rapid but for the last e, and down along the figure."""
        u, d = self.path.point(entry)
        near = min(d - self.escape, cut)
        self.out_to(min(near, self.clear(entry)))
        self.moves.go('rapid', u=u)
        self.moves.go('rapid', d=near)
        self.moves.go('feed', d=d)
        self.moves.along(self.path.pieces_between(entry, place))

    def climb(self, place, until, level):
        """Follows the figure out of a cut."""
        if self.path.point(place)[1] > self.moves.at[1] + EPS:
            return                                         # the figure ends below the level
        reached = self.path.reaches(max(level, 0.0), place, until) or until
        self.moves.along(self.path.pieces_between(place, reached))
        self.left = reached

    def out_to(self, depth):
        if self.moves.at[1] > depth:
            self.moves.go('rapid', d=depth)

    def clear(self, place):
        """Returns the depth e above every crest between the place where the tool left the figure and another."""
        return self.path.point(self.path.ridge(*sorted((self.left, place))))[1] - self.escape


def pattern(first_kind, pieces, start, allowance, relief, count):
    """G73: returns the moves in (Z, X) from S back to S; `relief` is (dk, di)."""
    moves = Moves(start)
    shifts = [tuple(allowance[i] + (relief[i] * (count - j) / (count - 1) if count > 1 else 0.0) for i in (0, 1)) for j in range(1, count + 1)]
    for shift in shifts:
        moved = [piece.mapped(lambda p, s=shift: (p[0] + s[0], p[1] + s[1]), False) for piece in pieces]
        moves.go('rapid', start[0] + shift[0], start[1] + shift[1])
        moves.go(first_kind, *moved[0].a)
        moves.along(moved)
    moves.go('rapid', *start)
    return moves.list


def finishing(first_kind, pieces, start):
    """G70: returns the moves in (Z, X) from the present point back to it."""
    moves = Moves(start)
    moves.go(first_kind, *pieces[0].a)
    moves.along(pieces)
    moves.go('rapid', *start)
    return moves.list
