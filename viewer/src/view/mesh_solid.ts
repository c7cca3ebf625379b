import { Vector3 } from 'three';
import type { Surface } from './surface';

/** The corners of a mesh (x, y, z one after the other, m) and its triangles (three corners each). */
export interface MeshNumbers {
  vertices: ArrayLike<number>;
  triangles: ArrayLike<number>;
}

/** Cosine of the angle between faces (25 degrees) from which on they meet in an edge; below it they are one smooth face. */
const creaseCosine = Math.cos((25 * Math.PI) / 180);

/** Adds a mesh: lines where its faces meet at an angle, smooth between. */
export function addMesh(surface: Surface, { vertices, triangles }: MeshNumbers): void {
  const count = triangles.length / 3;
  const point = (corner: number) => new Vector3(vertices[3 * corner], vertices[3 * corner + 1], vertices[3 * corner + 2]);
  // As long as twice the area of the triangle: big ones count more where normals are averaged.
  const weighted = Array.from({ length: count }, (_, i) => {
    const [a, b, c] = [0, 1, 2].map((k) => point(triangles[3 * i + k]));
    return b.sub(a).cross(c.sub(a));
  });
  const normals = weighted.map((normal) => normal.clone().normalize());
  const around = new Map<number, number[]>();
  const beside = new Map<number, number[]>();
  const side = (a: number, b: number) => Math.min(a, b) * (vertices.length / 3) + Math.max(a, b);
  const add = (map: Map<number, number[]>, key: number, triangle: number) => {
    const all = map.get(key);
    if (all) all.push(triangle);
    else map.set(key, [triangle]);
  };
  for (let i = 0; i < count; ++i) {
    for (let k = 0; k < 3; ++k) {
      add(around, triangles[3 * i + k], i);
      add(beside, side(triangles[3 * i + k], triangles[3 * i + ((k + 1) % 3)]), i);
    }
  }
  const smooth = (i: number, corner: number) => {
    const sum = new Vector3();
    for (const other of around.get(corner) ?? []) if (normals[other].dot(normals[i]) > creaseCosine) sum.add(weighted[other]);
    return sum.lengthSq() > 0 ? sum.normalize() : normals[i];
  };
  const isEdge = (a: number, b: number) => {
    const faces = beside.get(side(a, b)) ?? [];
    return faces.length !== 2 || normals[faces[0]].dot(normals[faces[1]]) < creaseCosine;
  };
  for (let i = 0; i < count; ++i) {
    const corners = [0, 1, 2].map((k) => triangles[3 * i + k]);
    const [a, b, c] = corners;
    surface.triangle(corners.map(point), corners.map((corner) => smooth(i, corner)), [isEdge(b, c), isEdge(c, a), isEdge(a, b)]);
  }
}
