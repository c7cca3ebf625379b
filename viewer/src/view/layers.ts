import {
  AlwaysDepth, BufferAttribute, BufferGeometry, Color, DepthTexture, GLSL3, Mesh, type Object3D, type PerspectiveCamera, ShaderMaterial,
  type WebGLRenderer, WebGLRenderTarget,
} from 'three';
import { mixed, type Theme } from './theme';

/** Stripes that the sky is made of: filling a stripe costs next to nothing, shading every pixel does not. */
const skyStripes = 64;

const vertexShader = 'void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }';
const fragmentShader = /* glsl */ `
precision highp float;
uniform sampler2D picture;
uniform highp sampler2D depths;
out vec4 colour;
void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  colour = texelFetch(picture, here, 0);
  gl_FragDepth = texelFetch(depths, here, 0).r;
}
`;

/**
 * What stands still is drawn, with its depths, into a picture of its own, only when it is not as it was; what moves is drawn over a copy
 * of that. So a picture costs what moves, however large the building is. (One pass copies both: without a graphics card it takes a
 * third of the time that framebuffers take to be copied one after the other.)
 */
export class Layers {
  private readonly still = new WebGLRenderTarget(1, 1, { depthTexture: new DepthTexture(1, 1) });
  private readonly copy: Mesh;
  private readonly stripe = new Color();

  constructor(private readonly renderer: WebGLRenderer) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    const uniforms = { picture: { value: this.still.texture }, depths: { value: this.still.depthTexture } };
    this.copy = new Mesh(geometry, new ShaderMaterial({
      glslVersion: GLSL3, vertexShader, fragmentShader, uniforms, depthFunc: AlwaysDepth,
    }));
    this.copy.frustumCulled = false;
  }

  /** In pixels of the picture. */
  resize(width: number, height: number): void {
    this.still.setSize(width, height);
  }

  /** Draws what stands still, before the sky. */
  drawStill(scene: Object3D, camera: PerspectiveCamera, theme: Theme): void {
    this.fillSky(theme);
    this.renderer.render(scene, camera);
    this.renderer.setRenderTarget(null);
  }

  /** Shows it, and draws what moves over it. */
  drawMoving(scene: Object3D, camera: PerspectiveCamera): void {
    this.renderer.render(this.copy, camera);
    this.renderer.render(scene, camera);
  }

  /** A soft run of colour from below to the top. */
  private fillSky(theme: Theme): void {
    const { renderer, still } = this;
    still.scissorTest = true;
    for (let i = 0; i < skyStripes; ++i) {
      const low = Math.floor((i * still.height) / skyStripes);
      const share = i / (skyStripes - 1);
      still.scissor.set(0, low, still.width, Math.floor(((i + 1) * still.height) / skyStripes) - low);
      renderer.setRenderTarget(still);
      renderer.setClearColor(this.stripe.setRGB(...mixed(theme.skyBelow, theme.skyTop, share * share * (3 - 2 * share))), 1);
      renderer.clearColor();
    }
    still.scissorTest = false;
    still.scissor.set(0, 0, still.width, still.height);
    renderer.setRenderTarget(still);
    renderer.clearDepth();
  }
}
