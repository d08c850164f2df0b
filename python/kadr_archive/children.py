"""Children: processes that work on programs, with limits of time and memory for each program."""
from __future__ import annotations

import os
import queue
import select
import signal
import subprocess
import sys
import threading
import time
from typing import Any, Callable, Iterable, Iterator, Optional

from . import child
from .work import Item, Job, remove_folders, result

BATCH = 64            # programs; their transport costs little, and a killed client loses little
DEATHS = 2            # a program that ends so many children is quarantined
START_SECONDS = 120   # a busy machine starts a child slowly
STARTS = 10           # attempts to start a child


class CannotWork(Exception):
    """No worker can be started."""


class WrongBuild(CannotWork):
    """A worker has another build of Kadr than the client: results would depend on who computes them."""


class Child:
    """One child process. It is started when it is needed, and again after a program has ended it."""

    def __init__(self, job: Job) -> None:
        self.job = job
        self.process: Optional[subprocess.Popen[bytes]] = None
        self.late = False   # the last program took longer than allowed

    def _start(self) -> subprocess.Popen[bytes]:
        """Starts the process. One that dies before it has a program is started again: no program is to blame."""
        for _ in range(STARTS):
            process = self._begin()
            assert process.stdin
            try:
                child.write(process.stdin, self.job)
                build = self._read(START_SECONDS)
            except BrokenPipeError:
                build = None
            if build is not None:
                break
            self.end()
        else:
            raise CannotWork('a process of kadr-archive does not start')
        if self.job.build and build != self.job.build:
            self.end()
            raise WrongBuild(f'a worker has Kadr {build}, this computer has {self.job.build}')
        return process

    def _begin(self) -> subprocess.Popen[bytes]:
        path = os.pathsep.join(filter(None, sys.path))   # the child imports the same modules
        self.process = subprocess.Popen([sys.executable, '-m', 'kadr_archive.child', str(os.getpid())], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        env={**os.environ, 'PYTHONPATH': path}, start_new_session=True)
        return self.process

    def _read(self, seconds: float) -> Optional[Any]:
        """Returns the next result; None if the child has died or takes longer. Then `late` says which."""
        assert self.process and self.process.stdout
        self.late = not select.select([self.process.stdout], [], [], seconds)[0]
        return None if self.late else child.read(self.process.stdout)

    def does(self, item: Item) -> Optional[dict[str, Any]]:
        """Works on one program. Returns None if the child has died."""
        process = self.process or self._start()
        assert process.stdin
        try:
            child.write(process.stdin, item)
            of = self._read(self.job.most_seconds)
        except BrokenPipeError:
            of, self.late = None, False
        if of is None:
            if self.end() == child.NO_MEMORY:
                return result(item, 'memory', f'more than {self.job.most_bytes >> 20} MB')
            if self.late:
                return result(item, 'time', f'longer than {self.job.most_seconds:g} s')
        return of

    def end(self) -> int:
        """Ends the process. Returns its exit status if it has ended by itself."""
        process, self.process = self.process, None
        if process is None:
            return 0
        for stream in (process.stdin, process.stdout):
            try:
                if stream:
                    stream.close()
            except BrokenPipeError:
                pass
        if not self.late:
            try:
                process.wait(1)   # without requests it ends
            except subprocess.TimeoutExpired:
                pass
        kill_group(process)
        process.wait()
        remove_folders(process.pid)
        return process.returncode


def kill_group(process: subprocess.Popen[bytes]) -> None:
    """Kills a child and the program kadr that it may run."""
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


def results_of(one: Child, items: Iterable[Item], stop: Callable[[], bool] = lambda: False) -> Iterator[dict[str, Any]]:
    """Yields the result of each program. One that ends a child is tried again in a new one; the second time it is quarantined."""
    for item in items:
        of = one.does(item)
        for _ in range(DEATHS - 1):
            if of is None and not stop():
                of = one.does(item)
        if stop():
            return
        yield of or killed(item)


def killed(item: Item) -> dict[str, Any]:
    return result(item, 'killed', f'ended {DEATHS} processes that worked on it; quarantined')


class Local:
    """Works with processes of this computer."""

    sees_files = True

    def batch_programs(self, todo: int) -> int:
        """Returns how many programs a batch has: the last batches keep all processes busy."""
        return max(1, min(BATCH, todo // (4 * self.workers)))

    def __init__(self, job: Job, workers: int) -> None:
        self.job = job
        self.workers = workers
        self.children = [Child(job) for _ in range(workers)]

    def results(self, batches: Iterator[list[Item]], stop: Callable[[], bool]) -> Iterator[list[dict[str, Any]]]:
        """Yields results in the order in which they are made. Each worker has one batch and another one in reserve."""
        todo: queue.Queue[Optional[list[Item]]] = queue.Queue(self.workers)
        made: queue.Queue[Any] = queue.Queue()
        threads = [threading.Thread(target=self._work, args=(one, todo, made, stop), daemon=True) for one in self.children]
        for thread in threads:
            thread.start()
        sent, waiting, more = 0, None, True
        try:
            while not stop():
                if waiting is None and more:
                    waiting = next(batches, None)
                    more = waiting is not None
                if waiting is not None:
                    try:
                        todo.put_nowait(waiting)
                        sent, waiting = sent + 1, None
                        continue
                    except queue.Full:
                        pass
                if not sent:
                    break
                try:
                    of = made.get(timeout=0.2)
                except queue.Empty:
                    continue
                if isinstance(of, BaseException):
                    raise of
                sent -= 1
                yield of
        finally:
            self._end(threads, todo, stop)

    def _end(self, threads: list[threading.Thread], todo: queue.Queue[Optional[list[Item]]], stop: Callable[[], bool]) -> None:
        """Waits for the threads; after an interruption their programs are given up."""
        ends = 0
        while any(thread.is_alive() for thread in threads):
            if stop():
                self.kill()
            if ends < len(threads):
                try:
                    todo.put_nowait(None)
                    ends += 1
                    continue
                except queue.Full:
                    pass
            for thread in threads:
                thread.join(0.1)

    def close(self) -> None:
        pass

    def kill(self) -> None:
        for one in self.children:
            if one.process:
                kill_group(one.process)

    @staticmethod
    def _work(one: Child, todo: queue.Queue[Optional[list[Item]]], made: queue.Queue[Any], stop: Callable[[], bool]) -> None:
        try:
            while (batch := todo.get()) is not None and not stop():
                made.put(list(results_of(one, batch, stop)))
        except BaseException as error:   # noqa: B902  the client's thread raises it
            made.put(error)
        finally:
            one.end()
