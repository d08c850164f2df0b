#!/usr/bin/env python3
"""Tests Kadr as a library: it is installed into a folder of its own and found there by CMake and by pkg-config; the programs of
examples/library are built on it and run. Their expected output is listed here, worked out by hand; the output that docs/library.md
prints is compared too.

    library.py --kadr build/release/kadr

The build folder must contain the library (target kadr_library). Prints a line per failure, then `N passed, N failed`.
Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import argparse
import os
import re
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from math import pi
from pathlib import Path

import docs_commands

TIME_LIMIT_S = 840  # it compiles the whole library if ccache has no copy
ROOT = Path(__file__).resolve().parent.parent
EXAMPLES = ROOT / 'examples/library'
VERSION = re.search(r'^project\(kadr VERSION (\S+)', (ROOT / 'CMakeLists.txt').read_text(), re.M)[1]

# examples/library/part.nc: T1 cuts 30 + 40 mm at 600 mm/min; T2 a hypotenuse of 50 mm and half a circle of radius 10 at 300 mm/min.
INTERPRET = 'N30 X30 Y0 Z0 F600\nN40 X30 Y40 Z0 F600\nN60 X0 Y0 Z0 F300\n'
OWN_SINK = f'T1: 70.000 mm, 7.000 s\nT2: {50 + 10 * pi:.3f} mm, {(50 + 10 * pi) / 5:.3f} s\n'
# position of the tool before each line from N10 (line 3) on
STEP = ''.join(f'before line {line}: X{x} Y{y} Z0\n' for line, x, y in
               [(3, 0, 0), (4, 0, 0), (5, 0, 0), (6, 30, 0), (7, 30, 40), (8, 30, 40), (9, 0, 0), (10, 20, 0)])
# own.toml: E15 is 15 tenths of a second
OWN_CONTROL = 'ours: Mills of shop 7\nN10 M51\nN20 dwell 1.5 s\nN30 M52\n'
FAULTY = '%\nN10 G0 X5\nN20 G1 X10 F100 Q\nN30 M30\n%\n'   # Q without a number, in line 3


def run(command, **more):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=TIME_LIMIT_S, **more)


class Failed(Exception):
    """Nothing after this can be checked."""


def must(command, **more):
    done = run(command, **more)
    if done.returncode:
        raise Failed(f'{shlex.join(map(str, command))}: {done.stdout}{done.stderr}')
    return done.stdout


def cached(build, name):
    found = re.search(rf'^{name}:\w+=(.*)$', (build / 'CMakeCache.txt').read_text(), re.M)
    return found[1] if found else ''


def compiler_of(build):
    """The users of a library with a sanitizer need the sanitizer too; they do not need its optimisation."""
    sanitizers = [flag for flag in cached(build, 'CMAKE_CXX_FLAGS').split() if flag.startswith('-fsanitize=')]
    return cached(build, 'CMAKE_CXX_COMPILER'), sanitizers


def installed(build, prefix):
    """Files are installed only into the prefix, and there only where a library's files belong."""
    must(['cmake', '--install', build, '--prefix', prefix, '--component', 'dev'])
    files = (build / 'install_manifest_dev.txt').read_text().split('\n')
    strange = [name for name in files if not re.match(rf'{re.escape(str(prefix))}/(include/kadr|lib/([\w-]+/)?(libkadr\.|cmake/kadr/|pkgconfig/kadr\.pc))', name)]
    yield None if files and not strange else f'installed elsewhere: {strange}'
    library = next(prefix.rglob('libkadr.so'), None)
    if library is None:
        raise Failed('no libkadr.so')
    soname = re.search(r'SONAME.*\[(.*)\]', must(['readelf', '-d', library]))
    wanted = 'libkadr.so.' + VERSION.rpartition('.')[0]
    yield None if soname and soname[1] == wanted else f'soname {soname}, not {wanted}'
    headers = sorted(path.name for path in (prefix / 'include/kadr').glob('*.h'))
    sources = sorted([path.name for path in (ROOT / 'include/kadr').glob('*.h')] + ['version.h'])
    yield None if headers == sources else f'headers {headers}, not {sources}'


def header_alone(compiler, flags, prefix, header):
    """Each header compiles alone, included as a user includes it, though the user's own folders `base` and `config` are in the include
    path."""
    source = f'#include <kadr/{header}>\nint main() {{}}\n'
    decoy = prefix.parent / 'decoy/base'
    decoy.mkdir(parents=True, exist_ok=True)
    (decoy / 'vec.h').write_text('#error of the user\n')
    done = run([compiler, '-std=c++20', *flags, '-Wall', '-Wextra', '-Werror', '-fsyntax-only', f'-I{decoy.parent}', f'-I{prefix}/include', '-x', 'c++', '-'], input=source)
    return None if done.returncode == 0 else f'<kadr/{header}>: {done.stderr[:2000]}'


def built(build, prefix, folder, *options):
    compiler, flags = compiler_of(build)
    must(['cmake', '-S', EXAMPLES, '-B', folder, '-G', 'Ninja', f'-DCMAKE_PREFIX_PATH={prefix}', f'-DCMAKE_CXX_COMPILER={compiler}',
          f'-DCMAKE_CXX_FLAGS={" ".join(flags)}', *options])


def prints(name, done, output, status=0):
    return None if (done.returncode, done.stdout) == (status, output) else \
        f'{name}: status {done.returncode}, {done.stdout!r}, not {output!r}; {done.stderr}'


def plan_fault(done):
    """samples of part.nc: 100 a second, from the origin to X20 Y0, at most 10 mm/s except on the path of N20, which has no length."""
    lines = done.stdout.split()
    if done.returncode or lines[0] != 't,X,Y,Z':
        return f'plan: {done.returncode} {lines[:1]} {done.stderr}'
    rows = [list(map(float, line.split(','))) for line in lines[1:]]
    # the last row is the end, which is not at a hundredth of a second
    if any(abs(b[0] - a[0] - 0.01) > 1e-9 for a, b in zip(rows, rows[1:-1])):
        return 'plan: not each 10 ms'
    if max(abs(value) for value in rows[0]) > 1e-9 or max(abs(a - b) for a, b in zip(rows[-1][1:], [20, 0, 0])) > 1e-6:
        return f'plan: from {rows[0]} to {rows[-1]}'
    fastest = max(sum((q - p) ** 2 for p, q in zip(a[1:], b[1:])) ** 0.5 / 0.01 for a, b in zip(rows, rows[1:-1]))
    least = 7 + (50 + 10 * pi) / 5   # s of cutting; acceleration and deceleration take longer
    return None if 9.9 < fastest < 10.001 and least < rows[-1][0] < least + 60 else f'plan: {fastest} mm/s, {rows[-1][0]} s'


def examples(folder):
    yield prints('interpret', run([folder / 'interpret', EXAMPLES / 'part.nc']), INTERPRET)
    yield plan_fault(run([folder / 'plan', EXAMPLES / 'part.nc']))
    done = run([folder / 'step', EXAMPLES / 'part.nc'])
    yield None if done.returncode == 0 and done.stdout.endswith(STEP) else f'step: {done.stdout}{done.stderr}'
    yield prints('own_control', run([folder / 'own_control', EXAMPLES / 'own.nc', EXAMPLES / 'own.toml']), OWN_CONTROL)
    yield prints('own_sink', run([folder / 'own_sink', EXAMPLES / 'part.nc']), OWN_SINK)
    faulty = folder / 'faulty.nc'
    faulty.write_text(FAULTY)
    for name in ('interpret', 'own_sink', 'step'):   # ends with the alarm, reported with its location
        done = run([folder / name, faulty])
        yield None if done.returncode == 1 and 'faulty.nc:3:' in done.stderr else f'{name}, faulty: {done.returncode} {done.stderr}'
    for name in ('interpret', 'plan', 'step', 'own_sink'):
        done = run([folder / name, folder / 'none.nc'])
        yield None if done.returncode == 2 and 'No such file' in done.stderr else f'{name}, no file: {done.returncode} {done.stderr}'


def as_printed(folder):
    """The program output that docs/library.md and its Russian page show."""
    for page in ('docs/library.md', 'docs/ru/library.md'):
        for command in docs_commands.commands_of(ROOT / page):
            if command.text.startswith('build/examples/'):
                text = command.text.replace('build/examples', shlex.quote(str(folder)), 1)
                done = subprocess.run(['bash', '-c', text], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=TIME_LIMIT_S)
                faults = list(docs_commands.faults_of(command.said(), done.stdout.splitlines()))
                yield f'{command}: {faults[0]}' if faults else None


def by_pkg_config(build, prefix, folder):
    compiler, flags = compiler_of(build)
    libdir = next(prefix.rglob('kadr.pc')).parent
    environment = {**os.environ, 'PKG_CONFIG_PATH': str(libdir)}
    said = must(['pkg-config', '--modversion', 'kadr'], env=environment).strip()
    yield None if said == VERSION else f'kadr.pc: version {said}'
    options = shlex.split(must(['pkg-config', '--cflags', '--libs', 'kadr'], env=environment))
    program = folder / 'by_pkg_config'
    must([compiler, '-std=c++20', *flags, EXAMPLES / 'interpret.cpp', '-o', program, *options])
    done = run([program, EXAMPLES / 'part.nc'], env={**os.environ, 'LD_LIBRARY_PATH': str(libdir.parent)})
    yield prints('interpret by pkg-config', done, INTERPRET)


def readme():
    """The code that the pages show is the example, word for word."""
    for name in ('docs/library.md', 'docs/ru/library.md'):
        shown = re.findall(r'```cpp\n(.*?)```', (ROOT / name).read_text(), re.S)
        yield None if shown == [(EXAMPLES / 'interpret.cpp').read_text()] else f'{name} does not show examples/library/interpret.cpp'


def failures(build, folder):
    """Yields one line per failure; None for each passed check."""
    prefix = folder / 'prefix'
    yield from installed(build, prefix)
    yield from readme()
    headers = sorted(path.name for path in (prefix / 'include/kadr').glob('*.h'))
    compiler, flags = compiler_of(build)
    with ThreadPoolExecutor(2) as pool:
        yield from pool.map(lambda header: header_alone(compiler, flags, prefix, header), headers)
    built(build, prefix, folder / 'shared')
    must(['cmake', '--build', folder / 'shared'])
    yield from examples(folder / 'shared')
    yield from as_printed(folder / 'shared')
    built(build, prefix, folder / 'static', '-DKADR_STATIC=ON')
    must(['cmake', '--build', folder / 'static', '--target', 'interpret'])
    yield prints('interpret, static', run([folder / 'static/interpret', EXAMPLES / 'part.nc']), INTERPRET)
    needed = must(['readelf', '-d', folder / 'static/interpret'])
    yield None if 'libkadr' not in needed else 'the static program needs libkadr.so'
    yield from by_pkg_config(build, prefix, folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--kadr', type=Path, required=True)
    build = parser.parse_args().kadr.resolve().parent
    results = []
    with tempfile.TemporaryDirectory() as folder:
        try:
            for result in failures(build, Path(folder)):
                results.append(result)
        except Failed as failed:
            results.append(str(failed))
    for line in filter(None, results):
        print(line)
    passed = sum(line is None for line in results)
    print(f'{passed} passed, {len(results) - passed} failed')
    sys.exit(passed != len(results))


if __name__ == '__main__':
    main()
