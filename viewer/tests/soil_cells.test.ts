import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import type { ComponentData, TaskData } from '../src/header';
import { SoilCells } from '../src/soil_cells';
import { makeFilm } from './film_maker';

function soil(result: 'done' | 'rejected'): SoilCells {
  const motion_dig = { soil: 'dig.soil', pose: [1, 0, 0, 10, 0, 1, 0, 0, 0, 0, 1, 0], columns: 3, cell: 500, cells: [1, 4], before: [0, 200],
    after: [-1000, -1000] };
  const component = { name: 'dig.soil', mass: 0, pose: motion_dig.pose, shapes: [] } as unknown as ComponentData;
  return new SoilCells(makeFilm({ header: { tasks: [{ name: 'dig', motion_dig } as unknown as TaskData], components: [component] }, end: 50,
    runs: [{ task: 'dig', start: 0, end: 50, result, happened: result === 'done' }],
    soils: [{ run: 0, component: 0, t: 10, cells: [1], heights: [-500] }, { run: 0, component: 0, t: 20, cells: [1, 4], heights: [-1000, 0] }] }));
}

/** Heights of the tops and bottoms of both columns, as they are drawn; null: as before. */
function drawn(cells: SoilCells, time: number): (number[] | null)[] {
  const frames = new Map(cells.seek(time));
  return cells.shapes.map(([{ lower, upper }], i) => {
    const frame = frames.get(i);
    return frame ? [upper, lower].map((p) => Number(new Vector3(...(p as [number, number, number])).applyMatrix4(frame).z.toFixed(6))) : null;
  });
}

describe('soil that a robot digs', () => {
  it('goes down cell by cell, and comes back', () => {
    const cells = soil('done');
    expect(cells.shapes[1][0].lower).toEqual([0.5, 0.5, -1]);
    expect(drawn(cells, 0)).toEqual([[0, -1], [0.2, -1]]);
    expect(drawn(cells, 10)).toEqual([[-0.5, -1], null]);
    const [gone, lower] = drawn(cells, 30);
    expect(gone?.[0]).toBeLessThan(-1e5);
    expect(lower).toEqual([0, -1]);
    expect(drawn(cells, 5)).toEqual([[0, -1], [0.2, -1]]);
  });

  it('stays where its task was refused', () => {
    expect(drawn(soil('rejected'), 40)).toEqual([[0, -1], [0.2, -1]]);
  });
});

describe('soil that trucks tip', () => {
  it('grows cell by cell from the ground', () => {
    const pose = [1, 0, 0, 10, 0, 1, 0, 0, 0, 0, 1, 0];
    const component = { name: 'yard.heap', mass: 0, pose, shapes: [] } as unknown as ComponentData;
    const heaps = [{ component: 'yard.heap', pose: pose as never, columns: 3, cell: 500, ground: [0, 100, 0, 0, 0, 0] }];
    const cells = new SoilCells(makeFilm({ header: { tasks: [], components: [component], heaps }, end: 50,
      runs: [{ task: 'haul', start: 0, end: 50, result: 'done', happened: true }],
      soils: [{ run: 0, component: 0, t: 10, cells: [1, 4], heights: [600, 200] }, { run: 0, component: 0, t: 20, cells: [1], heights: [1100] }] }));
    expect([...cells.components]).toEqual([0]);
    expect(cells.shapes[0][0].upper).toEqual([1, 0.5, 1.1]);
    const [before, none] = drawn(cells, 5);
    expect(before?.[0]).toBeLessThan(-1e5);
    expect(none?.[0]).toBeLessThan(-1e5);
    expect(drawn(cells, 12)).toEqual([[0.6, 0.1], [0.2, 0]]);
    expect(drawn(cells, 30)).toEqual([[1.1, 0.1], null]);
  });
});
