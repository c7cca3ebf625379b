import { Box3, Group, Matrix4, Vector3 } from 'three';
import { Digs } from '../digs';
import type { Film, Track } from '../film';
import type { RobotData, ShapeData } from '../header';
import { Mechanism, poseMatrix, poseRows } from '../kinematics';
import type { Motion } from '../motion';
import { SoilCells } from '../soil_cells';
import { Stock, turnLeft } from '../stock';
import { Timetables } from '../timetable';
import { Batch, type Light } from './batch';
import { withBuffer } from './buffers';
import { cornersOf, expandBy, Shapes } from './shapes';

/** A rope between two bodies of a machine, by their numbers; `hangs`: the tool hangs on it. */
export interface RopeOfMachine {
  from: number;
  to: number;
  p_from: [number, number, number];
  p_to: [number, number, number];
  hangs: boolean;
}

/** An element of one of the batches. */
export interface Part {
  batch: 'site' | 'component' | 'machine' | 'moving';
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

/** Room (m) about what stands on a ground that the plan does not have. */
const margin = 10;
/** Moments at which it is looked where a machine comes. */
const wayMarks = 60;

/** Turns a pose (world) about the vertical through the origin of a tool; degrees. */
function turnAbout(pose: Matrix4, tool: Matrix4, degrees: number): void {
  const [x, y] = [tool.elements[12], tool.elements[13]];
  pose.premultiply(new Matrix4().makeTranslation(-x, -y, 0)).premultiply(new Matrix4().makeRotationZ(degrees * Math.PI / 180))
    .premultiply(new Matrix4().makeTranslation(x, y, 0));
}

/** The things of the site as they are drawn, and where they are at the moment shown. */
export class SiteModel {
  /** What changes only when a component changes hands, and what moves. */
  readonly still = new Group();
  readonly moving = new Group();
  readonly site: Batch;
  readonly components: Batch;
  readonly machines: Batch;
  /** Elements as in `machines`: those that stand for the room a machine keeps for itself. */
  readonly envelopes: Batch;
  /** What keeps a timetable, and where it is; null: not on the site. */
  readonly movings: Batch;
  readonly movingPoses: (Matrix4 | null)[];
  /** Cells that robots dig, and the components that these are. */
  readonly soils: Batch;
  readonly soilComponents: Set<number>;
  readonly robots: Machine[];
  readonly stock: Stock;
  /** In its own frame, by component. */
  readonly componentBounds: Box3[];
  readonly machineBounds: Box3[];
  /** The element of the site that is the ground, and where its top is. */
  readonly ground: { element: number; box: Box3 };
  /** What is worth looking at at some time: all but the ground. */
  readonly extent: Box3;
  /** Corners of all that is worth looking at. */
  readonly outline: Vector3[] = [];
  /** The element of `header.carry` in the batch of machines, -1: there is none. */
  readonly carry: number;
  /** X_WO by component at the moment shown. */
  readonly poses: Matrix4[];
  /** The components that are carried, anew in a batch of their own, so that the others stand still; and which they are. */
  loads: Batch | null = null;
  loaded: number[] = [];
  private readonly shapes: Shapes;
  private readonly timetables: Timetables;
  private readonly digs: Digs;
  private readonly soilCells: SoilCells;
  private readonly movingBounds: Box3[];
  private readonly parts = new Map<string, Part[]>();

  constructor(private readonly film: Film, private readonly motion: Motion, private readonly light: Light) {
    const { header } = film;
    this.shapes = new Shapes(film);
    this.stock = new Stock(film);
    this.digs = new Digs(film);
    this.soilCells = new SoilCells(film);
    this.soilComponents = this.soilCells.components;
    this.soils = new Batch(this.shapes.surface(this.soilCells.shapes), this.soilCells.shapes.length, light);
    this.poses = this.stock.items.map((item) => item.pose.clone());

    const movings = this.shapes.surface((header.movings ?? []).map(({ shapes }) => shapes));
    this.timetables = new Timetables(film);
    this.movingPoses = (header.movings ?? []).map(() => null);
    this.movingBounds = movings.bounds;
    this.movings = new Batch(movings, this.movingPoses.length, light);

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
    this.machineBounds = this.shapes.surface(bodies).bounds;
    const roomy = this.robots.flatMap((machine) => envelopesOf(header.robots[machine.robot], machine, this.shapes));
    const buffers = header.robots.flatMap((robot) => robot.bodies.map(({ shapes, buffer }) => this.buffersOf(shapes, buffer ?? 0)));
    const solid = bodies.map((shapes, i) => (roomy.includes(i) ? [] : shapes));
    const seenThrough = bodies.map((shapes, i) => [...(roomy.includes(i) ? shapes : []), ...(buffers[i] ?? [])]);
    this.machines = new Batch(this.shapes.surface(solid), bodies.length, light, { pick: 1 + header.components.length });
    this.envelopes = new Batch(this.shapes.surface(seenThrough), bodies.length, light, { translucent: true });
    this.envelopes.mesh.renderOrder = 4;

    this.stock.items.forEach((item, i) => this.components.setPose(i, item.pose));
    this.extent = this.measure();
    this.move(0, -1);
    const site = header.site.map((shape) => [shape]);
    const bounds = this.shapes.surface(site).bounds;
    const areas = bounds.map((box) => (box.max.x - box.min.x) * (box.max.y - box.min.y));
    let ground = areas.indexOf(Math.max(...areas));
    if (ground < 0) {
      const box = this.plain();
      const pose = poseRows(new Matrix4());
      ground = site.push([{ type: 'box', pose, lower: box.min.toArray(), upper: box.max.toArray() }]) - 1;
      bounds.push(box);
    }
    this.ground = { element: ground, box: bounds[ground] };
    this.site = new Batch(this.shapes.surface(site), site.length, light, { grid: true });
    bounds.forEach((box, i) => {
      this.site.setPose(i, new Matrix4());
      if (i !== ground) this.addOutline(box, new Matrix4());
    });
    if (this.outline.length === 0) this.addOutline(this.ground.box, new Matrix4());
    // A ground no longer than what is on it is worth looking at, all of it.
    const longest = ({ min, max }: Box3) => Math.max(max.x - min.x, max.y - min.y);
    if (longest(bounds[ground]) <= longest(this.extent)) this.addOutline(bounds[ground], new Matrix4());
    this.extent.setFromPoints(this.outline);
    this.still.add(this.site.mesh, this.components.mesh, this.soils.mesh);
    this.moving.add(this.machines.mesh, this.envelopes.mesh, this.movings.mesh);
    this.nameParts();
  }

  get batches(): Batch[] {
    return [this.site, this.components, this.soils, this.machines, this.envelopes, this.movings, ...(this.loads ? [this.loads] : [])];
  }

  /** Brings everything to a moment (s); `tried` as in Stock. Returns the components that are not as they were. */
  move(time: number, tried: number): Set<number> {
    for (const machine of this.robots) {
      machine.q = this.motion.configuration(machine.robot, time, tried);
      machine.mechanism.place(machine.q);
      for (const batch of [this.machines, this.envelopes]) {
        machine.mechanism.bodies.forEach((pose, i) => batch.setPose(machine.first + i, pose));
      }
    }
    this.movingPoses.forEach((_, i) => {
      const pose = this.timetables.poseAt(i, time);
      this.movingPoses[i] = pose;
      if (pose) this.movings.setPose(i, pose);
    });
    if (this.carry >= 0) this.machines.setPose(this.carry, this.robots[0].mechanism.tool);
    const changed = this.stock.seek(time, tried);
    if (changed.size > 0) this.load();
    for (const i of changed) {
      if (!this.loaded.includes(i)) this.components.setPose(i, this.poses[i].copy(this.stock.items[i].pose));
    }
    for (const [i, frame] of this.soilCells.seek(time)) {
      this.soils.setPose(i, frame);
      for (const component of this.soilComponents) changed.add(component);
    }
    for (const [i, shrunk] of this.digs.seek(time, changed)) {
      changed.add(i);
      this.components.setPose(i, this.stock.items[i].pose.clone().multiply(shrunk));
    }
    this.loaded.forEach((component, i) => {
      const { pose, robot, turn } = this.stock.items[component];
      this.poses[component].copy(pose);
      const tool = this.robots[robot]?.mechanism.tool;
      if (tool) this.poses[component].premultiply(tool);
      if (tool && turn) turnAbout(this.poses[component], tool, -turnLeft(turn, time));
      this.loads?.setPose(i, this.poses[component]);
    });
    return changed;
  }

  /** Makes the batch of what is carried. */
  private load(): void {
    this.loaded = this.stock.items.flatMap((item, i) => (item.state === 'carried' ? [i] : []));
    if (this.loads) this.moving.remove(this.loads.mesh);
    this.loads?.dispose();
    this.loads = null;
    if (this.loaded.length === 0) return;
    const { components } = this.film.header;
    const surface = this.shapes.surface(this.loaded.map((component) => components[component].shapes));
    this.loads = new Batch(surface, this.loaded.length, this.light, { pick: 1 + components.length + this.machines.count });
    this.moving.add(this.loads.mesh);
  }

  /** Everything that a name of a refused step means: `robot.body`, a component, `load`, `site 2`, `the load chart of ROBOT`. */
  partsOf(name: string): Part[] {
    if (name === 'load') {
      if (this.carry >= 0) return [{ batch: 'machine', element: this.carry }];
      return this.loaded.map((element) => ({ batch: 'component', element }));
    }
    const prefix = ['the load chart of ', 'the buffer of ', 'the air above '].find((text) => name.startsWith(text)) ?? '';
    return this.parts.get(name.slice(prefix.length)) ?? [];
  }

  ropesOf(robot: number): RopeOfMachine[] {
    const { bodies, tool } = this.film.header.robots[robot];
    const number = (name: string | null) => bodies.findIndex((body) => body.name === name);
    return bodies.flatMap(({ rope, parent }) => (rope ? [{ from: number(rope.from), to: number(parent), hangs: parent === tool.body,
      p_from: rope.p_from as [number, number, number], p_to: rope.p_to as [number, number, number] }] : []));
  }

  private buffersOf(shapes: ShapeData[], by: number): ShapeData[] {
    if (by === 0) return [];
    const { bounds } = this.shapes.surface(shapes.map((shape) => [shape]));
    return shapes.map((shape, i) => withBuffer(shape, by, bounds[i]));
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
      else if (batch === 'moving') {
        const pose = this.movingPoses[element];
        if (pose) expandBy(box, this.movingBounds[element], pose);
      } else if (batch === 'machine') expandBy(box, this.machineBounds[element], bodies[element] ?? this.robots[0].mechanism.tool);
    }
    return box;
  }

  private measure(): Box3 {
    const numbers = new Map(this.film.header.components.map((component, i) => [component.name, i]));
    this.poses.forEach((pose, i) => this.addOutline(this.componentBounds[i], pose));
    for (const task of this.film.header.tasks) {
      const component = numbers.get(task.move ?? '');
      if (component !== undefined && task.to) this.addOutline(this.componentBounds[component], poseMatrix(task.to));
    }
    (this.film.header.movings ?? []).forEach(({ path }, i) => {
      for (const { pose } of path) this.addOutline(this.movingBounds[i], poseMatrix(pose));
    });
    for (const track of this.film.tracks) this.addWay(track);
    for (const { mechanism, first } of this.robots) {
      mechanism.bodies.forEach((pose, i) => this.addOutline(this.machineBounds[first + i], pose));
    }
    return new Box3().setFromPoints(this.outline);
  }

  /** Where a machine comes. */
  private addWay({ robot, run, first, count }: Track): void {
    const { mechanism, first: body } = this.robots[robot];
    const times = this.film.column('key.t');
    for (let i = 0; i < wayMarks; ++i) {
      mechanism.place(this.motion.configuration(robot, times[first + Math.round((i * (count - 1)) / (wayMarks - 1))] ?? 0, run));
      mechanism.bodies.forEach((pose, part) => this.addOutline(this.machineBounds[body + part], pose));
    }
  }

  private addOutline(box: Box3, pose: Matrix4): void {
    if (!box.isEmpty()) for (const corner of cornersOf(box)) this.outline.push(corner.applyMatrix4(pose));
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
    (header.movings ?? []).forEach(({ name }, element) => add(name, { batch: 'moving', element }));
    const names = header.site_names ?? [];
    const unnamed = header.site.length - names.filter((name) => name).length;
    header.site.forEach((_, i) => add(names[i] || (unnamed > 1 ? `site ${i + 1}` : 'site'), { batch: 'site', element: i }));
  }
}

/**
 * The bodies of a robot that are no things: they may meet another body of it and have it, or half of it, inside as it stands at first. People write
 * them for the room that belongs to a machine, such as the column about the rope of a crane that reaches over another.
 */
function envelopesOf(robot: RobotData, { mechanism, first }: Machine, shapes: Shapes): number[] {
  mechanism.place(robot.parameters.map((parameter) => robot.start[parameter.name] ?? parameter.start));
  const boxes = (name: string) => {
    const body = robot.bodies.findIndex((each) => each.name === name);
    const pose = mechanism.bodies[body];
    if (!pose) return { element: -1, parts: [], whole: new Box3() };
    const parts = shapes.surface(robot.bodies[body].shapes.map((shape) => [shape])).bounds.map((box) => box.clone().applyMatrix4(pose));
    return { element: first + body, parts, whole: parts.reduce((all, box) => all.union(box), new Box3()) };
  };
  const within = (a: Box3, b: Box3, axis: 'x' | 'y') => a.min[axis] < b.min[axis] && a.max[axis] > b.max[axis];
  // One shape of it must do it alone: a hook block and a length of rope above it are no column.
  const half = (a: Box3, b: Box3) => 2 * (Math.min(a.max.z, b.max.z) - Math.max(a.min.z, b.min.z)) >= b.max.z - b.min.z;
  const inside = (outer: Box3[], inner: Box3) => !inner.isEmpty()
    && outer.some((part) => !part.isEmpty() && within(part, inner, 'x') && within(part, inner, 'y') && half(part, inner));
  return robot.touching.flatMap((pair) => {
    const [a, b] = pair.map(boxes);
    return [...(inside(a.parts, b.whole) ? [a.element] : []), ...(inside(b.parts, a.whole) ? [b.element] : [])];
  });
}
