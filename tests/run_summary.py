#!/usr/bin/env python3
"""Tests `kadr run --json`: the test rebuilds the text of the summary from the JSON and compares it with the text that `kadr run` prints, so
all its figures are in the JSON.

    run_summary.py --kadr build/release/kadr [--every N]

Runs every example with its control and set-up, and a share of the golden programs; pictures, planner, several channels, inches, alarms.
Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import decimal
import json
import sys
import tempfile
from pathlib import Path

import harness
from commands.programs import EXAMPLES, example_words

BASIS = {'programmed': 'from programmed feeds and rapid rates, without acceleration', 'limited': 'as the control limits the speed, without acceleration',
         'accelerated': 'as the control limits the speed, with acceleration'}
PLANNER = "by Kadr's planner, within speed, acceleration and jerk of the axes"


class Nudge:
    """The JSON is rounded to 1e-9: for a value on the border between two figures of the text, either figure is correct."""
    by = decimal.Decimal(0)


def number(value, places):
    """Rounds half away from zero, without trailing zeros."""
    rounded = (decimal.Decimal(repr(value)) + Nudge.by).quantize(decimal.Decimal(1).scaleb(-places), decimal.ROUND_HALF_UP).normalize()
    return '0' if rounded == 0 else f'{rounded:f}'


def length(mm, unit):
    return number(mm / 25.4, 4) if unit == 'inch' else number(mm, 3)


def duration(seconds):
    tenths = int((decimal.Decimal(repr(seconds)) + Nudge.by).scaleb(1).quantize(decimal.Decimal(1), decimal.ROUND_HALF_UP))
    whole = tenths // 10
    if whole < 600:
        return f'{whole // 60}:{whole % 60:02}.{tenths % 10}'
    return f'{whole // 60}:{whole % 60:02}' if whole < 3600 else f'{whole // 3600}:{whole // 60 % 60:02}:{whole % 60:02}'


def line(name, value):
    return f'{name:<16}{value}' if len(name) < 16 else f'{name} {value}'


def split(time):
    whole = {key: value['all'] if isinstance(value, dict) else value for key, value in time.items() if key != 'basis'}
    return (f'{duration(whole["all"])} (cutting {duration(whole["cutting"])}, rapid {duration(whole["rapid"])}, dwell {duration(whole["dwell"])}, '
            f'tool change {duration(whole["tool_change"])})')


def extents(channel, key, rotary):
    unit = channel['unit']
    for nth, row in enumerate(channel[key]):
        axes = [f'{name} {number(least, 3) if name in rotary else length(least, unit)} … {number(most, 3) if name in rotary else length(most, unit)}'
                + ('°' if name in rotary else '') for name, (least, most) in row['axes'].items()]
        yield line(f'{key}, {"in" if unit == "inch" else "mm"}' if nth == 0 else '', (f'{row["system"]}  ' if row['system'] else '') + '   '.join(axes))


def text_of(channel):
    motions, unit = channel['motions'], 'in' if channel['unit'] == 'inch' else 'mm'
    yield line('blocks', channel['blocks'])
    other = f', other {motions["other"]}' if motions['other'] else ''
    yield line('motions', f'{motions["all"]} (rapid {motions["rapid"]}, feed {motions["feed"]}, arcs {motions["arcs"]}{other})')
    if channel['unit'] == 'mixed':
        yield line('units', 'mm; the program cuts both in inches and in millimetres')
    yield line(f'path, {unit}', f'cutting {length(channel["path"]["cutting"], channel["unit"])}, rapid {length(channel["path"]["rapid"], channel["unit"])}')
    names = [name for row in channel['all'] for name in row['axes']]
    rotary = set(names) - {'X', 'Y', 'Z'}
    yield from extents(channel, 'cutting', rotary)
    yield from extents(channel, 'all', rotary)
    if channel['diameters']:
        yield line('', 'X is a diameter')
    if speeds := channel['surface_speed_rpm']:
        least, most = speeds
        yield line('spindle', f'{number(least, 0)} rev/min and more at constant surface speed, without an upper limit' if most is None
                   else f'{number(least, 0)} … {number(most, 0)} rev/min at constant surface speed')
    time, least = channel['time'], channel['least_time']
    if time:
        yield line('time', split(time))
        yield line('', BASIS[time['basis']])
    if least:
        yield line('least time' if time else 'time', split(least))
        yield line('', PLANNER)
        yield line('', '; '.join(f'{key} speeding up {duration(least[key]["speeding_up"])}, slowing down {duration(least[key]["slowing_down"])}' for key in ('cutting', 'rapid')))
    if channel['motions_without_time']:
        yield line('', f'motions without a time (no feed, or the spindle stands): {channel["motions_without_time"]}')
    if channel['tools']:
        yield line('tools', ', '.join(f'T{use["tool"]} (cutting {duration(use["cutting"])})' for use in channel['tools']))
    yield line('alarms', f'{channel["alarms"]}, warnings {channel["warnings"]}')


def summary(made):
    channels = made['channels']
    if len(channels) == 1:
        return '\n'.join(text_of(channels[0])) + '\n'
    text = ''.join(f'channel {channel["channel"]}\n' + '\n'.join(text_of(channel)) + '\n\n' for channel in channels)
    times = []
    for channel in channels:
        waited = f' (waiting {duration(channel["waited"])})' if channel['waited'] > 0 else ''
        times.append(f'channel {channel["channel"]} {duration(channel["time"]["all"] + channel["waited"])}{waited}')
    return text + line('machining time', f'{duration(made["machining_time"])}: {", ".join(times)}') + '\n'


def compared(kadr, words):
    """Returns the faults of one program."""
    text = kadr.call('run', *words, '--lang', 'en')
    made = kadr.call('run', *words, '--json', '--lang', 'en')
    if text.returncode == 2:
        return [] if made.returncode == 2 and not made.stdout else [f'status {made.returncode}, {made.stdout[:80]!r} where the text is refused']
    if made.returncode != text.returncode or made.stderr != text.stderr:
        return [f'status {made.returncode}, and {text.returncode} without --json']
    try:
        read = json.loads(made.stdout)
    except ValueError as error:
        return [f'no JSON: {error}: {made.stdout[:100]!r}']
    if read['complete'] != (text.returncode == 0):
        return [f'complete {read["complete"]}, status {text.returncode}']
    made_anew = []
    for nudge in ('0', '1e-9', '-1e-9'):
        Nudge.by = decimal.Decimal(nudge)
        made_anew.append(summary(read).splitlines())
    Nudge.by = decimal.Decimal(0)
    printed = text.stdout.splitlines()
    if len(made_anew[0]) != len(printed):
        return [f'{len(printed)} lines, of the JSON {len(made_anew[0])}: {summary(read)!r}']
    return [f'{line!r}, of the JSON {lines[0]!r}' for line, *lines in zip(printed, *made_anew) if line not in lines][:3]


def check_all(kadr, every):
    for nth, (program, words) in enumerate(example_words()):
        if nth % every == 0:
            yield str(program), compared(kadr, [program, *words])
    lever = (EXAMPLES / 'gost/lever.nc', '--control', 'gost', '--setup', EXAMPLES / 'gost/lever.json')
    samples = ('--samples', 's.csv', '--max-time', '1e6')
    for more in (samples, ('--plot', 'p.svg'), ('--from', '3'), ('--quiet',)):
        if more[0] != '--quiet':
            yield f'lever {more[0]}', compared(kadr, [*lever, *more])
    kadr.file('inch.nc', 'G20 G90\nT3 M6\nS100 M3\nG1 X1.5 F10\nG21\nG0 X5\nM30\n')
    kadr.file('mixed.nc', 'G20 G90\nG1 X1.5 F10\nG21 X5\nG0 A90\nG4 P1\nM30\n')
    kadr.file('stopped.nc', 'G1 X1 F100\nG1 Q0\nM30\n')
    for name in ('inch.nc', 'mixed.nc', 'stopped.nc'):
        for machine in ((), ('--machine', 'mach3-router'), ('--machine', 'mach3-router', *samples)):
            yield f'{name} {" ".join(machine[:3:2])}', compared(kadr, [name, '--control', 'mach3', *machine])


def check_alone(kadr):
    """Standard output contains only the JSON; another output that needs standard output is refused."""
    kadr.file('p.nc', 'G1 X1 F100\nM30\n')
    for words in (('-q',), ('--why',), ('--trace', 't.jsonl'), ('--samples', 's.csv')):
        done = kadr.call('run', 'p.nc', '--control', 'mach3', '--json', *words)
        yield ' '.join(words), [] if done.returncode == 0 and json.loads(done.stdout)['complete'] else [f'{done.returncode} {done.stdout[:200]}']
    for words in (('--trace', '-'), ('--samples', '-')):
        done = kadr.call('run', 'p.nc', '--control', 'mach3', '--json', *words)
        yield ' '.join(words), [] if done.returncode == 2 and not done.stdout and '--json' in done.stderr else [f'{done.returncode} {done.stderr[:200]}']


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--every', type=int, default=1, help='runs every Nth example')
    options = harness.parsed(parser)
    tally = harness.Tally()
    with tempfile.TemporaryDirectory(prefix='kadr_summary_') as folder, harness.Kadr(options.kadr, Path(folder)) as kadr:
        for check in (lambda kadr: check_all(kadr, options.every), check_alone):
            for what, faults in check(kadr):
                tally.judge(what, faults)
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
