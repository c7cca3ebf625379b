import { Color, ColorManagement, LinearSRGBColorSpace, type PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { Quality } from './quality';
import { mixed, type Theme } from './theme';

// Colours are the screen's own from the theme to the pixel; nothing converts them.
ColorManagement.enabled = false;

/** Stripes that the sky is made of: filling a stripe costs next to nothing, shading every pixel does not. */
const skyStripes = 48;

/** The canvas and what draws on it: only when something changed, coarser while that is too slow, once at its finest when it rests. */
export class Stage {
  readonly scene = new Scene();
  readonly renderer: WebGLRenderer;
  private readonly quality = new Quality(() => devicePixelRatio);
  private ratio = 0;
  private width = 1;
  private height = 1;
  private dirty = true;
  private theme: Theme | null = null;
  private readonly stripe = new Color();

  /** Throws where there is no WebGL. `camera` is told of the size. */
  constructor(private readonly host: HTMLElement, readonly canvas: HTMLCanvasElement, private readonly camera: PerspectiveCamera,
              private readonly sized: (ratio: number, width: number, height: number) => void) {
    this.renderer = new WebGLRenderer({ canvas, antialias: false, powerPreference: 'high-performance' });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.info.autoReset = false;
    this.renderer.autoClearColor = false;
    new ResizeObserver(() => this.resize()).observe(host);
  }

  /** Something is not as it was drawn. */
  touch(): void {
    this.dirty = true;
  }

  /** Pictures a second while they follow each other, and what the last one took. */
  stats(): { fps: number; calls: number; triangles: number; pixelRatio: number } {
    const { calls, triangles } = this.renderer.info.render;
    return { fps: Math.round(10 * this.quality.rate) / 10, calls, triangles, pixelRatio: this.ratio };
  }

  /** Once a frame; `prepare` is called before something is drawn. */
  frame(now: number, prepare: () => void): void {
    if (this.width < 2 || this.height < 2) return;
    if (this.dirty) this.quality.moved(now);
    else if (!this.quality.rests(now)) return;
    this.dirty = false;
    this.sharpen(this.quality.ratio);
    prepare();
    this.renderer.info.reset();
    this.fillSky();
    this.renderer.render(this.scene, this.camera);
  }

  setTheme(theme: Theme): void {
    this.theme = theme;
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

  /** A soft run of colour from below to the top. */
  private fillSky(): void {
    const { renderer, theme, width, height } = this;
    if (!theme) return;
    renderer.setScissorTest(true);
    for (let i = 0; i < skyStripes; ++i) {
      const low = Math.floor((i * height) / skyStripes);
      const share = i / (skyStripes - 1);
      this.stripe.setRGB(...mixed(theme.skyBelow, theme.skyTop, share * share * (3 - 2 * share)));
      // A little higher than its share: the next covers what is too much, and no rounding leaves a gap.
      renderer.setScissor(0, low, width, height / skyStripes + 3);
      renderer.setClearColor(this.stripe, 1);
      renderer.clearColor();
    }
    renderer.setScissorTest(false);
  }

  private sharpen(ratio: number): void {
    if (ratio === this.ratio) return;
    this.ratio = ratio;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(this.width, this.height, false);
    this.sized(ratio, this.width, this.height);
  }
}
