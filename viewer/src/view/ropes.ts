import { Vector3 } from 'three';
import type { Light } from './batch';
import { cornersOf } from './shapes';
import type { Machine, SiteModel } from './site_model';
import { Strokes } from './strokes';
import type { Theme } from './theme';

/** Shortest rope (m) that is drawn, and how far (m) it may be from plumb. */
const shortest = 1;
const plumb = 1e-3;

/**
 * What bodies leave out: ropes from a trolley to its hook, slings from the hook to the load, and where on the ground the hook
 * is.
 */
export class Ropes {
  readonly strokes: Strokes;

  constructor(private readonly model: SiteModel, light: Light) {
    this.strokes = new Strokes(light, 1.6);
  }

  show(theme: Theme): void {
    this.strokes.clear();
    for (const machine of this.model.robots) {
      const chain = machine.mechanism.chain();
      if (chain.length < 2) continue;
      const [above, hook] = chain.slice(-2).map((body) => new Vector3().setFromMatrixPosition(machine.mechanism.bodies[body]));
      if (Math.hypot(above.x - hook.x, above.y - hook.y) > plumb || above.z - hook.z < shortest) continue;
      this.strokes.add(above, hook, theme.rope);
      this.slings(machine, theme);
    }
    this.strokes.flush();
  }

  /** From the hook to the upper corners of what hangs on it, and a plumb line from there to the ground. */
  private slings(machine: Machine, theme: Theme): void {
    const { model } = this;
    const tool = new Vector3().setFromMatrixPosition(machine.mechanism.tool);
    const ground = model.ground.box.max.z;
    let lowest = tool.z;
    const hang = (corners: Vector3[]) => {
      for (const corner of corners) lowest = Math.min(lowest, corner.z);
      for (const corner of corners.slice(4)) if (corner.z < tool.z - 0.1) this.strokes.add(tool, corner, theme.rope, 0.9);
    };
    for (const i of model.loaded) {
      if (model.stock.items[i].robot !== machine.robot || model.componentBounds[i].isEmpty()) continue;
      hang(cornersOf(model.componentBounds[i]).map((corner) => corner.applyMatrix4(model.poses[i])));
    }
    const [high, low] = [lowest, ground].map((z) => new Vector3(tool.x, tool.y, z));
    if (lowest > ground + 0.1) this.strokes.add(high, low, theme.rope, 0.35);
  }
}
