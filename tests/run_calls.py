#!/usr/bin/env python3
"""Tests which files may be called (nct 14.4.2; Kadr's own rule: numbers in other forms). Run: python3 tests/run_calls.py

Reading stays within the main program's folder and the folder of --files: no links out of them, no pipes, no devices. Files with the same
number are reported. The search order: docs/controls/nct-notes.md.
"""
import os
import sys
import tempfile

import harness

SUB = "#100=5\nM99\n"


class Memory(harness.Kadr):
    """A folder with the program memory `work/` and other files next to it."""

    def __init__(self, program, folder):
        super().__init__(program, folder)
        self.tally, self.work = harness.Tally(), self.folder / "work"
        for name in ("outside.nc", "library/O0020.nc", "library/00021.nc"):
            self.file(name, SUB)

    def expect(self, what, program, wanted, *options):
        """Runs the program; the messages must contain `wanted`; None: there must be no fault."""
        self.file("work/main.nc", program + "\nM30\n")
        done = self.call("run", "main.nc", "--control", "nct", "-q", *options, cwd=self.work)
        text = done.stdout + done.stderr
        holds = (done.returncode == 0) == (wanted is None) and (wanted is None or wanted in text)
        self.tally.expect(holds, what, f"status {done.returncode}, wanted {wanted}\n{text}")


def main():
    with tempfile.TemporaryDirectory(prefix="kadr_run_calls_") as folder:
        m = Memory(harness.kadr_of(__doc__), folder)
        m.expect("a file above the program", "M98 <..\\outside.nc>", "file_outside")
        m.expect("the password file", "M98 <" + "..\\" * 12 + "etc\\passwd>", "file_outside")
        m.expect("a file of --files", "M98 <..\\library\\O0020.nc>", None, "--files", "../library")
        m.expect("beside --files", "M98 <..\\outside.nc>", "file_outside", "--files", "../library")
        os.symlink("../outside.nc", m.work / "link.nc")
        m.expect("a link out of the folder", "M98 <link.nc>", "file_outside")
        os.symlink("../outside.nc", m.work / "O0030.nc")
        m.expect("a link out of the folder, by number", "M98 P30", "file_outside")
        (m.work / "inside.nc").write_text(SUB)
        os.symlink("inside.nc", m.work / "O0031.nc")
        m.expect("a link within the folder", "M98 P31", None)
        os.mkfifo(m.work / "pipe.nc")
        os.mkfifo(m.work / "O0032.nc")
        m.expect("a pipe", "M98 <pipe.nc>", "file_missing")
        m.expect("a pipe by number", "M98 P32", "program_missing")
        m.expect("a number of --files", "M98 P20", "program_missing")
        m.expect("a number of --files, named", "M98 P21", None, "--files", "../library")
        (m.work / "O00040.nc").write_text(SUB)
        m.expect("another form of the number", "M98 P40", None)
        (m.work / "040.nc").write_text(SUB)
        m.expect("two of them", "M98 P40", "label_twice")
        (m.work / "first.nc").write_text(":41\n" + SUB)
        m.expect("a number in the text", "M98 P41", None)
        (m.work / "second.nc").write_text("%\nO0041\n" + SUB)
        m.expect("two numbers in the text", "M98 P41", "label_twice")
        (m.work / "O1.nct").write_text(SUB)
        m.expect("14.4.1: O1.nct is no number", "M98 P1", "program_missing")
        (m.work / "O0042.prg").write_text("O0042\n" + SUB)
        m.expect("14.4.2: another extension", "M98 P42", "program_missing")
    return m.tally.result()


if __name__ == "__main__":
    sys.exit(main())
