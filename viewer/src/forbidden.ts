import type { ForbiddenData } from './film';
import type { Section } from './configurations';

/** What two parameters span of a grid, at a value of its third parameter. */
export interface Slice {
  /** Borders of the cells, ascending: one more than there are cells. */
  across: number[];
  up: number[];
  /** Row by row from below. */
  blocked: boolean[];
  /** The third parameter of the grid, by its number, -1 if it has none, and its value in this slice. */
  third: number;
  value: number;
}

/** Which parameters of a robot a grid goes over, by their numbers. */
export function sampledBy(grid: ForbiddenData, names: string[]): number[] {
  return grid.parameters.map((name) => names.indexOf(name));
}

const withinTurn = (value: number, cyclic: boolean) => (cyclic ? value - 360 * Math.round(value / 360) : value);

/** The range of a parameter of a grid, by its place among the grid's. */
export function rangeOf(grid: ForbiddenData, axis: number): { low: number; high: number } {
  return axis < 2 ? { low: grid.low[axis], high: grid.high[axis] } : { low: grid.layers[0], high: grid.layers[grid.layers.length - 1] };
}

function countOf(grid: ForbiddenData, axis: number): number {
  return axis < 2 ? grid.cells[axis] : Math.max(1, grid.layers.length);
}

/** Where cells were judged: in their middles. */
function middles(grid: ForbiddenData, axis: number): number[] {
  if (axis === 2) return grid.layers;
  const { low, high } = rangeOf(grid, axis);
  const count = countOf(grid, axis);
  return Array.from({ length: count }, (_, i) => low + (i + 0.5) / count * (high - low));
}

function borders(grid: ForbiddenData, axis: number): number[] {
  const { low, high } = rangeOf(grid, axis);
  const at = middles(grid, axis);
  return [low, ...at.slice(1).map((value, i) => (at[i] + value) / 2), high];
}

const cellsOf = new WeakMap<ForbiddenData, Uint8Array>();

/** 1: forbidden. */
function cells(grid: ForbiddenData): Uint8Array {
  let all = cellsOf.get(grid);
  if (!all) {
    all = new Uint8Array(countOf(grid, 0) * countOf(grid, 1) * countOf(grid, 2));
    let at = 0;
    grid.runs.forEach((length, i) => all?.fill(i % 2, at, at += length));
    cellsOf.set(grid, all);
  }
  return all;
}

/**
 * What a section shows of a grid: at the value of its slider where that is the third parameter of the grid, else at the value that this
 * had where the search began. Null: the two parameters were not sampled.
 */
export function sliceOf(grid: ForbiddenData, names: string[], cyclic: boolean[], { across, up, third, value }: Section): Slice | null {
  const sampled = sampledBy(grid, names);
  const [a, b] = [sampled.indexOf(across), sampled.indexOf(up)];
  if (a < 0 || b < 0 || a === b) return null;
  if (sampled.includes(-1)) return null;
  const c = 3 - a - b;
  const fixed = sampled[c] ?? -1;
  const wanted = third === fixed ? value : withinTurn(grid.at[fixed] ?? 0, cyclic[fixed]);
  const values = fixed < 0 ? [0] : middles(grid, c);
  const layer = values.reduce((best, each, i) => (Math.abs(each - wanted) < Math.abs(values[best] - wanted) ? i : best), 0);
  const strides = [1, countOf(grid, 0), countOf(grid, 0) * countOf(grid, 1)];
  const all = cells(grid);
  const blocked: boolean[] = [];
  for (let j = 0; j < countOf(grid, b); ++j) {
    for (let i = 0; i < countOf(grid, a); ++i) blocked.push(all[i * strides[a] + j * strides[b] + layer * strides[c]] === 1);
  }
  return { across: borders(grid, a), up: borders(grid, b), blocked, third: fixed, value: values[layer] };
}

/** The forbidden cells of a slice as rectangles, equal neighbours of a row as one: from, to, below, above. */
export function rectangles({ across, up, blocked }: Slice): [number, number, number, number][] {
  const columns = across.length - 1;
  const result: [number, number, number, number][] = [];
  for (let j = 0; j + 1 < up.length; ++j) {
    for (let i = 0; i < columns; ++i) {
      if (!blocked[j * columns + i]) continue;
      let end = i + 1;
      while (end < columns && blocked[j * columns + end]) ++end;
      result.push([across[i], across[end], up[j], up[j + 1]]);
      i = end;
    }
  }
  return result;
}
