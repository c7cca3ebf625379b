import { Vector3 } from 'three';
import { type Film, kinds } from '../film';
import type { Light } from './batch';
import { Strokes } from './strokes';
import type { Theme } from './theme';

/** Above what they are drawn on (m). */
const above = 0.03;

/** The cold joints of floors, as far as a task that is done has any: a stroke where each of them lies, as high as the tool went. */
export class Joints {
  readonly strokes: Strokes;
  private shown: Theme | null = null;

  constructor(private readonly film: Film, light: Light) {
    this.strokes = new Strokes(light, 3);
  }

  show(theme: Theme): void {
    if (theme === this.shown) return;
    this.shown = theme;
    this.strokes.clear();
    const { film } = this;
    const tasks = new Map(film.header.tasks.map((task) => [task.name, task]));
    const cold = kinds.indexOf('cold_joint');
    film.column('record.kind').forEach((kind, record) => {
      if (kind !== cold) return;
      const [x, y, toX, toY] = film.numbers(record, 'cold_joint.ends', 4);
      const height = (tasks.get(film.runs[film.run(record)].task)?.go?.pose?.[11] ?? 0) + above;
      this.strokes.add(new Vector3(x, y, height), new Vector3(toX, toY, height), theme.met);
    });
    this.strokes.flush();
  }
}
