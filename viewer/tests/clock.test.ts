import { describe, expect, it } from 'vitest';
import { Clock, decimal, duration, money, number, roughly } from '../src/clock';
import { ticks } from '../src/ticks';

describe('clock', () => {
  it('calls moments by their date where the plan has one', () => {
    const clock = new Clock('2026-05-04 07:00');
    expect(clock.full(0)).toBe('Mon 4 May 2026 07:00:00');
    expect(clock.full(21543.309)).toBe('Mon 4 May 2026 12:59:03');
    expect(clock.short(1082.78)).toBe('4 May 07:18');
    expect(clock.short(6 * 86400)).toBe('10 May 07:00');
    expect(clock.full(240 * 86400)).toBe('Wed 30 Dec 2026 07:00:00');
    expect(clock.exact(1.26)).toBe('07:00:01.2');
  });

  it('tells the seconds of a short plan, and the day once where it has but one', () => {
    const short = new Clock('2026-05-04 07:00', 93);
    expect([short.short(38), short.brief(38), short.time(38), short.span(0, 92)]).toEqual(['4 May 07:00:38', '07:00:38', '07:00:38', '4 May 07:00:00 – 07:01:32']);
    const long = new Clock('2026-05-04 23:00', 3 * 3600);
    expect([long.brief(0), long.span(0, 1800), long.span(0, 7200)]).toEqual(['4 May 23:00', '4 May 23:00 – 23:30', '4 May 23:00 – 5 May 01:00']);
    expect(new Clock(null, 93).span(1, 92)).toBe('0:00:01 – 0:01:32');
  });

  it('takes 29 February and the end of the year', () => {
    expect(new Clock('2028-02-28 23:59').full(60)).toBe('Tue 29 Feb 2028 00:00:00');
    expect(new Clock('2026-12-31 23:59').full(60)).toBe('Fri 1 Jan 2027 00:00:00');
  });

  it('says days and hours of what takes days', () => {
    expect(duration(7256 * 3600)).toBe('302 d 08:00');
    expect(duration(86400 * 12 + 4 * 3600 + 10 * 60 + 7)).toBe('12 d 04:10');
    expect(duration(86399.4)).toBe('23:59:59');
    expect(duration(86399.6)).toBe('1 d 00:00');
    expect(duration(2 * 86400 - 20)).toBe('2 d 00:00');
    expect(duration(-90000)).toBe('-1 d 01:00');
    expect(ticks(new Clock(null), 86400, 1.5 * 86400, 3).map((tick) => tick.label)).toEqual(['1 d 00:00', '1 d 06:00', '1 d 12:00']);
  });

  it('counts days and hours where the plan has no date', () => {
    const clock = new Clock(null);
    expect(clock.dated).toBe(false);
    expect(clock.full(90061)).toBe('1 d 01:01:01');
    expect(clock.short(90061)).toBe('1 d 01:01');
    expect(clock.exact(90061.5)).toBe('1 d 01:01:01.5');
    expect(clock.short(5099.5)).toBe('1:24:59');
    expect(clock.exact(0.3)).toBe('0:00:00.3');
    expect(clock.dayOf(86400)).toBe('day 2');
  });

  it('forgives a nanosecond', () => {
    expect(duration(59.999999999)).toBe('0:01:00');
    expect(new Clock('2026-05-04 07:00').clock(59.999999999)).toBe('07:01:00');
    expect(duration(8615.6)).toBe('2:23:36');
    expect(new Clock(null).full(8615.6)).toBe('2:23:35');
    expect(duration(-90)).toBe('-0:01:30');
    expect(duration(-1e-9)).toBe('0:00:00');
  });

  it('writes numbers short', () => {
    expect(number(-0.00001)).toBe('0');
    expect(number(1.23456789)).toBe('1.2346');
    expect(money(66865.049, 'EUR')).toBe('66,865.05 EUR');
    expect([decimal(12, 1), decimal(1204.04, 1), decimal(0.6, 2)]).toEqual(['12.0', '1,204.0', '0.60']);
    expect(roughly(2086681)).toBe('24.2 days');
    expect(roughly(12)).toBe('12 s');
  });
});

describe('ticks', () => {
  it('stand at round times of the day, not of the plan', () => {
    const found = ticks(new Clock('2026-05-04 07:10'), 0, 3 * 3600, 8);
    expect(found.map((tick) => tick.label)).toEqual(['07:30', '08:00', '08:30', '09:00', '09:30', '10:00']);
  });

  it('of days begin at midnight, of weeks on Monday', () => {
    const clock = new Clock('2026-05-06 07:00');
    expect(ticks(clock, 0, 3 * 86400, 3.5).map((tick) => tick.label)).toEqual(['7 May', '8 May', '9 May']);
    expect(ticks(clock, 0, 30 * 86400, 5).map((tick) => tick.label)).toEqual(['11 May', '18 May', '25 May', '1 Jun']);
  });

  it('of months begin on their first days, of years with the year', () => {
    const clock = new Clock('2025-02-18 08:00');
    expect(ticks(clock, 0, 320 * 86400, 5).map((tick) => tick.label)).toEqual(['1 Apr', '1 Jul', '1 Oct', '2026']);
    expect(clock.full(ticks(clock, 0, 320 * 86400, 5)[0].t)).toBe('Tue 1 Apr 2025 00:00:00');
    expect(ticks(clock, 0, 3000 * 86400, 5).map((tick) => tick.label)).toEqual(['2026', '2028', '2030', '2032']);
  });

  it('are never more than asked for, whatever the span', () => {
    for (const span of [0.5, 1, 7, 61, 4000, 1e5, 1e6, 1e8, 4e9]) {
      for (const clock of [new Clock(null), new Clock('2026-05-06 07:00')]) {
        expect(ticks(clock, 0, span, 10).length).toBeLessThanOrEqual(11);
        expect(ticks(clock, 0, span, 10).length).toBeGreaterThanOrEqual(1);
      }
    }
    expect(ticks(new Clock(null), 0, 0, 10)).toEqual([]);
  });
});
