#!/usr/bin/env python3
"""Tests a user's own control file: when it is loaded, what the engine cannot do is refused by name; the rest runs. Run: python3
tests/own_control.py

Refusals are a table of files and of what the message must name. Then each function of config/control/function.h is laid over each control, with
a program that uses its code: Kadr refuses it (status 2, with file, line, row and function), runs the program (0) or finds faults (1).
"""
import argparse
import pathlib
import random
import re
import subprocess
import sys
import tempfile

from harness import TIME_LIMIT_S

ROOT = pathlib.Path(__file__).resolve().parent.parent
BASES = ["gost", "s2c42", "mach3", "correctors", "nct"]
HEAD = 'id = "mine"\nname = { en = "x", ru = "x" }\n'

# extends, the rest of the file, what the message must contain
REFUSED = [
    # These once ended in a segmentation fault.
    ("gost", "[grammar]\nmacro = true\nexpressions = true\nvariables = 999\n", ["own.toml:5: ", "macro", "machine of the NCT"]),
    ("nct", 'dialect = "iso"\n', ["own.toml:4: ", "macro", "dialect"]),
    ("mach3", '[g]\n"68" = { does = "plane_rotation_on", takes = "XYR" }\n', ["own.toml:5: ", "G68", "'plane_rotation_on'", "machine of the NCT"]),
    ("gost", '[m]\n"30" = { does = "call_program", takes = "P" }\n', ["own.toml:5: ", "M30", "'call_program'"]),
    ("gost", '[address]\nE = { does = "rapid" }\n', ["own.toml:5: ", "E: ", "'rapid'", "[g] or [m]"]),
    ("mach3", '[g]\n"200" = { does = "speed_word", group = "1" }\n', ["own.toml:5: ", "G200", "'speed_word'", "[address]"]),
    ("mach3", '[defaults]\nend = ["M2"]\n', ["own.toml:5: ", "M2", "no mode"]),
    ("mach3", '[cycle.G200]\nsteps = ["peck_full", "retract"]\nneeds = "ZR"\n[g]\n"200" = { does = "cycle", takes = "XYZRQ" }\n', ["own.toml:6: ", "G200", "Q"]),
    ("gost", '[g]\n"54" = { arg = 900 }\n', ["own.toml:5: ", "G54", "'work_zero'", "0 to 99"]),
    ("mach3", '[axes]\nnames = ["X", "Y", "Z", "A", "B", "C", "U"]\n', ["own.toml:5: ", "axis U", "[address]"]),
    ("gost", "".join(f"[groups.own{i}]\n" for i in range(60)), ["own.toml:", "groups"]),
    # Combinations of settings that the engine does not support.
    ("nct", '[g]\n"17" = { does = "plane_xy" }\n', ["own.toml:5: ", "G17", "'plane_xy'", "machine of the NCT"]),
    ("nct", "dialect = \"correctors\"\n", ["own.toml:4: ", "dialect"]),
    ("mach3", '[grammar]\nformal_parameter = "R"\n', ["own.toml:5: ", "formal_parameter", "R"]),
    ("mach3", "[grammar]\nprogram_start_required = true\n", ["percent_ignored", "program_start_required"]),
    ("gost", "[behaviour]\nsubprograms_by_section = true\n", ["own.toml:5: ", "subprograms_by_section", "[grammar] section"]),
    ("fanuc", "[behaviour]\nrounds_words = false\n", ["own.toml:5: ", "rounds_words", "[grammar] least_increments"]),
    ("fanuc", "[behaviour]\ncommon_cleared = false\n", ["own.toml:5: ", "common_cleared", "N6001#6"]),
    ("mach3", "[behaviour]\narc_radius_difference = [0.01, -1.0]\n", ["own.toml:5: ", "arc_radius_difference"]),
    ("fanuc", '[behaviour]\ncycle_words = "q"\n', ["own.toml:5: ", "cycle_words must be one of shift_by_ijk"]),
    ("gost", "dialect = \"correctors\"\n", ["own.toml:4: ", "correctors", "L"]),
    ("correctors", '[m]\n"98" = { does = "call_subprogram", takes = "P" }\n', ["own.toml:5: ", "M98", "'call_subprogram'", "label"]),
    ("gost", '[g]\n"10" = { does = "set_data", takes = "LPXYZ" }\n', ["G10", "'set_data'", "fixture"]),
    ("mach3", "[grammar]\nvariables = 999\n", ["beyond"]),
    ("s2c42", "[behaviour]\narc_radius_difference = nan\n", ["own.toml:5: ", "arc_radius_difference"]),
    # M functions by a table, and the codes that programs are written with.
    ("mach3", '[convert]\nM27 = "M8"\n', ["own.toml:5: ", "M27", "'machine_function'"]),
    ("fanuc", '[convert]\nM8 = "M27"\n', ["own.toml:5: ", "M8", "'machine_function'"]),
    ("haas", '[convert]\nM88 = "coolant"\n', ["own.toml:5: ", "M88", "an M code"]),
    ("haas", '[convert]\nM88 = { fanuc = 8 }\n', ["own.toml:5: ", "M88", "an M code"]),
    ("haas", '[convert]\nM88 = { mine = "M8" }\n', ["own.toml:5: ", "this control itself"]),
    ("haas", '[convert]\nM88 = { nct = "M8" }\nM51 = { nct = "M8" }\n', ["own.toml:", "M51", "M88", "way back"]),
    ("haas", 'convert = "M8"\n', ["own.toml:4: ", "convert must be a table"]),
    ("haas", 'encoding = "koi9"\n', ["own.toml:4: ", "encoding", "koi8-r"]),
    ("haas", 'encoding = 8\n', ["own.toml:4: ", "encoding must be a text"]),
    # Unknown keys that were formerly accepted without a message.
    ("gost", "[grammar]\nmacros = true\n", ["own.toml:5: ", "unknown key 'macros'", "nearest: 'macro'"]),
    ("gost", "[behavior]\n", ["own.toml:4: ", "unknown key 'behavior'", "nearest: 'behaviour'"]),
    ("gost", "[behaviour]\nfeed_maximum = 3\narc_center = 3\n", ["unknown behaviour 'arc_center'", "nearest: 'arc_centers'"]),
    ("gost", '[g]\n"04" = { take = "P" }\n', ["own.toml:5: ", "unknown key 'take'", "nearest: 'takes'"]),
    ("gost", '[g]\n"04" = { does = "dwel" }\n', ["own.toml:5: ", "unknown function 'dwel'", "nearest: 'dwell'"]),
    ("gost", '[g]\n"04" = { group = 1 }\n', ["own.toml:5: ", "group must be a text"]),
    ("gost", '[g]\n"04" = { takes = "p" }\n', ["own.toml:5: ", "takes"]),
    ("gost", '[g]\n"01" = { with = "G2" }\n', ["own.toml:5: ", "with must be a list"]),
    ("gost", '[g]\n"01" = { with = [""] }\n', ["own.toml:5: ", "with"]),
    ("gost", '[g]\n"01" = { arg = 3 }\n', ["own.toml:5: ", "G1", "`arg` has no effect", "'linear'"]),
    ("gost", 'behaviour = 3\n', ["own.toml:4: ", "behaviour must be a table"]),
    ("gost", '[grammar]\nend_of_block = "lines"\n', ["own.toml:5: ", "end_of_block"]),
    ("gost", "[grammar]\nvariables = 999\n", ["own.toml:5: ", "variables has no effect"]),
    ("gost", '[grammar]\nparameters_in = "X"\n', ["own.toml:5: ", "parameters_in has no effect"]),
    ("correctors", "[grammar]\nmost_codes = { Y = 3, Q = 2 }\n", ["own.toml:5: ", "no address Q"]),
    ("correctors", "[behaviour]\nprobe_least_distance = 1\n", ["own.toml:5: ", "probe_least_distance has no effect"]),
    ("correctors", "[behaviour]\ndelayed_assignment = true\n", ["own.toml:5: ", "delayed_assignment has no effect"]),
    ("nct", "[behaviour]\nreference_feed = 100\n", ["own.toml:5: ", "reference_feed has no effect"]),
    ("gost", '[address]\nP = { second = true }\n', ["own.toml:5: ", "second", "corrector_word"]),
    ("gost", '[address]\nE = { does = "feed_word" }\n', ["own.toml:5: ", "E: ", "'feed_word' is a word F"]),
    ("gost", '[address]\nE = { does = "axis", unit = "length" }\n', ["own.toml:5: ", "E: ", "needs `axis`"]),
    ("gost", '[address]\nE = { does = "axis", axis = "X", unit = "length" }\n', ["own.toml:5: ", "axis X", "word E already"]),
    ("gost", '[address]\nX = { unit = "mm" }\n', ["own.toml:5: ", "unit: length or angle"]),
    ("gost", '[feed_codes]\nF7 = 100\n', ["own.toml:5: ", "feed_codes"]),
    ("gost", '[axes]\ndiameter = ["Q"]\n', ["own.toml:5: ", "diameter: no such axis"]),
    ("gost", '[axes]\ndiameter = "X"\n', ["own.toml:5: ", "diameter"]),
    ("nct", '[axes]\ndiameter = ["X"]\n', ["own.toml:5: ", "diameter has no effect", "machine of the NCT"]),
    ("gost", '[axes]\nname = ["X"]\n', ["own.toml:5: ", "unknown key 'name'", "names"]),
    # Settings without effect: they repeat another one, or nothing reads them.
    ("gost", '[g]\n"04" = { takes = "P" }\n', ["own.toml:5: ", "[g] 04 has no effect", "says the same"]),
    ("gost", '[g]\n"90" = { takes = "P" }\n', ["own.toml:5: ", "G90: `takes` has no effect", "'absolute'"]),
    ("fanuc", '[g]\n"80" = { takes = "*" }\n', ["own.toml:5: ", "G80: `takes` has no effect", "'drilling_off'"]),
    ("s2c42", "[grammar]\nblock_number_required = true\n", ["own.toml:5: ", "[grammar] block_number_required has no effect"]),
    ("mach3", "[behaviour]\ndwell_unit = \"milliseconds\"\n", ["own.toml:5: ", "`dwell_unit` has no effect", "machine of the NCT"]),
    ("correctors", "[behaviour]\nprobe_in_inverse_time = true\n", ["own.toml:5: ", "probe_in_inverse_time has no effect", "'probe'"]),
    ("gost", 'aliases = ["shop", "shop"]\n', ["own.toml:4: ", "'shop' stands twice"]),
    ("gost", 'aliases = ["shop"]\n', ["own.toml:4: ", "aliases have no effect"]),
    ("gost", 'aliases = ["emc2"]\n', ["own.toml:4: ", "'emc2' is the name of another control: linuxcnc"]),
    ("gost", 'aliases = ["Shop 7"]\n', ["own.toml:4: ", "'Shop 7' is not a name"]),
    ("gost", "[guess]\nM51 = 99\n", ["own.toml:5: ", "[guess] M51"]),
    ("gost", "[guess.text]\nall_number = 1\n", ["own.toml:5: ", "unknown key 'all_number'", "nearest: 'all_numbered'"]),
    ("mach3", '[[variables]]\nis = "home"\nfrom = 5161\ncount = 6\naccess = "R"\n', ["own.toml:8: ", "`access` has no effect"]),
]

# Files that must be accepted.
ACCEPTED = [
    ("gost", ""),
    ("s2c42", ""),
    ("mach3", ""),
    ("correctors", ""),
    ("nct", ""),
    ("gost", '[grammar]\nexpressions = true\nvariables = 999\n'),
    ("gost", '[m]\n"51" = { does = "machine_function", phase = "clamp", en = "on", ru = "вкл" }\n'),
    ("mach3", '[behaviour]\nfixtures = 6\n'),
    ("nct", '[behaviour]\nfurther_systems = 300\n'),
    ("fanuc", '[[variables]]\nis = "modal_group"\nranges = [[4012, 1]]\nfirst = 14\naccess = "R"\nen = "work system"\nru = "система координат"\n'),
    ("gost", '[cycle.G81]\nsteps = ["feed_bottom", "retract"]\nneeds = "ZR"\n[groups]\nown = {}\n[g]\n"81" = { group = "own", does = "cycle", takes = "XYZR" }\n'),
    ("nct", "[behaviour]\narc_radius_difference = 0.02\n"),
    ("gost", "[behaviour]\nfeed_most = 3000\narc_radius_word = true\n"),
    ("s2c42", "[behaviour]\nfeed_most = 3000\n[alarms]\nzero_change = false\n"),
    ("s2c42", "[grammar]\nblock_number_required = false\n"),
]

PROGRAM = """%
N1 G300 X1 Y2 Z3
N2 G300
N3 X5 Y1
N4 G300 P1 L2 R3 Q1 I1 J1 K1 F100 S100 H1 D1
N5 G1 X5 F100
N6 G300 X2
N7 M300 P1
N8 G2 X1 I1 J1
N9 E300
N10 G300 A1 B2 C3
N11 M2
"""


def functions():
    text = (ROOT / "src/config/control/function.h").read_text(encoding="utf-8")
    body = re.search(r"#define KADR_FUNCTIONS\(X\)((?:.*\\\n)*.*)", text)[1]
    return [re.split(r",\s*", row)[0] for row in re.findall(r"X\(([^)]*)\)", body)]


def phases():
    text = (ROOT / "src/config/control/function.h").read_text(encoding="utf-8")
    body = re.search(r"#define KADR_PHASES\(X\)((?:.*\\\n)*.*)", text)[1]
    return [p for p in re.findall(r"X\((\w+)\)", body) if p != "none"]


class Runner:
    def __init__(self, kadr, folder):
        self.kadr, self.folder, self.failures, self.counts = kadr, folder, [], {}

    def run(self, base, rest, program=PROGRAM):
        control, nc = self.folder / "own.toml", self.folder / "own.nc"
        control.write_text(HEAD + f'extends = "{base}"\n' + rest, encoding="utf-8")
        nc.write_text(program, encoding="utf-8")
        try:
            done = subprocess.run([self.kadr, "check", "own.nc", "--control", "./own.toml"], cwd=self.folder, capture_output=True, timeout=TIME_LIMIT_S)
        except subprocess.TimeoutExpired:
            return -99, "it never ends"
        return done.returncode, (done.stdout + done.stderr).decode("utf-8", "replace")

    def fail(self, what, base, rest, text):
        self.failures.append(f"{what}: extends {base}\n{rest}  {text.strip()[:600]}\n")

    def refused(self, base, rest, names):
        status, text = self.run(base, rest)
        missing = [n for n in names if n not in text]
        if status != 2 or missing:
            self.fail(f"status {status}, not named: {missing}", base, rest, text)

    def accepted(self, base, rest):
        status, text = self.run(base, rest)
        if status not in (0, 1):
            self.fail(f"status {status}", base, rest, text)

    def laid_over(self, base, function, takes):
        row = f'{{ does = "{function}", takes = "{takes}" }}'
        phase = ", ".join(f'"{p}"' for p in phases())
        rest = f'[order]\nphases = [{phase}]\n[g]\n"300" = {row}\n'
        status, text = self.run(base, rest)
        self.counts[status] = self.counts.get(status, 0) + 1
        if status == 2 and not re.search(r"\w+\.toml:\d+: .*G300: .*'" + function + "'", text) and not re.search(r"takes: no address|no \[cycle\.G300\]", text):
            self.fail("a refusal that does not say what", base, rest, text)
        if status not in (0, 1, 2):
            self.fail(f"status {status}", base, rest, text)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--kadr", default=str(ROOT / "build/release/kadr"))
    parser.add_argument("--every", type=int, default=4, help="tests every Nth pair of function and control")
    args = parser.parse_args()
    random.seed(15)
    with tempfile.TemporaryDirectory(prefix="kadr_own_control_") as folder:
        runner = Runner(str(pathlib.Path(args.kadr).resolve()), pathlib.Path(folder))
        for base, rest, names in REFUSED:
            runner.refused(base, rest, names)
        for base, rest in ACCEPTED:
            runner.accepted(base, rest)
        pairs = [(base, function) for function in functions() for base in BASES]
        for base, function in pairs[:: args.every]:
            runner.laid_over(base, function, random.choice(["XYZ", "XYZR", "P", "", "*", "IJKR", "XYZIJKRPQLFSTDH"]))
    for failure in runner.failures:
        print(failure)
    print(f"own control: {len(REFUSED)} refusals, {len(ACCEPTED)} files accepted, functions by status {runner.counts}, "
          f"{len(runner.failures)} failed")
    return 1 if runner.failures else 0


if __name__ == "__main__":
    sys.exit(main())
