#!/usr/bin/env python3
"""Compares Kadr with LinuxCNC's own interpreter: random programs, or those of a folder, in rs274 and in `kadr run --control linuxcnc`.

    tests/linuxcnc_oracle.py --kadr build/release/kadr [--count 400] [--seed 1] [--show] [--axes XYZABC]
    tests/linuxcnc_oracle.py --kadr build/release/kadr --folder DIR [--named FILE]     LinuxCNC's own programs

Compared: positions within 1e-4 mm, arcs with centre and turns, feeds, dwells, messages, spindle, coolant, outputs, and the text of an
alarm. A fourth of the programs are for a machine with the axes U V W too; with `--axes` all are for a machine with these axes.
`--named`: lines `NAME reason` of programs that differ for a reason; a named program without a difference is a fault. Skipped, with a
count and a message, where there is no rs274 (Debian's linuxcnc-uspace: dev/setup oracle).
"""
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import harness

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / 'golden'), str(HERE / 'rs274')]
import check  # noqa: E402
import oracle  # noqa: E402
import programs  # noqa: E402

TOOLS = '\n'.join(f'T{n} P{n} Z0 D0' for n in range(1, 100)) + '\n'
USUAL, ALL = 'XYZABC', 'XYZABCUVW'
SECONDS = 20  # limit of rs274, as some programs never end


class KadrRun(check.Run):
    """Like the referee's run of a case, but for a file in its own folder."""

    def __init__(self, kadr, folder, name, setup_file):  # noqa: super's makes a folder of its own
        setup = json.loads(Path(setup_file).read_text())
        self.axes = setup['axes']
        done = subprocess.run([kadr, 'run', name, '--control', 'linuxcnc', '--setup', setup_file, '--files', '.', '--trace', '-', '--lang', 'en'],
                              cwd=folder, capture_output=True, timeout=harness.TIME_LIMIT_S, stdin=subprocess.DEVNULL)
        self.status, self.stderr = done.returncode, done.stderr.decode(errors='replace')
        lines = [json.loads(x) for x in done.stdout.decode(errors='replace').splitlines() if x.startswith('{')]
        self.end = next((x for x in lines if x['do'] in ('end', 'alarm')), None)
        if self.end is None:
            raise check.Mismatch(f'the trace has no last line (status {self.status}; {self.stderr[:160]})')
        self.actions = [x for x in lines if x['do'] not in ('end', 'alarm') and x.get('code') != 'M66']  # which is no call of rs274
        for action in self.actions:
            if action['do'] == 'home':                    # the second half of G28: rs274 reports a traverse
                action['do'] = 'rapid'
        self.actions = self.without_still()
        self.add_snapshots(setup)


    def without_still(self):
        """Leaves out straight motions of no length, as from the oracle's result."""
        here, moving = dict.fromkeys(self.axes, 0), []
        for action in self.actions:
            to = {**here, **action.get('machine', {})}
            still = action['do'] in ('rapid', 'feed') and all(abs(to[a] - here[a]) <= 1e-9 for a in here)
            here = to
            if not still:
                moving.append(action)
        return moving


def expected(lines, error, text):
    expect = {'trace': oracle.Converter().all(lines), 'complete_for': ['motion', 'message', 'dwell', 'coolant', 'm']}
    if error is None:
        return expect
    expect['alarm'] = {'number': None, 'text': re.split(r': start=|\n', error)[0][:60]}
    if re.search(r'g\s*4[12]', text, re.I):
        expect['open'] = True                             # the motion that waits for cutter compensation
    return expect


def difference(rs274, kadr, folder, name, text, axes=USUAL):
    """Returns the difference, or None; "no answer" if rs274 itself does not end."""
    (folder / 'tool.tbl').write_text(TOOLS)
    (folder / 'p.var').write_text('')
    try:
        lines, error = rs274.run(folder, name, SECONDS, axes)
    except subprocess.TimeoutExpired:
        return 'no answer'
    for rest in ('p.var', 'p.var.bak'):
        (folder / rest).unlink(missing_ok=True)
    setup = folder.parent / 'setup.json'
    setup.write_text(json.dumps({'axes': list(axes), 'probe': {'1': None}}))
    expect = expected(lines, error, text)
    try:
        run = KadrRun(kadr, folder, name, str(setup))
        check.check_alarm(expect.get('alarm'), run)
        check.TraceCheck(expect, run).check()
    except check.Mismatch as mismatch:
        return f'{mismatch}' + (f' (rs274: {error[:100]})' if error else '')
    except subprocess.TimeoutExpired:
        return f'kadr does not end within {harness.TIME_LIMIT_S} s'
    return None


def of_text(rs274, kadr, text, axes):
    with tempfile.TemporaryDirectory(prefix='rs274') as place:
        folder = Path(place, 'memory')
        folder.mkdir()
        (folder / 'main.ngc').write_text(text + '\n')
        return difference(rs274, kadr, folder, 'main.ngc', text, axes)


def of_file(rs274, kadr, path):
    """Runs in a copy of the file's folder, because of the files that it calls."""
    with tempfile.TemporaryDirectory(prefix='rs274') as place:
        folder = Path(place, 'memory')
        folder.mkdir()
        for other in path.parent.iterdir():
            if other.is_file() and other.suffix not in ('.var', '.tbl', '.bak'):
                shutil.copy(other, folder / other.name)
        return difference(rs274, kadr, folder, path.name, path.read_text(encoding='latin-1'))


def named_in(path):
    return dict(line.split(None, 1) for line in Path(path).read_text().splitlines() if line and not line.startswith('#')) if path else {}


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--count', type=int, default=400)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--show', action='store_true', help='print the programs that differ')
    parser.add_argument('--folder')
    parser.add_argument('--named')
    parser.add_argument('--axes', choices=(USUAL, ALL))
    options = harness.parsed(parser)
    kadr, tally = options.kadr, harness.Tally()
    with tempfile.TemporaryDirectory(prefix='rs274') as place:
        try:
            rs274 = oracle.Oracle(place)
        except oracle.Absent as absent:
            tally.skip(f'nothing is compared with LinuxCNC: {absent}')
            return tally.result()
        if options.folder:
            root = Path(options.folder)
            work = {str(f.relative_to(root)): f for f in sorted(root.rglob('*.ngc'))}
            compare = lambda name: of_file(rs274, kadr, work[name])
        else:
            axes = {n: options.axes or (ALL if n % 4 == 0 else USUAL) for n in range(options.seed, options.seed + options.count)}
            work = {f'seed {n}': (*programs.random_program(n, of), of) for n, of in axes.items()}
            compare = lambda name: of_text(rs274, kadr, *work[name][1:])
        found = dict(zip(work, harness.each(compare, list(work))))
    named = named_in(options.named)
    for name, text in found.items():
        if text == 'no answer':
            tally.skip(f'{name}: rs274 does not end')
        elif (text is None) != (name in named):
            tally.judge(name, [])
            if text is not None and name in named:
                print(f'{name}: {named[name]} ({text})')
        else:
            tally.judge(name, [text or 'is named, and equal'])
            if options.show and not options.folder:
                print('\n'.join(f'    {n} {line}' for n, line in enumerate(work[name][1].splitlines(), 1)))
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
