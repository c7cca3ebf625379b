import { Box3, Matrix4, Vector3 } from 'three';

/** Grows as numbers are appended. */
class Numbers<T extends Float32Array | Int8Array | Uint32Array> {
  length = 0;
  constructor(private values: T, private readonly make: (length: number) => T) {}

  push(...numbers: number[]): void {
    if (this.length + numbers.length > this.values.length) {
      const grown = this.make(2 * this.values.length);
      grown.set(this.values);
      this.values = grown;
    }
    this.values.set(numbers, this.length);
    this.length += numbers.length;
  }

  done(): T {
    return this.values.subarray(0, this.length) as T;
  }
}

const floats = () => new Numbers(new Float32Array(1 << 12), (n) => new Float32Array(n));
const bytes = () => new Numbers(new Int8Array(1 << 12), (n) => new Int8Array(n));
const whole = () => new Numbers(new Uint32Array(1 << 12), (n) => new Uint32Array(n));

/**
 * The triangles of many elements in one. Each corner has a place in its element's frame (m), a normal (127 is 1), the number of its element
 * and four `rim` numbers: where one of them is 127 or -127 an edge runs that is drawn as a line. Between corners they run
 * linearly, so that a shader sees how far from the edges a point is.
 */
export class Surface {
  /** The number of the element that is added to. */
  element = 0;
  /** From the frame of the next faces to the element's. */
  frame = new Matrix4();
  /** By element, in its own frame. */
  readonly bounds: Box3[] = [];
  private readonly positions = floats();
  private readonly normals = bytes();
  private readonly rims = bytes();
  private readonly elements = floats();
  private readonly corners = whole();
  private readonly point = new Vector3();
  private readonly direction = new Vector3();

  get triangles(): number {
    return this.corners.length / 3;
  }

  arrays(): { positions: Float32Array; normals: Int8Array; rims: Int8Array; elements: Float32Array; corners: Uint32Array } {
    return { positions: this.positions.done(), normals: this.normals.done(), rims: this.rims.done(), elements: this.elements.done(),
      corners: this.corners.done() };
  }

  /**
   * Four corners, counter-clockwise from outside, from left below. `u`: lines at its left and right; `v`: below and above.
   */
  quad(points: Vector3[], normals: Vector3[], lines: { u: boolean; v: boolean }): void {
    const first = this.elements.length;
    const u = lines.u ? [-127, 127, 127, -127] : [0, 0, 0, 0];
    const v = lines.v ? [-127, -127, 127, 127] : [0, 0, 0, 0];
    for (let i = 0; i < 4; ++i) this.corner(points[i], normals[i], u[i], v[i], 0);
    this.corners.push(first, first + 1, first + 2, first, first + 2, first + 3);
  }

  /** Three corners; `lines[i]`: the side opposite corner i is an edge. */
  triangle(points: Vector3[], normals: Vector3[], lines: boolean[]): void {
    const first = this.elements.length;
    for (let i = 0; i < 3; ++i) {
      const [a, b, c] = lines.map((line, side) => (line && side !== i ? 127 : 0));
      this.corner(points[i], normals[i], a, b, c);
    }
    this.corners.push(first, first + 1, first + 2);
  }

  private corner(point: Vector3, normal: Vector3, u: number, v: number, w: number): void {
    const p = this.point.copy(point).applyMatrix4(this.frame);
    const n = this.direction.copy(normal).transformDirection(this.frame);
    (this.bounds[this.element] ??= new Box3()).expandByPoint(p);
    this.positions.push(p.x, p.y, p.z);
    this.normals.push(Math.round(127 * n.x), Math.round(127 * n.y), Math.round(127 * n.z), 0);
    this.rims.push(u, v, w, 0);
    this.elements.push(this.element);
  }
}
