import { day } from './clock';
import type { CalendarData } from './header';

/** [from, to], in seconds. */
export type Interval = [number, number];

/**
 * When this calendar has no shift, between two moments of the plan (s). `epoch`: seconds since 1970 at the beginning of the plan,
 * as if in UTC. Intervals are in order and apart from each other.
 */
export function offShift(calendar: CalendarData, epoch: number, from: number, to: number): Interval[] {
  const result: Interval[] = [];
  let free = from;
  for (const [begin, end] of onShift(calendar, epoch, from, to)) {
    if (begin > free) result.push([free, begin]);
    free = Math.max(free, end);
  }
  if (to > free) result.push([free, to]);
  return result;
}

/** When this calendar has a shift: as offShift. */
export function onShift(calendar: CalendarData, epoch: number, from: number, to: number): Interval[] {
  const off = new Set(calendar.off.map((date) => Math.round(Date.parse(`${date}T00:00:00Z`) / 1000 / day)));
  const result: Interval[] = [];
  for (let number = Math.floor((epoch + from) / day); number * day - epoch < to; ++number) {
    if (off.has(number)) continue;
    // Day 0 of 1970 was a Thursday; Monday is 0.
    const weekday = (((number + 3) % 7) + 7) % 7;
    const midnight = number * day - epoch;
    const hours = calendar.shifts.filter(({ days }) => contains(days, weekday)).flatMap(({ minutes }) => minutes);
    hours.sort((a, b) => a[0] - b[0]);
    for (const [first, last] of hours) {
      const begin = Math.max(midnight + 60 * first, from);
      const end = Math.min(midnight + 60 * last, to);
      if (end <= begin) continue;
      const before = result.at(-1);
      if (before && begin <= before[1]) before[1] = Math.max(before[1], end);
      else result.push([begin, end]);
    }
  }
  return result;
}

/** What two rows of intervals have in common. */
export function common(a: Interval[], b: Interval[]): Interval[] {
  const result: Interval[] = [];
  for (let i = 0, k = 0; i < a.length && k < b.length;) {
    const begin = Math.max(a[i][0], b[k][0]);
    const end = Math.min(a[i][1], b[k][1]);
    if (end > begin) result.push([begin, end]);
    if (a[i][1] < b[k][1]) ++i;
    else ++k;
  }
  return result;
}

/** In order, what touches joined. */
export function merged(intervals: Interval[]): Interval[] {
  const result: Interval[] = [];
  for (const [begin, end] of [...intervals].sort((a, b) => a[0] - b[0])) {
    const last = result.at(-1);
    if (last && begin <= last[1]) last[1] = Math.max(last[1], end);
    else result.push([begin, end]);
  }
  return result;
}

/** A row of days may run over the end of the week. */
function contains([first, last]: [number, number], weekday: number): boolean {
  return first <= last ? weekday >= first && weekday <= last : weekday >= first || weekday <= last;
}
