import { Group, Matrix4 } from 'three';
import type { Film } from '../film';
import type { ShapeData } from '../header';
import { poseMatrix } from '../kinematics';
import { Batch, type Light } from './batch';
import { Shapes } from './shapes';
import type { Colour, Theme } from './theme';

/** What is seen through: the zones of people while their task goes on, and where the component of a task is to go. */
export class Overlay {
  readonly group = new Group();
  private readonly shapes: Shapes;
  private batch: Batch | null = null;
  private shown = '';
  private readonly components: Map<string, number>;
  private readonly tasks: Map<string, number>;

  constructor(private readonly film: Film, private readonly light: Light) {
    this.shapes = new Shapes(film);
    this.components = new Map(film.header.components.map((component, i) => [component.name, i]));
    this.tasks = new Map(film.header.tasks.map((task, i) => [task.name, i]));
  }

  get triangles(): number {
    return this.batch?.triangles ?? 0;
  }

  /**
   * Shows what belongs to the runs that go on. `met`: what a refused step met, in its words; a zone of that name is pointed
   * out. Returns whether something is not as it was.
   */
  show(running: number[], zones: boolean, met: string, theme: Theme): boolean {
    const key = `${running.join(' ')} ${zones} ${met} ${theme.dark}`;
    if (key === this.shown) return false;
    this.shown = key;
    const elements: ShapeData[][] = [];
    const looks: { pose: Matrix4; colour: Colour; goal: boolean }[] = [];
    for (const run of running) {
      const task = this.film.header.tasks[this.tasks.get(this.film.runs[run].task) ?? -1];
      if (!task) continue;
      if (zones && task.zones.length > 0) {
        elements.push(task.zones);
        looks.push({ pose: new Matrix4(), colour: [`the zone of ${task.name}`, `the air above the zone of ${task.name}`].includes(met) ? theme.met : theme.zone, goal: false });
      }
      const component = this.film.header.components[this.components.get(task.move ?? '') ?? -1];
      if (!component || !task.to || this.film.runs[run].robot < 0) continue;
      elements.push(component.shapes);
      looks.push({ pose: poseMatrix(task.to), colour: theme.goal, goal: true });
    }
    this.clear();
    if (elements.length === 0) return true;
    const batch = new Batch(this.shapes.surface(elements), elements.length, this.light, { translucent: true });
    looks.forEach(({ pose, colour, goal }, i) => {
      batch.setPose(i, pose);
      batch.setLook(i, colour, goal ? 'marked' : 'plain');
    });
    batch.mesh.renderOrder = 4;
    this.batch = batch;
    this.group.add(batch.mesh);
    return true;
  }

  setCut(cut: boolean): void {
    this.batch?.setCut(cut);
  }

  private clear(): void {
    if (!this.batch) return;
    this.group.remove(this.batch.mesh);
    this.batch.dispose();
    this.batch = null;
  }
}
