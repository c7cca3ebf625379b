import { ColorManagement, LinearSRGBColorSpace, Matrix4, type PerspectiveCamera, Scene, Vector2, WebGLRenderer } from 'three';
import { Layers } from './layers';
import { Quality } from './quality';
import type { Theme } from './theme';

// Colours are the screen's own from the theme to the pixel; nothing converts them.
ColorManagement.enabled = false;

/** What drawing costs. */
export interface Stats {
  fps: number;
  calls: number;
  triangles: number;
  pixelRatio: number;
}

/**
 * The canvas and what draws on it: only when something changed, coarser while that is too slow, once at its finest when it
 * rests.
 */
export class Stage {
  /** What stays where it is from picture to picture, and what does not. */
  readonly still = new Scene();
  readonly moving = new Scene();
  readonly renderer: WebGLRenderer;
  private readonly quality = new Quality(() => devicePixelRatio);
  private ratio = 0;
  private width = 1;
  private height = 1;
  private dirty = true;
  private theme: Theme | null = null;
  private readonly layers: Layers;
  private stale = true;
  /** Of the still layer. */
  private cost = { calls: 0, triangles: 0 };
  /** From where the still layer was drawn. */
  private readonly seen = new Matrix4();
  private readonly seeing = new Matrix4();

  /** Throws where there is no WebGL. `camera` is told of the size. */
  constructor(private readonly host: HTMLElement, readonly canvas: HTMLCanvasElement, private readonly camera: PerspectiveCamera,
              private readonly sized: (ratio: number, width: number, height: number) => void) {
    this.renderer = new WebGLRenderer({ canvas, antialias: false, powerPreference: 'high-performance' });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.info.autoReset = false;
    this.renderer.autoClear = false;
    this.layers = new Layers(this.renderer);
    new ResizeObserver(() => this.resize()).observe(host);
  }

  /** Something is not as it was drawn. */
  touch(): void {
    this.dirty = true;
  }

  /** Something that stands still is not as it was drawn: in the next picture it is. */
  touchStill(): void {
    this.stale = true;
  }

  /** Pictures a second while they follow each other; draw calls and triangles of both layers. */
  stats(): Stats {
    const { calls, triangles } = this.renderer.info.render;
    return {
      fps: Math.round(10 * this.quality.rate) / 10, calls: calls + this.cost.calls,
      triangles: triangles + this.cost.triangles, pixelRatio: this.ratio,
    };
  }

  /** Once a frame; `prepare` is called before something is drawn. */
  frame(now: number, prepare: () => void): void {
    if (this.width < 2 || this.height < 2 || !this.theme) return;
    if (this.dirty) this.quality.moved(now);
    else if (!this.quality.rests(now)) return;
    this.dirty = false;
    this.sharpen(this.quality.ratio);
    prepare();
    const { camera } = this;
    camera.updateMatrixWorld();
    this.seeing.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const { info } = this.renderer;
    if (this.stale || !this.seeing.equals(this.seen)) {
      info.reset();
      this.layers.drawStill(this.still, camera, this.theme);
      this.cost = { calls: info.render.calls, triangles: info.render.triangles };
      this.stale = false;
      this.seen.copy(this.seeing);
    }
    info.reset();
    this.layers.drawMoving(this.moving, camera);
  }

  setTheme(theme: Theme): void {
    this.theme = theme;
    this.touchStill();
    this.touch();
  }

  resize(): void {
    const { clientWidth, clientHeight } = this.host;
    if (clientWidth === this.width && clientHeight === this.height) return;
    this.width = clientWidth;
    this.height = clientHeight;
    this.ratio = 0;
    this.touch();
  }

  private sharpen(ratio: number): void {
    if (ratio === this.ratio) return;
    this.ratio = ratio;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(this.width, this.height, false);
    const size = this.renderer.getDrawingBufferSize(new Vector2());
    this.layers.resize(size.x, size.y);
    this.stale = true;
    this.sized(ratio, this.width, this.height);
  }
}
