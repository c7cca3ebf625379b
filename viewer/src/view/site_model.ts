import { Box3, Group, Matrix4, Vector3 } from 'three';
import type { Film } from '../film';
import type { ShapeData } from '../header';
import { Mechanism, poseMatrix } from '../kinematics';
import type { Motion } from '../motion';
import { Stock } from '../stock';
import { Batch, type Light } from './batch';
import { expandBy, Shapes } from './shapes';

/** An element of one of the three batches. */
export interface Part {
  batch: 'site' | 'component' | 'machine';
  element: number;
}

/** A machine's bodies in the batch of machines, and where it is. */
export interface Machine {
  robot: number;
  mechanism: Mechanism;
  /** The element of its first body; the others follow. */
  first: number;
  /** Parameters at the moment shown (m, degrees). */
  q: ArrayLike<number>;
}

const margin = 10;

/** The things of the site as they are drawn, and where they are at the moment shown. */
export class SiteModel {
  readonly group = new Group();
  readonly site: Batch;
  readonly components: Batch;
  readonly machines: Batch;
  readonly robots: Machine[];
  readonly stock: Stock;
  /** In its own frame, by component. */
  readonly componentBounds: Box3[];
  readonly machineBounds: Box3[];
  /** The element of the site that is the ground, and where its top is. */
  readonly ground: { element: number; box: Box3 };
  /** What is worth looking at at some time: all but the ground. */
  readonly extent: Box3;
  /** The element of `header.carry` in the batch of machines, -1: there is none. */
  readonly carry: number;
  /** X_WO by component at the moment shown. */
  readonly poses: Matrix4[];
  private readonly shapes: Shapes;
  private readonly parts = new Map<string, Part[]>();

  constructor(private readonly film: Film, private readonly motion: Motion, light: Light) {
    const { header } = film;
    this.shapes = new Shapes(film);
    this.stock = new Stock(film);
    this.poses = this.stock.items.map((item) => item.pose.clone());

    const components = this.shapes.surface(header.components.map((component) => component.shapes));
    this.componentBounds = components.bounds;
    this.components = new Batch(components, header.components.length, light, { pick: 1 });

    const bodies: ShapeData[][] = [];
    this.robots = header.robots.map((robot, i) => {
      const first = bodies.length;
      for (const body of robot.bodies) bodies.push(body.shapes);
      return { robot: i, mechanism: new Mechanism(robot), first, q: [] };
    });
    this.carry = header.carry.length > 0 && this.robots.length > 0 ? bodies.push(header.carry) - 1 : -1;
    const machines = this.shapes.surface(bodies);
    this.machineBounds = machines.bounds;
    this.machines = new Batch(machines, bodies.length, light, { pick: 1 + header.components.length });

    this.move(0, -1);
    this.stock.items.forEach((item, i) => this.components.setPose(i, item.pose));
    this.extent = this.measure();
    const site = header.site.map((shape) => [shape]);
    const bounds = this.shapes.surface(site).bounds;
    const areas = bounds.map((box) => (box.max.x - box.min.x) * (box.max.y - box.min.y));
    let ground = areas.indexOf(Math.max(...areas));
    if (ground < 0) {
      const box = this.plain();
      ground = site.push([{ type: 'box', pose: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], lower: box.min.toArray(), upper: box.max.toArray() }]) - 1;
      bounds.push(box);
    }
    this.ground = { element: ground, box: bounds[ground] };
    this.site = new Batch(this.shapes.surface(site), site.length, light, { grid: true });
    bounds.forEach((box, i) => {
      this.site.setPose(i, new Matrix4());
      if (i !== ground) this.extent.union(box);
    });
    if (this.extent.isEmpty()) this.extent.copy(this.ground.box);
    this.group.add(this.site.mesh, this.components.mesh, this.machines.mesh);
    this.nameParts();
  }

  /** The batches in the order in which they are drawn. */
  get batches(): Batch[] {
    return [this.site, this.components, this.machines];
  }

  /** Brings everything to a moment (s); `tried` as in Stock. Returns the components that are not as they were. */
  move(time: number, tried: number): Set<number> {
    for (const machine of this.robots) {
      machine.q = this.motion.configuration(machine.robot, time, tried);
      machine.mechanism.place(machine.q);
      machine.mechanism.bodies.forEach((pose, i) => this.machines.setPose(machine.first + i, pose));
    }
    if (this.carry >= 0) this.machines.setPose(this.carry, this.robots[0].mechanism.tool);
    const changed = this.stock.seek(time, tried);
    for (const i of changed) this.place(i);
    this.stock.items.forEach((item, i) => {
      if (item.state === 'carried' && !changed.has(i)) this.place(i);
    });
    return changed;
  }

  /** Everything that a name of a refused step means: `robot.body`, a component, `load`, `site 2`, `the load chart of ROBOT`. */
  partsOf(name: string): Part[] {
    if (name === 'load') {
      if (this.carry >= 0) return [{ batch: 'machine', element: this.carry }];
      return this.stock.items.flatMap((item, element) => (item.state === 'carried' ? [{ batch: 'component' as const, element }] : []));
    }
    const chart = 'the load chart of ';
    return this.parts.get(name.startsWith(chart) ? name.slice(chart.length) : name) ?? [];
  }

  partsOfRobot(robot: number): Part[] {
    const { first } = this.robots[robot];
    return this.film.header.robots[robot].bodies.map((_, i) => ({ batch: 'machine', element: first + i }));
  }

  /** Where a component or a machine is now, in {W} (m). */
  boundsOf(parts: Part[]): Box3 {
    const box = new Box3();
    const bodies = this.robots.flatMap((machine) => machine.mechanism.bodies);
    for (const { batch, element } of parts) {
      if (batch === 'component') expandBy(box, this.componentBounds[element], this.poses[element]);
      else if (batch === 'machine') expandBy(box, this.machineBounds[element], bodies[element] ?? this.robots[0].mechanism.tool);
    }
    return box;
  }

  private place(component: number): void {
    const item = this.stock.items[component];
    const pose = this.poses[component].copy(item.pose);
    if (item.state === 'carried' && this.robots[item.robot]) pose.premultiply(this.robots[item.robot].mechanism.tool);
    this.components.setPose(component, pose);
  }

  private measure(): Box3 {
    const box = new Box3();
    const numbers = new Map(this.film.header.components.map((component, i) => [component.name, i]));
    this.poses.forEach((pose, i) => expandBy(box, this.componentBounds[i], pose));
    for (const task of this.film.header.tasks) {
      const component = numbers.get(task.move ?? '');
      if (component !== undefined && task.to) expandBy(box, this.componentBounds[component], poseMatrix(task.to));
    }
    return box.union(this.boundsOf(this.robots.flatMap((machine) => this.partsOfRobot(machine.robot))));
  }

  /** A ground for a plan that has none: as large as what stands on it, to whole tens of metres. */
  private plain(): Box3 {
    const around = this.extent.isEmpty() ? new Box3(new Vector3(), new Vector3()) : this.extent;
    const level = Math.min(0, around.min.z);
    const tens = (value: number, way: 1 | -1) => way * Math.ceil((way * value + margin) / 10) * 10;
    return new Box3(new Vector3(tens(around.min.x, -1), tens(around.min.y, -1), level - 0.3),
                    new Vector3(tens(around.max.x, 1), tens(around.max.y, 1), level));
  }

  private nameParts(): void {
    const { header } = this.film;
    const add = (name: string, part: Part) => this.parts.set(name, [...(this.parts.get(name) ?? []), part]);
    header.components.forEach(({ name }, element) => add(name, { batch: 'component', element }));
    header.robots.forEach((robot, i) => {
      for (const part of this.partsOfRobot(i)) {
        add(robot.name, part);
        add(`${robot.name}.${robot.bodies[part.element - this.robots[i].first].name}`, part);
      }
    });
    header.site.forEach((_, i) => add(header.site.length > 1 ? `site ${i + 1}` : 'site', { batch: 'site', element: i }));
  }
}
