import { day, duration, toTheSecond, type Clock } from './clock';

export interface Tick {
  t: number;
  label: string;
  /** It begins a day (or, without dates, stands for a whole day); of months a year. */
  major: boolean;
}

/** Round steps of time (s). */
export const steps = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 10800, 21600, 43200,
  day, 2 * day, 7 * day, 14 * day, 28 * day, 56 * day, 182 * day, 364 * day, 1820 * day];
/** Longer steps are whole months where there are dates. */
const longestStep = 14 * day;
const monthSteps = [1, 2, 3, 6, 12, 24, 60, 120, 600, 1200];
const monthLength = 30.44 * day;

/** Round moments between two times (s), at most about `most` of them, days from midnight and weeks from Monday. */
export function ticks(clock: Clock, from: number, to: number, most: number): Tick[] {
  const span = to - from;
  if (!(span > 0) || most < 1) return [];
  if (clock.dated && span / longestStep > most) return months(clock, from, to, most);
  const step = steps.find((each) => span / each <= most) ?? Math.ceil(span / most / (1820 * day)) * 1820 * day;
  // Multiples of days count from a Monday; without dates from the beginning.
  const zero = clock.dated ? (step >= day ? 4 * day : 0) - clock.epoch : 0;
  const result: Tick[] = [];
  for (let i = Math.ceil((from - zero) / step - 1e-9); zero + i * step <= to; ++i) {
    const t = zero + i * step;
    const major = clock.dated && (step >= day || Math.abs((((clock.epoch + t) % day) + day) % day) < 1e-3);
    result.push({ t, major, label: label(clock, t, step, major) });
  }
  return result;
}

/** The first days of months, of years by their number. */
function months(clock: Clock, from: number, to: number, most: number): Tick[] {
  const long = (to - from) / monthLength / most;
  const step = monthSteps.find((each) => each >= long) ?? Math.ceil(long / 1200) * 1200;
  const begin = new Date((clock.epoch + from) * 1000);
  const result: Tick[] = [];
  for (let month = Math.floor((begin.getUTCFullYear() * 12 + begin.getUTCMonth()) / step) * step; ; month += step) {
    const year = Math.floor(month / 12);
    const t = Date.UTC(year, month % 12, 1) / 1000 - clock.epoch;
    if (t > to) return result;
    const major = month % 12 === 0;
    if (t >= from) result.push({ t, major, label: major ? String(year) : clock.dayOf(t) });
  }
}

function label(clock: Clock, t: number, step: number, major: boolean): string {
  if (step < 1) return clock.exact(t);
  if (!clock.dated) return step >= day ? `${Math.round(t / day)} d` : step < 60 ? toTheSecond(Math.round(t)) : duration(t);
  if (major) return clock.dayOf(t);
  return step >= 60 ? clock.clock(t).slice(0, 5) : clock.clock(t);
}
