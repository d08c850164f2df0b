"""The progress bar on a terminal: tqdm, if it is installed."""
from __future__ import annotations

import sys
from typing import Any, Optional

from . import texts


class Bar:
    def __init__(self, quiet: bool) -> None:
        self.bar: Any = None
        self.made: Any = None
        if quiet or not sys.stderr.isatty():
            return
        try:
            from tqdm import tqdm
            self.made = tqdm
        except ImportError:
            pass

    def begin(self, what: str, total: Optional[int]) -> None:
        if self.made:
            self.bar = self.made(total=total, desc=texts.of(f'bar_{what}'), unit='', smoothing=0.05, leave=False)

    def add(self, count: int) -> None:
        if self.bar is not None:
            self.bar.update(count)

    def end(self) -> None:
        if self.bar is not None:
            self.bar.close()
            self.bar = None
