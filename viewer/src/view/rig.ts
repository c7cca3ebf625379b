import { type Box3, MathUtils, PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

/** From where a view looks: towards the middle, z up. */
export type ViewName = 'free' | 'top' | 'front' | 'side';

const directions: Record<ViewName, Vector3> = {
  free: new Vector3(-0.52, -0.95, 0.62).normalize(),
  top: new Vector3(0, -1e-3, 1).normalize(),
  front: new Vector3(0, -1, 0.06).normalize(),
  side: new Vector3(1, 0, 0.06).normalize(),
};

/** Vertical opening angles (degrees): from outside, and from a machine. */
const opening = 38;
const openingAboard = 62;
const flightSeconds = 0.7;
/** Share of the picture that what is fitted fills, and how much of its top (px) is under the buttons. */
const fill = 0.92;
const underButtons = 48;

/** The camera: turned, moved and brought near by pointer and keys, flying gently to where it is sent, or riding on a machine. */
export class Rig {
  readonly camera = new PerspectiveCamera(opening, 1, 0.3, 2000);
  private readonly controls: OrbitControls;
  private flight: { position: [Vector3, Vector3]; target: [Vector3, Vector3]; began: number } | null = null;
  private aboard = false;
  /** Of the picture (px). */
  private height = 1;
  /** What is fitted, as long as nobody has moved the camera since: a new size of the picture asks for a new distance. */
  private fitted: { points: Vector3[]; view: ViewName | null } | null = null;
  private readonly still = matchMedia('(prefers-reduced-motion: reduce)');

  /** `moved` is called when the camera is moved by hand; `left`: when that ends a ride. */
  constructor(element: HTMLElement, scene: Box3, moved: () => void, left: () => void) {
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, element);
    this.controls.zoomToCursor = true;
    this.controls.maxPolarAngle = Math.PI * 0.497;
    this.controls.addEventListener('change', moved);
    this.controls.addEventListener('start', () => {
      this.flight = null;
      this.fitted = null;
      if (this.aboard) left();
    });
    const size = scene.getSize(new Vector3()).length();
    this.controls.maxDistance = 6 * size + 20;
    this.controls.minDistance = 0.5;
    this.camera.far = 12 * size + 100;
    this.camera.near = MathUtils.clamp(size / 400, 0.1, 0.5);
  }

  resize(width: number, height: number): void {
    this.height = height;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.fitted) this.fit(this.fitted.points, this.fitted.view, false);
  }

  /** Looks at all of these points (m) from where the camera is now, or from a side, as near as it can. */
  fit(points: Vector3[], view: ViewName | null = null, gently = true): void {
    if (points.length === 0) return;
    this.leave();
    this.fitted = { points, view };
    const back = view ? directions[view].clone() : this.camera.position.clone().sub(this.controls.target).normalize();
    const right = new Vector3().crossVectors(this.camera.up, back).normalize();
    const up = new Vector3().crossVectors(back, right);
    const tall = Math.tan(MathUtils.degToRad(opening / 2));
    const top = Math.min(fill, 1 - (2 * underButtons) / Math.max(this.height, 4 * underButtons));
    // The eye must be behind the four planes through the rims of the picture and the outermost points.
    const rims = [[right, fill * tall * this.camera.aspect, fill * tall * this.camera.aspect],
      [up, top * tall, fill * tall]] as const;
    const eye = rims.map(([axis, over, under]) => {
      let [positive, negative] = [-Infinity, -Infinity];
      for (const point of points) {
        positive = Math.max(positive, point.dot(axis) + over * point.dot(back));
        negative = Math.max(negative, -point.dot(axis) + under * point.dot(back));
      }
      // Farther away there is room between the planes: then in their middle.
      const along = (away: number) => (positive - over * away + under * away - negative) / 2;
      return { along, away: (positive + negative) / (over + under) };
    });
    const [farthest, nearest] = minMax(points.map((point) => point.dot(back)));
    const middle = (farthest + nearest) / 2;
    const away = Math.max(eye[0].away, eye[1].away, nearest + 2);
    const across = right.clone().multiplyScalar(eye[0].along(away)).addScaledVector(up, eye[1].along(away));
    this.go(across.clone().addScaledVector(back, away), across.clone().addScaledVector(back, middle), gently);
  }

  /** Keys of the camera: how far to the right, up (turns, or moves if `sideways`) and nearer. */
  nudge(right: number, up: number, nearer: number, sideways: boolean): void {
    this.flight = null;
    this.fitted = null;
    const { target } = this.controls;
    const arm = this.camera.position.clone().sub(target);
    if (sideways) {
      const across = new Vector3().crossVectors(this.camera.up, arm).normalize();
      const ahead = new Vector3().crossVectors(this.camera.up, across).normalize();
      const step = across.multiplyScalar(right * 0.06 * arm.length()).addScaledVector(ahead, up * 0.06 * arm.length());
      target.add(step);
    } else {
      arm.applyAxisAngle(this.camera.up, right * 0.12);
      const height = MathUtils.clamp(Math.asin(arm.z / arm.length()) + up * 0.1, 0.01, Math.PI / 2 - 1e-3);
      const flat = Math.hypot(arm.x, arm.y) || 1e-9;
      const length = arm.length();
      arm.set((arm.x / flat) * Math.cos(height), (arm.y / flat) * Math.cos(height), Math.sin(height)).multiplyScalar(length);
    }
    arm.multiplyScalar(0.85 ** nearer);
    this.camera.position.copy(target).add(arm);
    this.controls.update();
  }

  /** Rides: the eye and what it looks at, in {W}, anew for each picture. */
  ride(eye: Vector3, at: Vector3): void {
    if (!this.aboard) {
      this.aboard = true;
      this.flight = null;
      this.fitted = null;
      this.controls.enableZoom = false;
      this.setOpening(openingAboard);
    }
    this.camera.position.copy(eye);
    this.controls.target.copy(at);
    this.camera.lookAt(at);
  }

  /** Ends a ride; the camera stays where it is. */
  leave(): void {
    if (!this.aboard) return;
    this.aboard = false;
    this.controls.enableZoom = true;
    this.setOpening(opening);
  }

  /** Whether the camera is on its way to where it was sent. */
  get flying(): boolean { return this.flight !== null; }

  /** Goes on with a flight; true as long as it lasts. */
  fly(now: number): boolean {
    if (!this.flight) return false;
    const share = Math.min((now - this.flight.began) / (1000 * flightSeconds), 1);
    const eased = share * share * (3 - 2 * share);
    this.camera.position.lerpVectors(...this.flight.position, eased);
    this.controls.target.lerpVectors(...this.flight.target, eased);
    if (share >= 1) this.flight = null;
    this.controls.update();
    return true;
  }

  private go(position: Vector3, target: Vector3, gently: boolean): void {
    if (!gently || this.still.matches) {
      this.flight = null;
      this.camera.position.copy(position);
      this.controls.target.copy(target);
      this.controls.update();
      return;
    }
    this.flight = { position: [this.camera.position.clone(), position], target: [this.controls.target.clone(), target],
      began: performance.now() };
  }

  private setOpening(angle: number): void {
    this.camera.fov = angle;
    this.camera.updateProjectionMatrix();
  }
}

/** The least and the greatest; of any number of values. */
function minMax(values: number[]): [number, number] {
  let [least, greatest] = [Infinity, -Infinity];
  for (const value of values) {
    least = Math.min(least, value);
    greatest = Math.max(greatest, value);
  }
  return [least, greatest];
}
