import { describe, expect, it } from 'vitest';
import { busyTimes, workedHours } from '../src/busy';
import { Clock } from '../src/clock';
import type { CalendarData } from '../src/header';
import { common, offShift, onShift } from '../src/shifts';
import { makeFilm } from './film_maker';

const hour = 3600;
const day = 24 * hour;
const site: CalendarData = { name: 'site', shifts: [{ days: [0, 4], minutes: [[420, 720], [750, 960]] }], off: ['2026-05-05'],
  carry_over: false };
/** A Monday, 07:00. */
const { epoch } = new Clock('2026-05-04 07:00');

describe('shifts', () => {
  it('leave out breaks, nights, days off and weekends', () => {
    expect(offShift(site, epoch, 0, 2 * day)).toEqual([
      [5 * hour, 5.5 * hour], [9 * hour, 2 * day]]);
    // Wednesday 16:00 to Thursday 07:00; Friday 16:00 to Monday 07:00.
    expect(offShift(site, epoch, 2 * day + 6 * hour, 3 * day)).toEqual([[2 * day + 9 * hour, 3 * day]]);
    expect(offShift(site, epoch, 4 * day + 8 * hour, 7 * day + hour)).toEqual([[4 * day + 9 * hour, 7 * day]]);
  });

  it('and what is off fill the time without gap or overlap', () => {
    for (let from = -3 * day; from < 9 * day; from += 7919) {
      const to = from + 5 * day + from % 997;
      const all = [...onShift(site, epoch, from, to), ...offShift(site, epoch, from, to)].sort((a, b) => a[0] - b[0]);
      expect(all[0][0]).toBe(from);
      expect(all.at(-1)?.[1]).toBe(to);
      all.slice(1).forEach(([begin], i) => expect(begin).toBe(all[i][1]));
    }
  });

  it('agree with asking minute by minute', () => {
    const night: CalendarData = { name: 'n', shifts: [{ days: [6, 1], minutes: [[0, 360], [1320, 1440]] }], off: ['2026-05-10'],
      carry_over: true };
    const on = onShift(night, epoch, 0, 8 * day);
    for (let t = 30; t < 8 * day; t += 420) {
      const at = new Date((epoch + t) * 1000);
      const minute = at.getUTCHours() * 60 + at.getUTCMinutes();
      const works = [0, 1, 2].includes(at.getUTCDay()) && at.toISOString().slice(0, 10) !== '2026-05-10' &&
        (minute < 360 || minute >= 1320);
      expect(on.some(([from, to]) => from <= t && t < to), at.toISOString()).toBe(works);
    }
  });

  it('without start_at begin on a Monday at midnight', () => {
    expect(onShift(site, new Clock(null).epoch, 0, day)).toEqual([[7 * hour, 12 * hour], [12.5 * hour, 16 * hour]]);
  });

  it('have in common what both have', () => {
    expect(common([[0, 4], [6, 9]], [[1, 2], [3, 7], [8, 12]])).toEqual([[1, 2], [3, 4], [6, 7], [8, 9]]);
  });
});

describe('busy times', () => {
  it('leave out the night within crew work and the wait for a shift', () => {
    const film = makeFilm({
      header: { start_at: '2026-05-06 15:00', calendars: [site], crews: [{ name: 'masons', size: 1, cost_per_hour: null,
        calendar: 'site' }],
        tasks: [{ name: 'a', robot: '', crews: ['masons'], zones: [], after: [] }] },
      end: 42 * hour,
      runs: [{ task: 'a', start: 0, end: 18 * hour }, { task: 'b', start: 18 * hour, end: 42 * hour },
        { task: 'no', start: 0, end: 30 * hour, result: 'rejected', happened: false }],
      records: [
        { kind: 'work', run: 0, t: 18 * hour, what: 'takes', crew: '', from: 0, time: 3 * hour },
        { kind: 'pause', run: 1, t: 40 * hour, why: 'shift', for: '', from: 19 * hour },
        // Done, and held by a link to its finish: nobody works for it.
        { kind: 'pause', run: 1, t: 42 * hour, why: 'held', for: 'a', from: 41 * hour },
      ],
    });
    expect(workedHours(film, 0)).toEqual([[0, hour], [16 * hour, 18 * hour]]);
    expect(busyTimes(film)).toEqual([[0, hour], [16 * hour, 19 * hour], [40 * hour, 41 * hour]]);
  });
});
