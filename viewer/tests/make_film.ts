import { Film, kinds, type Kind, type Run, type Track } from '../src/film';
import type { ComponentData, Header, RobotData } from '../src/header';

// Makes films (docs/film.md) of made-up runs, for tests and measurements.

/** A record: its kind, run and time, and the numbers of its other columns by name (poses: seven). */
export interface MadeRecord {
  kind: Kind;
  run: number;
  t: number;
  columns?: Record<string, number | number[]>;
}

export interface MadeFilm {
  header?: Partial<Header>;
  runs?: Partial<Run>[];
  records?: MadeRecord[];
  /** The keys of a robot: time, then its parameters; `run` -1 for what happened. */
  tracks?: { robot: number; run: number; keys: number[][] }[];
  strings?: string[];
  end?: number;
}

interface MadeColumn {
  scale: number;
  delta: boolean;
  values: number[];
}

const columnKinds: Record<string, [number, boolean]> = {
  'record.t': [1e-6, true], 'record.run': [1, true], 'key.t': [1e-6, true], 'key.q': [1e-6, true], 'work.from': [1e-6, true],
  'work.time': [1e-6, false], 'pause.from': [1e-6, true], 'attach.pose': [1e-9, false], 'detach.pose': [1e-9, false],
};

export const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

export function makeHeader(part: Partial<Header> = {}): Header {
  return {
    plan: 'made', path: 'made.plan', form: 'full', detail: 'steps', start_at: null, currency: '', calendars: [], files: [],
    site: [], components: [], robots: [], carry: [], crews: [], tasks: [], meshes: [], ...part,
  };
}

export function makeBox(lower: number[], upper: number[]): ComponentData['shapes'][number] {
  return { type: 'box', lower, upper, pose: identity };
}

/** A hoist on a rail along x: a trolley at x, 9 m up, and a hook at z below it. */
export function makeHoist(name: string, pose = identity): RobotData {
  const parameter = (of: string, body: string) =>
    ({ name: of, body, kind: 'translation' as const, cyclic: false, lower: 0, upper: 30, step: 1, speed: 1, start: 0 });
  return {
    name, type: 'hoist', pose, start: { x: 0, z: 0 }, calendar: '', touching: [], capacity: [],
    bodies: [
      { name: 'trolley', parent: null, frame: 'trans(x, 0, 9)', shapes: [makeBox([-0.4, -0.4, 0], [0.4, 0.4, 0.5])] },
      { name: 'hook', parent: 'trolley', frame: 'trans(0, 0, z - 9)', shapes: [makeBox([-0.2, -0.2, 0], [0.2, 0.2, 0.4])] },
    ],
    parameters: [parameter('x', 'trolley'), parameter('z', 'hook')],
    tool: { body: 'hook', frame: 'trans(0, 0, 0)' },
  };
}

/** The bytes of a film, not compressed. */
export function makeFilmBytes(made: MadeFilm): Uint8Array {
  const columns = new Map<string, MadeColumn>();
  const column = (name: string) => {
    const [scale, delta] = columnKinds[name] ?? [1, false];
    const found = columns.get(name) ?? { scale, delta, values: [] };
    columns.set(name, found);
    return found.values;
  };
  for (const { kind, run, t, columns: more = {} } of made.records ?? []) {
    column('record.kind').push(kinds.indexOf(kind));
    column('record.run').push(run);
    column('record.t').push(t);
    for (const [name, value] of Object.entries(more)) column(name).push(...(Array.isArray(value) ? value : [value]));
  }
  const tracks: Track[] = [];
  for (const { robot, run, keys } of made.tracks ?? []) {
    tracks.push({ robot, run, first: column('key.t').length, count: keys.length, q: column('key.q').length });
    for (const key of keys) column('key.t').push(key[0]);
    for (let p = 1; p < (keys[0]?.length ?? 0); ++p) for (const key of keys) column('key.q').push(key[p]);
  }
  const bytes: number[] = [];
  const described: Record<string, unknown> = {};
  for (const [name, { scale, delta, values }] of columns) {
    described[name] = { offset: bytes.length, count: values.length, scale, delta };
    let last = 0;
    for (const value of values) {
      const whole = Math.round(value / scale);
      append(bytes, delta ? whole - last : whole);
      last = whole;
    }
  }
  const run = { task: '', robot: 0, start: 0, end: null, result: '', reason: '', because: '', after: '', happened: true };
  const head = new TextEncoder().encode(JSON.stringify({
    header: makeHeader(made.header), schedule: null, end: made.end ?? 100, strings: made.strings ?? [''], places: [],
    runs: (made.runs ?? []).map((each) => ({ ...run, ...each })), tracks, columns: described,
  }));
  const raw = new Uint8Array(16 + head.length + bytes.length);
  raw.set(new TextEncoder().encode('RUBICONF'));
  new DataView(raw.buffer).setUint32(8, 1, true);
  new DataView(raw.buffer).setUint32(12, head.length, true);
  raw.set(head, 16);
  raw.set(bytes, 16 + head.length);
  return raw;
}

export function makeFilm(made: MadeFilm): Film {
  return new Film(makeFilmBytes(made));
}

/** Zigzag, seven bits a byte, low bits first. */
function append(bytes: number[], value: number): void {
  let rest = value < 0 ? -2 * value - 1 : 2 * value;
  for (; rest > 127; rest = Math.floor(rest / 128)) bytes.push((rest % 128) + 128);
  bytes.push(rest);
}
