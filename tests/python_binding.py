#!/usr/bin/env python3
"""Tests the Python binding: `import kadr` from the build folder (target kadr_python), and after `pip install` into a fresh virtual
environment without network.

    python_binding.py --kadr build/release/kadr

Expected results are worked out by hand. Prints a line per failure, then `N passed, N failed`.
Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

TIME_LIMIT_S = 840  # it compiles the whole library if ccache has no copy
ROOT = Path(__file__).resolve().parent.parent
CASES = Path(__file__).resolve().parent / 'python_binding'
DEBIAN = Path('/usr/bin/python3')   # the interpreter that python/CMakeLists.txt builds for


def run(command, **more):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=TIME_LIMIT_S, **more)


def with_path(path, **more):
    """Returns an environment in which only `path` is added to Python's import path."""
    clean = {name: value for name, value in os.environ.items() if not name.startswith(('PYTHON', 'PIP_', 'VIRTUAL_ENV'))}
    return {**clean, 'PYTHONDONTWRITEBYTECODE': '1', **({'PYTHONPATH': str(path)} if path else {}), **more}


def of_cases(python, path, name, folder):
    """Yields one line per failed test of tests/python_binding/; None for a passed one."""
    done = run([python, CASES / name, ROOT], env=with_path(path), cwd=folder)
    lines = done.stdout.splitlines()
    if not lines or lines[-1] != 'done':
        yield f'{name}: ended with {done.returncode}: {done.stdout[-500:]}{done.stderr[-3000:]}'
    for line in lines:
        if line.startswith('passed '):
            yield None
        elif line.startswith('failed '):
            yield f'{name}: {line}'


def installed_by_pip(python, build, folder):
    """Installs as python/README.md describes, without an index or a proxy that could reach one."""
    there = folder / 'venv'
    made = run([python, '-m', 'venv', '--system-site-packages', there])
    if made.returncode:
        yield f'venv: {made.stderr}'
        return
    environment = with_path(None, KADR_BUILD=str(build), PATH=f'{there}/bin:/usr/bin:/bin', http_proxy='http://127.0.0.1:9', https_proxy='http://127.0.0.1:9')
    done = run([there / 'bin/pip', 'install', '--no-index', ROOT / 'python'], env=environment, cwd=folder)
    if done.returncode:
        yield f'pip: {done.stdout[-2000:]}{done.stderr[-2000:]}'
        return
    program = 'import kadr; print(kadr.__file__, len(list(kadr.Session("%\\nG0 X5\\nM30\\n%\\n", control="nct").run().moves())))'
    ran = run([there / 'bin/python', '-c', program], env=environment, cwd=folder)
    yield None if ran.stdout.startswith(str(there)) and ran.stdout.endswith(' 1\n') else f'after pip: {ran.stdout}{ran.stderr}'
    typed = list(there.glob('lib/*/site-packages/kadr/py.typed')) + list(there.glob('lib/*/site-packages/kadr/_kadr.pyi'))
    yield None if len(typed) == 2 else f'after pip: no types, {typed}'


def failures(build, folder):
    python = DEBIAN if DEBIAN.exists() else Path(sys.executable)
    if not list((build / 'python/kadr').glob('_kadr*.so')):
        yield f'{build}/python: no extension; target kadr_python (python3-dev, pybind11-dev)'
        return
    for name in ('session.py', 'faults.py', 'interrupt.py', 'without_numpy.py', 'readme.py'):
        yield from of_cases(python, build / 'python', name, folder)
    yield from installed_by_pip(python, build, folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--kadr', type=Path, required=True)
    build = parser.parse_args().kadr.resolve().parent
    with tempfile.TemporaryDirectory() as folder:
        results = list(failures(build, Path(folder)))
    for line in filter(None, results):
        print(line)
    passed = sum(line is None for line in results)
    print(f'{passed} passed, {len(results) - passed} failed')
    sys.exit(passed != len(results))


if __name__ == '__main__':
    main()
