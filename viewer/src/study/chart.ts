import { steps } from '../ticks';

/** A drawing of SVG with axes. Its looks are classes of study.css: the page's policy refuses styles of elements. */
const SPACE = 'http://www.w3.org/2000/svg';

export type Attributes = Record<string, string | number>;

export function draw(tag: string, attributes: Attributes = {}, ...children: (Node | string)[]): SVGElement {
  const element = document.createElementNS(SPACE, tag);
  for (const [key, value] of Object.entries(attributes)) {
    element.setAttribute(key, typeof value === 'number' ? String(Math.round(value * 100) / 100) : value);
  }
  element.append(...children);
  return element;
}

/** Round steps of an axis: 1, 2 or 5 of a power of ten; of seconds: of minutes, hours, days. */
export function step(span: number, most: number, seconds: boolean): number {
  const rough = span / most;
  const found = seconds && rough >= 1 ? steps.find((each) => each >= rough) : undefined;
  if (found) return found;
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((each) => each * power).find((each) => each >= rough * (1 - 1e-9)) ?? 10 * power;
}

export function ticks(low: number, high: number, most: number, seconds: boolean): number[] {
  if (!(high > low)) return [low];
  const by = step(high - low, most, seconds);
  const result: number[] = [];
  for (let i = Math.ceil(low / by - 1e-9) + 0; i * by <= high + by * 1e-9; ++i) result.push(i * by);
  return result;
}

/** A time on an axis: days, hours or minutes, by the step. */
export function axisTime(seconds: number, by: number): string {
  if (by >= 86400) return `${Math.round(seconds / 8640) / 10} d`;
  if (by >= 1800) return `${Math.round(seconds / 360) / 10} h`;
  if (by >= 60) return `${Math.round(seconds / 6) / 10} min`;
  return `${Math.round(seconds * 100) / 100} s`;
}

export interface Axis { low: number; high: number; label: string; text: (value: number, by: number) => string; seconds: boolean }

export interface Chart { svg: SVGElement; x: (value: number) => number; y: (value: number) => number; right: number; bottom: number }

/** An empty chart with its axes; x and y take values to places in it. */
export function chart(width: number, height: number, horizontal: Axis, vertical: Axis, name: string): Chart {
  const left = 74;
  const right = width - 14;
  const top = 12;
  const bottom = height - 40;
  const place = (axis: Axis, from: number, to: number) => (value: number) =>
    (axis.high > axis.low ? from + (value - axis.low) / (axis.high - axis.low) * (to - from) : (from + to) / 2);
  const x = place(horizontal, left, right);
  const y = place(vertical, bottom, top);
  const svg = draw('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': name, class: 'chart' });
  const down = step(horizontal.high - horizontal.low || 1, 6, horizontal.seconds);
  for (const each of ticks(horizontal.low, horizontal.high, 6, horizontal.seconds)) {
    svg.append(draw('line', { x1: x(each), x2: x(each), y1: top, y2: bottom, class: 'grid' }),
      draw('text', { x: x(each), y: bottom + 15, class: 'tick middle' }, horizontal.text(each, down)));
  }
  const across = step(vertical.high - vertical.low || 1, 5, vertical.seconds);
  for (const each of ticks(vertical.low, vertical.high, 5, vertical.seconds)) {
    svg.append(draw('line', { x1: left, x2: right, y1: y(each), y2: y(each), class: 'grid' }),
      draw('text', { x: left - 6, y: y(each) + 4, class: 'tick end' }, vertical.text(each, across)));
  }
  svg.append(draw('line', { x1: left, x2: right, y1: bottom, y2: bottom, class: 'axis' }),
    draw('line', { x1: left, x2: left, y1: top, y2: bottom, class: 'axis' }),
    draw('text', { x: (left + right) / 2, y: height - 6, class: 'label middle' }, horizontal.label),
    draw('text', { x: 12, y: (top + bottom) / 2, class: 'label middle', transform: `rotate(-90 12 ${(top + bottom) / 2})` }, vertical.label));
  return { svg, x, y, right, bottom };
}

/** A little room on both sides. */
export function padded(values: number[], share = 0.06): { low: number; high: number } {
  const low = Math.min(...values);
  const high = Math.max(...values);
  const room = high > low ? (high - low) * share : Math.abs(high) * share || 1;
  return { low: Math.max(low - room, low >= 0 ? 0 : -Infinity), high: high + room };
}

export function path(points: [number, number][]): string {
  return points.map(([x, y], i) => `${i ? 'L' : 'M'}${Math.round(x * 100) / 100} ${Math.round(y * 100) / 100}`).join('');
}
