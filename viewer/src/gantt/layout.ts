import type { CalendarData } from '../header';
import type { Runs, Span } from '../runs';
import { Timetables } from '../timetable';

/** How high a lane is at least and at most, and the space below a row (px). */
const lowestLane = 28;
const highestLane = 48;
export const rowGap = 8;
/** How high the heading of a group of rows is (px). */
export const groupHeight = 22;

export type PieceKind = 'motion' | 'work' | 'wait' | 'off';

/** Times in s. */
export interface Piece {
  from: number;
  to: number;
  kind: PieceKind;
}

export interface Bar {
  /** `noRun` of what keeps a timetable by itself. */
  run: number;
  from: number;
  to: number;
  pieces: Piece[];
  critical: boolean;
}

/** What has no length: a task that was not done stands where it would have begun; a milestone. */
export interface Point {
  run: number;
  t: number;
  kind: 'rejected' | 'not reached' | 'milestone';
}

export interface Row {
  name: string;
  kind: 'machine' | 'crew' | 'nobody' | 'moving';
  calendar: CalendarData | null;
  /** Bars of a lane follow one another and do not overlap. */
  lanes: Bar[][];
  points: Point[];
  /** Where it begins and how high it is (px, from the first row's heading). */
  top: number;
  height: number;
}

/** Rows below a heading. */
export interface Group {
  title: string;
  /** px */
  top: number;
  rows: Row[];
}

/** The run of a bar that is of no task. */
export const noRun = -2;

/** Of what goes and stops more often only the whole is drawn. */
const mostStretches = 5000;

export interface Layout {
  groups: Group[];
  rows: Row[];
  /** px */
  height: number;
  laneHeight: number;
  /** Room for the names of the rows, at the left (px). */
  labelWidth: number;
}

/** One row for each machine and each crew; a task stands in the rows of all that work on it. */
export function layoutGantt(runs: Runs): Layout {
  const { header } = runs.film;
  const calendars = new Map(header.calendars.map((calendar) => [calendar.name, calendar]));
  const row = (kind: Row['kind'], name: string, calendar: string): Row =>
    ({ name, kind, calendar: calendars.get(calendar) ?? null, lanes: [], points: [], top: 0, height: 0 });
  const machines = header.robots.map((robot) => row('machine', robot.name, robot.calendar));
  const crews = header.crews.map((crew) => row('crew', crew.name, crew.calendar));
  const nobody = row('nobody', 'nobody', '');
  const crewOf = new Map(crews.map((crew) => [crew.name, crew]));
  const bars = new Map<Row, Bar[]>([...machines, ...crews, nobody].map((each) => [each, []]));

  runs.all.forEach((run, i) => {
    const machine = machines[run.robot];
    const holders = crewsOf(runs, i).flatMap((name) => crewOf.get(name) ?? []);
    const whole = [...(machine ? [machine] : []), ...holders];
    if (whole.length === 0 && !runs.spansOf(i).some((span) => crewOf.has(span.crew))) whole.push(nobody);
    const [from, to] = [run.start, runs.end(i)];
    const critical = runs.isCritical(i);
    for (const each of whole) {
      if (!run.happened) {
        each.points.push({ run: i, t: from, kind: run.result === 'not reached' ? 'not reached' : 'rejected' });
      } else if (to <= from) {
        each.points.push({ run: i, t: from, kind: 'milestone' });
      } else {
        const rest = each.kind === 'machine' ? 'motion' : 'work';
        bars.get(each)?.push({ run: i, from, to, critical, pieces: piecesOf(runs.spansOf(i), from, to, rest) });
      }
    }
    if (!run.happened) return;
    // Crews that come for a part of the task only.
    for (const span of runs.spansOf(i)) {
      const crew = span.kind === 'work' ? crewOf.get(span.crew) : undefined;
      if (!crew || whole.includes(crew) || span.to <= span.from) continue;
      const time = { from: span.from, to: span.to };
      bars.get(crew)?.push({ run: i, ...time, critical, pieces: [{ ...time, kind: 'work' }] });
    }
  });
  for (const [each, own] of bars) each.lanes = lanesOf(own);
  const hasNobody = nobody.points.length > 0 || (bars.get(nobody)?.length ?? 0) > 0;
  const timetables = new Timetables(runs.film);
  const kinds = { goes: 'motion', stays: 'off', stopped: 'wait' } as const;
  const movings = (header.movings ?? []).map(({ name }, i) => {
    const each = row('moving', name, '');
    const stretches = timetables.stretches(i, runs.film.end, mostStretches);
    if (stretches.length === 0) return each;
    const many = stretches.length === mostStretches;
    const [from, to] = [stretches[0].from, many ? runs.film.end : stretches[stretches.length - 1].to];
    const pieces: Piece[] = many ? [{ from, to, kind: 'motion' }]
      : stretches.map((stretch) => ({ from: stretch.from, to: stretch.to, kind: kinds[stretch.kind] }));
    each.lanes = [[{ run: noRun, from, to, critical: false, pieces }]];
    return each;
  });
  const groups: [string, Row[]][] = [['Machines', machines], ['Timetables', movings], ['Crews', crews], ['Without a machine', hasNobody ? [nobody] : []]];
  const filled = groups.filter(([, rows]) => rows.length > 0);
  return stacked(filled.map(([title, rows]) => ({ title, top: 0, rows })), lowestLane);
}

/** The same rows, higher where there is more room (px) than they need. */
export function stretched({ groups, rows }: Layout, room: number): Layout {
  const lanes = rows.reduce((sum, row) => sum + Math.max(row.lanes.length, 1), 0);
  const free = room - groups.length * groupHeight - rows.length * rowGap;
  return stacked(groups, Math.min(Math.max(Math.floor(free / Math.max(lanes, 1)), lowestLane), highestLane));
}

function crewsOf(runs: Runs, run: number): string[] {
  const task = runs.task(run);
  if (task) return task.crews;
  return (runs.row(run)?.crew ?? '').split(', ').filter((name) => name !== '');
}

/** Pieces without gaps from `from` to `to`; `rest` is what goes on outside of the spans. */
export function piecesOf(spans: readonly Span[], from: number, to: number, rest: PieceKind): Piece[] {
  const pieces: Piece[] = [];
  let at = from;
  for (const span of spans) {
    const begin = Math.max(span.from, at);
    const end = Math.min(span.to, to);
    if (end <= begin) continue;
    if (begin > at) pieces.push({ from: at, to: begin, kind: rest });
    pieces.push({ from: begin, to: end, kind: span.kind });
    at = end;
  }
  if (at < to) pieces.push({ from: at, to, kind: rest });
  return pieces;
}

/** As few lanes as will do, each bar in the first that is free. */
export function lanesOf(bars: Bar[]): Bar[][] {
  const lanes: Bar[][] = [];
  for (const bar of [...bars].sort((a, b) => a.from - b.from || a.run - b.run)) {
    const lane = lanes.find((each) => (each.at(-1)?.to ?? 0) <= bar.from);
    if (lane) lane.push(bar);
    else lanes.push([bar]);
  }
  return lanes;
}

/** A letter of a name needs so much, about (px). */
const letterWidth = 7.4;

function stacked(groups: Group[], laneHeight: number): Layout {
  const rows: Row[] = [];
  const placed: Group[] = [];
  let height = 0;
  for (const group of groups) {
    const top = height;
    height += groupHeight;
    const own = group.rows.map((row) => {
      // What was rejected lies above what was not reached because of it.
      const points = [...row.points].sort((a, b) => a.t - b.t || Number(a.kind === 'rejected') - Number(b.kind === 'rejected'));
      const high = Math.max(row.lanes.length, 1) * laneHeight + rowGap;
      height += high;
      return { ...row, points, top: height - high, height: high };
    });
    placed.push({ title: group.title, top, rows: own });
    rows.push(...own);
  }
  const longest = rows.reduce((most, row) => Math.max(most, row.name.length), 0);
  const labelWidth = Math.min(Math.max(Math.ceil(longest * letterWidth) + 16, 80), 150);
  return { groups: placed, rows, height, laneHeight, labelWidth };
}

/** The number of the first of a lane (bars, steps; one after the other) that ends after `t`. */
export function firstAfter(lane: readonly { to: number }[], t: number): number {
  let low = 0;
  let high = lane.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (lane[middle].to <= t) low = middle + 1;
    else high = middle;
  }
  return low;
}
