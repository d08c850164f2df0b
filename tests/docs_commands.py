#!/usr/bin/env python3
"""Runs every command that the pages print and compares its output with the page: README*.md, CONTRIBUTING.md, docs/**/*.md.

    docs_commands.py --kadr build/release/kadr [PAGE…] [--list] [--update] [--times]

A page prints commands in blocks of code, indented or between ```:

    $ kadr controls             a command; what it prints follows, up to the next `$ ` or the end of the block
    …                           on a line of its own: any lines; `...` is the same. At the end of a line, or without blanks around it:
                                anything
    (kadr) step                 typed at the prompt of `kadr debug`, which is a terminal then
    kadr mill face PLATE …      in a block without `$ `: a form with placeholders; the command and its options must be in `kadr COMMAND
                                --help`
    kadr check FILE             without placeholders: it must end with status 0; its output is not compared

A command within a sentence (`kadr check --strict`) is a form too.

The commands of a section run in order, in a fresh folder with `examples/` (a copy, which they must leave as it is) and with `kadr` in the
PATH: a command may use files that an earlier one wrote, and nothing is written into the checkout. `kadr serve` is stopped when it has
printed its address. NOT_RUN names the commands that are not run, with the reason. Standard output and standard error are compared as one
text. MASKS replace what differs from run to run.

--list prints what would be done with each command, --update writes what the program prints into the pages, around their `…`; --times prints
the processor time of each. Prints a line per failure, then `N passed, N failed`. Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import dataclasses
import difflib
import functools
import os
import pty
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import termios
from pathlib import Path

import harness
from harness import ROOT, TIME_LIMIT_S, expect

# The first word of a command, or its beginning, and why the test does not run it.
NOT_RUN = {
    'make': 'builds, tests or installs the whole of Kadr',
    'dev/': 'a tool for those who build Kadr, which builds, tests or installs',
    'KADR=': 'a tool for those who build Kadr',
    'cmake': 'compiles',
    'g++': 'compiles',
    'bench/': 'measures speed, for minutes',
    'build/bench/': 'measures speed, for minutes',
    'build/examples/': 'is built, run and compared by tests/library.py',
}
COMMAND = re.compile(r'(?:kadr|build/release/kadr) |' + '|'.join(re.escape(word) for word in NOT_RUN))
PLACEHOLDER = re.compile(r'\[|…|(?<!\S)[A-ZА-ЯЁ]+(?!\S)')
PROMPT = '(kadr) '   # of kadr debug
WITH_SUBCOMMANDS = ('mill', 'state', 'tape')
OPTION = re.compile(r'(?<![\w-])--?[a-z][\w-]*')
MASKS = [(re.compile(pattern), mask) for pattern, mask in (
    (r'\bkadr \d+\.\d+\.\d+', 'kadr VERSION'),
    (r'http://127\.0\.0\.1:\d+/#token=[0-9a-f]+…?', 'http://ADDRESS'),
    (r'/tmp/[\w./-]+', '/tmp/PATH'),
)]


def told(page):
    """The name of a page in messages."""
    return page.relative_to(ROOT) if page.is_relative_to(ROOT) else page


@dataclasses.dataclass
class Command:
    """A command of a page, and the output that the page shows."""
    page: Path
    line: int          # in the page, from 1
    section: int       # in the page, counted by headings
    indent: str
    prompted: bool     # after `$ `
    text: str
    printed: list

    def __str__(self):
        return f'{told(self.page)}:{self.line}: {self.text}'

    def not_run(self):
        """Why the command is not run, or None."""
        return next((why for start, why in NOT_RUN.items() if self.text.startswith(start)), None)

    def done(self):
        """What the test does with the command, for --list."""
        if why := self.not_run():
            return f'not run: {why}'
        if self.prompted:
            return 'compared'
        return 'form' if PLACEHOLDER.search(self.text) else 'run'

    def said(self):
        """The output that the page shows; blank lines before the next command only separate the two."""
        return self.printed[:max((number for number, line in enumerate(self.printed, 1) if line.strip()), default=0)]

    def typed(self):
        """The input at the prompt of `kadr debug`."""
        return [line.removeprefix(PROMPT) for line in self.printed if line.startswith(PROMPT)]


# ---- the pages

def pages():
    return [*sorted(ROOT.glob('README*.md')), ROOT / 'CONTRIBUTING.md', *sorted((ROOT / 'docs').rglob('*.md'))]


def blocks(lines):
    """Yields (section, number of the first line from 1, lines) of each block of code of a page."""
    section, block, first, fenced, before = 0, None, 0, False, ''
    for number, line in enumerate([*lines, ''], 1):
        if line.lstrip().startswith('```'):
            if fenced and block:
                yield section, first, block
            fenced, block, first = not fenced, [], number + 1
        elif fenced:
            block.append(line)
        elif line.startswith('    ') and (block or not before.strip() or before.startswith('#')):
            block, first = (block, first) if block else ([], number)
            block.append(line)
        elif block and not line.strip() and number <= len(lines):
            block.append(line)
        else:
            if block:
                yield section, first, block
            block = None
            section += line.startswith('#')
        before = line


def commands_of(page):
    """Returns the commands of a page, in order."""
    commands = []
    for section, first, block in blocks(page.read_text(encoding='utf-8').splitlines()):
        indent = min((re.match(' *', line)[0] for line in block if line.strip()), key=len, default='')
        lines = [line.removeprefix(indent) for line in block]
        prompted = any(line.startswith('$ ') for line in lines)
        printed = []   # output of the command above
        for number, line in enumerate(lines, first):
            if line.startswith('$ ') if prompted else COMMAND.match(line):
                printed = []
                commands.append(Command(page, number, section, indent, prompted, line.removeprefix('$ '), printed))
            elif prompted:
                printed.append(line)
    return commands


# ---- comparing a page with the program's output

def masked(line):
    for pattern, mask in MASKS:
        line = pattern.sub(mask, line)
    return line


def any_lines(line):
    return line.strip() in ('…', '...')


def pattern_of(line):
    """Returns the pattern of a line of a page that is not `…` alone. ` … ` between two figures is the program's own text."""
    return '.*'.join(map(re.escape, re.split(r'(?<=\S)…|…$', masked(line))))


def same(said, line):
    return re.fullmatch(pattern_of(said), masked(line)) is not None


def aligned(printed, got):
    """Returns pairs (line of the page or None, line of the program or None) that differ as little as possible, and whether all are equal;
    `…` of a page matches any lines."""
    alone = 1.0   # cost of an unmatched line; two lines that have nothing in common cost as much as two unmatched ones
    cost = [[0.0] * (len(got) + 1) for _ in range(len(printed) + 1)]
    step = [[''] * (len(got) + 1) for _ in range(len(printed) + 1)]
    for i in range(len(printed), -1, -1):
        for j in range(len(got), -1, -1):
            ways = []
            free = i < len(printed) and any_lines(printed[i])
            if i < len(printed):
                ways.append((cost[i + 1][j] + (0 if free else alone), 'said'))
            if j < len(got):
                ways.append((cost[i][j + 1] + (0 if free else alone), 'passed' if free else 'got'))
            if i < len(printed) and j < len(got) and not free:
                unlike = 0 if same(printed[i], got[j]) else 2 - 2 * difflib.SequenceMatcher(None, printed[i], got[j], False).quick_ratio()
                ways.append((cost[i + 1][j + 1] + unlike, 'both'))
            cost[i][j], step[i][j] = min(ways, default=(0.0, ''))
    i, j, pairs = 0, 0, []
    while step[i][j]:
        way = step[i][j]
        if way != 'passed':
            pairs.append((printed[i] if way in ('said', 'both') else None, got[j] if way in ('got', 'both') else None))
        i, j = i + (way in ('said', 'both')), j + (way in ('got', 'passed', 'both'))
    return pairs, cost[0][0] == 0


def faults_of(printed, got):
    """Returns how the page differs from the program's output."""
    pairs, alike = aligned(printed, got)
    if alike:
        return
    shown = []
    for said, line in pairs:
        if said is not None and line is not None and same(said, line) or said is not None and any_lines(said):
            continue
        shown += [f'    page    {said}'] * (said is not None) + [f'    program {line}'] * (line is not None)
    yield '\n' + '\n'.join(shown[:12])


def renewed(printed, got):
    """Returns the corrected lines of a page: the program's lines where they differ, with the `…` of the page kept."""
    for said, line in aligned(printed, got)[0]:
        if said is not None and (any_lines(said) or line is not None and same(said, line)):
            yield said
        elif line is not None:
            yield line


# ---- running them

def contents(folder):
    """Returns every file of a folder with its contents."""
    return {path.relative_to(folder): path.read_bytes() for path in Path(folder).rglob('*') if path.is_file()}


class Folder:
    """The folder where the commands of a section run: it has the examples, and `kadr` in the PATH."""

    def __init__(self, kadr, examples, at):
        self.at = Path(at)
        self.place = self.at / 'kadr'   # the root of the project, as far as readers need it
        for link, to in ((self.at / 'bin/kadr', kadr), (self.place / 'build/release/kadr', kadr), (self.place / 'examples', examples)):
            link.parent.mkdir(parents=True, exist_ok=True)
            link.symlink_to(to)
        self.add_archive(Path(kadr).parent / 'python')
        self.environment = {**os.environ, 'PATH': f'{self.at / "bin"}:{os.environ["PATH"]}', 'LANG': 'C', 'HOME': str(self.at), 'TMPDIR': str(self.at)}
        for name in ('LC_ALL', 'LC_MESSAGES', 'LANGUAGE'):
            self.environment.pop(name, None)

    def add_archive(self, python):
        """Adds kadr-archive, if the Python binding is built."""
        if list(python.glob('kadr/_kadr*.so')):
            script = self.at / 'bin/kadr-archive'
            script.write_text(f'#!/bin/sh\nPYTHONPATH={shlex.quote(str(python))} exec /usr/bin/python3 -B -m kadr_archive "$@"\n', encoding='utf-8')
            script.chmod(0o755)

    def run(self, command):
        """Executes a command.  returns its status, its output as lines, and its processor time in s"""
        printed, typed = self.at / 'printed', command.typed()
        ends = typing(typed) if typed else (subprocess.DEVNULL,)
        with open(printed, 'wb') as out:
            process = subprocess.Popen(['bash', '-c', command.text], cwd=self.place, env=self.environment, stdin=ends[-1], stdout=out,
                                       stderr=subprocess.STDOUT, start_new_session=True)
        endless = command.text.startswith('kadr serve ')
        if endless:
            harness.until(lambda: b'\n' in printed.read_bytes() or harness.ended(process))
            os.killpg(process.pid, signal.SIGTERM)
        if not harness.until(lambda: harness.ended(process)):
            os.killpg(process.pid, signal.SIGKILL)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        for end in ends if typed else ():
            os.close(end)
        expect(process.returncode != -signal.SIGKILL, f'no end within {TIME_LIMIT_S} s')
        status = 0 if endless and process.returncode in (143, -signal.SIGTERM) else process.returncode
        text = printed.read_bytes().decode('utf-8', 'replace')
        for line in typed:   # the prompt is printed, the input is not
            text = text.replace(PROMPT, f'\0{line}\n', 1)
        return status, text.replace('\0', PROMPT).splitlines(), used.ru_utime + used.ru_stime


def typing(lines):
    """Opens a terminal without echo on which the lines are typed.  returns its two ends; the second is the program's"""
    keyboard, terminal = pty.openpty()
    attributes = termios.tcgetattr(terminal)
    attributes[3] &= ~termios.ECHO
    termios.tcsetattr(terminal, termios.TCSANOW, attributes)
    os.write(keyboard, ''.join(f'{line}\n' for line in lines).encode() + b'\x04')
    return keyboard, terminal


@functools.cache
def options_of(kadr, *command):
    """Returns the options in the help of a command; None if there is no such command."""
    done = subprocess.run([kadr, *command, '--help', '--lang', 'en'], capture_output=True, text=True, timeout=TIME_LIMIT_S)
    return None if done.returncode else set(OPTION.findall(done.stdout))


def form_faults(kadr, text):
    """Returns the parts of a form (`kadr COMMAND FILE [--option]`, several on a line with two blanks between) that the help does not list."""
    for form in re.split(r'\s{2,}(?=kadr )', text):
        words = form.split()[1:]
        length = 0 if words[0].startswith('-') or words[0].isupper() else 2 if words[0] in WITH_SUBCOMMANDS else 1
        command = [word.split('|')[0] for word in words[:length]]
        known = options_of(kadr, *command)
        if known is None:
            yield f'there is no kadr {" ".join(command)}'
            continue
        for option in sorted(set(OPTION.findall(form)) - known):
            yield f'{option} is not in kadr {" ".join(command)} --help'


@dataclasses.dataclass
class Outcome:
    command: Command
    faults: list
    got: list | None = None    # the output that is compared
    seconds: float = 0         # of processor time


def outcome_of(folder, kadr, command):
    if command.done() == 'form':
        return Outcome(command, list(form_faults(kadr, command.text)))
    try:
        status, got, seconds = folder.run(command)
    except harness.Failure as failure:
        return Outcome(command, [str(failure)])
    if command.done() == 'run':
        return Outcome(command, [] if status == 0 else [f'exit status {status}; {" ".join(got)[:400]}'], None, seconds)
    faults = [f'exit status {status}; {" ".join(got)[:400]}'] if status > 2 else list(faults_of(command.said(), got))
    if not command.said() and status > 1 and not faults:
        faults = [f'exit status {status}']
    return Outcome(command, faults, got, seconds)


def outcomes_of(kadr, examples, commands):
    """Returns the outcomes of the commands of a section; if a tool is not installed, of the commands before it."""
    outcomes = []
    with tempfile.TemporaryDirectory(prefix='kadr_docs_') as at:
        folder = Folder(kadr, examples, at)
        for command in commands:
            tool = command.text.split()[0]
            if shutil.which(tool, path=folder.environment['PATH']) is None and not (folder.place / tool).exists():
                harness.skipped(f'{tool} is not installed: {command} and what follows in its section')
                break
            outcomes.append(outcome_of(folder, kadr, command))
    return outcomes


def sections_of(commands):
    """Groups the commands that are run by section."""
    found = {}
    for command in commands:
        if not command.not_run():
            found.setdefault((command.page, command.section), []).append(command)
    return list(found.values())


# ---- tests of this runner, and of names in the pages

PAGE = """# Title

    $ kadr one  # says so
    1
    …

    $ kadr two

Text, and in a list:

      $ kadr three
      3 … 4

## Section

```
kadr run PROGRAM [--lang en|ru]
kadr controls
```
"""


def judge_itself(tally, folder):
    """Tests how a page is read, and what counts as equal."""
    page = Path(folder) / 'page.md'
    page.write_text(PAGE, encoding='utf-8')
    read = [(c.line, c.section, c.text, c.said(), c.done()) for c in commands_of(page)]
    tally.same('a page', read, [(3, 1, 'kadr one  # says so', ['1', '…'], 'compared'), (7, 1, 'kadr two', [], 'compared'), (11, 1, 'kadr three', ['3 … 4'], 'compared'),
                                (17, 2, 'kadr run PROGRAM [--lang en|ru]', [], 'form'), (18, 2, 'kadr controls', [], 'run')])
    for printed, got, new in ((['1', '…', '3'], ['1', '2', '2', '3'], None), (['1', '...'], ['1'], None), ([], [], None), (['{"a":1,…}'], ['{"a":1,"b":2}'], None),
                              (['kadr 0.1.0'], ['kadr 0.2.0'], None), (['X -1 … 1'], ['X -1 … 0 1'], ['X -1 … 0 1']), (['1', '3'], ['1', '2', '3'], ['1', '2', '3']),
                              (['1'], [], []), ([], ['1'], ['1']), (['a 1', '…', 'b 2', 'c 3'], ['a 0', 'x', 'b 2', 'c 4', 'd'], ['a 0', '…', 'b 2', 'c 4', 'd'])):
        tally.same(f'{printed} and {got}', (bool(list(faults_of(printed, got))), list(renewed(printed, got))), (new is not None, printed if new is None else new))


def judge_sentences(tally, kadr, page):
    """Tests commands within the sentences of a page, `kadr check --strict`: they are forms."""
    for number, line in enumerate(page.read_text(encoding='utf-8').splitlines(), 1):
        for text in re.findall(r'`(kadr [^`]+)`', line):
            tally.judge(f'{told(page)}:{number}: {text}', form_faults(kadr, text))


def judge_examples(tally):
    """The example files that exist only for the pages."""
    text = ''.join(page.read_text(encoding='utf-8') for page in pages())
    tally.judge('examples/docs', [f'no page names {path.name}' for path in sorted((ROOT / 'examples/docs').iterdir()) if f'examples/docs/{path.name}' not in text])


# ---- updating the pages

def update(page, outcomes):
    """Writes the program's output into a page."""
    lines = page.read_text(encoding='utf-8').splitlines()
    for outcome in reversed(outcomes):
        command = outcome.command
        if outcome.got is None or not outcome.faults:
            continue
        new = [(command.indent + line).rstrip() for line in renewed(command.said(), outcome.got)]
        lines[command.line:command.line + len(command.said())] = new
    page.write_text('\n'.join(lines) + '\n', encoding='utf-8')


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('pages', nargs='*', type=Path, metavar='PAGE', help='only these pages')
    parser.add_argument('--without', metavar='NAME', help='leave out the pages of that name, for example cut.md')
    parser.add_argument('--list', action='store_true', help='only print what would be done with each command')
    parser.add_argument('--update', action='store_true', help='write what the program prints into the pages')
    parser.add_argument('--times', action='store_true', help='print the processor time of each command')
    parser.add_argument('--jobs', type=int, default=harness.CORES, help='sections run at the same time')
    options = harness.parsed(parser)
    chosen = [page.resolve() for page in options.pages] or [page for page in pages() if page.name != options.without]
    for page in chosen:
        if not page.is_file():
            parser.error(f'{page}: no such page')
    commands = [command for page in chosen for command in commands_of(page)]
    if options.list:
        for command in commands:
            print(f'{command}\n    {command.done()}')
        return 0
    tally, by_page = harness.Tally(), {}
    with tempfile.TemporaryDirectory(prefix='kadr_docs_') as at:
        examples = Path(at) / 'examples'
        judge_itself(tally, at)
        judge_examples(tally)
        for page in chosen:
            judge_sentences(tally, options.kadr, page)
        shutil.copytree(ROOT / 'examples', examples, ignore=shutil.ignore_patterns('*.png', 'pictures'))
        before = contents(examples)
        for outcomes in harness.each(lambda section: outcomes_of(options.kadr, examples, section), sections_of(commands), options.jobs):
            for outcome in outcomes:
                tally.judge(outcome.command, outcome.faults)
                if options.times:
                    print(f'{outcome.seconds:6.2f} s {outcome.command}')
                by_page.setdefault(outcome.command.page, []).append(outcome)
        after = contents(examples)
    tally.judge('examples stay as they are', [f'{path} is changed or new' for path in sorted(after) if after[path] != before.get(path)])
    if options.update:
        for page, outcomes in by_page.items():
            update(page, outcomes)
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
