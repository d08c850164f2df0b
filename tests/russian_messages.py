#!/usr/bin/env python3
"""Tests that faults found before a program runs are reported in Russian with --lang ru: in control, machine and set-up files, called files,
files that cannot be opened, options.

    russian_messages.py --kadr build/kadr

Each input has one fault. The first line of the message must contain Russian words and no English sentence: no two Latin words in a
row, apart from names of keys, functions, files and quoted texts.
"""
import argparse
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from harness import TIME_LIMIT_S

NCT = 'extends = "nct"\nid = "own"\n'
GOST = 'extends = "gost"\nid = "own"\n'
MACH3 = 'extends = "mach3"\nid = "own"\n'
S2C42 = 'extends = "s2c42"\nid = "own"\n'
CORRECTORS = 'extends = "correctors"\nid = "own"\n'
ALONE = ('id = "own"\n[axes]\nnames = ["X", "Y", "Z"]\n[order]\nphases = ["motion", "flow"]\n[address]\n'
         'X = { does = "axis", axis = "X" }\nY = { does = "axis", axis = "Y" }\nZ = { does = "axis", axis = "Z" }\n'
         'G = { does = "code" }\nM = { does = "code" }\n')

CONTROLS = {
    'no id': 'extends = "gost"\n',
    'no such base': 'extends = "gast"\nid = "own"\n',
    'id missing': '[axes]\nnames = ["X"]\n',
    'unknown key': GOST + 'axis = 1\n',
    'unknown key far off': GOST + 'qwertyuiop = 1\n',
    'unknown behaviour': GOST + '[behaviour]\nends_readin = true\n',
    'a number for a table': GOST + 'behaviour = 1\n',
    'a table for a text': GOST + '[name]\n[spec]\n',
    'no flag': GOST + '[behaviour]\nends_reading = 1\n',
    'no whole number': GOST + '[behaviour]\ncall_depth = 1.5\n',
    'no depth': GOST + '[behaviour]\ncall_depth = 0\n',
    'no fixtures': MACH3 + '[behaviour]\nfixtures = 0\n',
    'feed out of range': GOST + '[behaviour]\nfeed_most = -1\n',
    'arc centres': GOST + '[behaviour]\narc_centers = "somewhere"\n',
    'length offset': GOST + '[behaviour]\nlength_offset = "never"\n',
    'correctors': GOST + 'dialect = "correctors"\n',
    'delayed assignment': GOST + '[behaviour]\ndelayed_assignment = true\n',
    'key of earlier versions': GOST + '[behaviour]\nsubprograms_by_section = true\n',
    'no two differences': GOST + '[behaviour]\narc_radius_difference = [1, 2, 3]\n',
    'macro': GOST + '[grammar]\nmacro = true\n',
    'machine of the nct': GOST + 'dialect = "nct"\n',
    'nct with sections': NCT + '[grammar]\nsection = "L"\n',
    'nct with correctors': NCT + 'dialect = "correctors"\n',
    'nct with reference feed': NCT + '[behaviour]\nreference_feed = 100\n',
    'nct with codes of feeds': NCT + '[feed_codes]\n12 = 100\n',
    'format': GOST + 'format = "G2 M2 X+"\n',
    'format twice': GOST + 'format = "%: N04 G2 G2 M2"\n',
    'format of a word': GOST + '[address]\nX = { format = "+0" }\n',
    'format with a sign': GOST + '[address]\nX = { format = "-043" }\n',
    'end of block': GOST + '[grammar]\nend_of_block = "star"\n',
    'long parameters': GOST + '[grammar]\nlong_parameters = "RPe"\n',
    'parameters in': GOST + '[grammar]\nparameters_in = "xyz"\n',
    'most codes': GOST + '[grammar]\nmost_codes = 3\n',
    'most codes of': GOST + '[grammar]\nmost_codes = { GM = 3 }\n',
    'letter': GOST + '[grammar]\nlabel = "OO"\n',
    'letter of another': GOST + '[grammar]\nlabel = "K"\n',
    'formal and expressions': MACH3 + '[grammar]\nformal_parameter = "R"\n',
    'percent': MACH3 + '[grammar]\nprogram_start_required = true\n',
    'percent digits': MACH3 + '[grammar]\npercent_digits = 3\n',
    'mark': MACH3 + '[grammar]\nmark_everywhere = true\nend_of_block = "line_only"\n',
    'variables alone': GOST + '[grammar]\nvariables = 100\n',
    'no axes': 'id = "own"\n[axes]\nnames = []\n',
    'axis twice': 'id = "own"\n[axes]\nnames = ["X", "X"]\n',
    'rotary': ALONE.replace('"Z"]', '"Z"]\nrotary = ["A"]', 1),
    'no order': 'id = "own"\n[axes]\nnames = ["X"]\n',
    'unknown phase': GOST + '[order]\nphases = ["mation"]\n',
    'phase twice': GOST + '[order]\nphases = ["motion", "motion"]\n',
    'no addresses': 'id = "own"\n[axes]\nnames = ["X"]\n[order]\nphases = ["motion"]\n',
    'no letter': GOST + '[address]\nXY = { does = "axis" }\n',
    'no such axis': ALONE + 'U = { does = "axis", axis = "U" }\n',
    'unit': ALONE + 'U = { does = "word_of_code", unit = "inch" }\n',
    'does is missing': ALONE + 'U = { unit = "length" }\n',
    'unknown function': ALONE + 'F = { does = "fead_word" }\n',
    'function of a code': ALONE + 'U = { does = "rapid" }\n',
    'function of a word': ALONE + '[g]\n0 = { does = "axis" }\n',
    'function of the nct': ALONE + '[g]\n0 = { does = "radius_side" }\n',
    'function without the nct': NCT + '[g]\n77 = { does = "plane_xy" }\n',
    'another letter': ALONE + 'U = { does = "feed_word" }\n',
    'axis is missing': ALONE + 'U = { does = "axis" }\n',
    'axis without effect': ALONE + 'F = { does = "feed_word", axis = "X" }\n',
    'axis has its word': ALONE + 'U = { does = "axis", axis = "X" }\n',
    'phase without effect': ALONE + 'U = { does = "word_of_code", phase = "motion" }\n',
    'second': ALONE + 'U = { does = "word_of_code", second = true }\n',
    'scale': ALONE + 'U = { does = "word_of_code", scale = 0 }\n',
    'least above most': ALONE + 'U = { does = "word_of_code", least = 3, most = 2 }\n',
    'group is no table': GOST + '[groups]\nmotion = 1\n',
    'no such group': ALONE + '[g]\n0 = { does = "rapid", group = "mation" }\n',
    'letters': ALONE + '[g]\n0 = { does = "rapid", takes = "xy" }\n',
    'code is no table': GOST + '[g]\n0 = 1\n',
    'code is no number': GOST + '[g]\nX = { does = "rapid" }\n',
    'from of a code': GOST + '[g]\n0 = { does = "rapid", from = 1 }\n',
    'with': GOST + '[m]\n7 = { does = "coolant_flood", with = ["G8"] }\n',
    'takes no address': ALONE + '[g]\n0 = { does = "rapid", takes = "W" }\n',
    'needs no address': ALONE + '[g]\n0 = { does = "rapid", needs = "W" }\n',
    'no cycle': GOST + '[g]\n81 = { does = "cycle" }\n',
    'code twice': GOST + '[g]\n"0.0" = { does = "rapid" }\n"00" = { does = "rapid" }\n',
    'other of G': GOST + '[g]\nother = { does = "machine_function" }\n',
    'other does': GOST + '[m]\nother = { does = "rapid" }\n',
    'from above to': GOST + '[m]\nother = { does = "machine_function", from = 9, to = 3 }\n',
    'arg': GOST + '[g]\n0 = { does = "rapid", arg = 3 }\n',
    'arg out of range': S2C42 + '[g]\n54 = { does = "work_zero", arg = 77 }\n',
    'initial': GOST + '[groups]\nmotion = { initial = "G17" }\n',
    'end unknown': GOST + '[defaults]\nend = ["G777"]\n',
    'end is no mode': GOST + '[defaults]\nend = ["M30"]\n',
    'alarm': GOST + '[alarms]\nfeed_mising = { en = "x" }\n',
    'feed code': GOST + '[feed_codes]\nF1 = 100\n',
    'cycle is no table': MACH3 + '[cycle]\nG81 = 1\n',
    'cycle has no name': MACH3 + '[cycle]\nX = { steps = ["retract"], needs = "ZR" }\n',
    'step': MACH3 + '[cycle]\nG81 = { steps = ["jump"], needs = "ZR" }\n',
    'cycle with both': MACH3 + '[cycle]\nG81 = { steps = ["retract"], body = ["G0"], needs = "ZR" }\n',
    'cycle without Z': MACH3 + '[cycle]\nG81 = { steps = ["retract"], needs = "R" }\n',
    'peck without Q': MACH3 + '[cycle]\nG83 = { steps = ["peck_full"], needs = "ZR" }\n',
    'called without L number': S2C42 + '[cycle]\nL0 = { body = ["G0"] }\n',
    'called without sections': GOST + '[cycle]\nL81 = { body = ["G0"] }\n',
    'passes of a cycle': MACH3 + '[cycle]\nG83 = { steps = ["passes_by_parameter"], needs = "ZR" }\n',
    'parameters of a cycle': CORRECTORS + '[cycle]\nG81 = { body = ["X+R01"], parameters = { X = "Q1" } }\n',
    'body of a cycle': MACH3 + '[cycle]\nG81 = { body = ["G0 X1"] }\n',
    'variable is no table': MACH3 + 'variables = [1]\n',
    'variable of no kind': MACH3 + '[[variables]]\nis = "hame"\nfrom = 5161\ncount = 6\n',
    'variable of the nct': MACH3 + '[[variables]]\nis = "clock"\nfrom = 5161\ncount = 6\n',
    'variable counts': MACH3 + '[[variables]]\nis = "home"\nfrom = 5161\ncount = 3\n',
    'variable below': MACH3 + '[[variables]]\nis = "home"\nfrom = 5\ncount = 6\n',
    'variable beyond': MACH3 + '[[variables]]\nis = "home"\nfrom = 99990\ncount = 6\n',
    'ranges': MACH3 + '[[variables]]\nis = "home"\nranges = 3\n',
    'range': MACH3 + '[[variables]]\nis = "home"\nranges = [[1]]\n',
    'access': MACH3 + '[[variables]]\nis = "home"\nfrom = 5161\ncount = 6\naccess = "X"\n',
    'symbol': MACH3 + '[[variables]]\nis = "home"\nfrom = 5161\ncount = 6\nsymbol = "#x"\n',
    'parameters': NCT + 'parameters = "own"\n',
    'TOML: no value': GOST + 'x =\n',
    'TOML: an open string': GOST + 'x = "a\n',
    'TOML: an open list': GOST + 'x = [1, 2\n',
    'TOML: twice': GOST + 'id = "b"\n',
    'TOML: a heading': GOST + '[axes\n',
    'TOML: no UTF-8': GOST.encode() + b'x = "\xff"\n',
    'UTF-16': GOST.encode('utf-16'),
    'a NUL byte': GOST.encode() + b'\0',
    'empty': '',
}
MACHINES = {
    'unknown key': '[axis]\nX = { rapid = 1 }\n',
    'no limits': '[axes]\nX = { limits = [1] }\n',
    'wrong rate': '[axes]\nX = { rapid = -5 }\n',
    'axis is no table': '[axes]\nX = 3\n',
    'no TOML': 'axes\n',
}
SETUPS = {
    'no JSON': '{"tool": 1,,}',
    'unknown key': '{"toll": 1}',
    'a text for a number': '{"tool": "one"}',
    'open': '{"tool": 1',
    'axes': '{"axes": ["Q"]}',
    'an axis twice': '{"axes": ["X", "X"]}',
    'channels': '{"channels": {"2": {"program": "M30"}}}',
    'events': '{"events": [{"from": {"code": "M77"}, "input": 3}]}',
    'a list': '[1]',
    'no UTF-8': b'{"tool": "\xff"}',
}


class Runs:
    def __init__(self, kadr, folder):
        self.kadr, self.folder, self.passed, self.failed, self.fine = kadr, folder, 0, 0, []

    def say(self, what, args, stdin=b''):
        done = subprocess.run([self.kadr, *args, '--lang', 'ru'], cwd=self.folder, input=stdin, capture_output=True, timeout=TIME_LIMIT_S,
                              check=False)
        text = done.stderr.decode('utf-8', 'replace') + (done.stdout.decode('utf-8', 'replace') if done.returncode == 1 else '')
        lines = [line for line in text.splitlines() if line.strip() and 'похоже на' not in line]
        if done.returncode == 0 or not lines:
            self.fine.append(what)
            self.failed += 1
            print(f'{what}: status {done.returncode}, nothing is said')
            return
        bare = re.sub(r'«[^»]*»|"[^"]*"|\'[^\']*\'|`[^`]*`|\[[^\]]*\]|\{[^}]*\}|\S*[/.]\S+|--\S+|\b\w*_\w*\b', '#', lines[0])
        english = re.search(r'\b[A-Za-z]{2,} +[A-Za-z]{2,}\b', bare)
        if english or not re.search('[а-я]{3}', bare):
            self.failed += 1
            print(f'{what}: {lines[0]}')
            return
        self.passed += 1

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode('utf-8'))
        return name


def config_files(runs):
    runs.write('p.nc', 'G0 X1\nM30\n')
    for name, text in CONTROLS.items():
        runs.say(f'control, {name}', ['run', 'p.nc', '--control', './' + runs.write('own.toml', text)])
    for name, text in MACHINES.items():
        runs.say(f'machine, {name}', ['run', 'p.nc', '--control', 'mach3', '--machine', './' + runs.write('own.toml', text)])
    for name, text in SETUPS.items():
        control = 'mach3' if name == 'channels' else 'nct'
        runs.say(f'set-up, {name}', ['run', 'p.nc', '--control', control, '--setup', runs.write('s.json', text)])


def files(runs):
    """Files that do not exist, are folders, or may not be read; called files that may not be read."""
    (runs.folder / 'folder').mkdir()
    for what in ('none.nc', 'folder', 'p.nc/none.nc', 'x' * 300 + '.nc'):
        runs.say(f'program {what[:20]}', ['run', what, '--control', 'mach3'])
        runs.say(f'guessed {what[:20]}', ['run', what])
        runs.say(f'set-up {what[:20]}', ['run', 'p.nc', '--control', 'mach3', '--setup', what])
        runs.say(f'control {what[:20]}', ['run', 'p.nc', '--control', './' + what + '.toml'])
        runs.say(f'tape {what[:20]}', ['tape', 'encode', what])
        runs.say(f'contour {what[:20]}', ['mill', 'pocket', what, '--control', 'mach3', '--tool-diameter', '8', '--depth', '1'])
    runs.say('trace into a folder', ['run', 'p.nc', '--control', 'mach3', '--trace', 'folder'])
    runs.say('trace below nothing', ['run', 'p.nc', '--control', 'mach3', '--trace', 'none/t.json'])
    runs.say('plot', ['run', 'p.nc', '--control', 'mach3', '--plot', 'p.txt'])
    runs.say('encoding', ['run', 'p.nc', '--control', 'mach3', '--encoding', 'utf-17'])
    runs.say('no control', ['run', 'p.nc', '--control', 'mack3'])
    runs.say('no machine', ['run', 'p.nc', '--control', 'mach3', '--machine', 'none'])
    runs.say('no programs', ['check', 'folder'])
    runs.say('baseline', ['check', 'p.nc', '--control', 'mach3', '--baseline', runs.write('b.json', '3')])
    runs.say('setup over a file', ['setup', 'p.nc', '--control', 'mach3', '--out', 'p.nc'])
    for call in ('M98 P77', 'M98 <../../etc/passwd>', 'M98 </dev/zero>', 'M98 <folder>', 'G65 P8', 'G65 <none.nct>'):
        runs.write('c.nct', f'{call}\nM30\n')
        runs.say(call, ['run', 'c.nct', '--control', 'nct'])
    if os.geteuid() != 0:
        (runs.folder / 'p.nc').chmod(0)
        runs.say('no right', ['run', 'p.nc', '--control', 'mach3'])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--kadr', required=True)
    kadr = Path(parser.parse_args().kadr).resolve()
    with tempfile.TemporaryDirectory(prefix='kadr-russian-') as folder:
        runs = Runs(kadr, Path(folder))
        config_files(runs)
        files(runs)
    print(f'{runs.passed} passed, {runs.failed} failed')
    return 1 if runs.failed else 0


if __name__ == '__main__':
    sys.exit(main())
