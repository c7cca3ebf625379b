import { Vector3 } from 'three';
import type { Light } from './batch';
import { cornersOf } from './shapes';
import type { Machine, RopeOfMachine, SiteModel } from './site_model';
import { Strokes } from './strokes';
import type { Theme } from './theme';

/** Shortest rope (m) that is drawn, and how far (m) it may be from plumb. */
const shortest = 1;
const plumb = 1e-3;

/**
 * What bodies leave out: ropes, slings from the hook to the load, and where on the ground the hook is. The ropes are those of the
 * robot file; of a machine that names none it is guessed.
 */
export class Ropes {
  readonly strokes: Strokes;

  constructor(private readonly model: SiteModel, light: Light) {
    this.strokes = new Strokes(light, 1.6);
  }

  show(theme: Theme): void {
    this.strokes.clear();
    for (const machine of this.model.robots) {
      const ropes = this.model.ropesOf(machine.robot);
      const ends = ropes.length > 0 ? ropes.map((rope) => this.ends(machine, rope)) : this.plumbRope(machine);
      for (const [above, below] of ends) this.strokes.add(above, below, theme.rope);
      if (ropes.some(({ hangs }) => hangs) || (ropes.length === 0 && ends.length > 0)) this.slings(machine, theme);
    }
    this.strokes.flush();
  }

  private ends({ mechanism }: Machine, { from, to, p_from, p_to }: RopeOfMachine): [Vector3, Vector3] {
    return [new Vector3(...p_from).applyMatrix4(mechanism.bodies[from]), new Vector3(...p_to).applyMatrix4(mechanism.bodies[to])];
  }

  /** Of a machine that names no rope: from the last body but one to the last, where that hangs plumb below it. */
  private plumbRope({ mechanism }: Machine): [Vector3, Vector3][] {
    const chain = mechanism.chain();
    if (chain.length < 2) return [];
    const [above, hook] = chain.slice(-2).map((body) => new Vector3().setFromMatrixPosition(mechanism.bodies[body]));
    return Math.hypot(above.x - hook.x, above.y - hook.y) > plumb || above.z - hook.z < shortest ? [] : [[above, hook]];
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
