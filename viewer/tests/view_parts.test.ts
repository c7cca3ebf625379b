import { Box3, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { Activity } from '../src/activity';
import { Mechanism } from '../src/kinematics';
import { kindOf } from '../src/view/looks';
import { quantity } from '../src/view/quantity';
import { Quality } from '../src/view/quality';
import { cabOf } from '../src/view/ride';
import { makeFilm, makeHoist } from './make_film';

test.each([
  ['u_1_2.wall_3', 'wall'], ['north_1', 'north'], ['slab', 'slab'], ['d_1_1.pallet', 'pallet'], ['12', '12'],
])('%s is a %s', (name, kind) => {
  expect(kindOf(name)).toBe(kind);
});

test('quantities have no zeros that say nothing', () => {
  expect([quantity(2.5, 0), quantity(1.255, 1), quantity(-0.0001, 2)]).toEqual(['3', '1.3', '0']);
});

test('pictures get coarser while they are slow and finest at rest', () => {
  const quality = new Quality(() => 1);
  let now = 0;
  const play = (gap: number) => { for (let i = 0; i < 600; ++i) quality.moved(now += gap); };
  play(16);
  expect(quality.ratio).toBe(1);
  expect(quality.rate).toBeCloseTo(62.5);
  play(60);
  expect(quality.ratio).toBe(0.5);
  expect(quality.rests(now + 50)).toBe(false);
  expect(quality.rests(now + 500)).toBe(true);
  expect(quality.ratio).toBe(2);
  expect(quality.rests(now + 600)).toBe(false);
  play(16);
  expect(quality.ratio).toBe(1);
});

test('who rides a crane sits below its jib, who rides a truck behind and above it', () => {
  const high = new Mechanism(makeHoist('hoist'));
  high.place([10, 2]);
  const box = new Box3(new Vector3(-0.4, -0.4, 0), new Vector3(0.4, 0.4, 0.5));
  const crane = cabOf(high, () => box, (body) => body === 0);
  expect(crane.at.toArray()).toEqual([10, 0, 2]);
  expect(crane.eye.z).toBeLessThan(9);
  expect(crane.eye.z).toBeGreaterThan(8);
  const low = new Mechanism(makeHoist('hoist', [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -9]));
  low.place([10, 9]);
  expect(cabOf(low, () => box, (body) => body === 0).eye.z).toBeGreaterThan(2);
});

test('what goes on at a moment, in words', () => {
  const activity = new Activity(makeFilm({
    header: { robots: [makeHoist('one'), makeHoist('two')] }, strings: ['', 'hook', 'riggers', 'machine', 'two', 'shift'],
    runs: [{ robot: 0, start: 0, end: 50 }, { robot: -1, start: 10, end: 20 }, { robot: 0, start: 50, end: 90, happened: false },
      { robot: 0, start: 60, end: 70 }, { robot: 1, start: 60 }],
    records: [
      { kind: 'work', run: 0, t: 20, columns: { 'work.what': 1, 'work.crew': 2, 'work.from': 10, 'work.time': 10 } },
      { kind: 'pause', run: 0, t: 30, columns: { 'pause.why': 3, 'pause.for': 4, 'pause.from': 25 } },
      { kind: 'pause', run: 0, t: 40, columns: { 'pause.why': 5, 'pause.for': 0, 'pause.from': 30 } },
    ],
  }));
  expect([5, 10, 19.9, 20, 25, 30, 45].map((t) => activity.words(0, t)))
    .toEqual(['moves', 'hook (riggers)', 'hook (riggers)', 'moves', 'waits for two', 'waits for the next shift', 'moves']);
  expect(activity.running(15)).toEqual([0, 1]);
  expect(activity.running(65)).toEqual([3, 4]);
  expect(activity.running(65, 2)).toEqual([2, 4]);
});
