#!/usr/bin/env python3
"""The golden cases of the NCT control: all pass but those that tests/golden/nct-open.txt names, each with its reason; one that
is named and passes is a fault too, so that the list stays true."""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent


def open_cases():
    lines = (HERE / "golden" / "nct-open.txt").read_text(encoding="utf-8").splitlines()
    rows = [line.split(None, 1) for line in lines if line.strip() and not line.startswith("#")]
    without = [row[0] for row in rows if len(row) < 2]
    if without:
        sys.exit(f"nct-open.txt: no reason for {without}")
    return dict(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kadr", required=True)
    options = parser.parse_args()
    known = open_cases()
    with tempfile.NamedTemporaryFile(suffix=".json") as report:
        subprocess.run([sys.executable, HERE / "golden" / "check.py", "--kadr", options.kadr, "--jobs", "2", "--json", report.name,
                        HERE / "golden" / "nct"], check=False, stdout=subprocess.DEVNULL)
        rows = json.loads(Path(report.name).read_text(encoding="utf-8"))
    failed = {Path(row["file"]).stem: row["detail"] for row in rows if row["result"] == "failed"}
    passed = {Path(row["file"]).stem for row in rows if row["result"] == "passed"}
    for name in sorted(failed.keys() - known.keys()):
        print(f"FAIL {name}: {failed[name]}")
    for name in sorted(known.keys() - failed.keys()):
        print(f"FAIL {name}: is named in nct-open.txt, but {'passes' if name in passed else 'does not run'}")
    wrong = len(failed.keys() ^ known.keys())
    print(f"{len(passed)} cases pass, {len(known)} are open\n{len(passed) - len(known.keys() & passed)} passed, {wrong} failed")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
