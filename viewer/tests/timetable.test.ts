import { Matrix4, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { poseRows } from '../src/kinematics';
import { Timetables } from '../src/timetable';
import { makeFilm } from './film_maker';

const at = (x: number, degrees = 0) => poseRows(new Matrix4().makeTranslation(x, 0, 0)
  .multiply(new Matrix4().makeRotationZ(degrees * Math.PI / 180)));

function timetables(repeat: boolean, stops: { t: number; by: string; delay: number }[] = []): Timetables {
  const path = [{ t: 5, pose: at(0) }, { t: 15, pose: at(10, 90) }, { t: 25, pose: at(0) }];
  return new Timetables(makeFilm({ header: { movings: [{ name: 'gate', path, repeat, shapes: [] }] }, end: 100, runs: [],
    movings: stops.map((stop) => ({ name: 'gate', ...stop })) }));
}

function xOf(tables: Timetables, time: number): number | null {
  const pose = tables.poseAt(0, time);
  return pose ? Number(new Vector3().setFromMatrixPosition(pose).x.toFixed(6)) : null;
}

describe('what keeps a timetable', () => {
  it('is there from its first time to its last', () => {
    const once = timetables(false);
    expect([4.9, 5, 10, 20, 25].map((time) => xOf(once, time))).toEqual([null, 0, 5, 5, null]);
    const pose = once.poseAt(0, 10);
    expect(pose && new Vector3(1, 0, 0).transformDirection(pose).x).toBeCloseTo(Math.SQRT1_2);
  });

  it('begins again', () => {
    expect([25, 30, 2030].map((time) => xOf(timetables(true), time))).toEqual([0, 5, 5]);
  });

  it('is late by as long as it stood', () => {
    const late = timetables(false, [{ t: 8, by: 'crane.hook', delay: 0 }, { t: 9, by: 'wall', delay: 0 }, { t: 12, by: '', delay: 4 }]);
    expect([8, 11, 12, 13, 28.9, 29].map((time) => xOf(late, time))).toEqual([3, 3, 3, 4, 0.1, null]);
  });

  it('goes, stays and is stopped, without gaps', () => {
    const late = timetables(false, [{ t: 8, by: 'crane.hook', delay: 0 }, { t: 12, by: '', delay: 4 }]);
    expect(late.stretches(0, 100, 99)).toEqual([{ from: 5, to: 8, kind: 'goes' }, { from: 8, to: 12, kind: 'stopped' },
      { from: 12, to: 29, kind: 'goes' }]);
    const waiting = timetables(false, [{ t: 5, by: 'car', delay: 0 }, { t: 9, by: '', delay: 4 }]);
    expect(waiting.stretches(0, 100, 99)).toEqual([{ from: 9, to: 29, kind: 'goes' }]);
    const path = [{ t: 0, pose: at(0) }, { t: 4, pose: at(0) }, { t: 10, pose: at(6) }, { t: 16, pose: at(0) }];
    const gate = new Timetables(makeFilm({ header: { movings: [{ name: 'gate', path, repeat: true, shapes: [] }] }, end: 100, runs: [] }));
    expect(gate.stretches(0, 21, 99)).toEqual([{ from: 0, to: 4, kind: 'stays' }, { from: 4, to: 16, kind: 'goes' },
      { from: 16, to: 20, kind: 'stays' }, { from: 20, to: 21, kind: 'goes' }]);
    expect(gate.stretches(0, 1e9, 50)).toHaveLength(50);
  });

  it('is not there while it cannot come', () => {
    const waiting = timetables(false, [{ t: 5, by: 'car', delay: 0 }, { t: 9, by: '', delay: 4 }]);
    expect([5, 8, 9, 10].map((time) => xOf(waiting, time))).toEqual([null, null, 0, 1]);
  });
});
