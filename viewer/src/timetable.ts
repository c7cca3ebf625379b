import { Matrix4, Quaternion, Vector3 } from 'three';
import type { Film } from './film';
import type { MovingData } from './header';
import { poseMatrix } from './kinematics';

/** A stretch of time in which something goes by its timetable, or stands; times in s. */
interface Run {
  from: number;
  /** The time of its timetable then. */
  own: number;
  stands: boolean;
}

/** What something with a timetable does for a time (s): it goes, stays as its path says, or was stopped. */
export interface Stretch {
  from: number;
  to: number;
  kind: 'goes' | 'stays' | 'stopped';
}

/** Where things with a timetable are: by their paths and by the stops that the film tells. */
export class Timetables {
  private readonly paths: Path[];

  constructor({ header, movingStops }: Film) {
    this.paths = (header.movings ?? []).map((moving) => new Path(moving, movingStops.filter(({ name }) => name === moving.name)));
  }

  /** X_WO of one at a moment (s); null if it is not on the site. */
  poseAt(moving: number, time: number): Matrix4 | null {
    return this.paths[moving].poseAt(time);
  }

  /** What one does up to `until`, while it is on the site; at most `most` stretches. */
  stretches(moving: number, until: number, most: number): Stretch[] {
    return this.paths[moving].stretches(until, most);
  }
}

class Path {
  private readonly runs: Run[] = [{ from: 0, own: 0, stands: false }];
  private readonly places: { t: number; place: Vector3; turn: Quaternion }[];

  constructor(private readonly moving: MovingData, stops: { by: string; t: number }[]) {
    this.places = moving.path.map(({ t, pose }) => {
      const [place, turn, scale] = [new Vector3(), new Quaternion(), new Vector3()];
      poseMatrix(pose).decompose(place, turn, scale);
      return { t, place, turn };
    });
    for (const { by, t } of stops) {
      const last = this.runs[this.runs.length - 1];
      if (by !== '' && last.stands) continue;
      this.runs.push({ from: t, own: last.own + (last.stands ? 0 : t - last.from), stands: by !== '' });
    }
  }

  stretches(until: number, most: number): Stretch[] {
    const result: Stretch[] = [];
    const add = (stretch: Stretch) => {
      const last = result[result.length - 1];
      if (last && last.kind === stretch.kind && last.to === stretch.from) last.to = stretch.to;
      else if (stretch.to > stretch.from && result.length < most) result.push(stretch);
    };
    const [begin, end] = [this.places[0].t, this.places[this.places.length - 1].t];
    this.runs.forEach(({ from, own, stands }, i) => {
      const to = Math.min(this.runs[i + 1]?.from ?? until, until);
      if (stands) {
        if (own > begin || (own === begin && own === 0)) add({ from, to, kind: 'stopped' });
        return;
      }
      const shift = from - own;
      let round = this.moving.repeat ? Math.max(Math.floor((own - begin) / (end - begin)), 0) : 0;
      for (; result.length < most; ++round) {
        const passed = round * (end - begin) + shift;
        if (begin + passed >= to || (round > 0 && !this.moving.repeat)) break;
        for (let k = 1; k < this.places.length; ++k) {
          const [a, b] = [this.places[k - 1], this.places[k]];
          const same = a.place.distanceTo(b.place) < 1e-9 && Math.abs(a.turn.dot(b.turn)) > 1 - 1e-12;
          add({ from: Math.max(a.t + passed, from), to: Math.min(b.t + passed, to), kind: same ? 'stays' : 'goes' });
        }
      }
    });
    return result;
  }

  poseAt(time: number): Matrix4 | null {
    const run = this.runs.findLast(({ from }) => from <= time) ?? this.runs[0];
    let own = run.own + (run.stands ? 0 : time - run.from);
    const [begin, end] = [this.places[0].t, this.places[this.places.length - 1].t];
    if (own < begin || (run.stands && own === begin && own > 0)) return null;
    if (this.moving.repeat) own = begin + ((own - begin) % (end - begin));
    else if (own >= end) return null;
    const second = this.places.findIndex(({ t }) => t > own);
    const [a, b] = [this.places[second - 1], this.places[second]];
    const share = (own - a.t) / (b.t - a.t);
    return new Matrix4().compose(a.place.clone().lerp(b.place, share), a.turn.clone().slerp(b.turn, share), new Vector3(1, 1, 1));
  }
}
