import { describe, expect, it } from 'vitest';
import { Clock } from '../src/clock';
import { firstAfter, lanesOf, layoutGantt, noRun, piecesOf, stretched, type Bar } from '../src/gantt/layout';
import { axisHeight, paintGantt, runsAt, type Scene } from '../src/gantt/paint';
import type { Painter } from '../src/gantt/painter';
import { panned, showing, timeOf, wholeView, xOf, zoomed, zoomPlace } from '../src/gantt/view';
import type { MovingData } from '../src/header';
import { Runs } from '../src/runs';
import { makeFilm, robot } from './film_maker';

const film = () => makeFilm({
  header: { robots: [robot('crane', ['x'])], crews: [{ name: 'riggers', size: 2, cost_per_hour: null, calendar: '' },
    { name: 'masons', size: 1, cost_per_hour: null, calendar: '' }],
    tasks: [{ name: 'lift', robot: 'crane', crews: [], zones: [], after: [] }, { name: 'wall', robot: '', crews: ['masons'],
      zones: [], after: [] }] },
  end: 100,
  runs: [{ task: 'lift', robot: 0, start: 0, end: 50 }, { task: 'wall', start: 50, end: 100 },
    { task: 'no', robot: 0, start: 50, end: 90, result: 'rejected', reason: 'blocked', happened: false },
      { task: 'ready', start: 100, end: 100 }],
  records: [
    { kind: 'work', run: 0, t: 20, what: 'hook', crew: 'riggers', from: 10, time: 10 },
    { kind: 'pause', run: 0, t: 30, why: 'machine', for: 'high', from: 25 },
    { kind: 'work', run: 1, t: 100, what: 'takes', crew: '', from: 50, time: 50 },
  ],
});

describe('layout', () => {
  it('has a task in the rows of all that work on it, in pieces', () => {
    const { rows, groups } = layoutGantt(new Runs(film()));
    expect(groups.map((group) => group.title)).toEqual(['Machines', 'Crews', 'Without a machine']);
    expect(rows.map((row) => row.name)).toEqual(['crane', 'riggers', 'masons', 'nobody']);
    expect(rows[0].lanes[0][0].pieces).toEqual([{ from: 0, to: 10, kind: 'motion' }, { from: 10, to: 20, kind: 'work' },
      { from: 20, to: 25, kind: 'motion' }, { from: 25, to: 30, kind: 'wait' }, { from: 30, to: 50, kind: 'motion' }]);
    expect(rows[1].lanes[0].map((bar) => [bar.run, bar.from, bar.to])).toEqual([[0, 10, 20]]);
    expect(rows[2].lanes[0].map((bar) => [bar.run, bar.from, bar.to])).toEqual([[1, 50, 100]]);
    expect(rows[0].points).toEqual([{ run: 2, t: 50, kind: 'rejected' }]);
    expect(rows[3].points).toEqual([{ run: 3, t: 100, kind: 'milestone' }]);
  });

  it('has what keeps a timetable in rows of their own, of no task', () => {
    const pose = (x: number): number[] => [1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0];
    const path = [{ t: 0, pose: pose(0) }, { t: 10, pose: pose(5) }, { t: 30, pose: pose(5) }] as MovingData['path'];
    const { groups, rows } = layoutGantt(new Runs(makeFilm({ header: { robots: [robot('crane', ['x'])], movings:
      [{ name: 'gate', path, repeat: false, shapes: [] }] }, end: 100, runs: [],
      movings: [{ name: 'gate', by: 'crane.hook', delay: 0, t: 4 }, { name: 'gate', by: '', delay: 2, t: 6 }] })));
    expect(groups.map((group) => group.title)).toEqual(['Machines', 'Timetables']);
    expect(rows[1].lanes).toEqual([[{ run: noRun, from: 0, to: 32, critical: false, pieces: [{ from: 0, to: 4, kind: 'motion' },
      { from: 4, to: 6, kind: 'wait' }, { from: 6, to: 12, kind: 'motion' }, { from: 12, to: 32, kind: 'off' }] }]]);
  });

  it('makes rows higher where there is room, within bounds', () => {
    const low = layoutGantt(new Runs(film()));
    expect(stretched(low, 100).height).toBe(low.height);
    const high = stretched(low, low.height + 40);
    expect([high.laneHeight, high.height]).toEqual([low.laneHeight + 10, low.height + 40]);
    expect(high.rows[1].top - high.rows[0].top).toBeGreaterThan(low.rows[1].top - low.rows[0].top);
    expect(stretched(high, 5000).rows[0].height).toBe(56);
    expect(stretched(high, 100)).toEqual(low);
  });

  it('puts bars that overlap in different lanes, and needs no more lanes than bars at once', () => {
    const bars: Bar[] = [];
    let state = 7;
    for (let run = 0; run < 500; ++run) {
      state = (state * 48271) % 2147483647;
      const from = state % 1000;
      bars.push({ run, from, to: from + 1 + state % 37, pieces: [], critical: false });
    }
    const lanes = lanesOf(bars);
    expect(lanes.flat()).toHaveLength(bars.length);
    for (const lane of lanes) lane.slice(1).forEach((bar, i) => expect(bar.from).toBeGreaterThanOrEqual(lane[i].to));
    const most = Math.max(...bars.map(({ from }) => bars.filter((bar) => bar.from <= from && from < bar.to).length));
    expect(lanes).toHaveLength(most);
    for (const t of [0, 17, 500, 1040]) {
      const first = lanes[0].findIndex((bar) => bar.to > t);
      expect(firstAfter(lanes[0], t)).toBe(first < 0 ? lanes[0].length : first);
    }
  });

  it('leaves no gap between pieces, however spans overlap', () => {
    const span = (from: number, to: number, kind: 'work' | 'wait') => ({ from, to, kind, text: '', crew: '' });
    const pieces = piecesOf([span(-5, 3, 'wait'), span(2, 6, 'work'), span(4, 5, 'wait'), span(8, 20, 'wait')], 0, 10, 'motion');
    expect(pieces.map(({ from, to, kind }) => [from, to, kind])).toEqual([[0, 3, 'wait'], [3, 6, 'work'], [6, 8, 'motion'],
      [8, 10, 'wait']]);
  });
});

describe('view', () => {
  const whole = wholeView(1000, 500);

  it('keeps what is under the pointer where it is', () => {
    const t = timeOf(whole, 200);
    const closer = zoomed(whole, 200, 0.25, 1000);
    expect(xOf(closer, t)).toBeCloseTo(200, 6);
    expect(closer.to - closer.from).toBeCloseTo((whole.to - whole.from) / 4, 6);
    expect(zoomed(closer, 37, 4, 1000)).toEqual(whole);
    expect(zoomPlace(whole, 250)).toBe(xOf(whole, 250));
    expect(zoomPlace(closer, closer.to + 1)).toBe(closer.width / 2);
  });

  it('does not leave the plan, nor go closer than is of use', () => {
    expect(panned(whole, 1e6, 1000)).toEqual(whole);
    const closest = zoomed(whole, 100, 1e-12, 1000);
    expect(closest.to - closest.from).toBeCloseTo(2, 9);
    expect(panned(closest, -1e9, 1000).from).toBeCloseTo(whole.from, 9);
    expect(zoomed(wholeView(0, 100), 50, 0.1, 0).to).toBeGreaterThan(0);
  });

  it('moves to a moment only if it is not seen', () => {
    const view = { from: 100, to: 200, width: 500 };
    expect(showing(view, 150, 1000)).toBe(view);
    expect(showing(view, 500, 1000)).toEqual({ from: 480, to: 580, width: 500 });
  });
});

describe('painting', () => {
  const scene = (width: number): Scene => {
    const runs = new Runs(film());
    const layout = layoutGantt(runs);
    return { layout, view: wholeView(100, width - layout.labelWidth), scroll: 0, width, height: 300,
      clock: new Clock(null),
      nameOf: (run) => runs.all[run].task, picked: -1, now: 10, colours: {} };
  };

  it('finds the task under the pointer: bars, and marks first', () => {
    const at = scene(800);
    const row = (i: number) => axisHeight + at.layout.rows[i].top + 16;
    const x = (t: number) => at.layout.labelWidth + xOf(at.view, t);
    expect(runsAt(at, x(25), row(0))).toEqual([0]);
    expect(runsAt(at, x(15), row(1))).toEqual([0]);
    expect(runsAt(at, x(40), row(1))).toEqual([]);
    expect(runsAt(at, x(50), row(0))).toEqual([2]);
    expect(runsAt(at, x(75), row(2))).toEqual([1]);
    at.layout.rows[0].points.unshift({ run: 3, t: 50, kind: 'not reached' });
    expect(runsAt(at, x(50), row(0))).toEqual([2, 3]);
    expect(runsAt(at, 20, row(0))).toEqual([]);
    expect(runsAt(at, x(25), 3)).toEqual([]);
  });

  it('draws no more bars than there are pixels', () => {
    const runs = Array.from({ length: 10000 }, (_, i) => ({ task: `t${i}`, robot: 0, start: i * 10, end: i * 10 + 9 }));
    const many = makeFilm({ header: { robots: [robot('crane', ['x'])] }, end: 1e5, runs });
    let rects = 0;
    const painter: Painter = { rect: () => { ++rects; }, frame: () => undefined, line: () => undefined, diamond: () => undefined,
      text: () => undefined, clip: (_x, _y, _w, _h, draw) => draw() };
    const layout = layoutGantt(new Runs(many));
    paintGantt(painter, { ...scene(800), layout, view: wholeView(1e5, 800 - layout.labelWidth) });
    expect(rects).toBeGreaterThan(300);
    expect(rects).toBeLessThan(800);
  });
});
