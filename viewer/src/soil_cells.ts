import { Matrix4, Vector3 } from 'three';
import type { Film } from './film';
import type { ShapeData } from './header';
import { poseMatrix } from './kinematics';

/** A cell of soil that a robot digs, or that trucks tip: a column from `after` to `before` in the frame of its earth. */
interface Cell {
  X_WE: Matrix4;
  /** How high it is at first. */
  start: number;
  before: number;
  after: number;
  /** When it was lowered, and to which height (m); in the order of time. */
  changes: { t: number; height: number }[];
  /** What of it was drawn last, as a share. */
  left: number;
}

/** Where what is not there is put: nobody looks so far. */
const away = new Matrix4().makeTranslation(0, 0, -1e6);

/** Soil that robots dig bucket by bucket, cell by cell. */
export class SoilCells {
  /** By cell: its column as the ground lay. */
  readonly shapes: ShapeData[][] = [];
  /** The components that these are: they are not drawn themselves. */
  readonly components = new Set<number>();
  private readonly cells: Cell[] = [];

  constructor(film: Film) {
    const pose = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0] as ShapeData['pose'];
    for (const task of film.header.tasks) {
      const dig = task.motion_dig;
      if (!dig) continue;
      const component = film.header.components.findIndex(({ name }) => name === dig.soil);
      this.components.add(component);
      const numbers = new Map(dig.cells.map((cell, i) => [cell, this.cells.length + i]));
      const X_WE = poseMatrix(dig.pose);
      const side = dig.cell / 1000;
      dig.cells.forEach((cell, i) => {
        const x = (cell % dig.columns) * side;
        const y = Math.floor(cell / dig.columns) * side;
        const [before, after] = [dig.before[i] / 1000, dig.after[i] / 1000];
        this.shapes.push([{ type: 'box', pose, lower: [x, y, after], upper: [x + side, y + side, before] }]);
        this.cells.push({ X_WE, start: before, before, after, changes: [], left: -1 });
      });
      for (const bucket of film.soils) {
        if (bucket.component !== component || !film.runs[bucket.run].happened) continue;
        bucket.cells.forEach((cell, i) => {
          this.cells[numbers.get(cell) ?? -1]?.changes.push({ t: bucket.t, height: bucket.heights[i] / 1000 });
        });
      }
    }
    this.addHeaps(film);
  }

  /** Heaps: of each cell on which something was ever tipped the column that it became. */
  private addHeaps(film: Film): void {
    const pose = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0] as ShapeData['pose'];
    for (const heap of film.header.heaps ?? []) {
      const component = film.header.components.findIndex(({ name }) => name === heap.component);
      this.components.add(component);
      const X_WE = poseMatrix(heap.pose);
      const side = heap.cell / 1000;
      const known = new Map<number, Cell>();
      const tipped = film.soils.filter((each) => each.component === component && film.runs[each.run].happened).sort((a, b) => a.t - b.t);
      for (const load of tipped) {
        load.cells.forEach((cell, i) => {
          const height = load.heights[i] / 1000;
          const ground = heap.ground[cell] / 1000;
          const column = known.get(cell) ?? { X_WE, start: ground, before: height, after: ground, changes: [], left: -1 };
          column.before = Math.max(column.before, height);
          column.changes.push({ t: load.t, height });
          known.set(cell, column);
        });
      }
      for (const [cell, column] of known) {
        const x = (cell % heap.columns) * side;
        const y = Math.floor(cell / heap.columns) * side;
        this.shapes.push([{ type: 'box', pose, lower: [x, y, column.after], upper: [x + side, y + side, column.before] }]);
        this.cells.push(column);
      }
    }
  }

  /** The cells that are not as they were, and the frame of each of them. */
  seek(time: number): [cell: number, frame: Matrix4][] {
    return this.cells.flatMap((cell, i) => {
      let height = cell.start;
      for (const change of cell.changes) if (change.t <= time) height = change.height;
      const left = (height - cell.after) / (cell.before - cell.after);
      if (left === cell.left) return [];
      cell.left = left;
      if (left <= 0) return [[i, away]];
      const shrunk = new Matrix4().makeTranslation(0, 0, cell.after * (1 - left)).scale(new Vector3(1, 1, left));
      return [[i, cell.X_WE.clone().multiply(shrunk)]];
    });
  }
}
