#!/usr/bin/env python3
"""Runner of the faulty programs: `kadr check` must find every fault of tests/faulty/CONTROL/*.nc, and nothing else.

    run_faulty.py --kadr build/kadr                 all programs
    run_faulty.py --kadr build/kadr --only 'arc-*'  some of them

Each program NAME.nc (NAME.tape: rows of a punched tape) has a file NAME.expect:

    3:10 address_twice               a fault: line, column in characters from 1, id; in the order of `kadr check`
    3:4 warning look_alike_letter    a warning
    text: Address X twice            English text of the first fault
    number: 2002                     the control's own number of the first fault; nct: also that it has none, if the line is missing
    other: 4                         line of the second location of the first finding (the contour that is cut), shown in both formats
    args: --setup NAME.json          further arguments
    exit: 1                          default: 1 with a fault, 0 without
    # …                              a comment

The note not_stated (offsets that no set-up states) and advice count only where they are expected; tests/setup_command.py and
tests/checklist.py test them.

Each program is checked twice: --format json gives the findings, --format text must show the same lines, each with its source
line and a caret under the column, and the count. An unknown key, a folder without programs, a program without its .expect file or the
reverse fail.
Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import fnmatch
import json
import re
import shlex
import sys
from pathlib import Path

import harness
from harness import CONTROLS, Failure

ROOT = Path(__file__).resolve().parent / 'faulty'
PROGRAMS = ('.nc', '.tape')
FAULT = re.compile(r'(\d+):(\d+) (warning |note |advice )?([a-z0-9_]+)')


class Expected:
    """The content of NAME.expect."""

    def __init__(self, path):
        self.findings, self.text, self.number, self.args, self.exit, self.other = [], None, None, [], None, None
        for number, line in enumerate(path.read_text(encoding='utf-8').splitlines(), 1):
            line = line.strip()
            if not line or line.startswith('#'):
                continue
            if found := FAULT.fullmatch(line):
                self.findings.append((int(found[1]), int(found[2]), found[3].strip() if found[3] else 'alarm', found[4]))
                continue
            key, colon, value = line.partition(':')
            value = value.strip()
            if not colon or not value or key not in ('text', 'number', 'args', 'exit', 'other'):
                raise Failure(f'{path.name}:{number}: not understood: {line}')
            if key == 'text':
                self.text = value
            elif key == 'number':
                self.number = value
            elif key == 'args':
                self.args = shlex.split(value)
            elif key == 'other':
                self.other = int(value)
            else:
                self.exit = int(value)
        self.faults = sum(f[2] == 'alarm' for f in self.findings)
        if (self.text or self.number) and not self.findings:
            raise Failure(f'{path.name}: text or number, but no finding')
        if not self.findings and self.exit is None:
            raise Failure(f'{path.name}: expects nothing; say exit: 0 if that is meant')
        if self.exit is None:
            self.exit = 1 if self.faults else 0


def run(kadr, program, control, args, style):
    done = harness.Kadr(kadr, program.parent).call('check', program.name, '--control', control, '--lang', 'en', '--format', style, *(['--every'] if style == 'text' else []), *args)
    return done.returncode, done.stdout, done.stderr


def shown(findings):
    return '; '.join(f'{line}:{column} {"" if severity == "alarm" else severity + " "}{name}' for line, column, severity, name in findings) or 'nothing'


def check_json(expected, program_control, status, out, err):
    if status != expected.exit:
        raise Failure(f'exit status expected {expected.exit}, got {status} {err.strip()[:160]}')
    try:
        findings = json.loads(out)
    except json.JSONDecodeError:
        raise Failure(f'stdout is not JSON: {out[:120]!r} {err[:160]!r}') from None
    if not any(name == 'not_stated' for _, _, _, name in expected.findings):  # for programs without a set-up it counts only where it is the topic
        findings = [f for f in findings if f['id'] != 'not_stated']
    advised = {name for _, _, severity, name in expected.findings if severity == 'advice'}
    findings = [f for f in findings if f['severity'] != 'advice' or f['id'] in advised]
    got = [(f['line'], f['column'], f['severity'], f['id']) for f in findings]
    if got != expected.findings:
        raise Failure(f'expected {shown(expected.findings)}\n      got      {shown(got)}')
    if expected.text is not None:
        first = next((f for f in findings if f['severity'] == 'alarm'), findings[0])
        if first['text'] != expected.text:
            raise Failure(f'text expected {expected.text!r}, got {first["text"]!r}')
    if expected.other is not None and findings[0].get('other', {}).get('line') != expected.other:
        raise Failure(f'other line expected {expected.other}, got {findings[0].get("other")}')
    if findings and (expected.number or program_control == 'nct'):
        if findings[0]['number'] != expected.number:
            raise Failure(f'number expected {expected.number}, got {findings[0]["number"]}')
    for f in findings:
        if not f['hint'] or not f['text'] or re.search(r'\{\d?\}', f['text']):
            raise Failure(f'{f["line"]}:{f["column"]} {f["id"]}: text or hint is not complete: {f["text"]!r} {f["hint"]!r}')
        if '\N{REPLACEMENT CHARACTER}' in f['line_text']:
            raise Failure(f'{f["line"]}:{f["column"]}: the line is not decoded: {f["line_text"]!r}')
    return findings


def check_text(program, expected, findings, status, out, err):
    if status != expected.exit:
        raise Failure(f'--format text: exit status expected {expected.exit}, got {status}')
    lines = err.splitlines()
    at = 0
    for f in findings:
        head = f'{program.name}:{f["line"]}:{f["column"]}: {f["severity"]} {f["id"]}: {f["text"]}'
        while at < len(lines) and not lines[at].startswith(head):
            at += 1
        if at == len(lines):
            raise Failure(f'--format text lacks: {head}')
        if f['line_text']:
            check_caret(f, lines[at + 1:at + 3])
        if other := f.get('other'):
            check_other(other, lines[at + 3:at + 6])
        at += 1
    plural = lambda n: '' if n == 1 else 's'
    warnings = sum(f['severity'] == 'warning' for f in findings)
    count = f'1 program checked: {expected.faults} error{plural(expected.faults)}, {warnings} warning{plural(warnings)}'
    if not re.fullmatch(re.escape(count) + r'(, \d+ advices?)?\.', out.strip()):
        raise Failure(f'--format text: count expected {count!r}, got {out.strip()!r}')


def check_caret(finding, two_lines):
    """Checks that the line after the source line has a caret below the character at the column."""
    where = f'{finding["line"]}:{finding["column"]}'
    if len(two_lines) < 2 or not re.fullmatch(r'\s*\^~*\s*', two_lines[1]):
        raise Failure(f'--format text: no caret line at {where}')
    source, caret = finding['line_text'], two_lines[1].index('^')
    if len(source) >= finding['column'] and source[finding['column'] - 1].isprintable():
        if caret >= len(two_lines[0]) or two_lines[0][caret] != source[finding['column'] - 1]:
            raise Failure(f'--format text: the caret of {where} is under another character')


def check_other(other, three_lines):
    """Checks the second location: its line number, the line, a caret."""
    if len(three_lines) < 3 or three_lines[0].strip() != f'see line {other["line"]}:' or three_lines[1].strip() != other['line_text'].strip():
        raise Failure(f'--format text: the second place is not shown: {three_lines}')
    if not re.fullmatch(r'\s*\^~*\s*', three_lines[2]):
        raise Failure(f'--format text: no caret under the second place')


def judge(kadr, program, control):
    """Returns the faults: none, or why it failed."""
    expectation = program.with_suffix('.expect')
    if not expectation.exists():
        return [f'{expectation.name} is missing']
    try:
        expected = Expected(expectation)
        findings = check_json(expected, control, *run(kadr, program, control, expected.args, 'json'))
        check_text(program, expected, findings, *run(kadr, program, control, expected.args, 'text'))
    except Failure as failure:
        return [str(failure)]
    return []


def programs_of(control, tally):
    folder = ROOT / control
    files = sorted(folder.iterdir()) if folder.is_dir() else []
    programs = [f for f in files if f.suffix in PROGRAMS]
    if not programs:
        tally.judge(f'{control}/', ['holds no program'])
    used = {f.name for p in programs for f in (p, p.with_suffix('.expect'), p.with_suffix('.json'))}
    for file in files:
        if file.name not in used:
            tally.judge(f'{control}/{file.name}', ['belongs to no program'])
    return [(p, control) for p in programs]


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--only', default='*', help='only programs whose name matches, e.g. "arc-*"')
    options = harness.parsed(parser)
    tally = harness.Tally()
    for file in sorted(ROOT.iterdir()):
        if file.name not in CONTROLS:
            tally.judge(file.name, ['is no control'])
    jobs = [job for control in CONTROLS for job in programs_of(control, tally)]
    jobs = [job for job in jobs if fnmatch.fnmatch(job[0].name, options.only) or fnmatch.fnmatch(job[0].stem, options.only)]
    if not jobs:
        parser.error('no program to check')
    for (program, control), faults in zip(jobs, harness.each(lambda job: judge(options.kadr, *job), jobs)):
        tally.judge(f'{control}/{program.name}', faults)
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
