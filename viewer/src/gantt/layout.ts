import type { CalendarData } from '../header';
import type { Runs, Span } from '../runs';

/** How high a lane is, and the space below a row (px). */
export const laneHeight = 28;
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
  run: number;
  from: number;
  to: number;
  pieces: Piece[];
  critical: boolean;
}

/** What has no length: a task that was refused, stands where it would have begun; a milestone. */
export interface Point {
  run: number;
  t: number;
  kind: 'rejected' | 'not reached' | 'milestone';
}

export interface Row {
  name: string;
  kind: 'machine' | 'crew' | 'nobody';
  calendar: CalendarData | null;
  /** Bars of a lane follow one another and do not overlap. */
  lanes: Bar[][];
  points: Point[];
  /** Where it begins and how high it is (px, from the first row's heading). */
  top: number;
  height: number;
}

export interface Layout {
  groups: { title: string; top: number }[];
  rows: Row[];
  /** px */
  height: number;
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
  return stack([['Machines', machines], ['Crews', crews], ['Without a machine', hasNobody ? [nobody] : []]]);
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

function stack(groups: [string, Row[]][]): Layout {
  const layout: Layout = { groups: [], rows: [], height: 0 };
  for (const [title, rows] of groups) {
    if (rows.length === 0) continue;
    layout.groups.push({ title, top: layout.height });
    layout.height += groupHeight;
    for (const row of rows) {
      row.points.sort((a, b) => a.t - b.t);
      row.top = layout.height;
      row.height = Math.max(row.lanes.length, 1) * laneHeight + rowGap;
      layout.height += row.height;
      layout.rows.push(row);
    }
  }
  return layout;
}

/** The number of the first bar of a lane that ends after `t`. */
export function firstAfter(lane: readonly Bar[], t: number): number {
  let low = 0;
  let high = lane.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (lane[middle].to <= t) low = middle + 1;
    else high = middle;
  }
  return low;
}
