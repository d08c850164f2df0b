#!/usr/bin/env python3
"""The page's own tests (web/test, Vitest), where the page was built: without npm they are skipped, which is said.

    page.py --kadr PROGRAM
"""
import argparse
import subprocess
from pathlib import Path


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    web = Path(options.parse_args().kadr).resolve().parent / 'web'
    if not (web / 'node_modules').is_dir() or not (web / 'dist' / 'index.html').exists():
        print('0 passed, 0 failed: the page was not built here')
        return 0
    return subprocess.run(['npm', 'test', '--silent'], cwd=web, timeout=280).returncode


if __name__ == '__main__':
    raise SystemExit(main())
