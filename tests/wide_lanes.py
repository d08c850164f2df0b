#!/usr/bin/env python3
"""Checks that stock/cut/tilted_cut_wide.cpp is compiled for processors with AVX2, and that it shares no function with other files.

    wide_lanes.py --kadr build/release/kadr

The linker keeps any one copy of a function that several objects contain. If it kept the copy of the wide object, a processor without
AVX2 could execute it and crash. So every such function (a weak symbol) of the wide object has its vector type of eight lanes in its
name, which no other object has. Exit status: 0 passed, 1 failed, 2 the object does not exist.
"""
import argparse
import re
import subprocess
import sys
from pathlib import Path

OBJECT = 'src/CMakeFiles/kadr_stock.dir/stock/cut/tilted_cut_wide.cpp.o'


def weak_symbols(object_file):
    """Returns the demangled names of functions and data that other objects may contain as well."""
    listed = subprocess.run(['nm', '-C', str(object_file)], check=True, capture_output=True, text=True).stdout
    return [match[1] for match in re.finditer(r'^[0-9a-f]+ [WVu] (.*)$', listed, re.M)]


def main():
    parser = argparse.ArgumentParser(description='Check that the object for AVX2 shares no function.')
    parser.add_argument('--kadr', required=True, help='the program under test, in its build folder')
    object_file = Path(parser.parse_args().kadr).resolve().parent / OBJECT
    if not object_file.exists():
        print(f'{object_file} is not there', file=sys.stderr)
        return 2
    names = weak_symbols(object_file)
    shared = [name for name in names if '__vector(8)' not in name]
    for name in shared:
        print(f'FAILED the wide object holds a function that others may hold: {name}')
    if not names:
        print('FAILED no such function at all: the names are not read as they are printed')
    failed = len(shared) + (not names)
    print(f'{max(len(names), 1) - failed} passed, {failed} failed')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
