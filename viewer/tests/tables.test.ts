import { describe, expect, it } from 'vitest';
import { mark, sliderMarks } from '../src/marks';
import { Player } from '../src/player';
import { Runs, tallyText } from '../src/runs';
import { lengthName, lengths, nextLength, speedOf } from '../src/lengths';
import { filtered, sorted, tableRows } from '../src/task_table';
import type { ScheduledTask } from '../src/header';
import { makeFilm, robot, type RecordData } from './film_maker';

const scheduled = (task: string, start: number, cost: number): ScheduledTask => ({
  task, robot: 'crane', crew: '', start, duration: 10, motion: 6, work: 4,
  waited: { predecessor: 1, resource: 2, machine: 3, shift: 4 }, cost, tried: 5, accepted: 4, result: 'done', reason: '',
  float: { total: 30, free: 0 },
});

const refusedTry = (run: number, t: number): RecordData => ({
  kind: 'try', run, t, command: 'move_to', parameter: 'x', place: 1, ok: 0, reason: 'hit', moved: 'a', met: 'b',
});

const film = () => makeFilm({
  header: { robots: [robot('crane', ['x'])], components: [{ name: 'beam', pose: [], grip: [], mass: 1, shapes: [] }],
    tasks: [{ name: 'set_10', robot: 'crane', crews: [], move: 'beam', zones: [], after: [] }] },
  schedule: { tasks: [scheduled('park crane', 50, 2), scheduled('set_10', 0, 7), scheduled('park crane', 20, 1)],
    process_time: 100,
    resources: [], critical: [{ task: 'set_10', work_counts: true, text: 'set_10 starts with the plan' }] },
  end: 100,
  runs: [{ task: 'set_10', robot: 0, start: 0, end: 10 }, { task: 'park crane', robot: 0, start: 20, end: 30 },
    { task: 'park crane', robot: 0, start: 50, end: 60 },
    { task: 'set_9', robot: 0, start: 60, end: 95, result: 'rejected', reason: 'blocked by wall at step 2 (z, line 4)',
      happened: false }],
  records: [{ kind: 'task_start', run: 0, t: 0 }, refusedTry(0, 5), { kind: 'task_start', run: 3, t: 60 },
    { kind: 'wait', run: 3, t: 61 },
    refusedTry(3, 61), refusedTry(3, 61), { kind: 'end', run: 3, t: 95, status: 'done', message: '', reached: 0, tries: 3,
      accepted: 1 },
    { kind: 'task_end', run: 3, t: 60 }],
});

describe('runs', () => {
  it('find their rows in the schedule, also where several have one name', () => {
    const runs = new Runs(film());
    expect([0, 1, 2, 3].map((run) => runs.row(run)?.cost ?? null)).toEqual([7, 1, 2, null]);
    expect([0, 3].map((run) => runs.isCritical(run))).toEqual([true, false]);
  });

  it('are counted as the command counts: machines that only go out of the way are no tasks', () => {
    const tally = new Runs(film()).tally();
    expect(tally).toEqual({ tasks: 1, done: 1, short: 0, rejected: 0, notReached: 0, elements: 1, placed: 1 });
    expect(tallyText(tally)).toBe('all done');
    expect(tallyText({ ...tally, tasks: 9, rejected: 4, notReached: 2 })).toBe('4 rejected, 2 not reached');
    expect(tallyText({ ...tally, tasks: 1, done: 0, short: 1 })).toBe('1 short');
    expect(tallyText({ ...tally, tasks: 0, done: 0 })).toBe('');
  });

  it('know what goes on, and the last record at a moment', () => {
    const runs = new Runs(film());
    expect([0, 10, 25, 70].map((t) => runs.current(t))).toEqual([[0], [], [1], []]);
    expect([0, 4.9, 5, 99].map((t) => runs.recordAt(0, t))).toEqual([0, 0, 1, 1]);
    expect([0, 60, 61, 100].map((t) => runs.recordAt(3, t))).toEqual([2, 2, 5, 6]);
    expect(runs.recordAt(1, 25)).toBe(-1);
  });

  it('show what was tried in place of what its robot did', () => {
    const runs = new Runs(film());
    const player = new Player(runs.film);
    player.seek(5);
    expect(runs.shown(player)).toEqual([0]);
    player.goToRecord(4);
    expect(runs.shown(player)).toEqual([3]);
  });

  it('lead to the attempt that was refused', () => {
    expect(new Runs(film()).refusedAt(3)).toBe(4);
  });

  it('follow what is picked', () => {
    const runs = new Runs(film());
    const player = new Player(runs.film);
    expect(runs.focused(player)).toBe(-1);
    player.select({ kind: 'component', index: 0 });
    expect(runs.focused(player)).toBe(0);
    player.seek(25);
    player.select({ kind: 'robot', index: 0 });
    expect(runs.focused(player)).toBe(1);
    player.goToRecord(4);
    expect(runs.focused(player)).toBe(3);
  });
});

describe('table of tasks', () => {
  const rows = tableRows(new Runs(film()));
  const names = (found: typeof rows) => found.map((row) => `${row.name} ${row.start}`);

  it('adds the waits up and leaves out what is not known', () => {
    expect(rows[0]).toMatchObject({ who: 'crane', waits: 9, duration: 10, cost: 7, float: 30, result: 'done' });
    expect(rows[3]).toMatchObject({ duration: null, waits: null, cost: null, float: null, result: 'rejected' });
  });

  it('sorts by names as people do, and what is not known last both ways', () => {
    expect(names(sorted(rows, 'name', false))).toEqual(['park crane 20', 'park crane 50', 'set_9 60', 'set_10 0']);
    expect(sorted(rows, 'cost', false).map((row) => row.cost)).toEqual([1, 2, 7, null]);
    expect(sorted(rows, 'cost', true).map((row) => row.cost)).toEqual([7, 2, 1, null]);
  });

  it('finds every word, wherever it stands', () => {
    expect(names(filtered(rows, ' CRANE park '))).toEqual(['park crane 20', 'park crane 50']);
    expect(names(filtered(rows, 'wall rejected'))).toEqual(['set_9 60']);
    expect(filtered(rows, '(')).toHaveLength(1);
    expect(filtered(rows, '')).toBe(rows);
  });
});

describe('marks of the slider', () => {
  it('are at most one of a kind a pixel, at the right place', () => {
    const marks = sliderMarks(film(), [[0, 30], [50, 60]], 10);
    expect(marks).toHaveLength(10);
    expect(marks[0]).toBe(mark.busy | mark.start | mark.blocked);
    expect(marks[2]).toBe(mark.busy | mark.start);
    expect(marks[4]).toBe(0);
    expect(marks[6]).toBe(mark.busy | mark.refused);
    expect(sliderMarks(film(), [], 0)).toHaveLength(0);
    expect(sliderMarks(makeFilm({ end: 0, runs: [{ task: 'a', start: 0, end: 0 }] }), [], 5)[0]).toBe(mark.start);
  });
});

describe('lengths', () => {
  it('are kept by long plans, and slow no plan down', () => {
    expect([0, 12, 60, 120, 5400, 26e6].map((worked) => speedOf(60, worked))).toEqual([1, 1, 1, 2, 90, 26e6 / 60]);
    expect(lengths.map((length) => speedOf(length, 1800))).toEqual([60, 30, 10, 1]);
  });

  it('go from 30 s to real time and no farther', () => {
    expect(lengths.map(lengthName)).toEqual(['30 s', '1 min', '3 min', 'real time']);
    expect([nextLength(60, 1), nextLength(60, -1), nextLength(180, -1), nextLength(30, 1), nextLength('real', -1),
      nextLength('real', 1)]).toEqual([30, 180, 'real', 30, 'real', 180]);
  });
});
