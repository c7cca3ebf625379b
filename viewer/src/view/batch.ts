import {
  BufferAttribute, BufferGeometry, DataTexture, FloatType, GLSL3, type IUniform, type Matrix4, Mesh, NearestFilter, RGBAFormat,
  ShaderMaterial, Vector3,
} from 'three';
import { fragmentShader, pickShader, vertexShader } from './batch_shader';
import type { Surface } from './surface';
import type { Colour, Theme } from './theme';

/** How an element is drawn: not at all, as it is, or with thick edges in the colour of the selection. */
export type Style = 'hidden' | 'plain' | 'marked';
const styles: Record<Style, number> = { hidden: 0, plain: 1, marked: 2 };

/** Elements in a row of the table; each has four texels. */
const rowLength = 256;
const texels = 4;

export interface BatchOptions {
  /** Ground: a grid on what faces up. */
  grid?: boolean;
  /** Seen through and hatched. */
  translucent?: boolean;
  /** The number of the first element in pictures for picking; 0: not there. */
  pick?: number;
}

/** What all batches of a view share. */
export interface Light {
  edge: IUniform<Vector3>;
  selected: IUniform<Vector3>;
  gridColour: IUniform<Vector3>;
  /** Height above which nothing is drawn (m). */
  section: IUniform<number>;
  /** Pixels of the picture in one of the page. */
  pixelRatio: IUniform<number>;
}

export function makeLight(): Light {
  return {
    edge: { value: new Vector3() }, selected: { value: new Vector3() }, gridColour: { value: new Vector3() },
    section: { value: 1e9 }, pixelRatio: { value: 1 },
  };
}

export function setLight(light: Light, theme: Theme): void {
  light.edge.value.set(...theme.edge);
  light.selected.value.set(...theme.selected);
  light.gridColour.value.set(...theme.grid);
}

/**
 * Many elements in one draw call, however many and whatever their shapes: their triangles stand in one buffer, and where each
 * element is and how it looks in a table (a texture) that the shader reads.
 */
export class Batch {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  readonly triangles: number;
  private readonly picking: ShaderMaterial | null;
  private readonly cells: Float32Array;
  private readonly table: DataTexture;

  constructor(surface: Surface, readonly count: number, light: Light, options: BatchOptions = {}) {
    const rows = Math.max(1, Math.ceil(count / rowLength));
    this.cells = new Float32Array(rows * rowLength * texels * 4);
    this.table = new DataTexture(this.cells, rowLength * texels, rows, RGBAFormat, FloatType);
    this.table.minFilter = NearestFilter;
    this.table.magFilter = NearestFilter;
    const { positions, normals, rims, elements, corners } = surface.arrays();
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('facing', new BufferAttribute(normals, 4, true));
    geometry.setAttribute('rim', new BufferAttribute(rims, 4, true));
    geometry.setAttribute('element', new BufferAttribute(elements, 1));
    geometry.setIndex(new BufferAttribute(corners, 1));
    this.triangles = surface.triangles;
    const uniforms = { ...light, table: { value: this.table }, pick: { value: options.pick ?? 0 } };
    const material = new ShaderMaterial({ glslVersion: GLSL3, vertexShader, fragmentShader, uniforms });
    if (options.grid) material.defines.GRID = 1;
    if (options.translucent) {
      material.defines.TRANSLUCENT = 1;
      material.transparent = true;
      material.depthWrite = false;
    }
    this.picking = options.pick
      ? new ShaderMaterial({ glslVersion: GLSL3, vertexShader, fragmentShader: pickShader, uniforms, defines: { PICK: 1 } })
      : null;
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.matrixAutoUpdate = false;
  }

  /** X_W of an element's frame. */
  setPose(element: number, { elements: e }: Matrix4): void {
    const at = element * texels * 4;
    this.cells.set([e[0], e[4], e[8], e[12], e[1], e[5], e[9], e[13], e[2], e[6], e[10], e[14]], at);
    this.table.needsUpdate = true;
  }

  setLook(element: number, colour: Colour, style: Style): void {
    this.cells.set([...colour, styles[style]], element * texels * 4 + 12);
    this.table.needsUpdate = true;
  }

  /** Whether something is cut off at `light.section`: then insides are seen. */
  setCut(cut: boolean): void {
    for (const material of this.picking ? [this.mesh.material, this.picking] : [this.mesh.material]) {
      if (cut === 'CUT' in material.defines) continue;
      if (cut) material.defines.CUT = 1;
      else delete material.defines.CUT;
      material.side = cut ? 2 : 0;
      material.needsUpdate = true;
    }
  }

  /**
   * Draws with the numbers of elements for colours while `draw` runs; not at all if it is not there to be picked or not to be
   * seen.
   */
  pickWhile(draw: () => void): void {
    const { material } = this.mesh;
    if (!this.picking || !this.mesh.visible) return;
    this.mesh.material = this.picking;
    draw();
    this.mesh.material = material;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.picking?.dispose();
    this.table.dispose();
  }
}
