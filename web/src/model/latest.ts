// Keeps only the newest request: one is in progress, at most one waits, those in between are dropped.
export class Latest<T> {
  private busy = false;
  private next: T | undefined;
  constructor(private work: (wish: T) => Promise<void>) {}

  want(wish: T): void {
    this.next = wish;
    if (!this.busy) void this.run();
  }
  /// A newer request waits, so the result being fetched is already out of date.
  get stale(): boolean {
    return this.next !== undefined;
  }

  private async run(): Promise<void> {
    this.busy = true;
    while (this.next !== undefined) {
      const wish = this.next;
      this.next = undefined;
      try {
        await this.work(wish);
      } catch {
        /* lost or refused: the next request is sent again */
      }
    }
    this.busy = false;
  }
}

/// Calls `f` once, `ms` after the last call; if calls never pause, every `longest` ms.
export function debounce<A extends unknown[]>(ms: number, f: (...a: A) => void, longest = Infinity): (...a: A) => void {
  let timer: ReturnType<typeof setTimeout> | undefined,
    since = 0;
  return (...a) => {
    const now = Date.now();
    if (timer === undefined) since = now;
    else clearTimeout(timer);
    timer = setTimeout(
      () => {
        timer = undefined;
        f(...a);
      },
      Math.max(0, Math.min(ms, since + longest - now)),
    );
  };
}

/// Calls `f` at most once per `ms`, and always after the last call.
export function spaced(ms: number, f: () => void): () => void {
  let waiting = false;
  return () => {
    if (waiting) return;
    waiting = true;
    setTimeout(() => {
      waiting = false;
      f();
    }, ms);
  };
}
