#!/usr/bin/env python3
"""What a user does on the page of kadr serve, in a real browser (web/e2e/page.mjs, Chromium). Without Chromium, or without a built page, it is skipped, which is said.

    page_in_browser.py --kadr PROGRAM
"""
import argparse
import os
import shutil
import subprocess
import tempfile
from pathlib import Path


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True)
    kadr = Path(options.parse_args().kadr).resolve()
    web, root = kadr.parent / 'web', Path(__file__).resolve().parent.parent
    chromium = os.environ.get('CHROMIUM') or shutil.which('chromium') or shutil.which('chromium-browser')
    if not os.environ.get('KADR_BROWSER'):  # not steady enough yet on a busy machine
        print('0 passed, 0 failed: with KADR_BROWSER=1 only')
        return 0
    missing = ('there is no chromium (dev/setup installs it)' if not chromium
               else 'there is no node' if not shutil.which('node')
               else 'the page was not built here' if not (web / 'node_modules' / 'playwright-core').is_dir() or not (web / 'dist' / 'index.html').exists() else '')
    if missing:
        print(f'0 passed, 0 failed: {missing}')
        return 0
    with tempfile.TemporaryDirectory(prefix='kadr-page-') as pictures:
        place = {**os.environ, 'KADR': str(kadr), 'CHROMIUM': chromium}
        return subprocess.run(['node', 'e2e/page.mjs', str(root / 'examples'), pictures], cwd=web, env=place, timeout=590).returncode


if __name__ == '__main__':
    raise SystemExit(main())
