import { busyTimes } from './busy';
import type { Film } from './film';
import { speedOf, usualLength, type Length } from './lengths';
import type { Interval } from './shifts';

/** What is picked: an element, a run of a task, a robot. */
export type Selection =
  | { kind: 'component'; index: number }
  | { kind: 'run'; index: number }
  | { kind: 'robot'; index: number };

/** What a listener is told of. */
export type Change = 'time' | 'playing' | 'length' | 'fast' | 'record' | 'selection' | 'section';

/** Real seconds that a component is looked at in fast play, at most. */
const fastPlaySeconds = 0.15;

/**
 * The one state of the page: the moment it shows, whether it plays, what is picked, which record the debugger stands at.
 * Everything that is drawn follows it; everything that is pressed changes it. Knows no element of the page.
 */
export class Player {
  readonly end: number;
  private t = 0;
  private plays = false;
  private isFast = false;
  private chosen: Length = usualLength;
  private at: number | null = null;
  private picked: Selection | null = null;
  private cut: number | null = null;
  private owed = 0;
  private readonly listeners = new Map<Change, (() => void)[]>();
  /** When components came to stand, in order. */
  private readonly landmarks: number[];
  /** [from, to] of the times in which some task goes on, in order, apart from each other. */
  readonly busy: readonly Interval[];
  /** Seconds in which some task goes on. */
  readonly worked: number;

  constructor(readonly film: Film) {
    this.end = film.end;
    const landmarks: number[] = [];
    for (let i = 0; i < film.records; ++i) {
      const kind = film.kind(i);
      if ((kind === 'detach' || kind === 'remove') && film.runs[film.run(i)].happened) landmarks.push(film.time(i));
    }
    this.landmarks = [...new Set(landmarks)].sort((a, b) => a - b);
    this.busy = busyTimes(film);
    this.worked = this.busy.reduce((sum, [from, to]) => sum + to - from, 0);
  }

  on(change: Change | Change[], listener: () => void): void {
    for (const each of Array.isArray(change) ? change : [change]) {
      const all = this.listeners.get(each) ?? [];
      this.listeners.set(each, [...all, listener]);
    }
  }

  /** 0 to `end`, or later at a record of a rejected run that was tried for longer. */
  get time(): number { return this.t; }
  get playing(): boolean { return this.plays; }
  /** Fast play: machines are hidden, components appear one after the other. */
  get fast(): boolean { return this.isFast; }
  /** How long playing takes from beginning to end. */
  get length(): Length { return this.chosen; }
  /** Seconds of the plan a second. */
  get speed(): number { return speedOf(this.chosen, this.worked); }
  /** Whether playing passes over the times in which no task goes on (nights, weekends). */
  get skipsIdle(): boolean { return this.chosen !== 'real'; }
  /** The record the debugger stands at, null if it does not. */
  get record(): number | null { return this.at; }
  /** The rejected run that is shown as if it had happened, -1 for none. */
  get triedRun(): number {
    if (this.at === null) return -1;
    const run = this.film.run(this.at);
    return this.film.runs[run].happened ? -1 : run;
  }
  get selection(): Selection | null { return this.picked; }
  /** Height (m) above which nothing is drawn, null: everything is. */
  get section(): number | null { return this.cut; }

  play(): void { this.start(false); }
  fastPlay(): void { this.start(true); }
  toggle(): void { if (this.plays) this.pause(); else this.start(this.isFast); }

  pause(): void {
    if (!this.plays) return;
    this.plays = false;
    this.tell('playing');
  }

  /** Back to the beginning, machines shown. */
  stop(): void {
    this.pause();
    this.setFast(false);
    this.seek(0);
  }

  seek(time: number): void {
    this.leaveRecord();
    this.setTime(time);
  }

  setLength(length: Length): void {
    this.chosen = length;
    this.tell('length');
  }

  setSection(height: number | null): void {
    this.cut = height;
    this.tell('section');
  }

  nextComponent(): void {
    this.pause();
    this.seek(this.landmarks.find((t) => t > this.t) ?? this.end);
  }

  previousComponent(): void {
    this.pause();
    this.seek(this.landmarks.findLast((t) => t < this.t) ?? 0);
  }

  select(selection: Selection | null): void {
    this.picked = selection;
    this.tell('selection');
  }

  /** Puts the debugger at a record; the page shows its moment, and of a rejected run what it tried. */
  goToRecord(record: number | null): void {
    if (record === null) {
      this.leaveRecord();
      return;
    }
    this.pause();
    this.setFast(false);
    this.at = record;
    // What was rejected may have been tried for longer than the plan took without it.
    this.t = this.film.time(record);
    this.tell('time');
    this.tell('record');
  }

  /** To the next (or, backwards, the previous) attempt or wait: of the same run, of the one that is picked, of any. */
  step(by: 1 | -1): void {
    const { film, at } = this;
    let next = -1;
    if (at !== null) {
      const records = film.recordsOf(film.run(at));
      next = this.stepFrom(records, records.indexOf(at) + by, by);
    } else if (this.picked?.kind === 'run') {
      next = this.stepAtTime(this.picked.index, by);
    } else {
      film.runs.forEach((run, i) => {
        if (!run.happened) return;
        const found = this.stepAtTime(i, by);
        if (found >= 0 && (next < 0 || by * (film.time(found) - film.time(next)) < 0)) next = found;
      });
    }
    if (next >= 0) this.goToRecord(next);
  }

  /** Real time went on. */
  tick(seconds: number): void {
    if (!this.plays) return;
    if (this.isFast) {
      this.owed += seconds;
      const each = this.fastPlayStep();
      if (this.owed < each) return;
      const next = this.landmarks.findIndex((t) => t > this.t);
      const passed = Math.floor(this.owed / each);
      this.owed -= passed * each;
      this.setTime(next < 0 ? this.end : this.landmarks[next + passed - 1] ?? this.end);
    } else {
      this.setTime(this.skipsIdle ? this.workedOn(seconds * this.speed) : this.t + seconds);
    }
    if (this.t < this.end) return;
    this.pause();
    // What was hidden so that one sees the building grow has its place in the result.
    this.setFast(false);
  }

  private start(fast: boolean): void {
    this.leaveRecord();
    if (this.t >= this.end) this.setTime(0);
    this.setFast(fast);
    this.plays = true;
    this.owed = 0;
    this.tell('playing');
  }

  private setFast(fast: boolean): void {
    if (this.isFast === fast) return;
    this.isFast = fast;
    this.tell('fast');
  }

  private setTime(time: number): void {
    this.t = Math.min(Math.max(time, 0), this.end);
    this.tell('time');
  }

  private leaveRecord(): void {
    if (this.at === null) return;
    this.at = null;
    this.tell('record');
    if (this.t > this.end) this.setTime(this.end);
  }

  /** Real seconds for a component in fast play: all of them take no longer than the length that is chosen. */
  private fastPlayStep(): number {
    if (this.chosen === 'real' || this.landmarks.length === 0) return fastPlaySeconds;
    return Math.min(fastPlaySeconds, this.chosen / this.landmarks.length);
  }

  /** The moment after so many seconds in which some task goes on. */
  private workedOn(seconds: number): number {
    let low = 0;
    let high = this.busy.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.busy[middle][1] <= this.t) low = middle + 1;
      else high = middle;
    }
    let now = this.t;
    for (let left = seconds; low < this.busy.length; ++low) {
      const [from, to] = this.busy[low];
      now = Math.max(now, from);
      if (now + left < to) return now + left;
      left -= to - now;
      now = to;
    }
    return this.end;
  }

  /** The first attempt or wait of a run that is not over yet, or, backwards, the last that is; -1: none. */
  private stepAtTime(run: number, by: 1 | -1): number {
    const records = this.film.recordsOf(run);
    let low = 0;
    let high = records.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      const time = this.film.time(records[middle]);
      if (by > 0 ? time < this.t : time <= this.t) low = middle + 1;
      else high = middle;
    }
    return this.stepFrom(records, by > 0 ? low : low - 1, by);
  }

  private stepFrom(records: Int32Array, first: number, by: 1 | -1): number {
    for (let i = first; i >= 0 && i < records.length; i += by) {
      const kind = this.film.kind(records[i]);
      if (kind === 'try' || kind === 'wait') return records[i];
    }
    return -1;
  }

  private tell(change: Change): void {
    for (const listener of this.listeners.get(change) ?? []) listener();
  }
}
