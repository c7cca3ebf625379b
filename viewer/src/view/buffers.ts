import { Matrix4, type Box3 } from 'three';
import type { ShapeData } from '../header';
import { poseRows } from '../kinematics';

/**
 * A shape with a buffer of `by` (m) round it, as it is drawn: edges are not rounded, and prisms and meshes are shown by the box
 * round them. `bounds`: of the shape, in the frame of its body.
 */
export function withBuffer(shape: ShapeData, by: number, bounds: Box3): ShapeData {
  const less = (numbers: number[] = []) => numbers.map((number) => number - by);
  const more = (numbers: number[] = []) => numbers.map((number) => number + by);
  switch (shape.type) {
    case 'box':
      return { ...shape, lower: less(shape.lower), upper: more(shape.upper) };
    case 'cylinder':
      return { ...shape, radius: (shape.radius ?? 0) + by, z0: (shape.z0 ?? 0) - by, z1: (shape.z1 ?? 0) + by };
    case 'sphere':
    case 'capsule':
      return { ...shape, radius: (shape.radius ?? 0) + by };
    default:
      return { type: 'box', pose: poseRows(new Matrix4()), lower: less(bounds.min.toArray()), upper: more(bounds.max.toArray()) };
  }
}
