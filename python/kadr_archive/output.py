"""Writes converted programs into a folder."""
from __future__ import annotations

import os
from pathlib import Path
from typing import Sequence

from . import places
from .store import WITH_RESULT, Store


def write_all(store: Store, job: int, sources: Sequence[places.Source], out: Path) -> int:
    """Writes every proven program under its own name, in the same sub-folder; with several sources, each in a folder of its own.

    A file with the same content is left alone. Returns how many were written."""
    written = 0
    for number, source in enumerate(sources, 1):
        root = out.resolve() / (f'{number}-{Path(source.name).name}' if len(sources) > 1 else '')
        for folder, name, output in store.rows(f'SELECT p.folder, p.name, r.output FROM places p {WITH_RESULT} WHERE p.until IS NULL AND p.source = :source '
                                               'AND r.output IS NOT NULL', {'job': job, 'source': source.name}):
            file = Path(os.path.normpath(root / places.as_path(folder + name)))
            if root != file and root not in file.parents:
                continue   # a name in a zip file that leads out of the folder
            if file == Path(source.on_disk(folder, name) or ''):
                raise OSError(f'{file}: would be overwritten by its own conversion; --out names another folder')
            if file.is_file() and file.read_bytes() == output:
                continue
            file.parent.mkdir(parents=True, exist_ok=True)
            part = file.with_name(f'.{file.name}.part')
            part.write_bytes(output)
            os.replace(part, file)
            written += 1
    return written
