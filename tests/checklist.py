#!/usr/bin/env python3
"""Tests the checklist (docs/checklist.md): `kadr check` reports mistakes planted into clean programs at their line, and reports nothing
else.

    checklist.py --kadr build/kadr                   all
    checklist.py --kadr build/kadr --only 'arc*'     mistakes of some ids
    checklist.py --kadr build/kadr --table           what is found and what is missed, by id and control
    checklist.py --kadr build/kadr --update          rewrites tests/checklist/found.tsv

Planted: tests/planted/mistakes.py parses the programs tests/checklist/CONTROL/*.nc and the programs of examples/ and adds to each one
mistake whose line and id it knows. A fixed seed draws the locations, at most PLACES of a type in a program. Where the control itself
refuses the program (an alarm), another location is drawn: advice is for programs that run. 95 of 100 mistakes must be found, and no id
that tests/checklist/found.tsv names may be lost. What a rule does not detect yet is listed in tests/checklist/open.tsv with the reason:
it still counts in that share, and its row must go once all of it is found. Clean: the same programs, each with a tools file of its
tools, and all other programs of examples/ that check without an alarm, get no advice. Innocent: the programs of
tests/checklist/innocent.txt, which look wrong but are correct, get no advice either. The file has `== CONTROL name` and the program;
before the program, where needed, `setup: {…}`, and `tools: […]` with the numbers for a tools file.
"""
import collections
import fnmatch
import json
import random
import re
import sys
import tempfile
from pathlib import Path

import harness
from planted import mistakes
from planted.part_program import Program

HERE = Path(__file__).resolve().parent / 'checklist'
EXAMPLES = harness.ROOT / 'examples'
FOUND = HERE / 'found.tsv'
CONTROLS = ('s2c42', 'mach3', 'gost', 'correctors', 'nct', 'linuxcnc', 'grbl', 'fanuc', 'haas', 'fanuc-t')
ENDINGS = ('.nc', '.tap', '.ngc', '.nct')
SEED, PLACES = 20261128, 4   # the most locations per type of mistake in a program
LEAST_FOUND = 0.95


def open_rows():
    """Returns the known faults of open.tsv: id and control, or `clean`/`innocent` and a name; with the reason."""
    rows = [line.split('\t') for line in (HERE / 'open.tsv').read_text(encoding='utf-8').splitlines()[1:]]
    return {(what, of): why for what, of, why in rows}


OPEN = open_rows()


def judge_without(tally, what, name, faults):
    """Judges like Tally.judge, but what open.tsv lists must still fail; if it passes, its row must go."""
    if (what, name) in OPEN:
        faults = [] if faults else ['it is mended: its row of open.tsv must go']
    tally.judge(f'{what} {name}', faults)


# These are reported at the first cut with the tool, which another block, or a subprogram, may make. The unchanged program has
# no advice.
AT_FIRST_CUT = {'feed_too_small', 'feed_too_large', 'feed_per_tooth', 'cut_without_spindle', 'length_of_other', 'length_not_called', 'surface_speed_unlimited'}


def is_open(program, mistake):
    return (mistake.ids[0], program.control) in OPEN


MACHINE = 'id = "own"\nspindle_speed = {}\n[axes]\nX = {{ rapid = 10000 }}\n'


def findings(kadr, control, text, setup, tools=None, most_rpm=None):
    """Returns what `kadr check` finds, and whether the control stops. `tools`: the numbers for a tools file. `most_rpm`: the machine's
    limit."""
    with tempfile.TemporaryDirectory(prefix='kadr_check_') as folder:
        bench = harness.Kadr(kadr, folder)
        bench.file('p.nc', '\n'.join(text) + '\n')
        if tools is not None:
            rows = (f'[[tool]]\nnumber = {n}\nkind = "flat"\ndiameter = 8\nflute_length = 20\nlength = 50\n' for n in tools)
            bench.file('p.toml', '\n'.join(rows))
        more = []
        if setup is not None:
            bench.file('p.json', json.dumps(setup))
            more += ['--setup', 'p.json']
        if most_rpm is not None:
            bench.file('own.toml', MACHINE.format(most_rpm))
            more += ['--machine', 'own.toml']
        done = bench.call('check', 'p.nc', '--control', control, '--format', 'json', '--lang', 'en', *more)
    try:
        found = json.loads(done.stdout)
    except json.JSONDecodeError:
        raise harness.Failure(f'no JSON: {done.stdout[:100]!r} {done.stderr[:300]!r}') from None
    return [f for f in found if f['severity'] == 'advice'], [f for f in found if f['severity'] == 'alarm']


def shown(advice):
    return '; '.join(f'{a["line"]} {a["id"]}' for a in advice) or 'nothing'


# ---- planted mistakes

def programs():
    """Returns the programs that mistakes are planted into."""
    bases = [Program(control, path) for control in CONTROLS for path in sorted((HERE / control).glob('*.nc'))]
    for control in CONTROLS:
        for path in sorted((EXAMPLES / control).iterdir()):
            if path.suffix in ENDINGS and path.stem not in ('cover_koi8',):
                bases.append(Program(control, path))
    return bases


def drawn(kadr, program):
    """Returns, for each type, the first locations in an order given by the seed at which the control does not stop, with what was found."""
    own = random.Random(f'{SEED} {program.name}')
    kinds = collections.defaultdict(list)
    for m in mistakes.all_of(program):
        kinds[m.kind].append(m)
    results, refused = [], 0
    for places in kinds.values():
        own.shuffle(places)
        taken = 0
        for m in places:
            if taken == PLACES:
                break
            advice, alarms = findings(kadr, program.control, m.text, program.setup if m.setup is None else m.setup, m.tools, m.most_rpm)
            if alarms:
                refused += 1
                continue
            taken += 1
            results.append((program, m, advice, any((a['line'] == m.line or a['id'] in AT_FIRST_CUT) and a['id'] in m.ids for a in advice)))
    return results, refused


def table(results):
    """Returns the number found and the number planted, by id and control."""
    counts = collections.defaultdict(lambda: [0, 0])
    for program, m, _, found in results:
        for key in ((m.ids[0], program.control), (m.ids[0], 'all')):
            counts[key][0] += found
            counts[key][1] += 1
    return counts


def print_table(results, refused):
    counts = table(results)
    used = [c for c in CONTROLS if any(key[1] == c for key in counts)] + ['all']
    print('\t'.join(['id', *used]))
    for name in sorted({key[0] for key in counts}):
        print('\t'.join([name, *(f'{counts[name, c][0]}/{counts[name, c][1]}' if (name, c) in counts else '' for c in used)]))
    print(f'{sum(r[3] for r in results)} of {len(results)} found; {refused} more are refused by the control')
    for program, m, advice, found in results:
        if not found:
            print(f'not found: {program.name}: {m.kind}: {m.line} {"/".join(m.ids)}: `{m.text[m.line - 1].strip()}`; told: {shown(advice)}')


def judge_planted(tally, results):
    counts = table(results)
    found = {name: count for (name, control), count in counts.items() if control == 'all'}
    for line in FOUND.read_text(encoding='utf-8').splitlines()[1:]:
        name, was, _ = line.split('\t')
        tally.expect(int(was) == 0 or found.get(name, [0, 0])[0] > 0, f'planted {name}', f'{was} were found, now none')
    for name, control in OPEN:
        if name not in ('clean', 'innocent'):
            got = counts.get((name, control), [0, 0])
            tally.expect(got[0] < got[1], f'open: {name} of {control}', 'all are found, or none is planted: its row of open.tsv must go')
    share = sum(r[3] for r in results) / max(1, len(results))
    missed = [f'{p.name} {m.line} {m.ids[0]} ({m.kind}){" open" if is_open(p, m) else ""}' for p, m, _, is_found in results if not is_found]
    tally.expect(share >= LEAST_FOUND, f'{share:.1%} of {len(results)} planted mistakes are found', '\n  '.join(missed))
    tally.expect(len(results) >= 300, 'at least 300 mistakes', len(results))


def write_found(results):
    rows = [f'{name}\t{count[0]}\t{count[1]}' for (name, control), count in sorted(table(results).items()) if control == 'all']
    FOUND.write_text('\n'.join(['id\tfound\tplanted', *rows]) + '\n', encoding='utf-8')


# ---- clean and innocent programs

def examples():
    """Yields each program of examples/ with its control and set-up; a program that names no control is read as Kadr guesses."""
    for path in sorted(EXAMPLES.rglob('*')):
        if path.suffix in ENDINGS and path.parent.name not in ('docs', 'library'):
            setup = path.with_suffix('.json')
            control = path.parent.name if path.parent.name in CONTROLS else 'nct' if path.suffix == '.nct' else None
            yield path, control, setup if setup.exists() else None


def faults_of_example(kadr, example):
    path, control, setup = example
    more = [*(['--control', control] if control else []), *(['--setup', setup] if setup else [])]
    done = harness.Kadr(kadr, path.parent).call('check', path.name, '--format', 'json', '--lang', 'en', *more)
    try:
        found = json.loads(done.stdout)
    except json.JSONDecodeError:
        return []   # it is not G-code of any kind that Kadr reads without being given a control
    return [f'{f["line"]} {f["id"]}: {f["line_text"].strip()}: {f["text"]}' for f in found if f['severity'] == 'advice']


def innocents():
    """Returns the programs of innocent.txt: name, control, text, set-up."""
    for part in re.split(r'^== ', (HERE / 'innocent.txt').read_text(encoding='utf-8'), flags=re.M)[1:]:
        head, *lines = part.rstrip('\n').split('\n')
        control, name = head.split(' ', 1)
        given = {'setup': None, 'tools': None}
        while (key := lines[0].split(':')[0]) in given:
            given[key] = json.loads(lines.pop(0).removeprefix(f'{key}:'))
        yield name, control, lines, given['setup'], given['tools']


def faults_of_text(kadr, control, text, setup, tools=None):
    advice, alarms = findings(kadr, control, text, setup, tools)
    return [f'{a["line"]} {a["id"]}: {a["line_text"].strip()}: {a["text"]}' for a in [*alarms, *advice]]


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--only', default='*', help='only mistakes of ids that match')
    parser.add_argument('--table', action='store_true', help='prints what is found and what is not')
    parser.add_argument('--update', action='store_true', help='writes found.tsv')
    options = harness.parsed(parser)
    tally = harness.Tally()
    bases = programs()
    clean, results, refused = [], [], 0
    for program, faults in zip(bases, harness.each(lambda p: faults_of_text(options.kadr, p.control, p.lines, p.setup, p.numbers()), bases)):
        if 'examples' not in program.name and (HERE / f'{program.name}.nc').exists():
            judge_without(tally, 'clean', program.name, faults)
        if not faults:
            clean.append(program)
    for got, times in harness.each(lambda p: drawn(options.kadr, p), clean):
        results += [r for r in got if fnmatch.fnmatch(r[1].ids[0], options.only)]
        refused += times
    if options.update:
        write_found(results)
    if options.table:
        print_table(results, refused)
    if options.only == '*':
        judge_planted(tally, results)
    all_examples = list(examples())
    for example, faults in zip(all_examples, harness.each(lambda e: faults_of_example(options.kadr, e), all_examples)):
        judge_without(tally, 'clean', str(example[0].relative_to(EXAMPLES)), faults)
    cases = list(innocents())
    for (name, control, *_), faults in zip(cases, harness.each(lambda c: faults_of_text(options.kadr, *c[1:]), cases)):
        judge_without(tally, 'innocent', f'{control} {name}', faults)
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
