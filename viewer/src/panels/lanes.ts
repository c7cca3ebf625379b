import { decimal, duration, number } from '../clock';
import type { FlowData, LaneFlow, NetworkData } from '../header';
import { make, named } from './dom';
import { chartOf } from './material';

/** Longer lists are cut: `rubicon flow` has them whole. */
const mostListed = 100;
const mostNodes = 25;
const mapWidth = 440;
/** Of the picture, in its own units: kept free about the network, and the radius of the node with the longest waits. */
const margin = 16;
const greatest = 11;

export interface Spot {
  x: number;
  y: number;
  radius: number;
  /** 0: nobody waited; 1: here they waited longest. */
  heat: number;
}

// Not Math.min(...values): a network may have more nodes than a call takes arguments.
const leastOf = (values: number[]) => values.reduce((least, each) => Math.min(least, each));
const greatestOf = (values: number[], first: number) => values.reduce((most, each) => Math.max(most, each), first);

/** The nodes of a network in the plan view, north up, `mapWidth` wide; the area of each spot is as what was waited there. */
export function spotsOf(network: NetworkData, nodes: LaneFlow['nodes']): { spots: Spot[]; height: number } {
  const waited = new Map(nodes.filter((each) => each.network === network.name).map((each) => [each.node, each.waited]));
  const longest = greatestOf([...waited.values()], 0);
  const xs = network.nodes.map(({ pose }) => pose[3]);
  const ys = network.nodes.map(({ pose }) => pose[7]);
  const [west, south] = [leastOf(xs), leastOf(ys)];
  const wide = greatestOf(xs, west) - west;
  const high = greatestOf(ys, south) - south;
  const scale = Math.min((mapWidth - 2 * margin) / Math.max(wide, 1e-9), (mapWidth - 2 * margin) / Math.max(high, 1e-9));
  const left = (mapWidth - wide * scale) / 2;
  const spots = network.nodes.map(({ name }, i) => {
    const heat = longest > 0 ? (waited.get(name) ?? 0) / longest : 0;
    return { x: left + (xs[i] - west) * scale, y: margin + (high - (ys[i] - south)) * scale, radius: 1.5 + (greatest - 1.5) * Math.sqrt(heat), heat };
  });
  return { spots, height: high * scale + 2 * margin };
}

/** Lanes as lines, and on each node a spot: the longer vehicles waited there, the larger and the hotter. */
function mapOf(network: NetworkData, nodes: LaneFlow['nodes']): SVGSVGElement {
  const space = 'http://www.w3.org/2000/svg';
  const { spots, height } = spotsOf(network, nodes);
  const svg = document.createElementNS(space, 'svg');
  svg.setAttribute('viewBox', `0 0 ${mapWidth} ${number(height, 1)}`);
  svg.setAttribute('class', 'waits');
  svg.setAttribute('role', 'img');
  svg.setAttribute('aria-label', `where vehicles waited on ${network.name}`);
  const lines = document.createElementNS(space, 'path');
  lines.setAttribute('d', network.lanes.map(({ from, to }) => `M${number(spots[from].x, 1)} ${number(spots[from].y, 1)}L${number(spots[to].x, 1)} ${number(spots[to].y, 1)}`).join(''));
  svg.append(lines);
  const order = spots.map((_, i) => i).sort((a, b) => spots[a].heat - spots[b].heat || a - b);
  for (const i of order) {
    const { x, y, radius, heat } = spots[i];
    const spot = document.createElementNS(space, 'circle');
    spot.setAttribute('cx', number(x, 1));
    spot.setAttribute('cy', number(y, 1));
    spot.setAttribute('r', number(radius, 1));
    spot.setAttribute('class', heat > 0.5 ? 'hot' : heat > 0 ? 'warm' : 'cold');
    const title = document.createElementNS(space, 'title');
    const found = nodes.find((each) => each.network === network.name && each.node === network.nodes[i].name);
    title.textContent = found ? `${network.nodes[i].name}: ${found.waits} waits, ${duration(found.waited)}` : network.nodes[i].name;
    spot.append(title);
    svg.append(spot);
  }
  return svg;
}

function table(names: string[], rows: [string, ...(Node | string)[]][]): HTMLElement {
  const head = make('thead', {}, make('tr', {}, ...names.map((name) => make('th', { scope: 'col' }, name))));
  const body = make('tbody');
  for (const [name, ...cells] of rows) {
    body.append(make('tr', {}, make('th', { scope: 'row' }, named(name, 100)), ...cells.map((cell) => make('td', {}, cell))));
  }
  return make('table', {}, head, body);
}

function rest(all: number, listed: number): HTMLElement[] {
  return all > listed ? [make('p', { class: 'muted' }, `and ${all - listed} more`)] : [];
}

/** Vehicles of fleets: how much of the time they were held, where they waited for each other, how many at a time. */
export function lanesOf(flow: FlowData, networks: NetworkData[]): HTMLElement[] {
  const { lanes } = flow;
  if (!lanes || lanes.vehicles.length === 0) return [];
  const parts: HTMLElement[] = [make('h2', {}, 'Fleets')];
  parts.push(table(['Vehicle', 'Tasks', 'Held', 'Moved', 'Waits', 'Waited', 'Metres'], lanes.vehicles.slice(0, mostListed).map((each) =>
    [each.name, String(each.tasks), `${number((100 * each.held) / Math.max(flow.end, 1e-9), 0)} %`, duration(each.moving), String(each.waits),
      duration(each.waited), decimal(each.distance, 0)])));
  parts.push(...rest(lanes.vehicles.length, mostListed));
  if (lanes.nodes.length === 0) return [...parts, make('p', { class: 'muted' }, 'No vehicle waited for another machine.')];
  for (const { network: name, lengths } of lanes.queues) {
    const network = networks.find((each) => each.name === name);
    const most = lengths.reduce((longest, { count }) => Math.max(longest, count), 0);
    parts.push(make('h3', {}, `Waits on ${name}`));
    if (network) parts.push(make('div', { class: 'waits' }, mapOf(network, lanes.nodes)));
    parts.push(table(['Waiting at a time', 'Over the plan', 'At most'], [[name, chartOf(lengths, flow.end, most), String(most)]]));
  }
  parts.push(table(['Node', 'Waits', 'Waited', 'Longest', 'At most'], lanes.nodes.slice(0, mostNodes).map((each) =>
    [each.node, String(each.waits), duration(each.waited), duration(each.longest), String(each.most)])), ...rest(lanes.nodes.length, mostNodes));
  return parts;
}
