import { describe, expect, it } from 'vitest';
import { behaviourAt, depths, fileText, isRefusal } from '../src/behaviour';
import { sentence } from '../src/sentences';
import { Trail } from '../src/trail';
import { makeFilm, type RecordData } from './film_maker';

const attempt = (t: number, line: number, ok: number, reason = 'hit'): RecordData => ({
  kind: 'try', run: 0, t, command: 'move_to', parameter: 'x', place: line, ok, reason: ok ? '' : reason,
  moved: ok ? '' : 'crane.hook', met: ok ? '' : 'wall',
});

/** A random walk of a script: goals, loops within loops, attempts, variables. A small generator of its own keeps it the same. */
function walk(seed: number): RecordData[] {
  let state = seed;
  const random = (below: number) => {
    state = (state * 1103515245 + 12345) % 2147483648;
    return Math.floor(state / 65536) % below;
  };
  const records: RecordData[] = [{ kind: 'task_start', run: 0, t: 0 }];
  let t = 0;
  const body = (depth: number) => {
    for (let i = random(6); i >= 0; --i) {
      const what = random(5);
      if (what === 0) records.push({ kind: 'set', run: 0, t, var: `v${random(3)}`, value: String(random(100)) });
      else if (what === 1 && depth < 4) {
        const line = 10 + random(5);
        records.push({ kind: 'enter', run: 0, t, kind_: ['chain', 'cycle', 'first'][random(3)], place: line });
        body(depth + 1);
        records.push({ kind: 'exit', run: 0, t, kind_: 'chain', place: line, reached: random(2), successes: random(5) });
      } else if (what === 2) records.push({ kind: 'wait', run: 0, t: ++t });
      else if (random(2)) records.push(attempt(++t, random(9) + 1, 1));
      else records.push(attempt(t, random(9) + 1, 0));
    }
  };
  for (let k = 1; k <= 3; ++k) {
    records.push({ kind: 'goal', run: 0, t, k, n: 3 });
    body(0);
    if (k === 2) {
      // A livelock ends within its loops.
      records.push({ kind: 'enter', run: 0, t, kind_: 'chain', place: 3 }, attempt(++t, 4, 1));
      records.push({ kind: 'end', run: 0, t, status: 'livelock', message: '', reached: 0, tries: 1, accepted: 1 });
    }
  }
  return records;
}

/** The same, told again from the very beginning, in the plainest way. */
function replay(records: RecordData[], upto: number) {
  let stack: { line: number; from: number }[] = [];
  let variables: Record<string, string> = {};
  records.slice(0, upto + 1).forEach((record, i) => {
    if (record.kind === 'goal') [stack, variables] = [[], {}];
    if (record.kind === 'end') stack = [];
    if (record.kind === 'enter') stack.push({ line: Number(record.place), from: i });
    if (record.kind === 'exit') stack.pop();
    if (record.kind === 'set') variables[String(record.var)] = String(record.value);
  });
  const loops = stack.map(({ line, from }) => {
    const inside = records.slice(from, upto + 1).filter((record) => record.kind === 'try' || record.kind === 'wait');
    return { line, tries: inside.length, accepted: inside.filter((record) => record.kind === 'wait' || record.ok === 1).length };
  });
  return { loops, variables };
}

describe('behaviour', () => {
  it('stands at every record as a replay from the beginning says', () => {
    for (let seed = 1; seed <= 20; ++seed) {
      const records = walk(seed);
      const film = makeFilm({ end: 1000, runs: [{ task: 'a' }], records });
      const depth = depths(film, 0);
      records.forEach((record, i) => {
        const { loops, variables } = behaviourAt(film, 0, i);
        const expected = replay(records, i);
        const told = loops.map(({ place, tries, accepted }) => ({ line: place.line, tries, accepted }));
        expect(told).toEqual(expected.loops);
        expect(Object.fromEntries([...variables].map(([name, { value }]) => [name, value]))).toEqual(expected.variables);
        expect(depth[i]).toBe(expected.loops.length - (record.kind === 'enter' ? 1 : 0));
      });
    }
  });

  it('calls refused what something or a limit refused', () => {
    const records = [attempt(0, 1, 0), attempt(0, 1, 0, 'limit x'), attempt(0, 1, 0, 'at goal'),
      attempt(0, 1, 0, 'no direction'), attempt(1, 1, 1)];
    const film = makeFilm({ end: 1, runs: [{ task: 'a' }], records });
    expect(records.map((_, i) => isRefusal(film, i))).toEqual([true, true, false, false, false]);
    expect(sentence(film, 0)).toBe('move_to x refused: hit, crane.hook meets wall');
    expect(sentence(film, 4)).toBe('move_to x');
  });

  it('finds the text of a file whose path is longer or shorter', () => {
    const film = makeFilm({ header: { files: [{ path: 'robots/a/s.motion', text: 'A' }, { path: 'b/s.motion', text: 'B' }] },
      end: 0, runs: [] });
    expect(fileText(film, 'robots/a/s.motion')).toBe('A');
    expect(fileText(film, '/home/x/b/s.motion')).toBe('B');
    expect(fileText(film, 'a/s.motion')).toBe('A');
    expect(fileText(film, 's.motion')).toBeNull();
  });
});

describe('trail', () => {
  const records: RecordData[] = [
    { kind: 'task_start', run: 0, t: 0 }, { kind: 'goal', run: 0, t: 0, k: 1, n: 1 },
      { kind: 'enter', run: 0, t: 0, kind_: 'chain', place: 7 },
    attempt(1, 8, 1), { kind: 'task_start', run: 1, t: 1 }, attempt(1, 9, 0), attempt(2, 8, 1), { kind: 'wait', run: 0, t: 3 },
      attempt(3, 9, 0),
  ];
  const film = makeFilm({ end: 3, runs: [{ task: 'a' }, { task: 'b' }], records });
  const trail = new Trail(film, 0);

  it('has the records of its run', () => {
    expect(Array.from(trail.records)).toEqual([0, 1, 2, 3, 5, 6, 7, 8]);
    expect(trail.positionOf(5)).toBe(4);
    expect(trail.positionOf(4)).toBe(-1);
    expect([trail.hasSteps(), new Trail(film, 1).hasSteps(), new Trail(film, -1).hasSteps()]).toEqual([true, false, false]);
  });

  it('goes to tries and to refusals', () => {
    expect([trail.nextTry(0, 1), trail.nextTry(3, 1), trail.nextTry(6, 1), trail.nextTry(7, 1)]).toEqual(
      [3, 4, 7, -1]);
  });

  it('goes on to the next record of a line, and from the end to the first', () => {
    expect(trail.nextFromLine(3, 'a.motion', 8)).toBe(5);
    expect(trail.nextFromLine(5, 'a.motion', 8)).toBe(3);
    expect(trail.nextFromLine(0, 'a.motion', 99)).toBe(-1);
    expect([trail.hasLine('a.motion', 9), trail.hasLine('a.motion', 10), trail.hasLine('b.motion', 9)]).toEqual(
      [true, false, false]);
  });

  it('knows the line it stands at between records with a place', () => {
    expect(trail.placeAround(6)?.line).toBe(8);
    expect(trail.placeAround(0)?.line).toBe(7);
    expect(new Trail(film, 1).placeAround(0)).toBeNull();
  });
});
