"""Plane geometry of the slow reference of the turning cycles: pieces of a contour, and the contour as a path with places on it.

A point is a pair. In a figure it is (Z, X), X as a radius; in the frame of a roughing cycle it is (u, d): u the way along the cuts from the
start of the cycle, d the depth from there towards the figure's first point. All lengths are mm.
"""
import math
from dataclasses import dataclass

EPS = 1e-7      # two lengths closer than this are equal; the grid of the programs is 0.0005 mm


@dataclass(frozen=True)
class Piece:
    """A line from a to b, or an arc around c, counter-clockwise in the plane (first, second) if ccw is set."""
    a: tuple
    b: tuple
    c: tuple = None
    ccw: bool = False

    def radius(self):
        return math.dist(self.a, self.c)

    def angles(self):
        """Returns the angle of the start and the signed sweep of an arc, radians."""
        first = math.atan2(self.a[1] - self.c[1], self.a[0] - self.c[0])
        last = math.atan2(self.b[1] - self.c[1], self.b[0] - self.c[0])
        sweep = (last - first) % (2 * math.pi)
        return first, sweep if self.ccw else sweep - 2 * math.pi

    def at(self, t):
        """Returns the point at the share t of the line's length or the arc's sweep."""
        if t <= 0 or t >= 1:
            return self.a if t <= 0 else self.b
        if self.c is None:
            return self.a[0] + t * (self.b[0] - self.a[0]), self.a[1] + t * (self.b[1] - self.a[1])
        first, sweep = self.angles()
        return self.c[0] + self.radius() * math.cos(first + t * sweep), self.c[1] + self.radius() * math.sin(first + t * sweep)

    def shares_where(self, axis, value):
        """Returns the sorted shares t strictly inside the piece at which a coordinate has the value."""
        if self.c is None:
            way = self.b[axis] - self.a[axis]
            found = [] if abs(way) < EPS else [(value - self.a[axis]) / way]
        else:
            r, away = self.radius(), value - self.c[axis]
            if abs(away) > r:
                return []
            first, sweep = self.angles()
            at = math.acos(away / r) if axis == 0 else math.asin(away / r)
            both = (at, -at) if axis == 0 else (at, math.pi - at)
            found = []
            for angle in both:
                turned = (angle - first) % (2 * math.pi) if sweep > 0 else -((first - angle) % (2 * math.pi))
                found.append(turned / sweep)
        length = self.length()
        return sorted(t for t in found if EPS < t * length and (1 - t) * length > EPS and t < 1)

    def length(self):
        return math.dist(self.a, self.b) if self.c is None else abs(self.angles()[1]) * self.radius()

    def extreme_shares(self, axis):
        """Returns the shares inside an arc at which a coordinate turns back."""
        if self.c is None:
            return []
        first, sweep = self.angles()
        found = []
        for quarter in range(-8, 9):
            t = ((quarter if axis == 0 else quarter + 0.5) * math.pi - first) / sweep
            if 0 < t < 1 and EPS < t * self.length() < self.length() - EPS:
                found.append(t)
        return sorted(found)

    def part(self, t0, t1):
        return Piece(self.at(t0), self.at(t1), self.c, self.ccw)

    def mapped(self, function, turned_over):
        """Returns the piece in other axes; turned_over: they have the other hand."""
        return Piece(function(self.a), function(self.b), self.c and function(self.c), self.ccw != turned_over)


class Path:
    """A chain of pieces. A place is a pair: number of the piece, share t in it; places compare in their order along the path."""

    def __init__(self, pieces):
        self.pieces = list(pieces)

    def point(self, place):
        return self.pieces[place[0]].at(place[1])

    def first(self):
        return 0, 0.0

    def last(self):
        return len(self.pieces) - 1, 1.0

    def pieces_between(self, one, two):
        """Returns the parts of the pieces between two places, without those of no length."""
        parts = []
        for number in range(one[0], two[0] + 1):
            t0 = one[1] if number == one[0] else 0.0
            t1 = two[1] if number == two[0] else 1.0
            if (t1 - t0) * self.pieces[number].length() > EPS:
                parts.append(self.pieces[number].part(t0, t1))
        return parts

    def breaks(self, level, one, two):
        """Returns the places between two places, these too, that cut the path where its depth has the level or turns back."""
        places = [one]
        for number in range(one[0], two[0] + 1):
            piece = self.pieces[number]
            shares = {0.0, 1.0, *piece.shares_where(1, level), *piece.extreme_shares(1)}
            places += [(number, t) for t in sorted(shares) if one < (number, t) < two]
        return [*places, two]

    def deeper_than(self, level, one, two):
        """Returns the stretches between two places that are deeper than the level: pairs of places."""
        found = []
        places = self.breaks(level, one, two)
        for p, q in zip(places, places[1:]):
            if p[0] != q[0]:
                continue                                   # the end of a piece and the start of the next one are one point
            if self.point((p[0], (p[1] + q[1]) / 2))[1] <= level + EPS:
                continue
            joins = found and math.dist(self.point(found[-1][1]), self.point(p)) < EPS and self.point(p)[1] > level + EPS
            if joins:
                found[-1] = (found[-1][0], q)
            else:
                found.append((p, q))
        return found

    def reaches(self, level, one, two):
        """Returns the first place between two places at which the depth is the level or less; None if there is none."""
        for place in self.breaks(level, one, two):
            if self.point(place)[1] <= level + EPS:
                return place
        return None

    def ridge(self, one, two):
        """Returns the first of the least deep places between two places."""
        places = self.breaks(math.inf, one, two)
        least = min(self.point(place)[1] for place in places)
        return next(place for place in places if self.point(place)[1] < least + EPS)


def corner(before, after, kind, value):
    """Breaks the corner of two lines: kind 'C' takes the value off both, 'R' is the radius of the tangent arc.
    returns the three pieces that replace the two lines"""
    at = before.b
    one, two = direction(before), direction(after)
    turn = one[0] * two[1] - one[1] * two[0]
    half = math.acos(max(-1.0, min(1.0, one[0] * two[0] + one[1] * two[1]))) / 2
    leg = value if kind == 'C' else value * math.tan(half)
    p = (at[0] - leg * one[0], at[1] - leg * one[1])
    q = (at[0] + leg * two[0], at[1] + leg * two[1])
    if kind == 'C':
        middle = Piece(p, q)
    else:
        side = 1 if turn > 0 else -1
        middle = Piece(p, q, (p[0] - side * value * one[1], p[1] + side * value * one[0]), turn > 0)
    return [Piece(before.a, p), middle, Piece(q, after.b)]


def leg_of(before, after, kind, value):
    """Returns the length that a corner takes off each of its lines."""
    one, two = direction(before), direction(after)
    half = math.acos(max(-1.0, min(1.0, one[0] * two[0] + one[1] * two[1]))) / 2
    return value if kind == 'C' else value * math.tan(half)


def direction(line):
    length = math.dist(line.a, line.b)
    return (line.b[0] - line.a[0]) / length, (line.b[1] - line.a[1]) / length


def centre_of(a, b, radius, ccw):
    """Returns the centre of the arc of up to 180 degrees with this radius."""
    half = math.dist(a, b) / 2
    high = math.sqrt(max(0.0, radius * radius - half * half))
    nx, ny = -(b[1] - a[1]) / (2 * half), (b[0] - a[0]) / (2 * half)
    side = 1 if ccw else -1
    return (a[0] + b[0]) / 2 + side * high * nx, (a[1] + b[1]) / 2 + side * high * ny
