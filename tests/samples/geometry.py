"""The rules that the samples of tests/run_samples.py must obey, computed with numpy: limits of the axes, the path, planes, threads, feeds
per revolution.

`rows` is an array with a row for each sample: time in s, then the machine position of each axis of `names`. `spindle` is the spindle's
angle at the same times.
"""
import math

import numpy as np

from samples.programs import SMOOTH_PROGRAMS, SURFACE_PROGRAMS

LIMITS = {'speed': 200.0, 'acceleration': 1000.0, 'jerk': 20000.0}  # mm/s, mm/s², mm/s³
TOLERANCE = 0.02       # mm
OVER = 1.005           # of a limit: for differences of samples with nine decimals
EXACT_PATH = 0.005     # mm: from the exact run's own arcs, chords between its samples, THIN
MOST_PATH = 2000       # samples whose distance from the path is measured
THIN = 0.003           # mm: points of the exact run closer than this are merged
STANDS = 1e-4          # mm: motion that counts as stopped at the ends of a chain of threads
IN_STEP = 1e-6         # mm, degrees: rounding of nine decimals, and of values computed from them
NEAR_CORNER = 2        # mm
OVER_IN_CORNER = 1.03  # of the feed in a plane: the axes round the corners separately
SLOW = 0.15            # of the samples: at corners, the start and the end
AROUND_NEAR = 15       # points of the exact run before and after, where the nearest is searched
AROUND = 150           # the same, if none of the former is within NEAR
NEAR = 0.01            # mm
CHUNK = 64             # samples whose distances are computed at once


def lengths(ways):
    return np.sqrt((ways * ways).sum(-1))


def distances(points, begins, ends):
    """Returns the distance of each point from each segment: an array with a row for each point."""
    ways = ends - begins
    square = (ways * ways).sum(1)
    to = points[:, None, :] - begins
    part = np.clip((to * ways).sum(2) / np.where(square == 0, 1, square), 0, 1)
    return lengths(to - part[:, :, None] * ways)


def used(names, rows):
    """Returns (share, limit, axis, time) of the greatest use of each limit by each axis."""
    if len(rows) < 3:
        return
    period = rows[1, 0] - rows[0, 0]
    values = rows[:-1, 1:]  # the last row is the end itself, less than a period later
    moving = values.min(0) != values.max(0)
    for limit, most in LIMITS.items():
        values = np.diff(values, axis=0) / period
        if len(values) == 0:
            return
        at = np.abs(values).argmax(0)
        for k in np.flatnonzero(moving):
            yield abs(values[at[k], k]) / most, limit, names[k], rows[at[k], 0]


def thinned(points):
    path = [points[0]]
    for point in points:
        if math.dist(point, path[-1]) > THIN:
            path.append(point)
    return np.array(path)


class Distances:
    """Distances of samples from the segments of a path; each sample is searched along a part of the path that advances with the samples."""

    def __init__(self, points, path):
        self.points, self.begins, self.ends = points, path[:-1], path[1:]
        self.row = self.first = self.past = 0
        self.table = []

    def of(self, row, first, past):
        """Returns the distance of one sample from the segments `first` to `past`, without the last."""
        if not (self.row <= row < self.row + len(self.table) and self.first <= first and past <= self.past):
            self.row, self.first, self.past = row, first, min(past + CHUNK, len(self.begins))
            found = distances(self.points[row:row + CHUNK], self.begins[first:self.past], self.ends[first:self.past])
            self.table = found.tolist()
        return self.table[row - self.row][first - self.first:past - self.first]


def furthest(rows, exact):
    """Returns the greatest distance of a sample from the exact path, searched around the segment nearest to the last sample, and its time."""
    rows = rows[:MOST_PATH]
    moving = np.flatnonzero((exact[:, 1:] != exact[0, 1:]).any(0) | (rows[:, 1:] != exact[0, 1:]).any(0)) + 1
    path = thinned(exact[:, moving].tolist())
    stretches = len(path) - 1
    looked_for = Distances(rows[:, moving], path)
    near, worst = 0, (0, 0)
    for row in range(len(rows) if stretches > 0 else 0):
        for around in (AROUND_NEAR, AROUND):
            first = max(0, near - around)
            found = looked_for.of(row, first, min(stretches, near + around))
            best = min(found)
            if best < NEAR:
                break
        close = [i for i, d in enumerate(found, first) if d <= best + 1e-3]  # where the path returns to the same place, a later segment is preferred to an earlier one
        near = min((i for i in close if i >= near), default=close[-1])
        if best > worst[0]:
            worst = (best, rows[row, 0])
    return worst


def off_feed(rows, spindle):
    """Where the axes hardly accelerate, a revolution moves them 0.2 mm: along a motion speeds are kept within 2 %, and lower near the ends
    of its segments."""
    def of_20(steps):
        sums = np.concatenate(([0], steps.cumsum()))
        return sums[20:] - sums[:-20]
    ways, turns = of_20(lengths(np.diff(rows[:, 1:], axis=0))), of_20(np.abs(np.diff(spindle)) / 360)
    at = np.arange(100, len(rows) - 101, 20)
    around = np.array([ways[at + k] for k in (-80, -40, 40, 80)])
    even = (turns[at] > 0) & (around.max(0) <= 1.03 * ways[at]) & (around.min(0) >= 0.97 * ways[at])
    feeds = ways[at[even]] / turns[at[even]]
    for i in np.flatnonzero(np.abs(feeds / 0.2 - 1) > 0.03):
        yield f'{feeds[i]:.4f} mm/rev at {rows[at[even][i], 0]:.3f} s'
    if even.sum() < 100:
        yield f'only {even.sum()} places with an even speed'


def off_chords(name, rows):
    """Checks the run on a machine that does not round corners by itself."""
    q, tolerance, _, points = SMOOTH_PROGRAMS[name.removeprefix('smoothing ')]
    points = np.array([(x, round(y, 4)) for x, y in points])
    path = rows[lengths(rows[:, 1:3] - points[0]).argmin():, 1:3]
    away = distances(path, points[:-1], points[1:]).min(1).max()
    faults = [f'{away:.4f} mm off the chords'] if away > tolerance + EXACT_PATH / 5 else []
    if away < tolerance / 50:
        faults.append(f'only {away:.5f} mm off the chords: not smoothed')
    if q == 2:
        found = distances(points, path[:-1], path[1:])
        found[lengths(points[:, None, :] - path[:-1]) >= 1] = math.inf
        missed = found.min(1).max()
        if missed > EXACT_PATH / 5:
            faults.append(f'{missed:.4f} mm beside a programmed point')
    return faults


def off_surface(name, names, rows):
    """Reports samples that are off the contour of the plane, faster than its feed, or slower without a reason."""
    setup, radius, feed, contour = SURFACE_PROGRAMS[name.removeprefix('surface ')]
    x, turned = rows[:, names.index('X') + 1], rows[:, names.index('C' if radius == 0 else 'A') + 1]
    angle, contour = np.radians(turned), np.array(contour, dtype=float)
    plane = np.stack((x * np.cos(angle), x * np.sin(angle)) if radius == 0 else (x, radius * angle), 1)
    begin = lengths(plane - contour[0]).argmin()
    seconds = np.diff(rows[:, 0])[begin:-1]
    from_contour = distances(plane[begin:-2], contour[:-1], contour[1:]).min(1)
    speeds = lengths(np.diff(plane, axis=0))[begin:-1] / seconds * 60
    corner = lengths(plane[begin:-2, None, :] - contour).min(1) < NEAR_CORNER
    times = rows[begin:, 0]
    faults = [f'{from_contour[i]:.4f} mm off the contour at {times[i]:.3f} s' for i in np.flatnonzero(from_contour > TOLERANCE + EXACT_PATH)]
    fast = np.flatnonzero(speeds > feed * np.where(corner, OVER_IN_CORNER, OVER))
    faults += [f'{speeds[i]:.1f} mm/min at {times[i]:.3f} s' for i in fast]
    most = (np.abs(np.diff(turned))[begin:-1] / seconds * 60).max()
    limit = setup['parameters'].get('N0305.C', math.inf)
    if most > limit * OVER:
        faults.append(f'the rotary axis at {most:.1f} degrees/min')
    slow = (speeds < 0.95 * feed).mean()
    if most < 0.95 * limit and slow > SLOW:
        faults.append(f'{100 * slow:.0f} % of the samples are slow')
    return faults


def legs_in_step(actions):
    """Returns the motions in step with the spindle: (first of its chain, from, to, degrees that the spindle turns, where it begins)."""
    at, chained = {}, False
    for action in actions:
        to = action.get('machine')
        if to is None or 'to' not in action:
            continue
        ways = [to[axis] - at.get(axis, 0) for axis in to]
        if action['do'] == 'thread':
            turned = max(map(abs, ways)) / action['lead'] * 360
            yield not chained or 'angle' in action, dict(at), to, turned, action.get('angle', 0)
            chained = True
        else:
            chained = False
        if 'turn' in action:
            yield True, dict(at), to, action['turn'], None
        at = to


def out_of_step(actions, names, rows, spindle):
    """A chain starts and ends at rest; in between, away from ramps and corners, path and angle stay in step."""
    faults, chains = [], []
    for first, start, end, turned, angle in legs_in_step(actions):
        if first:
            chains.append((angle, []))
        chains[-1][1].append((np.array([start.get(n, 0) for n in names]), np.array([end[n] for n in names]), turned))
    behind = 0  # end of the last chain
    for angle, legs in chains:
        at_start = np.flatnonzero(lengths(rows[behind:, 1:] - legs[0][0]) < STANDS) + behind
        if len(at_start) == 0:
            faults.append(f'the chain to {legs[-1][1]} is not in the samples')
            break
        leaves = np.flatnonzero(np.diff(at_start) > 1)  # the axis stays at the start for some time, and may return later
        begin = at_start[leaves[0] if len(leaves) else -1]
        at_end = np.flatnonzero(lengths(rows[begin + 1:, 1:] - legs[-1][1]) < STANDS) + begin + 1
        if len(at_end) == 0:
            faults.append(f'the chain to {legs[-1][1]} is not in the samples')
            break
        behind = at_end[0]
        faults += chain_out_of_step(rows[begin:behind + 1], spindle[begin:behind + 1], angle, legs)
    if not chains:
        faults.append('nothing is in step with the spindle')
    return faults


def chain_out_of_step(rows, spindle, angle, legs):
    start, end, turned = legs[0]
    if angle is None:  # the spindle follows the axis
        along = lengths(rows[:, 1:] - start) / math.dist(end, start)
        worst = np.abs(spindle - spindle[0] - turned * (along - along[0])).max()
        return [f'tapping {worst:.6f} degrees out of step'] if worst > IN_STEP else []
    clockwise = 1 if spindle[-1] > spindle[0] else -1
    rate = abs(spindle[-1] - spindle[0]) / (rows[-1, 0] - rows[0, 0])
    middle = lengths(rows[:, 1:] - (start + end) / 2).argmin()
    part = math.dist(rows[middle, 1:], start) / math.dist(start, end)
    pulse = 360 * round((clockwise * spindle[middle] - angle - turned * part) / 360) + angle  # start of the chain
    fastest = max(math.dist(a, b) * rate / way for a, b, way in legs)
    ramp = rate * 2 * max(2 * fastest / LIMITS['acceleration'], math.sqrt(4 * fastest / LIMITS['jerk']))  # degrees, a generous bound
    faults, seen = [], 0
    for start, end, turned in legs:
        part = (clockwise * spindle - pulse) / turned
        even = (ramp / turned < part) & (part < 1 - ramp / turned)
        seen += even.sum()
        away = lengths(rows[even, 1:] - (start + part[even, None] * (end - start)))
        faults += [f'{away[i]:.6f} mm out of step at {rows[even][i, 0]:.3f} s' for i in np.flatnonzero(away > IN_STEP)]
        pulse += turned
    return faults if seen else ['no sample in step']
