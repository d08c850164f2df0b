#!/usr/bin/env python3
"""Tests kadr explain against tests/explain_cases/*.txt.

`$ ARGUMENTS` runs it (in English unless --lang is given). The lines below it: a line of the answer, without its outer blanks; `~ part of
it`; `! not in it`; `status N`, else 0. `#` starts a comment, with the section of the manual."""
import argparse
import pathlib
import shlex
import subprocess
import sys

from harness import TIME_LIMIT_S

CASES = pathlib.Path(__file__).parent / "explain_cases"


def cases(path):
    """Yields (location, arguments, expectations) of each run of a file."""
    found = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if line.startswith("$ "):
            found.append((f"{path.name}:{number}", shlex.split(line[2:]), []))
        elif line.strip() and not line.startswith("#"):
            found[-1][2].append(line.strip())
    return found


def faults(kadr, arguments, expected):
    language = [] if "--lang" in arguments else ["--lang", "en"]
    run = subprocess.run([kadr, "explain", *arguments, *language], capture_output=True, text=True, cwd=CASES, timeout=TIME_LIMIT_S)
    answer = run.stdout + run.stderr
    lines = [line.strip() for line in answer.splitlines()]
    status = [e for e in expected if e.startswith("status ")] or ["status 0"]
    found = [] if f"status {run.returncode}" in status else [f"status {run.returncode}"]
    for line in expected:
        if line.startswith("status "):
            continue
        if line.startswith("! "):
            right = line[2:] not in answer
        elif line.startswith("~ "):
            right = line[2:] in answer
        else:
            right = line in lines
        if not right:
            found.append(line)
    return found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--kadr", required=True)
    kadr = str(pathlib.Path(parser.parse_args().kadr).resolve())
    runs = [case for path in sorted(CASES.glob("*.txt")) for case in cases(path)]
    failed = 0
    for place, arguments, expected in runs:
        wrong = faults(kadr, arguments, expected)
        failed += bool(wrong)
        for line in wrong:
            print(f"{place}: explain {' '.join(arguments)}: {line}")
    print(f"{len(runs) - failed} passed, {failed} failed")
    return 1 if failed or not runs else 0


if __name__ == "__main__":
    sys.exit(main())
