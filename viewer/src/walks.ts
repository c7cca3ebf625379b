import { Vector3 } from 'three';
import type { Film, WalkData } from './film';
import type { RobotData } from './header';
import { Mechanism } from './kinematics';
import type { Motion } from './motion';

/** A corner is passed where the machine comes so near to it (m). */
const near = 0.02;

/** A piece of the way that was driven, in times (s): towards the goal (0), round an obstacle (1), in a trap (2). */
export interface Driven {
  from: Vector3;
  to: Vector3;
  begins: number;
  ends: number;
  mode: number;
}

/** The mode is that of the stretch that leads to it. */
export interface Corner {
  place: Vector3;
  mode: number;
}

/** A way that a guide walked. */
export interface Walk {
  /** From when (s) the machine follows it, and until when. */
  from: number;
  until: number;
  corners: Corner[];
}

/** Where the ways of guides in the plan view lie, and how far machines have followed them. */
export class Walks {
  private readonly byRun = new Map<number, WalkData[]>();
  private readonly walks = new Map<number, Walk[]>();
  private readonly driven = new Map<number, Driven[]>();

  constructor(private readonly film: Film, private readonly motion: Motion) {
    for (const walk of film.walks) this.byRun.set(walk.run, [...this.byRun.get(walk.run) ?? [], walk]);
  }

  has(run: number): boolean {
    return this.byRun.has(run);
  }

  /** The ways of a run, one after the other. */
  of(run: number): Walk[] {
    let walks = this.walks.get(run);
    if (walks) return walks;
    const { robot, end } = this.film.runs[run];
    const body = robot < 0 ? -1 : this.travelling(robot);
    const data = body < 0 ? [] : this.byRun.get(run) ?? [];
    walks = data.map(({ t, way, events }, i) => ({
      from: t, until: data[i + 1]?.t ?? end ?? this.film.end,
      corners: cornersOf(this.places(robot, body, way), events),
    }));
    this.walks.set(run, walks);
    return walks;
  }

  /** The number of the way that a run follows at a moment, -1: none yet. */
  at(run: number, time: number): number {
    return this.of(run).findLastIndex(({ from }) => from <= time);
  }

  /** The mode in which a run is at a moment, -1: it has no way. */
  modeAt(run: number, time: number, tried = -1): number {
    if (this.at(run, time) < 0) return -1;
    return this.drivenIn(run, tried).findLast(({ begins }) => begins <= time)?.mode ?? 0;
  }

  /** What a run drove, piece by piece. `tried` as in Motion. */
  drivenIn(run: number, tried: number): Driven[] {
    let driven = this.driven.get(run);
    if (driven) return driven;
    driven = this.of(run).flatMap((walk) => this.along(run, walk, tried));
    this.driven.set(run, driven);
    return driven;
  }

  /** Where a body is at each configuration of a way, at the height of its robot. */
  private places(robot: number, body: number, way: number[]): Vector3[] {
    const data = this.film.header.robots[robot];
    const mechanism = new Mechanism(data);
    const width = data.parameters.length;
    return Array.from({ length: Math.floor(way.length / width) }, (_, i) => {
      mechanism.place(way.slice(i * width, (i + 1) * width));
      return new Vector3().setFromMatrixPosition(mechanism.bodies[body]).setZ(data.pose[11]);
    });
  }

  private along(run: number, { from, until, corners }: Walk, tried: number): Driven[] {
    const { robot } = this.film.runs[run];
    const body = robot < 0 ? -1 : this.travelling(robot);
    if (body < 0) return [];
    const data = this.film.header.robots[robot];
    const mechanism = new Mechanism(data);
    const pieces: Driven[] = [];
    let before: { t: number; place: Vector3 } | null = null;
    let next = 1;
    for (const t of this.motion.moments(robot, from, until, run === tried ? run : -1)) {
      mechanism.place(this.motion.configuration(robot, t, run === tried ? run : -1));
      const place = new Vector3().setFromMatrixPosition(mechanism.bodies[body]).setZ(data.pose[11]);
      if (before && before.place.distanceTo(place) > 1e-6) {
        // It passes corners at which only the mode changes in the middle of a stretch.
        let begin = before;
        for (; next < corners.length && offSegment(corners[next].place, begin.place, place) < near; ++next) {
          const corner = corners[next].place;
          const share = begin.place.distanceTo(corner) / Math.max(begin.place.distanceTo(place), 1e-9);
          const passed = { t: begin.t + Math.min(share, 1) * (t - begin.t), place: corner };
          pieces.push({ from: begin.place, to: corner, begins: begin.t, ends: passed.t, mode: corners[next].mode });
          begin = passed;
        }
        const mode = corners[Math.min(next, corners.length - 1)]?.mode ?? 0;
        if (begin.place.distanceTo(place) > 1e-6) pieces.push({ from: begin.place, to: place, begins: begin.t, ends: t, mode });
      }
      before = { t, place };
    }
    return pieces;
  }

  private travelling(robot: number): number {
    return travellingBody(this.film.header.robots[robot]);
  }
}

/** The body of a robot whose place the parameters x and y are, -1: none. */
export function travellingBody({ bodies, parameters }: RobotData): number {
  const has = (body: string, name: string) =>
    parameters.some((each) => each.body === body && each.name.slice(each.name.lastIndexOf('.') + 1) === name);
  return bodies.findIndex(({ name }) => has(name, 'x') && has(name, 'y'));
}

/** What an event of docs/travel.md begins; all others begin the straight way to the destination. */
const modeAfter: Record<string, number> = { hit: 1, target: 1, track: 2 };

/** The places of a way, and those between them at which events change the mode: `hit at (4.28, 22.00) by ring`. */
export function cornersOf(places: Vector3[], events: string[]): Corner[] {
  const found = events.flatMap((text) => {
    const event = /^([a-z ]+) at \((-?[\d.]+), (-?[\d.]+)\)/.exec(text);
    return event ? [{ mode: modeAfter[event[1]] ?? 0, x: Number(event[2]), y: Number(event[3]) }] : [];
  });
  const corners: Corner[] = places.slice(0, 1).map((place) => ({ place, mode: 0 }));
  let mode = 0;
  let next = 0;
  for (let i = 1; i < places.length; ++i) {
    for (; next < found.length; ++next) {
      const { x, y, mode: after } = found[next];
      const begin = corners[corners.length - 1].place;
      const at = new Vector3(x, y, places[i].z);
      // Events are told to the centimetre: one at the end of a leg changes what comes after it.
      if (offSegment(at, begin, places[i]) > near || at.distanceTo(places[i]) <= near) break;
      if (after !== mode && at.distanceTo(begin) > near) corners.push({ place: at, mode });
      mode = after;
    }
    corners.push({ place: places[i], mode });
    for (; next < found.length && Math.hypot(found[next].x - places[i].x, found[next].y - places[i].y) <= near; ++next) {
      mode = found[next].mode;
    }
  }
  return corners;
}

function offSegment(p: Vector3, a: Vector3, b: Vector3): number {
  const along = b.clone().sub(a);
  const share = Math.min(Math.max(p.clone().sub(a).dot(along) / Math.max(along.lengthSq(), 1e-18), 0), 1);
  return p.distanceTo(a.clone().addScaledVector(along, share));
}
