#!/usr/bin/env python3
"""The rules of the source tree: dev/tree finds nothing here, and finds each breach that is planted in a tree of its own.

    source_tree.py --kadr build/release/kadr

Exit status: 0 all passed, 1 some failed.
"""
import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TREE = ROOT / 'dev' / 'tree'


def run(*command, folder=None):
    done = subprocess.run([str(part) for part in command], cwd=folder, capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def made_tree(folder, files):
    """A git checkout with these files; name → bytes. Tracks those whose name does not begin with "new"."""
    run('git', 'init', '-q', folder)
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    tracked = [name for name in files if not Path(name).name.startswith('new')]
    run('git', 'add', '--', *tracked, folder=folder)


def check_this_tree(_folder):
    if not (ROOT / '.git').exists():
        print('skipped: this is no git checkout')
        return True
    status, text = run(TREE, ROOT)
    return status == 0 or text


def check_a_clean_tree(folder):
    made_tree(folder, {'src/a.cpp': b'', 'docs/b.png': bytes(700_000), '.gitignore': b'/out/\n', 'out/large': bytes(800_000)})
    return run(TREE, folder) == (0, '')


def check_a_large_file(folder):
    made_tree(folder, {'src/a.cpp': b'', 'docs/b.png': bytes(700_001)})
    status, text = run(TREE, folder)
    return status == 1 and text.startswith('docs/b.png: ') or text


def check_a_large_file_to_be_added(folder):
    made_tree(folder, {'src/a.cpp': b'', 'tests/new.nc': bytes(700_001)})
    status, text = run(TREE, folder)
    return status == 1 and text.startswith('tests/new.nc: ') or text


def check_names_at_the_top(folder):
    made_tree(folder, {'src/a.cpp': b'', 'off': b'', '--help/x.ngc': b'', 'new.svg': b''})
    status, text = run(TREE, folder)
    return status == 1 and [line.split(': ')[0] for line in text.splitlines()] == ['--help', 'new.svg', 'off'] or text


def check_no_checkout(folder):
    status, text = run(TREE, folder)
    return status == 2 and 'no git checkout' in text or text


def main():
    parser = argparse.ArgumentParser(description='Check the rules of the source tree.')
    parser.add_argument('--kadr', help='not used: every runner is told the program')
    parser.parse_args()
    failed = 0
    checks = [check for name, check in globals().items() if name.startswith('check_')]
    for check in checks:
        with tempfile.TemporaryDirectory() as folder:
            result = check(Path(folder))
        if result is not True:
            print(f'FAILED {check.__name__}: {result}')
            failed += 1
    print(f'{len(checks) - failed} passed, {failed} failed')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
