import { Matrix4, Quaternion, Vector3 } from 'three';
import { cosDegrees, parseFrame, sinDegrees, type FrameElement } from './formula';
import type { PoseRows, RobotData } from './header';

/** The matrix of a pose of the trace (the upper three rows, row by row). */
export function poseMatrix(rows: PoseRows): Matrix4 {
  const [a, b, c, x, d, e, f, y, g, h, i, z] = rows;
  return new Matrix4().set(a, b, c, x, d, e, f, y, g, h, i, z, 0, 0, 0, 1);
}

/** The matrix of a pose of the film: x, y, z (m), then the quaternion x, y, z, w. */
export function quaternionMatrix(numbers: ArrayLike<number>): Matrix4 {
  const [x, y, z, i, j, k, w] = Array.from(numbers);
  return new Matrix4().compose(new Vector3(x, y, z), new Quaternion(i, j, k, w).normalize(), new Vector3(1, 1, 1));
}

/** The upper three rows of a matrix, row by row: how the trace writes a pose. */
export function poseRows(matrix: Matrix4): PoseRows {
  const e = matrix.elements;
  return [e[0], e[4], e[8], e[12], e[1], e[5], e[9], e[13], e[2], e[6], e[10], e[14]];
}

/** Where a machine's bodies and its tool are in {W} at a configuration. */
export class Mechanism {
  /** X_WB of each body in the order of the header; valid after `place`. */
  readonly bodies: Matrix4[];
  /** X_WT; valid after `place`. */
  readonly tool = new Matrix4();
  private readonly mounting: Matrix4;
  /** For each body the number of its parent, -1: the mounting frame. */
  private readonly parents: number[];
  private readonly frames: FrameElement[][];
  private readonly toolBody: number;
  private readonly toolFrame: FrameElement[];
  /** Parents before children. */
  private readonly order: number[] = [];

  constructor(robot: RobotData) {
    const names = robot.parameters.map((parameter) => parameter.name);
    const number = (body: string) => robot.bodies.findIndex((each) => each.name === body);
    this.bodies = robot.bodies.map(() => new Matrix4());
    this.mounting = poseMatrix(robot.pose);
    this.parents = robot.bodies.map((body) => (body.parent === null ? -1 : number(body.parent)));
    this.frames = robot.bodies.map((body) => parseFrame(body.frame, names));
    this.toolBody = number(robot.tool.body);
    this.toolFrame = parseFrame(robot.tool.frame, names);
    const seen = new Set<number>([-1]);
    const visit = (body: number) => {
      if (seen.has(body)) return;
      seen.add(body);
      visit(this.parents[body]);
      this.order.push(body);
    };
    for (let body = 0; body < this.parents.length; ++body) visit(body);
  }

  /** Brings `bodies` and `tool` to a configuration: the parameters in the order of the header (m, degrees). */
  place(q: ArrayLike<number>): void {
    for (const body of this.order) {
      const parent = this.parents[body];
      apply(this.bodies[body].copy(parent < 0 ? this.mounting : this.bodies[parent]), this.frames[body], q);
    }
    apply(this.tool.copy(this.toolBody < 0 ? this.mounting : this.bodies[this.toolBody]), this.toolFrame, q);
  }

  /** The bodies from the mounting to the one that holds the tool. */
  chain(): number[] {
    const result: number[] = [];
    for (let body = this.toolBody; body >= 0; body = this.parents[body]) result.unshift(body);
    return result;
  }
}

/** matrix := matrix * frame. */
function apply(matrix: Matrix4, frame: FrameElement[], q: ArrayLike<number>): void {
  const e = matrix.elements;
  for (const element of frame) {
    if (element.kind === 'trans') {
      const x = element.x(q);
      const y = element.y(q);
      const z = element.z(q);
      for (let i = 0; i < 3; ++i) e[12 + i] += e[i] * x + e[4 + i] * y + e[8 + i] * z;
      continue;
    }
    const angle = element.angle(q);
    const cosine = cosDegrees(angle);
    const sine = sinDegrees(angle);
    // A turn about an axis mixes the columns of the other two.
    const first = element.kind === 'rotx' ? 4 : element.kind === 'roty' ? 8 : 0;
    const second = element.kind === 'rotx' ? 8 : element.kind === 'roty' ? 0 : 4;
    for (let i = 0; i < 3; ++i) {
      const a = e[first + i];
      const b = e[second + i];
      e[first + i] = cosine * a + sine * b;
      e[second + i] = cosine * b - sine * a;
    }
  }
}
