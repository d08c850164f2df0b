// Maps a scroll position to lines and back, where all lines together are higher than a browser allows an element to
// be.
export const greatest_height = 8_000_000; // px: Firefox stops at some 17.9 million, Chromium at 33.5; both halved by zooming in

export class ScrollMap {
  constructor(
    readonly lines: number,
    readonly row: number,
    readonly view: number,
  ) {}

  /// px of all lines, without the limit.
  get whole(): number {
    return this.lines * this.row;
  }
  /// px height of the scrolled element.
  get height(): number {
    return Math.min(Math.max(this.whole, this.view), greatest_height);
  }
  get scaled(): boolean {
    return this.whole > greatest_height;
  }

  /// Returns the px of the whole at the upper edge, for a scroll position; and the reverse.
  top_of(scroll: number): number {
    return this.scaled ? scroll * this.ratio : scroll;
  }
  scroll_of(top: number): number {
    return this.scaled ? top / this.ratio : top;
  }
  bounded(top: number): number {
    return Math.min(Math.max(top, 0), Math.max(0, this.whole - this.view));
  }

  /// First line (from 1) and number of lines that are visible, even in part.
  seen(top: number): { first: number; count: number } {
    const first = Math.floor(top / this.row) + 1;
    const last = Math.min(this.lines, Math.ceil((top + this.view) / this.row));
    return { first, count: Math.max(0, last - first + 1) };
  }

  /// Returns the `top` at which a line is visible: unchanged if it is visible already, else with the line in the
  /// middle.
  top_showing(line: number, top: number): number {
    const y = (line - 1) * this.row;
    if (y >= top && y + this.row <= top + this.view) return top;
    return this.bounded(y - (this.view - this.row) / 2);
  }

  private get ratio(): number {
    return (this.whole - this.view) / Math.max(1, this.height - this.view);
  }
}
