// An event and its listeners.
export class Signal<T> {
  private who = new Set<(value: T) => void>();
  on(f: (value: T) => void): () => void {
    this.who.add(f);
    return () => this.who.delete(f);
  }
  emit(value: T): void {
    for (const f of [...this.who]) f(value);
  }
}
