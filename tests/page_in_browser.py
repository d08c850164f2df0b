#!/usr/bin/env python3
"""Tests what a user does on the page of kadr serve, in a real browser (web/e2e/page.mjs, Chromium). Skipped with a message without Chromium
or a built page. GROUP names the group of steps; without it all run, one after the other.

    page_in_browser.py --kadr PROGRAM [--group GROUP]
"""
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

import harness

most_seconds = 850  # for one round of a group, which takes some 50 s on two idle cores


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--group', default='')
    options = harness.parsed(parser)
    kadr = Path(options.kadr).resolve()
    web = kadr.parent / 'web'
    chromium = os.environ.get('CHROMIUM') or shutil.which('chromium') or shutil.which('chromium-browser')
    missing = ('there is no chromium (dev/setup installs it)' if not chromium
               else 'there is no node' if not shutil.which('node')
               else 'the page was not built here' if not (web / 'node_modules' / 'playwright-core').is_dir() or not (web / 'dist' / 'index.html').exists() else '')
    if missing:
        harness.skipped(f'the page in a browser: {missing}')
        print('0 passed, 0 failed')
        return 0
    with tempfile.TemporaryDirectory(prefix='kadr-page-') as pictures:
        place = {**os.environ, 'GROUP': options.group, 'KADR': str(kadr), 'CHROMIUM': chromium}
        command = ['node', 'e2e/page.mjs', str(harness.ROOT / 'examples'), pictures]
        for again in (True, False):  # software rendering on a busy machine can fail once by itself; two failures are a fault of the page
            try:
                until = {'UNTIL_FAILURE': '1'} if again else {}
                status = subprocess.run(command, cwd=web, env={**place, **until}, timeout=most_seconds, check=False).returncode
            except subprocess.TimeoutExpired:
                print(f'not over after {most_seconds} s')
                status = 1
            if status == 0 or not again:
                return status
            print('once more')


if __name__ == '__main__':
    raise SystemExit(main())
