import { BufferAttribute, BufferGeometry, GLSL3, Mesh, ShaderMaterial, Vector3 } from 'three';
import type { Theme } from './theme';

/** What is behind everything: a soft run of colour, drawn last and only where nothing else is. */
export class Sky {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;

  constructor() {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    this.mesh = new Mesh(geometry, new ShaderMaterial({
      glslVersion: GLSL3,
      depthWrite: false,
      uniforms: { top: { value: new Vector3() }, below: { value: new Vector3() } },
      vertexShader: 'out float height; void main() { height = 0.5 + 0.5 * position.y; gl_Position = vec4(position.xy, 1.0, 1.0); }',
      fragmentShader: `precision highp float; uniform vec3 top; uniform vec3 below; in float height; out vec4 colour;
        void main() { colour = vec4(mix(below, top, smoothstep(0.1, 1.0, height)), 1.0); }`,
    }));
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 1;
  }

  setTheme(theme: Theme): void {
    this.mesh.material.uniforms.top.value.set(...theme.skyTop);
    this.mesh.material.uniforms.below.value.set(...theme.skyBelow);
  }
}
