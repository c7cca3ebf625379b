import { decimal, duration, number } from '../clock';
import type { FlowData, Stock } from '../header';
import { make, named } from './dom';

/** Longer lists are cut: `rubicon flow` has them whole. */
const mostListed = 300;
const chartWidth = 110;
const chartHeight = 28;

/** So many of something from `t` on. */
export type Level = Pick<Stock, 't' | 'count'> & Partial<Stock>;

/** The stock over time as a stepped line, from the bottom (0) to the top (`most`) of the chart. */
export function stockPath(stock: Level[], end: number, most: number): string {
  const x = (t: number) => number((chartWidth * Math.min(t, end)) / Math.max(end, 1e-9), 2);
  const y = (count: number) => number(chartHeight - 1 - ((chartHeight - 2) * count) / Math.max(most, 1), 2);
  let path = '';
  for (const { t, count } of stock) path += path === '' ? `M${x(t)} ${y(count)}` : `H${x(t)}V${y(count)}`;
  return `${path}H${chartWidth}`;
}

export function chartOf(stock: Level[], end: number, most: number): SVGSVGElement {
  const space = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(space, 'svg');
  svg.setAttribute('viewBox', `0 0 ${chartWidth} ${chartHeight}`);
  svg.setAttribute('class', 'stock');
  svg.setAttribute('role', 'img');
  svg.setAttribute('aria-label', `${stock[0]?.count ?? 0} at the start, at most ${most}, ${stock.at(-1)?.count ?? 0} at the end`);
  const line = document.createElementNS(space, 'path');
  line.setAttribute('d', stockPath(stock, end, most));
  svg.append(line);
  return svg;
}

function head(...names: string[]): HTMLElement {
  return make('thead', {}, make('tr', {}, ...names.map((name) => make('th', { scope: 'col' }, name))));
}

function row(name: string, ...cells: (Node | string)[]): HTMLElement {
  return make('tr', {}, make('th', { scope: 'row' }, named(name, 100)), ...cells.map((cell) => make('td', {}, cell)));
}

/** Lifts, ways and waits of components, and the stock of storage places. */
export function materialOf(flow: FlowData): HTMLElement[] {
  const lifted = flow.components.filter((component) => component.lifts > 0 || component.removed);
  if (lifted.length === 0) return [];
  const parts: HTMLElement[] = [make('h2', {}, 'Material')];
  if (flow.storages.length > 0) {
    const body = make('tbody');
    for (const { name, stock, in: came, out, mean_stay: stay } of flow.storages) {
      const most = stock.reduce((greatest, { count }) => Math.max(greatest, count), 0);
      body.append(row(name, chartOf(stock, flow.end, most), String(most), String(came), String(out), String(stock.at(-1)?.count ?? 0),
        stay === null ? '' : duration(stay)));
    }
    parts.push(make('table', {}, head('Storage', 'Stock', 'Most', 'In', 'Out', 'At end', 'Mean stay'), body));
  }
  const places = flow.storages.length > 0;
  const body = make('tbody');
  for (const each of lifted.slice(0, mostListed)) {
    body.append(row(each.name, ...(places ? [named(each.from, 40)] : []), String(each.lifts), duration(each.waited), duration(each.carried),
      decimal(each.distance, 1), String(each.refused)));
  }
  const table = make('table', {}, head('Component', ...(places ? ['From'] : []), 'Lifts', 'Waited', 'Carried', 'Metres', 'Refused'), body);
  const more = lifted.length - mostListed;
  parts.push(make('details', {}, make('summary', {}, `${lifted.length} ${lifted.length === 1 ? 'component' : 'components'} moved`),
    make('p', { class: 'muted' }, 'Waited: it lay before a lift. Carried: it hung on a machine, and so far it came. Refused: steps with it.'),
    table, ...(more > 0 ? [make('p', { class: 'muted' }, `and ${more} more`)] : [])));
  return parts;
}
