#!/usr/bin/env python3
"""Tests `kadr edit`: the text that each edit writes, what it refuses, and that nothing but what was asked for has changed.

    edit.py --kadr build/kadr [--every N]

The cases state the new program as a person would write it. The properties run over every example program: its words are read by a reader of
this file's own, so that they do not share an assumption with the editor. Prints a line per failure, then `N passed, N failed`.
"""
import random
import re
import sys
import tempfile
from pathlib import Path

import harness
from harness import ROOT, Tally

MILL = '%\nO0001 (PLATE)\nG21 G90 G17 G40 G49 G80\nT1 M6\nS2000 M3\nG54 G0 X0 Y0\nG43 H1 Z50.\n'
END = 'G0 Z100.\nM30\n%\n'

PART = ('%\nO1\nG21 G90 G17 G40 G49 G80\nT1 M6\nS2000 M3\nG54 G0 X-20. Y-20.\nG43 H1 Z50.\nG1 Z-5. F100.\nG41 D1 X0 Y-10.\nY20.\nG2 X10. Y30. I10. J0\n'
        'G1 X40.\nY0\nG91 X-45.\nG90 G40 X-20. Y-20.\nG0 Z50.\nG98 G81 X5. Y5. Z-5. R2. F80.\nX15.\nG80\nG68 X10. Y20. R30.\nX30. Y5.\nG69\nG52 X5.\n'
        'G0 X7. Y7.\nG52 X0\nG91 G28 Z0\nG28 X0 Y0\nM30\n%\n')

PATTERN = ('%\nO1\nN1 T1 M6\nG90 G54\nS2000 M3\nG43 H1 Z50.\nG0 X1. Y2.\nG1 Z-5. F100.\nG91 X10.\nG90 G0 Z50.\nT2 M6\nS900 M3\nG43 H2 Z50.\n'
           'G98 G81 X4. Y4. Z-9. R2. F80.\nX8.\nG80\nG91 G28 Z0\nM30\n%\n')
CONTOUR = ('%\nO1\nG21 G90 G17 G40\nT1 M6\nS2000 M3 G54 G0 X-20. Y-20.\nG43 H1 Z-5.\nG41 D1 G1 X0 Y-10. F100.\nY20. F200.\nG2 X10. Y30. I10. J0\n'
           'G1 X40. F300. (TOP)\nX0 Y-10.\nG40 X-20. Y-20.\nG0 Z50.\nM30\n%\n')

# what is tested, control, program, options, the edited program
EDITS = [
    ('numbers where there are none', 'fanuc', MILL + 'G1 Z-5. F100.\n/X10.\n' + END, ['--renumber', '10'],
     '%\nO0001 (PLATE)\nN10 G21 G90 G17 G40 G49 G80\nN20 T1 M6\nN30 S2000 M3\nN40 G54 G0 X0 Y0\nN50 G43 H1 Z50.\nN60 G1 Z-5. F100.\n/N70 X10.\n'
     'N80 G0 Z100.\nN90 M30\n%\n'),
    ('jumps follow their blocks', 'fanuc', '%\nO1\n#1=0\nN5 #1=#1+1\nG0 X#1\nIF [#1 LT 3] GOTO 5\nGOTO 0007\nX99.\nN7 M30\n%\n', ['--renumber', '100:5'],
     '%\nO1\nN100 #1=0\nN105 #1=#1+1\nN110 G0 X#1\nN115 IF [#1 LT 3] GOTO 105\nN120 GOTO 0130\nN125 X99.\nN130 M30\n%\n'),
    ('numbers keep their digits', 's2c42', '%\nN001 G90 ПС\nN002 G01 X+1000 F0100 ПС\nN003 M02 ПС\n', ['--renumber', '5'],
     '%\nN005 G90 ПС\nN010 G01 X+1000 F0100 ПС\nN015 M02 ПС\n'),
    ('the figure of a turning cycle', 'fanuc-t', 'N1 T0101\nN2 G50 S2000\nN3 G96 S100 M3\nG0 X60. Z2.\nG71 U2. R0.5\nG71 P7 Q9 U0.4 W0.1 F0.3\n'
     'N7 G0 X20.\nG1 Z-20.\nN9 X60.\nG70 P7 Q9\nG0 X100. Z50.\nM30\n', ['--renumber', '10'],
     'N10 T0101\nN20 G50 S2000\nN30 G96 S100 M3\nN40 G0 X60. Z2.\nN50 G71 U2. R0.5\nN60 G71 P70 Q90 U0.4 W0.1 F0.3\n'
     'N70 G0 X20.\nN80 G1 Z-20.\nN90 X60.\nN100 G70 P70 Q90\nN110 G0 X100. Z50.\nN120 M30\n'),
    ('a local subprogram', 'haas', '%\nO00001\nG21 G90 G54\nT1 M6\nS1000 M3\nG0 X0 Y0\nM97 P50 L2\nM30\nN50 G91 G0 X1.\nG90 M99\n%\n', ['--renumber', '1'],
     '%\nO00001\nN1 G21 G90 G54\nN2 T1 M6\nN3 S1000 M3\nN4 G0 X0 Y0\nN5 M97 P7 L2\nN6 M30\nN7 G91 G0 X1.\nN8 G90 M99\n%\n'),
    ('the slash of a line that is moved in', 'linuxcnc', 'G21 G91\n  / G0 Z1\n\t/G0 X1\nM2\n', ['--renumber', '10'],
     'N10 G21 G91\n  / N20 G0 Z1\n\t/N30 G0 X1\nN40 M2\n'),
    ('lines with a remark only get no number', 'fanuc', '%\nO1\n(A)\n/2G0X1.\n(B)\nM30\n%\n', ['--renumber', '10'], '%\nO1\n(A)\n/2N10 G0X1.\n(B)\nN20 M30\n%\n'),
    ('comments, spaces and empty lines go', 'fanuc', MILL + '\n(SLOT)\nN10 G1 Z-5. F100. (IN)\n\n' + END, ['--strip', 'comments,spaces,empty-lines'],
     '%\nO0001\nG21G90G17G40G49G80\nT1M6\nS2000M3\nG54G0X0Y0\nG43H1Z50.\nN10G1Z-5.F100.\nG0Z100.\nM30\n%\n'),
    ('messages are no comments', 'linuxcnc', 'G21 (MM)\n(MSG, turn the part)\nG0 X1 ; fast\nM2\n', ['--strip', 'comments'],
     'G21\n(MSG, turn the part)\nG0 X1\nM2\n'),
    ('numbers go', 'linuxcnc', 'N10 G21\nN20 G0 X1\nN30 M2\n', ['--strip', 'numbers'], 'G21\nG0 X1\nM2\n'),
    ('spaces come', 'linuxcnc', 'N10G21G90(MM)\nG0X1Y2\nM2\n', ['--add', 'spaces'], 'N10 G21 G90(MM)\nG0 X1 Y2\nM2\n'),
    ('feeds of one tool', 'fanuc', MILL + 'G1 Z-5. F100.\nX10. F0250\nG0 Z50.\nT3 M6\nS900 M3\nG43 H3 Z5.\nG1 Z-1. F150.\n' + END, ['--feed', 'T3=85%'],
     MILL + 'G1 Z-5. F100.\nX10. F0250\nG0 Z50.\nT3 M6\nS900 M3\nG43 H3 Z5.\nG1 Z-1. F127.5\n' + END),
    ('feeds of all tools, and others for one', 'linuxcnc', 'G21 G90 G94\nT1 M6\nG1 X1 F100\nT2 M6\nG1 X2 F100\nM2\n', ['--feed', '50%,T2=120%'],
     'G21 G90 G94\nT1 M6\nG1 X1 F50\nT2 M6\nG1 X2 F120\nM2\n'),
    ('a feed in a variable', 'fanuc', '%\nO1\n#101=80.\nT1 M6\nS100 M3\nG90 G54 G0 X0 Y0\nG1 X5. F#101\nX9. F[#101/2]\nM30\n%\n', ['--feed', '50%'],
     '%\nO1\n#101=80.\nT1 M6\nS100 M3\nG90 G54 G0 X0 Y0\nG1 X5. F[#101*0.5]\nX9. F[[#101/2]*0.5]\nM30\n%\n'),
    ('spaces at the end of a word with an expression', 'fanuc', '%\nO1\n#1=80.\nS100 M3\nG1 X5. F#1   Y2.\nM30\n%\n', ['--feed', '50%', '--add', 'spaces'],
     '%\nO1\n#1=80.\nS100 M3\nG1 X5. F[#1*0.5] Y2.\nM30\n%\n'),
    ('a subprogram of the only tool that calls it', 'haas',
     '%\nO00001\nG21 G90 G54\nT1 M6\nS1000 M3\nG0 X0 Y0\nM97 P50\nT2 M6\nS900 M3\nG1 X5. F200.\nM30\nN50 G1 X1. F100.\nM99\n%\n', ['--feed', 'T1=90%'],
     '%\nO00001\nG21 G90 G54\nT1 M6\nS1000 M3\nG0 X0 Y0\nM97 P50\nT2 M6\nS900 M3\nG1 X5. F200.\nM30\nN50 G1 X1. F90.\nM99\n%\n'),
    ('a tap keeps its pitch', 'fanuc', '%\nO1\nG21 G90 G94 G54\nT1 M6\nS500 M3\nG43 H1 Z5.\nG84 X0 Y0 Z-10. R2. F500.\nG80\nM30\n%\n', ['--speed', '80%', '--feed', '50%'],
     '%\nO1\nG21 G90 G94 G54\nT1 M6\nS400 M3\nG43 H1 Z5.\nG84 X0 Y0 Z-10. R2. F400.\nG80\nM30\n%\n'),
    ('the lead of a thread stays', 'fanuc-t', 'T0101\nG97 S500 M3\nG0 X30. Z5.\nG92 X29. Z-20. F1.5\nX28.5\nG0 X60.\nG1 Z-1. F0.2\nM30\n', ['--feed', '50%'],
     'T0101\nG97 S500 M3\nG0 X30. Z5.\nG92 X29. Z-20. F1.5\nX28.5\nG0 X60.\nG1 Z-1. F0.1\nM30\n'),
    ('surface speed, and its limit stays', 'fanuc-t', 'T0101\nG50 S2500\nG96 S200 M3\nG0 X30. Z5.\nG1 Z-20. F0.2\nM30\n', ['--speed', '75%'],
     'T0101\nG50 S2500\nG96 S150 M3\nG0 X30. Z5.\nG1 Z-20. F0.2\nM30\n'),
    ('a dwell is no feed', 'linuxcnc', 'G21 G90\nT1 M6\nS100 M3\nG4 P2\nG1 X1 F60\nM2\n', ['--feed', '50%'], 'G21 G90\nT1 M6\nS100 M3\nG4 P2\nG1 X1 F30\nM2\n'),
    ('another tool with its offsets', 'fanuc', '%\nO1\nG21 G90 G54\nT3 M6\nS500 M3\nG43 H3 Z5.\nG41 D3 G1 X10. Y10. F100.\nX20.\nG40 Y30.\nG43 H13 Z6.\nM30\n%\n',
     ['--replace-tool', '3=7'],
     '%\nO1\nG21 G90 G54\nT7 M6\nS500 M3\nG43 H7 Z5.\nG41 D7 G1 X10. Y10. F100.\nX20.\nG40 Y30.\nG43 H13 Z6.\nM30\n%\n'),
    ('tools change places', 'linuxcnc', 'G21 G90\nT1 M6\nG43 H1\nG0 X1\nT2 M6\nG43 H2\nG0 X2\nM2\n', ['--replace-tool', '1=2,2=1'],
     'G21 G90\nT2 M6\nG43 H2\nG0 X1\nT1 M6\nG43 H1\nG0 X2\nM2\n'),
    ('a turning tool with its offset', 'fanuc-t', 'T0303\nG97 S500 M3\nG0 X30. Z5.\nT0300\nM30\n', ['--replace-tool', '3=5'],
     'T0505\nG97 S500 M3\nG0 X30. Z5.\nT0500\nM30\n'),
    ('another zero', 'fanuc', MILL + 'G55 X3.\n' + END, ['--replace-zero', 'G54=G56'], MILL.replace('G54', 'G56') + 'G55 X3.\n' + END),
    ('a further zero', 'fanuc', MILL + END, ['--replace-zero', 'G54=G54.1P3'], MILL.replace('G54', 'G54.1 P3') + END),
    ('a shift', 'fanuc', MILL + 'G1 Z-5. F100.\nG91 X10.\nG90 Y20.5\nG2 X30. Y20.5 I5. J0\n' + END, ['--shift', 'X2.25,Z-1'],
     MILL.replace('X0 Y0', 'X2.25 Y0').replace('Z50.', 'Z49.') + 'G1 Z-6. F100.\nG91 X10.\nG90 Y20.5\nG2 X32.25 Y20.5 I5. J0\n' + END.replace('Z100.', 'Z99.')),
    ('a shift of drilled holes', 'fanuc', MILL + 'G98 G81 X1. Y2. Z-5. R2. F80.\nX3.\nG80\n' + END, ['--shift', 'X1,Z0.5'],
     MILL.replace('X0 Y0', 'X1. Y0').replace('Z50.', 'Z50.5') + 'G98 G81 X2. Y2. Z-4.5 R2.5 F80.\nX4.\nG80\n' + END.replace('Z100.', 'Z100.5')),
    ('a shift in inches', 'linuxcnc', 'G20 G90 G54\nG0 X1 Y1\nG1 X2 F10\nM2\n', ['--shift', 'X25.4'], 'G20 G90 G54\nG0 X2 Y1\nG1 X3 F10\nM2\n'),
    ('a mirror image: arcs and the side of the compensation change, the cycle does not', 'fanuc', PART, ['--mirror', 'X'],
     PART.replace('X-20. Y-20.', 'X20. Y-20.').replace('G41', 'G42').replace('G2 X10. Y30. I10. J0', 'G3 X-10. Y30. I-10. J0').replace('X40.', 'X-40.')
     .replace('G91 X-45.', 'G91 X45.').replace('X5. Y5.', 'X-5. Y5.').replace('X15.', 'X-15.').replace('G68 X10. Y20. R30.', 'G68 X-10. Y20. R-30.')
     .replace('X30. Y5.', 'X-30. Y5.').replace('G52 X5.', 'G52 X-5.').replace('X7. Y7.', 'X-7. Y7.')),
    ('a mirror image about a line', 'linuxcnc', 'G21 G90 G54\nG0 X1 Y2\nG1 Y5 F60\nG3 X3 Y7 I0 J2\nM2\n', ['--mirror', 'Y=10'],
     'G21 G90 G54\nG0 X1 Y18\nG1 Y15 F60\nG2 X3 Y13 I0 J-2\nM2\n'),
    ('a mirror image in the other planes', 'fanuc', MILL + 'G18 G2 X10. Z40. R10. F100.\nG19 G3 Y10. Z30. J0 K-10.\nG17\n' + END, ['--mirror', 'X'],
     MILL + 'G18 G3 X-10. Z40. R10. F100.\nG19 G3 Y10. Z30. J0 K-10.\nG17\n' + END),
    ('a computed position in a mirror image', 'fanuc', MILL + '#1=5\nG1 X#1 Y[#1+1] F100.\n' + END, ['--mirror', 'X=2'],
     MILL.replace('X0 Y0', 'X4. Y0') + '#1=5\nG1 X[0-[#1]+4] Y[#1+1] F100.\n' + END),
    ('a quarter turn: words change places, missing ones too', 'fanuc', PART, ['--rotate', '90'],
     '%\nO1\nG21 G90 G17 G40 G49 G80\nT1 M6\nS2000 M3\nG54 G0 X20. Y-20.\nG43 H1 Z50.\nG1 Z-5. F100.\nG41 D1 X10. Y0\nX-20.\nG2 X-30. Y10. I0 J10.\n'
     'G1 Y40.\nX0\nG91 Y-45.\nG90 G40 X20. Y-20.\nG0 Z50.\nG98 G81 X-5. Y5. Z-5. R2. F80.\nY15.\nG80\nG68 X-20. Y10. R30.\nX-5. Y30.\nG69\nG52 Y5.\n'
     'G0 X-7. Y7.\nG52 Y0\nG91 G28 Z0\nG28 X0 Y0\nM30\n%\n'),
    ('a turn by another angle: rounded as the control reads it', 'linuxcnc', 'G21 G90 G54\nG0 X10 Y0\nG1 Y20 F60\nG2 X20 Y30 I10 J0\nM2\n', ['--rotate', '30'],
     'G21 G90 G54\nG0 X8.66 Y5.\nG1 X-1.34 Y22.321 F60\nG2 X2.321 Y35.981 I8.66 J5.\nM2\n'),
    ('a pattern of two columns and two rows: each tool works at all places before the next one', 'fanuc', PATTERN, ['--copy', '2x2:30,20'],
     '%\nO1\nN1 T1 M6\nG90 G54\nS2000 M3\nG43 H1 Z50.\nG0 X1. Y2.\nG1 Z-5. F100.\nG91 X10.\nG90 G0 Z50.\n'
     'G0 X31. Y2.\nG1 Z-5. F100.\nG91 X10.\nG90 G0 Z50.\nG0 X1. Y22.\nG1 Z-5. F100.\nG91 X10.\nG90 G0 Z50.\nG0 X31. Y22.\nG1 Z-5. F100.\nG91 X10.\nG90 G0 Z50.\n'
     'T2 M6\nS900 M3\nG43 H2 Z50.\nG98 G81 X4. Y4. Z-9. R2. F80.\nX8.\nG80\nG98 G81 X34. Y4. Z-9. R2. F80.\nX38.\nG80\n'
     'G98 G81 X4. Y24. Z-9. R2. F80.\nX8.\nG80\nG98 G81 X34. Y24. Z-9. R2. F80.\nX38.\nG80\nG91 G28 Z0\nM30\n%\n'),
    ('a pattern around a centre', 'linuxcnc', 'G21 G90 G54\nG0 X10 Y0 Z5\nG1 Z-1 F60\nX12 Y3\nG0 Z5\nM2\n', ['--copy', '4@90', '--lines', '2-5'],
     'G21 G90 G54\nG0 X10 Y0 Z5\nG1 Z-1 F60\nX12 Y3\nG0 Z5\nG0 X0 Y10 Z5\nG1 Z-1 F60\nX-3 Y12\nG0 Z5\nG0 X-10 Y0 Z5\nG1 Z-1 F60\nX-12 Y-3\nG0 Z5\n'
     'G0 X0 Y-10 Z5\nG1 Z-1 F60\nX3 Y-12\nG0 Z5\nM2\n'),
    ('a pattern of one place', 'linuxcnc', 'G21 G90\nG0 X10 Y0\nM2\n', ['--copy', '1x1:5,5'], 'G21 G90\nG0 X10 Y0\nM2\n'),
    ('a closed contour backwards: the side changes, each element keeps its feed', 'fanuc', CONTOUR, ['--reverse', '7-12'],
     CONTOUR.replace('G41 D1 G1 X0 Y-10. F100.\nY20. F200.\nG2 X10. Y30. I10. J0\nG1 X40. F300. (TOP)\nX0 Y-10.\nG40 X-20. Y-20.\n',
                     'G42 G1 X0. Y-10. D1 F300.\nX40. Y30.\nX10. Y30. (TOP)\nG3 X0. Y20. I0. J-10. F200.\nG1 X0. Y-10.\nG40 X-20. Y-20. F100.\n')
     + ''),
    ('an open contour backwards: the rapid leads to its other end', 'linuxcnc',
     'G21 G90 G54 G17\nG0 X0 Y0\nG0 Z-1\nG1 X10 Y0 F60\nX20 Y5\nG0 Z5\nG0 X50 Y50\nM2\n', ['--reverse', '4-5'],
     'G21 G90 G54 G17\nG0 X20. Y5.\nG0 Z-1\nG1 X10. Y0. F60\nX0. Y0.\nG0 Z5\nG0 X50 Y50\nM2\n'),
    ('copies have numbers and end marks of their own', 's2c42',
     '%\nN001 G90 ПС\nN002 G00 X+10000 Y+5000 ПС\nN003 G01 X+20000 F0100 ПС\nN004 M02 ПС\n', ['--copy', '2x1:5,0'],
     '%\nN001 G90 ПС\nN002 G00 X+10000 Y+5000 ПС\nN003 G01 X+20000 F0100 ПС\nN005 G00 X+15000 Y+5000 ПС\nN006 G01 X+25000 F0100 ПС\nN004 M02 ПС\n'),
    ('copies in a program with numbers', 'linuxcnc', 'N10 G21 G90 G54\nN20 G0 X1 Y2\nN30 G1 X5 F60\nN40 M2\n', ['--copy', '2x1:10,0'],
     'N10 G21 G90 G54\nN20 G0 X1 Y2\nN30 G1 X5 F60\nN50 G0 X11 Y2\nN60 G1 X15 F60\nN40 M2\n'),
    ('a start from blocks before the pattern', 'linuxcnc', 'G21 G90 G54\nG0 X1 Y2\nG53 G0 Z0\nG0 X1 Y2\nM6 T2\nG0 X3\nG1 Y4 F60\nM2\n',
     ['--copy', '2x1:10,0', '--lines', '6-7'], 'G21 G90 G54\nG0 X1 Y2\nG53 G0 Z0\nG0 X1 Y2\nM6 T2\nG0 X3\nG1 Y4 F60\nG0 X13 Y2\nG1 Y4 F60\nM2\n'),
    ('what follows copies begins where it began', 'linuxcnc', 'G21 G90 G54\nG0 X1 Y2\nG1 X5 F60\nG0 Y9\nX6\nM2\n', ['--copy', '2x1:10,0', '--lines', '2-3'],
     'G21 G90 G54\nG0 X1 Y2\nG1 X5 F60\nG0 X11 Y2\nG1 X15 F60\nG0 X5 Y9\nX6\nM2\n'),
    ('an approach with one coordinate', 'linuxcnc', 'G21 G90 G54\nG0 X0 Y1\nY0\nG1 X10 F60\nX20 Y5\nG0 Z5\nM2\n', ['--reverse', '4-5'],
     'G21 G90 G54\nG0 X0 Y1\nX20. Y5.\nG1 X10. Y0. F60\nX0. Y0.\nG0 Z5\nM2\n'),
    ('a contour with more decimals', 'linuxcnc', 'G21 G90 G54\nG0 X0.12345 Y0\nG1 X10 F60\nY5.00001\nX0.12345 Y0\nM2\n', ['--reverse', '3-5'],
     'G21 G90 G54\nG0 X0.12345 Y0\nG1 X10. Y5.00001 F60\nX10. Y0.\nX0.12345 Y0.\nM2\n'),
    ('G53 stays', 'fanuc', MILL + 'G53 Z0\nG0 X5.\n' + END, ['--shift', 'X1'], MILL.replace('X0 Y0', 'X1. Y0') + 'G53 Z0\nG0 X6.\n' + END),
]

# what is tested, control, program, options, a part of the message
REFUSED = [
    ('a computed jump', 'fanuc', '%\nO1\n#1=5\nGOTO #1\nN5 M30\n%\n', ['--renumber', '10'], 'p.nc:4: not edited: GOTO #1 computes the number of a block'),
    ('two tools in one subprogram', 'haas',
     '%\nO00001\nG21 G90 G54\nT1 M6\nS1000 M3\nG0 X0 Y0\nM97 P50\nT2 M6\nS900 M3\nM97 P50\nM30\nN50 G1 X1. F100.\nX0\nM99\n%\n', ['--feed', 'T1=90%'],
     'p.nc:12: not edited: this line is executed with the tools 1 and 2'),
    ('a feed that another tool goes on with', 'linuxcnc', 'G21 G90\nT1 M6\nG1 X1 F100\nT2 M6\nG1 X2\nM2\n', ['--feed', 'T1=50%'], 'p.nc:5: feed'),
    ('a tool that is there already', 'fanuc', MILL + 'T2 M6\n' + END, ['--replace-tool', '1=2'], 'the program already uses tool 2'),
    ('a tool that is not there', 'fanuc', MILL + END, ['--replace-tool', '4=5'], 'the program does not use tool 4'),
    ('a zero that the control does not have', 'grbl', 'G21 G90 G54\nG0 X1\nM30\n', ['--replace-zero', 'G54=G70'], 'no code G70'),
    ('an axis that is not there', 'grbl', 'G21 G90\nG0 X1\nM30\n', ['--shift', 'U3'], 'no axis U'),
    ('a diameter', 'fanuc-t', 'T0101\nG0 X30.\nM30\n', ['--shift', 'X1'], 'X is programmed as a diameter'),
    ('a program that stops', 'fanuc', MILL + 'G999\n' + END, ['--renumber', '10'], 'the program stops with an alarm'),
    ('numbers with too many digits', 's2c42', '%\nN001 G90 ПС\nN002 M02 ПС\n', ['--renumber', '99999'], 'more than 5 digits'),
    ('polar words in a mirror image', 'fanuc', MILL + 'G16\nX10. Y30.\nG15\n' + END, ['--mirror', 'X'], 'p.nc:8: not edited: G16: the words of this code'),
    ('a computed position in a turn', 'fanuc', MILL + '#1=5\nX#1\n' + END, ['--rotate', '30'], 'p.nc:9: not edited: X#1: a computed position'),
    ('a position that is not known in a turn', 'linuxcnc', 'G21 G90\nG0 X1\nM2\n', ['--rotate', '30'], 'p.nc:2: not edited: the position along Y'),
    ('a macro of another program in a mirror image', 'fanuc', MILL + 'G65 P100 X1.\n' + END + 'O100\nG0 X#24\nM99\n', ['--mirror', 'X'], 'p.nc:8: not edited: G65'),
    ('a pattern that calls', 'haas', '%\nO00001\nG21 G90 G54\nT1 M6\nG0 X0 Y0\nM97 P50\nM30\nN50 G91 G0 X1.\nG90 M99\n%\n', ['--copy', '2x1:5,0'],
     'p.nc:6: not edited: M97 P50'),
    ('a pattern whose start is not known', 'linuxcnc', 'G21 G90\nG0 X1\nY2\nM2\n', ['--copy', '2x1:5,0'], 'p.nc:2: not edited: the position along Y is not known here'),
    ('a pattern that begins with an increment', 'linuxcnc', 'G21 G90\nG0 X1 Y1\nM6 T1\nG91 X1\nG90\nM2\n', ['--copy', '2x1:5,0', '--lines', '4-4'], 'p.nc:4: not edited: the first motion that is repeated must'),
    ('lines that begin with a plunge', 'linuxcnc', 'G21 G90\nG0 X1 Y1\nG1 Z-5 F60\nX9\nM2\n', ['--copy', '2x1:5,0', '--lines', '3-4'], 'p.nc:3: not edited: G1 Z-5 F60: the first motion'),
    ('an increment after copies', 'linuxcnc', 'G21 G90\nG0 X1 Y1\nG1 X9 F60\nG91 G0 X5\nG90\nM2\n', ['--copy', '2x1:5,0', '--lines', '2-3'], 'p.nc:4: not edited: this increment would begin'),
    ('a plunge after copies', 'linuxcnc', 'G21 G90\nG0 X1 Y1\nG1 X9 F60\nG1 Z-1\nM2\n', ['--copy', '2x1:5,0', '--lines', '2-3'], 'something else would change'),
    ('a single coordinate after an open contour', 'linuxcnc', 'G21 G90\nG0 X1 Y1\nG1 X9 Y3 F60\nG0 X20\nM2\n', ['--reverse', '3-3'], 'something else would change'),
    ('copies that would cut above the part', 'linuxcnc', 'G21 G90\nG0 X1 Y1 Z5\nG0 Z-1\nG1 X9 Y1 F60\nG0 Z5\nM2\n', ['--copy', '2x1:20,0', '--lines', '4-5'], 'something else would change'),
    ('a contour with compensation on at its start', 'fanuc', CONTOUR, ['--reverse', '8-11'], 'not edited'),
    ('a contour with a plunge', 'linuxcnc', 'G21 G90\nG0 X0 Y0\nG1 X5 Y0 F60\nX0 Y0 Z-1\nM2\n', ['--reverse', '3-4'], 'p.nc:4: not edited: X0 Y0 Z-1'),
    ('a lathe in a mirror image', 'fanuc-t', 'T0101\nG0 X30.\nM30\n', ['--mirror', 'X'], 'has no XY plane'),
    ('a speed in a subroutine of the zero', 'fanuc', '%\nO1\nG90 G54\nT1 M6\nG10 L2 P1 X5.\nG54 G0 X1.\nM30\n%\n', ['--replace-zero', 'G54=G55'],
     'something else would change'),
]

# options that are wrong in themselves
WRONG = [['--feed', '80'], ['--feed', 'T3:80%'], ['--feed', '0%'], ['--renumber', 'x'], ['--renumber', '10:0'], ['--replace-tool', '3'], ['--shift', '10'],
         ['--replace-zero', 'G54'], ['--strip', 'everything'], ['--shift', 'X1e9'], ['--speed', '99999999%'], ['--copy', '0x1:5,5'], ['--copy', '3x2'], ['--copy', '2000x1:1,1'], ['--reverse', '5'],
         ['--reverse', '5-3'], ['--copy', '6@60:1'], ['--mirror', 'Z'], ['--mirror', 'X:5'], ['--rotate', 'x'], ['--rotate', '30@5'],
         ['--mirror', 'X', '--rotate', '90'], ['--shift', 'X1', '--mirror', 'X'], []]

WORD = re.compile(r'([A-Z])\s*([-+]?\d*\.?\d+|[-+]?\d+\.)')


def edit(kadr, control, text, options):
    kadr.file('p.nc', text)
    (kadr.folder / 'o.nc').unlink(missing_ok=True)
    done = kadr.call('edit', 'p.nc', '--control', control, '--out', 'o.nc', *options)
    made = kadr.folder / 'o.nc'
    return done, made.read_bytes().decode('utf-8') if made.exists() else None


def check_cases(tally, kadr):
    for what, control, text, options, wanted in EDITS:
        done, made = edit(kadr, control, text, options)
        tally.judge(what, [f'exit status {done.returncode}: {done.stderr}'] if done.returncode else [] if made == wanted else [f'\n{made}\nwanted\n{wanted}'])
        windows = text.replace('\n', '\r\n')
        done, made = edit(kadr, control, windows, options)
        tally.same(f'{what}: line ends stay', made, wanted.replace('\n', '\r\n'))
    for what, control, text, options, message in REFUSED:
        done, made = edit(kadr, control, text, options)
        tally.judge(what, [*([] if done.returncode == 1 else [f'exit status {done.returncode}']), *([] if made is None else ['a file is written']),
                           *([] if message in done.stderr else [f'the message is {done.stderr!r}'])])
    for options in WRONG:
        done, made = edit(kadr, 'fanuc', MILL + END, options)
        tally.judge(f'wrong option {options}', [*([] if done.returncode == 2 and done.stderr else [f'exit status {done.returncode}']),
                                                *([] if made is None else ['a file is written'])])
    done, made = edit(kadr, 'fanuc', '', ['--renumber', '10'])
    tally.expect(done.returncode in (0, 1) and 'terminate' not in done.stderr, 'an empty program', done.stderr)
    kadr.file('p.nc', MILL + END)
    done = kadr.call('edit', 'p.nc', '--control', 'fanuc', '--renumber', '10', '--out', 'p.nc')
    tally.expect(done.returncode == 2 and (kadr.folder / 'p.nc').read_text() == MILL + END, 'the program itself is not overwritten', done.stderr)


def words(text):
    """Returns the words of each line without comments and numbers of blocks: [(letter, number)]."""
    lines = []
    for line in text.splitlines():
        line = re.sub(r'\(.*?\)|\(.*|;.*', '', line)
        found = [(letter, float(number)) for letter, number in WORD.findall(line) if letter != 'N']
        if found:
            lines.append(found)
    return lines


def example_programs():
    return sorted(path for folder in ('fanuc', 'haas', 'linuxcnc', 'mach3', 'grbl', 'gost', 's2c42', 'nct', 'correctors', 'fanuc-t')
                  for path in (ROOT / 'examples' / folder).iterdir() if path.suffix in ('.nc', '.ngc', '.tap', '.nct'))


def check_examples(tally, kadr, every):
    """No word of any example changes but those that were to change."""
    examples = example_programs()
    options = [['--renumber', '10'], ['--strip', 'comments,spaces,empty-lines'], ['--add', 'spaces'], ['--feed', '50%'], ['--speed', '50%']]
    proven, possible = 0, 0
    for number, path in enumerate(examples[::every]):
        setup = path.with_suffix('.json')
        text = path.read_bytes()
        try:
            before = words(text.decode('utf-8'))
        except UnicodeDecodeError:
            before = None
        given = ['--control', path.parent.name, *(['--setup', setup] if setup.exists() else [])]
        if kadr.call('run', path, *given, '--quiet').returncode != 0:
            continue   # a subprogram, or a program for a machine of its own
        possible += len(options)
        for option in options:
            out = kadr.folder / 'o.nc'
            out.unlink(missing_ok=True)
            done = kadr.call('edit', path, *given, '--out', out, *option)
            what = f'{path.relative_to(ROOT)} {" ".join(option)}'
            tally.expect(done.returncode in (0, 1), what, done.stderr)
            proven += done.returncode == 0
            if done.returncode == 1:
                tally.expect(not out.exists(), f'{what}: a refused edit writes nothing')
                tally.expect(option[0] != '--strip' and option[0] != '--add', f'{what} is refused', done.stderr)
            elif before is not None:
                after = words(out.read_bytes().decode('utf-8'))
                letter = {'--feed': 'F', '--speed': 'SF'}.get(option[0], '')
                changed = [(a, b) for one, other in zip(before, after) for a, b in zip(one, other) if a != b]
                if option[0] != '--renumber':
                    tally.expect(len(before) == len(after), f'{what}: number of lines with words', len(before), len(after))
                    tally.judge(f'{what}: other words', [f'{a} became {b}' for a, b in changed if a[0] != b[0] or a[0] not in letter or abs(a[1] - 2 * b[1]) > 1])
    tally.expect(proven >= 0.9 * possible > 0, f'{proven} of {possible} edits of examples are proven')


def check_maps(tally, kadr, every):
    """A program mirrored twice, or turned four times by 90°, has its old words; each step is proven or refused with the block."""
    proven, possible = 0, 0
    for path in example_programs()[::every]:
        setup = path.with_suffix('.json')
        given = ['--control', path.parent.name, *(['--setup', setup] if setup.exists() else [])]
        try:
            before = words(path.read_bytes().decode('utf-8'))
        except UnicodeDecodeError:
            continue
        if path.parent.name == 'fanuc-t' or kadr.call('run', path, *given, '--quiet').returncode != 0:
            continue
        for option, times in ((['--mirror', 'X=10'], 2), (['--mirror', 'Y'], 2), (['--rotate', '90@5,5'], 4)):
            possible += 1
            now, what = path, f'{path.relative_to(ROOT)} {" ".join(option)}'
            for step in range(times):
                out = kadr.folder / f'o{step}.nc'
                out.unlink(missing_ok=True)
                done = kadr.call('edit', now, *given, '--out', out, *option)
                tally.expect(done.returncode in (0, 1) and out.exists() == (done.returncode == 0), what, done.stderr)
                if done.returncode != 0:
                    tally.expect(step == 0 or 'not_stated' in done.stderr, f'{what}: step {step + 1} is refused although the first was not', done.stderr)
                    break
                now = out
            else:
                proven += 1
                after = words(now.read_bytes().decode('utf-8'))
                tally.judge(f'{what}: {times} times', [f'{a} became {b}' for a, b in zip(before, after) if a != b][:3])
    tally.expect(proven >= 0.25 * possible > 0, f'{proven} of {possible} maps of examples are proven')
    print(f'{proven} of {possible} maps of examples are proven')


HEADS = {'fanuc': '%\nO1\nG21 G90 G17 G54\nT1 M6\nS900 M3\n', 'haas': '%\nO00001\nG21 G90 G17 G54\nT1 M6\nS900 M3\n', 'linuxcnc': 'G21 G90 G17 G54\nS900 M3\n',
         'mach3': 'G21 G90 G17 G54\nS900 M3\n', 'grbl': 'G21 G90 G17 G54\nS900 M3\n'}


def random_contour(rng):
    """Returns blocks of a closed contour of lines and half circles, absolute, with the position that leads to it first."""
    at = start = (rng.randint(-90, 90) / 2, rng.randint(-90, 90) / 2)
    lines = [f'G0 X{start[0]} Y{start[1]}', 'G0 Z5.', 'G1 Z-1. F60.']
    for _ in range(rng.randint(2, 8)):
        to = (rng.randint(-90, 90) / 2, rng.randint(-90, 90) / 2)
        if to == at:
            continue
        if rng.random() < 0.4:
            lines.append(f'G{rng.choice("23")} X{to[0]} Y{to[1]} I{(to[0] - at[0]) / 2} J{(to[1] - at[1]) / 2} F{rng.choice((80, 120))}.')
        else:
            lines.append(f'G1 X{to[0]} Y{to[1]} F{rng.choice((80, 120))}.')
        at = to
    if at != start:
        lines.append(f'G1 X{start[0]} Y{start[1]} F90.')
    return [*lines, 'G0 Z50.']


def check_random(tally, kadr, count):
    """Mirrored twice, turned four times, copied once or reversed twice, a random program is the old one. Each step is proven."""
    rng = random.Random(20999)
    for number in range(count):
        control = rng.choice(sorted(HEADS))
        contour = random_contour(rng)
        moves = [f'G91 G1 X{rng.randint(1, 9)}. Y{rng.randint(1, 9)}. F70.', 'G90'] if rng.random() < 0.5 else []
        text = HEADS[control] + '\n'.join([*contour, *moves, 'G0 Z60.', 'M30']) + '\n' + ('%\n' if HEADS[control].startswith('%') else '')
        first = HEADS[control].count('\n') + 4
        contour_lines = f'{first}-{first + len(contour) - 5}'
        for options, times in ((['--mirror', f'X={rng.randint(-5, 5)}'], 2), (['--rotate', f'90@{rng.randint(-5, 5)},3'], 4), (['--copy', '1x1:10,10'], 1),
                               (['--reverse', contour_lines], 2)):
            now, faults = text, []
            for _ in range(times):
                done, made = edit(kadr, control, now, options)
                if made is None:
                    faults.append(f'{done.stderr}{now}')
                    break
                now = made
            if not faults and options[0] == '--reverse':
                kadr.file('a.nc', text), kadr.file('b.nc', now)
                same = kadr.call('diff', 'a.nc', 'b.nc', '--control-a', control, '--control-b', control)
                faults += [] if same.returncode == 0 else [f'{same.stdout}{text}{now}']
            elif not faults and words(now) != words(text):
                faults.append(f'{text}became\n{now}')
            tally.judge(f'random program {number}, {control}: {" ".join(options)}, {times} times', faults)


def main():
    parser = harness.arguments(__doc__)
    parser.add_argument('--every', type=int, default=1, help='every nth example only')
    options = harness.parsed(parser)
    tally = Tally()
    with tempfile.TemporaryDirectory() as folder:
        kadr = harness.Kadr(options.kadr, folder)
        kadr.language = 'en'
        check_cases(tally, kadr)
        check_examples(tally, kadr, options.every)
        check_maps(tally, kadr, options.every)
        check_random(tally, kadr, 40 // options.every + 1)
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
