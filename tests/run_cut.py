#!/usr/bin/env python3
"""kadr cut: planted faults are found where they are, good programs have none, volumes are what geometry says.

    run_cut.py --kadr build/kadr [--only WORD]

tests/cut_cases/*.toml: [[case]] with name, program, stock, and tools where it is not the file's own `tools`. Expected:
    found     [["rapid_in_stock", LINE], …] collisions, in any order (default: none)
    warned    the same of warnings
    removed   mm³, within `within` (default 0.2 %, at least 0.5 mm³)
    depth     of the first collision, mm, within 0.05 and a hundredth
    stops     id of the alarm that ends the run
    part_program   the wanted part is what this program cuts of the same blank; part: an STL text
    left_on, gouged   [deepest, LINE], mm within a tenth of the cell; 0: no deeper than that; too_deep: the exit status is 1 because of it
    args      further words of the command line; setup: a set-up; machine: the id of one, or the text of its file
Every case is cut with one and with two threads: the same JSON. Then what `kadr mill` makes of examples/mill by every scheme, for every control that
it writes for: nothing is found in it, and what is removed is the zone. Prints a line per failure, then `N passed, N failed`.
Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import argparse
import json
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
TIME_LIMIT_S = 60
MILL_SCHEMES = ['zigzag', '1zigzag', '2zigzag', 'spiral-out', 'spiral-in', 'comb', '1comb', '2comb']
MILL_CONTROLS = ['s2c42', 'mach3', 'nct', 'gost', 'correctors']
MILL_STOCK = 'box:-20,-20,-30,220,180,0'


def write(file, text):
    file.write_text(text)
    return file


def cut(kadr, folder, case, tools, threads):
    (folder / 'tools.toml').write_text(case.get('tools', tools))
    program = folder / 'part.nc'
    program.write_text(case['program'].lstrip('\n'))
    words = [kadr, 'cut', str(program), '--control', case.get('control', 'mach3'), '--stock', case['stock'], '--tools', str(folder / 'tools.toml'),
             '--resolution', str(case.get('resolution', 0.5)), '--json', '-', '--lang', 'en', '--threads', str(threads)]
    if 'part_program' in case:
        made = subprocess.run([*words[:2], str(write(folder / 'wanted.nc', case['part_program'].lstrip('\n'))), *words[3:], '--out', str(folder / 'wanted.stl'), '-q'],
                              capture_output=True, text=True, timeout=TIME_LIMIT_S)
        if made.returncode != 0:
            return made
        words += ['--part', str(folder / 'wanted.stl')]
    elif 'part' in case:
        words += ['--part', str(write(folder / 'wanted.stl', case['part']))]
    words += case.get('args', [])
    if 'machine' in case:
        words += ['--machine', str(write(folder / 'machine.toml', case['machine'])) if '\n' in case['machine'] else case['machine']]
    if 'setup' in case:
        (folder / 'setup.json').write_text(case['setup'])
        words += ['--setup', str(folder / 'setup.json')]
    return subprocess.run(words, capture_output=True, text=True, timeout=TIME_LIMIT_S)


def faults_of(case, run):
    """Sentences: what is not as it was to be."""
    if not run.stdout.startswith('{'):
        yield f'no result: {run.stderr.strip()[:300]}'
        return
    result = json.loads(run.stdout)
    for key, heading in (('found', 'collisions'), ('warned', 'warned')):
        want = sorted((i, line) for i, line in case.get(key, []))
        got = sorted((f['id'], f['line']) for f in result.get(heading, []))
        if got != want:
            yield f'{heading}: {got}, not {want}'
    if 'removed' in case:
        want, got = case['removed'], result['removed']
        if abs(got - want) > case.get('within', max(0.002 * want, 0.5)):
            yield f'removed {got}, not {want}'
    if 'depth' in case and result['collisions']:
        want, got = case['depth'], result['collisions'][0]['depth']
        if abs(got - want) > 0.05 + 0.01 * want:
            yield f'depth {got}, not {want}'
    for key in ('left_on', 'gouged'):
        if key in case:
            (want, line), got = case[key], result['part'][key]
            if abs(got['deepest'] - want) > 0.1 * result['resolution'] or (want > 0 and got['line'] != line):
                yield f'{key}: {got}, not {case[key]}'
    stops = case.get('stops')
    if stops and f'alarm {stops}:' not in run.stderr:
        yield f'does not stop by {stops}: {run.stderr.strip()[:200]}'
    status = 1 if case.get('found') or stops or case.get('too_deep') else 0
    if run.returncode != status:
        yield f'exit status {run.returncode}, not {status}: {run.stderr.strip()[:200]}'


def mill(kadr, folder, scheme, control):
    """Sentences: what is wrong with the cut of a milled pocket, 12 mm deep in two layers."""
    program = folder / f'pocket-{control}.nc'
    made = subprocess.run([kadr, 'mill', 'pocket', str(HERE.parent / 'examples/mill/cover.txt'), '--control', control, '--scheme', scheme, '--tool-diameter', '12',
                           '--depth', '8', '--pass', '4', '--feed', '240', '--speed', '800', '--tool', '1', '--output', str(program)],
                          capture_output=True, text=True, timeout=TIME_LIMIT_S)
    if made.returncode != 0:
        yield f'not milled: {made.stderr.strip()[:200]}'
        return
    case = {'program': program.read_text(), 'control': control, 'stock': MILL_STOCK, 'resolution': 1,
            'tools': '[[tool]]\nnumber = 1\nkind = "flat"\ndiameter = 12\nflutes = 20\nlength = 50\nholder = [[40, 0], [40, 30]]\n'}
    yield from faults_of(case, cut(kadr, folder, case, '', 2))


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument('--kadr', required=True)
    arguments.add_argument('--only', default='')
    options = arguments.parse_args()
    passed = failed = 0
    with tempfile.TemporaryDirectory() as name:
        for file in sorted((HERE / 'cut_cases').glob('*.toml')):
            cases = tomllib.loads(file.read_text())
            for case in cases['case']:
                title = f'{file.stem}/{case["name"]}'
                if options.only not in title:
                    continue
                one, two = (cut(options.kadr, Path(name), case, cases.get('tools', ''), threads) for threads in (1, 2))
                faults = list(faults_of(case, one))
                if one.stdout != two.stdout:
                    faults.append('one thread and two threads differ')
                for fault in faults:
                    print(f'{title}: {fault}')
                failed += bool(faults)
                passed += not faults
        for scheme in MILL_SCHEMES:
            for control in MILL_CONTROLS:
                title = f'mill/{scheme}/{control}'
                if options.only not in title:
                    continue
                faults = list(mill(options.kadr, Path(name), scheme, control))
                for fault in faults:
                    print(f'{title}: {fault}')
                failed += bool(faults)
                passed += not faults
    print(f'{passed} passed, {failed} failed')
    if passed + failed == 0:
        return 2
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
