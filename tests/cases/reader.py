"""Reads tests/cases/CONTROL/TOPIC.cases: cases with the keys of tests/golden/README.md, written like the examples of a manual.

    == turn-single-block | 19.B | inferred            id | source | basis; the control is the folder
    Single block stops after each pass                title
    derivation one stop a place                       how the expected figures follow
    setup {"start": {"X": 50, "Z": 10}, …}            JSON; left out if empty
        G74.7 R0                                      the program: lines indented by four blanks,
        G74.7 X44 Z5 P6 Q5   -> feed Z5 -> rapid Z10  after ->: their actions, in the order of the text
                             -> stop single_block
    then feed Z5 -> rapid Z10                         actions not tied to a line: loops, subprograms; `then nothing` = none at all
    end X44 Z5                                        the keys of `expect`: the run as a whole
    variables #100=5 #101=vacant
    alarm 2012 line 2 text "…"                        alarm any_number: no number is stated; alarm none; alarm not_judged

An action: its type (`motion` = any motion), the end point's words (X2=5 for a name of several characters), then its other keys
with their values: `arc_ccw X0 Y10 center X0 Y0 turns 0.25`; shortly `dwell 2`, `spindle cw rpm 500`, `tool 5`, `m M70`, `stop
single_block`.
Any value may be a JSON string, list or object.
`why TEXT`: the case cannot be run, for this reason. `notes TEXT`. `subset`, `open`, `unordered`, `optional`, `loose` have no value.
`file NAME`, `channel N`: the indented lines that follow are that file of the program memory, the program of that channel.
`-- NAME`: a variant; the lines below it replace those above.
A program line that is empty, ends in a blank, contains a tab, … is written as a JSON string. `| ` continues the keyed line before it.
A line that begins with # and a blank is a comment.
"""
import json
import re
from pathlib import Path

CASES = Path(__file__).resolve().parent
INDENT = '    '
ARROW = '->'
FLAGS = ('subset', 'open', 'unordered')
TABLES = ('state', 'channels', 'files', 'steps')
OF_CASE = ('derivation', 'notes', 'why')
POINTS = ('to', 'programmed', 'tip', 'machine', 'contact', 'travel', 'center', 'tool_dir', 'normal')
VALUES = ('block', 'line', 'plane', 'turns', 'length', 'feed', 'unit', 'feed_max', 'feed_end', 'exact', 'seconds', 'lead', 'angle', 'turn',
          'points', 'spindle', 'dir', 'rpm', 'range', 'code', 'tool', 'data', 'magazine', 'pocket', 'address', 'value', 'number', 'text',
          'reason', 'channels', 'at', 'torque', 'master', 'slave', 'ratio', 'phase', 'note')
MARKS = ('optional', 'loose')
AT_ONCE = {'m': 'code', 'sync': 'code', 'stop': 'reason', 'spindle': 'dir', 'tool': 'tool', 'toolchange': 'tool', 'dwell': 'seconds',
           'message': 'text'}                          # the key whose value may follow the type of the action directly: `dwell 2`
OF_ALARM = ('line', 'block', 'text', 'text_en', 'text_ru')
NUMBER = r'-?(?:\d+\.?\d*|\.\d+)(?:e-?\d+)?'
WORD = re.compile(rf'([A-Z])({NUMBER})|([A-Z][A-Z0-9]*)=({NUMBER})')
CONTROL_CHARACTER = re.compile(r'[\x00-\x1f\x7f]')


class Unreadable(Exception):
    """A line that cannot be read; the message names the fault."""


# ---------------------------------------------------------------- values

def unique(pairs):
    keys = [key for key, _ in pairs]
    for key in keys:
        if keys.count(key) > 1:
            raise Unreadable(f'{key!r} stands twice')
    return dict(pairs)


JSON = json.JSONDecoder(object_pairs_hook=unique)


def json_of(text):
    try:
        return JSON.decode(text)
    except json.JSONDecodeError as error:
        raise Unreadable(f'no JSON: {error}') from None


def number_of(text):
    if not re.fullmatch(NUMBER, text):
        raise Unreadable(f'{text!r} is no number')
    return int(text) if re.fullmatch(r'-?\d+', text) else float(text)


def tokens_of(text):
    """Returns the (bare, text) pairs of words and the (json, value) pairs of JSON strings, lists and objects."""
    at, tokens = 0, []
    while at < len(text):
        if text[at] == ' ':
            at += 1
        elif text[at] in '"[{':
            try:
                value, at = JSON.raw_decode(text, at)
            except json.JSONDecodeError as error:
                raise Unreadable(f'no JSON: {error}') from None
            tokens.append(('json', value))
        else:
            word = text[at:].split(' ', 1)[0]
            at += len(word)
            tokens.append(('bare', word))
    return tokens


def value_of(token):
    kind, value = token
    if kind == 'json':
        return value
    if value in ('true', 'false'):
        return value == 'true'
    return number_of(value) if re.fullmatch(NUMBER, value) else value


def keyed(tokens, points=(), values=(), marks=(), first=None):
    """Reads `key value` pairs, with points as words, into a dict; words before any key are added to `first`."""
    table, here, left = {}, first, list(tokens)
    while left:
        kind, text = left.pop(0)
        if kind == 'bare' and here and (word := WORD.fullmatch(text)):
            point, axis = table.setdefault(here, {}), word[1] or word[3]
            if axis in point:
                raise Unreadable(f'{axis} stands twice')
            point[axis] = number_of(word[2] or word[4])
            continue
        if kind != 'bare' or text not in (*points, *values, *marks):
            raise Unreadable(f'{text!r} is neither a word nor a key')
        if text in table:
            raise Unreadable(f'{text} stands twice')
        here = text if text in points else None
        if text in values and not left:
            raise Unreadable(f'{text} has no value')
        table[text] = {} if here else True if text in marks else value_of(left.pop(0))
    return table


# ---------------------------------------------------------------- lines

def action_of(tokens):
    if not tokens or tokens[0][0] != 'bare':
        raise Unreadable('an action begins with what it does')
    do, others = tokens[0][1], tokens[1:]
    if do in AT_ONCE and others and others[0][1] not in (*POINTS, *VALUES, *MARKS):
        others = [('bare', AT_ONCE[do]), *others]
    return {**({} if do == 'motion' else {'do': do}), **keyed(others, POINTS, VALUES, MARKS, 'to')}


def actions_of(text):
    """Reads a line of actions: `feed Z5 -> rapid Z10`."""
    parts = [[]]
    for token in tokens_of(text):
        if token == ('bare', ARROW):
            parts.append([])
        else:
            parts[-1].append(token)
    return [action_of(part) for part in parts]


def alarm_of(text):
    (kind, first), *others = tokens_of(text) or [('bare', '')]
    if first in ('none', 'not_judged') and not others:
        return None if first == 'none' else 'any'
    return {'number': None if first == 'any_number' else number_of(str(first)), **keyed(others, values=OF_ALARM)}


def variables_of(text):
    table = {}
    for item in text.split():
        name, equals, value = item.rpartition('=')
        if not equals or name in table:
            raise Unreadable(f'{item!r}: not NAME=VALUE, or twice')
        table[name] = None if value == 'vacant' else number_of(value)
    return table


def expected(key, text):
    if key in FLAGS and not text:
        return True
    if key in TABLES:
        return json_of(text)
    if not text:
        raise Unreadable(f'{key} has no value')
    reader = {'end': lambda: keyed(tokens_of(text), ('to', 'machine'), first='to'), 'variables': lambda: variables_of(text),
              'alarm': lambda: alarm_of(text), 'tolerance': lambda: number_of(text),
              'modal': text.split, 'complete_for': lambda: [] if text == 'nothing' else text.split(), 'modulo': text.split,
              'also': lambda: json_of(text)}.get(key)
    if not reader:
        raise Unreadable(f'unknown key {key!r}')
    return reader()


def program_line(line):
    """Splits an indented line into (text of the program, text of the actions or None)."""
    body = line[len(INDENT):]
    if body.startswith('"'):
        try:
            text, length = JSON.raw_decode(body)
        except json.JSONDecodeError as error:
            raise Unreadable(f'no JSON string: {error}') from None
        rest = body[length:]
    else:
        found = re.fullmatch(rf'(.*?)(?: +({ARROW} .*))?', body)
        text, rest = found[1], found[2] or ''
        if text != text.strip() or not text or CONTROL_CHARACTER.search(body) or ARROW in text:
            raise Unreadable('this line of a program must be written as a JSON string')
    rest = rest.strip()
    if rest and not rest.startswith(ARROW + ' '):
        raise Unreadable(f'{ARROW} is missing behind the string')
    return text, rest[len(ARROW):] if rest else None


# ---------------------------------------------------------------- a case

class Part:
    """A case or a variant while its lines are being read."""

    def __init__(self):
        self.keys, self.setup, self.expect = {}, None, {}
        self.texts = {'program': []}                   # lines of the program, of ('files', NAME), of ('channels', N)
        self.into = 'program'

    def line(self, line):
        """Reads a line that is not empty: indented, or with a key."""
        if line.startswith(INDENT):
            self.indented(line)
            return
        key, _, text = line.partition(' ')
        if key in ('file', 'channel') and text:
            self.into = ('files' if key == 'file' else 'channels', text)
            if self.texts.setdefault(self.into, []):
                raise Unreadable(f'{line} stands twice')
        elif key == 'then':
            self.expect.setdefault('trace', []).extend([] if text == 'nothing' else actions_of(text))
        elif key == 'setup':
            if self.setup is not None or self.into != 'program' or self.texts['program']:
                raise Unreadable('setup stands once, before the program')
            self.setup = json_of(text)
        elif key in OF_CASE:
            if not text or self.keys.setdefault(key, text) is not text:
                raise Unreadable(f'{key} is empty or stands twice')
        elif key in self.expect:
            raise Unreadable(f'{key} stands twice')
        else:
            self.expect[key] = expected(key, text)

    def indented(self, line):
        if line.lstrip().startswith(ARROW + ' '):
            if self.into != 'program' or not self.texts['program']:
                raise Unreadable('actions stand beside a line of the program')
            actions = line.lstrip()[len(ARROW):]
        else:
            text, actions = program_line(line)
            self.texts[self.into].append(text)
        if actions is not None:
            if self.into != 'program':
                raise Unreadable('actions stand beside a line of the program')
            self.expect.setdefault('trace', []).extend(actions_of(actions))

    def whole(self):
        """Returns the dict of the keys that are present."""
        setup = self.setup
        for into, lines in self.texts.items():
            if into == 'program':
                continue
            if not lines:
                raise Unreadable(f'{into[1]} has no line')
            setup = {} if setup is None else setup
            table = setup.setdefault(into[0], {})
            if into[0] == 'files':
                table[into[1]] = '\n'.join(lines)
            else:
                table.setdefault(into[1], {})['program'] = '\n'.join(lines)
        program = {'program': '\n'.join(self.texts['program'])} if self.texts['program'] else {}
        return {**self.keys, **({} if setup is None else {'setup': setup}), **program, **({'expect': self.expect} if self.expect else {})}


def case_of(control, head, lines):
    """Returns the dict of a case; `lines` are (number, line) pairs; errors carry the number of the line."""
    names = [name.strip() for name in head[1][2:].split('|')]
    if len(names) != 3 or not all(names):
        raise Unreadable(f'{head[0]}: a case begins with == ID | SOURCE | BASIS')
    if not lines or lines[0][1].startswith(INDENT):
        raise Unreadable(f'{head[0]}: the title is missing')
    parts, last = [('', Part())], head[0]
    for last, line in lines[1:]:
        try:
            if line.startswith('-- '):
                parts.append((line[3:], Part()))
            else:
                parts[-1][1].line(line)
        except Unreadable as error:
            raise Unreadable(f'{last}: {error}') from None
    try:
        own, *variants = [(name, part.whole()) for name, part in parts]
    except Unreadable as error:
        raise Unreadable(f'{last}: {error}') from None
    if 'program' not in own[1]:
        raise Unreadable(f'{head[0]}: no program')
    case = {'id': names[0], 'control': control, 'source': names[1], 'title': lines[0][1], 'basis': names[2], 'runnable': 'why' not in own[1],
            'setup': {}, 'expect': {}, 'notes': '', **own[1]}
    if variants:
        case['variants'] = [{'name': name, **keys} for name, keys in variants]
    return case


def logical_lines(text):
    """Yields (number, line) without comments and empty lines; continuation lines are joined to the line they continue."""
    lines = []
    for number, line in enumerate(text.split('\n'), 1):
        if line.startswith('| ') and lines and not lines[-1][1].startswith(INDENT):
            lines[-1] = (lines[-1][0], lines[-1][1] + line[1:])
        elif line and not line.startswith('# '):
            lines.append((number, line))
    return lines


def read_text(text, control):
    """Returns ([(line number, case)], [faults 'LINE: …'])."""
    blocks, faults, cases = [], [], []
    for number, line in logical_lines(text):
        if line.startswith('=='):
            blocks.append(((number, line), []))
        elif blocks:
            blocks[-1][1].append((number, line))
        else:
            faults.append(f'{number}: a line before the first case')
    for head, lines in blocks:
        try:
            cases.append((head[0], case_of(control, head, lines)))
        except Unreadable as error:
            faults.append(str(error))
    if not blocks and not faults:
        faults.append('1: no case')
    return cases, faults


def read_all(folder=CASES):
    """Returns ([(FILE:LINE, case)], [faults 'FILE:LINE: …']) of all files below the folder."""
    cases, faults, known = [], [], {}
    for file in sorted(Path(folder).rglob('*.cases')):
        where = file.relative_to(folder)
        try:
            read, wrong = read_text(file.read_bytes().decode('utf-8'), file.parent.name)
        except UnicodeDecodeError as error:
            read, wrong = [], [f'1: {error}']
        faults += [f'{where}:{fault}' for fault in wrong]
        for line, case in read:
            name = (case['control'], case['id'])
            if name in known:
                faults.append(f'{where}:{line}: {case["id"]} stands at {known[name]} too')
            known.setdefault(name, f'{where}:{line}')
            cases.append((f'{where}:{line}', case))
    return cases, faults


def cases():
    """Returns the dicts of all our cases, for runners that use their programs; run_cases.py reports files that cannot be read."""
    read, faults = read_all()
    if faults:
        raise SystemExit('\n'.join(faults))
    return [case for _, case in read]
