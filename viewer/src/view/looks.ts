import type { Film } from '../film';
import type { Player, Selection } from '../player';
import type { Style } from './batch';
import type { Part, SiteModel } from './site_model';
import { mixed, type Colour, type Theme } from './theme';

/** The kind of a component by its name: `wall` of `u_1_2.wall_3`. */
export function kindOf(name: string): string {
  return name.slice(name.lastIndexOf('.') + 1).replace(/[\d_]+$/, '') || name;
}

/** How bodies of one machine differ: share of white (positive) or black. */
const shades = [0, 0.22, -0.14, 0.36, -0.24, 0.12];

/** How far what is not meant is dimmed while something is pointed out. */
const dimmed = 0.72;

/** Colours what the model shows: by state and kind, with what is picked and the pair of a refused step pointed out. */
export class Looks {
  private readonly kinds: number[];
  private theme!: Theme;
  /** Of the refused step shown, by batch and element. */
  private pair = new Map<string, Colour>();
  private picked = new Set<string>();
  /** Components that tasks dig away. */
  private readonly soils: Set<string>;

  constructor(private readonly film: Film, private readonly model: SiteModel, private readonly player: Player) {
    const numbers = new Map<string, number>();
    this.kinds = film.header.components.map(({ name }) => {
      const kind = kindOf(name);
      if (!numbers.has(kind)) numbers.set(kind, numbers.size);
      return numbers.get(kind) ?? 0;
    });
    const digs = film.header.tasks.flatMap(({ dig, choices }) => [dig, ...(choices ?? []).map((choice) => choice.dig)]);
    this.soils = new Set(digs.flatMap((dig) => dig?.soil ?? []));
  }

  setTheme(theme: Theme): void {
    this.theme = theme;
  }

  machineColour(robot: number): Colour {
    return this.theme.machines[robot % this.theme.machines.length];
  }

  /** What is selected and what blocks may have changed: everything. */
  all(): void {
    const { model, film } = this;
    this.picked = new Set(this.selectedParts().map(key));
    this.pair = this.blockingPair();
    film.header.site.forEach((_, i) => this.site(i));
    this.site(model.ground.element);
    film.header.components.forEach((_, i) => this.component(i));
    film.header.robots.forEach((robot, r) => robot.bodies.forEach((_, i) => this.body(r, i)));
    model.movingPoses.forEach((_, i) => this.moving(i));
    const soil = this.pair.size > 0 ? mixed(this.theme.soil, this.theme.skyBelow, dimmed) : this.theme.soil;
    for (let i = 0; i < model.soils.count; ++i) model.soils.setLook(i, soil, 'plain');
    if (model.carry >= 0) this.put({ batch: 'machine', element: model.carry }, this.theme.carried, 'plain');
  }

  component(element: number): void {
    const { state } = this.model.stock.items[element];
    const { theme } = this;
    const isSoil = this.soils.has(this.film.header.components[element].name);
    const colour = isSoil ? theme.soil : state === 'carried' ? theme.carried : state === 'waiting' ? theme.waiting
      : theme.components[this.kinds[element] % theme.components.length];
    const isDrawn = state !== 'removed' && !this.model.soilComponents.has(element);
    this.put({ batch: 'component', element }, colour, isDrawn ? 'plain' : 'hidden');
  }

  /** What keeps a timetable: people as their zones are, else as what stands. */
  moving(element: number): void {
    const { theme, model } = this;
    const people = this.film.header.movings?.[element].overhead !== undefined;
    const colour = people ? theme.zone : mixed(theme.fixture, [0, 0, 0], 0.35);
    this.put({ batch: 'moving', element }, colour, model.movingPoses[element] ? 'plain' : 'hidden');
  }

  selectedParts(): Part[] {
    const { selection } = this.player;
    return selection ? this.partsOf(selection) : [];
  }

  /** Of a run its component and its robot. */
  partsOf(selection: Selection): Part[] {
    const { header, runs } = this.film;
    if (selection.kind === 'component') return [{ batch: 'component', element: selection.index }];
    if (selection.kind === 'robot') return this.model.partsOfRobot(selection.index);
    const run = runs[selection.index];
    if (!run) return [];
    const moved = header.tasks.find((task) => task.name === run.task)?.move;
    const component = header.components.findIndex(({ name }) => name === moved);
    const parts: Part[] = component >= 0 ? [{ batch: 'component', element: component }] : [];
    return run.robot >= 0 ? [...parts, ...this.model.partsOfRobot(run.robot)] : parts;
  }

  private site(element: number): void {
    const { theme, model } = this;
    const isEarth = Boolean(this.film.header.site_names?.[element]);
    this.put({ batch: 'site', element }, isEarth ? theme.earth : element === model.ground.element ? theme.ground : theme.fixture, 'plain');
  }

  private body(robot: number, body: number): void {
    const shade = shades[body % shades.length];
    const colour = mixed(this.machineColour(robot), shade > 0 ? [1, 1, 1] : [0, 0, 0], Math.abs(shade));
    this.put({ batch: 'machine', element: this.model.robots[robot].first + body }, colour, 'plain');
  }

  private put(part: Part, colour: Colour, style: Style): void {
    const { model, theme } = this;
    const load = part.batch === 'component' ? model.loaded.indexOf(part.element) : -1;
    const batch = { site: model.site, component: model.components, machine: model.machines, moving: model.movings }[part.batch];
    const marked = this.picked.has(key(part));
    let shown = marked ? mixed(colour, theme.selected, part.batch === 'component' ? 0.45 : 0.18) : colour;
    let drawn = style === 'plain' && marked ? 'marked' : style;
    const met = this.pair.get(key(part));
    if (this.pair.size > 0) {
      shown = met ?? mixed(colour, theme.skyBelow, dimmed);
      if (drawn === 'marked') drawn = 'plain';
    }
    batch.setLook(part.element, shown, load >= 0 ? 'hidden' : drawn);
    if (load >= 0) model.loads?.setLook(load, shown, drawn);
    // Not hatched: that is for people.
    if (part.batch === 'machine') model.envelopes.setLook(part.element, shown, 'marked');
  }

  /** What moved and what it met in the refused step that is shown; nothing of any other step. */
  pairParts(): { moved: Part[]; met: Part[] } {
    const { film, player: { record }, model } = this;
    if (record === null || film.kind(record) !== 'try' || film.number(record, 'try.ok') !== 0) return { moved: [], met: [] };
    return { moved: model.partsOf(film.text(record, 'try.moved')), met: model.partsOf(film.text(record, 'try.met')) };
  }

  private blockingPair(): Map<string, Colour> {
    const { moved, met } = this.pairParts();
    const { theme } = this;
    const coloured = (parts: Part[], colour: Colour) => parts.map((part): [string, Colour] => [key(part), colour]);
    return new Map([...coloured(met, theme.met), ...coloured(moved, theme.moved)]);
  }
}

function key({ batch, element }: Part): string {
  return `${batch} ${element}`;
}
