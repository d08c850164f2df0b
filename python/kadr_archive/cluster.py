"""Works with a Dask cluster: a scheduler that runs already, with workers on any computers that have this package."""
from __future__ import annotations

import logging
import queue
import threading
from pathlib import Path
from typing import Any, Callable, Iterator, NamedTuple, Optional

from .children import DEATHS, CannotWork, Child, killed, results_of
from .work import Item, Job

CONNECT_SECONDS = 30
MOST_BATCH = 1024     # programs: some seconds, which a worker that dies has lost
IN_FLIGHT = 3         # batches for each thread of the workers: one at work, the others on the way
MOST_ON_THE_WAY = 1 << 18   # programs in all batches that are sent: scheduler and client hold their texts, some 650 MB
SILENT_SECONDS = 120  # without any worker for so long the run ends; the next one goes on

own = threading.local()   # in a worker: the child of each thread


def do_batch(job: Job, items: list[Item]) -> list[dict[str, Any]]:
    """Works on a batch in a worker. Each thread has a child of its own, as on a computer without cluster."""
    if getattr(own, 'job', None) != job:
        if hasattr(own, 'child'):
            own.child.end()
        own.job, own.child = job, Child(job)
    return list(results_of(own.child, items))


def connect(scheduler: str, scheduler_file: Optional[Path]) -> tuple[Any, Any]:
    """Returns Dask's module and a client of the scheduler."""
    try:
        import distributed
    except ImportError:
        raise CannotWork('a cluster needs Dask: python3-distributed') from None
    logging.getLogger('distributed').setLevel(logging.ERROR)   # that a busy computer answers late is no message for the user
    logging.getLogger('asyncio').setLevel(logging.CRITICAL)   # nor that Dask gives up a wait of its own: what concerns a batch arrives with its future
    where = {'scheduler_file': str(scheduler_file)} if scheduler_file else {'address': scheduler}
    if scheduler_file and not scheduler_file.is_file():
        raise CannotWork(f'{scheduler_file}: no such file')
    try:
        return distributed, distributed.Client(timeout=CONNECT_SECONDS, set_as_default=False, name='kadr-archive', **where)
    except (OSError, ValueError) as error:
        raise CannotWork(f'{scheduler or scheduler_file}: {error}') from None


class Sent(NamedTuple):
    """A batch on its way, and how many workers have died with it."""

    items: list[Item]
    deaths: int


class Cluster:
    """Sends batches to the workers of a Dask scheduler. Dask repeats those of a lost worker elsewhere."""

    def __init__(self, job: Job, scheduler: str, scheduler_file: Optional[Path], sees_files: bool) -> None:
        self.job = job
        self.sees_files = sees_files
        self.distributed, self.client = connect(scheduler, scheduler_file)

    def batch_programs(self, todo: int) -> int:
        """Returns how many programs a batch has: scheduler and client need some milliseconds for each, a worker for each program."""
        threads = max(1, self.threads())
        return max(1, min(MOST_BATCH, todo // (20 * threads), MOST_ON_THE_WAY // (IN_FLIGHT * threads)))

    def threads(self) -> int:
        return sum(self.client.nthreads().values())

    def results(self, batches: Iterator[list[Item]], stop: Callable[[], bool]) -> Iterator[list[dict[str, Any]]]:
        """Yields the results of each batch once, in the order in which they arrive."""
        ready: queue.Queue[Any] = queue.Queue()
        sent: dict[Any, Sent] = {}
        again: list[Sent] = []
        more, quiet = True, 0.0
        room = IN_FLIGHT * max(1, self.threads())
        try:
            while not stop():
                while len(sent) < room and (again or more):
                    one = again.pop() if again else self._next(batches)
                    if one is None:
                        more = False
                        break
                    self._send(one, sent, ready)
                if not sent:
                    break
                try:
                    future = ready.get(timeout=0.5)
                except queue.Empty:
                    quiet = 0 if self.client.status == 'running' and self.threads() else quiet + 0.5
                    if quiet > SILENT_SECONDS:
                        raise CannotWork('the scheduler or its workers do not answer') from None
                    continue
                quiet = 0
                room = IN_FLIGHT * max(1, self.threads())
                yield from self._take(future, sent, again, ready)
        finally:
            self.client.cancel(list(sent), force=True)

    @staticmethod
    def _next(batches: Iterator[list[Item]]) -> Optional[Sent]:
        batch = next(batches, None)
        return Sent(batch, 0) if batch else None

    def _send(self, one: Sent, sent: dict[Any, Sent], ready: queue.Queue[Any]) -> None:
        future = self.client.submit(do_batch, self.job, one.items, pure=False)
        sent[future] = one
        future.add_done_callback(ready.put)

    def _take(self, future: Any, sent: dict[Any, Sent], again: list[Sent], ready: queue.Queue[Any]) -> Iterator[list[dict[str, Any]]]:
        """Yields the results of a future, or puts its programs back: a batch with which several workers have died is divided."""
        if future not in sent:
            return
        one = sent[future]
        try:
            made = future.result(timeout=5)
        except self.distributed.TimeoutError:
            ready.put(future)   # its worker died with the result, which Dask computes again
            return
        except self.distributed.KilledWorker:
            del sent[future]
            if len(one.items) > 1:
                again += [Sent([item], 0) for item in one.items]
            elif one.deaths + 1 < DEATHS:
                again.append(Sent(one.items, one.deaths + 1))
            else:
                yield [killed(one.items[0])]
            return
        except self.distributed.CancelledError:
            del sent[future]
            again.append(one)   # the scheduler has lost it: it was restarted
            return
        del sent[future]
        yield made

    def close(self) -> None:
        self.client.close()
