import { depths } from './behaviour';
import type { Film, Place } from './film';

/** The records of one run, to step through: positions count in the run, records in the film. */
export class Trail {
  readonly records: Int32Array;
  readonly depth: Uint8Array;
  /** Lines with records, by file. */
  private readonly lines = new Map<string, Set<number>>();

  constructor(private readonly film: Film, readonly run: number) {
    this.records = run >= 0 ? film.recordsOf(run) : new Int32Array();
    this.depth = run >= 0 ? depths(film, run) : new Uint8Array();
    for (const record of this.records) {
      const place = this.place(record);
      if (!place) continue;
      const lines = this.lines.get(place.file) ?? new Set();
      this.lines.set(place.file, lines.add(place.line));
    }
  }

  /** Where a record comes from, null if it comes from no line of a script. */
  place(record: number): Place | null {
    const kind = this.film.kind(record);
    return kind === 'enter' || kind === 'exit' || kind === 'which' || kind === 'try' ? this.film.place(record) : null;
  }

  /** The position of a record of this run, -1 if it is of another. */
  positionOf(record: number): number {
    return this.records.indexOf(record);
  }

  hasLine(file: string, line: number): boolean {
    return this.lines.get(file)?.has(line) ?? false;
  }

  hasSteps(): boolean {
    return this.lines.size > 0;
  }

  /** The nearest position before or after one whose record is an attempt or a wait; -1: none. */
  nextTry(position: number, by: 1 | -1): number {
    return this.find(position, by, (record) => this.film.kind(record) === 'try' || this.film.kind(record) === 'wait');
  }

  /** The next position whose record comes from a line, from the beginning again if there is none; -1: none at all. */
  nextFromLine(position: number, file: string, line: number): number {
    const isThere = (record: number) => {
      const place = this.place(record);
      return place !== null && place.line === line && place.file === file;
    };
    const found = this.find(position, 1, isThere);
    return found >= 0 ? found : this.find(-1, 1, isThere);
  }

  /** The last place named at or before a position; else the first that follows. */
  placeAround(position: number): Place | null {
    for (let i = position; i >= 0; --i) {
      const place = this.place(this.records[i]);
      if (place) return place;
    }
    const after = this.find(position, 1, (record) => this.place(record) !== null);
    return after >= 0 ? this.place(this.records[after]) : null;
  }

  private find(position: number, by: 1 | -1, is: (record: number) => boolean): number {
    for (let i = position + by; i >= 0 && i < this.records.length; i += by) if (is(this.records[i])) return i;
    return -1;
  }
}
