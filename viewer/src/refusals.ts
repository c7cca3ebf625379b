import { isRefusal } from './behaviour';
import type { Runs } from './runs';

/**
 * Where something was refused, from task to task: attempts that the surroundings or a limit refused, and where tasks were
 * rejected. First those of one task, in their order, then those of the next in the order of the film.
 */
export class Refusals {
  constructor(private readonly runs: Runs) {}

  /** The nearest after (or, backwards, before) a position in a run, whatever run it is in; -1: there is none. */
  next(run: number, position: number, by: 1 | -1): number {
    const { film, all } = this.runs;
    for (let i = run, from = position + by; i >= 0 && i < all.length; i += by) {
      const records = film.recordsOf(i);
      if (i !== run) from = by > 0 ? 0 : records.length - 1;
      const rejected = this.runs.isRefused(i) ? this.runs.refusedAt(i) : -1;
      for (let k = from; k >= 0 && k < records.length; k += by) {
        if (records[k] === rejected || isRefusal(film, records[k])) return records[k];
      }
    }
    return -1;
  }
}
