import { describe, expect, it } from 'vitest';
import { legsOf } from '../src/view/search_graphs';
import { makeFilm, robot } from './film_maker';

const pose = [1, 0, 0, 100, 0, 1, 0, 0, 0, 0, 1, 2];

describe('what a guide searched through', () => {
  it('is drawn as straight lines of a vehicle, a little over the floor of its machine', () => {
    const motor = { ...robot('motor', ['x', 'y']), pose, bodies: [{ name: 'b', parent: null, frame: 'trans(x, y, 0)', shapes: [] }],
      tool: { body: 'b', frame: 'trans(0, 0, 9)' } } as ReturnType<typeof robot>;
    const film = makeFilm({ header: { robots: [motor] }, end: 20, runs: [{ task: 'go', robot: 0, start: 0, end: 20 }],
      graphs: [{ run: 0, t: 0, legs: 2, graph: [0, 0, 10, 0, 10, 0, 10, 5] }] });
    expect(legsOf(film, 0).map(([a, b]) => [...a.toArray(), ...b.toArray()])).toEqual([[100, 0, 2.05, 110, 0, 2.05], [110, 0, 2.05, 110, 5, 2.05]]);
  });

  it('follows the curve of a tool, the short way round', () => {
    const arm = { ...robot('arm', ['theta']), pose, bodies: [{ name: 'b', parent: null, frame: 'rotz(theta)', shapes: [] }],
      tool: { body: 'b', frame: 'trans(4, 0, 1)' } } as ReturnType<typeof robot>;
    arm.parameters[0] = { ...arm.parameters[0], kind: 'rotation', cyclic: true };
    const film = makeFilm({ header: { robots: [arm] }, end: 20, runs: [{ task: 'go', robot: 0, start: 0, end: 20 }],
      graphs: [{ run: 0, t: 0, legs: 1, graph: [170, -170] }] });
    const legs = legsOf(film, 0);
    expect(legs.length).toBe(4);
    const middle = legs[2][0].toArray();
    [96, 0, 3].forEach((value, i) => expect(middle[i]).toBeCloseTo(value, 9));
    for (const [a, b] of legs) for (const end of [a, b]) expect(Math.hypot(end.x - 100, end.y)).toBeCloseTo(4, 9);
  });
});
