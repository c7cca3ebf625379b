import { Box3, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { withBuffer } from '../src/view/buffers';
import { identity } from './make_film';

const bounds = new Box3(new Vector3(0, 0, 0), new Vector3(2, 2, 1));

test('shapes grow on all sides', () => {
  expect(withBuffer({ type: 'box', pose: identity, lower: [0, 1, 2], upper: [3, 5, 4] }, 0.5, bounds))
    .toMatchObject({ lower: [-0.5, 0.5, 1.5], upper: [3.5, 5.5, 4.5] });
  expect(withBuffer({ type: 'cylinder', pose: identity, radius: 2, z0: -1, z1: 4 }, 0.5, bounds))
    .toMatchObject({ radius: 2.5, z0: -1.5, z1: 4.5 });
  expect(withBuffer({ type: 'capsule', pose: identity, a: [0, 0, 0], b: [1, 0, 0], radius: 1 }, 0.5, bounds))
    .toMatchObject({ radius: 1.5, a: [0, 0, 0] });
});

test('prisms and meshes are shown by the box round them', () => {
  expect(withBuffer({ type: 'prism', pose: identity, z0: 0, z1: 1, polygon: [[0, 0], [2, 0], [2, 2]] }, 0.5, bounds))
    .toMatchObject({ type: 'box', lower: [-0.5, -0.5, -0.5], upper: [2.5, 2.5, 1.5] });
});
