import { kinds, type Film } from './film';
import { firstAfter } from './gantt/layout';
import { Mechanism } from './kinematics';
import type { Motion } from './motion';

// Dynamic workspaces as docs/earthwork.md says, from the steps of the film.

export type Flat = [x: number, y: number];
type Corner = [x: number, y: number, z: number];

/** Degrees between two places of a turning body, of which the hull is taken. */
const turnApart = 5;
const mostPlaces = 64;
/** s for which it is seen at least what stopped a machine. */
const leastSeen = 1;
const prefix = 'the workspace of ';

interface Step {
  from: number;
  to: number;
  /** When the machine stands next, null: it is not known where. */
  stands: number | null;
}

/** A machine stopped from a moment on (s); `by`: the machine (-1: people) whose workspace its own would have overlapped. */
export interface WorkspaceStop {
  robot: number;
  from: number;
  to: number;
  by: number;
}

/** What machines whose workspaces are kept apart would sweep until they stand, and whom that stopped. */
export class Workspaces {
  /** Numbers of the machines. */
  readonly of: number[];
  readonly stops: WorkspaceStop[] = [];
  private readonly steps = new Map<number, Step[]>();
  private readonly mechanisms = new Map<number, Mechanism>();

  /** `corners`: of a body of a robot, those of the boxes round its shapes, in its own frame. */
  constructor(private readonly film: Film, private readonly motion: Motion, private readonly corners: (robot: number, body: number) => Corner[]) {
    const { header } = film;
    const number = (name: string) => header.robots.findIndex((robot) => robot.name === name);
    this.of = (header.workspaces?.of ?? []).map(number);
    for (const robot of this.of) {
      this.steps.set(robot, []);
      this.mechanisms.set(robot, new Mechanism(header.robots[robot]));
    }
    film.runs.forEach((run, i) => { if (run.happened && this.steps.has(run.robot)) this.read(i, number); });
    for (const steps of this.steps.values()) steps.sort((a, b) => a.from - b.from);
    this.stops.sort((a, b) => a.from - b.from);
  }

  /** The convex outlines of the workspace of a machine at a moment; where it stands its footprint. */
  at(robot: number, time: number): Flat[][] {
    const step = this.stepAt(robot, time);
    if (!step) {
      const q = this.motion.configuration(robot, time);
      return this.swept(robot, q, q);
    }
    const from = this.motion.configuration(robot, step.from);
    const to = this.motion.configuration(robot, step.to);
    return this.swept(robot, from, this.end(robot, step, from, to));
  }

  /** What a machine that stopped would have needed: for a step like the last, or, of one that stood before, like its next; null: it made none. */
  wantedBy(stop: WorkspaceStop): Flat[][] | null {
    const { robot, from } = stop;
    const steps = this.steps.get(robot) ?? [];
    const next = steps.find((step) => step.from >= from);
    const last = steps.find((step) => step.to === from);
    const like = last ?? next;
    if (!like) return null;
    const q = this.motion.configuration(robot, from);
    const before = this.motion.configuration(robot, like.from);
    const after = this.motion.configuration(robot, like.to);
    const to = q.map((value, i) => value + after[i] - before[i]);
    const seconds = like.to - like.from;
    return this.swept(robot, q, this.end(robot, { from: 0, to: seconds, stands: (next ?? like).stands }, q, to));
  }

  /** What changes when the workspace does. */
  keyOf(robot: number, time: number): string {
    const step = this.stepAt(robot, time);
    return step ? `${robot}:${step.from}` : `${robot}=${Array.from(this.motion.configuration(robot, time), (value) => value.toFixed(3)).join(',')}`;
  }

  isMoving(robot: number, time: number): boolean {
    return this.stepAt(robot, time) !== undefined;
  }

  /** Those that are seen at a moment. */
  stopsAt(time: number): WorkspaceStop[] {
    return this.stops.filter(({ from, to }) => from <= time && time < Math.max(to, from + leastSeen));
  }

  /** The steps of a run, where each motion of it leads, and where it was stopped. */
  private read(run: number, number: (name: string) => number): void {
    const { film } = this;
    const { robot } = film.runs[run];
    const steps = this.steps.get(robot) ?? [];
    const codes = film.column('record.kind');
    const [tries, goals, ends] = [kinds.indexOf('try'), kinds.indexOf('goal'), kinds.indexOf('end')];
    let before = film.runs[run].start;
    let first = steps.length;
    let stop: WorkspaceStop | null = null;
    for (const record of film.recordsOf(run)) {
      const time = film.time(record);
      const code = codes[record];
      if (code === tries && film.number(record, 'try.ok') === 1 && time > before) {
        if (stop) stop.to = before;
        stop = null;
        steps.push({ from: before, to: time, stands: null });
      } else if (code === tries && film.text(record, 'try.moved').startsWith(prefix)) {
        if (stop) stop.to = time;
        const met = film.text(record, 'try.met');
        stop = { robot, from: time, to: film.runs[run].end ?? film.end, by: met.startsWith(prefix) ? number(met.slice(prefix.length)) : -1 };
        this.stops.push(stop);
      } else if (code === goals || code === ends) {
        const known = code === goals || film.number(record, 'end.reached') === 1;
        const last = steps.at(-1);
        if (known && last) for (const step of steps.slice(first)) step.stands = last.to;
        first = steps.length;
      }
      before = Math.max(before, time);
    }
  }

  private stepAt(robot: number, time: number): Step | undefined {
    const steps = this.steps.get(robot) ?? [];
    const step = steps[firstAfter(steps, time)];
    return step && step.from <= time ? step : undefined;
  }

  /** Where it would stand if it stopped as soon as the step is over. */
  private end(robot: number, step: Step, from: Float64Array, to: Float64Array): Float64Array {
    const { parameters } = this.film.header.robots[robot];
    const rules = this.film.header.workspaces ?? { reaction: 0, braking: 1, turn_braking: 1 };
    const seconds = step.to - step.from;
    const goal = step.stands === null ? null : this.motion.configuration(robot, step.stands);
    const length = Math.hypot(...parameters.map(({ kind, derived }, i) => (kind === 'translation' && derived === undefined ? to[i] - from[i] : 0)));
    const goesOn = (speed: number, braking: number) => rules.reaction + speed / (2 * braking);
    return to.map((value, i) => {
      const rate = (value - from[i]) / seconds;
      if (rate === 0) return value;
      const time = parameters[i].kind === 'rotation' ? goesOn(Math.abs(rate), rules.turn_braking) : goesOn(length / seconds, rules.braking);
      const more = rate * time;
      let left = goal ? goal[i] - value : more;
      if (goal && parameters[i].cyclic) left -= 360 * Math.round(left / 360);
      return value + (left * more >= 0 && Math.abs(left) < Math.abs(more) ? left : more);
    });
  }

  private swept(robot: number, from: Float64Array, to: Float64Array): Flat[][] {
    const { parameters } = this.film.header.robots[robot];
    const turned = Math.max(0, ...parameters.map(({ kind }, i) => (kind === 'rotation' ? Math.abs(to[i] - from[i]) : 0)));
    const parts = Math.min(Math.max(Math.ceil(turned / turnApart), 1), mostPlaces);
    const outlines: Flat[][] = [];
    let before = this.seen(robot, from);
    for (let part = 1; part <= parts; ++part) {
      const here = this.seen(robot, from.map((value, i) => value + (to[i] - value) * part / parts));
      here.forEach((points, body) => { if (points.length > 0) outlines.push(hullOf([...before[body], ...points])); });
      before = here;
    }
    return outlines;
  }

  /** The corners of its bodies from above. */
  private seen(robot: number, q: Float64Array): Flat[][] {
    const mechanism = this.mechanisms.get(robot);
    if (!mechanism) return [];
    mechanism.place(q);
    return mechanism.bodies.map(({ elements: e }, body) => this.corners(robot, body).map(([x, y, z]): Flat =>
      [e[0] * x + e[4] * y + e[8] * z + e[12], e[1] * x + e[5] * y + e[9] * z + e[13]]));
  }
}

/** Counter-clockwise. */
export function hullOf(points: Flat[]): Flat[] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (ordered: Flat[]) => {
    const hull: Flat[] = [];
    for (const p of ordered) {
      for (;;) {
        const [a, b] = hull.slice(-2);
        if (!b || (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
        hull.pop();
      }
      hull.push(p);
    }
    return hull.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}
