#!/usr/bin/env python3
"""Tests which control `kadr check` guesses when none is named: what decides, what is weak evidence, what the programs of a folder share.

    guess.py --kadr build/kadr

tests/guess_cases has programs in languages that Kadr does not support. The programs of CASES and FOLDERS are written out here; each
represents a section of its control's spec. Exit status: 0 all passed, 1 some failed.
"""
import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

from harness import TIME_LIMIT_S

HERE = Path(__file__).resolve().parent
FACTORY = '''extends = "gost"
id = "factory"
name = { en = "Shop 7", ru = "Цех 7" }
[guess]
'M51' = 14
'''

# A program and the expected message.
CASES = [
    ('N10 G54\nM97 P10\nM30\n', 'looks like haas (line 2: M97P'),
    ('%\nO00030\nG154 P3\nG0 X0. Y0.\nM30\n%\n', 'looks like haas (line 2: O00030, line 3: G154P'),
    ('G90\nG187 P1 E0.01\nG1 X5. F100.\n', 'looks like haas (line 2: G187'),
    ('#1=5\nWH[#1GT0]DO1\n#1=#1-1\nEND1\nM30\n', 'looks like fanuc (line 1: #1, line 2: WH['),
    ('M29 S500\nG84 Z-8. R2. F500\n', 'looks like fanuc (line 1: M29S'),
    ('G90 G1 XI-40 F100\n', 'looks like nct (line 1: XI-40'),
    ('#101=#100*COS#102\nG1 X#101 F100\nM30\n', 'looks like nct (line 1: COS#'),
    ('IF[#1EQ0]GOTO5\n#3106=12(WAIT)\nN5 M30\n', 'looks like nct (line 1: GOTO5, line 1: #1, line 2: #3106='),
    ('#103=AXNUM[Z]\nG0 AX[#103]=10\n', 'looks like nct (line 1: AXNUM['),
    ('#1=2\nWHILE[#1GT0]DO1\nG1 X40 Y30 F1000\n#1=#1-1\nEND1\nIF[#1EQ0]GOTO9\nN9 M30\n', 'perhaps nct: a weak guess'),
    ('#1=2\nWHILE[#1GT0]DO1\nG1 X40. Y30. F1000\n#1=#1-1\nEND1\nIF[#1EQ0]GOTO9\nN9 M30\n', 'perhaps fanuc: a weak guess'),
    ('G0 X10 Y5\nG1 Z-2 F100\nM30\n', 'perhaps grbl: a weak guess, nothing decides (no tools, no %); next comes mach3'),
    ('#1=SIN[30]\nWHILE[#1 GT 0]DO1\n#1=#1-1\nEND1\nM30\n', 'perhaps fanuc: a weak guess'),
    ('o100 while [#1 lt 5]\nG1 X#1\no100 endwhile\n', 'looks like linuxcnc (line 1: O100WHILE'),
    ('#<noexist> = 1\no<gotofoo> call [1]\nM2\n', 'looks like linuxcnc (line 1: #<'),
    ('(debug, here)\nG0 X1\n', 'looks like linuxcnc (line 1: (DEBUG,'),
    ('$H\nG21 G90\nG1 X10 F500\n', 'looks like grbl (line 1: $H'),
    ('G21\n$J=G91 X10 F100\n', 'looks like grbl (line 1: G21, line 2: $J='),
    ('% ПС\nN1 G0 X8000 ПС\nN2 M2 ПС\n', 'looks like s2c42 (line 1: ПС'),
    ('% LF\nN001 G91 Z-50. L4 04 LF\nN002 M02 LF\n', 'looks like correctors (line 2: L4 0'),
    ('%012 LF\n:1 G90 G00 X10. LF\nN2 M02 LF\n', 'perhaps gost: a weak guess, nothing decides'),
    ('G0 X1.5\nG1 Z-2 F100\nM30\n', 'perhaps mach3: a weak guess, nothing decides'),
    ('', 'perhaps mach3: a weak guess, nothing decides (the text tells little)'),
    ('%\nO0012\nG18 G20 G40 G99\nT0101\nG50 S2500\nG96 S600 M03\nG00 X2.1 Z.1\nG71 U.08 R.02\nG71 P1 Q2 U.02 W.005 F.012\nN1 G00 X1.\nN2 G01 Z-1.\nM30\n%\n',
     'looks like fanuc-t (line 4: T0101, line 5: G50S2500, line 8: G71U.08R'),
    ('(T0404 - 3/4 BORING BAR)\nT0404\nG50 S900\nG96 S400 M03\nG00 X1.2 Z.1\nG01 Z-1.5 F.006\nU-.02\nG00 Z.5\nM30\n', 'fanuc-t'),
    ('O0044(PART OFF)\nT0606\nG97 S900 M03\nG99\nG00 X32. Z-25.\nG75 R0.2\nG75 X0 P2000 F0.05\nG00 X60.\nG28 U0 W0\nM30\n', 'looks like fanuc-t'),
    ('O9010(BAR PULLER)\nT1010\nG98\nG00 X0 Z5.\nG01 Z-15. F500.\nM11\nG04 U1.5\nG01 W40. F1000.\nM10\nG99\nG28 U0\nM99\n', 'fanuc-t'),
    ('%\nO0050\n#501=0\nT0202\nG97 S1200 M03\nG99\nWHILE [#501 LT 4] DO1\n#501=#501+1\nG00 X[20-#501*2] Z2.\nG01 Z-20. F0.15\nG00 U2. Z2.\nEND1\n'
     'G28 U0 W0\nM30\n%\n', 'fanuc-t'),
    ('%\nO00071\nT1 M06\nG00 G90 G54 X0. Y0. S1500 M03\nG43 H01 Z0.1\nG81 G98 Z-0.5 R0.1 F8. L0\nG70 I2. J15. L6\nG80\nM30\n%\n', 'looks like haas ('),
    ('%\nO0500\nG90 G54 G0 X0. Y0.\nG43 H1 Z25.\nG1 U5. W-2. F200.\nX10.\nM30\n%\n', 'perhaps fanuc: a weak guess'),
    ('G21 G18 G7\nG95 G96 D2500 S180 M3\nT1 M6 G43\nG0 X42 Z2\nG76 P1.5 Z-20 I-1 J0.2 K0.92 Q29.5 H2 E0.5 L2\nM5\nM2\n', 'looks like linuxcnc'),
    ('(Mach3Turn post)\nG18 G21 G40 G80 G90 G94\nT0101\nM3 S900\nG0 X40 Z2\nG76 X18.2 Z-20 Q1 P1.5 H0.2 I29 R20 K2 L45 C2\nM30\n', 'looks like mach3'),
    ('%O0305\nN1 G54 G95 T0101\nN2 G96 S150 M3\nN3 G0 X50 Z2\nN4 G71.7 U2 R1\nN5 G71.7 P10 Q20 U0.4 W0.1 F0.2\nN10 G0 X20\nN20 G1 Z-30\nN21 M30\n',
     'looks like nct'),
    ('%012 LF\nN001 G96 S100 T0101 M03 LF\nN002 G00 X+40. Z+2. LF\nN003 G33 Z-20. K1.5 LF\nN005 M02 LF\n', 'perhaps gost: a weak guess'),
    ('R1=0\nLOOP:\nR1=R1+1\nG1 X=R1 F200\nIF R1<5 GOTOB LOOP\nM2\n', 'looks like sinumerik (line 1: R1='),
    ('N10 G18 G71 G95\nN20 DIAMON\nN30 LIMS=2500\nN40 T1 D1\nN50 G96 S180 M3\nN60 G0 X52 Z2\nN70 G1 X48 F0.2\nN80 Z-30\nN90 M30\n',
     'looks like sinumerik (line 2: DIAMON'),
    ('; plate, side 1\nN10 G17 G54 G71 G90\nN20 T="MILL12"\nN30 M6\nN40 S2500 M3\nN50 G0 X=R1 Y0 Z5\nN60 CYCLE81(5,0,2,-12)\nN70 G2 X20 Y0 CR=10\nN80 M30\n',
     'looks like sinumerik (line 3: T="'),
    ('0 BEGIN PGM PART MM\n1 TOOL CALL 5 Z S2000\n2 L X+10 Y+5 R0 FMAX\n3 END PGM PART MM\n', 'looks like heidenhain (line 1: BEGINPGM'),
    ('7 L X+20 Y+5\n8 L X+30\n9 CC X+0 Y+0\n', 'looks like heidenhain (line 1: LX+20'),
    ('%\nO0001\nN10 G0 X1.\n#1=5\nWHILE [#1 GT 0] DO1\n#1=#1-1\nEND1\nM30\n%\n', 'perhaps fanuc: a weak guess'),
]

# Programs of a folder, some in subfolders; the expected message of each.
FOLDERS = [
    ({'a.nc': 'G154 P3\nG0 X0.\n', 'b.nc': 'G0 X1.5\nG1 Z-2 F100\n', 'sub/c.nc': 'G0 X2.5\n'},
     {'a.nc': 'looks like haas', 'b.nc': 'perhaps haas, as a.nc is (line 1: G154P', 'sub/c.nc': 'perhaps haas, as a.nc is'}),
    ({'a.nc': 'G154 P3\nG0 X0.\n', 'b.nc': '$H\nG0 X1\n', 'c.nc': 'G0 X1.5\nG1 Z-2 F100\n'},
     {'a.nc': 'looks like haas', 'b.nc': 'looks like grbl', 'c.nc': 'perhaps mach3: a weak guess'}),
    ({'a.nc': '#1=5\nWHILE[#1 GT 0]DO1\n#1=#1-1\nEND1\nIF[#1 EQ 0] GOTO 5\nN5 M30\n', 'b.nc': 'G0 X1.\nG1 X2. F100.\nM30\n'},
     {'a.nc': 'perhaps fanuc: a weak guess', 'b.nc': 'perhaps fanuc, like its folder as a whole: a weak guess'}),
    ({'factory.toml': FACTORY, 'a.nc': '%\nN1 G01 X10. F100 M51\nN2 M02\n', 'b.nc': '%\nN1 G00 X5.\nN2 M02\n'},
     {'a.nc': 'looks like factory.toml (line 2: M51', 'b.nc': 'perhaps factory.toml, as a.nc is (line 2: M51'}),
]

LATHE = '%\nO0001\nG21 G40 G99\nT0101\nG97 S1000 M03\nG00 X40. Z2.\nG01 Z-20. F0.2\nX44.\nG00 X100. Z50.\nM30\n%\n'
ROUGH = """%
O0012(SHAFT)
G18 G21 G40 G80 G99
T0101
G50 S2500
G96 S180 M03
G00 X52. Z2. M08
G71 U2. R0.5
G71 P100 Q110 U0.4 W0.1 F0.25
N100 G00 X20.
G01 Z-20.
X30. Z-40.
N110 X52.
G70 P100 Q110 F0.1
G28 U0 W0
M30
%
"""
DENFORD = '[BILLET X50 Z60\nO0002\nG21 G99\nT0101 M06\nG97 S1000 M03\nG00 X52 Z1\nM30\n'
SYSTEM_B = """%
O0040
G21 G90 G95
T0101 M41
G92 S2000
G96 S150 M03
G00 X50. Z2.
G77 X45. Z-30. F0.2
X40.
G00 X60. Z5.
G91 G28 X0 Z0
M30
%
"""
MILL = 'G21\nG90 G54\nG0 X10. Y5. Z5.\nG1 Z-1. F100.\nX20.\nM30\n'

# Files, arguments of `kadr check`, its exit status, what the output must and must not contain.
COMMANDS = [
    # a lathe program is no milling program, even if --control says so; the message names the control for it, which is also the guess; a
    # user's own control is accepted as named
    ({'a.nc': LATHE}, ['a.nc'], 0, 'fanuc-t', 'refused'),
    ({'a.nc': LATHE}, ['a.nc', '--control', 'fanuc-t'], 0, '1 program checked: 0 errors', 'unknown'),
    ({'a.nc': LATHE}, ['a.nc', '--control', 'fanuc'], 2, "a lathe's program, line 3: G99, line 4: T0101, line 5: G97, no Y; of fanuc Kadr reads milling", 'errors'),
    ({'a.nc': LATHE}, ['a.nc', '--control', 'HAAS-VF'], 2, 'of haas Kadr reads milling programs alone, turning is read by fanuc-t', 'errors'),
    ({'.kadr.toml': 'control = "fanuc"\n', 'a.nc': LATHE}, ['a.nc'], 2, 'of fanuc Kadr reads milling programs alone', 'errors'),
    ({'a.nc': LATHE}, ['a.nc', '--control', 'haas'], 2, 'of haas Kadr reads milling programs alone', 'errors'),
    ({'a.nc': LATHE}, ['a.nc', '--control', 'fanuc', '--lang', 'ru'], 2, 'программа токарного станка, строка 3: G99', 'Ошибок'),
    ({'a.nc': LATHE, 'mine.toml': 'extends = "fanuc"\nid = "mine"\nname = { en = "Mine", ru = "Мой" }\n'}, ['a.nc', '--control', 'mine.toml'], 0,
     '1 program checked', "lathe's"),
    # a folder without anything that Kadr reads; a mill program next to a lathe program, a lathe of another language next to it
    ({'a.nc': DENFORD, 'b.nc': DENFORD}, ['.'], 2, 'Denford', 'errors'),
    ({'a.nc': DENFORD, 'b.nc': '%\nO00012\nG53 Z0.\nG0 X1. Y1.\nM30\n%\n'}, ['.'], 0, '1 program checked', None),
    ({'a.nc': ROUGH, 'b.nc': '%\nO00012\nG53 Z0.\nG0 X1. Y1.\nM30\n%\n'}, ['.'], 0, '2 programs checked', "lathe's"),
    # a subprogram without evidence of its own stays with the lathe programs of its folder
    ({'a.nc': ROUGH, 'b.nc': 'O9020\nG0 X5. Z1.\nM99\n'}, ['b.nc', '--max-blocks', '20'], 0, 'perhaps fanuc-t, as a.nc is', 'unknown'),
    # G-code systems: the systems B and C are controls of their own; without evidence of a system, A
    ({'a.nc': SYSTEM_B}, ['a.nc'], 0, 'looks like fanuc-t-b', 'alarm'),
    # a factory's own control that extends a lathe's control
    ({'a.nc': LATHE.replace('M30', 'M51\nM30'), 'shop.toml': FACTORY.replace('gost', 'fanuc-t')}, ['a.nc'], None, 'looks like shop.toml', None),
    # .kadr.toml: in the folder, in one above; patterns; --control has priority over it; faults in it
    ({'.kadr.toml': 'control = "grbl"\n', 'a.nc': MILL}, ['a.nc'], 0, '1 program checked', 'perhaps'),
    ({'.kadr.toml': 'control = "grbl"\n', 'b/c/a.nc': MILL}, ['b/c/a.nc'], 0, '1 program checked', 'unknown'),
    ({'.kadr.toml': 'control = "grbl"\n[control_for]\n"*.nct" = "nct"\n', 'a.nct': 'G54.1 P1\nM30\n'}, ['a.nct'], 0, '1 program checked', 'looks'),
    ({'.kadr.toml': 'control = "grbl"\n', 'a.nc': 'G54.1 P1\nM30\n'}, ['a.nc', '--control', 'fanuc'], 0, '1 program checked', 'perhaps'),
    ({'.kadr.toml': 'control = "mine.toml"\n', 'mine.toml': 'extends = "fanuc"\nid = "mine"\nname = { en = "Mine", ru = "Мой" }\n', 'a.nc': MILL},
     ['a.nc'], 0, '1 program checked', 'perhaps'),
    ({'.kadr.toml': 'controll = "grbl"\n', 'a.nc': MILL}, ['a.nc'], 0, ".kadr.toml:1: 'control', a text, and [control_for]", None),
    ({'.kadr.toml': 'control = "nosuch"\n', 'a.nc': MILL}, ['a.nc'], 2, "no control 'nosuch'", 'checked'),
    # nothing decides: the control that reads it without a fault is preferred to those that do not have G12.1
    ({'a.nc': 'G0 X10 Z5\nG12.1\nG1 X20 C5 F100\nG13.1\nM30\n'}, ['a.nc'], 1, 'perhaps nct: a weak guess', None),
    # a second file of the folder is read as evidence, though the command does not name it
    ({'a.nc': 'G154 P3\nG0 X0.\n', 'b.nc': 'G0 X1.5\nG1 Z-2. F100.\n'}, ['b.nc'], 0, 'perhaps haas, as a.nc is (line 1: G154P', None),
    ({'a.nc': '%00000\nN0 T1.1\nN1 M6\n', 'b.nc': '%00001\nN0 T2.2\nN1 M6\n', 'c.nc': 'N1 G0 X5 Y5\n'}, ['c.nc'], 2, 'Fagor, line 1: %00000, line 2: T1.1, as in a.nc', None),
]

# A file of tests/guess_cases and the expected message.
UNKNOWN = {
    'denford.txt': 'Denford (lathes for schools), line 1: [BILLET',
    'okuma.min.txt': 'Okuma, line 2: G15H1', 'okuma-call.txt': 'Okuma, line 2: MODIN', 'sheet.txt': 'few lines are blocks',
}


def said(kadr, folder, *names):
    """Returns {file: the message about it}."""
    done = subprocess.run([kadr, 'check', *names, '--lang', 'en', '--max-blocks', '100'], cwd=folder, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=TIME_LIMIT_S)
    lines = [line.removeprefix('kadr: ').replace('./', '') for line in done.stderr.splitlines()]
    return {line.split(': ')[0]: line for line in lines if line.endswith('--control')}


def laid_out(folder, files):
    for file, text in files.items():
        (folder / file).parent.mkdir(parents=True, exist_ok=True)
        (folder / file).write_text(text)


def checked(kadr, folder, *arguments):
    """Returns the exit status and all output."""
    done = subprocess.run([kadr, 'check', *(() if '--lang' in arguments else ('--lang', 'en')), *arguments], cwd=folder, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=TIME_LIMIT_S)
    return done.returncode, done.stdout + done.stderr.replace('./', '')


def remembering(kadr, folder):
    """Yields (what, got, expected): what --remember writes, and that nothing is written without it."""
    laid_out(folder, {'a.nc': MILL, 'sub/b.nc': MILL, 'sub/mine.toml': 'extends = "fanuc"\nid = "mine"\nname = { en = "Mine", ru = "Мой" }\n'})
    memory = folder / '.kadr.toml'
    checked(kadr, folder, 'a.nc', '--control', 'haas')
    yield 'nothing is written unasked', str(memory.exists()), 'False'
    checked(kadr, folder, 'a.nc', '--control', 'haas', '--remember')
    yield '--remember', memory.read_text(), 'control = "haas"\n'
    memory.write_text('# ours\ncontrol = "haas"  # since May\n[control_for]\n"*.ngc" = "linuxcnc"\n')
    checked(kadr, folder, 'a.nc', '--control', 'grbl', '--remember')
    yield 'other lines stay', memory.read_text(), '# ours\ncontrol = "grbl"\n[control_for]\n"*.ngc" = "linuxcnc"\n'
    checked(kadr, folder, 'sub/b.nc', '--control', 'sub/mine.toml', '--remember')
    yield 'a control of one\'s own', (folder / 'sub/.kadr.toml').read_text(), 'control = "mine.toml"\n'
    yield 'and it is found again', checked(kadr, folder, 'sub/b.nc')[1], '1 program checked: 0 errors'
    yield 'without --control', checked(kadr, folder, 'a.nc', '--remember')[1], '--remember: --control says what'


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--kadr', required=True)
    kadr = str(Path(parser.parse_args().kadr).resolve())
    passed, failed = 0, 0

    def judge(name, text, expected):
        nonlocal passed, failed
        if expected in (text or ''):
            passed += 1
        else:
            failed += 1
            print(f'FAIL {name}: {text!r}, expected {expected!r}')

    with tempfile.TemporaryDirectory() as name:
        for n, (program, expected) in enumerate(CASES):
            folder = Path(name, f'case{n}')
            folder.mkdir()
            (folder / 'a.nc').write_text(program)
            judge(f'case {n} {program!r}', said(kadr, folder, 'a.nc').get('a.nc'), expected)
        for n, (files, expected) in enumerate(FOLDERS):
            folder = Path(name, f'folder{n}')
            laid_out(folder, files)
            found = said(kadr, folder, '.')
            for file, what in expected.items():
                judge(f'folder {n} {file}', found.get(file), what)
        for n, (files, arguments, status, expected, unexpected) in enumerate(COMMANDS):
            folder = Path(name, f'command{n}')
            laid_out(folder, files)
            code, text = checked(kadr, folder, *arguments)
            judge(f'command {n} {arguments}', text, expected)
            if status is not None:
                judge(f'command {n} {arguments}: its status', str(code), str(status))
            if unexpected:
                judge(f'command {n} {arguments}: {unexpected}', 'is not there' if unexpected not in text else text, 'is not there')
        for what, text, expected in remembering(kadr, Path(name, 'remember')):
            judge(what, text, expected)
    for file, expected in UNKNOWN.items():
        judge(file, said(kadr, HERE / 'guess_cases', file).get(file), f'no program of a control that Kadr knows ({expected}')
    listed = set(UNKNOWN)
    for file in sorted(path.name for path in (HERE / 'guess_cases').iterdir()):
        if file not in listed:
            judge(file, None, 'a row of UNKNOWN')
    print(f'{passed} passed, {failed} failed')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
