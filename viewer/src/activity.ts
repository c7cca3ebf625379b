import { kinds, type Film } from './film';
import { workWord } from './sentences';

/** What a robot or a crew does at a moment: a stretch of a run that is not motion. */
interface Stretch {
  from: number;
  to: number;
  record: number;
}

/** Which tasks go on at a moment, and what they are about just then. */
export class Activity {
  /** Works and pauses by run, in order of time. */
  private readonly stretches = new Map<number, Stretch[]>();

  constructor(private readonly film: Film) {
    const codes = film.column('record.kind');
    const [works, pauses] = [kinds.indexOf('work'), kinds.indexOf('pause')];
    for (let record = 0; record < film.records; ++record) {
      if (codes[record] !== works && codes[record] !== pauses) continue;
      const kind = film.kind(record);
      const run = film.run(record);
      const all = this.stretches.get(run) ?? [];
      if (all.length === 0) this.stretches.set(run, all);
      all.push({ from: film.number(record, `${kind}.from`), to: film.time(record), record });
    }
  }

  /** The runs that go on at a moment; `tried`: a rejected run that is shown instead of what its robot did, -1 for none. */
  running(time: number, tried = -1): number[] {
    const { runs, end } = this.film;
    const result: number[] = [];
    for (let i = 0; i < runs.length; ++i) {
      const run = runs[i];
      if (i === tried) result.push(i);
      else if (!run.happened || run.start > time || (run.end ?? end) <= time) continue;
      else if (tried < 0 || run.robot < 0 || run.robot !== runs[tried].robot) result.push(i);
    }
    return result;
  }

  /** The work or pause that a run is in, null: it moves. */
  stretch(run: number, time: number): number | null {
    return this.stretches.get(run)?.find(({ from, to }) => from <= time && time < to)?.record ?? null;
  }

  /** What a run does at a moment, in words: `hook (riggers)`, `waits for high`, `moves`. */
  words(run: number, time: number): string {
    const { film } = this;
    const record = this.stretch(run, time);
    if (record === null) return 'moves';
    if (film.kind(record) === 'work') {
      const crew = film.text(record, 'work.crew');
      return workWord(film.text(record, 'work.what')) + (crew ? ` (${crew})` : '');
    }
    const why = film.text(record, 'pause.why');
    const whom = film.text(record, 'pause.for');
    if (why === 'shift') return 'waits for the next shift';
    if (why === 'lift') return `waits for a shift for its lift: ${whom}`;
    if (why === 'repair') return `waits: ${whom} is repaired`;
    if (why === 'held') return `is held by ${whom}`;
    return `waits for ${whom || `a ${why}`}`;
  }
}
