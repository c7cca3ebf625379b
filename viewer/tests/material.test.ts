import { expect, test } from 'vitest';
import { stockPath } from '../src/panels/material';

test('the stock is a stepped line over the whole plan', () => {
  const stock = [{ t: 0, count: 2, mass: 0 }, { t: 50, count: 1, mass: 0 }, { t: 75, count: 0, mass: 0 }];
  expect(stockPath(stock, 100, 2)).toBe('M0 1H55V14H82.5V27H110');
});

test('a place that never had anything is a line at the bottom', () => {
  expect(stockPath([{ t: 0, count: 0, mass: 0 }], 0, 0)).toBe('M0 27H110');
});
