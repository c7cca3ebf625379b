import { type Matrix4, Vector3 } from 'three';
import type { Film } from '../film';
import type { CoverData } from '../header';
import { poseMatrix } from '../kinematics';
import type { Light } from './batch';
import { digitStrokes } from './digits';
import { Strokes } from './strokes';
import type { Colour, Theme } from './theme';

/** The steps by which the way of a tool over an area was found, in the order of docs/coverage.md. */
export const floorSteps = ['beams', 'cells', 'adjacency', 'order', 'lines'] as const;
export type FloorStep = (typeof floorSteps)[number];

/** Over the area, so that it does not hide them (m). */
const above = 0.04;
/** Half of the cross at a node, and how far the border of a cell is drawn inside it (m). */
const cross = 0.18;
const inset = 0.07;
/** A number's height (m): a share of the narrow side of its cell within bounds; and how much of it lines keep clear of its middle. */
const number = { least: 0.45, most: 0.9, share: 0.35, clear: 1.1 };
/** Of the arrow head of a line at work (m). */
const barb = { length: 0.35, across: 0.14 };
const roundSides = 16;

type Flat = [x: number, y: number];

function pairs(numbers: number[]): Flat[] {
  return Array.from({ length: numbers.length / 2 }, (_, i): Flat => [numbers[2 * i], numbers[2 * i + 1]]);
}

/** Mean of the corners' box: inside each cell, which one line along x meets once, or beside it by little. */
function middleOf(points: Flat[]): Flat {
  const area = points.reduce((sum, [x, y], i) => {
    const [u, v] = points[(i + 1) % points.length];
    return sum + x * v - u * y;
  }, 0);
  const [x, y] = points.reduce(([sx, sy], [ax, ay], i) => {
    const [bx, by] = points[(i + 1) % points.length];
    const part = ax * by - bx * ay;
    return [sx + (ax + bx) * part, sy + (ay + by) * part];
  }, [0, 0]);
  return area === 0 ? points[0] : [x / (3 * area), y / (3 * area)];
}

/** Areas that tools work over: their borders, and of the steps of the method those that are switched on. */
export class Floors {
  readonly strokes: Strokes;
  private readonly covers: { cover: CoverData; pose: Matrix4 }[];

  constructor(film: Film, light: Light) {
    this.strokes = new Strokes(light, 1.8);
    // Coats of paint go the same way: it is drawn once.
    const known = new Set<string>();
    this.covers = film.header.tasks.flatMap(({ cover }) => {
      const way = JSON.stringify([cover?.pose, cover?.floor, cover?.steps]);
      if (!cover?.floor || known.has(way)) return [];
      known.add(way);
      return [{ cover, pose: poseMatrix(cover.pose) }];
    });
  }

  /** The steps that there is anything of. */
  static stepsOf(film: Film): FloorStep[] {
    const steps = film.header.tasks.flatMap(({ cover }) => cover?.steps ?? []);
    return floorSteps.filter((step) => (step === 'beams' ? steps.some(({ pieces }) => pieces.length > 0)
      : step === 'adjacency' ? steps.some(({ doors }) => doors.length > 0) : steps.length > 0));
  }

  show(steps: ReadonlySet<FloorStep>, theme: Theme): void {
    this.strokes.redraw(`${[...steps].sort().join(' ')} ${theme.dark}`, () => this.draw(steps, theme));
  }

  private draw(steps: ReadonlySet<FloorStep>, theme: Theme): void {
    for (const { cover, pose } of this.covers) {
      const at = ([x, y]: Flat) => new Vector3(x, y, above).applyMatrix4(pose);
      this.addFloor(cover, at, theme);
      const found = cover.steps;
      if (!found) continue;
      if (steps.has('beams')) this.addBeams(found, at, theme);
      if (steps.has('cells')) this.addCells(found, at, theme);
      if (steps.has('adjacency')) this.addDoors(found, at, theme);
      if (steps.has('order')) this.addOrder(found, at, theme);
      if (steps.has('lines')) this.addLines(found, at, theme);
    }
  }

  private ring(points: Flat[], at: (p: Flat) => Vector3, colour: Colour, opacity = 1): void {
    points.forEach((p, i) => this.strokes.add(at(p), at(points[(i + 1) % points.length]), colour, opacity));
  }

  private addFloor({ floor }: CoverData, at: (p: Flat) => Vector3, theme: Theme): void {
    this.ring(pairs(floor.outline), at, theme.label, 0.9);
    for (const shaft of floor.shafts) {
      const points = pairs(shaft);
      this.ring(points, at, theme.label, 0.9);
      // The cross of draughtsmen: here is no floor.
      if (points.length === 4) for (const i of [0, 1]) this.strokes.add(at(points[i]), at(points[i + 2]), theme.label, 0.45);
    }
    for (const [x, y, size, round] of floor.columns) {
      const half = size / 2;
      const turn = (i: number): Flat => [x + half * Math.cos((2 * Math.PI * i) / roundSides), y + half * Math.sin((2 * Math.PI * i) / roundSides)];
      this.ring(round ? Array.from({ length: roundSides }, (_, i) => turn(i))
        : [[x - half, y - half], [x + half, y - half], [x + half, y + half], [x - half, y + half]], at, theme.label, 0.9);
    }
  }

  /** The hypergraph: a cross for each node, a line for each piece of a beam or an edge; those that a column obstructs stand out. */
  private addBeams({ nodes, pieces }: NonNullable<CoverData['steps']>, at: (p: Flat) => Vector3, theme: Theme): void {
    const places = pairs(nodes);
    for (const [from, to, , obstructed] of pieces) {
      this.strokes.add(at(places[from]), at(places[to]), obstructed ? theme.met : theme.machines[2 % theme.machines.length]);
    }
    for (const [x, y] of places) {
      for (const side of [-cross, cross]) this.strokes.add(at([x - cross, y - side]), at([x + cross, y + side]), theme.label);
    }
  }

  private addCells({ cells }: NonNullable<CoverData['steps']>, at: (p: Flat) => Vector3, theme: Theme): void {
    for (const cell of cells) {
      const points = pairs(cell);
      const middle = middleOf(points);
      const inner = points.map(([x, y]): Flat => [x + inset * Math.sign(middle[0] - x), y + inset * Math.sign(middle[1] - y)]);
      this.ring(inner, at, theme.machines[0]);
    }
  }

  /** From the middle of a cell over the middle of what it has in common with its neighbour to the middle of that. */
  private addDoors({ cells, doors }: NonNullable<CoverData['steps']>, at: (p: Flat) => Vector3, theme: Theme): void {
    const middles = cells.map((cell) => middleOf(pairs(cell)));
    const colour = theme.machines[1 % theme.machines.length];
    for (const [a, b, x0, y0, x1, y1, obstructed] of doors) {
      const door: Flat = [(x0 + x1) / 2, (y0 + y1) / 2];
      this.strokes.add(at(middles[a]), at(door), colour, 0.8);
      this.strokes.add(at(door), at(middles[b]), colour, 0.8);
      this.strokes.add(at([x0, y0]), at([x1, y1]), obstructed ? theme.met : colour);
    }
  }

  /** The number of each cell in the order of work, and a line from one to the next. */
  private addOrder({ cells, order }: NonNullable<CoverData['steps']>, at: (p: Flat) => Vector3, theme: Theme): void {
    const rings = cells.map(pairs);
    const middles = rings.map(middleOf);
    const heights = rings.map((ring) => {
      const [xs, ys] = [ring.map(([x]) => x), ring.map(([, y]) => y)];
      const narrow = Math.min(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys));
      return Math.min(Math.max(number.share * narrow, number.least), number.most);
    });
    order.forEach((cell, i) => {
      for (const [a, b] of digitStrokes(i + 1, middles[cell], heights[cell])) this.strokes.add(at(a), at(b), theme.selected);
      if (i === 0) return;
      const before = order[i - 1];
      const [from, to] = [middles[before], middles[cell]];
      const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
      const length = Math.hypot(dx, dy);
      const [begin, end] = [number.clear * heights[before], length - number.clear * heights[cell]];
      if (end <= begin) return;
      const on = (along: number): Flat => [from[0] + (dx * along) / length, from[1] + (dy * along) / length];
      this.strokes.add(at(on(begin)), at(on(end)), theme.selected, 0.6);
    });
  }

  /** Lines at work, with an arrow head in the middle of each; passes beside borders and columns fainter. */
  private addLines({ lines }: NonNullable<CoverData['steps']>, at: (p: Flat) => Vector3, theme: Theme): void {
    for (const { pass, points: numbers } of lines) {
      const points = pairs(numbers);
      const colour = theme.machines[3 % theme.machines.length];
      for (let i = 1; i < points.length; ++i) {
        const [a, b] = [points[i - 1], points[i]];
        this.strokes.add(at(a), at(b), colour, pass ? 0.65 : 1);
        const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
        if (length < 2 * barb.length) continue;
        const [ux, uy] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
        const tip: Flat = [(a[0] + b[0] + ux * barb.length) / 2, (a[1] + b[1] + uy * barb.length) / 2];
        for (const side of [-barb.across, barb.across]) {
          this.strokes.add(at(tip), at([tip[0] - ux * barb.length - uy * side, tip[1] - uy * barb.length + ux * side]), colour, pass ? 0.65 : 1);
        }
      }
    }
  }
}
