import type { Film } from './film';
import type { Motion } from './motion';

export type Point = [x: number, y: number];
/** Straight from a configuration to another: values of all parameters (m, degrees). */
export type Leg = [from: number[], to: number[]];

/** Shares of a leg that are the same. */
const rounding = 1e-9;

/** Two parameters of a robot, by their numbers, and about which value a third one has; `third` -1: whatever. */
export interface Section {
  across: number;
  up: number;
  third: number;
  value: number;
  reach: number;
}

/** The legs that a guide searched through: both configurations of each, the second the short way round from the first. */
export function legsOfGraph(film: Film, at: number): Leg[] {
  const { run, graph } = film.graphs[at];
  const { robot } = film.runs[run];
  if (robot < 0) return [];
  const { parameters } = film.header.robots[robot];
  const width = parameters.length;
  const legs: Leg[] = [];
  for (let i = 0; i + 2 * width <= graph.length; i += 2 * width) {
    const from = graph.slice(i, i + width);
    const to = graph.slice(i + width, i + 2 * width).map((value, p) => {
      const off = value - from[p];
      return from[p] + (parameters[p].cyclic ? off - 360 * Math.round(off / 360) : off);
    });
    legs.push([from, to]);
  }
  return legs;
}

/** The graph by which a run planned last, -1 if it has none by then. */
export function graphAt(film: Film, run: number, time: number): number {
  return film.graphs.findLastIndex((graph) => graph.run === run && graph.t <= time);
}

/** How the robot went from when a guide had found its way until it planned again, or the task was over. */
export function wayAfter(film: Film, motion: Motion, at: number): Leg[] {
  const { run, t } = film.graphs[at];
  const { robot, end, happened } = film.runs[run];
  const next = film.graphs.find((graph, i) => i > at && graph.run === run && graph.t > t);
  const tried = happened ? -1 : run;
  const way = motion.moments(robot, t, next?.t ?? end ?? film.end, tried).map((moment) => Array.from(motion.configuration(robot, moment, tried)));
  return way.slice(1).map((to, i): Leg => [way[i], to]);
}

/** The same legs with cyclic parameters between -180 and 180 degrees: in pieces where one goes over that. */
export function withinATurn(legs: Leg[], cyclic: boolean[]): Leg[] {
  return legs.flatMap(([from, to]) => {
    const shares = [0, 1];
    cyclic.forEach((turns, p) => {
      const [low, high] = [Math.min(from[p], to[p]), Math.max(from[p], to[p])];
      for (let k = Math.ceil((low - 180) / 360); turns && 180 + 360 * k < high; ++k) shares.push((180 + 360 * k - from[p]) / (to[p] - from[p]));
    });
    shares.sort((a, b) => a - b);
    return shares.slice(1).flatMap((end, i): Leg[] => {
      const begin = shares[i];
      if (end - begin < 1e-9 && shares.length > 2) return [];
      const back = cyclic.map((turns, p) => (turns ? 360 * Math.round((from[p] + (begin + end) / 2 * (to[p] - from[p])) / 360) : 0));
      const on = (share: number) => from.map((value, p) => value + share * (to[p] - value) - back[p]);
      return [[on(begin), on(end)]];
    });
  });
}

/** What of a leg is near the value of the third parameter, in the plane of the other two; null: nothing. */
export function nearPart([from, to]: Leg, { across, up, third, value, reach }: Section): [Point, Point] | null {
  const on = (share: number): Point => [from[across] + share * (to[across] - from[across]), from[up] + share * (to[up] - from[up])];
  if (third < 0) return [on(0), on(1)];
  const span = to[third] - from[third];
  if (Math.abs(span) < 1e-9) return Math.abs(from[third] - value) <= reach ? [on(0), on(1)] : null;
  const shares = [value - reach, value + reach].map((limit) => (limit - from[third]) / span);
  const [first, last] = [Math.max(Math.min(...shares), 0), Math.min(Math.max(...shares), 1)];
  return first <= last ? [on(first), on(last)] : null;
}

/** Where a way has the value of the third parameter. */
export function crossings(way: Leg[], { across, up, third, value }: Section): Point[] {
  if (third < 0) return [];
  return way.flatMap(([from, to]): Point[] => {
    const span = to[third] - from[third];
    const share = (value - from[third]) / span;
    return span !== 0 && share >= -rounding && share < 1 - rounding ? [[from[across] + share * (to[across] - from[across]), from[up] + share * (to[up] - from[up])]] : [];
  });
}

/** The parameters that differ between configurations, those that differ most first; the others behind them. */
export function variedOf(configurations: number[][], width: number): { parameter: number; low: number; high: number }[] {
  return Array.from({ length: width }, (_, parameter) => {
    let [low, high] = [Infinity, -Infinity];
    for (const q of configurations) [low, high] = [Math.min(low, q[parameter]), Math.max(high, q[parameter])];
    return { parameter, low, high };
  }).sort((a, b) => (b.high - b.low) - (a.high - a.low) || a.parameter - b.parameter);
}
