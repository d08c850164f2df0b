#!/usr/bin/env python3
"""Tests wrong set-ups: each is refused with its location, its key and the nearest valid one, in both languages, exit status 2.

    setup_refused.py --kadr build/kadr

Each row: control, set-up (text of the file, or options), what stderr must contain after the file's name, in English and in Russian.
Prints a line per failing row, then `N passed, N failed`. Exit status: 0 all passed, 1 some failed, 2 wrong usage.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

import harness

PROGRAMS = {'s2c42': '%\nN1 G90 ПС\nN2 M2 ПС\n', 'mach3': 'M30\n', 'gost': '%\nN1 G90\nN2 M02\n', 'correctors': '%\nN1 G90\nN2 M02\n', 'nct': 'M30\n'}
AXES = {'mach3': 'X, Y, Z, A, B, C', 'nct': 'X, Y, Z', 's2c42': 'X, Y, Z', 'gost': 'X, Y, Z, U, V, W, A, B, C'}


def no_axis(key, axis, near=None, there=None):
    """Returns the (English, Russian) message about a wrong axis."""
    return (f"setup key '{key}': no axis '{axis}'; " + (f"did you mean '{near}'?" if near else f'there are {there}'),
            f'ключ «{key}» исходного состояния: нет оси «{axis}»; ' + (f'возможно, «{near}»?' if near else f'есть {there}'))


def not_of(key, control, instead=None):
    return (f"setup key '{key}': the control {control} has no such thing" + (f"; did you mean '{instead}'?" if instead else ''),
            f'ключ «{key}» исходного состояния: у УЧПУ {control} этого нет' + (f'; возможно, «{instead}»?' if instead else ''))


def unknown(key, near):
    return f"unknown setup key '{key}'; did you mean '{near}'?", f'неизвестный ключ «{key}» исходного состояния; возможно, «{near}»?'


def must_be(key, en, ru):
    return f"setup key '{key}' must be {en}", f'ключ «{key}» исходного состояния: нужно: {ru}'


# control, set-up, line, (English, Russian)
FILES = [
    # issue 15, 2: formerly accepted on nct without a message
    ('nct', '{"work_offsets": {"G54": {"x": -500}}}', 1, no_axis('work_offsets.G54.x', 'x', 'X')),
    ('nct', '{\n "start": {"X": 1,\n           "Q": 2}\n}', 3, no_axis('start.Q', 'Q', there='X, Y, Z')),
    ('nct', '{"work_offsets":\n {"G99": {"X": 1}}}', 2, ("setup key 'work_offsets.G99': no work offset 'G99'; did you mean 'G59'?",
                                                        'ключ «work_offsets.G99» исходного состояния: нет нуля детали «G99»; возможно, «G59»?')),
    ('nct', '{"zeros": {"1": {"X": 1}}}', 1, not_of('zeros', 'nct', 'work_offsets')),
    ('nct', '{"machine": {"x": {"rapid": 5}}}', 1, no_axis('machine.x', 'x', 'X')),
    ('nct', '{"skip": [12]}', 1, must_be('skip', 'a list of whole numbers, 1 to 9', 'список целых чисел, от 1 до 9')),
    ('nct', '{"tool": -4}', 1, must_be('tool', 'a whole number, 0 to 99999999', 'целое число, от 0 до 99999999')),
    ('nct', '{"signals": {"CP_MIND": 1}}', 1, ("setup key 'signals.CP_MIND': no signal 'CP_MIND'; did you mean 'CP_MINT'?",
                                              'ключ «signals.CP_MIND» исходного состояния: нет сигнала «CP_MIND»; возможно, «CP_MINT»?')),
    ('nct', '{"correctors": {"3": 1}}', 1, not_of('correctors', 'nct', 'offsets')),
    ('nct', '{"variables": {"R2": 1}}', 1, must_be('variables.R2', 'named #n or #_NAME', 'имя вида #n или #_NAME')),
    ('nct', '{"parameters": {"N13390": 1}}', 1, ("setup key 'parameters.N13390': no parameter 'N13390'; did you mean 'N1339'?",
                                                'ключ «parameters.N13390» исходного состояния: нет параметра «N13390»; возможно, «N1339»?')),
    ('nct', '{"offsets": {"0": {"length": 1}}}', 1, must_be('offsets.0', 'named by a whole number, 1 to 999', 'номер — целое число от 1 до 999')),
    ('nct', '{"offsets": {"1": {"lenght": 1}}}', 1, unknown('offsets.1.lenght', 'length')),
    ('nct', '{"offsets": {"01": {"length": 1}}}', 1, must_be('offsets.01', 'named by a whole number, 1 to 999', 'номер — целое число от 1 до 999')),
    ('nct', '{"mirror": ["V"]}', 1, no_axis('mirror', 'V', there='X, Y, Z')),
    ('nct', '{"diameter": {"U": true}}', 1, no_axis('diameter.U', 'U', there='X, Y, Z')),
    ('nct', '{"reference_points": {"5": {"X": 0}}}', 1, must_be('reference_points.5', 'named by a whole number, 1 to 4', 'номер — целое число от 1 до 4')),
    ('nct', '{"probe": {"1": {"z": 0}}}', 1, no_axis('probe.1.z', 'z', 'Z')),
    ('nct', '{"events": [{"when": {"code": "M21"}, "do": "set", "signal": "CP_MINTT", "value": 1}]}', 1,
     ("setup key 'events[0].signal': no signal 'CP_MINTT'; did you mean 'CP_MINT'?",
      'ключ «events[0].signal» исходного состояния: нет сигнала «CP_MINTT»; возможно, «CP_MINT»?')),
    ('nct', '{"shifts": {"G93": {"X": 1}}}', 1, ("setup key 'shifts.G93': no shift 'G93'; did you mean 'G92'?",
                                                'ключ «shifts.G93» исходного состояния: нет смещения «G93»; возможно, «G92»?')),
    ('nct', '{"axes": ["X", "Y", "V"], "start": {"Z": 1}}', 1, no_axis('start.Z', 'Z', there='X, Y, V')),
    ('nct', '{"kinematics": {"type": "gantry"}}', 1, must_be('kinematics.type', '"head-head", "table-table" or "head-table"',
                                                            '"head-head", "table-table" или "head-table"')),
    ('nct', '{"feed": -1}', 1, must_be('feed', 'a number, 0 to 1000000000 mm/min', 'число от 0 до 1000000000 мм/мин')),
    ('nct', '{"override": {"feed": "fast"}}', 1, must_be('override.feed', 'a number, 0 to 1000', 'число, от 0 до 1000')),
    ('nct', '[]', None, ("setup key 'setup' must be a table { … }", 'исходное состояние: нужна таблица { … }')),
    ('nct', '{"parameters": {"N1404": 9}}', 1, must_be('parameters.N1404', 'a whole number, 0 to 8', 'целое число, от 0 до 8')),
    ('nct', '{"parameters": {"N0306#0": 2}}', 1, must_be('parameters.N0306#0', '0 or 1', '0 или 1')),
    ('nct', '{"parameters": {"N0306#NAP": 1}}', 1, must_be('parameters.N0306#NAP', 'named by a bit that it has', 'имя с битом, который у него есть')),
    ('nct', '{"feed": 1,\n "modal": ["G999"]}', 2, ("setup key 'modal': the control nct has no 'G999'",
                                                   'ключ «modal» исходного состояния: у УЧПУ nct нет «G999»')),
    # its relatives: the other controls
    ('s2c42', '{"work_offsets": {"G54": {"X": 1}}}', 1, not_of('work_offsets', 's2c42', 'zeros')),
    ('s2c42', '{"zeros": {"10": {"X": 1}}}', 1, must_be('zeros.10', 'named by a whole number, 1 to 9', 'номер — целое число от 1 до 9')),
    ('s2c42', '{"zeros": {"1": {"x": 1}}}', 1, no_axis('zeros.1.x', 'x', 'X')),
    ('s2c42', '{"correctors": {"1": 1}}', 1, not_of('correctors', 's2c42', 'offsets')),
    ('s2c42', '{"variables": {"#100": 1}}', 1, must_be('variables.#100', 'named R0 to R9', 'имя от R0 до R9')),
    ('s2c42', '{"offsets": {"100": {"length": 1}}}', 1, must_be('offsets.100', 'named by a whole number, 1 to 99', 'номер — целое число от 1 до 99')),
    ('s2c42', '{"skip": [2]}', 1, must_be('skip', 'a list of whole numbers, 1 to 1', 'список целых чисел, от 1 до 1')),
    ('gost', '{"parameters": {"N0308": 1}}', 1, not_of('parameters', 'gost')),
    ('s2c42', '{"probe": {"1": {"X": 1}}}', 1, not_of('probe', 's2c42')),
    ('s2c42', '{"offsets": {"1": {"corner_radius": 1}}}', 1, not_of('offsets.1.corner_radius', 's2c42')),
    ('mach3', '{"work_offsets": {"G53": {"X": 1}}}', 1, ("setup key 'work_offsets.G53': no work offset 'G53'; did you mean 'G54'?",
                                                        'ключ «work_offsets.G53» исходного состояния: нет нуля детали «G53»; возможно, «G54»?')),
    ('mach3', '{"work_offsets": {"G54": {"U": 1}}}', 1, no_axis('work_offsets.G54.U', 'U', there=AXES['mach3'])),
    ('mach3', '{"work_offsets": {"G54": {"G17": 10}}}', 1, no_axis('work_offsets.G54.G17', 'G17', there=AXES['mach3'])),
    ('mach3', '{"variables": {"#20000": 1}}', 1, must_be('variables.#20000', 'named #1 to #10320', 'имя от #1 до #10320')),
    ('mach3', '{"spindle": {"2": {"rpm": 1}}}', 1, must_be('spindle.2', 'named 1', 'номер 1')),
    ('mach3', '{"spindle": {"1": {"ranges": [[1, 2]]}}}', 1, not_of('spindle.1.ranges', 'mach3')),
    ('mach3', '{"machine": {"X": {"zone3": [0, 1]}}}', 1, not_of('machine.X.zone3', 'mach3')),
    ('mach3', '{"events": []}', 1, not_of('events', 'mach3')),
    ('mach3', '{"single_block": true}', 1, not_of('single_block', 'mach3')),
    ('gost', '{"work_offsets": {"G60": {"X": 1}}}', 1, ("setup key 'work_offsets.G60': no work offset 'G60'; there are G54, G55, G56, G57, G58, G59, common",
                                                       'ключ «work_offsets.G60» исходного состояния: нет нуля детали «G60»; есть G54, G55, G56, G57, G58, G59, common')),
    ('gost', '{"variables": {"#1": 1}}', 1, not_of('variables', 'gost')),
    ('gost', '{"tool_table": {}}', 1, not_of('tool_table', 'gost')),
    ('gost', '{"clock": "2014-05-18T15:32:41"}', 1, not_of('clock', 'gost')),
    ('correctors', '{"zeros": {"1": {"X": 1}}}', 1, not_of('zeros', 'correctors')),
    ('correctors', '{"work_offsets": {"G54": {"X": 1}}}', 1, not_of('work_offsets', 'correctors')),
    ('correctors', '{"corectors": {"1": 1}}', 1, unknown('corectors', 'correctors')),
    ('correctors', '{"correctors": {"100": 1}}', 1, must_be('correctors.100', 'named by a whole number, 1 to 99', 'номер — целое число от 1 до 99')),
]

# control, options, what stderr must begin with after `kadr: `
OPTIONS = [
    ('nct', ['--zero', 'G99=X1'], '--zero G99=X1: ', ("setup key 'work_offsets.G99': no work offset 'G99'; did you mean 'G59'?", None)),
    ('nct', ['--zero', 'G54=x1'], '--zero G54=x1: ', no_axis('work_offsets.G54.x', 'x', 'X')),
    ('nct', ['--zero', '1=X1'], '--zero 1=X1: ', not_of('zeros', 'nct', 'work_offsets')),
    ('nct', ['--zero', 'G54=X1,X2'], '', ('--zero G54=X1,X2: want G54=X-400,Y-250,Z-300, or NUMBER=X… (mm, degrees; each axis once)', None)),
    ('nct', ['--zero', 'G54'], '', ('--zero G54: want G54=X-400,Y-250,Z-300, or NUMBER=X… (mm, degrees; each axis once)', None)),
    ('nct', ['--tool', '1:q8'], '', ('--tool 1:q8: want NUMBER:r8,l100 (r radius, l length, rw and lw wear, mm; '
                                     'of a turning tool x, y, z geometry, xw, yw, zw wear, t number of the tip; each once)',
                                     '--tool 1:q8: нужно НОМЕР:r8,l100 (r радиус, l вылет, rw и lw износ, мм; '
                                     'у резца x, y, z — геометрия, xw, yw, zw — износ, t — номер вершины; каждый один раз)')),
    ('nct', ['--tool', '1:r8,'], '', ('--tool 1:r8,: want NUMBER:r8,l100 (r radius, l length, rw and lw wear, mm; '
                                      'of a turning tool x, y, z geometry, xw, yw, zw wear, t number of the tip; each once)', None)),
    ('nct', ['--tool', '1:rnan'], '', ('--tool 1:rnan: want NUMBER:r8,l100 (r radius, l length, rw and lw wear, mm; '
                                       'of a turning tool x, y, z geometry, xw, yw, zw wear, t number of the tip; each once)', None)),
    ('nct', ['--tool', '1000:r8'], '--tool 1000:r8: ', must_be('offsets.1000', 'named by a whole number, 1 to 999', 'номер — целое число от 1 до 999')),
    ('nct', ['--corrector', '3=1'], '--corrector 3=1: ', not_of('correctors', 'nct', 'offsets')),
    ('correctors', ['--corrector', '3=X1'], '', ('--corrector 3=X1: want NUMBER=-0.35 (mm)', '--corrector 3=X1: нужно НОМЕР=-0.35 (мм)')),
    ('s2c42', ['--zero', 'G58=X1'], '--zero G58=X1: ', must_be('zeros.G58', 'named by a whole number, 1 to 9', 'номер — целое число от 1 до 9')),
]


def said(kadr, control, arguments, lang, folder):
    program = Path(folder, f'{control}.nc')
    program.write_text(PROGRAMS[control], encoding='utf-8')
    run = subprocess.run([kadr, 'run', program, '--control', control, '-q', '--lang', lang, *arguments], capture_output=True, text=True,
                         timeout=harness.TIME_LIMIT_S)
    return run.returncode, run.stderr


def faults_of(kadr, control, arguments, begins, texts, folder):
    for lang, text in zip(('en', 'ru'), texts):
        if text is None:
            continue
        status, stderr = said(kadr, control, arguments, lang, folder)
        if status != 2 or stderr != f'kadr: {begins}{text}\n':
            yield f'{lang}: status {status}, not 2: {stderr.strip()!r}, not {begins + text!r}'


def main():
    kadr, tally = harness.kadr_of(__doc__), harness.Tally()
    with tempfile.TemporaryDirectory() as folder:
        rows = []
        for number, (control, text, line, texts) in enumerate(FILES):
            file = Path(folder, f'{number}.json')
            file.write_text(text, encoding='utf-8')
            rows.append((control, text, ['--setup', str(file)], f'{file}:{line}: ' if line else f'{file}: ', texts))
        rows += [(control, ' '.join(options), options, begins, texts) for control, options, begins, texts in OPTIONS]
        for control, name, arguments, begins, texts in rows:
            tally.judge(f'{control} {name}', faults_of(kadr, control, arguments, begins, texts, folder))
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
