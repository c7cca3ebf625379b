// A second reading of where things are, straight from the trace: shares nothing with the page but the file format.

type Matrix = number[];

const identity: Matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

function times(a: Matrix, b: Matrix): Matrix {
  const result: Matrix = [];
  for (let row = 0; row < 3; ++row) {
    for (let column = 0; column < 4; ++column) {
      let sum = column === 3 ? a[4 * row + 3] : 0;
      for (let k = 0; k < 3; ++k) sum += a[4 * row + k] * b[4 * k + column];
      result.push(sum);
    }
  }
  return result;
}

const radians = (degrees: number) => (degrees * Math.PI) / 180;

function element(name: string, args: number[]): Matrix {
  if (name === 'trans') return [1, 0, 0, args[0], 0, 1, 0, args[1], 0, 0, 1, args[2]];
  const c = Math.cos(radians(args[0]));
  const s = Math.sin(radians(args[0]));
  if (name === 'rotx') return [1, 0, 0, 0, 0, c, -s, 0, 0, s, c, 0];
  if (name === 'roty') return [c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0];
  return [c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0];
}

/** A frame text of the header at these values, by letting JavaScript compute it. */
function frameAt(text: string, q: Record<string, number>): Matrix {
  let formula = text;
  for (const name of Object.keys(q).sort((a, b) => b.length - a.length)) {
    formula = formula.replaceAll(new RegExp(`(?<![\\w.])${name.replaceAll('.', '\\.')}(?![\\w.])`, 'g'), `(${q[name]})`);
  }
  const list = formula.replaceAll(/\)\s*\*\s*(?=trans|rot[xyz])/g, '),');
  const make = (name: string) => (...args: number[]) => element(name, args);
  const compute = new Function('trans', 'rotx', 'roty', 'rotz', 'sin', 'cos', `return [${list}]`);
  const elements = compute(make('trans'), make('rotx'), make('roty'), make('rotz'), (a: number) => Math.sin(radians(a)),
    (a: number) => Math.cos(radians(a))) as Matrix[];
  return elements.reduce(times, identity);
}

interface Robot {
  name: string;
  pose: Matrix;
  start: Record<string, number>;
  bodies: { name: string; parent: string | null; frame: string }[];
  parameters: { name: string; cyclic: boolean }[];
  tool: { body: string; frame: string };
}

interface TraceRecord {
  type: string;
  task: string;
  robot: string;
  t?: number;
  ok?: boolean;
  q?: Record<string, number>;
  result?: string;
  component?: string;
  pose?: Matrix;
}

export class TracePoses {
  readonly end: number;
  private readonly robots: Robot[];
  private readonly components: { name: string; pose: Matrix }[];
  private readonly records: TraceRecord[];

  constructor(trace: Record<string, unknown>[]) {
    const [header, ...records] = trace as unknown as [{ robots: Robot[]; components: { name: string; pose: Matrix }[] }, ...TraceRecord[]];
    this.robots = header.robots;
    this.components = header.components;
    const undone = new Set(records.filter((r) => r.type === 'task_end' && r.result !== 'done').map((r) => r.task));
    this.records = records.filter((r) => !undone.has(r.task) && r.t !== undefined);
    this.end = Math.max(0, ...this.records.map((r) => r.t ?? 0));
  }

  /** World poses of all bodies (robot.body) and components at a moment; of a removed component none. */
  at(time: number): Record<string, Matrix> {
    const poses: Record<string, Matrix> = {};
    const tools: Record<string, Matrix> = {};
    for (const robot of this.robots) {
      const q = this.values(robot, time);
      const bodies: Record<string, Matrix> = {};
      for (const body of robot.bodies) {
        bodies[body.name] = times(body.parent === null ? robot.pose : bodies[body.parent], frameAt(body.frame, q));
        poses[`${robot.name}.${body.name}`] = bodies[body.name];
      }
      tools[robot.name] = times(bodies[robot.tool.body], frameAt(robot.tool.frame, q));
    }
    for (const component of this.components) {
      let pose: Matrix | null = component.pose;
      const changes = this.records.filter((r) => r.component === component.name && (r.t ?? 0) <= time);
      changes.sort((a, b) => (a.t ?? 0) - (b.t ?? 0));
      const last = changes.at(-1);
      if (last?.type === 'attach') pose = times(tools[last.robot], last.pose ?? identity);
      else if (last?.type === 'detach') pose = last.pose ?? identity;
      else if (last?.type === 'remove') pose = null;
      if (pose) poses[component.name] = pose;
    }
    return poses;
  }

  /** The parameters of a robot: a straight line through every record of its tasks. */
  private values(robot: Robot, time: number): Record<string, number> {
    let before = { t: 0, q: robot.start };
    let own = { ...robot.start };
    const clock: Record<string, number> = {};
    for (const record of this.records) {
      if (record.robot !== robot.name || record.type === 'attach' || record.type === 'detach') continue;
      const from = clock[record.task] ?? record.t ?? 0;
      clock[record.task] = record.t ?? 0;
      if (record.type !== 'try' || !record.ok || !record.q) continue;
      const to = { t: record.t ?? 0, q: record.q };
      if (to.t <= time) {
        before = to;
        own = { ...record.q };
        continue;
      }
      if (from >= time) break;
      const share = (time - from) / (to.t - from);
      for (const { name, cyclic } of robot.parameters) {
        let change = to.q[name] - before.q[name];
        if (cyclic) change -= 360 * Math.round(change / 360);
        own[name] = before.q[name] + share * change;
      }
      break;
    }
    return own;
  }
}
