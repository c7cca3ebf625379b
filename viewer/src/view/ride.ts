import { Vector3 } from 'three';
import type { Box3 } from 'three';
import type { Mechanism } from '../kinematics';

/** Height (m) above which a body is no vehicle but hangs from a mast: its cab is below it, and nobody stands behind it. */
const highUp = 8;

/**
 * The eye of who drives a machine, and what they look at, in {W} (m): aboard the first body that turns or drives, beside and
 * below its near end if that is high up (a crane's jib), else behind and above it (a vehicle). They look at the tool.
 */
export function cabOf(mechanism: Mechanism, bounds: (body: number) => Box3,
                      moves: (body: number) => boolean): { eye: Vector3; at: Vector3 } {
  const chain = mechanism.chain();
  const body = chain.find(moves) ?? chain[0];
  const at = new Vector3().setFromMatrixPosition(mechanism.tool);
  if (body === undefined) return { eye: at.clone().add(new Vector3(-8, -8, 6)), at };
  const pose = mechanism.bodies[body];
  const box = bounds(body);
  const tool = at.clone().applyMatrix4(pose.clone().invert());
  const forward = new Vector3(tool.x, tool.y, 0);
  if (forward.lengthSq() < 1e-6) forward.set(1, 0, 0);
  forward.normalize();
  const side = new Vector3(forward.y, -forward.x, 0);
  const eye = new Vector3();
  const low = new Vector3(0, 0, box.isEmpty() ? 0 : box.min.z).applyMatrix4(pose).z;
  if (low > highUp) {
    eye.addScaledVector(forward, 1.5).addScaledVector(side, 1.9).setZ(box.min.z - 0.2);
  } else {
    const size = box.isEmpty() ? new Vector3(3, 3, 1) : box.getSize(new Vector3());
    const back = Math.abs(forward.x) * size.x + Math.abs(forward.y) * size.y;
    eye.addScaledVector(forward, -0.9 * back - 2).setZ((box.isEmpty() ? 1 : box.max.z) + 1.6);
  }
  return { eye: eye.applyMatrix4(pose), at };
}
