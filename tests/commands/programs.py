"""Runs every command over one program: the examples as dev/examples calls them, the golden programs as tests/golden/check.py lays them out.
Used by tests/every_command.py."""
import dataclasses
import json
import re
import shutil
import tempfile
import threading
import tomllib
from pathlib import Path

import harness
from commands.observed import Kadr, not_json, text
from golden import check as golden

EXAMPLES = harness.ROOT / 'examples'
PROGRAMS = ('.nc', '.nct', '.tap', '.ngc', '.mpf', '.h', '.tape')
CONTROLS = ('s2c42', 'mach3', 'correctors', 'gost', 'nct', 'linuxcnc', 'fanuc', 'haas', 'grbl')
TOOLS = ''.join(f'[[tool]]\nnumber = {number}\nkind = "flat"\ndiameter = 10\nflute_length = 30\nlength = 60\n' for number in range(1, 31))
CUT = ('--stock', 'box:-20,-20,-10,40,40,5', '--resolution', '2')   # a small blank at a coarse resolution
RUN_OUTPUTS = {'--trace': 't.jsonl', '--plot': 'p.svg', '--plot-speed': 'v.svg', '--samples': 's.csv'}
FEW = ('--max-passes', '10')   # for a program that never ends
DEBUG = b'step\nnext\nwhere\nstate\ncontinue\nquit\n'


@dataclasses.dataclass
class Place:
    """A program in its folder, and the arguments to call it with."""
    kadr: Kadr
    name: str
    folder: Path         # where the commands work
    program: str         # the name on the command line
    changed: str         # a copy with one digit changed
    control: str | None  # None: guessed
    words: list          # --machine, --setup


def change(path, copy):
    """Writes a copy with the last digit changed; a text without digits gets one more block."""
    data = path.read_bytes()
    at = max((found.start() for found in re.finditer(rb'\d', data)), default=None)
    copy.write_bytes(data + b'\nG4\n' if at is None else data[:at] + (b'1' if data[at:at + 1] != b'1' else b'2') + data[at + 1:])


def commands(place, number):
    """Yields (name, words, outputs, more) of each command over a program."""
    p, control = place.program, ['--control', place.control] if place.control else []
    words = [*control, *place.words]
    target = [to for to in CONTROLS if to != place.control][number % (len(CONTROLS) - 1)]
    yield 'run', ['run', p, *words], (), {}
    outputs = [word for pair in RUN_OUTPUTS.items() for word in pair]
    yield 'run --plot --samples', ['run', p, *words, *outputs, '--max-time', '1', *FEW, '--why', '--files', 'written', '-q'], tuple(RUN_OUTPUTS.values()), {}
    for form in ('text', 'json', 'sarif'):
        yield f'check --format {form}', ['check', p, *words, '--format', form], (), {}
    yield 'debug', ['debug', p, *words], (), {'input': DEBUG}
    yield 'cut', ['cut', p, *words, *CUT, '--tools', 'tools.toml', '--out', 'part.stl', '--json', 'cut.json', '--blocks', 'cut.csv'], ('part.stl', 'cut.json', 'cut.csv'), {}
    yield 'report', ['report', p, *words, '--out', 'r.html'], ('r.html',), {}
    yield 'diff with itself', ['diff', p, p, *words], (), {}
    yield 'diff', ['diff', p, place.changed, *words, '--plot', 'd.svg'], ('d.svg',), {}
    yield 'setup', ['setup', p, *words], (), {}
    yield 'setup --tools', ['setup', p, *words, '--tools'], (), {}
    if p.endswith('.tape'):
        yield 'tape decode', ['tape', 'decode', p], (), {}
    else:
        yield 'tape encode', ['tape', 'encode', p, 'x.tape'], ('x.tape',), {}
        yield 'tape decode', ['tape', 'decode', 'x.tape', 'x.txt'], ('x.txt',), {}
    yield 'convert', ['convert', p, *(['--from', place.control] if place.control else []), *place.words, '--to', target, *FEW, '--out', 'c.nc', '--setup-out', 'c.json'], ('c.nc', 'c.json'), {}


def printed_wrongly(name, done):
    """Returns what a command prints on standard output that does not match its format."""
    if name in ('check --format json', 'check --format sarif', 'setup') and (done.stdout or done.returncode == 0):
        yield not_json(done.stdout)
    if name == 'setup --tools' and done.returncode == 0:
        try:
            tomllib.loads(done.stdout.decode())
        except ValueError as error:
            yield f'no TOML: {error}'
    if name == 'diff with itself' and done.returncode == 1 and b'alarm' not in done.stderr:
        yield f'a program differs from itself: {text(done.stdout)}'


class Explained:
    """The alarms that were explained already, over all programs."""

    def __init__(self):
        self.lock, self.those = threading.Lock(), set()

    def new(self, alarms):
        with self.lock:
            found = sorted(alarms - self.those)
            self.those |= alarms
        return found


def names_of(finding):
    """Returns the names of an alarm: its id, its number, and both together as its text has it (PS0114, error:20)."""
    yield finding['id']
    number = finding['number']
    if number and finding['id'] != 'program_alarm':   # that number belongs to the program
        yield number
        first = finding['text'].split()[0]
        if first.endswith(number):
            yield first


def over_a_program(place, number, explained):
    """Yields (check, faults) of every command over one program."""
    for name, words, outputs, more in commands(place, number):
        if name == 'tape decode' and not (place.folder / words[2]).exists():   # the program has a character without a code
            continue
        done, faults = place.kadr.observed(words, outputs, folder=place.folder, **more)
        faults += filter(None, printed_wrongly(name, done))
        if name == 'report' and done.returncode in (0, 1) and not (place.folder / 'r.html').exists():
            faults.append(f'exit status {done.returncode} without a report')
        yield f'{place.name}: {name}', faults
        if name == 'check --format json' and place.control in CONTROLS and not any(printed_wrongly(name, done)):
            for alarm in explained.new({(place.control, word) for finding in json.loads(done.stdout or b'[]') for word in names_of(finding)}):
                told, faults = place.kadr.observed(['explain', *alarm], folder=place.folder)
                if told.returncode:
                    faults.append(f'exit status {told.returncode}: {text(told.stderr)}')
                yield f'explain {" ".join(alarm)}', faults


def known_examples():
    """Returns program → its control and the arguments that dev/examples calls it with."""
    known = {}
    for line in (harness.ROOT / 'dev/examples').read_text(encoding='utf-8').splitlines():
        if found := re.match(r'example +(\S+) +(\S+) +(\S+)', line):
            name, control, machine = found.groups()
            known[name] = control, ['--machine', machine]
        elif found := re.match(r'cut +(cut/\S+) +\d --control (\S+)', line):
            known[found[1]] = found[2], []
    return known


def examples_called():
    """Yields (program, control, more words) of each example. Examples that dev/examples does not call are called without options, as a new
    user would."""
    known = known_examples()
    # the .h of the library's examples is a C header
    files = [path for path in sorted(EXAMPLES.rglob('*')) if path.suffix in PROGRAMS and path.parent.name != 'library']
    missing = known.keys() - {path.relative_to(EXAMPLES).as_posix() for path in files}
    harness.expect(files and not missing, f'dev/examples names {missing}')
    for path in files:
        control, words = known.get(path.relative_to(EXAMPLES).as_posix(), (None, []))
        setup = path.with_suffix('.json')
        if control and setup.exists():
            words = [*words, '--setup', setup]
        yield path, control, words


def example_words():
    """Yields (program, all its arguments) of each example."""
    for path, control, words in examples_called():
        own = EXAMPLES / control if control and control.endswith('.toml') else control
        yield path, [*(['--control', own] if own else []), *words]


def examples(kadr, every):
    """Returns a job for each example."""
    for path, control, words in list(examples_called())[::every]:
        name = path.relative_to(EXAMPLES).as_posix()

        def laid_out(folder, path=path, name=name, control=control, words=words):
            copies = folder / 'copy'   # called files are next to the changed copy too
            copies.mkdir()
            for other in path.parent.iterdir():
                if other.suffix in (*PROGRAMS, '.json', '.toml'):
                    shutil.copy(other, copies)
            change(path, copies / path.name)
            own = EXAMPLES / control if control and control.endswith('.toml') else control
            return Place(kadr, f'examples/{name}', folder, str(path), str(copies / path.name), own and str(own), words)
        yield f'examples/{name}', laid_out


def golden_programs(kadr, every):
    """Returns a job for each golden program of the share."""
    runs = [(file, case, run) for file, case in golden.load_cases([harness.ROOT / 'tests/golden']) if case['runnable'] for run in golden.runs_of(case)]
    harness.expect(runs, 'there is no golden case')
    for file, case, (variant, setup, program, _) in runs[::every]:
        name = f'golden/{case["control"]}/{file.stem}{" " + variant if variant else ""}'

        def laid_out(folder, case=case, setup=setup, program=program, name=name):
            memory, main, setup_file = golden.laid_out(folder, case['control'], setup, program)
            changed = 'changed' + Path(main).suffix
            change(memory / main, memory / changed)
            return Place(kadr, name, memory, main, changed, case['control'], ['--setup', setup_file])
        yield name, laid_out


def over_programs(kadr, options):
    """Returns name → job; a job returns (check, faults)."""
    explained = Explained()
    for number, (name, laid_out) in enumerate([*examples(kadr, options.examples_every), *golden_programs(kadr, options.every)]):
        def job(laid_out=laid_out, number=number):
            with tempfile.TemporaryDirectory(prefix='kadr_every_') as folder:
                place = laid_out(Path(folder))
                (place.folder / 'tools.toml').write_text(TOOLS)
                yield from over_a_program(place, number, explained)
        yield name, job
