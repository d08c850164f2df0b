#!/usr/bin/env python3
"""Checks controls/nct.toml against the tables of spec/nct. Run: python3 tests/nct_spec.py

Every code of the table of chapter 3 has a row of its group; every line of the index of system variables (chapter 23) has a row that may
be read and written as the index states; every alarm with a number and words in a table of alarms is in [alarms] or in NO_ALARM_YET.
Prints a line per difference, then `N passed, N failed`. Exit status: 0 all passed, 1 some failed.
"""
import pathlib
import re
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
SPEC = ROOT / "spec" / "nct"
CONTROL = tomllib.loads((ROOT / "controls" / "nct.toml").read_text(encoding="utf-8"))
# Alarms of functions that Kadr does not have yet, and messages of the machine (3…).
NO_ALARM_YET = {2001, 2019, 2040, 2041, 2042, 2045, 2046, 2049, 2192} | set(range(3000, 4000))

passed = 0
failures = []


def check(ok, what):
    global passed
    if ok:
        passed += 1
    else:
        failures.append(what)
    return ok


def chapter(number):
    return next(SPEC.glob(f"{number}-*.md")).read_text(encoding="utf-8")


def rows_below(text, heading):
    """Yields the cells of the table under a heading, without its header."""
    part = re.split(r"\n## ", text.split(heading, 1)[1])[0]
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in part.splitlines() if line.startswith("|")]
    return rows[2:]


def codes_of(cell):
    """`G55 ... G59` → G55 to G59; `G68.2 P1` → G68.2."""
    numbers = re.findall(r"G(\d+(?:\.\d)?)", cell)
    if "..." in cell:
        return [str(n) for n in range(int(numbers[0]), int(numbers[1]) + 1)]
    return numbers


def check_codes():
    groups, initial = CONTROL["groups"], {}
    rows = rows_below(chapter("03"), "## Codes in this chapter")
    check(len(rows) > 100, "chapter 3: the table of codes is not read")
    for cell, group, modal, init, _, _ in rows:
        for code in codes_of(cell):
            row = CONTROL["g"].get(code)
            if not check(row is not None, f"G{code}: no row"):
                continue
            check(row.get("group") == group, f"G{code}: group {row.get('group')}, in the manual {group}")
            check(groups[group].get("modal", True) == modal.startswith("yes"), f"G{code}: modal in the manual: {modal}")
            if init:
                initial.setdefault(group, []).append("G" + code)
    for group, codes in initial.items():
        check(groups[group]["initial"] in codes, f"group {group}: {groups[group]['initial']} is not in force at power-on")


def numbers_of(row):
    ranges = row.get("ranges", [])
    return {r[0] + i * stride + j for r in ranges for stride, repeat in [r[2:] or (0, 1)] for i in range(repeat) for j in range(r[1])}


def check_variables():
    access = {}
    for row in CONTROL["variables"]:
        access.update(dict.fromkeys(numbers_of(row), row.get("access", "RW")))
    symbols = {row.get("symbol") for row in CONTROL["variables"]}
    rows = rows_below(chapter("23"), "## System variable index by number")
    check(len(rows) > 50, "chapter 23: the index of variables is not read")
    for cell, symbol, allowed, _ in rows:
        parts, ways = cell.split(";"), allowed.replace("/", "").split("; ")
        for i, part in enumerate(parts):
            way = ways[min(i, len(ways) - 1)]
            for first, last in re.findall(r"#(\d+)(?:–#(\d+))?", part):
                numbers = range(int(first), int(last or first) + 1)
                if len(numbers) > 1000 or first in ("120001", "120061"):  # rotations: ten numbers a system, three are used
                    numbers = (numbers[0], numbers[-1])
                wrong = [n for n in numbers if access.get(n) != way]
                check(not wrong, f"#{first}: not {way}, or no row: {wrong[:3]}")
        for name in re.findall(r"#_([A-Z_]+\d*[A-Z]*)", symbol):
            family = re.sub(r"\d+$", "", name)
            check(name in symbols or family in symbols, f"#_{name}: no row")


def check_alarms():
    there = {row.get("number") for row in CONTROL["alarms"].values()}
    seen = set()
    for page in sorted(SPEC.glob("*.md")):
        for line in page.read_text(encoding="utf-8").splitlines():
            if match := re.match(r"\| (\d{4}) \|", line):
                number = int(match[1])
                seen.add(number)
                check(number in there or number in NO_ALARM_YET, f"alarm {number} of {page.name}: not in [alarms]")
    check(len(seen) > 40, "spec/nct: the tables of alarms are not read")


def main():
    check_codes()
    check_variables()
    check_alarms()
    for failure in failures:
        print("  " + failure)
    print(f"{passed} passed, {len(failures)} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
