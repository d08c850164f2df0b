#!/usr/bin/env python3
"""Gives every kind of file that the command line reads the wrong content: each run ends soon with a message, in little memory, and leaves
the file unchanged.

    set-up, control, machine, state, contour   x   too deep, too long, binary, UTF-16, NUL bytes, empty, a directory, a device, a pipe …
    kadr state check and recover               sound, damaged, no state, in use, nothing overwritten; in both languages
"""
import json
import os
import resource
import sqlite3
import subprocess
import sys
from pathlib import Path

import harness
from harness import expect as need

MEMORY = 600 << 20  # bytes of address space: a file has at most 16 MB
PROGRAM = "O0001\nG10 L2 P1 X-40\n#500=7\n#501=8\n#502=9\nG0 X1\nM30\n"

# The content written into a file of each type, and what the message must contain.
ANY = {
    "utf-16": ('{"tool": 1}\n'.encode("utf-16"), "UTF-16"),
    "nul": (b'{"tool"\0: 1}', ":1:8: a NUL byte"),
    "binary": (bytes(range(1, 256)) * 50, ":1:"),
    "long": (b" " * ((16 << 20) + 1), "longer than 16 MiB"),
}
JSON = {
    "deep": (b"[" * 5_000_000, ":1:33: more than 32 brackets"),
    "deep-tables": (b'{"a":' * 1_000_000, ":1:161: more than 32 brackets"),
    "many": (b"[" + b"1," * 8_000_000 + b"1]", "more than 500000 values"),
    "twice": (b'{"tool": 1,\n "tool": 2}', ":2:2: the key 'tool' stands twice"),
    "nan": (b'{"feed": NaN}', ":1:10: 'NaN' is no number"),
    "infinity": (b'{"feed": Infinity}', ":1:10: 'Infinity' is no number"),
    "great": (b'{"feed": 1e999}', ":1:10: 1e999 is too great"),
    "cut": (b'{"feed": 10', ":1:12: the text ends"),
    "comma": (b'{"feed": 10,\r\n}', ":2:1: a comma before '}'"),
    "acceleration": (b'{"machine": {"X": {"acceleration": 1e-300}}}', "acceleration"),
    "rapid": (b'{"machine": {"X": {"rapid": -1}}}', "rapid"),
    "limits": (b'{"machine": {"X": {"limits": [5, 5]}}}', "limits"),
    "empty": (b"", ":1:1: the text ends"),
}
TOML = {
    "dotted": (b"a" + b".a" * 50_000 + b" = 1", ":1:32: a key of more than 16 parts"),
    "heading": (b"[a" + b".a" * 50_000 + b"]", ":1:33: a key of more than 16 parts"),
    "arrays": (b"a = " + b"[" * 100_000, ":1:37: more than 32 brackets"),
    "tables": (b"a = " + b"{b=" * 100_000, "more than 32 brackets"),
    "many": (b"a = [" + b"1," * 8_000_000 + b"]", "more than 200000 values"),
    "cut": (b"id = 'a'\nx = [1,\n", ":2:9: "),
    "twice": (b"id = 'a'\nid = 'b'\n", ":2:"),
    "empty": (b"", "id is missing"),
}
MACHINE = {
    "acceleration": (b"id = 'a'\n[axes]\nX = { acceleration = 1e-300 }\n", ":3: acceleration must be"),
    "nan": (b"id = 'a'\n[axes]\nX = { rapid = nan }\n", ":3: rapid must be"),
    "limits": (b"id = 'a'\n[axes]\nX = { limits = [inf, -inf] }\n", ":3: limits must be"),
}
CONTROL = {
    "scale": (b"id = 'a'\nextends = 'gost'\n[address]\nF = { scale = nan }\n", ":4: scale must be"),
    "device": (b"id = 'a'\nextends = '/dev/zero'\n", "is a device, not a file"),
}
STATE = {
    "empty": (b"", "is empty: no state file"),
    "program": (PROGRAM.encode(), "no state file of Kadr"),
    "binary": (b"\x7fELF" + bytes(5000), "no state file of Kadr"),
    "magic": (b"SQLite format 3\0" + bytes(5000), "no state file of Kadr"),
}


class Kadr(harness.Kadr):
    def __init__(self, program, folder):
        super().__init__(program, folder)
        self.nct = self.file("p.nc", PROGRAM)

    def call(self, *words, **more):
        limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        return super().call(*words, **{"preexec_fn": limit, **more})

    def refused(self, option, path, sentence, language="en"):
        control = [] if option == "--control" else ["--control", "nct"]
        command = ["run", self.nct, *control, option, path, "-q", "--lang", language]
        if option == "mill":
            command = ["mill", "pocket", path, "--tool-diameter", 8, "--depth", 1, "--control", "nct", "--output", self.folder / "out.nc"]
        done = self.call(*command)
        what = f"{option} {Path(path).name}: status {done.returncode}, {done.stderr.strip()[:300]!r}"
        need(done.returncode in ([1, 2] if option == "mill" else [2]), what)
        need(sentence in done.stderr, f"{what}, wanted {sentence!r}")
        need("json.exception" not in done.stderr, what)


def check_contents(kadr):
    for option, ending, cases in (("--setup", ".json", ANY | JSON), ("--machine", ".toml", ANY | TOML | MACHINE),
                                  ("--control", ".toml", ANY | TOML | CONTROL), ("--state", ".state", STATE)):
        for name, (content, sentence) in cases.items():
            path = kadr.folder / (name + ending)
            path.write_bytes(content)
            kadr.refused(option, path, sentence)
            need(path.read_bytes() == content, f"{option} {name}: was changed")
            path.unlink()
    for name, content in (("utf-16", '{"tool": 1}\n'.encode("utf-16")), ("binary", bytes(range(256)) * 50), ("empty", b""),
                          ("deep", b"<svg>" + b"<g>" * 1_000_000), ("long", b"\n" * ((16 << 20) + 1))):
        path = kadr.folder / (name + ".txt")
        path.write_bytes(content)
        kadr.refused("mill", path, ": ")
        path.unlink()


def check_kinds(kadr):
    """A directory, a device, a pipe: refused at once, with a message."""
    pipe, directory, none = kadr.folder / "pipe.toml", kadr.folder / "d.toml", kadr.folder / "none.toml"
    os.mkfifo(pipe)
    directory.mkdir()
    device = kadr.folder / "zero.toml"
    device.symlink_to("/dev/zero")
    for option in ("--setup", "--machine", "--control", "--state", "mill"):
        kadr.refused(option, pipe, "is a pipe, not a file")
        kadr.refused(option, directory, "is a directory, not a file")
        kadr.refused(option, device, "is a device, not a file")
        if option not in ("--state", "mill"):
            kadr.refused(option, none, "cannot be read: there is no such file")
    kadr.refused("--setup", pipe, "это канал (FIFO), а не файл", "ru")
    kadr.refused("--state", directory, "это каталог, а не файл", "ru")


def check_russian(kadr):
    path = kadr.folder / "r.json"
    path.write_text('{"tool": 1,}')
    kadr.refused("--setup", path, "r.json:1:12: запятая перед '}'", "ru")
    path = kadr.folder / "r.toml"
    path.write_text("id = 'a'\n[axes]\nX = { acceleration = -1 }\n")
    kadr.refused("--machine", path, "r.toml:3: acceleration: должно быть число от 0.001", "ru")


def check_state(kadr):
    file, new = kadr.folder / "shop.state", kadr.folder / "new.state"
    run = ["run", kadr.nct, "--control", "nct", "--state", file, "-q"]
    done = kadr.call(*run)
    need(done.returncode == 0 and file.exists(), f"run --state: {done.stderr}")
    done = kadr.call("state", "check", file)
    need(done.returncode == 0 and "sound: control nct, " in done.stdout, f"check: {done}")
    sound = file.read_bytes()
    with sqlite3.connect(file) as base:
        base.execute("PRAGMA journal_mode = DELETE")
        base.execute("UPDATE state SET value = -41.0 WHERE key = 'G54/X'")
    base.close()
    damaged = file.read_bytes()
    done = kadr.call("state", "check", file)
    need(done.returncode == 1 and "work_offsets G54/X: its checksum does not fit, it holds -41" in done.stdout, f"check: {done}")
    done = kadr.call("state", "check", file, "--lang", "ru")
    need(done.returncode == 1 and "work_offsets G54/X: контрольная сумма не сходится, записано -41" in done.stdout, f"check: {done}")
    done = kadr.call(*run)
    need(done.returncode == 2 and "is damaged: work_offsets G54/X" in done.stderr, f"run: {done}")
    done = kadr.call("state", "recover", file, "--out", new)
    need(done.returncode == 1 and "G54/X" in done.stdout, f"recover: {done}")
    need(file.read_bytes() == damaged, "a damaged file was changed")
    kept = new.read_bytes()
    done = kadr.call("state", "recover", file, "--out", new)
    need(done.returncode == 2 and "is there already" in done.stderr and new.read_bytes() == kept, f"recover again: {done}")
    done = kadr.call("state", "recover", file, "--out", file)
    need(done.returncode == 2 and file.read_bytes() == damaged, f"recover over itself: {done}")
    done = kadr.call("state", "check", new)
    need(done.returncode == 0, f"check of the new one: {done}")
    empty = kadr.folder / "empty.nc"
    empty.write_text("O0002\nM30\n")
    done = kadr.call("run", empty, "--control", "nct", "--state", new, "--trace", "-", "-q")
    last = json.loads(done.stdout.splitlines()[-1])
    need(last["variables"]["#500"] == 7 and "X" not in last["state"].get("work_offsets", {}).get("G54", {}), f"recovered: {last}")
    file.write_bytes(sound)
    with open("/dev/full", "w") as full:
        done = kadr.call("state", "check", file, stdout=full)
    need(done.returncode == 2, "check to a full disk")
    for path in (kadr.folder / "nothing", kadr.folder, "/dev/zero"):
        need(kadr.call("state", "check", path).returncode == 2, f"check {path}")
        need(kadr.call("state", "recover", path, "--out", kadr.folder / "x").returncode == 2, f"recover {path}")
    need(not (kadr.folder / "x").exists(), "recover wrote something out of nothing")


def check_two_at_once(kadr):
    """A second run, and a check, while a run uses the file."""
    file, loop = kadr.folder / "two.state", kadr.folder / "loop.nc"
    loop.write_text("O0003\nWHILE[1EQ1] DO1\n#500=#500+1\nEND1\nM30\n")
    endless = ("run", loop, "--control", "nct", "--state", file, "-q", "--max-blocks", 10**12)
    first = kadr.start(*endless, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    need(harness.until(lambda: file.exists() and "is in use" in kadr.call("state", "check", file).stderr), "the first run does not take the file")
    done = kadr.call("run", kadr.nct, "--control", "nct", "--state", file, "-q")
    need(done.returncode == 2 and "is in use by another process" in done.stderr, f"second run: {done}")
    done = kadr.call("state", "check", file)
    need(done.returncode == 2 and "is in use by another process" in done.stderr, f"check in use: {done}")
    first.kill()
    first.wait()
    done = kadr.call("state", "check", file)  # with the log that the killed run left
    need(done.returncode == 0, f"check behind a kill: {done}")


if __name__ == "__main__":
    sys.exit(harness.main(__doc__, globals(), Kadr, jobs=1))  # preexec_fn allows no other threads
