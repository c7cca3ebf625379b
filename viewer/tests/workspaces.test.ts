import { describe, expect, it } from 'vitest';
import type { Header, RobotData } from '../src/header';
import { Motion } from '../src/motion';
import { hullOf, Workspaces, type Flat } from '../src/workspaces';
import { makeFilm, robot, type RecordData } from './film_maker';

const car = (name: string): RobotData => ({
  ...robot(name, ['x', 'theta']), bodies: [{ name: 'car', parent: null, frame: 'trans(x, 0, 0) * rotz(theta)', shapes: [] }], tool: { body: 'car', frame: 'trans(0, 0, 0)' },
  parameters: [['x', 'translation'], ['theta', 'rotation']].map(([parameter, kind]) => ({
    name: parameter, body: 'car', kind: kind as 'translation', cyclic: kind === 'rotation', lower: null, upper: null, step: 1, speed: 2, start: 0 })),
});
/** A metre long and wide, to the front. */
const corners = (): [number, number, number][] => [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, i & 2 ? 0.5 : -0.5, i & 4 ? 1 : 0]);
const header = { robots: [car('a'), car('b')], tasks: [], workspaces: { of: ['a', 'b'], reaction: 1, braking: 2, turn_braking: 30 } } as unknown as Partial<Header>;
const bounds = (outlines: Flat[][]) => [0, 1].flatMap((axis) => [Math.min(...outlines.flat().map((p) => p[axis])), Math.max(...outlines.flat().map((p) => p[axis]))]);
const step = (run: number, t: number): RecordData => ({ kind: 'try', run, t, ok: 1, reason: '', moved: '', met: '' });
const refused = (run: number, t: number, met: string): RecordData => ({ kind: 'try', run, t, ok: 0, reason: 'hit', moved: 'the workspace of b', met });

function site(records: RecordData[], b: { t: number[]; q: number[][] }): Workspaces {
  const film = makeFilm({
    header, end: 10, runs: [{ task: 'go_a', robot: 0, start: 0, end: 6, happened: true }, { task: 'go_b', robot: 1, start: 0, end: 10, happened: true }], records,
    tracks: [{ robot: 0, t: [0, 5], q: [[0, 0], [10, 0]] }, { robot: 1, ...b }],
  });
  return new Workspaces(film, new Motion(film), corners);
}

describe('dynamic workspaces', () => {
  it('reach as far as a machine goes until it stands, and no farther than its goal', () => {
    const spaces = site([...[0.5, 1, 4, 4.5, 5].map((t) => step(0, t)), { kind: 'end', run: 0, t: 5, reached: 1, status: 'done', message: '' }],
      { t: [0, 10], q: [[20, 0], [20, 0]] });
    // 2 m/s: a step of 1 m, 2 m of reaction, 1 m of braking, and the car is 1 m long.
    expect(bounds(spaces.at(0, 0.25)).map((value) => Math.round(value * 1e4) / 1e4)).toEqual([0, 5, -0.5, 0.5]);
    expect(bounds(spaces.at(0, 0.75))[1]).toBeCloseTo(6);
    // The goal is at 10 m.
    expect(bounds(spaces.at(0, 4.75))[1]).toBeCloseTo(11);
    expect(bounds(spaces.at(0, 5.5))).toEqual([10, 11, -0.5, 0.5]);
    expect(spaces.isMoving(0, 4.75)).toBe(true);
    expect(spaces.isMoving(0, 5.5)).toBe(false);
    expect(spaces.keyOf(0, 0.1)).toBe(spaces.keyOf(0, 0.4));
    expect(spaces.keyOf(0, 0.1)).not.toBe(spaces.keyOf(0, 0.6));
  });

  it('are of all places on a turn', () => {
    // 20 degrees a second: a step of 10 degrees, 20 of reaction, 20 / 3 of braking.
    const spaces = site([step(1, 0.5), { kind: 'end', run: 1, t: 0.5, reached: 0, status: 'budget', message: '' }], { t: [0, 0.5], q: [[0, 0], [0, 10]] });
    const outlines = spaces.at(1, 0.2);
    expect(outlines.length).toBe(Math.ceil((10 + 20 + 20 / 3) / 5));
    const far = (10 + 20 + 20 / 3) * Math.PI / 180;
    expect(bounds(outlines)[3]).toBeCloseTo(Math.sin(far) + 0.5 * Math.cos(far));
  });

  it('tell who was stopped by whom, for as long as it stood, and what it wanted', () => {
    const spaces = site([step(1, 0.5), refused(1, 0.5, 'the workspace of a'), { kind: 'pause', run: 1, t: 3, from: 0.5, why: 'machine', for: 'a' }, step(1, 3.5),
      refused(1, 3.5, 'a surveyor'), step(1, 4), { kind: 'end', run: 1, t: 4, reached: 1, status: 'done', message: '' }], { t: [0, 0.5, 3, 4], q: [[20, 0], [19, 0], [19, 0], [17, 0]] });
    expect(spaces.stops).toEqual([{ robot: 1, from: 0.5, to: 3, by: 0 }, { robot: 1, from: 3.5, to: 3.5, by: -1 }]);
    expect(spaces.stopsAt(0.4)).toEqual([]);
    expect(spaces.stopsAt(2.9).map(({ by }) => by)).toEqual([0]);
    // 2 m/s: it was at 19 m, and wanted the last step of 1 m once more, 2 m of reaction, 1 m of braking, but no farther than 17 m.
    const wanted = spaces.wantedBy(spaces.stops[0]);
    expect(bounds(wanted ?? []).map((value) => Math.round(value * 1e4) / 1e4)).toEqual([17, 20, -0.5, 0.5]);
    // A short stop is seen, too.
    expect(spaces.stopsAt(4.4).map(({ by }) => by)).toEqual([-1]);
    expect(spaces.stopsAt(4.6)).toEqual([]);
  });

  it('have convex outlines', () => {
    expect(hullOf([[0, 0], [2, 0], [1, 1], [2, 2], [0, 2], [1, 0]])).toEqual([[0, 0], [2, 0], [2, 2], [0, 2]]);
  });
});
