import { Matrix4 } from 'three';
import { kinds, type Film } from './film';
import { poseMatrix, quaternionMatrix } from './kinematics';

/**
 * What became of a component: it waits where it was at first, hangs on a machine, stands where it was put, or has left the
 * site.
 */
export type State = 'waiting' | 'carried' | 'placed' | 'removed';

/** A component at a moment. `pose` is X_WO, but X_TO while it is carried by the robot of number `robot` (else -1). */
export interface Item {
  state: State;
  robot: number;
  pose: Matrix4;
  /** People turn it about the vertical through the tool: `pose` is how it hangs when that is over. */
  turn?: Turn;
}

/** By how much (degrees, counter-clockwise as seen from above), and from when to when (s). */
export interface Turn {
  angle: number;
  from: number;
  to: number;
}

/** How much of a turn is still to come at a moment, in degrees. */
export function turnLeft({ angle, from, to }: Turn, time: number): number {
  return time >= to ? 0 : angle * Math.min((to - time) / (to - from), 1);
}

/** A component changed hands. */
interface Event extends Item {
  component: number;
  run: number;
  t: number;
  /** How the component was before. */
  before: Item;
}

/**
 * Where every component is at a moment, forwards and backwards: events in the order of time and a cursor that remembers for
 * each what was before it, so that going on costs what happens in between, not how much there is.
 */
export class Stock {
  /** One for each component of the header, as of the last `seek`. */
  readonly items: Item[];
  private readonly first: Item[];
  /** What happened, in order. */
  private readonly events: Event[] = [];
  /** What rejected runs tried, in the order of their records, by run. */
  private readonly tries = new Map<number, Event[]>();
  private cursor = 0;
  /** Components that the rejected run shown last has moved elsewhere, with how they are without it. */
  private readonly laidOver = new Map<number, Item>();

  constructor(private readonly film: Film) {
    this.first = film.header.components.map((component) => ({ state: 'waiting', robot: -1, pose: poseMatrix(component.pose) }));
    this.items = [...this.first];
    const codes = film.column('record.kind');
    const wanted = new Set([kinds.indexOf('attach'), kinds.indexOf('detach'), kinds.indexOf('remove'), kinds.indexOf('turn')]);
    for (let record = 0; record < film.records; ++record) {
      const event = wanted.has(codes[record]) ? this.read(record) : null;
      if (!event) continue;
      if (film.runs[event.run].happened) this.events.push(event);
      else if (this.tries.has(event.run)) this.tries.get(event.run)?.push(event);
      else this.tries.set(event.run, [event]);
    }
    this.events.sort((a, b) => a.t - b.t);
    const last = [...this.first];
    for (const event of this.events) {
      event.before = last[event.component];
      last[event.component] = event;
    }
  }

  /**
   * Goes to a moment (s). `tried`: a rejected run that is shown as if it had happened, -1 for none: what its robot did in its
   * stead is not, and what it tried itself is. Returns the components that are not as they were.
   */
  seek(time: number, tried = -1): Set<number> {
    const before = new Map<number, Item>();
    const note = (component: number) => {
      if (!before.has(component)) before.set(component, this.items[component]);
    };
    const set = (component: number, item: Item) => {
      note(component);
      this.items[component] = item;
    };
    for (const [component, item] of this.laidOver) set(component, item);
    this.laidOver.clear();
    for (; this.cursor < this.events.length && this.events[this.cursor].t <= time; ++this.cursor) {
      set(this.events[this.cursor].component, this.events[this.cursor]);
    }
    for (; this.cursor > 0 && this.events[this.cursor - 1].t > time; --this.cursor) {
      const event = this.events[this.cursor - 1];
      set(event.component, event.before);
    }
    if (tried >= 0) {
      for (const [component, item] of this.tried(tried, time)) {
        this.laidOver.set(component, this.items[component]);
        set(component, item);
      }
    }
    const changed = new Set<number>();
    for (const [component, item] of before) if (this.items[component] !== item) changed.add(component);
    return changed;
  }

  /** What a rejected run changes about the state at a moment. */
  private tried(run: number, time: number): Map<number, Item> {
    const { start, robot } = this.film.runs[run];
    const changes = new Map<number, Item>();
    for (let i = this.cursor - 1; i >= 0 && this.events[i].t > start; --i) {
      const event = this.events[i];
      if (this.film.runs[event.run].robot === robot) changes.set(event.component, event.before);
    }
    for (const event of this.tries.get(run) ?? []) if (event.t <= time) changes.set(event.component, event);
    return changes;
  }

  private read(record: number): Event | null {
    const { film } = this;
    const kind = film.kind(record);
    if (kind !== 'attach' && kind !== 'detach' && kind !== 'remove' && kind !== 'turn') return null;
    const component = film.number(record, `${kind}.component`);
    const run = film.run(record);
    const first = this.first[component];
    if (!first) return null;
    const event = { component, run, t: film.time(record), before: first };
    if (kind === 'remove') return { ...event, state: 'removed', robot: -1, pose: first.pose };
    const pose = quaternionMatrix(film.pose(record));
    if (kind === 'detach') return { ...event, state: 'placed', robot: -1, pose };
    const carried = { ...event, state: 'carried' as const, robot: film.runs[run].robot, pose };
    if (kind === 'attach') return carried;
    const turn = { angle: film.number(record, 'turn.angle'), from: film.number(record, 'turn.from'), to: event.t };
    return { ...carried, t: turn.from, turn };
  }
}
