// How many segments this browser draws in a picture without a delay: measured by the graphics card's own fences. Fewer
// while something moves, more at rest.
export interface Bounds {
  least: number;
  first: number;
  most: number;
  wanted: number;
} // segments; ms a picture may take

// Without a graphics card a segment costs some thousand times as much.
export const soft_moving: Bounds = { least: 20_000, first: 40_000, most: 200_000, wanted: 35 };
export const soft_resting: Bounds = { least: 30_000, first: 120_000, most: 300_000, wanted: 90 };
export const soft_pixels = 50; // of a line, which take as long as a segment: SwiftShader on two cores, 0.9 µs and 17 ns
export const card_moving: Bounds = { least: 50_000, first: 500_000, most: 2_000_000, wanted: 14 };
export const card_resting: Bounds = { least: 200_000, first: 1_500_000, most: 3_000_000, wanted: 50 };

export class Pace {
  budget: number;
  constructor(private b: Bounds) {
    this.budget = b.first;
  }

  /// A picture of `segments` took `ms`. The budget decreases at once and increases slowly, and only if it limited the
  /// picture.
  took(ms: number, segments: number): void {
    const { least, most, wanted } = this.b;
    if (ms > 1.4 * wanted && segments > least)
      this.budget = Math.max(least, Math.min(this.budget, segments * Math.max(0.4, wanted / ms)));
    else if (ms < 0.5 * wanted && segments > this.budget / 3) this.budget = Math.min(most, this.budget * 1.1);
  }
}

/// Names of renderers that draw by the processor alone.
export const draws_softly = (renderer: string): boolean => /swiftshader|llvmpipe|software|basic render/i.test(renderer);

/// Reports after each picture how long the card took for it: at most one is measured at a time.
export class Stopwatch {
  private fence: WebGLSync | null = null;
  constructor(
    private gl: WebGL2RenderingContext,
    private told: (ms: number, segments: number, fine: boolean) => void,
  ) {}

  start(segments: number, fine: boolean): void {
    if (this.fence) return;
    this.fence = this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.gl.flush();
    const begin = performance.now();
    const look = (): void => {
      if (!this.fence) return;
      const state = this.gl.clientWaitSync(this.fence, 0, 0),
        ms = performance.now() - begin;
      if (state === this.gl.TIMEOUT_EXPIRED && ms < 5000) {
        setTimeout(look, 3);
        return;
      }
      this.gl.deleteSync(this.fence);
      this.fence = null;
      if (state !== this.gl.WAIT_FAILED) this.told(ms, segments, fine);
    };
    setTimeout(look, 3);
  }
}
