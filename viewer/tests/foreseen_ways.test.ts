import { describe, expect, it } from 'vitest';
import { borderOf } from '../src/view/foreseen_ways';

const length = (pieces: ReturnType<typeof borderOf>) => pieces.reduce((sum, [a, b]) => sum + Math.hypot(b[0] - a[0], b[1] - a[1]), 0);
const square = (x: number, y: number) => [x, y, x + 2, y, x + 2, y + 2, x, y + 2];

describe('the border of what is foreseen', () => {
  it('is that of all outlines together', () => {
    expect(length(borderOf({ corners: [4], points: square(0, 0) }))).toBeCloseTo(8);
    // They overlap by a quarter: 16 m less what each has inside the other.
    expect(length(borderOf({ corners: [4, 4], points: [...square(0, 0), ...square(1, 1)] }))).toBeCloseTo(12);
    // Side by side: the common edge is no border. One inside the other: it has none.
    expect(length(borderOf({ corners: [4, 4], points: [...square(0, 0), ...square(2, 0)] }))).toBeCloseTo(12);
    expect(length(borderOf({ corners: [4, 4], points: [...square(0, 0), 0.5, 0.5, 1, 0.5, 1, 1, 0.5, 1] }))).toBeCloseTo(8);
    // The same twice is drawn once.
    expect(length(borderOf({ corners: [4, 4], points: [...square(0, 0), ...square(0, 0)] }))).toBeCloseTo(8);
  });
});
