import type { Film, Track } from './film';

/** Where robots stood: the values of their parameters at any moment, from the key frames of a film. */
export class Motion {
  private readonly main = new Map<number, Track>();
  private readonly tried = new Map<number, Track>();
  private readonly t: Float64Array;
  private readonly q: Float64Array;

  constructor(private readonly film: Film) {
    this.t = film.column('key.t');
    this.q = film.column('key.q');
    for (const track of film.tracks) {
      if (track.run < 0) this.main.set(track.robot, track);
      else this.tried.set(track.run, track);
    }
  }

  /**
   * The parameters of a robot at a moment, in the order of the header (m, degrees). `run`: a rejected run whose own motion counts
   * instead of what happened, if it is this robot's; else -1.
   */
  configuration(robot: number, time: number, run = -1): Float64Array {
    const own = run >= 0 ? this.tried.get(run) : undefined;
    const track = own && own.robot === robot ? own : this.main.get(robot);
    const parameters = this.film.header.robots[robot].parameters;
    const values = new Float64Array(parameters.length);
    if (!track || track.count === 0) {
      parameters.forEach((parameter, i) => { values[i] = this.film.header.robots[robot].start[parameter.name] ?? parameter.start; });
      return values;
    }
    const { first, count } = track;
    const after = this.keyAfter(track, time);
    const a = Math.max(after - 1, 0);
    const b = Math.min(after, count - 1);
    const span = this.t[first + b] - this.t[first + a];
    const share = span > 0 ? Math.min(Math.max((time - this.t[first + a]) / span, 0), 1) : 0;
    for (let i = 0; i < values.length; ++i) {
      const row = track.q + i * count;
      values[i] = this.q[row + a] + share * (this.q[row + b] - this.q[row + a]);
    }
    return values;
  }

  /** The moments at which the robot's way in this time bends, and both ends of it. */
  moments(robot: number, from: number, to: number, run = -1): number[] {
    const track = run >= 0 ? this.tried.get(run) : this.main.get(robot);
    const result = [from];
    if (track) {
      for (let i = this.keyAfter(track, from); i < track.count && this.t[track.first + i] < to; ++i) {
        result.push(this.t[track.first + i]);
      }
    }
    result.push(to);
    return result;
  }

  /** The number in its track of the first key later than `time`. */
  private keyAfter(track: Track, time: number): number {
    let low = 0;
    let high = track.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.t[track.first + middle] <= time) low = middle + 1;
      else high = middle;
    }
    return low;
  }
}
