"""What a roughing leaves on the part, by heights at samples along the cuts: nothing beyond the figure, no rapid through the stock, no cut
deeper than stated, and in the end the figure with its allowance.

It knows nothing of how a cycle divides its passes, so it also judges the slow reference. The tool is a point; the stock is all that lies
deeper than the start of the cycle, the figure's own depth bounds it.
"""
import bisect
import math

from lathe_twin.shapes import EPS, Piece

SAMPLES = 90
TOLERANCE = 2e-5


class Heights:
    """The figure's depth at the samples, and the depth that is cut so far. Frame: (u, d) of rough.py."""

    def __init__(self, pieces):
        self.first, self.last = pieces[0].a[0], pieces[-1].b[0]
        edges = sorted({self.first, self.last, *(p.b[0] for p in pieces)})
        usual = {self.first + (self.last - self.first) * (n + 0.5) / SAMPLES for n in range(SAMPLES)}
        beside = {e + s for e in edges for s in (-1e-3, 1e-3)}
        self.u = sorted(u for u in usual | beside if self.first + 1e-6 < u < self.last - 1e-6 and min(abs(u - e) for e in edges) > 1e-4)
        self.figure = [max(depths_at(pieces, u)) for u in self.u]
        self.cut = [0.0] * len(self.u)

    def over(self, piece):
        """Yields the number of each sample that a move passes, and the move's depths there."""
        ends = [piece.a[0], piece.b[0]]
        if piece.c is not None:
            ends += [piece.at(t)[0] for t in piece.extreme_shares(0)]
        for number in range(bisect.bisect_left(self.u, min(ends)), bisect.bisect_right(self.u, max(ends))):
            for depth in depths_at([piece], self.u[number]):
                yield number, depth


def depths_at(pieces, u):
    """Returns the depths at which pieces pass over u, lines along d aside."""
    found = []
    for piece in pieces:
        if abs(piece.b[0] - piece.a[0]) < EPS and piece.c is None:
            continue
        found += [end[1] for end in (piece.a, piece.b) if abs(end[0] - u) < EPS]
        found += [piece.at(t)[1] for t in piece.shares_where(0, u)]
    return found


def faults(moves, pieces, start, step, whole):
    """Returns what is wrong with the moves (kind, to, centre, ccw) from `start`; `whole`: the pass along the figure is among them."""
    heights, at, found = Heights(pieces), start, []
    for number, (kind, to, centre, ccw) in enumerate(moves):
        piece = Piece(at, to, centre, ccw)
        at = to
        for n, depth in heights.over(piece):
            if depth > heights.figure[n] + TOLERANCE:
                found.append(f'move {number} ({kind}) is {depth - heights.figure[n]:.6f} beyond the figure at u {heights.u[n]:.4f}')
            if kind == 'rapid' and depth > heights.cut[n] + TOLERANCE:
                found.append(f'move {number}: rapid {depth - heights.cut[n]:.6f} deep in the stock at u {heights.u[n]:.4f}')
            if kind != 'rapid':
                if depth - heights.cut[n] > step + TOLERANCE:
                    found.append(f'move {number} cuts {depth - heights.cut[n]:.6f} deep at u {heights.u[n]:.4f}')
                heights.cut[n] = max(heights.cut[n], depth)
    left = [(f - c, u) for f, c, u in zip(heights.figure, heights.cut, heights.u)]
    if whole and left and max(left)[0] > TOLERANCE:
        found.append(f'{max(left)[0]:.6f} is left at u {max(left)[1]:.4f}')
    return found[:3]


def cut_by(moves, pieces):
    """Returns the heights that motions cut, rapids aside; the first motion only positions."""
    heights, at = Heights(pieces), None
    for kind, to, centre, ccw in moves:
        if at is not None and kind != 'rapid':
            for n, depth in heights.over(Piece(at, to, centre, ccw)):
                heights.cut[n] = max(heights.cut[n], depth)
        at = to
    return heights


def straight_down(moves, pieces, start):
    """Returns the rapids along d that end deeper than the figure next to them; `faults` sees only moves along u."""
    found, at, path = [], start, pieces
    for number, (kind, to, _, _) in enumerate(moves):
        if kind == 'rapid' and abs(to[0] - at[0]) < 1e-9 and to[1] > at[1]:
            near = [d for s in (-1e-4, 1e-4) for d in depths_at(path, to[0] + s)]
            if near and to[1] > max(near) + 1e-3 and not math.isclose(to[0], start[0], abs_tol=1e-9):
                found.append(f'move {number}: rapid down to {to[1]:.4f}, figure {max(near):.4f}')
        at = to
    return found
