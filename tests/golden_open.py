#!/usr/bin/env python3
"""Runs the golden cases of controls that have open ones: all pass except those that tests/golden/CONTROL-open.txt names, each with its
reason; a named case that passes is a fault too, so that the list stays true."""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent


CONTROLS = ("nct", "linuxcnc", "fanuc", "haas", "haas-st", "mach3", "grbl", "sinumerik",
            "heidenhain")


def open_cases(control):
    lines = (HERE / "golden" / f"{control}-open.txt").read_text(encoding="utf-8").splitlines()
    rows = [line.split(None, 1) for line in lines if line.strip() and not line.startswith("#")]
    without = [row[0] for row in rows if len(row) < 2]
    if without:
        sys.exit(f"{control}-open.txt: no reason for {without}")
    return dict(rows)


def run(control, kadr):
    """Returns the number of passed cases, and the faults."""
    known = open_cases(control)
    with tempfile.NamedTemporaryFile(suffix=".json") as report:
        subprocess.run([sys.executable, HERE / "golden" / "check.py", "--kadr", kadr, "--jobs", "2", "--json", report.name,
                        HERE / "golden" / control], check=False, stdout=subprocess.DEVNULL)
        rows = json.loads(Path(report.name).read_text(encoding="utf-8"))
    failed = {Path(row["file"]).stem: row["detail"] for row in rows if row["result"] == "failed"}
    passed = {Path(row["file"]).stem for row in rows if row["result"] == "passed"}
    for name in sorted(failed.keys() - known.keys()):
        print(f"FAIL {control}/{name}: {failed[name]}")
    for name in sorted(known.keys() - failed.keys()):
        print(f"FAIL {control}/{name}: is named in {control}-open.txt, but {'passes' if name in passed else 'does not run'}")
    print(f"{control}: {len(passed)} cases pass, {len(known)} are open")
    return len(passed) - len(known.keys() & passed), len(failed.keys() ^ known.keys())


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kadr", required=True)
    options = parser.parse_args()
    counts = [run(control, options.kadr) for control in CONTROLS]
    wrong = sum(count[1] for count in counts)
    print(f"{sum(count[0] for count in counts)} passed, {wrong} failed")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
