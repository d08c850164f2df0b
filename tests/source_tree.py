#!/usr/bin/env python3
"""Tests the rules of the source tree: dev/tree finds nothing here, and finds each breach that is planted in a temporary tree. Tests also
that dev/test_results counts the results of a test run, and that dev/slowest names what took longest,
and that dev/doc_names finds wrong names in a page.

    source_tree.py --kadr build/release/kadr

Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import subprocess
import sys
from pathlib import Path

import harness
from harness import expect

ROOT = Path(__file__).resolve().parent.parent
TREE = ROOT / 'dev' / 'tree'
DOC_NAMES = ROOT / 'dev' / 'doc_names'
RESULTS = ROOT / 'dev' / 'test_results'
JUNIT = '''<testsuite>
  <testcase name="oracle" time="0.5" status="run"><system-out>skipped: rs274 is not installed\n0 passed</system-out></testcase>
  <testcase name="slow" time="9.25" status="run"><system-out/></testcase>
  {more}
</testsuite>'''


def run(*command, folder=None):
    """Returns the exit status and all output."""
    done = subprocess.run([str(part) for part in command], cwd=folder, capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def made_tree(folder, files):
    """Creates a git checkout with these files, name → bytes, and tracks those whose name does not begin with "new"."""
    run('git', 'init', '-q', folder)
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    tracked = [name for name in files if not Path(name).name.startswith('new')]
    run('git', 'add', '--', *tracked, folder=folder)


def check_this_tree(_kadr):
    if not (ROOT / '.git').exists():
        harness.skipped('this is no git checkout')
        return
    status, text = run(TREE, ROOT)
    expect(status == 0, text)


def check_a_clean_tree(kadr):
    made_tree(kadr.folder, {'src/a.cpp': b'', 'docs/b.png': bytes(700_000), '.gitignore': b'/out/\n', 'out/large': bytes(800_000)})
    expect(run(TREE, kadr.folder) == (0, ''), 'something is found in a clean tree')


def check_a_large_file(kadr):
    made_tree(kadr.folder, {'src/a.cpp': b'', 'docs/b.png': bytes(700_001)})
    status, text = run(TREE, kadr.folder)
    expect(status == 1 and text.startswith('docs/b.png: '), text)


def check_a_large_file_to_be_added(kadr):
    made_tree(kadr.folder, {'src/a.cpp': b'', 'tests/new.nc': bytes(700_001)})
    status, text = run(TREE, kadr.folder)
    expect(status == 1 and text.startswith('tests/new.nc: '), text)


def check_names_at_the_top(kadr):
    made_tree(kadr.folder, {'src/a.cpp': b'', 'off': b'', '--help/x.ngc': b'', 'new.svg': b''})
    status, text = run(TREE, kadr.folder)
    expect(status == 1 and [line.split(': ')[0] for line in text.splitlines()] == ['--help', 'new.svg', 'off'], text)


def check_namespaces_of_tests(kadr):
    one, other = b'namespace kadr::one_test {\n', b'namespace kadr::other_test {\n'
    made_tree(kadr.folder, {'tests/path/a_test.cpp': one, 'tests/path/b/a_test.cpp': one, 'tests/path/c_test.cpp': other, 'tests/lang/a_test.cpp': one})
    status, text = run(TREE, kadr.folder)
    expect(status == 1 and text == 'tests/path/b/a_test.cpp: has the namespace kadr::one_test of tests/path/a_test.cpp\n', text)


def check_pictures_in_true_colour(kadr):
    def head(colour_type):
        return b'\x89PNG\r\n\x1a\n' + bytes(17) + bytes([colour_type])

    made_tree(kadr.folder, {'docs/a.png': head(2) + bytes(20_000), 'docs/b.png': head(3) + bytes(20_000), 'docs/c.png': head(2)})
    status, text = run(TREE, kadr.folder)
    expect(status == 1 and text.startswith('docs/a.png: ') and text.count('\n') == 1, text)


def check_no_checkout(kadr):
    status, text = run(TREE, kadr.folder)
    expect(status == 2 and 'no git checkout' in text, text)


def results(kadr, more='', *changes):
    return run(RESULTS, kadr.file('tests.xml', JUNIT.format(more=more)), *changes)


def check_results_of_passed_tests(kadr):
    status, text = results(kadr)
    expect(status == 0 and text.endswith('\n2 passed, 0 failed\n'), text)
    expect(text.index(' slow\n') < text.index(' oracle\n'), f'the slowest does not come first: {text}')
    expect('  oracle: rs274 is not installed\n' in text, f'the reason is missing: {text}')


def check_results_of_failed_tests(kadr):
    for more in ('<testcase name="a" status="fail"/>', '<testcase name="a" status="notrun"/>', '<testcase name="a" status="disabled"/>'):
        status, text = results(kadr, more)
        expect(status == 1 and text.endswith('\n2 passed, 1 failed\n'), text)
        expect(('fail' in more) != ('  a: not run' in text), text)


def check_results_where_files_are_left(kadr):
    status, text = results(kadr, '', '?? picture.svg\n M README.md')
    expect(status == 1 and '  ?? picture.svg\n' in text and text.endswith('\n2 passed, 1 failed\n'), text)


def check_no_results(kadr):
    expect(run(RESULTS, kadr.folder / 'tests.xml') == (1, '0 passed, 0 failed\n'), 'no tests are taken for passed ones')


def check_slowest_steps(kadr):
    kadr.file('build/.ninja_log', '# ninja log v5\n0\t1500\t1\ta.o\t1\n0\t2500\t1\tb.o\t2\n0\t3500\t1\ta.o\t3\n')
    kadr.file('build/tests.xml', JUNIT.format(more=''))
    status, text = run(ROOT / 'dev' / 'slowest', kadr.folder / 'build', kadr.folder / 'none', '--steps', '3')
    steps = [line.split(': ', 1)[1] for line in text.splitlines()]
    expect(status == 0 and steps == ['test slow', 'a.o', 'b.o'], text)


def check_names_in_pages(kadr):
    page = kadr.file('page.md', '`Control::run()` in `control/control.h`, `VirtualMachine::take()`.\n| `Session::open()` | `session/session.h` |\n')
    expect(run(DOC_NAMES, page) == (0, ''), 'something is found in a page whose names are right')


def check_wrong_names_in_pages(kadr):
    page = kadr.file('page.md', '`VirtualMachine::nonsense()`; `Control::run()` (`machine/plc.h`); `no_file.h`.\n'
                     '| `Session::open()` | `session/player.h` |\n')
    status, text = run(DOC_NAMES, page)
    expect(status == 1, text)
    for fault in ('VirtualMachine::nonsense is not in src/', 'Control::run is not in machine/plc.h', 'no_file.h is not in src/',
                  'Session::open is not in session/player.h'):
        expect(f': {fault}\n' in text, f'{fault}: not found in {text}')


if __name__ == '__main__':
    sys.exit(harness.main(__doc__, globals()))
