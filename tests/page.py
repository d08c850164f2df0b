#!/usr/bin/env python3
"""Runs the page's own tests (web/test, Vitest), where the page was built; without npm they are skipped with a message.

    page.py --kadr PROGRAM
"""
import subprocess
import sys
from pathlib import Path

import harness


def main():
    web = Path(harness.kadr_of(__doc__)).resolve().parent / 'web'
    if not (web / 'node_modules').is_dir() or not (web / 'dist' / 'index.html').exists():
        harness.skipped('the tests of the page itself: the page was not built here')
        print('0 passed, 0 failed')
        return 0
    return subprocess.run(['npm', 'test', '--silent'], cwd=web, timeout=800, check=False).returncode


if __name__ == '__main__':
    sys.exit(main())
