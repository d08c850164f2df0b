// The canvas and its drawing. Without a graphics card edges are smoothed only while nothing moves, as smoothing takes
// three times as long.
import {
  LinearSRGBColorSpace,
  Mesh,
  OrthographicCamera,
  PlaneGeometry,
  Scene as Stage,
  ShaderMaterial,
  WebGLRenderer,
  WebGLRenderTarget,
  type Camera,
  type Object3D,
} from "three";
import {
  card_moving,
  card_resting,
  draws_softly,
  Pace,
  soft_moving,
  soft_pixels,
  soft_resting,
  Stopwatch,
} from "./pace";
import { NoWebGl } from "./types";

const samples = 4; // per pixel, where edges are smoothed

export class Canvas {
  readonly renderer: WebGLRenderer;
  readonly element: HTMLCanvasElement;
  readonly soft: boolean; // no graphics card
  took = 0; // ms, for the last picture while something moved
  private moving: Pace;
  private resting: Pace;
  private watch: Stopwatch;
  private smooth = new WebGLRenderTarget(1, 1, { samples, stencilBuffer: false });
  private copy = new Stage();
  private flat = new OrthographicCamera(-1, 1, 1, -1, 0, 1);

  constructor() {
    this.element = document.createElement("canvas");
    // Edges are smoothed in `smooth`, when there is time.
    const context = this.element.getContext("webgl2", { antialias: false, powerPreference: "high-performance" });
    if (!context) throw new NoWebGl("this browser gives no WebGL");
    this.soft = draws_softly(renderer_name(context));
    this.renderer = new WebGLRenderer({ canvas: this.element, context });
    this.renderer.localClippingEnabled = true;
    this.renderer.outputColorSpace = LinearSRGBColorSpace; // colours appear as they are in the theme
    this.renderer.debug.checkShaderErrors = false; // a query would wait for the compiler
    this.moving = new Pace(this.soft ? soft_moving : card_moving);
    this.resting = new Pace(this.soft ? soft_resting : card_resting);
    this.watch = new Stopwatch(context, (ms, segments, fine) => {
      (fine ? this.resting : this.moving).took(ms, segments);
      if (!fine) this.took = ms;
    });
    const copied = new ShaderMaterial({
      uniforms: { picture: { value: this.smooth.texture } },
      depthTest: false,
      depthWrite: false,
      vertexShader: "varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }",
      fragmentShader:
        "uniform sampler2D picture; varying vec2 at; void main() { gl_FragColor = texture2D(picture, at); }",
    });
    const sheet = new Mesh(new PlaneGeometry(2, 2), copied);
    sheet.frustumCulled = false;
    this.copy.add(sheet);
  }

  /// How many pixels of a line cost as much as a segment: negligible with a graphics card.
  get pixels(): number {
    return this.soft ? soft_pixels : Infinity;
  }
  budget(fine: boolean): number {
    return (fine ? this.resting : this.moving).budget;
  }

  size(width: number, height: number): void {
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.setSize(width, height);
    this.smooth.setSize(this.element.width, this.element.height);
  }

  /// Compiles the shaders of these objects while nobody waits for them. Their materials must stay alive.
  prepare(stage: Stage, camera: Camera, objects: Object3D[]): void {
    stage.add(...objects);
    this.renderer.compile(stage, camera);
    this.renderer.compile(this.copy, this.flat);
    stage.remove(...objects);
  }

  /// `fine`: nothing moves, the picture may take longer.
  draw(stage: Stage, camera: Camera, fine: boolean, cost: number): void {
    const { renderer } = this;
    if (fine || !this.soft) {
      renderer.setRenderTarget(this.smooth);
      renderer.render(stage, camera);
      renderer.setRenderTarget(null);
      renderer.render(this.copy, this.flat);
    } else renderer.render(stage, camera);
    this.watch.start(cost, fine);
  }
}

function renderer_name(gl: WebGL2RenderingContext): string {
  const told = gl.getExtension("WEBGL_debug_renderer_info");
  return String(gl.getParameter(told ? told.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
}
