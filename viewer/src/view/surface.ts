import { Box3, Matrix4, Vector3 } from 'three';

/** Grows as items of `size` numbers are appended. */
class Numbers<T extends Float32Array | Int8Array | Uint32Array> {
  length = 0;
  private values: T;

  constructor(private readonly make: (length: number) => T, private readonly size: number) {
    this.values = make(4096);
  }

  push(a: number, b = 0, c = 0, d = 0): void {
    if (this.length + 4 > this.values.length) {
      const grown = this.make(2 * this.values.length);
      grown.set(this.values);
      this.values = grown;
    }
    const { values, length, size } = this;
    values[length] = a;
    if (size > 1) values[length + 1] = b;
    if (size > 2) values[length + 2] = c;
    if (size > 3) values[length + 3] = d;
    this.length += size;
  }

  done(): T {
    return this.values.subarray(0, this.length) as T;
  }
}

/**
 * The triangles of many elements in one. Each corner has a place in its element's frame (m), a normal (127 is 1), the number of
 * its element and four `rim` numbers: where one of them is 127 or -127 an edge runs that is drawn as a line. Between corners
 * they run linearly, so that a shader sees how far from the edges a point is.
 */
export class Surface {
  /** The number of the element that is added to. */
  element = 0;
  /** From the frame of the next faces to the element's. */
  frame = new Matrix4();
  /** By element, in its own frame. */
  readonly bounds: Box3[] = [];
  private readonly positions = new Numbers((length) => new Float32Array(length), 3);
  private readonly normals = new Numbers((length) => new Int8Array(length), 4);
  private readonly rims = new Numbers((length) => new Int8Array(length), 4);
  private readonly elements = new Numbers((length) => new Float32Array(length), 1);
  private readonly corners = new Numbers((length) => new Uint32Array(length), 3);
  private readonly point = new Vector3();
  private readonly direction = new Vector3();

  get triangles(): number {
    return this.corners.length / 3;
  }

  arrays(): { positions: Float32Array; normals: Int8Array; rims: Int8Array; elements: Float32Array; corners: Uint32Array } {
    return {
      positions: this.positions.done(), normals: this.normals.done(), rims: this.rims.done(), elements: this.elements.done(),
      corners: this.corners.done(),
    };
  }

  /**
   * Four corners, counter-clockwise from outside, from left below. `u`: lines at its left and right; `v`: below and above.
   */
  quad(points: Vector3[], normals: Vector3[], lines: { u: boolean; v: boolean }): void {
    const first = this.elements.length;
    const u = lines.u ? [-127, 127, 127, -127] : [0, 0, 0, 0];
    const v = lines.v ? [-127, -127, 127, 127] : [0, 0, 0, 0];
    for (let i = 0; i < 4; ++i) this.corner(points[i], normals[i], u[i], v[i], 0);
    this.corners.push(first, first + 1, first + 2);
    this.corners.push(first, first + 2, first + 3);
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
    this.normals.push(Math.round(127 * n.x), Math.round(127 * n.y), Math.round(127 * n.z));
    this.rims.push(u, v, w);
    this.elements.push(this.element);
  }
}
