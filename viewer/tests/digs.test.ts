import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { Digs } from '../src/digs';
import type { ComponentData, TaskData } from '../src/header';
import { poseRows } from '../src/kinematics';
import { Matrix4 } from 'three';
import { makeFilm } from './film_maker';

const pose = poseRows(new Matrix4());
const soil = { name: 'dig.soil', mass: 0, pose, shapes: [{ type: 'box', pose, lower: [0, 0, -2], upper: [4, 4, 1] }, { type: 'box', pose, lower: [4, 0, -1], upper: [5, 4, 1] }] };

function digs(): Digs {
  const tasks = [{ name: 'dig', dig: { soil: 'dig.soil' } }, { name: 'walk' }] as unknown as TaskData[];
  return new Digs(makeFilm({ header: { tasks, components: [soil as unknown as ComponentData] }, end: 200,
    runs: [{ task: 'walk', start: 0, end: 50 }, { task: 'dig', start: 50, end: 150 }],
    records: [{ kind: 'work', run: 0, t: 50, what: 'takes', crew: '', from: 0, time: 50 },
      { kind: 'work', run: 1, t: 150, what: 'takes', crew: '', from: 50, time: 100 }] }));
}

/** Where the top and the bottom of the soil are at a moment. */
function heights(all: Digs, time: number): number[] | null {
  const [found] = all.seek(time, new Set());
  return found ? [1, -2].map((z) => Number(new Vector3(0, 0, z).applyMatrix4(found[1]).z.toFixed(6))) : null;
}

describe('soil that is dug', () => {
  it('goes down to its bottom while its task goes on', () => {
    const all = digs();
    expect(heights(all, 20)).toBeNull();
    expect(heights(all, 100)).toEqual([-0.5, -2]);
    expect(heights(all, 100)).toBeNull();
    expect(heights(all, 150)).toEqual([-1.997, -2]);
    expect(heights(all, 10)).toEqual([1, -2]);
  });

  it('is told anew where it came back', () => {
    const all = digs();
    expect(all.seek(0, new Set([0])).length).toBe(1);
  });
});
