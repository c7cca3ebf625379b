import { BufferAttribute, BufferGeometry, type Box3, CanvasTexture, LinearFilter, Mesh, MeshBasicMaterial } from 'three';
import type { Theme } from './theme';

/** Pixels of a label in the picture of all labels. */
const wide = 128;
const tall = 48;
const most = 12;

/** Metres along the southern and western rim of the ground, written on it; one draw call. */
export class GroundLabels {
  readonly mesh: Mesh<BufferGeometry, MeshBasicMaterial>;
  private readonly texts: string[] = [];
  private readonly canvas = document.createElement('canvas');
  private readonly texture: CanvasTexture;

  constructor(ground: Box3) {
    const { min, max } = ground;
    const extent = Math.max(max.x - min.x, max.y - min.y);
    const step = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000].find((each) => extent / each <= most) ?? 5000;
    const height = extent * 0.022;
    const width = (height * wide) / tall;
    const positions: number[] = [];
    const uvs: number[] = [];
    const corners: number[] = [];
    const write = (text: string, x: number, y: number) => {
      const n = this.texts.push(text) - 1;
      const z = max.z + 0.01;
      positions.push(x, y, z, x + width, y, z, x + width, y + height, z, x, y + height, z);
      corners.push(4 * n, 4 * n + 1, 4 * n + 2, 4 * n, 4 * n + 2, 4 * n + 3);
    };
    const first = (low: number) => Math.ceil((low + 0.5 * width) / step) * step;
    for (let x = first(min.x); x < max.x - 0.6 * width; x += step) write(`${x + 0} m`, x - width / 2, min.y + 0.4 * height);
    for (let y = first(min.y); y < max.y - height; y += step) write(`${y + 0} m`, min.x + 0.3 * height, y - height / 2);
    const count = Math.max(this.texts.length, 1);
    // Rows go down in the picture, v goes up.
    for (let i = 0; i < this.texts.length; ++i) {
      const [low, high] = [1 - (i + 1) / count, 1 - i / count];
      uvs.push(0, low, 1, low, 1, high, 0, high);
    }
    this.canvas.width = wide;
    this.canvas.height = tall * count;
    this.texture = new CanvasTexture(this.canvas);
    this.texture.minFilter = LinearFilter;
    this.texture.generateMipmaps = false;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
    geometry.setAttribute('uv', new BufferAttribute(new Float32Array(uvs), 2));
    geometry.setIndex(corners);
    this.mesh = new Mesh(geometry, new MeshBasicMaterial({ map: this.texture, transparent: true, depthWrite: false }));
    this.mesh.material.polygonOffset = true;
    this.mesh.material.polygonOffsetFactor = -2;
    this.mesh.material.polygonOffsetUnits = -2;
    this.mesh.renderOrder = 2;
  }

  setTheme(theme: Theme): void {
    const pen = this.canvas.getContext('2d');
    if (!pen) return;
    pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
    pen.fillStyle = `rgb(${theme.label.map((part) => Math.round(255 * part)).join(' ')})`;
    pen.font = '600 34px system-ui, sans-serif';
    pen.textAlign = 'center';
    pen.textBaseline = 'middle';
    this.texts.forEach((text, i) => pen.fillText(text, wide / 2, tall * (i + 0.5), wide - 4));
    this.texture.needsUpdate = true;
  }
}
