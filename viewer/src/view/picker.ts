import { type PerspectiveCamera, type Scene, Vector2, WebGLRenderTarget, type WebGLRenderer } from 'three';
import type { SiteModel, Part } from './site_model';

/** Tells what is drawn at a pixel: one pixel is drawn with the numbers of the elements for colours. */
export class Picker {
  private readonly target = new WebGLRenderTarget(1, 1);
  private readonly pixel = new Uint8Array(4);

  constructor(private readonly renderer: WebGLRenderer, private readonly scene: Scene, private readonly camera: PerspectiveCamera,
              private readonly model: SiteModel) {}

  /** x, y in 0..1 from the upper left corner of the picture. Null: nothing that can be picked. */
  at(x: number, y: number): Part | null {
    const { renderer, camera, model } = this;
    const size = renderer.getSize(new Vector2());
    camera.setViewOffset(size.x, size.y, x * size.x, y * size.y, 1, 1);
    const background = renderer.getClearAlpha();
    renderer.setClearAlpha(0);
    const others = this.scene.children.filter((child) => child !== model.group && child.visible);
    for (const child of others) child.visible = false;
    renderer.setRenderTarget(this.target);
    renderer.clear();
    model.site.pickWhile(() => model.components.pickWhile(() => model.machines.pickWhile(() => renderer.render(this.scene, camera))));
    renderer.readRenderTargetPixels(this.target, 0, 0, 1, 1, this.pixel);
    renderer.setRenderTarget(null);
    for (const child of others) child.visible = true;
    renderer.setClearAlpha(background);
    camera.clearViewOffset();
    const [low, middle, high] = this.pixel;
    const number = low + 256 * middle + 65536 * high - 1;
    if (number < 0) return null;
    return number < model.components.count
      ? { batch: 'component', element: number }
      : { batch: 'machine', element: number - model.components.count };
  }
}
