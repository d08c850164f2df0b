"""A part program as tests/checklist.py reads it to plant a mistake: its blocks as words, and the modes in force in each. The only knowledge
about a control is how its numbers are written."""
import dataclasses
import json
import re

WORD = re.compile(r'([A-Z])\s*([+-]?(?:\d+\.?\d*|\.\d+))')
SCALE = {'s2c42': {a: 1000 for a in 'XYZIJK'}, 'gost': {**{a: 1000 for a in 'XYIJ'}, 'Z': 100}}   # increments per millimetre
POINTED = ('fanuc', 'fanuc-t', 'haas', 'nct', 'correctors')


@dataclasses.dataclass
class Word:
    letter: str
    text: str
    begin: int
    end: int

    @property
    def number(self):
        return float(self.text)


@dataclasses.dataclass
class Block:
    """One line; `motion`, `cycle`, `side`, `tool` and `incremental` are in force when it is executed."""
    at: int
    words: list
    motion: int = 0
    cycle: int = 0
    side: bool = False
    incremental: bool = False
    tool: int = 0
    section: int = 0     # 0: the program; each subprogram has the next number
    label: int = 0       # number of the subprogram that starts here
    calls: int = 0       # number of the called subprogram

    def find(self, letter):
        return next((w for w in self.words if w.letter == letter), None)

    def has(self, letter, *numbers):
        return any(w.letter == letter and (not numbers or w.number in numbers) for w in self.words)

    def sideways(self):
        return self.has('X') or self.has('Y')

    def code(self, letter, *numbers):
        return next((w for w in self.words if w.letter == letter and w.number in numbers), None)

    def cuts(self):
        return bool(self.cycle and self.sideways()) or (self.motion in (1, 2, 3) and (self.sideways() or self.has('I')) and not self.has('G', 28, 53))


def without_comments(line):
    """Replaces comments with blanks; the length stays the same."""
    return re.sub(r'\([^)]*\)|;.*', lambda m: ' ' * len(m[0]), line)


class Program:
    def __init__(self, control, path):
        self.control, self.name = control, f'{control}/{path.stem}'
        self.lines = path.read_text(encoding='utf-8').splitlines()
        setup = path.with_suffix('.json')
        self.setup = json.loads(setup.read_text(encoding='utf-8')) if setup.exists() else None
        self.blocks = self.read()

    def read(self):
        blocks, now, selected = [], Block(0, []), 0
        for at, line in enumerate(self.lines):
            bare = without_comments(line)
            if self.control == 's2c42':
                bare = bare.replace('ПС', '  ')
            words = [Word(m[1], m[2], m.start(), m.end()) for m in WORD.finditer(bare)]
            block = dataclasses.replace(now, at=at, words=words, label=0, calls=0)
            self.flow(block, bare)
            for w in words:
                if w.letter == 'G':
                    self.mode(block, w.number)
                if w.letter == 'T':
                    selected = int(w.number) // 100 if self.control in ('gost', 'correctors') else int(w.number)
            if block.code('M', 6):
                block.tool = selected
            blocks.append(block)
            now = block
        return blocks

    @staticmethod
    def flow(block, bare):
        label = re.match(r'\s*O(\d+)\s*(sub)?\s*$', bare)
        if label and block.at > 1:
            block.section, block.label = block.section + 1, int(label[1])
        if re.match(r'\s*O\d+ endsub', bare):
            block.section = 0
        call = re.match(r'\s*O(\d+) call', bare) or re.search(r'M98\s*P(\d+)', bare)
        block.calls = int(call[1]) if call else 0

    @staticmethod
    def mode(block, code):
        if code in (0, 1, 2, 3):
            block.motion, block.cycle = int(code), 0
        elif 73 <= code <= 89 and code != 80:
            block.cycle = int(code)
        elif code == 80:
            block.cycle = 0
        elif code in (40, 41, 42):
            block.side = code != 40
        elif code in (90, 91):
            block.incremental = code == 91

    # ---- numbers

    def written(self, letter, value):
        """Writes a length in mm as this control does."""
        if self.control in SCALE:
            return str(round(value * SCALE[self.control].get(letter, 1)))
        text = f'{value:.4f}'.rstrip('0')
        return text if self.control in POINTED else text.rstrip('.')

    def value(self, word):
        return word.number / SCALE.get(self.control, {}).get(word.letter, 1)

    # ---- the text with a change

    def replaced(self, at, word, new):
        """Returns the text with a word replaced; `new`: the whole new word, or empty to remove it."""
        line = self.lines[at]
        text = line[:word.begin] + new + line[word.end:]
        return [*self.lines[:at], re.sub(r'  +', ' ', text) if not new else text, *self.lines[at + 1:]]

    def inserted(self, at, *new):
        return [*self.lines[:at], *new, *self.lines[at:]]

    def own_line(self, words):
        """Writes words as a line of this control."""
        return {'s2c42': f'N9000 {words} ПС', 'gost': f'N9000 {words} LF', 'correctors': f'N900 {words} LF'}.get(self.control, words)

    # ---- queries

    def tools(self):
        """Returns the blocks that change the tool."""
        return [b for b in self.blocks if b.code('M', 6)]

    def numbers(self):
        """Returns the numbers of all tools that the program calls; empty if it calls none."""
        return sorted({b.tool for b in self.tools()}) or None

    def first_call(self, tool=None):
        """Returns the first block whose T calls that tool, or any tool."""
        for b in self.blocks:
            word = b.find('T')
            number = word and (int(word.number) // 100 if self.control in ('gost', 'correctors') else int(word.number))
            if word and tool in (None, number):
                return b
        return None

    def stint(self, change):
        """Returns the blocks from a tool change to the next, or to the end of the program."""
        stint = []
        for b in self.blocks[change.at + 1:]:
            if b.code('M', 6) or b.section != change.section:
                break
            stint.append(b)
        return stint

    def first_cut(self, blocks):
        """Returns the first block that cuts sideways or drills; for a call, in the subprogram."""
        for b in blocks:
            if b.calls:
                sections = {s.label: s.section for s in self.blocks if s.label}
                inside = self.first_cut([s for s in self.blocks if s.section == sections.get(b.calls, -1) and not s.calls])
                if inside:
                    return inside
            if b.cuts():
                return b
        return None
