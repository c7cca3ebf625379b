import { isRefusal } from './behaviour';
import type { Film } from './film';
import type { Interval } from './shifts';

/** What stands at a pixel of the time slider. */
export const mark = { busy: 1, start: 2, blocked: 4, refused: 8 } as const;

/**
 * The marks of a slider so many pixels wide: where some task goes on, where tasks start, where attempts were refused by what was
 * in the way, and where tasks were rejected or not reached: at most one of each a pixel.
 */
export function sliderMarks(film: Film, busy: readonly Interval[], width: number): Uint8Array {
  const marks = new Uint8Array(Math.max(width, 0));
  const end = Math.max(film.end, 1e-9);
  const pixel = (t: number) => Math.min(Math.max(Math.floor(t / end * width), 0), width - 1);
  if (width < 1) return marks;
  for (const [from, to] of busy) for (let x = pixel(from); x <= pixel(to); ++x) marks[x] |= mark.busy;
  film.runs.forEach((run) => {
    if (run.happened) marks[pixel(run.start)] |= mark.start;
    else marks[pixel(run.start)] |= mark.refused;
  });
  for (let i = 0; i < film.records; ++i) {
    if (isRefusal(film, i) && film.runs[film.run(i)].happened) marks[pixel(film.time(i))] |= mark.blocked;
  }
  return marks;
}
