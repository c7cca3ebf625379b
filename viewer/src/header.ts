// The header of a trace as docs/trace.md describes it, and schedule.json as docs/commands/run.md does: what the page reads of them.
// Lengths in metres, angles in degrees, times in seconds from the beginning of the plan.

/** The upper three rows of a 4 x 4 matrix, row by row. */
export type PoseRows = number[];

export interface ShapeData {
  type: 'box' | 'cylinder' | 'sphere' | 'capsule' | 'prism' | 'mesh';
  pose: PoseRows;
  lower?: number[];
  upper?: number[];
  centre?: number[];
  a?: number[];
  b?: number[];
  radius?: number;
  z0?: number;
  z1?: number;
  polygon?: [number, number][];
  /** Number in `meshes`. */
  mesh?: number;
}

export interface Parameter {
  name: string;
  body: string;
  kind: 'translation' | 'rotation';
  cyclic: boolean;
  lower: number | null;
  upper: number | null;
  step: number;
  speed: number;
  start: number;
  /** The formula by which it follows others. */
  derived?: string;
}

/** From a point of the body `from` to a point of the parent of the body that is the rope, each in its own frame (m). */
export interface RopeData {
  radius: number;
  from: string;
  p_from: number[];
  p_to: number[];
}

export interface RobotData {
  name: string;
  type: string;
  pose: PoseRows;
  start: Record<string, number>;
  calendar: string;
  /** `buffer`: so far (m) a body keeps from what is not of its machine. */
  bodies: { name: string; parent: string | null; frame: string; shapes: ShapeData[]; buffer?: number; rope?: RopeData }[];
  parameters: Parameter[];
  tool: { body: string; frame: string };
  /** Pairs of bodies that may meet. */
  touching: [string, string][];
  capacity: [number, number][];
}

export interface ComponentData {
  name: string;
  pose: PoseRows;
  grip: PoseRows;
  mass: number;
  shapes: ShapeData[];
  /** What it is fixed to, and for each the task that must be done first ("": none). */
  fixed_to?: string[];
  fixed_after?: string[];
  braced_by?: string[];
  /** Who braces it by hand. */
  braced_by_crews?: string[];
  /** What the client says of it, by name: `storey`, `fire`; `name` is the client's own. */
  attributes?: Record<string, string>;
}

export interface CalendarData {
  name: string;
  shifts: { days: [number, number]; minutes: [number, number][] }[];
  off: string[];
  carry_over: boolean;
}

export interface TaskData {
  name: string;
  robot: string;
  crews: string[];
  move?: string;
  to?: PoseRows;
  /** Where its tool goes; by values of parameters where there is no pose. */
  go?: { pose?: PoseRows };
  /** Of a task that digs in an earth: the component that it takes away. */
  dig?: { soil?: string };
  choices?: { dig?: { soil?: string } }[];
  /** Of a task whose robot digs: the cells of its pit (heights in mm). */
  motion_dig?: { soil: string; pose: PoseRows; columns: number; cell: number; cells: number[]; before: number[]; after: number[] };
  /** Of a task that covers an area: how (docs/trace.md). */
  cover?: CoverData;
  zones: ShapeData[];
  after: { task: string; type: string; lag: number }[];
  attributes?: Record<string, string>;
}

/** An area that a tool works over, and how its way was found; places are x and y in turn, in the frame of the area (m). */
export interface CoverData {
  area: string;
  pose: PoseRows;
  floor: { outline: number[]; shafts: number[][]; columns: [x: number, y: number, size: number, round: boolean][] };
  /** Of holes there are none. */
  steps?: {
    nodes: number[];
    /** From node, to node, whether it is an edge of the floor, whether columns obstruct it. */
    pieces: [number, number, boolean, boolean][];
    cells: number[][];
    /** Of which two cells, from where to where, whether columns obstruct it. */
    doors: [number, number, number, number, number, number, boolean][];
    order: number[];
    lines: { cell: number; pass: boolean; points: number[] }[];
  };
}

/** What moves by a timetable: its frame at times (s). With people `overhead`, where no load may hang. */
export interface MovingData {
  name: string;
  path: { t: number; pose: PoseRows }[];
  repeat: boolean;
  shapes: ShapeData[];
  overhead?: ShapeData[];
}

/** Nodes and lanes between them, by their numbers. */
export interface NetworkData {
  name: string;
  classes: { name: string; speed: number; width: number }[];
  nodes: { name: string; pose: PoseRows }[];
  lanes: { from: number; to: number; class: number; length?: number }[];
}

export interface Header {
  plan: string;
  path: string;
  form: 'short' | 'full';
  detail: 'steps' | 'tasks' | 'none';
  start_at: string | null;
  currency: string;
  calendars: CalendarData[];
  files: { path: string; text: string }[];
  site: ShapeData[];
  /** Whose they are, "" for those of the site itself. */
  site_names?: string[];
  movings?: MovingData[];
  /** The ground on which trucks tip, cell by cell (mm). */
  heaps?: { component: string; pose: PoseRows; columns: number; cell: number; ground: number[] }[];
  networks?: NetworkData[];
  /** Machines that keep their dynamic workspaces apart, in their order. */
  workspaces?: { of: string[]; reaction: number; braking: number; turn_braking: number; foreseen?: number; watch?: boolean };
  /** `friction` only where forces must balance. */
  support?: { mode: 'on' | 'warn' | 'off'; gap: number; friction?: number; floating?: string[] };
  components: ComponentData[];
  robots: RobotData[];
  carry: ShapeData[];
  crews: { name: string; size: number; cost_per_hour: number | null; calendar: string }[];
  tasks: TaskData[];
  /** In the film the numbers of a mesh stand in columns; these are their names. */
  meshes: { closed: boolean; vertices: string; triangles: string }[];
}

export interface Waited {
  predecessor: number;
  resource: number;
  machine: number;
  shift: number;
  /** Where machines break down. */
  repair?: number;
}

export interface ScheduledTask {
  task: string;
  robot: string;
  crew: string;
  start: number;
  duration: number;
  begins?: string;
  ends?: string;
  motion: number;
  work: number;
  waited: Waited;
  cost?: number;
  tried: number;
  accepted: number;
  result: 'done' | 'short' | 'rejected' | 'not reached';
  reason: string;
  /** Of a task that is done: how much later it could be done, s. */
  float?: { total: number; free: number };
  due?: number;
  /** So much after `due`; 0 if it is in time. */
  late?: number;
  /** What does not stand, where the plan only warns of it. */
  support?: string[];
  /** Waypoints that its motions left without reaching them. */
  missed?: string[];
  dig?: DigData;
  motion_dig?: MotionDigData;
}

/** What a robot dug bucket by bucket (m3 of bank volume), and the parts of a cycle on average (s). */
export interface MotionDigData {
  dug: number;
  buckets: number;
  working: number;
  per_hour: number;
  cost_per_m3?: number;
  fuel_per_m3?: number;
  loads?: number;
  waited?: number;
  mean: { cycle: number; to_the_cut: number; cut: number; swing: number; dump: number };
}

/** What a task dug (m3 of bank volume), and the queues of its trucks (s). */
export interface DigData {
  volume: number;
  tipped: number;
  loads: number;
  working: number;
  per_hour: number;
  cost_per_m3?: number;
  fuel_per_m3?: number;
  trucks: number;
  match_factor: number;
  queues: { stage: string; by: string; servers: number; served: number; mean_wait: number; longest_wait: number; mean_length: number; utilisation: number }[];
}

/** So many components lie in a storage place from `t` on. */
export interface Stock {
  t: number;
  count: number;
  mass: number;
}

/** What `rubicon flow --format json` tells. */
export interface FlowData {
  end: number;
  components: { name: string; from: string; to: string; removed: boolean; lifts: number; waited: number; carried: number;
    distance: number; refused: number }[];
  storages: { name: string; in: number; out: number; mean_stay: number | null; stock: Stock[] }[];
  /** Of a plan with fleets: what vehicles did, and where and when they stood for other machines. */
  lanes?: LaneFlow;
}

export interface LaneFlow {
  vehicles: { name: string; fleet: string; tasks: number; held: number; moving: number; waits: number; waited: number; distance: number }[];
  nodes: { network: string; node: string; waits: number; waited: number; longest: number; most: number }[];
  queues: { network: string; lengths: { t: number; count: number }[] }[];
}

export interface ResourceData {
  name: string;
  kind: 'robot' | 'crew';
  tasks: number;
  held: number;
  busy: number;
  shifts: number;
  utilisation: number;
  cost_per_hour?: number | null;
  cost?: number;
  /** l */
  fuel?: number;
}

export interface ScheduleData {
  tasks: ScheduledTask[];
  process_time: number;
  start_at?: string;
  ends?: string;
  cost?: number;
  currency?: string;
  /** What the money goes for, in the order of the command's table; where the plan says more than rates. */
  cost_by_kind?: Record<string, number>;
  /** l */
  fuel?: number;
  resources: ResourceData[];
  critical: { task: string; work_counts: boolean; text: string }[];
  timetables?: { name: string; stops: number; late: number; stands_before: string }[];
  /** Durations that are not certain; drawn by `sample`, else they stand for their means. */
  uncertain?: number;
  sample?: { seed: number; run: number };
  /** What the weather took, of calendars that lose days. */
  lost_days?: { calendar: string; working_days: number; lost: number; dates: string[] }[];
  /** Machines that broke down, where any do. */
  breakdowns?: { robot: string; during: string; worked: number; repair: number; from: number; to: number }[];
}
