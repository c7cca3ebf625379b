import { describe, expect, it } from 'vitest';
import { crossings, graphAt, legsOfGraph, nearPart, variedOf, withinATurn, type Section } from '../src/configurations';
import { makeFilm, robot } from './film_maker';

const section: Section = { across: 0, up: 1, third: 2, value: 5, reach: 1 };

describe('configurations of guides', () => {
  it('are the legs by which a run planned last, the short way round', () => {
    const arm = robot('arm', ['x', 'theta']);
    arm.parameters[1] = { ...arm.parameters[1], kind: 'rotation', cyclic: true };
    const film = makeFilm({ header: { robots: [arm] }, end: 20, runs: [{ task: 'go', robot: 0, start: 0, end: 20 }],
      graphs: [{ run: 0, t: 0, legs: 1, graph: [0, 0, 1, 10] }, { run: 0, t: 7, legs: 2, graph: [0, 170, 2, -170, 2, -170, 3, 350] }] });
    expect([graphAt(film, 0, 6), graphAt(film, 0, 7), graphAt(film, 1, 7)]).toEqual([0, 1, -1]);
    expect(legsOfGraph(film, 1)).toEqual([[[0, 170], [2, 190]], [[2, -170], [3, -10]]]);
    expect(variedOf(legsOfGraph(film, 1).flat(), 2)).toEqual([{ parameter: 1, low: -170, high: 190 }, { parameter: 0, low: 0, high: 3 }]);
  });

  it('are near a value of a third parameter in a part of a leg', () => {
    expect(nearPart([[0, 0, 0], [10, 20, 10]], section)).toEqual([[4, 8], [6, 12]]);
    expect(nearPart([[0, 0, 10], [10, 20, 0]], section)).toEqual([[4, 8], [6, 12]]);
    expect(nearPart([[0, 0, 5.5], [10, 20, 5.5]], section)).toEqual([[0, 0], [10, 20]]);
    expect(nearPart([[0, 0, 0], [10, 20, 3.9]], section)).toBeNull();
    expect(nearPart([[0, 0, 7], [10, 20, 7]], section)).toBeNull();
    expect(nearPart([[0, 0, 7], [10, 20, 7]], { ...section, third: -1 })).toEqual([[0, 0], [10, 20]]);
  });

  it('stay within a turn, in pieces', () => {
    expect(withinATurn([[[170, 0], [190, 2]]], [true, false])).toEqual([[[170, 0], [180, 1]], [[-180, 1], [-170, 2]]]);
    expect(withinATurn([[[400, 0], [360, 4]]], [true, false])).toEqual([[[40, 0], [0, 4]]]);
    expect(withinATurn([[[400, 0], [360, 4]], [[1, 2], [1, 2]]], [false, false])).toEqual([[[400, 0], [360, 4]], [[1, 2], [1, 2]]]);
    expect(withinATurn([[[180, -180], [-180, 180]]], [true, true])).toEqual([[[180, -180], [-180, 180]]]);
  });

  it('have the value where a way crosses it, at a waypoint once', () => {
    const way = [[0, 0, 0], [10, 0, 10], [20, 10, 0], [30, 0, 5], [40, 0, 9]];
    expect(crossings(way.slice(1).map((to, i) => [way[i], to]), section)).toEqual([[5, 0], [15, 5], [30, 0]]);
    expect(crossings([[[0, 0, 5], [10, 0, 5]]], section)).toEqual([]);
    expect(crossings([[[0, 0, 0], [10, 0, 10]]], { ...section, third: -1 })).toEqual([]);
  });
});
