import { Box3, type Matrix4, Vector3 } from 'three';
import type { Film } from '../film';
import type { ShapeData } from '../header';
import { addShape } from './solids';
import type { MeshNumbers } from './mesh_solid';
import { Surface } from './surface';

/** Turns lists of shapes into surfaces; an element is a list. */
export class Shapes {
  constructor(private readonly film: Film) {}

  surface(elements: ShapeData[][]): Surface {
    const surface = new Surface();
    elements.forEach((shapes, element) => {
      surface.element = element;
      surface.bounds[element] = new Box3();
      for (const shape of shapes) addShape(surface, shape, (number) => this.mesh(number));
    });
    return surface;
  }

  private mesh(number: number): MeshNumbers {
    const data = this.film.header.meshes[number];
    if (!data) return { vertices: [], triangles: [] };
    return { vertices: this.film.column(data.vertices), triangles: this.film.column(data.triangles) };
  }
}

/** Grows a box by another that stands at a pose. */
export function expandBy(box: Box3, other: Box3, pose: Matrix4): void {
  if (!other.isEmpty()) box.union(other.clone().applyMatrix4(pose));
}

/** The eight corners of a box. */
export function cornersOf({ min, max }: Box3): Vector3[] {
  return [0, 1, 2, 3, 4, 5, 6, 7].map((i) => new Vector3(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z));
}
