#!/usr/bin/env python3
"""Tests where `make install` and `make deb` put which file: the Debian package is built, checked by lintian, unpacked, and its program run.

    package.py --kadr build/release/kadr

The package is built inside the build folder, in a folder of its own that is removed. Prints a line per failure, then `N passed, N
failed`. Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import argparse
import gzip
import re
import subprocess
import sys
import tempfile
from pathlib import Path

TIME_LIMIT_S = 240
ROOT = Path(__file__).resolve().parent.parent
DOC = 'usr/share/doc/kadr'
# Files of the package, each with a part of its text; None: the text is not checked.
FILES = [
    ('usr/bin/kadr', None),
    ('usr/lib/kadr/modules/kadr-bodies.so', None),
    ('usr/share/man/man1/kadr.1.gz', 'kadr run'),
    ('usr/share/man/ru/man1/kadr.1.gz', 'станк'),
    ('usr/share/bash-completion/completions/kadr', 'complete '),
    ('usr/share/zsh/vendor-completions/_kadr', '#compdef kadr'),
    ('usr/share/fish/vendor_completions.d/kadr.fish', 'complete -c kadr'),
    ('usr/share/kadr/controls/nct.toml', 'id = "nct"'),
    ('usr/share/kadr/machines/generic.toml', None),
    (f'{DOC}/copyright', 'Apache-2.0'),
    (f'{DOC}/copyright', 'Boost Software License'),
    (f'{DOC}/changelog.gz', 'kadr ('),
    (f'{DOC}/README.md', 'make run'),
    (f'{DOC}/README.ru.md', 'кадр'),
    (f'{DOC}/docs/setup.md', None),
    (f'{DOC}/docs/ru/setup.md', None),
    (f'{DOC}/examples/s2c42/flange.nc', None),
]


def run(command, **more):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=TIME_LIMIT_S, **more)


def text_of(path):
    data = path.read_bytes()
    return (gzip.decompress(data) if path.suffix == '.gz' else data).decode()


def failures(build, folder):
    """Yields one line per failure; None for each passed check."""
    made = run(['cpack', '--config', build / 'CPackConfig.cmake', '-B', folder / 'deb'])
    packages = list((folder / 'deb').glob('*.deb'))
    if made.returncode or len(packages) != 1:
        yield f'cpack: {made.stdout}{made.stderr}'
        return
    judged = run(['lintian', '--fail-on', 'error,warning', '--allow-root', packages[0]])
    yield None if judged.returncode == 0 else f'lintian: {judged.stdout}{judged.stderr}'
    tree = folder / 'tree'
    unpacked = run(['dpkg-deb', '-x', packages[0], tree])
    yield None if unpacked.returncode == 0 else unpacked.stderr
    for name, piece in FILES:
        path = tree / name
        if not path.is_file():
            yield f'{name} is not in it'
        else:
            yield None if piece is None or piece in text_of(path) else f'{name} does not hold {piece!r}'
    version = re.search(r'^project\(kadr VERSION (\S+)', (ROOT / 'CMakeLists.txt').read_text(), re.M)[1]
    said = run([tree / 'usr/bin/kadr', '--version']).stdout
    yield None if said == f'kadr {version}\n' else f'--version says {said!r}, CMakeLists.txt {version}'
    field = run(['dpkg-deb', '-f', packages[0], 'Version']).stdout.strip()
    yield None if field == version else f'the package is {field}, CMakeLists.txt has {version}'
    # the example of the documentation, by the installed program and files
    ran = run([tree / 'usr/bin/kadr', 'run', tree / DOC / 'examples/s2c42/flange.nc', '--setup', tree / DOC / 'examples/s2c42/flange.json'])
    yield None if ran.returncode == 0 and 'blocks' in ran.stdout + ran.stderr else f'the example: {ran.stdout}{ran.stderr}'
    # modules loaded on demand are found where they are installed, and the package depends on what it needs
    cut = tree / DOC / 'examples/cut'
    ran = run([tree / 'usr/bin/kadr', 'cut', cut / 'trunnion.nc', '--control', 'mach3', '--machine', cut / 'trunnion.toml', '--setup', cut / 'trunnion.json',
               '--stock', 'box:-20,-20,-20,20,20,0', '--tools', cut / 'tools.toml', '--lang', 'en', '--resolution', '1'])
    yield None if ran.returncode == 1 and 'alarm machine' in ran.stderr else f'bodies of the machine: {ran.stdout}{ran.stderr}'
    needs = run(['dpkg-deb', '-f', packages[0], 'Depends']).stdout
    yield None if 'libfcl' in needs else f'the package does not need FCL: {needs}'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--kadr', type=Path, required=True)
    build = parser.parse_args().kadr.resolve().parent
    with tempfile.TemporaryDirectory(dir=build) as folder:
        results = list(failures(build, Path(folder)))
    for line in filter(None, results):
        print(line)
    passed = sum(line is None for line in results)
    print(f'{passed} passed, {len(results) - passed} failed')
    sys.exit(passed != len(results))


if __name__ == '__main__':
    main()
