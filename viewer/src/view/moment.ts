/**
 * A time of the plan (s): `4 May 07:18` if the plan has a date to begin at (`YYYY-MM-DD HH:MM`), else `0:18:05`. There are no
 * time zones: reckoned as if it were UTC.
 */
export function momentText(startAt: string | null, seconds: number): string {
  const begin = startAt ? Date.parse(`${startAt.replace(' ', 'T')}Z`) : Number.NaN;
  const whole = Math.floor(seconds + 1e-6);
  if (Number.isNaN(begin)) return `${Math.floor(whole / 3600)}${new Date(whole * 1000).toISOString().slice(13, 19)}`;
  const date = new Date(begin + whole * 1000);
  const day = date.toLocaleDateString('en-GB', { day: 'numeric', month: 'short', timeZone: 'UTC' });
  return `${day} ${date.toISOString().slice(11, 16)}`;
}

/** A number with at most so many decimals, and no -0. */
export function quantity(value: number, decimals: number): string {
  return String(Number(value.toFixed(decimals)) + 0);
}
