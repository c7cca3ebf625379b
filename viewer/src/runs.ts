import { workedHours } from './busy';
import type { Film, Run } from './film';
import type { ScheduledTask, TaskData, Waited } from './header';
import type { Player } from './player';
import { workWord } from './sentences';

/** What a run did in a piece of its time (s), besides moving: crew work, a wait of its script, a pause, hours without a shift. */
export interface Span {
  from: number;
  to: number;
  kind: 'work' | 'wait' | 'off';
  /** `hook by riggers`, `waits for the zone of chimney`: for people. */
  text: string;
  /** Who does crew work, `""`: those who hold the task. */
  crew: string;
}

/** What became of the tasks of a plan, and of the components that they move. */
export interface Tally {
  tasks: number;
  done: number;
  short: number;
  rejected: number;
  notReached: number;
  /** Components that some task moves, and those of them for which every such task was done. */
  elements: number;
  placed: number;
}

/** `4 rejected, 2 not reached`; `1 short`; `all done`. */
export function tallyText({ tasks, short, rejected, notReached }: Tally): string {
  if (tasks === 0) return '';
  const parts = [...(short > 0 ? [`${short} short`] : []), ...(rejected > 0 ? [`${rejected} rejected`] : []), ...(notReached > 0 ? [`${notReached} not reached`] : [])];
  return parts.join(', ') || 'all done';
}

const pauses: Record<string, string> = { machine: 'waits for', crew: 'waits for', shift: 'waits for the next shift',
  held: 'is done, held by', lift: 'its lift waits for a shift:', repair: 'waits for the repair of' };

/** What the page asks about tasks: what schedule.json and the trace tell of each, put together. */
export class Runs {
  private readonly rows: (ScheduledTask | null)[];
  private readonly tasks: Map<string, TaskData>;
  private readonly movers: Map<string, number[]>;
  private spans: Span[][] | null = null;
  /** Tasks of the critical path. */
  private readonly chain: Set<string>;

  constructor(readonly film: Film) {
    this.tasks = new Map(film.header.tasks.map((task) => [task.name, task]));
    this.chain = new Set(film.schedule?.critical.map((link) => link.task));
    const open = new Map<string, ScheduledTask[]>();
    for (const row of film.schedule?.tasks ?? []) open.set(row.task, [...open.get(row.task) ?? [], row]);
    // Several runs may have one name (`park crane`): they are told apart by their start.
    this.rows = film.runs.map((run) => {
      const rows = open.get(run.task) ?? [];
      const i = Math.max(rows.findIndex((row) => Math.abs(row.start - run.start) < 1e-6), 0);
      return rows.splice(i, 1)[0] ?? null;
    });
    this.movers = new Map();
    film.runs.forEach((run, i) => {
      const moved = this.tasks.get(run.task)?.move;
      if (moved !== undefined) this.movers.set(moved, [...this.movers.get(moved) ?? [], i]);
    });
  }

  get all(): readonly Run[] { return this.film.runs; }

  /** What schedule.json says of a run, null if it says nothing. */
  row(run: number): ScheduledTask | null { return this.rows[run]; }

  task(run: number): TaskData | null { return this.tasks.get(this.all[run].task) ?? null; }

  /** Whether a run is one of a task of the plan: a machine that only goes out of the way (`park`) is none. */
  isTask(name: string): boolean { return this.tasks.size === 0 || this.tasks.has(name); }

  /** How many tasks the plan has, and what became of them: as the command counts them. */
  tally(): Tally {
    const outcomes = this.film.schedule?.tasks ?? this.all.map(({ task, result }) => ({ task, result: result || 'done' }));
    const results = outcomes.filter(({ task }) => this.isTask(task)).map(({ result }) => result);
    const count = (wanted: string) => results.filter((result) => result === wanted).length;
    const moved = new Set([...this.tasks.values()].flatMap(({ move }) => (move === undefined ? [] : [move])));
    const doneTasks = new Set(outcomes.filter(({ result }) => result === 'done').map(({ task }) => task));
    const open = new Set([...this.tasks.values()].flatMap(({ name, move }) => (move !== undefined && !doneTasks.has(name) ? [move] : [])));
    return { tasks: results.length, done: count('done'), short: count('short'), rejected: count('rejected'), notReached: count('not reached'),
      elements: moved.size, placed: [...moved].filter((name) => !open.has(name)).length };
  }

  isCritical(run: number): boolean { return this.all[run].happened && this.chain.has(this.all[run].task); }

  isRefused(run: number): boolean { return this.all[run].result === 'rejected' || this.all[run].result === 'not reached'; }

  /** When a run is over (s); of one that did not happen, when it would have begun. */
  end(run: number): number {
    const { happened, start, end } = this.all[run];
    return happened ? end ?? this.film.end : start;
  }

  machine(run: number): string { return this.film.header.robots[this.all[run].robot]?.name ?? ''; }

  /** `low` or, where no machine works, the crew. */
  who(run: number): string {
    return this.machine(run) || (this.row(run)?.crew ?? this.task(run)?.crews.join(', ') ?? '');
  }

  /** The runs that go on at a moment. */
  current(t: number): number[] {
    const found: number[] = [];
    for (let i = 0; i < this.all.length; ++i) {
      if (this.all[i].happened && this.all[i].start <= t && t < this.end(i)) found.push(i);
    }
    return found;
  }

  /** The runs that the page shows as going on: where a rejected run is stepped through, that instead of its robot's others. */
  shown(player: Player): number[] {
    const tried = player.triedRun;
    const now = this.current(player.time);
    if (tried < 0) return now;
    const { robot } = this.all[tried];
    return [tried, ...now.filter((run) => robot < 0 || this.all[run].robot !== robot)];
  }

  /** The last record of a run at or before a moment, its first if there is none; -1 if it has no records. */
  recordAt(run: number, t: number): number {
    const records = this.film.recordsOf(run);
    let low = 0;
    // The end of a rejected run is told with the time of its start.
    let high = records.length - (this.all[run].happened ? 0 : 1);
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.film.time(records[middle]) <= t) low = middle + 1;
      else high = middle;
    }
    return records[Math.max(low - 1, 0)] ?? -1;
  }

  /** The run whose steps are shown: of the record, of what is picked; -1: none. */
  focused(player: Player): number {
    if (player.record !== null) return this.film.run(player.record);
    const picked = player.selection;
    if (!picked) return -1;
    if (picked.kind === 'run') return picked.index;
    if (picked.kind === 'robot') return this.current(player.time).find((run) => this.all[run].robot === picked.index) ?? -1;
    const movers = this.movers.get(this.film.header.components[picked.index]?.name ?? '') ?? [];
    return movers.findLast((run) => this.all[run].start <= player.time) ?? movers[0] ?? -1;
  }

  /** Where to look for the reason why a run was not done: the attempt that its reason names, else the motion that ended short. */
  refusedAt(run: number): number {
    const { film } = this;
    const records = film.recordsOf(run);
    const named = Number(/ at step (\d+) /.exec(this.all[run].reason)?.[1] ?? 0);
    let tries = 0;
    let last = records.at(-1) ?? -1;
    for (const record of records) {
      const kind = film.kind(record);
      if (kind === 'try' || kind === 'wait') ++tries;
      if (kind === 'end' && film.number(record, 'end.reached') === 0) last = record;
      if (kind !== 'try' || film.number(record, 'try.ok') === 1) continue;
      if (tries === named) return record;
    }
    return last;
  }

  /** Crew work, waits and pauses of a run, in order. */
  spansOf(run: number): Span[] {
    this.spans ??= this.readSpans();
    return this.spans[run];
  }

  /** Seconds of waiting by kind: what the schedule says, or nothing if there is none. */
  waited(run: number): Waited | null { return this.row(run)?.waited ?? null; }

  private readSpans(): Span[][] {
    const { film } = this;
    const spans: Span[][] = film.runs.map(() => []);
    const last = film.runs.map((run) => run.start);
    for (let i = 0; i < film.records; ++i) {
      const run = film.run(i);
      const own = spans[run];
      const to = film.time(i);
      const kind = film.kind(i);
      if (kind === 'work') {
        const crew = film.text(i, 'work.crew');
        const text = workWord(film.text(i, 'work.what')) + (crew && ` by ${crew}`);
        let from = film.number(i, 'work.from');
        for (const [begin, end] of workedHours(film, i)) {
          if (begin > from) own.push({ kind: 'off', from, to: begin, crew: '', text: 'no shift' });
          own.push({ kind: 'work', from: begin, to: end, crew, text });
          from = end;
        }
      } else if (kind === 'pause') {
        const why = film.text(i, 'pause.why');
        own.push({ kind: why === 'shift' ? 'off' : 'wait', from: film.number(i, 'pause.from'), to, crew: '',
          text: `${pauses[why] ?? `waits: ${why}`} ${film.text(i, 'pause.for')}`.trim() });
      } else if (kind === 'wait') {
        const before = own.at(-1);
        if (before?.text === 'waits as its script says' && before.to >= last[run]) before.to = to;
        else own.push({ kind: 'wait', from: last[run], to, crew: '', text: 'waits as its script says' });
      }
      last[run] = to;
    }
    for (const own of spans) own.sort((a, b) => a.from - b.from);
    return spans;
  }
}
