import { Color, type Object3D, type PerspectiveCamera, type WebGLRenderer, WebGLRenderTarget } from 'three';
import { mixed, type Theme } from './theme';

/** Stripes that the sky is made of: filling a stripe costs next to nothing, shading every pixel does not. */
const skyStripes = 64;

/**
 * Two pictures with their depths: what stands still, drawn only when it is not as it was, and what is shown: a copy of the
 * first with what moves drawn over it. So a picture costs what moves, however large the building is; copying is cheap even
 * without a graphics card.
 */
export class Layers {
  private readonly still = new WebGLRenderTarget();
  private readonly shown = new WebGLRenderTarget();
  private readonly stripe = new Color();

  constructor(private readonly renderer: WebGLRenderer) {}

  /** In pixels of the picture. */
  resize(width: number, height: number): void {
    for (const target of [this.still, this.shown]) target.setSize(width, height);
  }

  /** Draws what stands still, before the sky. */
  drawStill(scene: Object3D, camera: PerspectiveCamera, theme: Theme): void {
    this.fillSky(theme);
    this.renderer.setRenderTarget(this.still);
    this.renderer.render(scene, camera);
    this.renderer.setRenderTarget(null);
  }

  /** Draws what moves over it, and shows both. */
  drawMoving(scene: Object3D, camera: PerspectiveCamera): void {
    const { renderer } = this;
    const gl = renderer.getContext() as WebGL2RenderingContext;
    // Also makes the buffers of a target that has not been drawn to.
    renderer.setRenderTarget(this.shown);
    this.copy(this.still, this.shown, gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    renderer.render(scene, camera);
    renderer.setRenderTarget(null);
    this.copy(this.shown, null, gl.COLOR_BUFFER_BIT);
  }

  private copy(from: WebGLRenderTarget, to: WebGLRenderTarget | null, what: number): void {
    const { renderer } = this;
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const { width, height } = from;
    renderer.state.bindFramebuffer(gl.READ_FRAMEBUFFER, this.buffer(from));
    renderer.state.bindFramebuffer(gl.DRAW_FRAMEBUFFER, to && this.buffer(to));
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, what, gl.NEAREST);
    renderer.state.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
  }

  private buffer(target: WebGLRenderTarget): WebGLFramebuffer {
    return (this.renderer.properties.get(target) as { __webglFramebuffer: WebGLFramebuffer }).__webglFramebuffer;
  }

  /** A soft run of colour from below to the top. */
  private fillSky(theme: Theme): void {
    const { renderer, still } = this;
    for (let i = 0; i < skyStripes; ++i) {
      const low = Math.floor((i * still.height) / skyStripes);
      const share = i / (skyStripes - 1);
      still.scissorTest = true;
      still.scissor.set(0, low, still.width, Math.floor(((i + 1) * still.height) / skyStripes) - low);
      renderer.setRenderTarget(still);
      renderer.setClearColor(this.stripe.setRGB(...mixed(theme.skyBelow, theme.skyTop, share * share * (3 - 2 * share))), 1);
      renderer.clearColor();
    }
    still.scissorTest = false;
    renderer.setRenderTarget(still);
    renderer.clearDepth();
  }
}
