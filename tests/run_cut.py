#!/usr/bin/env python3
"""Tests kadr cut: it finds planted faults where they are and none in good programs; volumes agree with geometry.

    run_cut.py --kadr build/kadr [--only WORD]

tests/cut_cases/*.toml: [[case]] with name, program, stock, and tools, unless the file's own `tools` are used. Expected:
    found     [["rapid_in_stock", LINE], …] collisions, in any order (default: none)
    warned    the same for warnings
    removed   mm³, within `within` (default 0.2 %, at least 0.5 mm³)
    depth     of the first collision, mm, within 0.05 plus one per cent
    stops     id of the alarm that ends the run
    part_program   the wanted part is what this program cuts from the same blank; part: an STL text
    left_on, gouged   [deepest, LINE], mm within a tenth of the cell; 0: at most that; too_deep: the exit status is 1 because of it
    calls     of the first collision: [["O100", LINE], …], outermost first
    checks    [["heaviest.0.rate", 150, 1.5], …]: a path in the JSON, its value, the tolerance (a text: its ending; 'null': null)
    rows      [[LINE, "rate", 150, 1.5], …]: in the first row of a line in --blocks; "": not given
    files     { "name" = "text" }: further files next to the program
    window    {stock, removed: mm³ within `within`; resolution}
    simplified   {off: mm at most; greatest share of the triangles that remain}: of part.stl, which is complete
    deviation the greatest number in off.ply, mm within 0.01
    refused   the start of the message; nothing is cut, the exit status is 2
    told      what stderr contains: a list of parts
    stock     left out: the program without --stock
    resolution   mm (default 0.5); "chosen": by the program. tools = "guess", stock = "guess": these texts as the option's value
    args      further words of the command line, files in a folder of the case; setup: a set-up; machine: one of the file's [machines],
              the id of one, or the text of its file
    bodies    names of the two bodies in the first collision, in any order; place: its position, mm within 0.02
Every case is cut with one and with two threads: the same JSON, the same --blocks, whose volumes add up to the volumes of the tools. The
keys of `heaviest` and `emptiest` are those that docs/commands/cut.md names. Then the programs of `kadr mill` are cut, for every scheme
and every control that it writes for: from examples/mill for one control per scheme, in turn, from a small drawing for the others; they
have no fault and no alarm.
Prints a line per failure, then `N passed, N failed`.
Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import argparse
import csv
import io
import json
import shutil
import struct
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

from harness import TIME_LIMIT_S

HERE = Path(__file__).resolve().parent
MILL_SCHEMES = ['zigzag', '1zigzag', '2zigzag', 'spiral-out', 'spiral-in', 'comb', '1comb', '2comb']
MILL_CONTROLS = ['s2c42', 'mach3', 'nct', 'gost', 'correctors']
MILL_DRAWINGS = {  # name: text, blank
    'cover': ((HERE.parent / 'examples/mill/cover.txt').read_text(), 'box:-20,-20,-30,220,180,0'),
    'small': ('from 0 0\nline 70 0\nline 70 40\narc 60 50 60 40 ccw\nline 0 50\nclose\nfrom 30 20\nline 38 20\nline 38 28\nline 30 28\nclose\n',
              'box:-20,-20,-30,90,70,0'),
}
HEAVIEST_KEYS = {'line', 'program', 'block', 'tool', 'rate', 'feed_per_tooth', 'depth', 'width', 'angle', 'volume', 'seconds', 'at', 'at_time'}
EMPTIEST_KEYS = {'line', 'program', 'block', 'tool', 'seconds'}
NOT_ALWAYS = {'program', 'block'}
COLUMNS = 'line,block,tool,begins,seconds,length,volume,rate,feed_per_tooth,depth,width,angle,program'.split(',')
MOST_TOLD = 10


def write(file, text):
    file.write_text(text)
    return file


def cut(kadr, folder, case, tools, threads, machines={}, part_is_there=False):
    (folder / 'tools.toml').write_text(case.get('tools', tools))
    program = folder / 'part.nc'
    program.write_text(case['program'].lstrip('\n'))
    stock = str(write(folder / 'blank.stl', case['stock'].lstrip('\n'))) if case.get('stock_file') else case.get('stock')
    shapes = 'guess' if case.get('tools') == 'guess' else str(folder / 'tools.toml')
    cell = [] if case.get('resolution') == 'chosen' else ['--resolution', str(case.get('resolution', 0.5))]
    words = [kadr, 'cut', str(program), '--control', case.get('control', 'mach3'), *(['--stock', stock] if stock else []), '--tools', shapes, *cell, '--json', '-', '--lang', 'en', '--threads', str(threads),
             '--blocks', str(folder / 'blocks.csv')]
    for name, text in case.get('files', {}).items():
        write(folder / name, text.lstrip('\n'))
    if part_is_there:
        words += ['--part', str(folder / 'wanted.stl')]
    elif 'part_program' in case:
        made = subprocess.run([*words[:2], str(write(folder / 'wanted.nc', case['part_program'].lstrip('\n'))), *words[3:], '--out', str(folder / 'wanted.stl'), '-q'],
                              capture_output=True, text=True, timeout=TIME_LIMIT_S)
        if made.returncode != 0:
            return made
        words += ['--part', str(folder / 'wanted.stl')]
    elif 'part' in case:
        words += ['--part', str(write(folder / 'wanted.stl', case['part']))]
    words += [str(folder / word) if word.endswith(('.stl', '.ply')) else word for word in case.get('args', [])]
    if 'machine' in case:
        machine = machines.get(case['machine'], case['machine'])
        words += ['--machine', str(write(folder / 'machine.toml', machine)) if '\n' in machine else machine]
    if 'setup' in case:
        (folder / 'setup.json').write_text(case['setup'])
        words += ['--setup', str(folder / 'setup.json')]
    return subprocess.run(words, capture_output=True, text=True, timeout=TIME_LIMIT_S)


def faults_of_loads(case, result, table):
    """Yields sentences: what is wrong with the heaviest and the emptiest lines, and the table of blocks."""
    for heading, keys in (('heaviest', HEAVIEST_KEYS), ('emptiest', EMPTIEST_KEYS)):
        if len(result[heading]) > MOST_TOLD:
            yield f'{heading}: more than {MOST_TOLD}'
        for line in result[heading]:
            if set(line) - keys or keys - NOT_ALWAYS - set(line):
                yield f'{heading}: keys {sorted(line)}'
    for place, want, *off in case.get('checks', []):
        got = result
        for key in place.split('.'):
            got = got[int(key)] if isinstance(got, list) else got.get(key)
        if isinstance(want, str) and want != 'null':
            got = want if str(got).endswith(want) else got
        if got != (None if want == 'null' else want) and not (off and got is not None and abs(got - want) <= off[0]):
            yield f'{place}: {got}, not {want}'
    rows = list(csv.DictReader(io.StringIO(table)))
    if table.splitlines()[0].split(',') != COLUMNS:
        yield f'--blocks: columns {table.splitlines()[0]}'
    for line, column, want, *off in case.get('rows', []):
        got = next((row[column] for row in rows if row['line'] == str(line)), None)
        if got != want and not (off and got and abs(float(got) - want) <= off[0]):
            yield f'--blocks: {column} of line {line} is {got}, not {want}'
    told, removed = sum(float(row['volume']) for row in rows), sum(tool['removed'] for tool in result['tools'])
    if not case.get('found') and abs(told - removed) > 1e-3 * (1 + len(rows) + len(result['tools'])):
        yield f'--blocks: {told} mm³ in all, not {removed}'


def window_faults(want, got):
    for key in ('stock', 'removed'):
        if abs(got[key] - want[key]) > want['within']:
            yield f'window {key} {got[key]}, not {want[key]}'
    if got['resolution'] != want['resolution'] or abs(got['stock'] - got['left'] - got['removed']) > 0.002 or got['error_bound'] <= 0:
        yield f'window {got}'


def mesh_faults(case, result, folder):
    """Yields the faults of the written mesh files."""
    if 'simplified' in case:
        got, size = result['simplified'], (folder / 'part.stl').stat().st_size
        if got['off'] > case['simplified']['off'] or got['triangles'] > case['simplified']['share'] * got['exact'] or size != 84 + 50 * got['triangles']:
            yield f'simplified {got}, {size} bytes'
    if 'deviation' in case:
        head, _, body = (folder / 'off.ply').read_bytes().partition(b'end_header\n')
        points = int(head.split(b'element vertex ')[1].split()[0])
        greatest = max(value for *_, value in struct.iter_unpack('<fffBBBf', body[:19 * points]))
        if abs(greatest - case['deviation']) > 0.01:
            yield f'deviation {greatest}, not {case["deviation"]}'


def faults_of(case, run, folder, table=None):
    """Yields sentences: what differs from the expectations."""
    if 'refused' in case:
        if run.returncode != 2 or not run.stderr.removeprefix('kadr: ').startswith(case['refused']):
            yield f'not refused: exit status {run.returncode}, {run.stderr.strip()[:300]}'
        return
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
    if 'bodies' in case and result['collisions']:
        got = result['collisions'][0].get('bodies')
        if got is None or sorted(got) != sorted(case['bodies']):
            yield f'between {got}, not {case["bodies"]}'
    if 'place' in case and result['collisions']:
        got = [result['collisions'][0]['at'][axis] for axis in 'XYZ']
        if any(want is not None and abs(got[i] - want) > 0.02 for i, want in enumerate(None if w == 'any' else w for w in case['place'])):
            yield f'at {got}, not {case["place"]}'
    for key in ('left_on', 'gouged'):
        if key in case:
            (want, line), got = case[key], result['part'][key]
            if abs(got['deepest'] - want) > 0.1 * result.get('window', result)['resolution'] or (want > 0 and got['line'] != line):
                yield f'{key}: {got}, not {case[key]}'
    if 'calls' in case:
        got = [[call['program'], call['line']] for call in result['collisions'][0].get('calls', [])]
        if got != case['calls']:
            yield f'calls: {got}, not {case["calls"]}'
        for what, line in case['calls']:
            if f'called {what} in line {line}' not in run.stderr:
                yield f'alarm does not tell: called {what} in line {line}'
    if table is not None:
        yield from faults_of_loads(case, result, table)
    if 'window' in case:
        yield from window_faults(case['window'], result['window'])
    yield from mesh_faults(case, result, folder)
    for part in case.get('told', []):
        if part not in run.stderr:
            yield f'does not say {part!r}: {run.stderr.strip()[:400]}'
    stops = case.get('stops')
    if stops and f'alarm {stops}:' not in run.stderr:
        yield f'does not stop by {stops}: {run.stderr.strip()[:200]}'
    status = 1 if case.get('found') or stops or case.get('too_deep') else 0
    if run.returncode != status:
        yield f'exit status {run.returncode}, not {status}: {run.stderr.strip()[:200]}'


def mill(kadr, folder, scheme, control, drawing):
    """Yields sentences: what is wrong with the cut of a milled pocket, 8 mm deep in two layers."""
    text, stock = MILL_DRAWINGS[drawing]
    program = folder / f'pocket-{control}.nc'
    made = subprocess.run([kadr, 'mill', 'pocket', str(write(folder / 'drawing.txt', text)), '--control', control,
                           '--scheme', scheme, '--tool-diameter', '12',
                           '--depth', '8', '--pass', '4', '--feed', '240', '--speed', '800', '--tool', '1', '--output', str(program)],
                          capture_output=True, text=True, timeout=TIME_LIMIT_S)
    if made.returncode != 0:
        yield f'not milled: {made.stderr.strip()[:200]}'
        return
    case = {'program': program.read_text(), 'control': control, 'stock': stock, 'resolution': 1,
            'tools': '[[tool]]\nnumber = 1\nkind = "flat"\ndiameter = 12\nflute_length = 20\nlength = 50\nholder = [[40, 0], [40, 30]]\n'}
    yield from faults_of(case, cut(kadr, folder, case, '', 2), folder)


def without_module(kadr, folder, case, tools, machines):
    """Yields sentences: what is wrong if kadr-bodies.so is missing."""
    alone = Path(shutil.copy(kadr, folder / 'kadr-alone'))
    run = cut(str(alone), folder, case, tools, 1, machines)
    if run.returncode != 2 or 'kadr-bodies.so' not in run.stderr:
        yield f'exit status {run.returncode}, not 2: {run.stderr.strip()[:200]}'
    run = cut(str(alone), folder, {key: value for key, value in case.items() if key != 'machine'}, tools, 1)
    if run.returncode not in (0, 1):
        yield f'a machine without bodies: exit status {run.returncode}: {run.stderr.strip()[:200]}'


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
                runs, tables = [], []
                for threads in (1, 2):
                    (Path(name) / 'blocks.csv').unlink(missing_ok=True)
                    runs.append(cut(options.kadr, Path(name), case, cases.get('tools', ''), threads, cases.get('machines', {}),
                                    part_is_there=threads == 2 and 'part_program' in case))
                    table = Path(name) / 'blocks.csv'
                    tables.append(table.read_text() if table.exists() else None)
                one, two = runs
                faults = list(faults_of(case, one, Path(name), tables[0]))
                if one.stdout != two.stdout or tables[0] != tables[1]:
                    faults.append('one thread and two threads differ')
                for fault in faults:
                    print(f'{title}: {fault}')
                failed += bool(faults)
                passed += not faults
        title = 'machine/without the module'
        if options.only in title:
            cases = tomllib.loads((HERE / 'cut_cases/machine.toml').read_text())
            faults = list(without_module(options.kadr, Path(name), cases['case'][0], cases['tools'], cases['machines']))
            for fault in faults:
                print(f'{title}: {fault}')
            failed += bool(faults)
            passed += not faults
        for i, scheme in enumerate(MILL_SCHEMES):
            for control in MILL_CONTROLS:
                title = f'mill/{scheme}/{control}'
                if options.only not in title:
                    continue
                drawing = 'cover' if control == MILL_CONTROLS[i % len(MILL_CONTROLS)] else 'small'
                faults = list(mill(options.kadr, Path(name), scheme, control, drawing))
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
