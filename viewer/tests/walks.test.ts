import { describe, expect, it } from 'vitest';
import { Motion } from '../src/motion';
import { Walks } from '../src/walks';
import { makeFilm, robot } from './film_maker';

/** It was to go 10 m east, then 5 m north round something; it drove the first leg, was led anew at 14 s, and went on. */
function walks(): Walks {
  const motor = { ...robot('motor', ['x', 'y']), pose: [1, 0, 0, 100, 0, 1, 0, 0, 0, 0, 1, 2], bodies: [{ name: 'b', parent: null,
    frame: 'trans(x, y, 0)', shapes: [] }], tool: { body: 'b', frame: 'trans(0, 0, 0)' } } as ReturnType<typeof robot>;
  const film = makeFilm({ header: { robots: [motor] }, end: 20, runs: [{ task: 'go', robot: 0, start: 0, end: 20 }],
    walks: [{ run: 0, t: 0, way: [0, 0, 10, 0, 10, 5], events: ['hit at (104.00, 0.00) by wall', 'leave at (110.00, 5.00) by wall',
      'reached at (110.00, 5.00)'] },
    { run: 0, t: 14, way: [10, 2, 20, 2], events: ['hit at (110.00, 2.00) by wall', 'track at (110.00, 2.00) by wall, gate'] }],
    tracks: [{ robot: 0, t: [0, 10, 14, 20], q: [[0, 0], [10, 0], [10, 2], [16, 2]] }] });
  return new Walks(film, new Motion(film));
}

describe('ways in the plan view', () => {
  it('have their corners where they turn and where what was met changes the mode, at the height of the machine', () => {
    const [first, second] = walks().of(0);
    expect([first.from, first.until, second.from, second.until]).toEqual([0, 14, 14, 20]);
    expect(first.corners.map(({ place, mode }) => [place.x, place.y, place.z, mode])).toEqual([[100, 0, 2, 0], [104, 0, 2, 0], [110, 0, 2, 1],
      [110, 5, 2, 1]]);
    expect(second.corners.map(({ place, mode }) => [place.x, place.y, mode])).toEqual([[110, 2, 0], [120, 2, 2]]);
  });

  it('are driven piece by piece: the mode changes at a corner in the middle of a stretch', () => {
    const pieces = walks().drivenIn(0, -1).map(({ from, to, begins, ends, mode }) => [from.x, from.y, to.x, to.y, begins, ends, mode]);
    expect(pieces).toEqual([[100, 0, 104, 0, 0, 4, 0], [104, 0, 110, 0, 4, 10, 1], [110, 0, 110, 2, 10, 14, 1], [110, 2, 116, 2, 14, 20, 2]]);
  });

  it('tell the mode and the way at a moment', () => {
    const all = walks();
    expect([1, 7, 13, 15].map((time) => all.modeAt(0, time))).toEqual([0, 1, 1, 2]);
    expect([0, 13.9, 14].map((time) => all.at(0, time))).toEqual([0, 0, 1]);
    expect([all.has(0), all.has(1)]).toEqual([true, false]);
  });
});
