import { Vector3 } from 'three';
import type { Film } from '../film';
import { Mechanism } from '../kinematics';
import type { Motion } from '../motion';
import type { Light } from './batch';
import { Strokes } from './strokes';
import type { Colour } from './theme';

/** How far (m, degrees) parameters may run between two points of a path: turns are arcs. */
const longest = 3;
/** Points a path may have at most. */
const mostPoints = 20000;

interface Path {
  points: Vector3[];
  times: number[];
}

/** The ways of the tools in the runs that go on: what is behind strong, what is ahead faint. */
export class Paths {
  readonly strokes: Strokes;
  private readonly paths = new Map<number, Path>();

  constructor(private readonly film: Film, private readonly motion: Motion, light: Light) {
    this.strokes = new Strokes(light, 2.2);
  }

  /** `tried` as in Stock; colours by robot. */
  show(running: number[], tried: number, time: number, colour: (robot: number) => Colour, dark: boolean): void {
    this.strokes.setNow(time);
    this.strokes.redraw(`${running.join(' ')} ${dark}`, () => {
      for (const run of running) {
        if (this.film.runs[run].robot < 0) continue;
        const { points, times } = this.pathOf(run, run === tried ? run : -1);
        const tint = colour(this.film.runs[run].robot);
        for (let i = 1; i < points.length; ++i) this.strokes.add(points[i - 1], points[i], tint, 1, times[i - 1], times[i]);
      }
    });
  }

  private pathOf(run: number, tried: number): Path {
    const known = this.paths.get(run);
    if (known) return known;
    const { robot, start, end } = this.film.runs[run];
    const mechanism = new Mechanism(this.film.header.robots[robot]);
    const path: Path = { points: [], times: [] };
    const add = (time: number, q: ArrayLike<number>) => {
      mechanism.place(q);
      const point = new Vector3().setFromMatrixPosition(mechanism.tool);
      const last = path.points.at(-1);
      if (last && last.distanceToSquared(point) < 1e-8) return;
      path.points.push(point);
      path.times.push(time);
    };
    let before: { t: number; q: Float64Array } | null = null;
    for (const t of this.motion.moments(robot, start, end ?? this.film.end, tried)) {
      const q = this.motion.configuration(robot, t, tried);
      if (before) {
        const far = Math.max(...q.map((value, i) => Math.abs(value - (before as { q: Float64Array }).q[i])));
        const pieces = Math.min(Math.ceil(far / longest), 120);
        for (let piece = 1; piece < pieces; ++piece) {
          const at = before.t + ((t - before.t) * piece) / pieces;
          add(at, this.motion.configuration(robot, at, tried));
        }
      }
      add(t, q);
      before = { t, q };
      if (path.points.length > mostPoints) break;
    }
    this.paths.set(run, path);
    return path;
  }
}
