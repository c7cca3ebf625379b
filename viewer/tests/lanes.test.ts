import { expect, test } from 'vitest';
import type { NetworkData, PoseRows } from '../src/header';
import { spotsOf } from '../src/panels/lanes';

const pose = (x: number, y: number): PoseRows => [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, 0];
const network: NetworkData = {
  name: 'yard', classes: [], lanes: [{ from: 0, to: 1, class: 0 }],
  nodes: [{ name: 'a', pose: pose(0, 0) }, { name: 'b', pose: pose(100, 0) }, { name: 'c', pose: pose(0, 50) }],
};
const waits = (node: string, waited: number, of = 'yard') => ({ network: of, node, waits: 1, waited, longest: waited, most: 1 });

test('a spot is as large as the wait, and the north is up', () => {
  const { spots, height } = spotsOf(network, [waits('b', 40), waits('c', 10), waits('a', 99, 'other')]);
  expect(spots.map(({ heat }) => heat)).toEqual([0, 1, 0.25]);
  expect(spots[1].radius).toBe(11);
  expect(spots[2].radius).toBeCloseTo(1.5 + 9.5 / 2);
  expect([spots[0].x, spots[1].x]).toEqual([16, 424]);
  expect(spots[2].y).toBeLessThan(spots[0].y);
  expect(height).toBeCloseTo(204 + 32);
});

test('one node and no waits', () => {
  const { spots } = spotsOf({ ...network, nodes: [network.nodes[0]], lanes: [] }, []);
  expect(spots).toEqual([{ x: 220, y: 16, radius: 1.5, heat: 0 }]);
});
