/** How long the animation takes: seconds, or as long as it took. */
export type Length = number | 'real';

/** From the fastest to the slowest. */
export const lengths: readonly Length[] = [30, 60, 180, 'real'];
export const usualLength: Length = 60;

export function lengthName(length: Length): string {
  if (length === 'real') return 'real time';
  return length < 60 ? `${length} s` : `${length / 60} min`;
}

/** Seconds of the plan a second, so that `worked` seconds of it take so long; never slower than they were. */
export function speedOf(length: Length, worked: number): number {
  return length === 'real' ? 1 : Math.max(worked / length, 1);
}

/** The next length of the row: 1 faster, -1 slower. */
export function nextLength(length: Length, by: 1 | -1): Length {
  return lengths[lengths.indexOf(length) - by] ?? length;
}
