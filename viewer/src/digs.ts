import { Matrix4, Vector3 } from 'three';
import { workedHours } from './busy';
import type { Film } from './film';
import type { ShapeData } from './header';
import type { Interval } from './shifts';

/** Soil that a task digs away while the film goes on. */
interface Soil {
  component: number;
  /** The hours in which it is dug. */
  hours: Interval[];
  /** Its lowest place, in its own frame. */
  bottom: number;
  /** The share that was left when it was last asked. */
  left: number;
}

function lowestOf(shapes: ShapeData[]): number {
  return shapes.reduce((low, shape) => (shape.type === 'box' ? Math.min(low, shape.lower?.[2] ?? 0) : low), Infinity);
}

/**
 * How far soils are dug: their surfaces go down evenly, from how the ground lies to the bottom of the pit, in the hours of their tasks. Where in
 * the pit somebody digs is not simulated.
 */
export class Digs {
  private readonly soils: Soil[] = [];

  constructor(film: Film) {
    const { header } = film;
    const digs = header.tasks.flatMap(({ name, dig, choices }) => [dig, ...(choices ?? []).map((choice) => choice.dig)]
      .flatMap((each) => (each?.soil ? [[name, each.soil] as const] : [])));
    const components = new Map(digs.map(([task, soil]) => [task, header.components.findIndex(({ name }) => name === soil)]));
    for (let i = 0; components.size > 0 && i < film.records; ++i) {
      if (film.kind(i) !== 'work') continue;
      const run = film.runs[film.run(i)];
      const component = components.get(run.task) ?? -1;
      if (component < 0 || !run.happened) continue;
      this.soils.push({ component, hours: workedHours(film, i), bottom: lowestOf(header.components[component].shapes), left: 1 });
    }
  }

  /** Components whose soil is not as it was, those of `changed` too, with what there is of it: a frame of theirs that goes before their shapes. */
  seek(time: number, changed: Set<number>): [component: number, shrunk: Matrix4][] {
    return this.soils.flatMap((soil) => {
      const total = soil.hours.reduce((sum, [from, to]) => sum + to - from, 0);
      const done = soil.hours.reduce((sum, [from, to]) => sum + Math.min(Math.max(time - from, 0), to - from), 0);
      // A soil without any height has no sides to draw.
      const left = Math.max(total > 0 ? 1 - done / total : 1, 1e-3);
      if (left === soil.left && !changed.has(soil.component)) return [];
      soil.left = left;
      return [[soil.component, new Matrix4().makeTranslation(0, 0, soil.bottom * (1 - left)).scale(new Vector3(1, 1, left))]];
    });
  }
}
