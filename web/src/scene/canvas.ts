// The canvas and how a picture gets onto it. Without a graphics card edges are smoothed only while nothing moves: that costs three times the time.
import { LinearSRGBColorSpace, Mesh, OrthographicCamera, PlaneGeometry, Scene as Stage, ShaderMaterial, WebGLRenderer, WebGLRenderTarget, type Camera } from "three";
import { card_moving, card_resting, draws_softly, Pace, soft_moving, soft_resting, Stopwatch } from "./pace";
import { NoWebGl } from "./types";

const samples = 4; // of each pixel, where edges are smoothed

export class Canvas {
  readonly renderer: WebGLRenderer;
  readonly element: HTMLCanvasElement;
  readonly soft: boolean;            // no graphics card
  private moving: Pace;
  private resting: Pace;
  private watch: Stopwatch;
  private smooth = new WebGLRenderTarget(1, 1, { samples, stencilBuffer: false });
  private copy = new Stage();
  private flat = new OrthographicCamera(-1, 1, 1, -1, 0, 1);

  constructor() {
    this.element = document.createElement("canvas");
    this.soft = draws_softly(renderer_name());
    const context = this.element.getContext("webgl2", { antialias: !this.soft, powerPreference: "high-performance" });
    if (!context) throw new NoWebGl("this browser gives no WebGL");
    this.renderer = new WebGLRenderer({ canvas: this.element, context });
    this.renderer.localClippingEnabled = true;
    this.renderer.outputColorSpace = LinearSRGBColorSpace; // colours go to the screen as they stand in the theme
    this.renderer.debug.checkShaderErrors = false; // asking waits for the compiler
    this.moving = new Pace(this.soft ? soft_moving : card_moving);
    this.resting = new Pace(this.soft ? soft_resting : card_resting);
    this.watch = new Stopwatch(context, (ms, segments, fine) => (fine ? this.resting : this.moving).took(ms, segments));
    const copied = new ShaderMaterial({
      uniforms: { picture: { value: this.smooth.texture } }, depthTest: false, depthWrite: false,
      vertexShader: "varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }",
      fragmentShader: "uniform sampler2D picture; varying vec2 at; void main() { gl_FragColor = texture2D(picture, at); }",
    });
    const sheet = new Mesh(new PlaneGeometry(2, 2), copied);
    sheet.frustumCulled = false;
    this.copy.add(sheet);
  }

  budget(fine: boolean): number { return (fine ? this.resting : this.moving).budget; }

  size(width: number, height: number): void {
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.setSize(width, height);
    if (this.soft) this.smooth.setSize(this.element.width, this.element.height);
  }

  /// `fine`: nothing moves, the picture may take longer.
  draw(stage: Stage, camera: Camera, fine: boolean, segments: number): void {
    const { renderer } = this;
    if (this.soft && fine) {
      renderer.setRenderTarget(this.smooth);
      renderer.render(stage, camera);
      renderer.setRenderTarget(null);
      renderer.render(this.copy, this.flat);
    } else renderer.render(stage, camera);
    this.watch.start(segments, fine);
  }
}

/// Asked of a canvas that is thrown away: whether edges are smoothed must be said when a canvas is made.
function renderer_name(): string {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return "";
  const told = gl.getExtension("WEBGL_debug_renderer_info"), name = String(gl.getParameter(told ? told.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return name;
}
