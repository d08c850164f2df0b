#!/usr/bin/env python3
"""Tests the fast reading and planning of plain blocks (lang/block/plain_block, control/block/shapes). A block with a comment is not plain:
a program gives the same trace and the same alarms with and without a comment at the end of each block.

    run_plain.py --kadr build/kadr [--seed 4] [--count 60] [--every 1]

Runs random programs of few shapes and many modes, with good and bad blocks, and the programs of tests/golden and tests/cases; with
--every N each N-th of them. A case is run if it has a plain block of a shape that no case before it has for the same control with the
same modal codes at the start; with --all every case with a plain block is run.
"""
import argparse
import json
import random
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from cases import reader
from harness import TIME_LIMIT_S

HERE = Path(__file__).resolve().parent
COMMENT = ' (.)'
COMMANDS = (['run', '--quiet', '--trace', '-'], ['check'])  # checking continues after an alarm
MARK = re.compile(r'^ *\^~*\n', re.MULTILINE)  # below the characters of an alarm, which may be the whole block
PLAIN = re.compile(r'[A-Za-z0-9 .+-]*[0-9.] *')  # as far as it can be decided without the control's grammar
NUMBER = re.compile(r'(?<=[A-FI-LN-SU-Z])[+-]?[0-9.]+')  # the numbers of G, M, H, D and T belong to the shape
BLOCK_NUMBER = re.compile(r'N *[0-9]+ *')
LENGTH = {'X', 'Y', 'Z', 'I', 'J', 'R', 'Q'}
ANY = ['G90', 'G91', 'G17', 'G18', 'G19', 'G40', 'G41 D1', 'G42 D1', 'G43 H1', 'G49', 'G54', 'G55', 'G94', 'G95', 'G61', 'G64', 'G4 P',
       'G0', 'G1', 'G2', 'G3', 'G80', 'G81 X Y Z R F', 'G81', 'G83 X Y Z R Q F', 'M3', 'M5', 'M8', 'M9', 'S', 'T1', 'F', 'G28 X Y',
       'G53 X Z', 'G92 X Y', 'G0 X Y', 'G0 Z', 'G1 X', 'G1 Y F', 'X', 'Y', 'Z', 'X Y', 'X Y Z', 'G1 X Y', 'G2 X Y R', 'G3 X Y I J', 'X Y I J',
       'X Y R', 'G1 G2 X', 'G1 G1', 'X X', 'G199', 'M99', 'M199', 'H1', 'D1', 'P1', 'E1', 'L2', 'R', 'I', 'G1 G91 X', 'G90 G0 X Y']
OF = {'nct': ANY + ['G68 X Y R', 'G69', 'G51.1 X', 'G50.1', 'G16', 'G15', 'G10 L2 P1 X', 'G52 X', 'G65 P9999 A', 'G33 Z E', 'G22 X Y Z I J',
                    'G21', 'G20', 'M98 P1', 'U', 'G9 X', 'G38', 'G39'],
      'mach3': ANY + ['G52 X', 'G68 A0 B0 R', 'G69', 'G51 X', 'G50', 'G15', 'G16', 'G10 L2 P1 X', 'G93', 'G98', 'G99', 'G21', 'G20', 'A', 'G31 X'],
      'gost': ANY, 'correctors': ANY}
SETUP = {'offsets': {'1': {'radius': 2, 'length': 30}}}


def block(choose, shapes):
    words = []
    for word in choose.choice(shapes).split():
        if len(word) > 1:
            words.append(word)
        elif word in LENGTH:
            words.append(f'{word}{choose.randint(-40, 40)}{choose.choice(("", ".", ".5", ".25"))}')
        else:
            words.append(word + str(choose.choice((0, 1, 100, 250, -5))))
    number = f'N{choose.randint(1, 999)} ' if choose.random() < 0.2 else ''
    return number + choose.choice((' ', '' if all(len(w) > 1 for w in words) else ' ')).join(words)


def random_programs(choose, count):
    for i in range(count):
        control = choose.choice(sorted(OF))
        shapes = choose.sample(OF[control], 12) + ['G1 X Y F', 'X Y']
        blocks = ['%'] if control == 'correctors' else []
        blocks += [block(choose, shapes) for _ in range(100)]
        yield f'random {i}', control, SETUP, '\n'.join(blocks) + '\n'


def programs_of_cases():
    golden = [(path.stem, json.loads(path.read_text(encoding='utf-8'))) for path in sorted(HERE.glob('golden/*/*.json'))]
    for name, case in [*((case['id'], case) for case in reader.cases()), *golden]:
        if case['control'] in OF:
            yield name, case['control'], case['setup'], case['program']


def commented(program):
    return '\n'.join(line + COMMENT if is_plain(line) else line for line in program.split('\n'))


def is_plain(line):
    return PLAIN.fullmatch(line.strip()) is not None


def with_new_shapes(programs):
    """Returns those with a plain block of a shape that none before them has, for the same control and the same modal codes at the start."""
    seen = set()
    for number, program in programs:
        _, control, setup, text = program
        modal = tuple(setup.get('modal', ()))
        shapes = {(control, modal, NUMBER.sub('#', BLOCK_NUMBER.sub('', line.strip(), 1))) for line in text.split('\n') if is_plain(line)}
        if not shapes <= seen:
            yield number, program
        seen |= shapes


def outcome(kadr, folder, name, commands, control, setup, program):
    """Returns the output and the actions, without the comments."""
    path, own, said = folder / name, folder / f'{name}.files', []
    own.mkdir()  # for the program's output: other runs write files of the same name meanwhile
    path.write_text(program, encoding='utf-8')
    (folder / f'{name}.json').write_text(json.dumps(setup), encoding='utf-8')
    for command in commands:
        made = subprocess.run([kadr, command[0], path, '--control', control, '--setup', folder / f'{name}.json', *command[1:]],
                              capture_output=True, text=True, timeout=TIME_LIMIT_S, cwd=own)
        said.append(made.returncode)
        said += [MARK.sub('', text.replace(COMMENT, '').replace(name, '')) for text in (made.stdout, made.stderr)]
    return said


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--kadr', required=True)
    parser.add_argument('--seed', type=int, default=4)
    parser.add_argument('--count', type=int, default=60)
    parser.add_argument('--every', type=int, default=1, help='run every Nth program, for a slow build')
    parser.add_argument('--all', action='store_true', help='run every program with a plain block')
    options = parser.parse_args()
    kadr, choose = str(Path(options.kadr).resolve()), random.Random(options.seed)
    programs = [*enumerate([*random_programs(choose, options.count), *programs_of_cases()])][::options.every]
    with_plain = [(number, program) for number, program in programs if any(map(is_plain, program[3].split('\n')))]
    run = with_plain if options.all else [item for item in with_plain if item[0] < options.count]
    if not options.all:
        run += with_new_shapes(with_plain[len(run):])
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(2) as pool:
        folder = Path(name)

        def differs(item):
            number, (_, control, setup, program) = item
            commands = COMMANDS if number < options.count else COMMANDS[:1]
            plain = outcome(kadr, folder, f'a{number:05}', commands, control, setup, program)
            other = outcome(kadr, folder, f'b{number:05}', commands, control, setup, commented(program))
            return None if plain == other else (plain, other)

        results = list(pool.map(differs, run))
    failed = [(program, result) for (_, program), result in zip(run, results) if result]
    for (name, control, _, program), (plain, other) in failed[:5]:
        print(f'FAIL {control} {name}\n{program}')
        for a, b in zip(plain, other):
            pairs = zip(str(a).split('\n'), str(b).split('\n'))
            print(next((f'plain:     {x}\ncommented: {y}' for x, y in pairs if x != y), ''))
    print(f'{len(programs)} programs, {len(with_plain)} of them with plain blocks, {len(run)} run, {len(failed)} differ')
    sys.exit(1 if failed or len(with_plain) < options.count / options.every else 0)


if __name__ == '__main__':
    main()
