import { describe, expect, it } from 'vitest';
import type { ForbiddenData } from '../src/film';
import { rectangles, sliceOf } from '../src/forbidden';

// z and x span three columns and two rows, in layers for theta.
const grid: ForbiddenData = {
  parameters: ['z', 'x', 'theta'], low: [0, 10], high: [6, 14], cells: [3, 2], layers: [-90, 0, 30], at: [10, 0, 365],
  // Layer by layer: 1 1 0 / 0 0 1, none, 0 1 1 / 1 1 1.
  runs: [0, 2, 3, 1, 7, 5],
};
const names = ['x', 'y', 'theta', 'z'];
const cyclic = [false, false, true, false];
const of = (across: string, up: string, third: string, value = 0) =>
  sliceOf(grid, names, cyclic, { across: names.indexOf(across), up: names.indexOf(up), third: names.indexOf(third), value, reach: 0 });
const bits = (blocked?: boolean[]) => blocked?.map(Number).join('');

describe('forbidden cells', () => {
  it('are of the layer that is nearest to the slider', () => {
    expect(of('z', 'x', 'theta', -50)).toEqual({ across: [0, 2, 4, 6], up: [10, 12, 14], blocked: [true, true, false, false, false, true], third: 2, value: -90 });
    expect(bits(of('z', 'x', 'theta', 14)?.blocked)).toBe('000000');
    expect(bits(of('z', 'x', 'theta', 1e9)?.blocked)).toBe('011111');
  });

  it('are spanned by any two of the three parameters, either way', () => {
    expect(bits(of('x', 'z', 'theta', -90)?.blocked)).toBe('101001');
    // Layers as rows: borders half-way between them. The slider over x: its second row.
    expect(of('z', 'theta', 'x', 13.5)).toEqual({ across: [0, 2, 4, 6], up: [-90, -45, 15, 30],
      blocked: [false, false, true, false, false, false, true, true, true], third: 0, value: 13 });
  });

  it('are as where the search began where the slider has another parameter, or none', () => {
    expect(of('z', 'x', 'y', -90)).toMatchObject({ third: 2, value: 0 });
    expect(of('z', 'x', 'none', -90)).toMatchObject({ third: 2, value: 0 });
    const flat = sliceOf({ ...grid, parameters: ['z', 'x'], layers: [], runs: [5, 1] }, names, cyclic, { across: 3, up: 0, third: 2, value: 5, reach: 0 });
    expect(flat).toMatchObject({ third: -1, blocked: [false, false, false, false, false, true] });
  });

  it('are not known of other parameters', () => {
    expect(of('z', 'y', 'theta')).toBeNull();
    expect(of('y', 'x', 'theta')).toBeNull();
    expect(of('z', 'z', 'theta')).toBeNull();
  });

  it('are drawn as one rectangle where they are neighbours in a row', () => {
    const slice = of('z', 'x', 'theta', 30);
    expect(slice && rectangles(slice)).toEqual([[2, 6, 10, 12], [0, 6, 12, 14]]);
  });
});
