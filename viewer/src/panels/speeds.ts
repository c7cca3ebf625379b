import { fastest, slowest } from '../player';

/** Seconds of the plan a second. */
export const speeds = [slowest, 0.5, 1, 2, 5, 10, 30, 60, 120, 300, fastest];

/** The next speed of the row, up or down. */
export function fasterSpeed(speed: number, by: 1 | -1): number {
  const next = by > 0 ? speeds.find((each) => each > speed) : speeds.findLast((each) => each < speed);
  return next ?? speed;
}
