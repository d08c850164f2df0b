#!/usr/bin/env python3
"""Tests kadr convert with every golden program of every control to every other: each conversion is proven equal and written, or refused
with the location. There is no third outcome: no crash, no hang, no file after a refusal.

    convert_golden.py --kadr PROGRAM [--every N] [--jobs N] [--out FILE] [--update]

docs/commands/convert.md and its Russian page state the number of programs of each control; the test always compares that with the golden
programs. It compares the outcomes with both pages only if it converts all programs (--every 1); --update writes them there.
"""
import argparse
import collections
import concurrent.futures
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from golden.check import runs_of
from harness import TIME_LIMIT_S
from page_client.client import expect, result

CONTROLS = ('s2c42', 'mach3', 'correctors', 'gost', 'nct', 'linuxcnc', 'fanuc', 'haas', 'grbl')
GOLDEN = Path(__file__).resolve().parent / 'golden'
EVERY = 15  # takes some 20 s; not a multiple of 8, which would always select the same target control


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


class Document:
    """The statements of docs/commands/convert.md or its Russian page about the golden programs: the figures of a sentence, and a table."""

    DOCS = Path(__file__).resolve().parent.parent / 'docs'
    BEGINS = {'commands/convert.md': 'The golden programs', 'ru/commands/convert.md': 'Эталонные программы'}
    NAMES = {'2С42': 's2c42', 'Mach3': 'mach3', 'correctors': 'correctors', 'с корректорами': 'correctors', 'GOST': 'gost', 'ГОСТ': 'gost', 'NCT': 'nct',
             'LinuxCNC': 'linuxcnc', 'Fanuc': 'fanuc', 'Haas': 'haas', 'Grbl': 'grbl'}
    FIGURE = r'(?<![\w`])\d{1,3}(?:,\d{3})+|(?<![\w`])\d{3,}'   # figures of three digits and more

    def __init__(self, name):
        self.name, self.path = name, self.DOCS / name
        text = self.path.read_text(encoding='utf-8')
        self.begin = text.index(self.BEGINS[name])
        self.end = text.index('\n\n', text.index('\n| ', self.begin))
        self.before, self.text, self.after = text[:self.begin], text[self.begin:self.end], text[self.end:]
        self.sentence, self.table = self.text.split('\n\n', 1)

    def figures(self):
        """Returns the numbers of all conversions, proven, word by word, refused, and refused because of an alarm."""
        return [int(figure.replace(',', '')) for figure in re.findall(self.FIGURE, self.sentence)]

    def programs(self):
        """Returns the number of programs by control."""
        return {self.NAMES[name]: int(count) for name, count in re.findall(r'^\| ([^|]+) \((\d+)\) \|', self.table, re.M)}

    def proven(self):
        """Returns the number of proven conversions by (from, to)."""
        rows = [[cell.strip() for cell in row.strip('|').split('|')] for row in self.table.splitlines()]
        return {(self.NAMES[row[0].split(' (')[0]], self.NAMES[to]): int(cell) for row in rows[2:] for to, cell in zip(rows[0][1:], row[1:]) if cell}

    def written(self, figures, programs, proven):
        """Returns the text with these figures."""
        rest = iter(figures)
        with_comma = ',' in re.search(self.FIGURE, self.sentence)[0]
        sentence = re.sub(self.FIGURE, lambda _: f'{next(rest):,}' if with_comma else str(next(rest)), self.sentence)
        head, line = self.table.splitlines()[:2]
        to = [name.strip() for name in head.strip('|').split('|')][1:]
        rows = [f'| {name} ({programs[self.NAMES[name]]}) | ' + ' | '.join('' if self.NAMES[name] == self.NAMES[b] else str(proven[self.NAMES[name], self.NAMES[b]]) for b in to) + ' |'
                for name in to if programs[self.NAMES[name]]]
        return f'{self.before}{sentence}\n\n' + '\n'.join([head, line, *rows]) + self.after


def hold_documents(all_jobs, outcomes, update):
    """`outcomes`: of all conversions, by job; None if not all were made."""
    programs = collections.Counter(job[0] for job in all_jobs)
    programs = {control: programs[control] // (len(CONTROLS) - 1) for control in CONTROLS}
    for name in Document.BEGINS:
        document = Document(name)
        if outcomes is not None:
            proven = collections.Counter((job[0], job[4]) for job, (outcome, _) in zip(all_jobs, outcomes) if outcome.startswith('written'))
            figures = [len(all_jobs), sum(proven.values()), sum('word by word' in outcome for outcome, _ in outcomes),
                       sum(outcome == 'refused' for outcome, _ in outcomes), sum('an alarm stops the program under its own control' in why for _, why in outcomes)]
            if update:
                document.path.write_text(document.written(figures, programs, proven), encoding='utf-8')
                document = Document(name)
            expect(document.figures() == figures, f'{name}: {document.figures()}, but it is {figures}')
            expect(document.proven() == {pair: proven[pair] for pair in document.proven()}, f'{name}: the table')
        expect(document.figures()[0] == len(all_jobs), f'{name}: {document.figures()[0]} conversions, but there are {len(all_jobs)}')
        expect(document.programs() == {control: count for control, count in programs.items() if count}, f'{name}: programs {document.programs()}, but there are {programs}')


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--kadr', required=True, type=Path)
    options.add_argument('--every', type=int, default=EVERY)
    options.add_argument('--jobs', type=int, default=2)
    options.add_argument('--out', type=Path, help='write each outcome to this file, one per line')
    options.add_argument('--update', action='store_true', help='with --every 1: writes the figures into the documents')
    given = options.parse_args()
    counts = collections.Counter()
    lines, outcomes = [], []
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        all_jobs = jobs(given.every)
        for job, (outcome, why) in zip(all_jobs, pool.map(lambda job: convert(given.kadr.resolve(), job), all_jobs)):
            counts[outcome] += 1
            outcomes.append((outcome, why))
            lines.append(f'{job[0]} {job[1]} -> {job[4]}: {outcome}\n{why}')
            expect(outcome == 'refused' or outcome.startswith('written'), f'{job[0]} {job[1]} to {job[4]}: {outcome} {why[:300]}')
    if given.out:
        given.out.write_text(''.join(lines), encoding='utf-8')
    for outcome, count in counts.most_common():
        print(count, outcome, file=sys.stderr)
    expect(sum(counts.values()) > 0 and counts['refused'] < sum(counts.values()), 'something is converted')
    hold_documents(jobs(1), outcomes if given.every == 1 else None, given.update)
    return result()


if __name__ == '__main__':
    raise SystemExit(main())
