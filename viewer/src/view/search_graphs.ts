import { Vector3 } from 'three';
import { graphAt, legsOfGraph } from '../configurations';
import type { Film } from '../film';
import { Mechanism } from '../kinematics';
import { travellingBody } from '../walks';
import type { Light } from './batch';
import { Strokes } from './strokes';
import type { Theme } from './theme';

/** Above what they are drawn on (m). */
const above = 0.05;
/** Straight pieces that a leg is drawn in: between its ends a tool runs on curves. */
const pieces = 4;

/** What guides searched through: trees, roadmaps, lattices and graphs of sight, as ways of the tool or, of a vehicle, of its place. */
export class SearchGraphs {
  readonly strokes: Strokes;

  constructor(private readonly film: Film, light: Light) {
    this.strokes = new Strokes(light, 1.1);
  }

  /** Those by which the runs under way planned last. */
  show(running: number[], on: boolean, time: number, theme: Theme): void {
    const now = on ? running.map((run) => graphAt(this.film, run, time)).filter((at) => at >= 0) : [];
    this.strokes.redraw(`${now.join(' ')} ${theme.dark}`, () => {
      for (const at of now) {
        for (const [from, to] of legsOf(this.film, at)) this.strokes.add(from, to, theme.label, 0.45);
      }
    });
  }
}

/** The straight pieces of a graph in {W}. */
export function legsOf(film: Film, at: number): [Vector3, Vector3][] {
  const { robot } = film.runs[film.graphs[at].run];
  if (robot < 0) return [];
  const data = film.header.robots[robot];
  const mechanism = new Mechanism(data);
  const body = travellingBody(data);
  const place = (q: number[]) => {
    mechanism.place(q);
    return body < 0 ? new Vector3().setFromMatrixPosition(mechanism.tool)
      : new Vector3().setFromMatrixPosition(mechanism.bodies[body]).setZ(data.pose[11] + above);
  };
  const legs: [Vector3, Vector3][] = [];
  for (const [from, to] of legsOfGraph(film, at)) {
    const count = body < 0 ? pieces : 1;
    let before = place(from);
    for (let k = 1; k <= count; ++k) {
      const next = place(from.map((value, p) => value + (to[p] - value) * k / count));
      legs.push([before, next]);
      before = next;
    }
  }
  return legs;
}
