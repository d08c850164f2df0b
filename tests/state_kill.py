#!/usr/bin/env python3
"""Kills a run with --state (SIGKILL) at random moments; the file must then contain the state after a completed block.

The program counts in #500, writes its double to #501 in the next block, three offsets in one block (G10), and changes tools; each
change is one use of a tool with life. So in the state that is found:
    #501 is even and at most 2·#500               two blocks; a run that starts again continues to count
    the three coordinates of G54 are the same     one block, after the two
    no tool is lost or doubled                    a change writes two entries in one block
and a run that starts from this state accepts it.
"""
import argparse
import json
import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from harness import TIME_LIMIT_S

KILLS = 200
PROGRAM = """O0001
WHILE[1EQ1] DO1
#500=#500+1
#501=#500*2
G10 L2 P1 X#500 Y#500 Z#500
T1 M6
T2 M6
END1
M30
"""
SETUP = {"tool_table": {str(n): {"T": n, "info": "SENCV", "status": 1, "counter": 0, "life": 1000000000} for n in (1, 2)},
         "place_table": {"1/1": 1, "1/2": 2, "10/1": 0}}


def state_of(kadr, folder):
    """Returns the last line of a run of an empty program with the state: the contents of the file."""
    empty = folder / "empty.nct"
    empty.write_text("#100=#500\nM30\n")
    done = subprocess.run([kadr, "run", empty, "--control", "nct", "--state", folder / "memory.state", "--trace", "-", "-q"],
                          capture_output=True, text=True, timeout=TIME_LIMIT_S)
    if done.returncode != 0:
        raise AssertionError(f"the state cannot be read: {done.stderr}")
    return json.loads(done.stdout.splitlines()[-1])


def check(last):
    """Checks that the state is one that a completed block leaves; returns #500."""
    count, double = last["variables"].get("#500", 0), last["variables"].get("#501", 0)
    if double % 2 != 0 or double > 2 * count:
        raise AssertionError(f"#500 = {count}, #501 = {double}")
    if count == 0 and "tool_table" not in last["state"]:
        return 0  # killed before the first block was complete
    zero = last["state"].get("work_offsets", {}).get("G54", {"X": 0, "Y": 0, "Z": 0})
    if len(set(zero.values())) != 1 or zero["X"] > double / 2:
        raise AssertionError(f"G54 {zero} behind #500 = {count}")
    tools, places = last["state"]["tool_table"], last["state"]["place_table"]
    lying = [row for row in places.values() if row != 0]
    if sorted(lying) != [1, 2]:
        raise AssertionError(f"places {places}: a tool is lost or doubled")
    uses = [tools[n]["counter"] for n in ("1", "2")]
    if not 0 <= uses[0] - uses[1] <= KILLS:  # a run that starts again changes to T1 once more
        raise AssertionError(f"uses {uses}, places {places}: not those of completed blocks")
    return count


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kadr", required=True)
    parser.add_argument("--kills", type=int, default=KILLS)
    options = parser.parse_args()
    kadr = str(Path(options.kadr).resolve())
    choice = random.Random(12)
    with tempfile.TemporaryDirectory(prefix="kadr_state") as name:
        folder = Path(name)
        program, setup = folder / "count.nct", folder / "setup.json"
        program.write_text(PROGRAM)
        setup.write_text(json.dumps(SETUP))
        begin = time.monotonic()
        (folder / "empty.nct").write_text("M30\n")
        subprocess.run([kadr, "run", folder / "empty.nct", "--control", "nct", "-q"], capture_output=True)  # measures how long a start takes here
        start = time.monotonic() - begin
        before = 0
        for n in range(options.kills):
            # The set-up is applied before the state: it counts only until something is saved.
            command = [kadr, "run", program, "--control", "nct", "--state", folder / "memory.state", "-q"]
            run = subprocess.Popen(command + (["--setup", setup] if before == 0 else []), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            time.sleep(choice.uniform(0.005, max(0.06, 2 * start)))
            run.send_signal(signal.SIGKILL)
            run.wait()
            try:
                count = check(state_of(kadr, folder))
                if count < before:
                    raise AssertionError(f"#500 went back from {before} to {count}")
            except (AssertionError, KeyError) as fault:
                print(f"kill {n + 1}: {fault!r}\n0 passed, 1 failed")
                return 1
            before = count
    if before == 0:
        print("nothing was saved in all runs\n0 passed, 1 failed")
        return 1
    print(f"{options.kills} kills, {int(before)} passes\n1 passed, 0 failed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
