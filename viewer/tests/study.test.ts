import { expect, test } from 'vitest';
import { axisTime, padded, step, ticks } from '../src/study/chart';
import { namesOf } from '../src/study/pictures';
import { cell, clock, command, comparedWith, differenceText, firstShown, moment, rowsOf, settings, shown, type Study, type Variant } from '../src/study/data';

const answer = (mean: number, p80: number | null) => ({
  finished: 50, mean, quantiles: [{ p: 0.8, value: p80, interval: [null, null] as [null, null], run: 3 }],
});
const variant = (number: number, floors: string, mean: number, p80: number | null): Variant => ({
  variant: number, set: { floors, crane: 'low' }, runs: 50, unfinished: 0, again: `rubicon run p.plan --set floors=${floors} --sample 7:0`,
  answers: [answer(mean, p80)],
});
const study = (variants: Variant[], more: Partial<Study> = {}): Study => ({
  study: 's', plan: 'p.plan', design: 'full', sampled: true, runs: 50, seed: 7, questions: [{ text: 'makespan', unit: 's' }], asked: [0],
  parameters: ['floors', 'crane'], variants, pareto: [], ...more,
});

test('numbers are written as in the table of the command', () => {
  const one = variant(1, '2', 1, 2);
  expect(clock(3661.4)).toBe('1:01:01');
  expect(clock(-59.6)).toBe('-0:01:00');
  expect(shown('s', null, one)).toBe('never');
  expect(shown('s', undefined, one)).toBe('–');
  expect(shown('share', 0.256, one)).toBe('25.6 %');
  expect(shown('moment', 3600, one)).toBe('1:00:00');
  expect(shown('moment', 3660, { ...one, start_at: '2026-02-28 23:30' })).toBe('2026-03-01 00:31');
  expect(moment('2024-02-28 08:00', 86400)).toBe('2024-02-29 08:00');
  expect(settings({ ...one, set: {} })).toBe('as the plan says');
});

test('rows are filtered by words and sorted by numbers; never is last, what is not there behind it', () => {
  const all = study([variant(1, '10', 30, 5), variant(2, '9', 10, null), { variant: 3, set: { floors: '9', crane: 'high' }, fault: 'no' }, variant(4, '11', 20, 1)]);
  const numbers = (...of: Parameters<typeof rowsOf> extends [Study, ...infer Rest] ? Rest : never) => rowsOf(all, ...of).map((each) => each.variant);
  expect(numbers('', { parameter: 'floors' }, false)).toEqual([2, 3, 1, 4]);
  expect(numbers('', { question: 0, of: 'mean' }, true)).toEqual([1, 4, 2, 3]);
  expect(numbers('', { question: 0, of: 0.8 }, false)).toEqual([4, 1, 2, 3]);
  expect(numbers('floors 9', 'variant', false)).toEqual([2, 3]);
  expect(numbers('HIGH', 'variant', false)).toEqual([3]);
  expect(cell(all.variants[2], 'rejected')).toBeUndefined();
});

test('the chosen one is shown first, or the first that runs', () => {
  const variants = [{ variant: 1, set: {}, fault: 'no' }, variant(2, '2', 1, 2), variant(3, '3', 1, 2)];
  expect(firstShown(study(variants)).variant).toBe(2);
  expect(firstShown(study(variants, { pareto: [3] })).variant).toBe(3);
  const choice = { direction: 'least', statistic: 'mean(cost)', with: [], chosen: 2, equal: [2], passed_over: [] };
  expect(firstShown(study(variants, { choice, pareto: [3] })).variant).toBe(2);
});

test('a run of a variant has its command', () => {
  expect(command(variant(1, '10', 1, 2), 31)).toBe('rubicon run p.plan --set floors=10 --sample 7:31');
});

test('variants in one place of the picture are named together, once', () => {
  const at = (name: number, x: number) => ({ name, x, y: 50 });
  expect(namesOf([at(6, 100), at(5, 101), at(1, 300), at(4, 99)])).toEqual(['', '', '1', '4, 5, 6']);
  expect(namesOf([7, 6, 5, 4, 3, 2, 1].map((name) => at(name, 0)))[6]).toBe('1, 2, 3, 4, 5, 6, …');
});

test('axes have round numbers', () => {
  expect(ticks(0, 1, 5, false)).toEqual([0, 0.2, 0.4, 0.6000000000000001, 0.8, 1]);
  expect(step(4 * 86400, 6, true)).toBe(86400);
  expect(step(50 * 60, 6, true)).toBe(600);
  expect(step(1e9, 6, true)).toBe(200000000);
  expect(axisTime(5400, 3600)).toBe('1.5 h');
  expect(axisTime(23400, 1800)).toBe('6.5 h');
  expect(ticks(3, 3, 5, false)).toEqual([3]);
  expect(padded([10, 10])).toEqual({ low: 9.4, high: 10.6 });
  expect(padded([0, 0])).toEqual({ low: 0, high: 1 });
});

test('variants are compared with the first that runs', () => {
  const more = { ...answer(7200, null), difference: { mean: 3600, interval: [3000, 4200] as [number, number], runs: 50 } };
  const one = variant(2, '3', 1, 2);
  expect(differenceText('moment', more, one)).toBe('+1:00:00 ± 0:10:00');
  expect(differenceText('money', { difference: { mean: -5, runs: 1 } }, one)).toBe('-5.00');
  expect(differenceText('s', answer(1, 2), one)).toBe('');
  expect(comparedWith(study([{ variant: 1, set: {}, fault: 'no' }, one]))?.variant).toBe(2);
  expect(cell({ ...one, answers: [more] }, { question: 0, of: 'difference' })).toBe(3600);
});
