import { behaviourAt, isRefusal, type BehaviourState } from '../behaviour';
import { number } from '../clock';
import { refusal, sentence } from '../sentences';
import type { Trail } from '../trail';
import { cut, make, named } from './dom';
import type { Page } from './page';

interface Change {
  name: string;
  unit: string;
  before: number;
  after: number;
}

/** How a behaviour stands at a position of a trail: what was done, configuration before and after, variables, open loops. */
export function showState(host: HTMLElement, page: Page, trail: Trail, at: number): void {
  if (at < 0) {
    host.replaceChildren();
    return;
  }
  const record = trail.records[at];
  const changes = changesAt(page, trail, at);
  const state = behaviourAt(page.film, trail.run, at);
  const words = make('bdi', {}, cut(saying(page, record, changes), 500));
  const said = make('div', { class: `said ${isRefusal(page.film, record) ? 'bad' : ''}` }, words);
  const hasScript = trail.hasSteps();
  host.replaceChildren(said, ...pairOf(page, record), make('div', { class: 'pairs' },
    ...(changes.length > 0 ? [configuration(changes)] : []),
    ...(hasScript ? [make('div', {}, variables(state), loops(state))] : [])));
}

/** What moved and what it met, with the colours that they have in the view. */
function pairOf({ film }: Page, record: number): HTMLElement[] {
  if (film.kind(record) !== 'try' || film.text(record, 'try.met') === '') return [];
  const entry = (kind: string, column: string) =>
    make('span', { class: kind }, `${kind} `, named(film.text(record, column), 80));
  return [make('div', { class: 'pair' }, entry('moved', 'try.moved'), entry('met', 'try.met'))];
}

function changesAt({ film, motion }: Page, trail: Trail, at: number): Change[] {
  const robot = film.runs[trail.run].robot;
  const data = film.header.robots[robot];
  if (!data) return [];
  const tried = film.runs[trail.run].happened ? -1 : trail.run;
  const t = film.time(trail.records[at]);
  const kind = film.kind(trail.records[at]);
  const moved = at > 0 && (kind === 'try' || kind === 'wait');
  const after = motion.configuration(robot, t, tried);
  const before = moved ? motion.configuration(robot, film.time(trail.records[at - 1]), tried) : after;
  return data.parameters.map(({ name, kind: moves, cyclic }, i) => {
    const value = cyclic ? wrapped : (each: number) => each;
    return { name, unit: moves === 'rotation' ? '°' : ' m', before: value(before[i]), after: value(after[i]) };
  });
}

/** An angle as scripts see it: in (-180, 180]. */
function wrapped(angle: number): number {
  return angle - 360 * Math.ceil((angle - 180) / 360 - 1e-9);
}

function saying({ film }: Page, record: number, changes: Change[]): string {
  if (film.kind(record) !== 'try') return sentence(film, record);
  const command = film.text(record, 'try.command');
  const steps = film.text(record, 'try.parameter').split(', ').map((name) => {
    const change = changes.find((each) => each.name === name);
    if (!change) return name;
    const stays = number(change.before) === number(change.after);
    return `${name} ${number(change.before)}${stays ? '' : ` → ${number(change.after)}`}${change.unit}`;
  });
  const how = film.number(record, 'try.ok') ? 'accepted' : `refused: ${refusal(film, record)}`;
  return `${command} ${steps.join(', ')}: ${how}`;
}

function head(...names: string[]): HTMLElement {
  return make('thead', {}, make('tr', {}, ...names.map((name) => make('th', { scope: 'col' }, name))));
}

function configuration(changes: Change[]): HTMLElement {
  const box = make('div', {}, make('h3', {}, 'Where the machine stands'));
  const body = make('tbody');
  for (const { name, unit, before, after } of changes) {
    const same = number(before) === number(after);
    body.append(make('tr', same ? {} : { class: 'changed' }, make('td', {}, named(name, 60)), make('td', {}, number(before) + unit),
      make('td', {}, number(after) + unit)));
  }
  box.append(make('table', { class: 'fixed values' }, head('', 'before', 'after'), body));
  return box;
}

function variables(state: BehaviourState): HTMLElement {
  const box = make('div', {}, make('h3', {}, 'Variables'));
  if (state.variables.size === 0) {
    box.append(make('div', { class: 'muted' }, 'none is set'));
    return box;
  }
  const body = make('tbody');
  for (const [name, { value }] of state.variables) {
    const shown = Number.isFinite(Number(value)) ? number(Number(value)) : value;
    body.append(make('tr', {}, make('td', {}, named(name, 60)), make('td', { title: cut(value, 300) }, cut(shown, 60))));
  }
  box.append(make('table', { class: 'fixed' }, body));
  return box;
}

function loops(state: BehaviourState): HTMLElement {
  const box = make('div', {}, make('h3', {}, 'Open loops'));
  if (state.loops.length === 0) {
    box.append(make('div', { class: 'muted' }, 'none'));
    return box;
  }
  const body = make('tbody');
  for (const loop of state.loops) {
    const cells = [named(loop.kind, 60), String(loop.place.line), String(loop.tries), String(loop.accepted)];
    body.append(make('tr', {}, ...cells.map((cell) => make('td', {}, cell))));
  }
  box.append(make('table', { class: 'fixed loops' }, head('', 'line', 'tried', 'accepted'), body));
  return box;
}
