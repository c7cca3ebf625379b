import { Film, kinds, type GraphData, type Kind, type MovingStop, type Run, type SoilTaken, type WalkData } from '../src/film';
import type { Header, RobotData, ScheduleData } from '../src/header';

// Writes films as docs/film.md says, for tests; nothing of it comes from the code that reads them.

type Value = string | number | number[] | boolean;
export type RecordData = { kind: Kind; run: number; t: number } & Record<string, Value>;

const columnsOf: Record<string, { members: string[]; scale?: Record<string, number>; delta?: string[] }> = {
  goal: { members: ['k', 'n'] }, set: { members: ['var', 'value'] }, enter: { members: ['kind_', 'place'] },
  exit: { members: ['kind_', 'place', 'reached', 'successes'] }, which: { members: ['label', 'place'] },
  try: { members: ['command', 'parameter', 'place', 'ok', 'reason', 'moved', 'met'] },
  work: { members: ['what', 'crew', 'from', 'time'], scale: { from: 1e-6, time: 1e-6 }, delta: ['from'] },
  pause: { members: ['why', 'for', 'from'], scale: { from: 1e-6 }, delta: ['from'] },
  attach: { members: ['component', 'pose'], scale: { pose: 1e-9 } }, detach: { members: ['component', 'pose'],
    scale: { pose: 1e-9 } },
  turn: { members: ['component', 'angle', 'from', 'pose', 'moved', 'met'], scale: { angle: 1e-6, from: 1e-6, pose: 1e-9 },
    delta: ['from'] },
  remove: { members: ['component'] }, end: { members: ['status', 'message', 'reached', 'tries', 'accepted'] },
};

export interface FilmData {
  header?: Partial<Header>;
  schedule?: ScheduleData | null;
  end: number;
  runs: (Partial<Run> & { task: string })[];
  records?: RecordData[];
  movings?: MovingStop[];
  walks?: WalkData[];
  graphs?: GraphData[];
  soils?: SoilTaken[];
  /** Keys of the robot of that number (or, with a run, of what it tried): times and rows of values. */
  tracks?: { robot: number; run?: number; t: number[]; q: number[][] }[];
}

export function robot(name: string, parameters: string[], calendar = ''): RobotData {
  return {
    name, type: name, pose: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], start: {}, calendar, bodies: [], tool: { body: '', frame: '' },
      capacity: [], touching: [],
    parameters: parameters.map((each) => ({ name: each, body: 'b', kind: 'translation', cyclic: false, lower: null, upper: null,
      step: 1,
      speed: 1, start: 0 })),
  };
}

export function makeFilm(data: FilmData): Film {
  return new Film(encodeFilm(data));
}

export function encodeFilm({ header, schedule = null, end, runs, records = [], movings, soils, walks, graphs, tracks = [] }: FilmData): Uint8Array {
  const strings = [''];
  const stringOf = (text: string) => {
    if (!strings.includes(text)) strings.push(text);
    return strings.indexOf(text);
  };
  const places: [number, number, number][] = [];
  const placeOf = (line: number) => {
    const file = stringOf('a.motion');
    let i = places.findIndex((place) => place[1] === line);
    if (i < 0) i = places.push([file, line, 1]) - 1;
    return i;
  };
  const columns: Record<string, { values: number[]; scale: number; delta: boolean }> = {};
  const add = (name: string, values: number[], scale = 1, delta = false) => {
    columns[name] ??= { values: [], scale, delta };
    columns[name].values.push(...values);
  };
  for (const record of records) {
    add('record.kind', [kinds.indexOf(record.kind)]);
    add('record.run', [record.run], 1, true);
    add('record.t', [record.t], 1e-6, true);
    const own = columnsOf[record.kind];
    for (const member of own?.members ?? []) {
      const value = record[member] ?? 0;
      const column = `${record.kind}.${member.replace('_', '')}`;
      const plain = member === 'place' ? placeOf(Number(value)) : typeof value === 'string' ? stringOf(value) : value;
      add(column, Array.isArray(plain) ? plain : [Number(plain)], own.scale?.[member] ?? 1, own.delta?.includes(member) ?? false);
    }
  }
  const headTracks = tracks.map(({ robot: number, run = -1, t, q }) => {
    const first = columns['key.t']?.values.length ?? 0;
    const at = columns['key.q']?.values.length ?? 0;
    add('key.t', t, 1e-6, true);
    const width = q[0]?.length ?? 0;
    for (let p = 0; p < width; ++p) add('key.q', q.map((row) => row[p]), 1e-6, true);
    return { robot: number, run, first, count: t.length, q: at };
  });
  const bytes: number[] = [];
  const headColumns: Record<string, object> = {};
  for (const [name, { values, scale, delta }] of Object.entries(columns)) {
    headColumns[name] = { offset: bytes.length, count: values.length, scale, delta };
    let last = 0;
    for (const value of values) {
      const whole = Math.round(value / scale);
      let v = BigInt(delta ? whole - last : whole);
      last = whole;
      v = v < 0n ? -2n * v - 1n : 2n * v;
      for (; v > 127n; v >>= 7n) bytes.push(Number(v & 127n) | 128);
      bytes.push(Number(v));
    }
  }
  const head = {
    ...(movings ? { movings } : {}), ...(soils ? { soils } : {}), ...(walks ? { walks } : {}), ...(graphs ? { graphs } : {}),
    header: { plan: 'p', path: 'p.plan', form: 'full', detail: 'steps', start_at: null, currency: '', calendars: [], files: [],
      site: [],
      components: [], robots: [], carry: [], crews: [], tasks: [], meshes: [], ...header },
    schedule, end, strings, places, tracks: headTracks, columns: headColumns,
    runs: runs.map((run) => ({ robot: -1, start: 0, end: end, result: 'done', reason: '', because: '', after: '', happened: true,
      ...run })),
  };
  const json = new TextEncoder().encode(JSON.stringify(head));
  const result = new Uint8Array(16 + json.length + bytes.length);
  result.set(new TextEncoder().encode('RUBICONF'));
  new DataView(result.buffer).setUint32(8, 1, true);
  new DataView(result.buffer).setUint32(12, json.length, true);
  result.set(json, 16);
  result.set(bytes, 16 + json.length);
  return result;
}
