import { describe, expect, it } from 'vitest';
import { Player } from '../src/player';
import { makeFilm, robot, type RecordData } from './film_maker';

const pose = [0, 0, 0, 0, 0, 0, 1];
const step = (run: number, t: number, ok = 1): RecordData => ({ kind: 'try', run, t, command: 'move_to', parameter: 'x',
  place: 1, ok,
  reason: ok ? '' : 'hit', moved: ok ? '' : 'a.b', met: ok ? '' : 'c' });

/** Two tasks that go on at once, a pause between, and a rejected one that was tried for longer than all. */
const film = () => makeFilm({
  header: { robots: [robot('a', ['x']), robot('b', ['x'])] }, end: 100,
  runs: [{ task: 'one', robot: 0, start: 0, end: 20 }, { task: 'two', robot: 1, start: 5, end: 30 },
    { task: 'no', robot: 0, start: 20, end: 150, result: 'rejected', happened: false },
      { task: 'three', robot: 0, start: 60, end: 100 }],
  records: [
    step(0, 4), step(0, 8), step(1, 7), step(0, 8, 0), { kind: 'wait', run: 1, t: 9 },
      { kind: 'detach', run: 0, t: 20, component: 0, pose },
    step(2, 40), { kind: 'detach', run: 2, t: 45, component: 0, pose }, step(2, 150, 0), { kind: 'task_end', run: 2, t: 20 },
    { kind: 'detach', run: 1, t: 28, component: 1, pose }, step(3, 70), { kind: 'remove', run: 3, t: 90, component: 0 },
  ],
});

describe('player', () => {
  it('steps through one run, forwards and backwards', () => {
    const player = new Player(film());
    player.select({ kind: 'run', index: 0 });
    const seen: (number | null)[] = [];
    for (const by of [1, 1, 1, 1, -1, -1, -1] as const) {
      player.step(by);
      seen.push(player.record);
    }
    expect(seen).toEqual([0, 1, 3, 3, 1, 0, 0]);
    expect(player.time).toBe(4);
  });

  it('steps to what comes next in time where no run is picked', () => {
    const player = new Player(film());
    player.seek(5);
    player.step(1);
    expect(player.record).toBe(2);
    player.seek(5);
    player.step(-1);
    expect(player.record).toBe(0);
    player.seek(31);
    player.step(1);
    expect(player.record).toBe(11);
  });

  it('shows a rejected run while it stands in it, for as long as it was tried', () => {
    const player = new Player(film());
    player.goToRecord(8);
    expect(player.triedRun).toBe(2);
    expect(player.time).toBe(150);
    player.goToRecord(null);
    expect(player.triedRun).toBe(-1);
    expect(player.time).toBe(100);
    player.select({ kind: 'run', index: 2 });
    player.seek(30);
    player.step(1);
    expect(player.record).toBe(6);
  });

  it('goes to where components came to stand or went, not to what was undone', () => {
    const player = new Player(film());
    const seen: number[] = [];
    for (let i = 0; i < 5; ++i) {
      player.nextComponent();
      seen.push(player.time);
    }
    expect(seen).toEqual([20, 28, 90, 100, 100]);
    player.previousComponent();
    expect(player.time).toBe(90);
    player.seek(0);
    player.previousComponent();
    expect(player.time).toBe(0);
  });

  it('passes over idle time, but not in real time', () => {
    const player = new Player(film());
    player.setLength(180);
    player.seek(25);
    player.play();
    player.tick(3);
    expect(player.time).toBe(28);
    player.tick(4);
    expect(player.time).toBe(62);
    player.setLength('real');
    player.seek(25);
    player.play();
    player.tick(10);
    expect(player.time).toBe(35);
    player.tick(100);
    expect(player.time).toBe(100);
    expect(player.playing).toBe(false);
  });

  it.each([[30, 30], [60, 60], [180, 70], ['real', 100]] as const)('plays in %s: 70 s of work and 30 s of none', (length, seconds) => {
    const player = new Player(film());
    player.setLength(length);
    player.play();
    let played = 0;
    for (; player.playing && played < 1000; ++played) player.tick(1);
    expect(Math.abs(played - seconds)).toBeLessThanOrEqual(1);
    expect(player.time).toBe(100);
  });

  it('takes a minute for months of work, and for the components alone', () => {
    const week = 7 * 86400;
    const runs = Array.from({ length: 2000 }, (_, i) => ({ task: `t${i}`, robot: 0, start: i * week, end: i * week + 40_000 }));
    const records = runs.map(({ end }, run): RecordData => ({ kind: 'detach', run, t: end, component: 0, pose }));
    const player = new Player(makeFilm({ header: { robots: [robot('a', ['x'])] }, end: 2000 * week, runs, records }));
    for (const fast of [false, true]) {
      player.seek(0);
      if (fast) player.fastPlay();
      else player.play();
      let ticks = 0;
      for (; player.playing && ticks < 1e5; ++ticks) player.tick(0.04);
      expect(ticks * 0.04).toBeGreaterThan(55);
      expect(ticks * 0.04).toBeLessThan(61);
    }
  });

  it('plays components only when it plays fast', () => {
    const player = new Player(film());
    player.fastPlay();
    player.tick(0.2);
    expect(player.time).toBe(20);
    player.stop();
    expect([player.time, player.fast, player.playing]).toEqual([0, false, false]);
  });

  it('shows the machines again when fast play is over', () => {
    const player = new Player(film());
    player.fastPlay();
    for (let i = 0; i < 20; ++i) player.tick(0.2);
    expect([player.time, player.fast, player.playing]).toEqual([100, false, false]);
  });

  it('tells who listens, and keeps time in its bounds', () => {
    const player = new Player(film());
    const told: string[] = [];
    player.on(['time', 'record', 'length'], () => told.push('told'));
    player.seek(1e9);
    expect(player.time).toBe(100);
    player.seek(-1);
    expect(player.time).toBe(0);
    player.setLength(30);
    expect(player.length).toBe(30);
    expect(told).toHaveLength(3);
  });

  it('does nothing where there is nothing', () => {
    const player = new Player(makeFilm({ end: 0, runs: [] }));
    player.step(1);
    player.nextComponent();
    player.play();
    player.tick(1);
    expect([player.time, player.playing, player.record]).toEqual([0, false, null]);
  });
});
