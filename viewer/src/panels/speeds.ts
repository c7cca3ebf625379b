import { fastest, slowest } from '../player';

/** Seconds of the plan a second. */
export const speeds = [slowest, 0.5, 1, 2, 5, 10, 30, 60, 120, 300, fastest];

/** Real seconds that a plan should take to play, at least. */
const playSeconds = 60;

/** The speed to begin with for so many seconds of a plan: short plans play in real time, long ones as fast as it goes. */
export function fittingSpeed(seconds: number): number {
  return speeds.findLast((speed) => speed <= seconds / playSeconds && speed > 1) ?? 1;
}

/** The next speed of the row, up or down. */
export function fasterSpeed(speed: number, by: 1 | -1): number {
  const next = by > 0 ? speeds.find((each) => each > speed) : speeds.findLast((each) => each < speed);
  return next ?? speed;
}
