import { Vector3 } from 'three';
import type { Film } from '../film';
import type { Motion } from '../motion';
import { Walks } from '../walks';
import type { Light } from './batch';
import { make } from './elements';
import { Strokes } from './strokes';
import type { Theme } from './theme';

/** Above what they are drawn on (m). */
const above = 0.06;
/** Dashes of the line to the destination at most, and how long one is at least (m). */
const mostDashes = 60;
const leastDash = 0.4;
const names = ['towards', 'searching', 'tracking'];

/** The ways of guides in the plan view: what was driven by its mode, what is planned pale, the line to the destination. */
export class WalkLines {
  /** What was driven; what is planned. */
  readonly strokes: Strokes;
  readonly planned: Strokes;
  /** What the colours mean, while there is such a way. */
  readonly legend = make('div', 'view-legend');
  private readonly walks: Walks;
  private readonly entries: HTMLElement[];
  private shown = '';

  constructor(film: Film, motion: Motion, light: Light) {
    this.walks = new Walks(film, motion);
    this.strokes = new Strokes(light, 3.2, 0);
    this.planned = new Strokes(light, 1.6);
    this.entries = [...names, 'destination'].map((name) => {
      const text = name === 'destination' ? 'line to the destination' : name;
      const entry = make('span', `view-${name}`, text);
      this.legend.append(entry);
      return entry;
    });
    this.legend.hidden = true;
  }

  has(run: number): boolean {
    return this.walks.has(run);
  }

  /** `tried` as in Stock. */
  show(running: number[], tried: number, time: number, theme: Theme): void {
    const own = running.filter((run) => this.walks.has(run));
    const now = own.map((run) => this.walks.at(run, time));
    this.strokes.setNow(time);
    this.legend.hidden = now.every((walk) => walk < 0);
    const modes = new Set(own.map((run) => this.walks.modeAt(run, time, tried)));
    names.forEach((_, mode) => this.entries[mode].classList.toggle('view-now', modes.has(mode)));
    const key = `${own.join(' ')} ${now.join(' ')} ${tried} ${theme.dark}`;
    if (key === this.shown) return;
    this.shown = key;
    this.strokes.clear();
    this.planned.clear();
    const up = (place: Vector3) => place.clone().setZ(place.z + above);
    own.forEach((run, i) => {
      for (const { from, to, begins, ends, mode } of this.walks.drivenIn(run, tried)) {
        this.strokes.add(up(from), up(to), theme.modes[mode], 1, begins, ends);
      }
      const walk = this.walks.of(run)[now[i]];
      if (!walk || walk.corners.length < 2) return;
      walk.corners.slice(1).forEach(({ place, mode }, k) => {
        this.planned.add(up(walk.corners[k].place), up(place), theme.modes[mode], 0.6);
      });
      this.addDashes(up(walk.corners[0].place), up(walk.corners[walk.corners.length - 1].place), theme);
    });
    this.strokes.flush();
    this.planned.flush();
  }

  private addDashes(from: Vector3, to: Vector3, theme: Theme): void {
    const length = from.distanceTo(to);
    const count = Math.max(Math.min(Math.floor(length / (2 * leastDash)), mostDashes), 1);
    for (let i = 0; i < count; ++i) {
      this.planned.add(from.clone().lerp(to, i / count), from.clone().lerp(to, (i + 0.55) / count), theme.dark ? theme.label : theme.edge, 0.8);
    }
  }
}
