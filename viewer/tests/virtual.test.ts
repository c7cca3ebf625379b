import { describe, expect, it } from 'vitest';
import { scrollToRow, visibleRows } from '../src/virtual';

describe('long lists', () => {
  it('hold the rows that are seen and a few more, at their places', () => {
    expect(visibleRows(0, 100, 20, 1000)).toEqual({ first: 0, after: 9, top: 0, height: 20000 });
    expect(visibleRows(1010, 100, 20, 1000)).toEqual({ first: 46, after: 60, top: 920, height: 20000 });
    expect(visibleRows(19900, 100, 20, 1000).after).toBe(1000);
    expect(visibleRows(0, 100, 20, 0)).toEqual({ first: 0, after: 0, top: 0, height: 0 });
    expect(visibleRows(50, 100, 20, 3)).toMatchObject({ first: 0, after: 3 });
  });

  it('reach every row of a million, though no element is that high', () => {
    const [view, row, count] = [400, 20, 1e6];
    const { height } = visibleRows(0, view, row, count);
    expect(height).toBeLessThan(1e7);
    const last = visibleRows(height - view, view, row, count);
    expect(last.after).toBe(count);
    // The last row ends where the list ends.
    expect(last.top + (last.after - last.first) * row).toBeCloseTo(height, 3);
    for (const wanted of [0, 1, 12345, 500000, 999999]) {
      const at = scrollToRow(wanted, 0, view, row, count);
      const seen = visibleRows(at, view, row, count, 0);
      expect(wanted).toBeGreaterThanOrEqual(seen.first);
      expect(wanted).toBeLessThan(seen.after);
    }
  });

  it('do not move to a row that is seen', () => {
    expect(scrollToRow(5, 40, 200, 20, 1000)).toBe(40);
    expect(scrollToRow(1, 40, 200, 20, 1000)).toBe(0);
    // A third of ten rows is above it, and no row is cut in two.
    expect(scrollToRow(12, 40, 200, 20, 1000)).toBe((12 - 3) * 20);
    expect(scrollToRow(999, 0, 200, 20, 1000)).toBe(19800);
  });
});
