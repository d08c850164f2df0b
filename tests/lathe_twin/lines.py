"""The slow reference of the cycles that cut along straight lines: G90, G92, G94, G74, G75, G76 (spec/fanuc-t 8.3 to 8.5, 9.7 to 9.10).

Points are (Z, X), X as a radius, mm. A move is (kind, point, centre, ccw) as in rough.py; kind 'thread' too.
"""
import math

from lathe_twin.shapes import EPS


class Moves:
    def __init__(self, at):
        self.at, self.list = at, []

    def go(self, kind, z=None, x=None):
        self.at = (self.at[0] if z is None else z, self.at[1] if x is None else x)
        self.list.append((kind, self.at, None, False))


def towards(here, there):
    return (there > here) - (there < here)


def turning(start, end, taper):
    """G90: `end` (Z, X); `taper` = radius at the start of the cut minus radius at its end."""
    moves = Moves(start)
    moves.go('rapid', x=end[1] + taper)
    moves.go('feed', *end)
    moves.go('feed', x=start[1])
    moves.go('rapid', z=start[0])
    return moves.list


def facing(start, end, taper):
    """G94."""
    moves = Moves(start)
    moves.go('rapid', z=end[0] + taper)
    moves.go('feed', *end)
    moves.go('feed', z=start[0])
    moves.go('rapid', x=start[1])
    return moves.list


def thread_cut(moves, start, end, run_out, run_out_angle):
    """Cuts a thread to its end, with the run-out, and goes back to the start in X, then in Z. The cut begins where the tool stands. The
    run-out rises from where it leaves the thread, at most to the X of the start."""
    begin = moves.at
    run_out = min(run_out, abs(end[0] - begin[0]))
    if run_out > EPS:
        share = 1 - run_out / abs(end[0] - begin[0])
        leaves = begin[1] + share * (end[1] - begin[1])
        rise = min(run_out * math.tan(math.radians(run_out_angle or 45)), abs(start[1] - leaves))
        moves.go('thread', end[0] - towards(begin[0], end[0]) * run_out, leaves)
        moves.go('thread', end[0], leaves + towards(leaves, start[1]) * rise)
    else:
        moves.go('thread', *end)
    moves.go('rapid', x=start[1])
    moves.go('rapid', z=start[0])


def threading(start, end, taper, run_out, run_out_angle):
    """G92: `run_out` is the length in mm."""
    moves = Moves(start)
    moves.go('rapid', x=end[1] + taper)
    thread_cut(moves, start, end, run_out, run_out_angle)
    return moves.list


def depths(height, first, least, allowance, passes, constant=False):
    """Returns the depths of the passes of G76, the finishing passes at the full height among them."""
    limit, found, depth, n = height - allowance, [], 0.0, 0
    while depth < limit - EPS:
        n += 1
        depth = min(max(first * (n if constant else math.sqrt(n)), depth + least), limit)
        found.append(depth)
    return found + [height] * passes


def multiple_thread(start, end, taper, height, first, least, allowance, passes, angle, run_out, run_out_angle, constant=False, one_edge=True):
    """G76."""
    moves = Moves(start)
    side = towards(end[1], start[1])                       # from the thread to the outside
    ahead = towards(start[0], end[0])
    for depth in depths(height, first, least, allowance, passes, constant):
        level = end[1] + side * (height - depth)
        flank = depth * math.tan(math.radians(angle / 2)) if one_edge else 0.0
        cone = taper * (1 - flank / abs(end[0] - start[0]))  # all passes cut the same cone, wherever they start on it
        moves.go('rapid', start[0] + ahead * flank, level + cone)
        thread_cut(moves, start, (end[0], level), run_out, run_out_angle)
    return moves.list


def pecks(start, end, column_step, depth_step, escape, relief, along):
    """G74 (along = 0: pecks along Z) and G75 (along = 1). `end` has None for an axis that the cycle does not name."""
    across = 1 - along
    moves = Moves(start)

    def go(kind, **to):
        """Moves along `deep`, the axis of the pecks, or `aside`."""
        names = ('z', 'x')
        moves.go(kind, **{names[along] if name == 'deep' else names[across]: value for name, value in to.items()})

    single = end[across] is None
    side = 0 if single else towards(start[across], end[across])
    column = start[across]
    while True:
        one_column(go, start[along], end[along], depth_step, escape)
        away = relief if single else -side * relief
        if relief:
            go('rapid', aside=column + away)
        go('rapid', deep=start[along])
        if single or side * (end[across] - column) < EPS:
            break
        column = end[across] if side * (end[across] - column) < column_step + EPS else column + side * column_step
        go('rapid', aside=column)
    moves.go('rapid', *start)
    return moves.list


def one_column(go, top, bottom, step, escape):
    """Pecks one column; the way back never leads beyond the start."""
    way = towards(top, bottom)
    depth = top
    while way * (bottom - depth) > step + EPS:
        depth += way * step
        go('feed', deep=depth)
        go('rapid', deep=depth - way * min(escape, abs(depth - top)))
    go('feed', deep=bottom)
