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

  it('passes over idle time, if it shall', () => {
    const player = new Player(film());
    player.setSpeed(10);
    player.seek(25);
    player.play();
    player.tick(0.2);
    expect(player.time).toBe(27);
    player.tick(0.4);
    expect(player.time).toBe(60);
    player.setSkipsIdle(false);
    player.seek(25);
    player.play();
    player.tick(1);
    expect(player.time).toBe(35);
    player.tick(100);
    expect(player.time).toBe(100);
    expect(player.playing).toBe(false);
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

  it('tells who listens, and keeps speed and time in their bounds', () => {
    const player = new Player(film());
    const told: string[] = [];
    player.on(['time', 'record', 'speed'], () => told.push('told'));
    player.seek(1e9);
    expect(player.time).toBe(100);
    player.seek(-1);
    expect(player.time).toBe(0);
    player.setSpeed(1e9);
    expect(player.speed).toBe(600);
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
