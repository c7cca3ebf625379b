import type { Film, Place } from './film';

/** A loop of a script that was entered and not left. */
export interface OpenLoop {
  kind: string;
  place: Place;
  /** The record that entered it. */
  entered: number;
  /** Attempts and waits inside, also of loops inside; and how many of them were steps. */
  tries: number;
  accepted: number;
}

export interface BehaviourState {
  /** From the outermost to the innermost. */
  loops: OpenLoop[];
  /** By name: the value as JSON text, and the record that set it. */
  variables: Map<string, { value: string; record: number }>;
  /** Waypoint k of n; null before the first. */
  goal: { k: number; n: number } | null;
}

/** How the script of a run stands after its record number `upto` (counted in the run): every waypoint begins anew. */
export function behaviourAt(film: Film, run: number, upto: number): BehaviourState {
  const records = film.recordsOf(run);
  const state: BehaviourState = { loops: [], variables: new Map(), goal: null };
  let first = Math.min(upto, records.length - 1);
  while (first > 0 && film.kind(records[first]) !== 'goal') --first;
  for (let i = Math.max(first, 0); i <= upto && i < records.length; ++i) apply(film, records[i], state);
  return state;
}

function apply(film: Film, record: number, state: BehaviourState): void {
  const kind = film.kind(record);
  if (kind === 'goal') {
    state.loops = [];
    state.variables.clear();
    state.goal = { k: film.number(record, 'goal.k'), n: film.number(record, 'goal.n') };
  } else if (kind === 'way_point') {
    state.loops = [];
    state.variables.clear();
  } else if (kind === 'set') {
    state.variables.set(film.text(record, 'set.var'), { value: film.text(record, 'set.value'), record });
  } else if (kind === 'enter') {
    const kindOfLoop = film.text(record, 'enter.kind');
    state.loops.push({ kind: kindOfLoop, place: film.place(record), entered: record, tries: 0, accepted: 0 });
  } else if (kind === 'exit') {
    state.loops.pop();
  } else if (kind === 'try' || kind === 'wait') {
    const ok = kind === 'wait' || film.number(record, 'try.ok') === 1;
    for (const loop of state.loops) {
      ++loop.tries;
      if (ok) ++loop.accepted;
    }
  } else if (kind === 'end') {
    state.loops = [];
  }
}

/** How many loops are open around each record of a run; what enters and what leaves a loop stands outside of it. */
export function depths(film: Film, run: number): Uint8Array {
  const records = film.recordsOf(run);
  const result = new Uint8Array(records.length);
  let depth = 0;
  records.forEach((record, i) => {
    const kind = film.kind(record);
    if (kind === 'goal' || kind === 'way_point' || kind === 'end') depth = 0;
    if (kind === 'exit') depth = Math.max(depth - 1, 0);
    result[i] = Math.min(depth, 255);
    if (kind === 'enter') ++depth;
  });
  return result;
}

/** Whether a record is an attempt that the surroundings or a limit refused: `at goal` and `no direction` are no refusals. */
export function isRefusal(film: Film, record: number): boolean {
  if (film.kind(record) !== 'try' || film.number(record, 'try.ok') === 1) return false;
  const reason = film.text(record, 'try.reason');
  return reason === 'hit' || reason.startsWith('limit');
}

/** The text of a file that records name: their path may be longer or shorter than that in the header. */
export function fileText(film: Film, path: string): string | null {
  const { files } = film.header;
  const exact = files.find((file) => file.path === path);
  if (exact) return exact.text;
  const ends = files.filter((file) => file.path.endsWith(`/${path}`) || path.endsWith(`/${file.path}`));
  return ends.length === 1 ? ends[0].text : null;
}
