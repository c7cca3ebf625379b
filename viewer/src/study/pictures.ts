/** The pictures of a study: time against cost, how sure the time is, progress, what drives it. */
import { axisTime, chart, draw, padded, path, type Axis } from './chart';
import { clock, COST, MAKESPAN, moment, settings, shown, type Study, type Variant } from './data';

const WIDTH = 560;
const HEIGHT = 300;
/** Of points in the same place: so near are they, and so many are named. */
const near = 8;
const mostNames = 6;

function timeAxis(values: number[], label: string): Axis {
  return { ...padded(values), label, text: axisTime, seconds: true };
}

const quantile = (variant: Variant, question: number, p: number) =>
  variant.answers?.[question]?.quantiles?.find((each) => each.p === p)?.value ?? undefined;

/** What stands at each point, in the order in which they are drawn: of those that lie on each other the uppermost names all. */
export function namesOf(points: { name: number; x: number; y: number }[]): string[] {
  return points.map(({ x, y }, i) => {
    const here = points.flatMap((other, k) => (Math.hypot(other.x - x, other.y - y) < near ? [k] : []));
    if (here[here.length - 1] !== i) return '';
    const names = here.map((k) => points[k].name).sort((a, b) => a - b);
    return names.slice(0, mostNames).join(', ') + (names.length > mostNames ? ', …' : '');
  });
}

/** Every variant as a point: mean process time and cost, with bars from P10 to P95; null without costs. */
export function paretoPicture(study: Study, selected: Variant, select: (variant: Variant) => void): SVGElement | null {
  const points = study.variants.filter((each) => each.answers?.[MAKESPAN]?.mean !== undefined && each.answers[COST]?.mean !== undefined);
  if (points.length < 2) return null;
  const mean = (variant: Variant, question: number) => variant.answers![question].mean!;
  const bars = study.sampled && points.length <= 30;
  const reach = (question: number) => points.flatMap((each) => {
    const all = bars ? [quantile(each, question, 0.1), quantile(each, question, 0.95)] : [];
    return [mean(each, question), ...all.filter((value): value is number => typeof value === 'number')];
  });
  const currency = points[0].currency ?? '';
  const { svg, x, y } = chart(WIDTH, HEIGHT, timeAxis(reach(MAKESPAN), 'process time'),
    { ...padded(reach(COST)), label: currency ? `cost, ${currency}` : 'cost', text: (value) => value.toLocaleString('en'), seconds: false },
    'Process time against cost of each variant');
  const front = study.pareto.map((number) => study.variants[number - 1]);
  if (front.length > 1) {
    svg.append(draw('path', { d: path(front.map((each) => [x(mean(each, MAKESPAN)), y(mean(each, COST))])), class: 'front' }));
  }
  // What matters most is drawn last, over the others.
  const rank = (each: Variant) => (each === selected ? 2 : study.pareto.includes(each.variant) ? 1 : 0);
  const order = [...points].sort((a, b) => rank(a) - rank(b));
  const names = namesOf(order.map((each) => ({ name: each.variant, x: x(mean(each, MAKESPAN)), y: y(mean(each, COST)) })));
  for (const [i, each] of order.entries()) {
    const [px, py] = [x(mean(each, MAKESPAN)), y(mean(each, COST))];
    const group = draw('g', { class: 'point', tabindex: '0', role: 'button', 'aria-label': `variant ${each.variant}: ${settings(each)}` });
    const ends = [quantile(each, MAKESPAN, 0.1), quantile(each, MAKESPAN, 0.95), quantile(each, COST, 0.1), quantile(each, COST, 0.95)];
    if (bars && ends.every((value) => value !== undefined)) {
      group.append(draw('line', { x1: x(ends[0]!), x2: x(ends[1]!), y1: py, y2: py, class: 'spread' }),
        draw('line', { x1: px, x2: px, y1: y(ends[2]!), y2: y(ends[3]!), class: 'spread' }));
    }
    const kind = each === selected ? 'chosen' : study.pareto.includes(each.variant) ? 'best' : each.unfinished ? 'failing' : 'other';
    group.append(draw('circle', { cx: px, cy: py, r: points.length > 200 ? 3 : 6, class: kind }),
      draw('title', {}, `variant ${each.variant}: ${settings(each)}\n${clock(mean(each, MAKESPAN))}, ${shown('money', mean(each, COST), each)} ${currency}`));
    const right = px > WIDTH - 80;
    if (points.length <= 30) group.append(draw('text', { x: right ? px - 9 : px + 9, y: py - 7, class: right ? 'tick end' : 'tick' }, names[i]));
    group.addEventListener('click', () => select(each));
    group.addEventListener('keydown', (event) => {
      if ((event as KeyboardEvent).key === 'Enter') select(each);
    });
    svg.append(group);
  }
  return svg;
}

/** The share of runs by process time, and how many are done by then. */
export function sureness(study: Study, variant: Variant): SVGElement | null {
  const counts = variant.histogram ?? [];
  const total = variant.runs ?? 0;
  if (!study.sampled || !counts.length || !total) return null;
  const most = Math.max(...counts) / total;
  const { least, most: high } = variant.answers![MAKESPAN];
  const low = least!;
  const edge = (i: number) => low + (high! - low) * i / counts.length;
  const { svg, x, y, bottom } = chart(WIDTH, HEIGHT, { low, high: high!, label: 'process time', text: axisTime, seconds: true },
    { low: 0, high: 1, label: 'share of runs done by then', text: (value) => `${Math.round(100 * value)} %`, seconds: false },
    'How sure the process time is');
  const line: [number, number][] = [[x(low), y(0)]];
  let done = 0;
  counts.forEach((count, i) => {
    const [from, to] = [x(edge(i)), x(edge(i + 1))];
    const height = (bottom - y(1)) * 0.6 * (count / total) / most;
    if (count) {
      svg.append(draw('rect', { x: from + 0.5, y: bottom - height, width: Math.max(to - from - 1, 0.5), height, class: 'bin' },
        draw('title', {}, `${clock(edge(i))} to ${clock(edge(i + 1))}: ${count} of ${total} runs`)));
    }
    done += count;
    line.push([to, y(done / total)]);
  });
  svg.append(draw('path', { d: path(line), class: 'curve' }));
  for (const each of variant.answers?.[MAKESPAN].quantiles ?? []) {
    if (each.value === null) continue;
    const place = x(each.value);
    svg.append(draw('line', { x1: place, x2: place, y1: y(each.p), y2: bottom, class: 'mark' }),
      draw('circle', { cx: place, cy: y(each.p), r: 3, class: 'mark' },
        draw('title', {}, `P${Math.round(100 * each.p)}: ${clock(each.value)}`)),
      draw('text', { x: place - 5, y: y(each.p) - 5, class: 'tick end' }, `P${Math.round(100 * each.p)}`));
  }
  return svg;
}

/** When which share of the cost (or of the tasks) is done: P10 to P90 as a band, the median as a line. */
export function progressPicture(variant: Variant): SVGElement | null {
  const band = variant.progress;
  if (!band) return null;
  const share = (i: number) => i / (band.p50.length - 1);
  const { svg, x, y } = chart(WIDTH, HEIGHT, { ...padded([0, ...band.p90], 0), label: 'time from the beginning', text: axisTime, seconds: true },
    { low: 0, high: 1, label: variant.answers?.[COST]?.mean === undefined ? 'tasks done' : 'cost of tasks done', text: (value) => `${Math.round(100 * value)} %`, seconds: false },
    'Progress over time');
  const early = band.p10.map((time, i): [number, number] => [x(time), y(share(i))]);
  const late = band.p90.map((time, i): [number, number] => [x(time), y(share(i))]);
  svg.append(draw('path', { d: `${path([...early, ...late.reverse()])}Z`, class: 'band' }),
    draw('path', { d: path(band.p50.map((time, i) => [x(time), y(share(i))])), class: 'curve' }));
  return svg;
}

/** Horizontal bars with a name each. */
function bars(name: string, rows: { name: string; from: number; to: number; text: string; hint: string; kind: string }[], low: number, high: number,
  middle?: number): SVGElement {
  const height = 22;
  const left = 190;
  const right = WIDTH - 96;
  const svg = draw('svg', { viewBox: `0 0 ${WIDTH} ${rows.length * height + 8}`, role: 'img', 'aria-label': name, class: 'chart' });
  const x = (value: number) => (high > low ? left + (value - low) / (high - low) * (right - left) : left);
  rows.forEach((row, i) => {
    const top = i * height + 4;
    const label = row.name.length > 28 ? `${row.name.slice(0, 27)}…` : row.name;
    svg.append(draw('g', {}, draw('title', {}, row.hint),
      draw('text', { x: left - 8, y: top + 14, class: 'tick end' }, label),
      draw('rect', { x: Math.min(x(row.from), x(row.to)), y: top + 3, width: Math.max(Math.abs(x(row.to) - x(row.from)), 1), height: height - 8, class: row.kind }),
      draw('text', { x: right + 8, y: top + 14, class: 'tick' }, row.text)));
  });
  if (middle !== undefined) {
    svg.append(draw('line', { x1: x(middle), x2: x(middle), y1: 2, y2: rows.length * height + 6, class: 'mark' }));
  }
  return svg;
}

/** The mean time where each duration was in its lowest and in its highest tenth, the widest first. */
export function tornado(variant: Variant): SVGElement | null {
  const mean = variant.answers?.[MAKESPAN]?.mean;
  const drivers = (variant.drivers ?? []).filter((each) => each.low !== undefined && each.high !== undefined)
    .sort((a, b) => Math.abs(b.high! - b.low!) - Math.abs(a.high! - a.low!)).slice(0, 12);
  if (!drivers.length || mean === undefined) return null;
  const ends = drivers.flatMap((each) => [each.low!, each.high!]);
  return bars('What drives the process time', drivers.map((each) => ({
    name: each.duration, from: each.low!, to: each.high!, text: clock(each.high! - each.low!),
    hint: `${each.duration}: mean ${clock(each.low!)} where it was short, ${clock(each.high!)} where it was long; rank correlation ${each.correlation.toFixed(2)}`,
    kind: 'driver',
  })), Math.min(mean, ...ends), Math.max(mean, ...ends), mean);
}

/** In which share of the runs a task is on the critical path. */
export function criticality(variant: Variant): SVGElement | null {
  const finished = (variant.runs ?? 0) - (variant.unfinished ?? 0);
  const tasks = (variant.critical ?? []).slice(0, 12);
  if (!tasks.length || !finished) return null;
  return bars('Critical tasks', tasks.map((each) => ({
    name: each.task, from: 0, to: each.runs / finished, text: `${(100 * each.runs / finished).toFixed(1)} %`,
    hint: `${each.task}: critical in ${each.runs} of ${finished} runs`, kind: 'critical',
  })), 0, 1);
}

/** "2026-03-04 17:47" where the plan has dates, else a time. */
export function finishText(variant: Variant, seconds: number): string {
  return variant.start_at ? moment(variant.start_at, seconds) : clock(seconds);
}
