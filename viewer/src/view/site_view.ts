import { Box3 } from 'three';
import { Activity } from '../activity';
import type { Film } from '../film';
import type { PoseRows } from '../header';
import { poseMatrix, poseRows } from '../kinematics';
import type { Motion } from '../motion';
import type { Player, Selection } from '../player';
import { makeLight, setLight } from './batch';
import { Card } from './card';
import { make } from './elements';
import { bindKeys } from './keys';
import { Floors, type FloorStep } from './floors';
import { ForeseenWays } from './foreseen_ways';
import { GroundLabels } from './labels';
import { Joints } from './joints';
import { Lanes } from './lanes';
import { Looks } from './looks';
import { Overlay } from './overlay';
import { Paths } from './paths';
import { Picker } from './picker';
import { cabOf } from './ride';
import { Rig, type ViewName } from './rig';
import { Ropes } from './ropes';
import { SearchGraphs } from './search_graphs';
import { Section } from './section';
import { cornersOf, expandBy } from './shapes';
import { SiteModel } from './site_model';
import { Stage, type Stats } from './stage';
import { themeOf, type Theme } from './theme';
import { Toolbar, type Tool } from './toolbar';
import { WalkLines } from './walks';
import { WorkspaceLines } from './workspace_lines';
import './view.css';

/** Room (m) about what is flown to. */
const roomAround = 6;
/** Share of the picture that a refused pair fills at least, or the camera goes nearer. */
const leastPair = 0.12;

/** What each step of the way over an area is. */
const stepTitles: Record<FloorStep, string> = {
  beams: 'Areas: beams and edges, cut where they meet; what a column obstructs stands out',
  cells: 'Areas: the cells that the floor is cut into',
  adjacency: 'Areas: which cells have a border in common',
  order: 'Areas: the order of the cells',
  lines: 'Areas: the lines at work, and passes beside borders and columns',
};

/** The site in 3D at the moment that the player shows. Draws by itself, whenever something changed. */
export class SiteView {
  private readonly light = makeLight();
  private readonly model: SiteModel;
  private readonly looks: Looks;
  private readonly activity: Activity;
  private readonly overlay: Overlay;
  private readonly paths: Paths;
  private readonly walks: WalkLines;
  private readonly graphs: SearchGraphs;
  private readonly foreseen: ForeseenWays;
  private readonly workspaces: WorkspaceLines;
  private readonly ropes: Ropes;
  private readonly lanes: Lanes;
  private readonly joints: Joints;
  private readonly floors: Floors;
  private readonly labels: GroundLabels;
  private readonly card: Card;
  private readonly section: Section;
  private readonly toolbar: Toolbar;
  private readonly rig: Rig;
  private readonly stage: Stage;
  private readonly picker: Picker;
  private readonly shows = { paths: true, zones: true, workspaces: true, search: false };
  /** Steps of the ways over areas that are shown. */
  private readonly steps = new Set<FloorStep>();
  private theme: Theme;
  /** The robot that the camera rides on, -1: none. */
  private riding = -1;
  /** Whether what is picked is being picked here. */
  private picking = false;
  private movedOn = true;
  private repainted = true;

  /** Throws where there is no WebGL; `openSiteView` says so in the page instead. */
  constructor(host: HTMLElement, private readonly film: Film, motion: Motion, private readonly player: Player) {
    this.theme = themeOf(host);
    this.model = new SiteModel(film, motion, this.light);
    this.activity = new Activity(film);
    this.looks = new Looks(film, this.model, player);
    this.overlay = new Overlay(film, this.light);
    this.paths = new Paths(film, motion, this.light);
    this.walks = new WalkLines(film, motion, this.light);
    this.graphs = new SearchGraphs(film, this.light);
    this.foreseen = new ForeseenWays(film, this.light);
    this.workspaces = new WorkspaceLines(film, motion, this.light);
    this.ropes = new Ropes(this.model, this.light);
    this.lanes = new Lanes(film, this.light);
    this.joints = new Joints(film, this.light);
    this.floors = new Floors(film, this.light);
    this.labels = new GroundLabels(this.model.ground.box);
    this.card = new Card(film, player, this.model, this.activity);
    const { extent, ground } = this.model;
    this.section = new Section(player, ground.box.max.z, Math.max(extent.max.z, ground.box.max.z + 3));
    this.toolbar = this.makeToolbar();
    const canvas = make('canvas', 'view-canvas');
    this.rig = new Rig(canvas, new Box3().copy(extent).union(ground.box), () => this.stage.touch(), () => this.ride(-1));
    this.stage = new Stage(host, canvas, this.rig.camera, (ratio, width, height) => {
      this.rig.resize(width, height);
      this.light.pixelRatio.value = ratio;
      for (const strokes of [this.paths.strokes, this.ropes.strokes, this.lanes.strokes, this.joints.strokes, this.floors.strokes,
        this.walks.strokes, this.walks.planned, this.graphs.strokes, this.foreseen.strokes, this.workspaces.strokes, this.workspaces.marks]) strokes.size.set(width * ratio, height * ratio);
    });
    this.picker = new Picker(this.stage.renderer, this.rig.camera, this.model);
    this.stage.still.add(this.model.still, this.labels.mesh);
    this.stage.moving.add(this.model.moving, this.paths.strokes.mesh, this.ropes.strokes.mesh, this.lanes.strokes.mesh, this.joints.strokes.mesh,
      this.floors.strokes.mesh, this.graphs.strokes.mesh, this.workspaces.strokes.mesh, this.workspaces.marks.mesh, this.foreseen.strokes.mesh, this.walks.planned.mesh, this.walks.strokes.mesh, this.overlay.group);
    canvas.tabIndex = 0;
    host.append(canvas, this.walks.legend, this.section.element, this.toolbar.element, this.card.element);
    const { components, robots, site } = film.header;
    const note = 'This plan has no site, no components and no machines: there is nothing to see here yet.';
    if (components.length + robots.length + site.length === 0) host.append(make('p', 'view-note', note));
    this.listen(canvas);
    bindKeys(canvas, {
      nudge: (...by) => { this.ride(-1); this.rig.nudge(...by); this.stage.touch(); },
      fit: () => this.look(null),
      look: (view) => this.look(view),
      machine: () => this.ride(this.riding >= 0 ? -1 : this.robotToRide()),
      toggle: (what) => this.toggle(what),
      section: (by) => this.section.nudge(by),
      drop: () => player.select(null),
    });
    this.setTheme();
    this.rig.resize(Math.max(host.clientWidth, 1), Math.max(host.clientHeight, 1));
    this.stage.resize();
    this.rig.fit(this.model.outline, 'free', false);
    const frame = (now: number) => {
      if (this.rig.fly(now)) this.stage.touch();
      this.stage.frame(now, () => this.update());
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  /**
   * For tests: the pose in {W} (rows) of every body as `robot.body`, every tool as `robot.tool` and every component, at the
   * moment shown.
   */
  poses(): { bodies: Record<string, PoseRows>; tools: Record<string, PoseRows>; components: Record<string, PoseRows> } {
    this.update();
    const { header } = this.film;
    const bodies: [string, PoseRows][] = [];
    const tools: [string, PoseRows][] = [];
    for (const { robot, mechanism } of this.model.robots) {
      const { name, bodies: parts } = header.robots[robot];
      parts.forEach((body, i) => bodies.push([`${name}.${body.name}`, poseRows(mechanism.bodies[i])]));
      tools.push([name, poseRows(mechanism.tool)]);
    }
    const components = header.components.map(({ name }, i): [string, PoseRows] => [name, poseRows(this.model.poses[i])]);
    return { bodies: Object.fromEntries(bodies), tools: Object.fromEntries(tools), components: Object.fromEntries(components) };
  }

  /** For tests: `waiting`, `carried`, `placed` or `removed` by component at the moment shown. */
  states(): Record<string, string> {
    this.update();
    return Object.fromEntries(this.film.header.components.map(({ name }, i) => [name, this.model.stock.items[i].state]));
  }

  /** For tests and measurements: pictures a second while playing, draw calls and triangles of the last picture. */
  stats(): Stats {
    return this.stage.stats();
  }

  /** For tests: where in the window (CSS pixels) a click picks a component or a robot, null if it is out of sight. */
  whereIs(what: Selection): { x: number; y: number } | null {
    this.update();
    return this.picker.whereIs(what, this.model.boundsOf(this.looks.partsOf(what)));
  }

  private listen(canvas: HTMLCanvasElement): void {
    const { player } = this;
    player.on('time', () => { this.movedOn = true; this.stage.touch(); });
    player.on(['record', 'selection', 'fast'], () => { this.movedOn = this.repainted = true; this.stage.touch(); });
    player.on('selection', () => this.frameSelection());
    player.on('record', () => this.framePair());
    player.on('section', () => { this.section.show(); this.repainted = true; this.stage.touch(); });
    player.on('fast', () => { if (player.fast) this.ride(-1); this.toolbar.setEnabled('machine', !player.fast); });
    this.toolbar.setEnabled('machine', this.film.header.robots.length > 0);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.setTheme());
    new MutationObserver(() => this.setTheme()).observe(document.documentElement, { attributes: true });
    let down = { x: 0, y: 0 };
    canvas.addEventListener('pointerdown', (event) => { down = { x: event.clientX, y: event.clientY }; });
    canvas.addEventListener('click', (event) => {
      if (Math.hypot(event.clientX - down.x, event.clientY - down.y) < 5) this.pick(event);
    });
    canvas.addEventListener('dblclick', (event) => {
      const picked = this.picker.at(event.clientX, event.clientY);
      if (picked) this.flyTo(this.model.boundsOf(this.looks.partsOf(picked)));
    });
    canvas.addEventListener('webglcontextrestored', () => { this.repainted = true; this.stage.touch(); });
  }

  private makeToolbar(): Toolbar {
    const view = (name: ViewName, label: string, key: string) => ({ name: name as 'top' | 'front' | 'side', label,
      title: `Look from ${name === 'top' ? 'above' : `the ${name}`} (${key} in the view)`, press: () => this.look(name) });
    return new Toolbar([
      [{ name: 'fit', label: 'Fit', title: 'Show all (F in the view; W A S D turn, with Shift move, + - bring near)',
        press: () => this.look(null) },
      view('top', 'Top', '1'), view('front', 'Front', '2'), view('side', 'Side', '3'),
      { name: 'machine', label: 'Machine', title: 'Ride on the machine that is picked or at work (4 in the view)', toggle: true,
        press: () => this.ride(this.riding >= 0 ? -1 : this.robotToRide()) }],
      [{ name: 'paths', label: 'Paths', title: 'Ways of the hooks and tools (P in the view)', toggle: true,
        press: () => this.toggle('paths') },
      { name: 'zones', label: 'Zones', title: 'Zones of people (Z in the view)', toggle: true,
        press: () => this.toggle('zones') },
      ...this.workspaceTools(), ...this.searchTools()],
      ...this.stepTools(),
    ]);
  }

  private workspaceTools(): Tool[] {
    return this.film.header.workspaces === undefined ? [] : [{ name: 'workspaces', label: 'Workspaces', toggle: true,
      title: 'What machines would sweep until they stand, what they are foreseen to sweep, and whom that stopped', press: () => this.toggle('workspaces') }];
  }

  private searchTools(): Tool[] {
    return this.film.graphs.length === 0 ? [] : [{ name: 'search', label: 'Search', toggle: true,
      title: 'What guides searched through before they found a way', press: () => this.toggle('search') }];
  }

  /** Of the ways over areas: a button for each step of the method. */
  private stepTools(): Tool[][] {
    const tools = Floors.stepsOf(this.film).map((step) => ({
      name: step, label: step[0].toUpperCase() + step.slice(1), title: stepTitles[step], toggle: true, press: () => this.toggleStep(step),
    }));
    return tools.length > 0 ? [tools] : [];
  }

  private toggleStep(step: FloorStep): void {
    if (!this.steps.delete(step)) this.steps.add(step);
    this.toolbar.setPressed(step, this.steps.has(step));
    this.repainted = true;
    this.stage.touch();
  }

  private setTheme(): void {
    this.theme = themeOf(this.stage.canvas);
    setLight(this.light, this.theme);
    this.looks.setTheme(this.theme);
    this.labels.setTheme(this.theme);
    this.stage.setTheme(this.theme);
    this.repainted = true;
    this.stage.touch();
    for (const what of ['paths', 'zones', 'workspaces', 'search'] as const) this.toolbar.setPressed(what, this.shows[what]);
  }

  /** Brings what is drawn to what the player shows. */
  private update(): void {
    const { model, player, film, looks } = this;
    if (this.movedOn || this.repainted) {
      const tried = player.triedRun;
      const changed = model.move(player.time, tried);
      if (this.repainted) looks.all();
      else {
        for (const component of [...changed, ...model.loaded]) looks.component(component);
        model.movingPoses.forEach((_, i) => looks.moving(i));
      }
      if (this.repainted || changed.size > 0) this.stage.touchStill();
      const { record } = player;
      const met = record !== null && film.kind(record) === 'try' ? film.text(record, 'try.met') : '';
      const running = this.activity.running(player.time, tried);
      const machines = !player.fast;
      this.overlay.show(running, this.shows.zones, met, this.theme);
      model.moving.visible = machines;
      this.ropes.show(this.theme);
      this.lanes.show(this.theme);
      this.joints.show(this.theme);
      this.floors.show(this.steps, this.theme);
      const ways = machines && this.shows.paths ? running : [];
      this.graphs.show(running, machines && this.shows.search, player.time, this.theme);
      this.foreseen.show(running, machines && this.shows.workspaces, player.time, this.theme);
      this.workspaces.show(machines && this.shows.workspaces && tried < 0, player.time, (robot) => looks.machineColour(robot), this.theme);
      this.walks.show(ways, tried, player.time, this.theme);
      // Where a guide walked, the way of the vehicle stands for that of its tool.
      this.paths.show(ways.filter((run) => !this.walks.has(run)), tried, player.time, (robot) => looks.machineColour(robot),
                      this.theme.dark);
      if (!machines) this.ropes.strokes.mesh.visible = false;
      const cut = player.section;
      this.light.section.value = cut ?? 1e9;
      for (const batch of model.batches) batch.setCut(cut !== null);
      this.overlay.setCut(cut !== null);
      this.card.show();
      this.movedOn = this.repainted = false;
    }
    if (this.riding >= 0) {
      const { mechanism, first } = model.robots[this.riding];
      const robot = film.header.robots[this.riding];
      const { eye, at } = cabOf(mechanism, (body) => model.machineBounds[first + body],
                                (body) => robot.parameters.some((parameter) => parameter.body === robot.bodies[body].name));
      this.rig.ride(eye, at);
    }
  }

  private look(view: ViewName | null): void {
    this.ride(-1);
    this.rig.fit(this.model.outline, view);
    this.stage.touch();
  }

  private flyTo(box: Box3): void {
    if (box.isEmpty()) return;
    this.ride(-1);
    this.rig.fit(cornersOf(box.expandByScalar(roomAround)));
    this.stage.touch();
  }

  private pick(event: MouseEvent): void {
    this.picking = true;
    this.player.select(this.picker.at(event.clientX, event.clientY));
    this.picking = false;
  }

  /** What is picked elsewhere in the page comes into the picture: of a run its component on its way from here to its goal. */
  private frameSelection(): void {
    const { selection } = this.player;
    if (this.picking || !selection || this.riding >= 0) return;
    if (selection.kind !== 'run') {
      const box = this.model.boundsOf(this.looks.partsOf(selection));
      if (this.picker.pointsOf(box, 0.5).length < 12) this.flyTo(box);
      return;
    }
    const parts = this.looks.selectedParts().filter((part) => part.batch === 'component');
    const box = this.model.boundsOf(parts.length > 0 ? parts : this.looks.selectedParts());
    const task = this.film.header.tasks.find(({ name }) => name === this.film.runs[selection.index].task);
    for (const { element } of parts) if (task?.to) expandBy(box, this.model.componentBounds[element], poseMatrix(task.to));
    this.flyTo(box);
  }

  /** The pair of a refused step comes into the picture if it is small or out of sight, or the task was picked just now. */
  private framePair(): void {
    const { moved, met } = this.looks.pairParts();
    if (moved.length + met.length === 0 || this.riding >= 0) return;
    const flying = this.rig.flying;
    this.update();
    const box = this.model.boundsOf([...moved, ...met]);
    if (flying || this.picker.sizeOf(box) < leastPair) this.flyTo(box);
  }

  private ride(robot: number): void {
    if (robot === this.riding) return;
    this.riding = robot;
    if (robot < 0) this.rig.leave();
    this.toolbar.setPressed('machine', robot >= 0);
    this.stage.touch();
  }

  /** The machine that is picked, else one at work, else the first. */
  private robotToRide(): number {
    const { player, film } = this;
    const { selection } = player;
    if (film.header.robots.length === 0 || player.fast) return -1;
    if (selection?.kind === 'robot') return selection.index;
    if (selection?.kind === 'run' && film.runs[selection.index].robot >= 0) return film.runs[selection.index].robot;
    const robots = this.activity.running(player.time, player.triedRun).map((run) => film.runs[run].robot);
    return robots.find((robot) => robot >= 0) ?? 0;
  }

  private toggle(what: keyof typeof this.shows): void {
    this.shows[what] = !this.shows[what];
    this.toolbar.setPressed(what, this.shows[what]);
    this.repainted = true;
    this.stage.touch();
  }
}
