import type { Clock } from '../clock';
import { day } from '../clock';
import { offShift, type Interval } from '../shifts';
import { ticks } from '../ticks';
import { firstAfter, noRun, rowGap, type Bar, type Layout, type Row } from './layout';
import type { Painter } from './painter';
import { timeOf, xOf, type TimeView } from './view';

/** Room for the time above (px). */
export const axisHeight = 30;

/** A name needs so much a letter, about (px). */
const letterWidth = 6.4;
/** A bold letter of the name of a row. */
const boldWidth = 7.2;
/** The strip of a bar: below its name. */
const stripTop = 14;
/** What a lane has besides the strip. */
const aroundStrip = 17;
/** Bars of the critical path that are narrower have a line below, no frame around (px). */
const narrow = 16;

export interface Scene {
  layout: Layout;
  /** Its width is that right of the names. */
  view: TimeView;
  /** How far the rows are scrolled (px). */
  scroll: number;
  width: number;
  height: number;
  clock: Clock;
  nameOf(run: number): string;
  /** -1: none. */
  picked: number;
  /** The moment that is shown (s), null: no line. */
  now: number | null;
  colours: Record<string, string>;
}

/** Draws the chart: only what is seen. */
export function paintGantt(painter: Painter, scene: Scene): void {
  const { layout, scroll, width, height, colours } = scene;
  const { laneHeight, labelWidth } = layout;
  painter.rect(0, 0, width, height, colours.panel);
  painter.clip(0, axisHeight, width, height - axisHeight, () => {
    const seen = (top: number, tall: number) => top + tall > scroll && top < scroll + height - axisHeight;
    const off = new Map<string, Interval[]>();
    for (const row of layout.rows) {
      const y = axisHeight + row.top - scroll;
      if (!seen(row.top, row.height)) continue;
      painter.clip(labelWidth, Math.max(y, axisHeight), width - labelWidth, row.height, () => {
        paintOff(painter, scene, row, y, off);
        row.lanes.forEach((lane, i) => paintLane(painter, scene, lane, y + 2 + i * laneHeight));
        paintPoints(painter, scene, row, y + 2);
      });
      const room = Math.floor((labelWidth - 12) / boldWidth);
      painter.clip(0, y, labelWidth - 4, row.height, () => {
        painter.text(8, y + laneHeight / 2 + 2, clipped(row.name, room), colours.text, true);
      });
      painter.line(0, y + row.height - 0.5, width, y + row.height - 0.5, colours.line, 1);
    }
    for (const group of layout.groups) {
      const y = axisHeight + group.top - scroll;
      painter.rect(0, y, width, 21, colours.bg);
      painter.text(8, y + 11, group.title, colours.muted, true);
    }
  });
  paintAxis(painter, scene);
}

function paintOff(painter: Painter, scene: Scene, row: Row, y: number, known: Map<string, Interval[]>): void {
  const { layout: { labelWidth }, view, clock, colours } = scene;
  // Days narrower than two px would only make it grey.
  if (!row.calendar || (view.to - view.from) / day > view.width / 2) return;
  let off = known.get(row.calendar.name);
  if (!off) {
    off = offShift(row.calendar, clock.epoch, Math.max(view.from, 0), view.to);
    known.set(row.calendar.name, off);
  }
  for (const [from, to] of off) {
    const x = labelWidth + xOf(view, from);
    painter.rect(x, y, xOf(view, to) + labelWidth - x, row.height - 1, colours.off);
  }
}

function paintLane(painter: Painter, scene: Scene, lane: readonly Bar[], y: number): void {
  const { view, colours, picked, layout: { labelWidth, laneHeight } } = scene;
  const stripHeight = laneHeight - aroundStrip;
  const fill = { motion: colours.machine, work: colours.crew, wait: colours.wait, off: colours.line };
  let drawn = -Infinity;
  for (let i = firstAfter(lane, view.from); i < lane.length && lane[i].from < view.to; ++i) {
    const bar = lane[i];
    const left = labelWidth + xOf(view, bar.from);
    const right = labelWidth + xOf(view, bar.to);
    const isPicked = bar.run === picked;
    // Of bars that fall on the same px one is enough.
    if (right < drawn + 1 && !isPicked) continue;
    drawn = right;
    const wide = Math.max(right - left - (right - left > 4 ? 1 : 0), 1);
    if (isPicked) painter.rect(left - 2, y, wide + 4, laneHeight - 2, colours.pick);
    if (wide < 4) {
      painter.rect(left, y + stripTop, wide, stripHeight, fill[bar.pieces[0].kind]);
      if (bar.critical) painter.rect(left, y + stripTop + stripHeight, wide, 2, colours.critical);
      continue;
    }
    for (const piece of bar.pieces) {
      if (piece.to < view.from || piece.from > view.to) continue;
      const x = labelWidth + xOf(view, piece.from);
      const end = Math.min(labelWidth + xOf(view, piece.to), left + wide);
      // Where nobody works it is a thread.
      const off = piece.kind === 'off';
      const top = y + stripTop + (off ? stripHeight / 2 - 1.5 : 0);
      painter.rect(x, top, Math.max(end - x, 0.5), off ? 3 : stripHeight, fill[piece.kind]);
    }
    if (bar.critical) paintCritical(painter, scene, bar, y);
    const from = Math.max(left, labelWidth);
    const room = Math.floor((left + wide - from - 3) / letterWidth);
    if (room >= 5 && bar.run !== noRun) painter.text(from + 1, y + 7, clipped(scene.nameOf(bar.run), room), colours.text, isPicked);
  }
}

/** Round what goes on in a bar; not round nights and weekends in it, in which there is nothing. */
function paintCritical(painter: Painter, { view, colours, layout: { labelWidth, laneHeight } }: Scene, bar: Bar, y: number): void {
  const stripHeight = laneHeight - aroundStrip;
  const pieces: [number, number][] = [];
  for (const { kind, from, to } of bar.pieces) {
    if (kind === 'off' || to < view.from || from > view.to) continue;
    const [left, right] = [labelWidth + xOf(view, from), labelWidth + xOf(view, to)];
    const last = pieces.at(-1);
    if (last && left <= last[1] + 1) last[1] = Math.max(last[1], right);
    else pieces.push([left, right]);
  }
  for (const [left, right] of pieces) {
    const wide = Math.max(right - left, 1);
    if (wide < narrow) painter.rect(left, y + stripTop + stripHeight, wide, 2, colours.critical);
    else painter.frame(left, y + stripTop - 1, wide, stripHeight + 2, colours.critical);
  }
}

function paintPoints(painter: Painter, scene: Scene, row: Row, y: number): void {
  const { layout: { labelWidth, laneHeight }, view, colours, picked } = scene;
  const fill = { rejected: colours.bad, 'not reached': colours.muted, milestone: colours.text };
  const middle = y + stripTop + (laneHeight - aroundStrip) / 2;
  const drawn = new Map<string, number>();
  for (const point of row.points) {
    const x = labelWidth + xOf(view, point.t);
    if (x < labelWidth - 8 || x > labelWidth + view.width + 8) continue;
    if (x < (drawn.get(point.kind) ?? -Infinity) + 1 && point.run !== picked) continue;
    drawn.set(point.kind, x);
    if (point.run === picked) painter.diamond(x, middle, 11, colours.text);
    if (point.run === picked) painter.diamond(x, middle, 9.5, colours.pick);
    painter.diamond(x, middle, 6.5, fill[point.kind]);
  }
}

function paintAxis(painter: Painter, { layout: { labelWidth }, view, width, height, clock, colours, now }: Scene): void {
  painter.rect(0, 0, width, axisHeight, colours.panel);
  // The day at the left rim: hours alone do not tell it.
  if (clock.dated) painter.text(8, axisHeight / 2 - 1, clock.dayOf(Math.max(view.from, 0)), colours.muted, true);
  painter.clip(labelWidth, 0, width - labelWidth, height, () => {
    for (const { t, label, major } of ticks(clock, view.from, view.to, view.width / 74)) {
      const x = Math.round(labelWidth + xOf(view, t)) + 0.5;
      if (t < -1e-6) continue;
      painter.line(x, axisHeight - 6, x, major ? height : axisHeight, colours.line, 1);
      // Half a name tells a wrong time.
      if (x + 3 + label.length * boldWidth <= width) painter.text(x + 3, axisHeight / 2 - 1, label, colours.muted, major);
    }
    if (now !== null) {
      const x = labelWidth + xOf(view, now);
      painter.line(x, axisHeight - 8, x, height, colours.text, 1.5);
      painter.diamond(x, axisHeight - 6, 5, colours.text);
    }
  });
  painter.line(0, axisHeight - 0.5, width, axisHeight - 0.5, colours.line, 1);
  painter.line(labelWidth - 0.5, 0, labelWidth - 0.5, height, colours.line, 1);
}

/** At most so many letters, none cut in two. */
function clipped(text: string, most: number): string {
  const letters = Array.from(text.slice(0, 4 * most + 4));
  return letters.length <= most ? letters.join('') : `${letters.slice(0, Math.max(most - 1, 1)).join('')}…`;
}

/** The runs at a point of the chart (px): a bar, or all marks there; the time at x. */
export function runsAt(scene: Scene, x: number, y: number): number[] {
  const { layout, view, scroll } = scene;
  const { labelWidth, laneHeight } = layout;
  if (x < labelWidth || y < axisHeight) return [];
  const down = y - axisHeight + scroll;
  const row = layout.rows.find((each) => down >= each.top && down < each.top + each.height - rowGap);
  if (!row) return [];
  const points = row.points.filter((point) => Math.abs(xOf(view, point.t) - (x - labelWidth)) <= 7);
  if (points.length > 0 && down < row.top + laneHeight) return points.map((point) => point.run).reverse();
  const lane = row.lanes[Math.floor((down - row.top) / laneHeight)] ?? [];
  const t = timeOf(view, x - labelWidth);
  // Two px beside a narrow bar are near enough.
  const near = 2 / view.width * (view.to - view.from);
  const bar = lane[firstAfter(lane, t - near)];
  return bar && bar.run !== noRun && bar.from - near <= t ? [bar.run] : [];
}
