#!/usr/bin/env python3
"""kadr convert: every golden program of every control to every other is proven equal and written, or refused with the place. No third
outcome: no crash, no hang, no file of a refused one.

    convert_golden.py --kadr PROGRAM [--every N] [--jobs N] [--out FILE]
"""
import argparse
import collections
import concurrent.futures
import json
import subprocess
import sys
import tempfile
from pathlib import Path

from golden.check import runs_of
from harness import TIME_LIMIT_S
from page_client.client import expect, result

CONTROLS = ('s2c42', 'mach3', 'correctors', 'gost', 'nct', 'linuxcnc', 'fanuc', 'haas', 'grbl')
GOLDEN = Path(__file__).resolve().parent / 'golden'
EVERY = 15  # some 20 s; no multiple of 8, else it is one other control alone


def jobs(every):
    pairs = []
    for control in CONTROLS:
        for file in sorted((GOLDEN / control).glob('*.json')):
            case = json.loads(file.read_text(encoding='utf-8'))
            if not case.get('runnable', True):
                continue
            for name, setup, program, _ in runs_of(case):
                pairs += [(control, f'{case["id"]}{name}', setup, program, to) for to in CONTROLS if to != control]
    return pairs[::every]


def convert(kadr, job):
    control, name, setup, program, to = job
    setup = dict(setup)
    files = setup.pop('files', {})
    main = setup.pop('main_file', 'main.nct' if control == 'nct' else 'main.nc')
    setup.pop('points', None), setup.pop('watch', None)
    with tempfile.TemporaryDirectory() as folder:
        for path, text in {**files, main: program}.items():
            file = Path(folder, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding='utf-8', newline='')
        setup_file, out = Path(folder, 'setup.json'), Path(folder, 'out.nc')
        setup_file.write_text(json.dumps(setup, ensure_ascii=False), encoding='utf-8')
        try:
            got = subprocess.run([str(kadr), 'convert', main, '--from', control, '--to', to, '--setup', str(setup_file), '--out', str(out), '--lang', 'en'],
                                 cwd=folder, capture_output=True, text=True, timeout=TIME_LIMIT_S, check=False, errors='replace')
        except subprocess.TimeoutExpired:
            return 'hangs', ''
        if got.returncode == 0 and out.exists() and got.stderr.startswith('equal: '):
            return next(line for line in got.stderr.splitlines() if line.startswith('written')), ''
        if got.returncode == 1 and not out.exists() and 'not converted' in got.stderr:
            return 'refused', got.stderr
        return f'status {got.returncode}', got.stderr


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True, type=Path)
    options.add_argument('--every', type=int, default=EVERY)
    options.add_argument('--jobs', type=int, default=2)
    options.add_argument('--out', type=Path, help='each outcome, a line')
    given = options.parse_args()
    counts = collections.Counter()
    lines = []
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        all_jobs = jobs(given.every)
        for job, (outcome, why) in zip(all_jobs, pool.map(lambda job: convert(given.kadr.resolve(), job), all_jobs)):
            counts[outcome] += 1
            lines.append(f'{job[0]} {job[1]} -> {job[4]}: {outcome}\n{why}')
            expect(outcome == 'refused' or outcome.startswith('written'), f'{job[0]} {job[1]} to {job[4]}: {outcome} {why[:300]}')
    if given.out:
        given.out.write_text(''.join(lines), encoding='utf-8')
    for outcome, count in counts.most_common():
        print(count, outcome, file=sys.stderr)
    expect(sum(counts.values()) > 0 and counts['refused'] < sum(counts.values()), 'something is converted')
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
