import type { FlowData, Header, ScheduleData } from './header';

// Reads a film: docs/film.md.

export const kinds = ['task_start', 'goal', 'set', 'enter', 'exit', 'which', 'try', 'wait', 'work', 'pause', 'attach', 'detach',
  'remove', 'end', 'task_end', 'stop', 'guide', 'way_point', 'turn', 'moving', 'cold_joint',
  'breakdown', 'lost_days', 'soil', 'think'] as const;
export type Kind = (typeof kinds)[number];

/** A task that began, or was not reached. */
export interface Run {
  task: string;
  /** Number in header.robots, -1: none. */
  robot: number;
  start: number;
  /** null as long as it is not over. */
  end: number | null;
  result: '' | 'done' | 'short' | 'rejected' | 'not reached';
  reason: string;
  because: string;
  after: string;
  /** What the records of a rejected run tell did not happen. */
  happened: boolean;
}

/** Something with a timetable stops before `by`, or goes on (''); by `delay` its timetable has shifted up to then. */
export interface MovingStop {
  name: string;
  by: string;
  delay: number;
  t: number;
}

/** A bucket of soil: cells of the component that were lowered, and their new heights (mm). */
export interface SoilTaken {
  run: number;
  component: number;
  t: number;
  cells: number[];
  heights: number[];
}

/** A way that a guide walked in the plan view at a moment (s): its waypoints (all parameters of each), what it met and decided. */
export interface WalkData {
  run: number;
  t: number;
  way: number[];
  events: string[];
}

/** What a machine is foreseen to sweep from a moment on (s), for so many seconds: outlines with so many corners each, x and y in turn (m). */
export interface ForeseenData {
  run: number;
  machine: string;
  seconds: number;
  t: number;
  corners: number[];
  points: number[];
}

/** Where a robot may not stand about what its guide searched through: cells that two parameters span, by name, in layers for values of a third. */
export interface ForbiddenData {
  parameters: string[];
  low: number[];
  high: number[];
  cells: number[];
  layers: number[];
  /** All parameters, where the search began. */
  at: number[];
  /** So many free cells, so many that are forbidden, and so on: along the first parameter, row by row, layer by layer. */
  runs: number[];
}

/** What a guide searched through at a moment (s): of each leg both configurations, and how many legs there were. */
export interface GraphData {
  run: number;
  t: number;
  legs: number;
  graph: number[];
  /** Not of all: a run tells it of its first searches. */
  forbidden?: ForbiddenData;
}

/** How a robot moved; docs/film.md says how its keys stand in the columns. */
export interface Track {
  robot: number;
  /** -1: what happened; else the number of the rejected run. */
  run: number;
  first: number;
  count: number;
  q: number;
}

interface Column {
  offset: number;
  count: number;
  scale: number;
  delta: boolean;
}

interface Head {
  header: Header;
  schedule: ScheduleData | null;
  flow?: FlowData | null;
  movings?: MovingStop[];
  soils?: SoilTaken[];
  foreseen?: ForeseenData[];
  walks?: WalkData[];
  graphs?: GraphData[];
  end: number;
  strings: string[];
  places: [number, number, number][];
  runs: Run[];
  tracks: Track[];
  columns: Record<string, Column>;
}

/** A line of a script. */
export interface Place {
  file: string;
  line: number;
  column: number;
}

const magic = 'RUBICONF';

export class FilmError extends Error {}

export class Film {
  readonly header: Header;
  readonly schedule: ScheduleData | null;
  readonly flow: FlowData | null;
  /** In the order in which they happened. */
  readonly movingStops: MovingStop[];
  readonly soils: SoilTaken[];
  readonly foreseen: ForeseenData[];
  readonly walks: WalkData[];
  readonly graphs: GraphData[];
  readonly end: number;
  readonly runs: Run[];
  readonly tracks: Track[];
  readonly strings: string[];
  /** How many records there are. */
  readonly records: number;
  private readonly head: Head;
  private readonly bytes: Uint8Array;
  private readonly decoded = new Map<string, Float64Array>();
  private ranks: Int32Array | null = null;
  private byRun: Int32Array[] | null = null;

  constructor(raw: Uint8Array) {
    const view = new DataView(raw.buffer, raw.byteOffset, raw.byteLength);
    if (raw.length < 16 || new TextDecoder().decode(raw.subarray(0, 8)) !== magic) throw new FilmError('these bytes are no film');
    if (view.getUint32(8, true) !== 1) throw new FilmError(`this page reads films of version 1, not ${view.getUint32(8, true)}`);
    const length = view.getUint32(12, true);
    this.head = JSON.parse(new TextDecoder().decode(raw.subarray(16, 16 + length))) as Head;
    this.bytes = raw.subarray(16 + length);
    ({ header: this.header, schedule: this.schedule, end: this.end, runs: this.runs, tracks: this.tracks,
      strings: this.strings } = this.head);
    this.flow = this.head.flow ?? null;
    this.movingStops = this.head.movings ?? [];
    // What the weather took is off, as what the plan says is.
    for (const { calendar, dates } of this.schedule?.lost_days ?? []) {
      this.header.calendars.find(({ name }) => name === calendar)?.off.push(...dates);
    }
    this.soils = this.head.soils ?? [];
    this.foreseen = this.head.foreseen ?? [];
    this.walks = this.head.walks ?? [];
    this.graphs = this.head.graphs ?? [];
    this.records = this.head.columns['record.kind']?.count ?? 0;
  }

  /** The numbers of a column; decoded once. A column that is not there is empty. */
  column(name: string): Float64Array {
    let values = this.decoded.get(name);
    if (!values) {
      values = this.decode(this.head.columns[name]);
      this.decoded.set(name, values);
    }
    return values;
  }

  kind(record: number): Kind {
    return kinds[this.column('record.kind')[record]];
  }

  time(record: number): number {
    return this.column('record.t')[record];
  }

  run(record: number): number {
    return this.column('record.run')[record];
  }

  /** The records of a run, in their order. Their times never fall, but for the `task_end` of what was rejected. */
  recordsOf(run: number): Int32Array {
    if (!this.byRun) {
      const runs = this.column('record.run');
      const counts = new Int32Array(this.runs.length);
      for (const each of runs) ++counts[each];
      this.byRun = Array.from(counts, (count) => new Int32Array(count));
      counts.fill(0);
      for (let i = 0; i < runs.length; ++i) this.byRun[runs[i]][counts[runs[i]]++] = i;
    }
    return this.byRun[run];
  }

  /** A member of a record, such as number(r, 'try.ok'); the record must be of that kind. */
  number(record: number, column: string): number {
    return this.column(column)[this.rank(record)];
  }

  /** So many numbers of a record, such as numbers(r, 'cold_joint.ends', 4). */
  numbers(record: number, column: string, count: number): Float64Array {
    const first = count * this.rank(record);
    return this.column(column).subarray(first, first + count);
  }

  text(record: number, column: string): string {
    return this.strings[this.number(record, column)];
  }

  /** Where in the scripts a record of the kinds enter, exit, which and try comes from. */
  place(record: number): Place {
    const [file, line, column] = this.head.places[this.number(record, `${this.kind(record)}.place`)];
    return { file: this.strings[file], line, column };
  }

  /** Seven numbers: x, y, z (m), then the quaternion x, y, z, w; of attach (X_TO) and detach (X_WO). */
  pose(record: number): Float64Array {
    const first = 7 * this.rank(record);
    return this.column(`${this.kind(record)}.pose`).subarray(first, first + 7);
  }

  /** How many records of the same kind come before this one. */
  private rank(record: number): number {
    if (!this.ranks) {
      const kind = this.column('record.kind');
      const seen = new Int32Array(kinds.length);
      this.ranks = new Int32Array(kind.length);
      for (let i = 0; i < kind.length; ++i) this.ranks[i] = seen[kind[i]]++;
    }
    return this.ranks[record];
  }

  private decode(column: Column | undefined): Float64Array {
    if (!column) return new Float64Array();
    const values = new Float64Array(column.count);
    const { bytes } = this;
    // Exact: whole numbers below 2^53, divided by what the scale is the inverse of.
    const divisor = column.scale < 1 ? Math.round(1 / column.scale) : 1;
    let at = column.offset;
    let last = 0;
    for (let i = 0; i < values.length; ++i) {
      let byte = bytes[at++];
      let value = byte & 127;
      for (let place = 128; byte > 127; place *= 128) {
        byte = bytes[at++];
        value += (byte & 127) * place;
      }
      value = value % 2 === 0 ? value / 2 : -(value + 1) / 2;
      if (column.delta) value = last += value;
      values[i] = value / divisor;
    }
    return values;
  }
}

/** The film of a page: base64 of gzip of docs/film.md. */
export async function readFilm(base64: string): Promise<Film> {
  const text = base64.trim();
  if (text === '') throw new FilmError('this page holds no film: it is the empty frame that rubicon report fills');
  const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Film(new Uint8Array(await new Response(stream).arrayBuffer()));
}
