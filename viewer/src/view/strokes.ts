import {
  BufferAttribute, BufferGeometry, DynamicDrawUsage, GLSL3, InterleavedBuffer, InterleavedBufferAttribute, type IUniform, Mesh,
  ShaderMaterial, Vector2, type Vector3,
} from 'three';
import type { Light } from './batch';
import type { Colour } from './theme';

const vertexShader = /* glsl */ `
precision highp float;
uniform vec2 size;
uniform float width;
uniform float pixelRatio;
uniform float now;
uniform float ahead;
in vec2 corner;
in vec3 a;
in vec3 b;
in vec2 times;
in vec4 tint;
out float vAcross;
out float vHalf;
out vec4 vTint;
out vec3 vWorld;

// By what share of its distance a line counts as nearer to the eye than it is: one in a face is seen before it from however far (depths have 24 bits), one
// behind a wall is not.
const float nearer = 0.001;

vec4 projected(vec3 p) {
  vec4 seen = viewMatrix * vec4(p, 1.0);
  return projectionMatrix * vec4(seen.xyz * (1.0 - nearer), 1.0);
}

// The depth of a point beside a line that lies flat, as of a ribbon on the ground: or the half of it towards the eye would be below. Seen at a low angle a
// ribbon of some pixels is metres wide: no more of it than this share of its distance comes nearer, or it would come out before a wall.
const float mostNearer = 0.004;

float flatDepth(vec4 middle, vec2 aside) {
  vec2 scale = vec2(projectionMatrix[0][0], projectionMatrix[1][1]);
  vec3 up = viewMatrix[2].xyz;
  float height = dot(up, vec3(middle.xy / scale, -middle.w));
  if (abs(height) < 1e-3 * middle.w) return middle.z;
  float inverse = clamp(1.0 / middle.w + dot(up.xy, aside / scale) / height, 0.5 / middle.w, (1.0 + mostNearer) / middle.w);
  return (projectionMatrix[3][2] * inverse - projectionMatrix[2][2]) * middle.w;
}

void main() {
  vec4 from = projected(a);
  vec4 to = projected(b);
  // Both ends in front of the eye, or the direction on the screen would be wrong.
  float near = 0.01;
  if (from.w < near && to.w < near) { gl_Position = vec4(0.0, 0.0, 2.0, 1.0); return; }
  if (from.w < near) from = mix(to, from, (to.w - near) / (to.w - from.w));
  if (to.w < near) to = mix(from, to, (from.w - near) / (from.w - to.w));
  vec2 along = (to.xy / to.w - from.xy / from.w) * size;
  float length = max(length(along), 1e-6);
  vec2 normal = vec2(-along.y, along.x) / length;
  vHalf = 0.5 * width * pixelRatio;
  vAcross = corner.y * (vHalf + 1.0);
  vec4 here = corner.x < 0.5 ? from : to;
  vec2 aside = normal * vAcross * 2.0 / size;
  if (abs(a.z - b.z) < 1e-4) here.z = flatDepth(here, aside);
  here.xy += aside * here.w;
  vTint = vec4(tint.rgb, (corner.x < 0.5 ? times.x : times.y) <= now ? tint.a : tint.a * ahead);
  vWorld = corner.x < 0.5 ? a : b;
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

/** Numbers of a corner: which it is, both ends of its piece (m), the times at which they are passed (s), colour with opacity. */
const members: [name: string, size: number, offset: number][] =
  [['corner', 2, 0], ['a', 3, 2], ['b', 3, 5], ['times', 2, 8], ['tint', 4, 10]];
const stride = 14;
const corners = [[0, -1], [1, -1], [1, 1], [0, 1]];

/** Straight pieces of lines as wide as `width` pixels of the page, in one draw call. What comes after `now` is faint. */
export class Strokes {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  /** Pixels of the picture. */
  readonly size = new Vector2(1, 1);
  private readonly now: IUniform<number> = { value: 1e30 };
  private numbers: number[] = [];
  private drawn = '';
  private buffer: InterleavedBuffer | null = null;

  /** `ahead`: how much of its opacity is left of what comes after `now`. */
  constructor(light: Light, width: number, ahead = 0.45) {
    const uniforms = { ...light, size: { value: this.size }, width: { value: width }, now: this.now, ahead: { value: ahead } };
    this.mesh = new Mesh(new BufferGeometry(), new ShaderMaterial({
      glslVersion: GLSL3, vertexShader, fragmentShader, uniforms, transparent: true, depthWrite: false, side: 2,
    }));
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

  /** Draws anew if `key` is another than the last time: it says all that the lines depend on. */
  redraw(key: string, draw: () => void): void {
    if (key === this.drawn) return;
    this.drawn = key;
    this.clear();
    draw();
    this.flush();
  }

  add(a: Vector3, b: Vector3, colour: Colour, opacity = 1, from = -1e30, to = -1e30): void {
    for (const corner of corners) {
      this.numbers.push(...corner, a.x, a.y, a.z, b.x, b.y, b.z, from, to, ...colour, opacity);
    }
  }

  /** Shows what has been added since the last `clear`. */
  flush(): void {
    const pieces = this.numbers.length / stride / 4;
    this.mesh.visible = pieces > 0;
    if (pieces === 0) return;
    if (!this.buffer || this.buffer.array.length < this.numbers.length) this.buffer = this.room(2 * pieces);
    this.buffer.array.set(this.numbers);
    this.buffer.needsUpdate = true;
    this.mesh.geometry.setDrawRange(0, 6 * pieces);
  }

  /** A buffer for so many pieces. */
  private room(pieces: number): InterleavedBuffer {
    const buffer = new InterleavedBuffer(new Float32Array(pieces * 4 * stride), stride);
    buffer.setUsage(DynamicDrawUsage);
    const geometry = new BufferGeometry();
    for (const [name, size, offset] of members) geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, size, offset));
    const triangles = new Uint32Array(6 * pieces);
    for (let i = 0; i < pieces; ++i) triangles.set([0, 1, 2, 0, 2, 3].map((corner) => 4 * i + corner), 6 * i);
    geometry.setIndex(new BufferAttribute(triangles, 1));
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
    return buffer;
  }
}
