#!/usr/bin/env python3
"""Checks that the notes of a control list, with the reason, what it inherits from the control that it extends: each key of [behaviour] that
its file does not set itself is named there, and no other. A parameter of one control must not decide for another. The description of a
control names neither the control at the root of the chain nor its parameters.

    inherited.py --kadr PROGRAM
"""
import re
import subprocess
import tomllib

import harness

CONTROLS = harness.ROOT / 'controls'
HEADING = '## Taken over from '


def behaviour_of(control, over=''):
    """Returns the [behaviour] keys of the control and those it extends, with the control that sets each last. `over`: the control in place of
    the one that it extends."""
    table = tomllib.loads((CONTROLS / f'{control}.toml').read_text(encoding='utf-8'))
    base = over or table.get('extends', '')
    base_over, base = base if isinstance(base, list) else ('', base)
    keys = behaviour_of(base, base_over) if base else {}
    return {**keys, **dict.fromkeys(table.get('behaviour', {}), control)}


def named_in(notes):
    """Returns the keys in the first column of the section's table; None if the section is missing."""
    text = notes.read_text(encoding='utf-8')
    if HEADING not in text:
        return None
    section = text.split(HEADING, 1)[1].split('\n## ', 1)[0]
    return {key for row in re.findall(r'^\| (`[^|]*) \|', section, re.MULTILINE) for key in re.findall(r'`(\w+)`', row)}


def faults_of(control):
    taken_over = {key for key, by in behaviour_of(control).items() if by != control}
    named = named_in(harness.ROOT / 'docs' / 'controls' / f'{control}-notes.md')
    if named is None:
        return [f'{control}: its notes have no section "{HEADING}…"']
    return [f'{control}: {key} is taken over, and its notes do not say why' for key in sorted(taken_over - named)] + \
           [f'{control}: its notes name {key}, which is not taken over' for key in sorted(named - taken_over)]


def parameters_of(name):
    """Returns the names of the parameters of a table of controls/, with those of the table that it extends."""
    table = tomllib.loads((CONTROLS / f'{name}.toml').read_text(encoding='utf-8'))
    inherited = parameters_of(table['extends']) if 'extends' in table else set()
    return inherited - {key for key, row in table.items() if row is False} | {key for key, row in table.items() if isinstance(row, dict)}


def strangers_in(kadr, control, table):
    """Returns what `kadr explain` and the documentation page say about the root control, or about parameters that this control does not
    have."""
    root = control
    while 'extends' in (under := tomllib.loads((CONTROLS / f'{root}.toml').read_text(encoding='utf-8'))):
        root = under['extends'] if isinstance(under['extends'], str) else under['extends'][0]
    numbers = {f'N{int(number):04}' for number in parameters_of(table['parameters']) if number.isdigit()}
    for options in ([], ['--markdown']):
        text = subprocess.run([kadr, 'explain', control, *options], capture_output=True, text=True, check=True).stdout
        yield from sorted(set(re.findall(rf'(?i)\b{root}\b', text)) | set(re.findall(r'\bN[0-9]{4}\b', text)) - numbers)


def main():
    kadr = harness.kadr_of(__doc__)
    tables = {path.stem: tomllib.loads(path.read_text(encoding='utf-8')) for path in CONTROLS.glob('*.toml')}
    extending = sorted(control for control, table in tables.items() if 'extends' in table)
    faults = [fault for control in extending for fault in faults_of(control)]
    faults += [f'{control}: {word} stands in what is told of it' for control in extending if 'parameters' in tables[control]
               for word in strangers_in(kadr, control, tables[control])]
    for fault in faults:
        print(f'FAIL {fault}')
    print(f'{len(extending)} passed, {len(faults)} failed')
    return 1 if faults or not extending else 0


if __name__ == '__main__':
    raise SystemExit(main())
