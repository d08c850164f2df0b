#!/usr/bin/env python3
"""Compares Kadr for browsers with the native program: every example of examples/README.md gives the same trace, messages and exit status,
byte for byte; `cut` the same STL and JSON; `check`, `convert` and `explain` the same text in both languages.

    traces.py --kadr build/release/kadr [--node tests/alone/kadr_node] [--only TEXT]

Prints one line per difference. Exit status: 0 all the same, 1 not.
"""
import argparse
import concurrent.futures
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parents[1] / 'examples'
MOST_SECONDS = 300
# The mathematical library of browsers and that of Linux differ in the last bit of some functions (docs/web.md). In these programs the last
# bit decides: the text after the name says what.
LAST_BIT_DECIDES = {
    'five-axes/sphere.nct': 'times of three blocks',
    'fanuc-t/roller.nc': 'the twelfth digit of a speed',
    'five-axes/swarf_cut.nct': 'which of two axes that leave their ways at one instant is named',
}
MORE = [
    'check fanuc/flange_taps.nc --control fanuc --lang ru',
    'check docs --lang en',
    'explain G83 --control fanuc --lang ru',
    'convert fanuc/rounded_plate.nc --from fanuc --to linuxcnc',
    'convert fanuc-t/bushing.nc --from fanuc-t --to haas-st',
    'edit cut/plate.nc --feed 80%',
    'diff fanuc/flange_taps.nc fanuc/flange_taps.nc',
    'cut cut/plate.nc --out OUT.stl --json',
    'cut cut/waves.ngc --out OUT.stl --json',
    'cut cut/plate.nc --out OUT.3mf --json',
    'run fanuc/flange_taps.nc --control fanuc --setup fanuc/flange_taps.json --plot OUT.svg',
]


def commands(only):
    """Yields the arguments of each command."""
    seen = set()
    for line in (EXAMPLES / 'README.md').read_text(encoding='utf-8').splitlines():
        if not line.startswith('    kadr run '):
            continue
        words = shlex.split(line)[1:]
        if '--plot' in words:
            at = words.index('--plot')
            del words[at:at + 2]
        if '--state' in words:  # there are no state files in a browser
            continue
        if '--trace' not in words:
            words += ['--trace', '-']
        if (key := tuple(words)) not in seen and only in line:
            seen.add(key)
            yield words
    for line in MORE:
        if only in line:
            yield shlex.split(line)


def result(program, words, folder):
    """Returns exit status, both outputs and the written file of a command."""
    words = [str(folder / word) if word.startswith('OUT.') else word for word in words]
    ran = subprocess.run([*program, *words], cwd=EXAMPLES, capture_output=True, timeout=MOST_SECONDS, check=False)
    written = b''.join(path.read_bytes() for path in sorted(folder.iterdir()))
    name = str(folder).encode()
    return ran.returncode, ran.stdout.replace(name, b''), ran.stderr.replace(name, b''), written


def difference(native, node, words):
    """Returns a sentence about the first difference; an empty text if there is none."""
    found = []
    for program in (native, node):
        with tempfile.TemporaryDirectory(prefix='kadr-same-') as folder:
            found.append(result(program, words, Path(folder)))
    for what, one, other in zip(('exit status', 'output', 'messages', 'written file'), *found):
        if one == other:
            continue
        if isinstance(one, int):
            return f'{what}: {one}, in the browser {other}: {found[1][2][-300:].decode(errors="replace")}'
        lines = zip(one.splitlines() + [b'(end)'], other.splitlines() + [b'(end)'])
        n, (a, b) = next(((n, pair) for n, pair in enumerate(lines, 1) if pair[0] != pair[1]), (0, (b'', b'')))
        return f'{what}, line {n}: {a[:200].decode(errors="replace")}\n  in the browser: {b[:200].decode(errors="replace")}'
    return ''


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--kadr', required=True)
    parser.add_argument('--node', default=str(HERE / 'kadr_node'))
    parser.add_argument('--only', default='')
    parser.add_argument('--jobs', type=int, default=2)
    options = parser.parse_args()
    native, node = [str(Path(options.kadr).resolve())], [str(Path(options.node).resolve())]
    passed = failed = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        all_words = list(commands(options.only))
        for words, found in zip(all_words, pool.map(lambda words: difference(native, node, words), all_words)):
            may_differ = words[1] in LAST_BIT_DECIDES
            if found and not may_differ:
                failed += 1
                print(f'kadr {shlex.join(words)}\n  {found}')
            else:
                passed += 1
                if found:
                    print(f'kadr {shlex.join(words)}: {LAST_BIT_DECIDES[words[1]]}, as is known')
    print(f'{passed} passed, {failed} failed')
    return 1 if failed or passed < 40 and not options.only else 0


if __name__ == '__main__':
    sys.exit(main())
