import {
  BufferAttribute, DynamicDrawUsage, GLSL3, InstancedBufferGeometry, InstancedInterleavedBuffer, InterleavedBufferAttribute,
  type IUniform, Mesh, ShaderMaterial, Vector2, type Vector3,
} from 'three';
import type { Light } from './batch';
import type { Colour } from './theme';

const vertexShader = /* glsl */ `
precision highp float;
uniform vec2 size;
uniform float width;
uniform float pixelRatio;
uniform float now;
in vec3 a;
in vec3 b;
in vec2 times;
in vec4 tint;
out float vAcross;
out float vHalf;
out vec4 vTint;
out vec3 vWorld;

void main() {
  vec4 from = projectionMatrix * viewMatrix * vec4(a, 1.0);
  vec4 to = projectionMatrix * viewMatrix * vec4(b, 1.0);
  // Both ends in front of the eye, or the direction on the screen would be wrong.
  float near = 0.01;
  if (from.w < near && to.w < near) { gl_Position = vec4(0.0, 0.0, 2.0, 1.0); return; }
  if (from.w < near) from = mix(to, from, (to.w - near) / (to.w - from.w));
  if (to.w < near) to = mix(from, to, (from.w - near) / (from.w - to.w));
  vec2 along = (to.xy / to.w - from.xy / from.w) * size;
  float length = max(length(along), 1e-6);
  vec2 normal = vec2(-along.y, along.x) / length;
  vHalf = 0.5 * width * pixelRatio;
  vAcross = position.y * (vHalf + 1.0);
  vec4 here = position.x < 0.5 ? from : to;
  here.xy += normal * vAcross * 2.0 / size * here.w;
  vTint = vec4(tint.rgb, (position.x < 0.5 ? times.x : times.y) <= now ? tint.a : tint.a * 0.45);
  vWorld = position.x < 0.5 ? a : b;
  gl_Position = here;
}
`;

const fragmentShader = /* glsl */ `
precision highp float;
uniform float section;
in float vAcross;
in float vHalf;
in vec4 vTint;
in vec3 vWorld;
out vec4 colour;

void main() {
  if (vWorld.z > section) discard;
  colour = vec4(vTint.rgb, vTint.a * clamp(vHalf + 0.5 - abs(vAcross), 0.0, 1.0));
}
`;

/** Numbers of a segment: both ends (m), the times at which it is passed (s), colour with opacity. */
const stride = 12;

/** Straight pieces of lines as wide as `width` pixels of the page, in one draw call. What comes after `now` is faint. */
export class Strokes {
  readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  /** Pixels of the picture. */
  readonly size = new Vector2(1, 1);
  private readonly now: IUniform<number> = { value: 1e30 };
  private numbers: number[] = [];
  private capacity = 0;

  constructor(light: Light, width: number) {
    const uniforms = { ...light, size: { value: this.size }, width: { value: width }, now: this.now };
    this.mesh = new Mesh(new InstancedBufferGeometry(), new ShaderMaterial({
      glslVersion: GLSL3, vertexShader, fragmentShader, uniforms, transparent: true, depthWrite: false, side: 2,
    }));
    this.mesh.geometry.setAttribute('position', new BufferAttribute(new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0]), 3));
    this.mesh.geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.mesh.frustumCulled = false;
    this.mesh.matrixAutoUpdate = false;
    this.mesh.renderOrder = 3;
    this.mesh.visible = false;
  }

  setNow(time: number): void {
    this.now.value = time;
  }

  clear(): void {
    this.numbers = [];
  }

  add(a: Vector3, b: Vector3, colour: Colour, opacity = 1, from = -1e30, to = -1e30): void {
    this.numbers.push(a.x, a.y, a.z, b.x, b.y, b.z, from, to, ...colour, opacity);
  }

  /** Shows what has been added since the last `clear`. */
  flush(): void {
    const count = this.numbers.length / stride;
    const { geometry } = this.mesh;
    if (count > this.capacity) {
      this.capacity = Math.max(64, 2 * count);
      const buffer = new InstancedInterleavedBuffer(new Float32Array(this.capacity * stride), stride);
      buffer.setUsage(DynamicDrawUsage);
      const members: [string, number, number][] = [['a', 3, 0], ['b', 3, 3], ['times', 2, 6], ['tint', 4, 8]];
      for (const [name, size, offset] of members) {
        geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, size, offset));
      }
    }
    if (count > 0) {
      const { data } = geometry.getAttribute('a') as InterleavedBufferAttribute;
      data.array.set(this.numbers);
      data.needsUpdate = true;
    }
    geometry.instanceCount = count;
    this.mesh.visible = count > 0;
  }
}
