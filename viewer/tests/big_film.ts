import { makeBox, makeFilmBytes, makeHoist, type MadeRecord } from './make_film';

// A made-up building of any size, for measurements: storeys of slabs and panels, set one after the other by one hoist.

const secondsEach = 600;

export interface BigFilm {
  components: number;
  /** Attempts that the hoist makes for each component. */
  tries: number;
}

/** The bytes of the film, not compressed. */
export function makeBigFilm({ components, tries }: BigFilm): Uint8Array {
  const side = Math.ceil(Math.sqrt(components / 6));
  const place = (i: number) => ({ x: 4 * (i % side), y: 4 * (Math.floor(i / side) % side), z: 3 * Math.floor(i / side / side) });
  const at = ({ x, y, z }: { x: number; y: number; z: number }) => [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z];
  const records: MadeRecord[] = [];
  const keys: number[][] = [[0, 0, 0]];
  for (let i = 0; i < components; ++i) {
    const begin = i * secondsEach;
    const { x, y, z } = place(i);
    records.push({ kind: 'task_start', run: i, t: begin });
    for (let k = 0; k < tries; ++k) {
      const t = begin + ((k + 1) * secondsEach) / (tries + 2);
      records.push({ kind: 'try', run: i, t, columns: {
        'try.command': 1, 'try.parameter': 2, 'try.place': 0, 'try.ok': 1, 'try.reason': 0, 'try.moved': 0, 'try.met': 0,
      } });
      if (k === 0) {
        records.push({ kind: 'attach', run: i, t, columns: { 'attach.component': i, 'attach.pose': [0, 0, -3, 0, 0, 0, 1] } });
      }
      keys.push([t, (x * k) / tries, z + 4 + Math.sin(k) * 0.5]);
    }
    records.push({ kind: 'detach', run: i, t: begin + secondsEach - 1, columns: { 'detach.component': i,
      'detach.pose': [x, y, z, 0, 0, 0, 1] } });
    records.push({ kind: 'task_end', run: i, t: begin + secondsEach - 1 });
  }
  const panel = [makeBox([-1.9, -0.1, 0], [1.9, 0.1, 2.8])];
  const slab = [makeBox([-1.95, -1.95, 2.8], [1.95, 1.95, 3])];
  const names = Array.from({ length: components }, (_, i) => `${i % 3 === 0 ? 'slab' : 'panel'}_${i}`);
  const end = components * secondsEach;
  return makeFilmBytes({
    header: {
      start_at: '2026-03-02 07:00', site: [makeBox([-40, -40, -0.5], [4 * side + 10, 4 * side + 10, 0])],
      components: names.map((name, i) => ({
        name, pose: at({ x: -30 + (i % 8) * 2.5, y: Math.floor(i / 8) % 64, z: 0.3 * Math.floor(i / 512) }),
        grip: at({ x: 0, y: 0, z: 3 }), mass: 2400, shapes: i % 3 === 0 ? slab : panel,
      })),
      robots: [makeHoist('hoist')],
      tasks: names.map((name, i) => ({
        name: `set_${name}`, robot: 'hoist', crews: [], move: name, to: at(place(i)), zones: [], after: [],
      })),
    },
    strings: ['', 'move_to', 'x'],
    runs: names.map((name, i) => ({
      task: `set_${name}`, start: i * secondsEach, end: (i + 1) * secondsEach - 1, result: 'done' as const,
    })),
    records, tracks: [{ robot: 0, run: -1, keys }], end,
  });
}
