import { describe, expect, it } from 'vitest';
import { Refusals } from '../src/refusals';
import { Runs } from '../src/runs';
import { makeFilm, robot, type RecordData } from './film_maker';

const attempt = (run: number, t: number, ok: number, reason = 'hit'): RecordData => ({
  kind: 'try', run, t, command: 'move_to', parameter: 'x', place: 1, ok, reason: ok ? '' : reason, moved: '', met: '',
});

/** Refusals in the first and the third task; the fourth is rejected without one, the last was not reached. */
const film = () => makeFilm({
  header: { robots: [robot('a', ['x'])] }, end: 40,
  runs: [{ task: 'one', robot: 0, start: 0, end: 10 }, { task: 'two', robot: 0, start: 10, end: 20 },
    { task: 'three', robot: 0, start: 20, end: 30 },
    { task: 'four', robot: 0, start: 30, end: 31, result: 'rejected', reason: 'too heavy', happened: false },
    { task: 'five', robot: 0, start: 31, end: 31, result: 'not reached', reason: 'four was rejected', happened: false }],
  records: [
    { kind: 'task_start', run: 0, t: 0 }, attempt(0, 1, 0), attempt(0, 2, 1), attempt(0, 2, 0, 'limit of x'), attempt(0, 3, 0, 'at goal'),
    attempt(1, 12, 1), attempt(2, 21, 1), attempt(2, 22, 0), { kind: 'task_start', run: 3, t: 30 }, { kind: 'task_end', run: 3, t: 30 },
  ],
});

describe('refusals', () => {
  it('are gone through from task to task, forwards and backwards', () => {
    const runs = new Runs(film());
    const refusals = new Refusals(runs);
    const walk = (run: number, position: number, by: 1 | -1) => {
      const seen: number[] = [];
      for (let next = refusals.next(run, position, by); next >= 0;) {
        seen.push(next);
        run = runs.film.run(next);
        next = refusals.next(run, runs.film.recordsOf(run).indexOf(next), by);
      }
      return seen;
    };
    expect(walk(0, -1, 1)).toEqual([1, 3, 7, 9]);
    expect(walk(4, 0, -1)).toEqual([9, 7, 3, 1]);
    expect(walk(1, 0, 1)).toEqual([7, 9]);
    expect(walk(1, 0, -1)).toEqual([3, 1]);
  });

  it('end, and are none where nothing was refused', () => {
    expect(new Refusals(new Runs(film())).next(3, 1, 1)).toBe(-1);
    const free = makeFilm({ end: 1, runs: [{ task: 'a', robot: 0, start: 0, end: 1 }], header: { robots: [robot('a', ['x'])] },
      records: [attempt(0, 1, 1)] });
    expect(new Refusals(new Runs(free)).next(0, -1, 1)).toBe(-1);
    expect(new Refusals(new Runs(makeFilm({ end: 0, runs: [] }))).next(0, -1, 1)).toBe(-1);
  });
});
