import { Vector3 } from 'three';
import type { Film, ForeseenData } from '../film';
import type { Light } from './batch';
import { Strokes } from './strokes';
import type { Theme } from './theme';

/** Above the ground (m). */
const above = 0.08;

type Flat = [x: number, y: number];

/** What machines are foreseen to sweep: the border of it on the ground, while another machine keeps out of it. */
export class ForeseenWays {
  readonly strokes: Strokes;

  constructor(private readonly film: Film, light: Light) {
    this.strokes = new Strokes(light, 2.6);
  }

  /** What was looked at last by each of the runs under way, for as long as it reached ahead. */
  show(running: number[], on: boolean, time: number, theme: Theme): void {
    const { foreseen } = this.film;
    const last = on ? Math.max(-1, ...foreseen.filter(({ run, t }) => running.includes(run) && t <= time).map(({ t }) => t)) : -1;
    const now = foreseen.flatMap((each, i) => (each.t === last && running.includes(each.run) && time < each.t + each.seconds ? [i] : []));
    this.strokes.redraw(`${now.join(' ')} ${theme.dark}`, () => {
      for (const i of now) {
        for (const [a, b] of borderOf(foreseen[i])) this.strokes.add(new Vector3(...a, above), new Vector3(...b, above), theme.met);
      }
    });
  }
}

/** The border of all outlines together: of each of their edges what lies in no other outline. */
export function borderOf({ corners, points }: Pick<ForeseenData, 'corners' | 'points'>): [Flat, Flat][] {
  let at = 0;
  const outlines = corners.map((count) => Array.from({ length: count }, (): Flat => [points[at++], points[at++]]));
  const pieces: [Flat, Flat][] = [];
  outlines.forEach((outline, own) => outline.forEach((a, i) => {
    const b = outline[(i + 1) % outline.length];
    const hidden = outlines.flatMap((other, k) => (k === own ? [] : insideOf(other, a, b, k < own))).sort(([p], [q]) => p - q);
    let from = 0;
    const on = (share: number): Flat => [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share];
    for (const [begin, end] of [...hidden, [1, 1]]) {
      if (begin > from + 1e-6) pieces.push([on(from), on(begin)]);
      from = Math.max(from, end);
    }
  }));
  return pieces;
}

/** What of a line lies in a convex outline, as shares of the line; of one on its edge, in its direction, if `edge`. */
function insideOf(outline: Flat[], a: Flat, b: Flat, edge: boolean): [number, number][] {
  let [from, to] = [0, 1];
  for (let i = 0; i < outline.length; ++i) {
    const [p, q] = [outline[i], outline[(i + 1) % outline.length]];
    const side = ([x, y]: Flat) => (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
    const [here, there] = [side(a), side(b)];
    const on = 1e-6;
    if (Math.abs(here) < on && Math.abs(there) < on) {
      // On a common edge with the other beside it nothing is a border; with both on one side it is drawn once.
      const same = (q[0] - p[0]) * (b[0] - a[0]) + (q[1] - p[1]) * (b[1] - a[1]) > 0;
      if (same && !edge) return [];
      continue;
    }
    if (here <= 0 && there <= 0) return [];
    const cut = here / (here - there);
    if (here < 0) from = Math.max(from, cut);
    if (there < 0) to = Math.min(to, cut);
  }
  return to > from ? [[from, to]] : [];
}
