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
