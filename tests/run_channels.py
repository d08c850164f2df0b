#!/usr/bin/env python3
"""Property test of channels that wait for each other (NCT 14.5), and of what `kadr check` and the summary report about them.

    run_channels.py --kadr build/kadr [--seed N] [--count N]

Random programs of two to four channels, with dwells and waiting codes, are run twice. The traces are equal, and no run hangs. Which
channels meet, when, and which wait without end must agree with the slow model below, which has no scheduler. The seed is printed. Exit
status: 0 all passed, 1 some failed.
"""
import json
import random
import sys
from pathlib import Path

import harness
from harness import Failure

PARAMETERS = {'N2201': 500, 'N2202': 599}
NEAR = 1e-6  # s


def random_channels(rng):
    """Returns {channel: [('dwell', s) or ('wait', code, channels)]}; in half of the results all channels can meet."""
    numbers = range(1, rng.randint(2, 4) + 1)
    channels = {n: [] for n in numbers}
    fair = rng.random() < 0.5
    for _ in range(rng.randint(1, 12)):
        who = sorted(rng.sample(numbers, rng.randint(2, len(numbers))))
        wait = ('wait', rng.choice((501, 502)), tuple(who))
        for n in who if fair else rng.sample(who, rng.randint(1, len(who))):
            if rng.random() < 0.8:
                channels[n].append(('dwell', rng.randint(1, 5000) / 1000))
            channels[n].append(wait)
    return channels


def text_of(steps, rng):
    """Returns the program, with the digits of P in any order."""
    lines = ['G94']
    for step in steps:
        if step[0] == 'dwell':
            lines.append(f'G4 P{step[1]}')
        else:
            lines.append(f'M{step[1]} P' + ''.join(map(str, rng.sample(step[2], len(step[2])))))
    return '\n'.join(lines + ['M30'])


def model(channels):
    """Returns ([(code, {channel: arrival})] in the order of release, channels that wait without end). No clock: channels that can meet do."""
    place, time, met = dict.fromkeys(channels, 0), dict.fromkeys(channels, 0.0), []
    while True:
        waiting = {}
        for n, steps in channels.items():
            while place[n] < len(steps) and steps[place[n]][0] == 'dwell':
                time[n] += steps[place[n]][1]
                place[n] += 1
            if place[n] < len(steps):
                waiting[n] = steps[place[n]][1:]
        for n, key in waiting.items():
            if all(waiting.get(other) == key for other in key[1]):
                met.append((key[0], {other: time[other] for other in key[1]}))
                release = max(time[other] for other in key[1])
                for other in key[1]:
                    time[other], place[other] = release, place[other] + 1
                break
        else:
            return sorted(met, key=lambda m: max(m[1].values())), set(waiting)


class Kadr(harness.Kadr):
    language = 'en'

    def nct(self, *arguments):
        return self.call(*arguments, '--control', 'nct', '--setup', 'setup.json')

    def lay_out(self, programs, **setup):
        setup = {'parameters': PARAMETERS, 'channels': {str(n): {'program': p} for n, p in programs.items() if n != 1}, **setup}
        self.file('setup.json', json.dumps(setup))
        self.file('main.nct', programs[1])


def judge_syncs(lines, met):
    syncs = [line for line in lines if line['do'] == 'sync']
    if len(syncs) != len(met):
        raise Failure(f'{len(syncs)} meetings, {len(met)} expected')
    left = list(met)
    for sync in syncs:
        same = [m for m in left if m[0] == int(sync['code'][1:]) and set(m[1]) == set(sync['channels'])
                and abs(max(m[1].values()) - sync['at']) < NEAR]
        if not same:
            raise Failure(f'not expected: {sync}')
        arrivals = [same[0][1][n] for n in sync['channels']]
        if any(a > b + NEAR for a, b in zip(arrivals, arrivals[1:])):
            raise Failure(f'not in the order of arrival: {sync}, {same[0]}')
        left.remove(same[0])
    if any(a['at'] > b['at'] + NEAR for a, b in zip(syncs, syncs[1:])):
        raise Failure('meetings not in the order of time')


def judge_random(kadr, channels, programs):
    met, stuck = model(channels)
    kadr.lay_out(programs)
    done = kadr.nct('run', 'main.nct', '-q', '--trace', '-')
    if done.stdout != kadr.nct('run', 'main.nct', '-q', '--trace', '-').stdout:
        raise Failure('the second trace is another one')
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    judge_syncs(lines, met)
    last = {line['channel']: line for line in lines if line['do'] in ('end', 'alarm')}
    if set(last) != set(channels):
        raise Failure(f'last lines of channels {sorted(last)}')
    waits = {n for n, line in last.items() if line.get('id') == 'channels_wait'}
    if waits != stuck or done.returncode != (1 if stuck else 0):
        raise Failure(f'waiting for ever: {sorted(waits)}, {sorted(stuck)} expected; exit status {done.returncode}')
    for n, steps in channels.items():
        dwells = [s[1] for s in steps if s[0] == 'dwell']
        got = [line['seconds'] for line in lines if line['do'] == 'dwell' and line['channel'] == n]
        if any(abs(a - b) > NEAR for a, b in zip(dwells, got)) or (n not in stuck and len(dwells) != len(got)):
            raise Failure(f'channel {n}: dwells {got}, {dwells} expected')


def check_summary(kadr):
    """Busy and waiting times of each channel; the longest is the machining time."""
    kadr.lay_out({1: 'G94 G4 P2\nM501 P12\nG4 P1', 2: 'G94 G4 P5\nM501 P12'})
    out = kadr.nct('run', 'main.nct').stdout
    expected = 'machining time  0:06.0: channel 1 0:06.0 (waiting 0:03.0), channel 2 0:05.0'
    if expected not in out.splitlines():
        raise Failure(f'the summary lacks {expected!r}:\n{out}')


def check_stopped(kadr):
    """An alarm stops all channels: the last line of the other channel names the origin."""
    kadr.lay_out({1: 'G94 G4 P5\n#100=1', 2: 'G94 G4 P1\nN7 #3000=1(STOP)'})
    done = kadr.nct('run', 'main.nct', '-q', '--trace', '-')
    last = {line['channel']: line for line in map(json.loads, done.stdout.splitlines()) if line['do'] in ('end', 'alarm')}
    if last[1].get('alarm_channel') != 2 or 'alarm_channel' in last[2] or last[1]['block'] != 'N7' or done.returncode != 1:
        raise Failure(f'last lines {last}')
    if 'channel2.nct:2:' not in done.stderr:
        raise Failure(f'stderr: {done.stderr}')


def check_faults(kadr):
    """kadr check finds the faults of all channels, and waits without end; a program alone has no such waits."""
    kadr.lay_out({1: 'M501 P12\nG1 X1 F100 G997\nM502 P12\nG999', 2: 'G998\nM501 P12\n#100=1'})
    done = kadr.nct('check', 'main.nct', '--format', 'json')
    found = sorted((Path(f['file']).name, f['line'], f['id']) for f in json.loads(done.stdout))
    expected = [('channel2.nct', 1, 'code_unknown'), ('main.nct', 2, 'code_unknown'), ('main.nct', 3, 'channels_wait'),
                ('main.nct', 4, 'code_unknown')]
    if found != expected or done.returncode != 1:
        raise Failure(f'found {found}, expected {expected}')
    kadr.file('setup.json', json.dumps({'parameters': PARAMETERS}))
    kadr.file('main.nct', 'M501 P12\nG1 X1 F100\nM502 P12\n')
    if (done := kadr.nct('check', 'main.nct')).returncode != 0:
        raise Failure(f'a program alone: {done.stderr}')
    kadr.file('main.nct', 'G94\nG4 P1\n#3001=0\nWHILE[#3001 LT 2000]DO1\nG4 P0.5\nEND1\n')
    if (done := kadr.nct('check', 'main.nct')).returncode != 0:
        raise Failure(f'a loop that looks at the clock: {done.stderr}')


def check_setups(kadr):
    """Invalid set-ups: the program's own channel again, axes that do not exist, events that never occur."""
    def on(code):
        return {'events': [{'when': {'code': code}, 'do': 'start'}]}
    for setup, words in (({'channels': {'1': {'program': ''}}}, 'channel 1'), ({'channels': {'2': {'axes': ['Q']}}}, 'channel 2: '), (on('G4'), 'G4')):
        kadr.lay_out({1: 'M30'}, **setup)
        done = kadr.nct('run', 'main.nct')
        if done.returncode != 2 or words not in done.stderr:
            raise Failure(f'{setup}: exit status {done.returncode}, {done.stderr}')


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--seed', type=int, default=14, help='seed of the random programs')
    parser.add_argument('--count', type=int, default=60, help='number of random programs')
    options = harness.parsed(parser)
    print(f'seed {options.seed}')
    rng, checks = random.Random(options.seed), harness.checks_of(globals())
    for number in range(options.count):
        channels = random_channels(rng)
        programs = {n: text_of(steps, rng) for n, steps in channels.items()}
        checks[f'random {number}'] = lambda kadr, channels=channels, programs=programs: judge_random(kadr, channels, programs)
    return harness.carried_out(checks, options.kadr, Kadr)


if __name__ == '__main__':
    sys.exit(main())
