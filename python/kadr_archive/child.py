"""The process in which Kadr works on programs, one after the other.

A program may run endlessly, take all memory, or end the process: the parent (children.py) then ends or replaces this process, and no result
of another program is lost. Requests and results are pickled and preceded by their length; parent and child are the same program.
"""
from __future__ import annotations

import os
import pickle
import resource
import signal
import struct
import sys
import threading
import time
from typing import Any, BinaryIO, Optional

LENGTH = struct.Struct('<Q')
NO_MEMORY = 77   # exit status after a program that needs more memory than allowed


def write(to: BinaryIO, value: Any) -> None:
    content = pickle.dumps(value, protocol=pickle.HIGHEST_PROTOCOL)
    to.write(LENGTH.pack(len(content)))
    to.write(content)
    to.flush()


def read(source: BinaryIO) -> Optional[Any]:
    """Returns the next value; None at the end, also in the middle of a value: the other side has died."""
    head = source.read(LENGTH.size)
    if len(head) < LENGTH.size:
        return None
    content = source.read(LENGTH.unpack(head)[0])
    return pickle.loads(content) if len(content) == LENGTH.unpack(head)[0] else None


def end_with_parent(parent: int) -> None:
    """Ends this process soon after its parent has died, also in the middle of a program."""
    def watch() -> None:
        while os.getppid() == parent:
            time.sleep(0.5)
        from .work import remove_folders
        remove_folders(os.getpid())
        os.killpg(0, signal.SIGKILL)   # with the program kadr, if one runs
    threading.Thread(target=watch, daemon=True).start()


def main() -> None:
    requests, results = sys.stdin.buffer, os.fdopen(os.dup(1), 'wb')
    os.dup2(2, 1)   # what Kadr or Python prints does not get into the results
    end_with_parent(int(sys.argv[1]))
    from .work import build, done
    job = read(requests)
    if job is None:
        return
    write(results, build())
    used = int(open('/proc/self/statm').read().split()[5]) * resource.getpagesize() if os.path.exists('/proc/self/statm') else 0
    resource.setrlimit(resource.RLIMIT_DATA, (used + job.most_bytes, used + job.most_bytes))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    try:
        while (item := read(requests)) is not None:
            write(results, done(item, job))
    except MemoryError:
        os._exit(NO_MEMORY)   # what is left of the program is not trusted with the next one


if __name__ == '__main__':
    main()
