"""Programs and the results of converting them. Used by tests/convert*.py."""
import concurrent.futures
import dataclasses
import json
import math
import subprocess
from pathlib import Path

CONTROLS = ('s2c42', 'mach3', 'correctors', 'gost', 'nct', 'linuxcnc', 'fanuc', 'haas', 'grbl')
WITH_NAMES = (*CONTROLS, 'sinumerik')  # with the controls whose blocks have names
EXAMPLES = Path(__file__).resolve().parent.parent.parent / 'examples'
SECONDS = 120
# The proof notes that `kadr convert` prints, and the option that makes `kadr diff` ignore the same.
NOTES = {'messages': ('what the program shows to the operator is a comment there', '--no-messages'), 'tools': ('tools are changed by hand', '--tools-by-hand'),
         'feeds': ('feed per revolution is written per minute', '--feeds-at-speed'),
         'rounded': ('feeds are rounded to what the F word', '--feeds-rounded')}


@dataclasses.dataclass
class Converted:
    control: str
    file: Path
    setup: Path | None
    to: str
    outcome: str  # 'refused', the method of the proof, or what went wrong
    said: str
    out: Path

    def proven(self):
        return self.outcome.startswith('written: ')

    def right(self):
        return self.proven() or self.outcome == 'refused'

    def out_setup(self):
        return self.out.with_suffix('.json')

    def rules(self):
        return [option for said, option in NOTES.values() if said in self.said]

    def name(self):
        return f'{self.control} {self.file.name} to {self.to}'


def run(*words, **more):
    return subprocess.run([str(w) for w in words], **{'capture_output': True, 'text': True, 'errors': 'replace', 'timeout': SECONDS, 'check': False, **more})


def examples(controls=CONTROLS):
    """(control, program)"""
    for control in controls:
        for file in sorted((EXAMPLES / control).glob('*')):
            if file.suffix in ('.nc', '.tap', '.nct', '.ngc', '.mpf', '.h') and not file.name.startswith('O'):
                yield control, file


def setup_of(file):
    return file.with_suffix('.json') if file.with_suffix('.json').exists() else None


def convert(kadr, control, file, to, out, setup=None):
    """Checks that a conversion either is proven and written, or is refused with the reason and writes nothing."""
    made = Converted(control, file, setup, to, '', '', out)
    for old in (out, made.out_setup()):
        old.unlink(missing_ok=True)
    try:
        got = run(kadr, 'convert', file, '--from', control, '--to', to, '--out', out, '--setup-out', made.out_setup(), '--lang', 'en', *(['--setup', setup] if setup else []))
    except subprocess.TimeoutExpired:
        made.outcome = 'hangs'
        return made
    made.said = got.stderr
    written = out.exists(), made.out_setup().exists()
    if got.returncode == 0 and written == (True, True) and got.stderr.startswith('equal: '):
        made.outcome = next(line for line in got.stderr.splitlines() if line.startswith('written: '))
    elif got.returncode == 1 and written == (False, False) and 'not converted' in got.stderr and len(got.stderr.splitlines()) >= 2:
        made.outcome = 'refused'
    else:
        made.outcome = f'status {got.returncode}, written {written}: {got.stderr[:300]}'
    return made


def convert_all(kadr, jobs, folder, threads=2):
    """jobs: (control, file, setup, to)"""
    def one(numbered):
        number, (control, file, setup, to) = numbered
        return convert(kadr, control, file, to, folder / f'{number}_{control}_{file.stem}_{to}.nc', setup)
    return all_of(one, list(enumerate(jobs)), threads)


def all_of(work, jobs, threads=2):
    with concurrent.futures.ThreadPoolExecutor(threads) as pool:
        return list(pool.map(work, jobs))


def tolerance_of(*controls):
    """Returns the tolerance in mm that `kadr convert` proves arcs with, whose centres are rounded too (docs/commands/convert.md): GOST
    writes Z in hundredths."""
    half, of_z = 0.0005, 0.005 if 'gost' in controls else 0.0005
    return math.hypot(3 * half, 3 * half, of_z) + 1e-5


def diff(kadr, made, other=None, tolerance=None):
    """Compares the result with the source by `kadr diff`."""
    tolerance = tolerance or tolerance_of(made.control, made.to)
    return run(kadr, 'diff', made.file, other or made.out, '--control-a', made.control, '--control-b', made.to, '--tolerance', tolerance, '--setup-b', made.out_setup(), '--lang', 'en',
               *(['--setup-a', made.setup] if made.setup else []), *made.rules())


def course(kadr, file, control, setup):
    """Returns a rough form of what `kadr diff` compares: motions, and the spindle and coolant state along them; None if an alarm stops it."""
    got = run(kadr, 'run', file, '--control', control, '--setup', setup, '--trace', '-', '--quiet')
    if got.returncode != 0:
        return None
    acts, places = [], [json.loads(setup.read_text(encoding='utf-8')).get('start', {})]
    state = {'dir': 'stop'}
    for line in got.stdout.splitlines():
        action = {key: value for key, value in json.loads(line).items() if key not in WHERE}
        place = action.pop('machine', None)
        if action['do'] in ('spindle', 'speed', 'coolant'):
            state = {**state, **{key: value for key, value in action.items() if key not in ('do', 'code')}}
            continue
        if action['do'] in ('tool', 'end', 'message') or (place and distance(place, places[-1]) < SAME):
            continue
        if action['do'] != 'toolchange':
            action.update({'what': state.get('what', 'off'), 'dir': state['dir']} if state['dir'] == 'stop' else state)
        if place and len(places) > 1 and acts[-1][0] == action and action['do'] in ('rapid', 'feed') and is_between(places[-2], places[-1], place):
            places.pop(), acts.pop()
        if place:
            places.append(place)
        acts.append((action, place))
    return acts


WHERE = ('block', 'line', 'col', 'file', 'to', 'exact', 'programmed')
SAME = 1e-6  # mm


def distance(a, b):
    return math.dist([a.get(axis, 0) for axis in sorted({*a, *b})], [b.get(axis, 0) for axis in sorted({*a, *b})])


def is_between(a, b, c):
    return distance(a, b) + distance(b, c) < distance(a, c) + SAME
