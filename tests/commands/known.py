"""Faults that are known and open, with the reason. They do not fail tests/every_command.py. Once one is fixed the test fails, so that its
row is removed."""
import collections
import dataclasses
import fnmatch
import re

import harness


@dataclasses.dataclass
class Open:
    check: str | list   # the checks that find it, by name (fnmatch): one pattern or several
    fault: str          # the message that the checks report (a regular expression)
    why: str

    def finds(self, what):
        return any(fnmatch.fnmatch(what, pattern) for pattern in ([self.check] if isinstance(self.check, str) else self.check))


OPEN = {}   # name → Open


class Tally(harness.Tally):
    """Counts the checks; a check that OPEN names is counted under its row."""

    def __init__(self, tell_open=False):
        super().__init__()
        self.looked_at, self.open, self.tell_open = set(), collections.Counter(), tell_open

    def judge(self, what, faults):
        rows = [(name, row) for name, row in OPEN.items() if row.finds(what)]
        known = {fault: [name for name, row in rows if re.search(row.fault, fault)] for fault in faults}
        with self.lock:
            self.looked_at |= {name for name, _ in rows}
            self.open.update({name for names in known.values() for name in names})
        left = [fault for fault, names in known.items() if not names]
        if self.tell_open:
            for fault in known.keys() - left:
                print(f'open {" ".join(known[fault])} {what}: {fault}', flush=True)
        if left or not known:
            super().judge(what, left)

    def result(self):
        for name, row in OPEN.items():
            if self.open[name]:
                print(f'open {name}: {self.open[name]} checks; {row.why}', flush=True)
            elif name in self.looked_at:
                super().judge(f'open {name}', ['it is found no more: its row in OPEN goes'])
        return super().result()
