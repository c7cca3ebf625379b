import { type Box3, type PerspectiveCamera, Vector2, Vector3, type WebGLRenderer, WebGLRenderTarget } from 'three';
import type { Selection } from '../player';
import type { SiteModel } from './site_model';

/** Tells what is drawn at a place: one pixel is drawn with the numbers of the elements for colours. */
export class Picker {
  private readonly target = new WebGLRenderTarget(1, 1);
  private readonly pixel = new Uint8Array(4);

  constructor(private readonly renderer: WebGLRenderer, private readonly camera: PerspectiveCamera,
              private readonly model: SiteModel) {}

  /** The component or robot at a place in the window (CSS pixels), null if there is none. */
  at(x: number, y: number): Selection | null {
    const { left, top, width, height } = this.renderer.domElement.getBoundingClientRect();
    return this.draw((x - left) / width, (y - top) / height);
  }

  /**
   * Where in the window (CSS pixels) a click picks something that lies in a box, null if it is out of sight or something of the
   * page lies over it.
   */
  whereIs(what: Selection, box: Box3): { x: number; y: number } | null {
    const { left, top, width, height } = this.renderer.domElement.getBoundingClientRect();
    for (const share of [0.5, 0.98, 0.02, 0.8, 0.2]) {
      for (const point of this.pointsOf(box, share)) {
        // Whole pixels: that is where a pointer can be.
        const [x, y] = [Math.round(left + (0.5 + 0.5 * point.x) * width), Math.round(top + (0.5 - 0.5 * point.y) * height)];
        const picked = this.at(x, y);
        const covered = document.elementFromPoint(x, y) !== this.renderer.domElement;
        if (!covered && picked?.kind === what.kind && picked.index === what.index) return { x, y };
      }
    }
    return null;
  }

  /**
   * Points on the faces of a box ({W}, m) that are in the picture, which goes from -1 to 1; `share`: where between the middle
   * of a face (0.5) and its rim.
   */
  pointsOf(box: Box3, share: number): Vector3[] {
    if (box.isEmpty()) return [];
    this.camera.updateMatrixWorld();
    const size = box.getSize(new Vector3());
    const places = [0, 1, 2].flatMap((axis) => [0, 1].flatMap((end) => [share, 1 - share].map((u) => {
      const place = new Vector3(share, u, 1 - u).setComponent(axis, end);
      return box.min.clone().add(place.multiply(size)).project(this.camera);
    })));
    return places.filter(({ x, y, z }) => Math.abs(x) < 1 && Math.abs(y) < 1 && z < 1);
  }

  /** What share of the picture, across or down, a box ({W}, m) fills; 0 if not all of it is in the picture. */
  sizeOf(box: Box3): number {
    const seen = this.pointsOf(box, 0.5);
    const span = (of: (point: Vector3) => number) => (Math.max(...seen.map(of)) - Math.min(...seen.map(of))) / 2;
    return seen.length < 12 ? 0 : Math.max(span(({ x }) => x), span(({ y }) => y));
  }

  /** x, y in 0..1 from the upper left corner of the picture. */
  private draw(x: number, y: number): Selection | null {
    const { renderer, camera, model } = this;
    const size = renderer.getSize(new Vector2());
    camera.setViewOffset(size.x, size.y, x * size.x, y * size.y, 1, 1);
    camera.updateMatrixWorld();
    renderer.setRenderTarget(this.target);
    renderer.setClearColor(0, 0);
    renderer.clear();
    for (const batch of [model.components, ...(model.moving.visible ? [model.machines, model.loads] : [])]) {
      batch?.pickWhile(() => renderer.render(batch.mesh, camera));
    }
    renderer.readRenderTargetPixels(this.target, 0, 0, 1, 1, this.pixel);
    renderer.setRenderTarget(null);
    camera.clearViewOffset();
    return this.numbered(this.pixel[0] + 256 * this.pixel[1] + 65536 * this.pixel[2] - 1);
  }

  /** What has a number in pictures for picking. */
  private numbered(number: number): Selection | null {
    const { components, machines, robots, loaded, carry } = this.model;
    if (number < 0) return null;
    if (number < components.count) return { kind: 'component', index: number };
    const body = number - components.count;
    if (body >= machines.count) return { kind: 'component', index: loaded[body - machines.count] };
    const robot = body === carry ? robots[0] : robots.findLast((machine) => machine.first <= body);
    return robot ? { kind: 'robot', index: robot.robot } : null;
  }
}
