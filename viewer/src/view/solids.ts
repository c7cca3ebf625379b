import { Matrix4, ShapeUtils, Vector2, Vector3 } from 'three';
import type { ShapeData } from '../header';
import { poseMatrix } from '../kinematics';
import { addMesh, type MeshNumbers } from './mesh_solid';
import { Surface } from './surface';

/** Pieces of a full turn by which round things are drawn. */
const turnPieces = 20;

/** Adds a shape to a surface, in the frame of what it belongs to (m). */
export function addShape(surface: Surface, shape: ShapeData, mesh: (number: number) => MeshNumbers): void {
  surface.frame = poseMatrix(shape.pose);
  const none = [0, 0, 0];
  const { lower = none, upper = none, centre = none, a = none, b = none, radius = 0, z0 = 0, z1 = 0 } = shape;
  switch (shape.type) {
    case 'box': return addBox(surface, lower, upper);
    case 'cylinder': return addPrism(surface, circle(radius), z0, z1, true);
    case 'prism': return addPrism(surface, (shape.polygon ?? []).map(([x, y]) => new Vector2(x, y)), z0, z1, false);
    case 'sphere': return addCapsule(surface, new Vector3(...centre), new Vector3(...centre), radius);
    case 'capsule': return addCapsule(surface, new Vector3(...a), new Vector3(...b), radius);
    case 'mesh': return addMesh(surface, mesh(shape.mesh ?? 0));
  }
}

function circle(radius: number): Vector2[] {
  return Array.from({ length: turnPieces }, (_, i) => {
    const angle = (2 * Math.PI * i) / turnPieces;
    return new Vector2(radius * Math.cos(angle), radius * Math.sin(angle));
  });
}

function addBox(surface: Surface, lower: number[], upper: number[]): void {
  for (let axis = 0; axis < 3; ++axis) {
    for (const side of [lower, upper]) {
      const normal = new Vector3().setComponent(axis, side === upper ? 1 : -1);
      // The corners of a face, counter-clockwise seen from outside.
      const [u, v] = side === upper ? [(axis + 1) % 3, (axis + 2) % 3] : [(axis + 2) % 3, (axis + 1) % 3];
      const corner = (atU: number[], atV: number[]) =>
        new Vector3().setComponent(axis, side[axis]).setComponent(u, atU[u]).setComponent(v, atV[v]);
      const corners = [corner(lower, lower), corner(upper, lower), corner(upper, upper), corner(lower, upper)];
      surface.quad(corners, [normal, normal, normal, normal], { u: true, v: true });
    }
  }
}

/** An extruded polygon; `round`: its sides are one smooth face. */
function addPrism(surface: Surface, polygon: Vector2[], z0: number, z1: number, round: boolean): void {
  if (polygon.length < 3) return;
  const corners = ShapeUtils.isClockWise(polygon) ? [...polygon].reverse() : polygon;
  const n = corners.length;
  const at = (i: number, z: number) => new Vector3(corners[i % n].x, corners[i % n].y, z);
  for (let i = 0; i < n; ++i) {
    const a = corners[i];
    const b = corners[(i + 1) % n];
    const flat = new Vector3(b.y - a.y, a.x - b.x, 0).normalize();
    const [left, right] = round ? [at(i, 0).normalize(), at(i + 1, 0).normalize()] : [flat, flat];
    surface.quad([at(i, z0), at(i + 1, z0), at(i + 1, z1), at(i, z1)], [left, right, right, left], { u: !round, v: true });
  }
  for (const [z, up] of [[z1, 1], [z0, -1]]) {
    const normal = new Vector3(0, 0, up);
    for (const [i, j, k] of ShapeUtils.triangulateShape(corners, [])) {
      const [a, b, c] = up > 0 ? [i, j, k] : [i, k, j];
      const rim = (p: number, q: number) => (q - p + n) % n === 1 || (p - q + n) % n === 1;
      surface.triangle([at(a, z), at(b, z), at(c, z)], [normal, normal, normal], [rim(b, c), rim(c, a), rim(a, b)]);
    }
  }
}

/** All points nearer than the radius to the segment from a to b. */
function addCapsule(surface: Surface, a: Vector3, b: Vector3, radius: number): void {
  const axis = b.clone().sub(a);
  const length = axis.length();
  const w = length > 1e-9 ? axis.divideScalar(length) : new Vector3(0, 0, 1);
  const u = Math.abs(w.x) < 0.9 ? new Vector3(1, 0, 0).cross(w).normalize() : new Vector3(0, 1, 0).cross(w).normalize();
  const basis = new Matrix4().makeBasis(u, w.clone().cross(u), w);
  const rings = turnPieces / 2;
  // From pole to pole; the middle ring is there twice, once about each end.
  const latitudes = Array.from({ length: rings + 2 }, (_, i) => Math.PI * ((i <= rings / 2 ? i : i - 1) / rings - 0.5));
  const normal = (i: number, j: number) => {
    const turn = (2 * Math.PI * j) / turnPieces;
    const flat = Math.cos(latitudes[i]);
    return new Vector3(flat * Math.cos(turn), flat * Math.sin(turn), Math.sin(latitudes[i])).transformDirection(basis);
  };
  const point = (i: number, j: number) => normal(i, j).multiplyScalar(radius).add(i <= rings / 2 ? a : b);
  for (let i = 0; i + 1 < latitudes.length; ++i) {
    if (i === rings / 2 && length <= 1e-9) continue;
    for (let j = 0; j < turnPieces; ++j) {
      const places = [[i, j], [i, j + 1], [i + 1, j + 1], [i + 1, j]];
      surface.quad(places.map(([p, q]) => point(p, q)), places.map(([p, q]) => normal(p, q)), { u: false, v: false });
    }
  }
}
