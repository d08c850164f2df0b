#!/usr/bin/env python3
"""Tests the reader of our own cases, tests/cases/reader.py: how it reads a text, and which texts it refuses, naming the line.

    case_texts.py [--kadr build/kadr]
"""
import argparse
import sys

from cases import reader

HEAD = '== a | 1.1 | rule\nA title\nderivation by hand\n'
CASE = {'id': 'a', 'control': 'nct', 'source': '1.1', 'title': 'A title', 'basis': 'rule', 'runnable': True, 'derivation': 'by hand',
        'notes': '', 'setup': {}, 'program': 'G0 X1', 'expect': {}}
READ = [  # text after HEAD, the keys of the case that differ from CASE
    ('    G0 X1\n', {}),
    ('    G0 X1  -> rapid X1\n', {'expect': {'trace': [{'do': 'rapid', 'to': {'X': 1}}]}}),
    ('    G0 X1  -> rapid X1 -> motion X2=-.5\n           -> feed feed 0.1\n',
     {'expect': {'trace': [{'do': 'rapid', 'to': {'X': 1}}, {'to': {'X2': -.5}}, {'do': 'feed', 'feed': 0.1}]}}),
    ('    G0 X1\nthen dwell 2 -> stop single_block -> spindle rpm 5 -> message "A -> B" -> coolant loose\n',
     {'expect': {'trace': [{'do': 'dwell', 'seconds': 2}, {'do': 'stop', 'reason': 'single_block'}, {'do': 'spindle', 'rpm': 5},
                           {'do': 'message', 'text': 'A -> B'}, {'do': 'coolant', 'loose': True}]}}),
    ('    G0 X1\nthen nothing\n', {'expect': {'trace': []}}),
    ('    "\\tG0 -> \\"X1 "  -> tool 5\n    ""\n', {'program': '\tG0 -> "X1 \n', 'expect': {'trace': [{'do': 'tool', 'tool': 5}]}}),
    ('setup {"feed": 5,\n| "skip": [2]}\n# a remark\n    #1=5 (G0)\n\n    ; Ф\n', {'setup': {'feed': 5, 'skip': [2]}, 'program': '#1=5 (G0)\n; Ф'}),
    ('    G0 X1\nend X1 machine X2\nvariables #1=2.5 #2=vacant\nmodal G1 F5\n',
     {'expect': {'end': {'to': {'X': 1}, 'machine': {'X': 2}}, 'variables': {'#1': 2.5, '#2': None}, 'modal': ['G1', 'F5']}}),
    ('    G0 X1\nalarm 2012 line 2 text "no F"\nopen\ncomplete_for nothing\n',
     {'expect': {'alarm': {'number': 2012, 'line': 2, 'text': 'no F'}, 'open': True, 'complete_for': []}}),
    ('    G0 X1\nalarm any_number block N3\n', {'expect': {'alarm': {'number': None, 'block': 'N3'}}}),
    ('    G0 X1\nalarm none\n', {'expect': {'alarm': None}}),
    ('    G0 X1\nalarm not_judged\n', {'expect': {'alarm': 'any'}}),
    ('why no signals\n    G0 X1\n', {'runnable': False, 'why': 'no signals'}),
    ('setup {"channels": {"2": {"axes": ["U"]}}}\n    G0 X1\nfile O 1.nct\n    M99\n    M30\nchannel 2\n    G4\n',
     {'setup': {'channels': {'2': {'axes': ['U'], 'program': 'G4'}}, 'files': {'O 1.nct': 'M99\nM30'}}}),
    ('    G0 X1\n-- one\nsetup {"feed": 1}\n-- two of them\n    G1  -> feed X1\nopen\n',
     {'variants': [{'name': 'one', 'setup': {'feed': 1}},
                   {'name': 'two of them', 'program': 'G1', 'expect': {'trace': [{'do': 'feed', 'to': {'X': 1}}], 'open': True}}]}),
]
REFUSED = [  # whole text, the expected error message
    ('', '1: no case'), ('# only a remark\n', '1: no case'), ('end X1\n', '1: a line before the first case'),
    ('== a | 1.1\nA title\n', '1: a case begins with'), ('== a | 1.1 | rule\n    G0\n', '1: the title is missing'), (HEAD, '1: no program'),
    (HEAD + '    G0\nfeeds 5\n', "5: unknown key 'feeds'"), (HEAD + '  G0\n', "4: unknown key ''"), (HEAD + '    G0 \n', '4: this line'),
    (HEAD + '    G0\t\n', '4: this line'), (HEAD + '    G0->rapid\n', '4: this line'), (HEAD + '    "G0" rapid\n', '4: -> is missing'),
    (HEAD + '    G0  -> rapid X\n', "4: 'X' is neither"), (HEAD + '    G0  -> rapid X1 X2\n', '4: X stands twice'),
    (HEAD + '    G0  -> rapid to Y1 feed\n', '4: feed has no value'), (HEAD + '    G0  -> rapid ->\n', '4: an action begins'),
    (HEAD + '    -> rapid X1\n', '4: actions stand beside'), (HEAD + '    G0\nfile a\n    M99  -> rapid X1\n', '6: actions stand beside'),
    (HEAD + '    G0\nfile a\n', '5: a has no line'), (HEAD + 'setup {"a": 1, "a": 2}\n    G0\n', "4: 'a' stands twice"),
    (HEAD + 'setup {"a"\n    G0\n', '4: no JSON'), (HEAD + '    G0\nsetup {}\n', '5: setup stands once'), (HEAD + '    G0\nend X1\nend X2\n', '6: end'),
    (HEAD + '    G0\nalarm x\n', "5: 'x' is no number"), (HEAD + '    G0\nalarm 1 lines 2\n', "5: 'lines' is neither"),
    (HEAD + '    G0\nvariables #1\n', "5: '#1': not"), (HEAD + '    G0\ntolerance\n', '5: tolerance has no value'),
]


def main():
    parser = argparse.ArgumentParser(description='What the reader of our own cases reads and refuses.')
    parser.add_argument('--kadr', help='not needed')
    parser.parse_args()
    failed = []
    for text, keys in READ:
        got = reader.read_text(HEAD + text, 'nct')
        if got != ([(1, {**CASE, **keys})], []):
            failed.append(f'{text}expected {keys}\ngot {got}')
    for text, fault in REFUSED:
        _, faults = reader.read_text(text, 'nct')
        if len(faults) != 1 or not faults[0].startswith(fault):
            failed.append(f'{text}expected the fault {fault}\ngot {faults}')
    for text in failed:
        print(f'FAIL {text}')
    print(f'{len(READ) + len(REFUSED) - len(failed)} passed, {len(failed)} failed')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
