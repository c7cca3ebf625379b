import { Vector3 } from 'three';
import type { Film } from '../film';
import type { Motion } from '../motion';
import { Workspaces, type Flat } from '../workspaces';
import type { Light } from './batch';
import { borderOf } from './foreseen_ways';
import { cornersOf, Shapes } from './shapes';
import { Strokes } from './strokes';
import type { Colour, Theme } from './theme';

/** Above the ground (m). */
const above = 0.07;
/** Opacity of the workspace of a machine that stands. */
const faint = 0.4;

/** The borders of dynamic workspaces on the ground. What stopped a machine stands out, with the workspace that it would have had itself. */
export class WorkspaceLines {
  readonly strokes: Strokes;
  /** What stopped a machine. */
  readonly marks: Strokes;
  private readonly workspaces: Workspaces;
  private shown = '';

  constructor(private readonly film: Film, motion: Motion, light: Light) {
    this.strokes = new Strokes(light, 2);
    this.marks = new Strokes(light, 4);
    const shapes = new Shapes(film);
    const corners = film.header.robots.map(({ bodies }) => bodies.map((body) =>
      shapes.surface(body.shapes.map((shape) => [shape])).bounds.flatMap((box) => cornersOf(box).map(({ x, y, z }): [number, number, number] => [x, y, z]))));
    this.workspaces = new Workspaces(film, motion, (robot, body) => corners[robot][body]);
  }

  show(on: boolean, time: number, colourOf: (robot: number) => Colour, theme: Theme): void {
    const { workspaces } = this;
    const of = on ? workspaces.of : [];
    const stops = on ? workspaces.stopsAt(time) : [];
    const key = `${theme.dark} ${of.map((robot) => workspaces.keyOf(robot, time)).join(' ')} ${stops.map(({ robot, from }) => `${robot}!${from}`).join(' ')}`;
    if (key === this.shown) return;
    this.shown = key;
    this.strokes.clear();
    this.marks.clear();
    const stopped = new Map(stops.map((stop) => [stop.robot, stop]));
    for (const robot of of) {
      const stop = stopped.get(robot);
      const inTheWay = stops.some(({ by }) => by === robot);
      // Of one that stands for another: what it would have swept, so that the two are seen to overlap.
      const wanted = stop && workspaces.wantedBy(stop);
      if (wanted) this.add(this.marks, robot, wanted, theme.moved, 0.8);
      const outlines = workspaces.at(robot, time);
      if (inTheWay || stop) this.add(this.marks, robot, outlines, inTheWay ? theme.met : theme.moved, 1);
      else this.add(this.strokes, robot, outlines, colourOf(robot), workspaces.isMoving(robot, time) ? 1 : faint);
    }
    this.marks.flush();
    this.strokes.flush();
  }

  private add(strokes: Strokes, robot: number, outlines: Flat[][], colour: Colour, opacity: number): void {
    const z = this.film.header.robots[robot].pose[11] + above;
    for (const [a, b] of borderOf({ corners: outlines.map(({ length }) => length), points: outlines.flat(2) })) {
      strokes.add(new Vector3(...a, z), new Vector3(...b, z), colour, opacity);
    }
  }
}
