import { Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import type { ShapeData } from '../src/header';
import { addShape } from '../src/view/solids';
import { Surface } from '../src/view/surface';
import { identity } from './make_film';

const turned = [0, -1, 0, 5, 1, 0, 0, -3, 0, 0, 1, 2];
/** A cube of 2 m about the origin, as a mesh. */
const cube = {
  vertices: [-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1],
  triangles: [0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7],
};

function surfaceOf(shape: ShapeData): Surface {
  const surface = new Surface();
  addShape(surface, shape, () => cube);
  return surface;
}

/** Of a closed surface whose faces look outwards; by the divergence theorem. */
function volume(surface: Surface): number {
  const { positions, corners } = surface.arrays();
  const point = (i: number) => new Vector3().fromArray(positions, 3 * corners[i]);
  let sum = 0;
  for (let i = 0; i < corners.length; i += 3) sum += point(i).dot(point(i + 1).cross(point(i + 2))) / 6;
  return sum;
}

const round = (radius: number) => 20 * Math.sin(Math.PI / 20) * Math.cos(Math.PI / 20) * radius * radius;

describe.each([['at the origin', identity], ['turned and shifted', turned]])('%s', (_, pose) => {
  test.each<[string, Partial<ShapeData>, number, number]>([
    ['box', { lower: [0, 1, 2], upper: [3, 5, 4] }, 24, 1e-5],
    ['cylinder', { radius: 2, z0: -1, z1: 4 }, 5 * round(2), 1e-4],
    ['prism', { z0: 0, z1: 2, polygon: [[0, 0], [4, 0], [4, 4], [2, 1], [0, 4]] }, 2 * 10, 1e-4],
    ['prism', { z0: 0, z1: 2, polygon: [[0, 4], [2, 1], [4, 4], [4, 0], [0, 0]] }, 2 * 10, 1e-4],
    ['sphere', { centre: [1, 2, 3], radius: 1.5 }, (4 / 3) * Math.PI * 1.5 ** 3, 0.8],
    ['capsule', { a: [0, 0, 0], b: [3, 0, 4], radius: 1 }, (4 / 3) * Math.PI + 5 * Math.PI, 0.8],
    ['mesh', { mesh: 0 }, 8, 1e-5],
  ])('a %s is closed and looks outwards', (type, numbers, expected, off) => {
    const shape = { type, pose, ...numbers } as ShapeData;
    expect(Math.abs(volume(surfaceOf(shape)) - expected)).toBeLessThan(off);
  });
});

test('normals look the way the triangles do', () => {
  const shapes: Omit<ShapeData, 'pose'>[] = [
    { type: 'box', lower: [0, 0, 0], upper: [1, 2, 3] }, { type: 'cylinder', radius: 1, z0: 0, z1: 1 }, { type: 'mesh', mesh: 0 },
    { type: 'capsule', a: [0, 0, 0], b: [0, 2, 0], radius: 1 },
  ];
  for (const shape of shapes) {
    const { positions, normals, corners } = surfaceOf({ ...shape, pose: turned }).arrays();
    for (let i = 0; i < corners.length; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => new Vector3().fromArray(positions, 3 * corners[i + k]));
      const face = b.clone().sub(a).cross(c.clone().sub(a));
      if (face.length() < 1e-9) continue;
      for (let k = 0; k < 3; ++k) {
        const normal = new Vector3().fromArray(Array.from(normals.subarray(4 * corners[i + k], 4 * corners[i + k] + 3)));
        expect(face.clone().normalize().dot(normal.divideScalar(127))).toBeGreaterThan(0.8);
      }
    }
  }
});

test('a box has lines on all sides of its faces, a cube of triangles none across them', () => {
  const box = surfaceOf({ type: 'box', lower: [0, 0, 0], upper: [1, 1, 1], pose: identity }).arrays();
  for (let i = 0; i < box.rims.length; i += 4) expect([Math.abs(box.rims[i]), Math.abs(box.rims[i + 1])]).toEqual([127, 127]);
  const mesh = surfaceOf({ type: 'mesh', mesh: 0, pose: identity }).arrays();
  // Of the three sides of a triangle the diagonal is no edge: one of the three numbers is 0 at all its corners.
  for (let i = 0; i < mesh.rims.length; i += 12) {
    const zero = [0, 1, 2].filter((side) => [0, 4, 8].every((corner) => mesh.rims[i + corner + side] === 0));
    expect(zero).toHaveLength(1);
  }
});

test('an element knows its bounds in its own frame', () => {
  const surface = surfaceOf({ type: 'box', lower: [0, 0, 0], upper: [1, 2, 3], pose: turned });
  expect(surface.bounds[0].min.toArray()).toEqual([3, -3, 2]);
  expect(surface.bounds[0].max.toArray()).toEqual([5, -2, 5]);
});
