#!/usr/bin/env python3
"""Tests samples of programs with tool centre point control; tests/golden/five_axis_samples.py judges each: tip, direction, speed, limits.

    five_axis_samples.py --kadr build/kadr

Exit status: 0 all within the bounds, 1 not, 2 wrong usage.
"""
import argparse
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TIME_LIMIT_S = 600


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--kadr', required=True)
    arguments = parser.parse_args()
    referee = [sys.executable, str(ROOT / 'tests/golden/five_axis_samples.py'), '--machine', str(ROOT / 'machines/nct-vmc.toml')]
    return subprocess.run([*referee, '--kadr', arguments.kadr], timeout=TIME_LIMIT_S, check=False).returncode


if __name__ == '__main__':
    sys.exit(main())
