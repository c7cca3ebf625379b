import { type PerspectiveCamera, Vector2, type WebGLRenderer, WebGLRenderTarget } from 'three';
import type { SiteModel, Part } from './site_model';

/** Tells what is drawn at a pixel: one pixel is drawn with the numbers of the elements for colours. */
export class Picker {
  private readonly target = new WebGLRenderTarget(1, 1);
  private readonly pixel = new Uint8Array(4);

  constructor(private readonly renderer: WebGLRenderer, private readonly camera: PerspectiveCamera, private readonly model: SiteModel) {}

  /** x, y in 0..1 from the upper left corner of the picture. Null: nothing that can be picked. */
  at(x: number, y: number): Part | null {
    const { renderer, camera, model } = this;
    const size = renderer.getSize(new Vector2());
    camera.setViewOffset(size.x, size.y, x * size.x, y * size.y, 1, 1);
    renderer.setRenderTarget(this.target);
    renderer.setClearColor(0, 0);
    renderer.clear();
    for (const batch of [model.components, ...(model.moving.visible ? [model.machines, model.loads] : [])]) {
      batch?.pickWhile(() => renderer.render(batch.mesh, camera));
    }
    renderer.readRenderTargetPixels(this.target, 0, 0, 1, 1, this.pixel);
    renderer.setRenderTarget(null);
    camera.clearViewOffset();
    const [low, middle, high] = this.pixel;
    const number = low + 256 * middle + 65536 * high - 1;
    if (number < 0) return null;
    const { count } = model.components;
    if (number < count) return { batch: 'component', element: number };
    if (number < count + model.machines.count) return { batch: 'machine', element: number - count };
    return { batch: 'component', element: model.loaded[number - count - model.machines.count] };
  }
}
