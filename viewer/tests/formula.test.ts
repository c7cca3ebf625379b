import { expect, test } from 'vitest';
import { cosDegrees, parseFormula, parseFrame, sinDegrees } from '../src/formula';

const names = ['x', 'hook.z', 'jib.theta', 'x_2'];
const value = (text: string) => parseFormula(text, names)([3, 14, 30, 100]);

test.each([
  ['2 + 3 * 4', 14],
  ['(2 + 3) * 4', 20],
  ['2 - 3 - 4', -5],
  ['24 / 4 / 3', 2],
  ['24 / (4 / 2)', 12],
  ['-x', -3],
  ['-x * -2', 6],
  ['2 - -x', 5],
  ['x-1', 2],
  ['-(x + 1)', -4],
  ['1e-05 * 1e5', 1],
  ['1.5e2', 150],
  ['.5', 0.5],
  ['hook.z - 31.2', -17.2],
  ['(2 * hook.z - 68) / 3', -40 / 3],
  ['sin(jib.theta)', 0.5],
  ['cos(2 * jib.theta)', 0.5],
  ['x_2 + x', 103],
])('%s', (text, expected) => {
  expect(value(text)).toBeCloseTo(expected, 12);
});

test('right angles are exact', () => {
  expect([0, 90, 180, 270, 360, -90].map(sinDegrees)).toEqual([0, 1, 0, -1, 0, -1]);
  expect([0, 90, 180, 270, 450].map(cosDegrees)).toEqual([1, 0, -1, 0, 0]);
});

test.each(['', '2 +', '(2', 'y', 'x 2', 'sin 3', 'x ^ 2', '2 + )'])('no formula: %s', (text) => {
  expect(() => parseFormula(text, names)).toThrow(/expected .* found/);
});

test('a frame is a product of shifts and turns', () => {
  expect(parseFrame('trans(x, 0, 31.2) * rotz(jib.theta)', names).map((element) => element.kind)).toEqual(['trans', 'rotz']);
  expect(() => parseFrame('trans(x, 0)', names)).toThrow("expected ,, found ')'");
  expect(() => parseFrame('turn(x)', names)).toThrow('expected trans, rotx, roty or rotz');
});
