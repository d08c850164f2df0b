"""Mistakes that tests/checklist.py plants into clean programs: each function finds the locations for one type of mistake in a program, and
returns the text with the mistake, the line that must be reported and the ids that may report it. The line is where the mistake is
written, except for mistakes that show only where the tool first cuts (FIRST CUT below)."""
import dataclasses
import json
import re


LATHES = ('fanuc-t',)   # controls of lathes


@dataclasses.dataclass
class Mistake:
    kind: str
    ids: tuple      # one of them must be reported
    line: int       # where it must be reported
    text: list
    setup: dict | None = None   # instead of the program's own
    tools: list | None = None   # the numbers for a tools file of the program
    most_rpm: int | None = None   # of the machine file


def plant(kind, ids, at, text, setup=None, **more):
    return Mistake(kind, (ids,) if isinstance(ids, str) else ids, at + 1, text, setup, **more)


# ---- numbers

def point_dropped(p):
    if p.control not in ('fanuc', 'haas'):   # on the others a number means the same without its point
        return
    for b in p.blocks:
        for w in b.words:
            if w.letter in 'XYZIJR' and w.text.endswith('.') and w.number:
                yield plant('point dropped', 'point_forgotten', b.at, p.replaced(b.at, w, w.letter + w.text[:-1]))


def digit_too_many(p):
    """For the outermost coordinate of the program, and with two digits too many for any other."""
    cuts = [(b, w) for b in p.blocks if b.cuts() and not b.incremental and (b.motion < 2 or b.cycle) for w in b.words if w.letter in 'XY']
    for letter in 'XY':
        mine = [(b, w) for b, w in cuts if w.letter == letter and w.number]
        most = max((abs(p.value(w)) for _, w in mine), default=0)
        for b, w in mine:
            times = 10 if abs(p.value(w)) == most else 100
            yield plant('digits too many', 'coordinate_far', b.at, p.replaced(b.at, w, letter + p.written(letter, p.value(w) * times)))


def unit_changed(p):
    if p.control in ('s2c42', 'gost', 'correctors'):   # they have no inches
        return
    for change in p.tools()[1:]:
        move = next((b for b in p.stint(change) if any(b.has(a) for a in 'XYZ') and not b.has('G', 28, 53)), None)
        if move:
            yield plant('G20 in mid program', 'units_changed', move.at + 1, p.inserted(move.at, 'G20'))
    if p.control == 'grbl':
        for b in p.blocks[8:]:
            if b.motion == 0 and b.sideways():
                yield plant('G20 in mid program', 'units_changed', b.at + 1, p.inserted(b.at, 'G20'))


# ---- offsets and spindle of a tool

def offset_of_another(p):
    """FIRST CUT of the tool, for its length."""
    others = sorted({b.tool for b in p.tools()})
    for change in p.tools():
        for b in p.stint(change):
            length = b.code('G', 43) and (b.find('H') or b.find('D'))
            other = next((t for t in others if t != change.tool), None)
            if other is None:
                continue
            if length:
                cut = p.first_cut(p.stint(change))
                digits = len(length.text)
                if cut:
                    yield plant('H of another tool', 'length_of_other', cut.at, p.replaced(b.at, length, f'{length.letter}{other:0{digits}}'))
            radius = b.code('G', 41, 42) and b.find('D')
            if radius:
                yield plant('D of another tool', 'radius_of_other', b.at, p.replaced(b.at, radius, f'D{other:0{len(radius.text)}}'))


def length_dropped(p):
    """FIRST CUT. If no code cancelled the offset of the previous tool, that offset is still in force."""
    if len(p.tools()) < 2:
        return
    for change in p.tools():
        for b in p.stint(change):
            code, cut = b.code('G', 43), p.first_cut(p.stint(change))
            if code and cut:
                text = re.sub(r'G43 ?', '', re.sub(r' ?[HD]\d+', '', p.lines[b.at]))
                yield plant('G43 dropped', ('length_not_called', 'length_of_other'), cut.at, [*p.lines[:b.at], text, *p.lines[b.at + 1:]])


def spindle_mistakes(p):
    """M3 missing and M5 too early: FIRST CUT after it. M4 for M3 at its own line."""
    changes = p.tools() or p.blocks[:1]
    for change in changes:
        stint = p.stint(change)
        own = [change, *stint]
        start = next(((b, b.code('M', 3, 13)) for b in own if b.code('M', 3, 13)), None)
        cut = p.first_cut(stint)
        if not start or not cut:
            continue
        b, word = start
        taps = cut.cycle in (74, 84)
        if not taps:   # many controls start the spindle in the canned cycle
            yield plant('M3 dropped', 'cut_without_spindle', cut.at, p.replaced(b.at, word, 'M8' if word.number == 13 else ''))
        if len(changes) > 1 and not taps:   # a tap needs both directions of rotation
            yield plant('M4 for M3', 'direction_of_others', b.at, p.replaced(b.at, word, {'3': 'M4', '03': 'M04', '13': 'M14'}[word.text]))
        cuts = [c for c in stint if c.cuts() and not taps]
        for before in cuts[1:len(cuts) - 1:3]:
            yield plant('M5 too early', 'cut_without_spindle', before.at + 1, p.inserted(before.at, p.own_line('M05' if word.text == '03' else 'M5')))


def coolant_dropped(p):
    """FIRST CUT."""
    if len(p.tools()) < 3:
        return
    for change in p.tools():
        for b in [change, *p.stint(change)]:
            word, cut = b.code('M', 8, 13), p.first_cut(p.stint(change))
            if word and cut:
                yield plant('M8 dropped', 'coolant_forgotten', cut.at, p.replaced(b.at, word, 'M3' if word.number == 13 else ''))


def system_changed(p):
    """FIRST CUT. A tool without a work offset code would inherit the wrong one, so every tool must have one."""
    changes = p.tools()
    stated = [next((b for b in p.stint(c) if b.code('G', 54)), None) for c in changes]
    for i, (change, b) in enumerate(zip(changes, stated)):
        cut = p.first_cut(p.stint(change))
        if len(changes) >= 4 and b and cut and all(stated[i + 1:]):
            yield plant('work offset of one tool', 'work_offset_once', cut.at, p.replaced(b.at, b.code('G', 54), 'G55'))


def tool_not_changed(p):
    for change in p.tools():
        tool, code = change.find('T'), change.code('M', 6)
        if tool and len(p.tools()) > 2:
            if change is not p.tools()[0]:
                yield plant('M6 dropped', 'tool_unused', change.at, p.replaced(change.at, code, ''))
            cut = next((b for b in p.stint(change) if b.code('G', 0) and b.sideways() and b.section == 0), None)
            if cut and p.control in ('fanuc', 'haas', 'nct', 'mach3', 'linuxcnc'):
                end = len(p.lines[cut.at].split('(')[0].rstrip())
                yield plant('a tool called and not changed', 'tool_unused', cut.at, [*p.lines[:cut.at], p.lines[cut.at][:end] + ' T19', *p.lines[cut.at + 1:]])


def retract_dropped(p):
    """Drops all motions that retract the tool after its last cut."""
    changes = p.tools()
    for change, following in zip(changes, changes[1:]):
        stint = p.stint(change)
        last = max((b.at for b in stint if b.cuts()), default=None)
        if last is None:
            continue
        text = list(p.lines)
        for b in stint:
            if b.at > last and (b.has('Z') or b.has('G', 26)):
                text[b.at] = re.sub(r' ?Z-?[\d.]+|G0?0(?!\d)|G91 G28|G26', '', text[b.at])
        text = [line for i, line in enumerate(text) if not (last < i < following.at and re.fullmatch(r'(N\d+)?\s*(G[09]\d?)?\s*', line))]
        at = text.index(p.lines[following.at])
        yield plant('tool change without retract', 'tool_change_low', at, text)


# ---- feeds and speeds

def teeth_of(p, change):
    named = re.search(r'(\d+) (?:FLUTE|TEETH|FL\b)', p.lines[change.at])
    return int(named[1]) if named else 0


def feed_mistakes(p):
    whole = p.control in ('s2c42', 'gost')   # their F is an integer
    for b in p.blocks:
        feed = b.find('F')
        if feed is None or b.cycle in (74, 84) or not (b.motion or b.cycle) or b.has('G', 65):
            continue
        if not whole:
            yield plant('a feed per turn in G94', ('feed_too_small', 'feed_per_tooth'), b.at, p.replaced(b.at, feed, 'F0.2'))
        if p.control not in ('s2c42', 'gost'):
            yield plant('four digits too many in F', 'feed_too_large', b.at, p.replaced(b.at, feed, f'F{feed.number * 10000:.0f}' + '.' * feed.text.endswith('.')))
    for b in p.blocks[:12]:
        minutes = b.code('G', 94)
        first = next((c for c in p.blocks[b.at + 1:] if (c.motion or c.cycle) and c.find('F')), None)
        if minutes and first and not any(c.calls for c in p.blocks) and p.control not in ('s2c42', 'gost', 'grbl', 'mach3', 'linuxcnc'):
            yield plant('G95 for G94', 'feed_too_large', first.at, p.replaced(b.at, minutes, 'G95'))


def tooth_mistakes(p):
    for change in p.tools():
        if not teeth_of(p, change) or p.control == 'mach3':
            continue
        for b in p.stint(change):
            feed = b.find('F')
            if feed and b.cuts() and not b.cycle:
                yield plant('two digits of F lost', 'feed_per_tooth', b.at, p.replaced(b.at, feed, 'F1' + '.' * feed.text.endswith('.')))
                yield plant('two digits too many in F', 'feed_per_tooth', b.at, p.replaced(b.at, feed, f'F{feed.number * 120:g}' + '.' * feed.text.endswith('.')))


def tap_mistakes(p):
    for b in p.blocks:
        feed = b.find('F')
        if not b.code('G', 74, 84) or not feed:
            continue
        point = '.' * feed.text.endswith('.')
        for wrong in (62, 6250, 260, 65):
            yield plant('feed of a tap', 'tap_feed', b.at, p.replaced(b.at, feed, f'F{wrong}{point}'))
        speed = next((s for s in reversed(p.blocks[:b.at]) if s.find('S')), None)
        for wrong in ('S50', 'S530', 'S5500'):
            yield plant('speed of a tap', 'tap_feed', b.at, p.replaced(speed.at, speed.find('S'), wrong))


def speed_mistakes(p):
    """Above the limit of the machine file, and above the gears of the set-up."""
    for b in p.blocks:
        speed = b.find('S')
        if speed and speed.number > 10:
            yield plant('S beyond the machine', 'speed_beyond_spindle', b.at, list(p.lines), most_rpm=int(speed.number) - 1)
    if p.control != 'nct' or p.setup is None:   # the set-ups of other controls do not contain the gears
        return
    setup = {**p.setup, 'axes': ['X', 'Y', 'Z'], 'spindle': {'1': {'name': 'S', 'ranges': [[50, 1000], [800, 8000]]}}}
    for b in p.blocks:
        speed = b.find('S')
        if speed:
            yield plant('S beyond the gears', 'speed_beyond_spindle', b.at, p.replaced(b.at, speed, 'S2' + speed.text + '0'), setup)


# ---- the tables next to the program

STRANGE = 19   # no program has a tool, or an offset, with this number


def table_mistakes(p):
    """At the first word that calls the tool; for a tool that is never called, at the first call of any. The file has the tools of the
    program."""
    changes = p.tools()
    numbers = sorted({b.tool for b in changes})
    for number in numbers:
        others = [n for n in numbers if n != number]
        if others:
            yield plant('a tool left out of the table', 'tool_not_in_table', p.first_call(number).at, list(p.lines), tools=others)
    for change in changes:
        tool = change.find('T')
        if tool and len(tool.text) < 4 and len(numbers) > 1:   # T0404 is tool and corrector
            strange = p.replaced(change.at, tool, f'T{STRANGE:0{len(tool.text)}}')
            yield plant('T of no tool of the table', 'tool_not_in_table', change.at, strange, tools=numbers)
    if numbers:
        yield plant('a tool too many in the table', 'table_tools_unused', p.first_call().at, list(p.lines), tools=[*numbers, STRANGE])
    for change, following in zip(changes, changes[1:]):
        own = range(change.at, following.at)
        alone = sum(b.tool == change.tool for b in changes) == 1 and not any(b.has('T') for b in p.blocks[change.at + 1:following.at])
        if alone and len(numbers) > 2 and change is not changes[0] and change.find('T'):
            lines = [line for i, line in enumerate(p.lines) if i not in own]
            yield plant('an operation dropped', 'table_tools_unused', p.first_call().at, lines, tools=numbers)
    offsets = (p.setup or {}).get('offsets', {})
    for b in p.blocks:
        length = b.code('G', 43) and (b.find('H') or b.find('D'))
        if length and str(int(length.number)) in offsets:
            row = str(int(length.number))
            first = next(c for c in p.blocks if c.code('G', 43) and (c.find('H') or c.find('D')) and int((c.find('H') or c.find('D')).number) == int(row))
            setup = {**p.setup, 'offsets': {**{n: o for n, o in offsets.items() if n != row}, str(STRANGE): offsets[row]}}
            yield plant('an offset under another number', 'offset_row_unused', first.at, list(p.lines), setup)


# ---- canned cycles

def cycle_mistakes(p):
    for b in p.blocks:
        following = [c for c in p.blocks[b.at + 1:b.at + 3] if c.cycle and not any(c.has(a) for a in 'GM')]
        if b.cycle and not b.has('G') and b.sideways():
            if following:
                number = re.match(r'(N\d+ )?', p.lines[b.at])[0]
                yield plant('G0 between positions', 'hole_lost', b.at, [*p.lines[:b.at], number + 'G0 ' + p.lines[b.at][len(number):], *p.lines[b.at + 1:]])
            yield plant('a position twice', 'hole_twice', b.at + 1, p.inserted(b.at + 1, re.sub(r'^N\d+ ?', '', p.lines[b.at])))
        r, z = b.find('R'), b.find('Z')
        if b.has('G', 81, 82, 83, 84, 85) and r and z and not b.incremental:
            position = ' '.join(w.letter + w.text for w in b.words if w.letter in 'XY')
            if position:
                yield plant('first position twice', 'hole_twice', b.at + 1, p.inserted(b.at + 1, position))
            at = b.at
            line = p.lines[at]
            swapped = line.replace(f'Z{z.text}', '@').replace(f'R{r.text}', f'R{z.text}').replace('@', f'Z{r.text}')
            yield plant('R and Z exchanged', 'levels_swapped', at, [*p.lines[:at], swapped, *p.lines[at + 1:]])
            if abs(p.value(z)) >= p.value(r):
                yield plant('sign of Z lost', 'levels_swapped', at, p.replaced(at, z, f'Z{z.text.lstrip("-")}'))


# ---- cutter compensation

def compensation_mistakes(p):
    if p.control == 'correctors':   # its G41 states how a corrector is added, not a side
        return
    for b in p.blocks:
        code = b.code('G', 41, 42)
        if not code or not b.sideways():
            continue
        end = next((c for c in p.blocks[b.at + 1:] if c.code('G', 40)), None)
        contour = [c for c in p.blocks[b.at + 1:end.at] if c.cuts()]
        yield plant('G40 dropped', 'compensation_left_on', b.at, p.replaced(end.at, end.code('G', 40), ''))
        for c in contour[1:-2]:
            if c.motion == 1:
                lines = p.replaced(end.at, end.code('G', 40), '')
                number = re.match(r'(N\d+ )?', lines[c.at])[0]
                lines[c.at] = number + 'G40 ' + lines[c.at][len(number):]
                yield plant('G40 in mid contour', 'compensation_ends_in_cut', c.at, lines)
        start = next((c for c in reversed(p.blocks[:b.at]) if c.sideways()), None)
        x, y = b.find('X'), b.find('Y')
        if start and x and y and start.find('X') and start.find('Y'):
            for dx, dy in ((-2, 0), (0, -2.5), (-1, -2), (-1, -1)):
                lines = p.replaced(start.at, start.find('Y'), 'Y' + p.written('Y', p.value(y) + dy))
                lines[start.at] = lines[start.at].replace(f'X{start.find("X").text}', 'X' + p.written('X', p.value(x) + dx), 1)
                yield plant('approach shorter than the radius', 'approach_short', b.at, lines)


def arc_mistakes(p):
    for b in p.blocks:
        arc = b.code('G', 2, 3)
        if not arc or (not b.find('R') and not b.find('I') and not b.find('J')):
            continue
        full = not b.sideways() or (p.name.startswith('grbl') and not b.find('R') and b.has('I') and not b.has('J'))
        at = next((c for c in reversed(p.blocks[:b.at]) if c.sideways()), None)
        if full and at and at.find('X') and at.find('Y'):
            center = p.value(b.find('I'))
            for off in (0.005, 0.01, 0.03):
                sign = -1 if (arc.number == 2) == (center > 0) else 1
                end = f'X{at.find("X").text} Y{p.written("Y", p.value(at.find("Y")) + sign * off)}'
                line = re.sub(r'G0?[23].*?(?=I)', lambda m, e=end, a=arc: f'G{a.text} {e} ', p.lines[b.at], count=1)
                yield plant('end of a full circle beside its start', 'arc_nearly_full', b.at, [*p.lines[:b.at], line, *p.lines[b.at + 1:]])
        elif not full:
            other = {'2': '3', '3': '2', '02': '03', '03': '02'}[arc.text]
            kind = 'G2 and G3 exchanged, ' + ('R' if b.find('R') else 'I J')
            yield plant(kind, 'arc_against_neighbours', b.at, p.replaced(b.at, arc, f'G{other}'))


# ---- heights

def inside(p, at):
    """True if the tool is over cut material when the block starts; next to the stock a rapid may go down."""
    place = {}
    for b in p.blocks[:at]:
        place.update({w.letter: p.value(w) for w in b.words if w.letter in 'XY' and not b.incremental})
    for letter in 'XY':
        ends = [p.value(w) for b in p.blocks if b.cuts() and not b.incremental for w in b.words if w.letter == letter]
        if letter not in place or not ends or not min(ends) + 0.6 < place[letter] < max(ends) - 0.6:
            return False
    return True


def rapid_mistakes(p):
    lowest = 0
    for b in p.blocks:
        z = b.find('Z')
        if not z or b.incremental or b.has('G', 28, 53, 26, 49) or b.cycle or b.section:
            continue
        low = p.value(z) < min(lowest, 0) - 0.02
        if b.motion == 1 and not b.sideways():
            if low and b.code('G', 1) and inside(p, b.at):
                code = b.code('G', 1)
                yield plant('G0 for G1 downwards', 'rapid_below_zero', b.at, p.replaced(b.at, code, 'G' + '0' * len(code.text)))
            lowest = min(lowest, p.value(z))
        elif b.motion == 0 and not b.sideways() and 0 < p.value(z) < 10 and -p.value(z) < lowest - 0.02 and inside(p, b.at):
            yield plant('sign of Z before the cut', 'rapid_below_zero', b.at, p.replaced(b.at, z, 'Z' + p.written('Z', -p.value(z))))


def low_mistakes(p):
    """Drops the retract between two cuts; the rapid after it is reported."""
    for b, following in zip(p.blocks, p.blocks[1:]):
        z = b.find('Z')
        if z and not b.sideways() and not b.cycle and (b.motion == 0 or p.control == 'gost') and p.value(z) > 0 and not b.section:
            if following.code('G', 0) and following.sideways() and following.tool == b.tool and p.blocks[b.at - 1].cuts():
                yield plant('retract dropped', 'rapid_sideways_low', following.at - 1, [*p.lines[:b.at], *p.lines[b.at + 1:]])
        if b.section and z and b.code('G', 0) and p.value(z) > 0:
            caller = next((c for c in reversed(p.blocks) if c.calls == next(s.label for s in p.blocks if s.label and s.section == b.section)), None)
            move = next((c for c in p.blocks[caller.at:] if c.code('G', 0) and c.sideways()), None) if caller else None
            if move and p.control != 'linuxcnc':
                yield plant('retract dropped in a subprogram', 'rapid_sideways_low', move.at, [*p.lines[:b.at], *p.lines[b.at + 1:]])


# ---- program flow and modes

def flow_mistakes(p):
    gotos = [b for b in p.blocks if 'GOTO' in p.lines[b.at]]
    ends = [b for b in p.blocks if b.code('M', 2, 30) and b.section == 0]
    if ends and not gotos and p.control != 'grbl':
        end = ends[0]
        for change in p.tools()[1:]:
            move = next((b for b in p.stint(change) if any(b.has(a) for a in 'XYZ')), None)
            lines = p.inserted(change.at, re.sub(r'^N\d+ ', lambda m: m[0] if p.control in ('s2c42', 'gost', 'correctors') else '', p.lines[end.at]))
            if move:
                yield plant('M30 moved up', 'lines_unreachable', move.at + 1, lines)
    labels = {b.label: b for b in p.blocks if b.label}
    called = [b for b in p.blocks if b.calls]
    for call in called:
        if sum(c.calls == call.calls for c in called) == 1 and len(labels) > 1 and p.control != 'linuxcnc':
            other = next(n for n in labels if n != call.calls)
            at = labels[call.calls].at
            yield plant('call of another subprogram', 'subprogram_uncalled', at, [l.replace(f'P{call.calls}', f'P{other}') if i == call.at else l for i, l in enumerate(p.lines)])
    for b in gotos:
        target = re.search(r'GOTO (\d+)', p.lines[b.at])[1]
        numbers = {w.text for c in p.blocks for w in c.words if w.letter == 'N'}
        for wrong in sorted({'9999', target + '5', '1' + target} - numbers):
            yield plant('number of GOTO', 'jump_to_nowhere', b.at, [l.replace(f'GOTO {target}', f'GOTO {wrong}') if i == b.at else l for i, l in enumerate(p.lines)])
        for twin in p.blocks[b.at + 1::4]:
            number = twin.find('N')
            if number and number.text != target:
                yield plant('a block number twice', 'jump_to_two', b.at, p.replaced(twin.at, number, f'N{target}'))


def end_mistakes(p):
    """The file is truncated in transfer, after a cut of the main program. The other controls miss the end, or the closing %: they warn, or
    stop."""
    if p.control not in ('mach3', 'grbl'):
        return
    lifted = False   # by a rapid, since the tool change
    for b in p.blocks:
        lifted = (lifted or bool(b.motion == 0 and b.find('Z') and p.value(b.find('Z')) > 0)) and not b.code('M', 6)
        if lifted and b.motion in (1, 2, 3) and b.sideways() and b.cuts() and not b.cycle and not b.section and not b.find('Z'):
            yield plant('file cut off', 'end_missing', b.at, p.lines[:b.at + 1])


def mode_mistakes(p):
    """For a program whose head does not set the mode, and whose end does not reset it."""
    moved = next((b.at for b in p.blocks if any(b.has(a) for a in 'XYZ')), 0)
    if p.control in ('grbl', 'linuxcnc'):   # M2 and M30 restore G90
        return
    head = p.blocks[:moved + 1]
    on = {b.at for b in p.blocks if b.code('G', 91, 68)}
    for at in on:
        b = p.blocks[at]
        code = b.code('G', 91, 68)
        off = [c for c in p.blocks[at:] if c.code('G', 90 if code.number == 91 else 69)]
        if code.number == 68 and off and not any(h.code('G', 69) for h in head):
            yield plant('G69 dropped', 'mode_left_on', at, p.replaced(off[0].at, off[0].code('G', 69), ''))
        last = off and not any(c.has(a) for c in p.blocks[off[0].at:] for a in 'XYZ' if c.section == b.section)
        if code.number == 91 and last and not b.section and not any(h.code('G', 90, 91) for h in head):
            yield plant('G90 dropped at the end', 'mode_left_on', at, p.replaced(off[0].at, off[0].code('G', 90), ''))


KINDS = (point_dropped, digit_too_many, unit_changed, offset_of_another, length_dropped, spindle_mistakes, coolant_dropped, system_changed,
         tool_not_changed, retract_dropped, feed_mistakes, tooth_mistakes, tap_mistakes, speed_mistakes, table_mistakes, cycle_mistakes, compensation_mistakes,
         arc_mistakes, rapid_mistakes, low_mistakes, flow_mistakes, end_mistakes, mode_mistakes)


def lathe_mistakes(p):
    """The limit of the spindle speed, the speed of a thread, the face of the chuck nearer than the program expects it, and the sign of a wear."""
    limits = [b for b in p.blocks if b.code('G', 50) and b.find('S')]
    surface = next((b for b in p.blocks if b.code('G', 96)), None)
    if limits and surface:
        at = {b.at for b in limits}
        cut = next(b for b in p.blocks[surface.at:] if b.motion == 1 and (b.has('X') or b.has('Z')))
        yield plant('no G50 S', 'surface_speed_unlimited', cut.at - sum(a < cut.at for a in at), [l for i, l in enumerate(p.lines) if i not in at])
    rapid = ((p.setup or {}).get('machine') or {}).get('Z', {}).get('rapid')
    thread = next((b for b in p.blocks if b.code('G', 32) or (b.code('G', 76) and b.find('X'))), None)
    if thread and rapid:
        speed = next(b for b in reversed(p.blocks[:thread.at]) if b.find('S'))
        for more in (1.1, 4):
            yield plant('S of a thread', 'thread_beyond_rapid', thread.at, p.replaced(speed.at, speed.find('S'), f'S{round(rapid / thread.find("F").number * more)}'))
    if p.setup and 'chuck_face' in p.setup and not any(b.code('G', 71, 72, 73) for b in p.blocks):
        depths = [(p.value(b.find('Z')), b) for b in p.blocks if b.find('Z') and not b.code('G', 28)]
        lowest = min(depth for depth, _ in depths)
        first = next(b for depth, b in depths if depth == lowest)
        yield plant('the chuck nearer', 'beyond_chuck_face', first.at, list(p.lines), {**p.setup, 'chuck_face': lowest + 0.5})


    offsets = (p.setup or {}).get('offsets', {})
    for number, row in offsets.items():
        call = next((b for b in p.blocks if b.find('T') and int(b.find('T').number) % 100 == int(number)), None)
        points = {2: 1, 3: -1, 4: -1, 6: 1}.get(row.get('tip'))   # along X
        if call and points:
            setup = {**p.setup, 'offsets': {**offsets, number: {**row, 'X_wear': -0.2 * points}}}
            yield plant('wear with the wrong sign', 'wear_sign', call.at, list(p.lines), setup)


def all_of(program):
    """Returns each mistake of every type once. The mistakes of mills are not planted into the programs of lathes."""
    seen = set()
    for kind in [lathe_mistakes] if program.control in LATHES else KINDS:
        for m in kind(program):
            text = tuple(m.text), m.setup is None, tuple(m.tools or ()), m.most_rpm
            if (m.text != program.lines or m.tools or m.setup or m.most_rpm) and text not in seen:
                seen.add(text)
                yield m
