import { Vector3 } from 'three';
import type { Film } from '../film';
import { poseMatrix } from '../kinematics';
import type { Light } from './batch';
import { Strokes } from './strokes';
import type { Theme } from './theme';

/** Above what they are drawn on (m). */
const above = 0.03;
/** Of a lane: how long the barbs of its arrow head are, and how far they stand off (m). */
const barb = { length: 0.8, across: 0.35 };
/** Half of the cross at a node (m). */
const cross = 0.35;

/** The networks of the site: a line for each lane, with an arrow head where it goes one way only, and a cross for each node. */
export class Lanes {
  readonly strokes: Strokes;
  private shown: Theme | null = null;

  constructor(private readonly film: Film, light: Light) {
    this.strokes = new Strokes(light, 1.6);
  }

  show(theme: Theme): void {
    if (theme === this.shown) return;
    this.shown = theme;
    this.strokes.clear();
    for (const network of this.film.header.networks ?? []) {
      const places = network.nodes.map(({ pose }) => {
        const place = new Vector3().setFromMatrixPosition(poseMatrix(pose));
        return place.setZ(place.z + above);
      });
      const both = new Set(network.lanes.map(({ from, to }) => `${to} ${from}`));
      for (const { from, to } of network.lanes) {
        const [a, b] = [places[from], places[to]];
        const oneWay = !both.has(`${from} ${to}`);
        if (!oneWay && from > to) continue;
        this.strokes.add(a, b, theme.label, 0.8);
        if (oneWay) this.addHead(a, b, theme);
      }
      for (const place of places) {
        for (const [x, y] of [[cross, cross], [cross, -cross]]) {
          this.strokes.add(place.clone().add(new Vector3(-x, -y, 0)), place.clone().add(new Vector3(x, y, 0)), theme.label);
        }
      }
    }
    this.strokes.flush();
  }

  /** In the middle of the lane. */
  private addHead(a: Vector3, b: Vector3, theme: Theme): void {
    const along = b.clone().sub(a);
    if (along.length() < 2 * barb.length) return;
    along.normalize();
    const tip = a.clone().lerp(b, 0.5).addScaledVector(along, barb.length / 2);
    const across = new Vector3(-along.y, along.x, 0);
    for (const side of [-barb.across, barb.across]) {
      this.strokes.add(tip, tip.clone().addScaledVector(along, -barb.length).addScaledVector(across, side), theme.label, 0.8);
    }
  }
}
