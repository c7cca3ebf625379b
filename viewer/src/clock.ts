const weekdays = ['Mon', 'Tue', 'Wed', 'Thu', 'Fri', 'Sat', 'Sun'];
const months = ['Jan', 'Feb', 'Mar', 'Apr', 'May', 'Jun', 'Jul', 'Aug', 'Sep', 'Oct', 'Nov', 'Dec'];

export const day = 86400;

/** Of plans that are shorter (s), moments are told to the second. */
const shortPlan = 2 * 3600;

/** Monday 1970-01-05 00:00, where a plan without `start_at` begins, as seconds since 1970 (UTC). */
const someMonday = 4 * day;

/**
 * What the time of the plan is called: dates where the plan has `start_at`, else hours since it began. Days have 24 hours, there
 * are no time zones; everything is computed as if it were UTC.
 */
export class Clock {
  /** Seconds since 1970 at the beginning of the plan. */
  readonly epoch: number;
  readonly dated: boolean;
  private readonly digits: number;
  private readonly oneDay: boolean;

  /** `length`: of the plan (s). */
  constructor(startAt: string | null, length = Infinity) {
    const parts = /^(\d{4})-(\d{2})-(\d{2})[ T](\d{2}):(\d{2})(?::(\d{2}))?$/.exec(startAt ?? '');
    this.dated = parts !== null;
    const [year, month, date, hour, minute, second] = (parts ?? []).slice(1).map((part) => Number(part ?? 0));
    this.epoch = parts ? Date.UTC(year, month - 1, date, hour, minute, second) / 1000 : someMonday;
    this.digits = length < shortPlan ? 8 : 5;
    this.oneDay = Math.floor(this.epoch / day) === Math.floor((this.epoch + length) / day);
  }

  /** `Mon 4 May 2026 07:18:05`, or `0:18:05`, `12 d 04:10:03`. */
  full(t: number): string {
    if (!this.dated) return toTheSecond(Math.floor(t + 1e-6));
    const at = this.date(t);
    const weekday = weekdays[(at.getUTCDay() + 6) % 7];
    return `${weekday} ${at.getUTCDate()} ${months[at.getUTCMonth()]} ${at.getUTCFullYear()} ${this.clock(t)}`;
  }

  /** `4 May 07:18`, or `0:18:05`, `12 d 04:10`; of a short plan `4 May 07:18:05`. */
  short(t: number): string {
    return this.dated ? `${this.dayOf(t)} ${this.time(t)}` : duration(Math.floor(t + 1e-6));
  }

  /** As `short`, without the day where the plan has but one: `07:18`. */
  brief(t: number): string {
    return this.dated && this.oneDay ? this.time(t) : this.short(t);
  }

  /** `4 May 07:18 – 07:31`, `4 May 07:18 – 5 May 09:00`. */
  span(from: number, to: number): string {
    const sameDay = this.dated && this.dayName(from) === this.dayName(to);
    return `${this.short(from)} – ${sameDay ? this.time(to) : this.short(to)}`;
  }

  /** `Mon 4 May 2026`. */
  dayName(t: number): string {
    return this.full(t).slice(0, -9);
  }

  /** The day alone: `4 May`; `day 1` where there is no date. */
  dayOf(t: number): string {
    const at = this.date(t);
    if (this.dated) return `${at.getUTCDate()} ${months[at.getUTCMonth()]}`;
    return `day ${Math.floor(Math.floor(t) / day) + 1}`;
  }

  /** The time of the day: `07:18:05`. */
  clock(t: number): string {
    return this.date(t).toISOString().slice(11, 19);
  }

  /** The time of the day as it is told: `07:18`; of a short plan `07:18:05`. */
  time(t: number): string {
    return this.clock(t).slice(0, this.digits);
  }

  /** Time of the day with tenths: `07:18:05.3`, or `0:18:05.3`. */
  exact(t: number): string {
    const tenths = Math.floor(t * 10 + 1e-4);
    const whole = Math.floor(tenths / 10);
    return `${this.dated ? this.clock(whole) : toTheSecond(whole)}.${tenths % 10}`;
  }

  private date(t: number): Date {
    // Whole seconds; a nanosecond short of one is that one.
    return new Date(Math.floor(this.epoch + t + 1e-6) * 1000);
  }
}

/** `4:10:07` of seconds, to the nearest; of a day and more `12 d 04:10`, to the minute. */
export function duration(seconds: number): string {
  const whole = Math.round(Math.abs(seconds));
  const sign = seconds < -1e-6 && whole > 0 ? '-' : '';
  if (whole < day) return sign + hours(whole);
  const minutes = Math.round(whole / 60);
  return `${sign}${Math.floor(minutes / 1440)} d ${two(Math.floor(minutes / 60) % 24)}:${two(minutes % 60)}`;
}

/** A whole number of seconds: `4:10:07`, `12 d 04:10:07`. */
export function toTheSecond(seconds: number): string {
  if (seconds < day) return hours(seconds);
  return `${Math.floor(seconds / day)} d ${hours(seconds % day).padStart(8, '0')}`;
}

/** `4:10:07`, `52:10:07` of whole seconds, however many hours. */
export function hours(seconds: number): string {
  return `${Math.floor(seconds / 3600)}:${two(Math.floor(seconds / 60) % 60)}:${two(seconds % 60)}`;
}

/** Working time, `40:10:07` however long: a working day has other hours than a day. */
export function workingTime(seconds: number): string {
  const whole = Math.round(Math.abs(seconds));
  return (seconds < -1e-6 && whole > 0 ? '-' : '') + hours(whole);
}

function two(value: number): string {
  return String(value).padStart(2, '0');
}

/** `24.2 days`, or `3.5 h`, whichever tells more. */
export function roughly(seconds: number): string {
  if (seconds >= day) return `${(seconds / day).toFixed(1)} days`;
  if (seconds >= 3600) return `${(seconds / 3600).toFixed(1)} h`;
  return seconds >= 60 ? `${(seconds / 60).toFixed(1)} min` : `${number(seconds, 1)} s`;
}

/** At most so many decimals, no zeros behind them. */
export function number(value: number, decimals = 4): string {
  const text = String(Number(value.toFixed(decimals)));
  return text === '-0' ? '0' : text;
}

/** With just so many decimals, as numbers in a column have them: `1,204.0`. */
export function decimal(value: number, decimals: number): string {
  return value.toLocaleString('en-GB', { minimumFractionDigits: decimals, maximumFractionDigits: decimals });
}

/** `66,865.05 EUR`. */
export function money(value: number, currency: string): string {
  const text = decimal(value, 2);
  return currency ? `${text} ${currency}` : text;
}
