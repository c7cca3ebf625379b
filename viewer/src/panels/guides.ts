import { number } from '../clock';
import { crossings, graphAt, legsOfGraph, nearPart, variedOf, wayAfter, withinATurn, type Leg, type Section } from '../configurations';
import { rangeOf, rectangles, sampledBy, sliceOf, type Slice } from '../forbidden';
import { chart, draw, padded, path, type Axis, type Chart } from '../study/chart';
import { button, givesBackFocus, make, named, onceAFrame, setText } from './dom';
import { download, fileName } from './download';
import type { Page } from './page';
import type { Shown } from './side';
import { svgFile } from './svg_file';
import { palette } from './theme';

/** Of the picture (px): at least and at most, and its height as a share of its width. */
const narrowest = 340;
const widest = 640;
const upright = 0.85;
/** Of two lengths, which are as long on both axes: at least and at most. */
const flattest = 0.4;
const tallest = 1.3;
/** Of the chart round what it spans (px). */
const margins = { across: 88, up: 52 };
/** A run tells where the robot may not stand of so many searches, the first (docs/trace.md). */
const told = 32;
/** What counts as near the value of the slider: this share of what the parameter runs over, to both sides. */
const nearShare = 0.04;
const steps = 200;

interface Searched {
  at: number;
  legs: Leg[];
  way: Leg[];
  ranges: Map<number, { low: number; high: number }>;
}

/** The configurations that a guide searched through, as two parameters span them, with a slider for a third. */
export function mountGuides(host: HTMLElement, page: Page, shown: Shown): void {
  const { film, motion, player, runs } = page;
  host.classList.add('scrolls', 'guides');
  const title = make('h2');
  const axes = { across: choice('Across'), up: choice('Up'), third: choice('Slider') };
  const slider = make('input', { type: 'range', 'aria-label': 'Value of the third parameter', max: String(steps), step: 'any' });
  const value = make('output');
  const picture = make('div');
  const region = make('p', { class: 'region' });
  const note = make('p', { class: 'muted' }, 'Pale: what the guide searched through; strong what of it is near the value of the slider. Thick: how the machine went, with a ring '
    + 'where it has that value, and a dot where it is now.');
  host.append(title, make('div', { class: 'axes' }, ...Object.values(axes).map(({ label }) => label), make('label', { class: 'field' }, slider, value),
    button('Export SVG', () => exportSvg())), picture, region, note);
  let chosenByHand = false;
  let searched: Searched | null = null;
  let plot: Chart | null = null;
  let painted = 0;
  const widthNow = () => Math.min(Math.max(host.clientWidth - 24, narrowest), widest);
  const now = draw('circle', { r: 5, class: 'now' });

  const grid = () => film.graphs[searched?.at ?? 0].forbidden;
  const parameters = () => film.header.robots[film.runs[film.graphs[searched?.at ?? 0].run].robot].parameters;
  const unitOf = (i: number) => (parameters()[i].kind === 'rotation' ? '°' : ' m');
  const chosen = (): Section => {
    const [across, up, third] = [axes.across, axes.up, axes.third].map(({ select }) => Number(select.value));
    const { low, high } = searched?.ranges.get(third) ?? { low: 0, high: 0 };
    return { across, up, third, value: low + (high - low) * Number(slider.value) / steps, reach: nearShare * (high - low) };
  };

  /** Another search: the parameters whose forbidden cells it tells, else the three that it changed most. */
  const take = (at: number) => {
    const { run } = film.graphs[at];
    const { parameters: all } = film.header.robots[film.runs[run].robot];
    const names = all.map(({ name }) => name);
    const cyclic = all.map((each) => each.cyclic);
    const legs = withinATurn(legsOfGraph(film, at), cyclic);
    const way = withinATurn(wayAfter(film, motion, at), cyclic);
    const varied = variedOf([...legs, ...way].flat(), names.length);
    const before = chosenByHand && searched && film.runs[film.graphs[searched.at].run].robot === film.runs[run].robot;
    searched = { at, legs, way, ranges: new Map(varied.map((each) => [each.parameter, each])) };
    title.replaceChildren(named(film.runs[run].task, 200), ` (${film.graphs[at].legs.toLocaleString('en-GB')} legs searched)`);
    if (before) return;
    const { forbidden } = film.graphs[at];
    const first = forbidden ? sampledBy(forbidden, names).filter((each) => each >= 0) : [];
    const order = [...first, ...varied.map(({ parameter }) => parameter).filter((each) => !first.includes(each))];
    Object.values(axes).forEach(({ select }, i) => {
      select.replaceChildren(...(i === 2 ? [make('option', { value: '-1' }, 'none')] : []), ...names.map((name, p) => make('option', { value: String(p) }, name)));
      select.value = String(order[i] ?? (i === 2 ? -1 : 0));
    });
    // Where the search began, if that is told.
    const { low, high } = searched.ranges.get(order[2] ?? -1) ?? { low: 0, high: 0 };
    const begun = order.length > 2 && forbidden && high > low ? withinATurn([[forbidden.at, forbidden.at]], cyclic)[0][0][order[2]] : (low + high) / 2;
    slider.value = String(high > low ? steps * (begun - low) / (high - low) : steps / 2);
  };

  const paint = () => {
    if (!searched) return;
    const section = chosen();
    const names = parameters().map(({ name }) => name);
    const forbidden = grid();
    const slice = forbidden ? sliceOf(forbidden, names, parameters().map(({ cyclic }) => cyclic), section) : null;
    const axis = (i: number): Axis => {
      const { low, high } = searched?.ranges.get(i) ?? { low: 0, high: 0 };
      const sampled = slice && forbidden ? rangeOf(forbidden, sampledBy(forbidden, names).indexOf(i)) : null;
      const range = sampled ? { low: Math.min(low, sampled.low), high: Math.max(high, sampled.high) } : padded([low, high]);
      return { ...range, label: parameters()[i].name + (unitOf(i) === '°' ? ', degrees' : ', m'),
        text: (each: number) => number(each, 3), seconds: false };
    };
    painted = widthNow();
    const [horizontal, vertical] = [axis(section.across), axis(section.up)];
    plot = chart(painted, heightOf(painted, horizontal, vertical), horizontal, vertical, 'Configurations of the guide');
    const { svg, x, y } = plot;
    const line = (points: [number, number][]) => path(points.map(([a, b]) => [x(a), y(b)]));
    const near = searched.legs.map((leg) => nearPart(leg, section)).filter((part) => part !== null);
    const whole = (legs: Leg[]) => legs.map((leg) => line(leg.map((q): [number, number] => [q[section.across], q[section.up]]))).join('');
    // Before the lines of the axes, which are behind everything.
    svg.prepend(...ground(plot, horizontal, vertical, slice));
    if (!slice) svg.append(draw('text', { x: (x(horizontal.low) + x(horizontal.high)) / 2, y: y(vertical.high) + 18, class: 'middle untold' }, 'forbidden region not sampled'));
    const past = ({ low, high }: Axis, borders: number[]) => low < borders[0] || high > borders[borders.length - 1];
    tellRegion(slice, section, names, slice !== null && (past(horizontal, slice.across) || past(vertical, slice.up)));
    // Each with an edge in the colour of the ground, so that it is seen on what is forbidden.
    for (const [name, d] of [['searched', whole(searched.legs)], ['near', near.map(line).join('')], ['way', whole(searched.way)]]) {
      svg.append(draw('path', { d, class: `edge ${name}-edge` }), draw('path', { d, class: name }));
    }
    for (const [a, b] of crossings(searched.way, section)) svg.append(draw('circle', { cx: x(a), cy: y(b), r: 7, class: 'ring' }));
    svg.append(now);
    picture.replaceChildren(svg);
    slider.disabled = section.third < 0;
    setText(value, section.third < 0 ? '' : number(section.value, 2) + unitOf(section.third));
  };

  /** The same metres are as long on both axes. */
  const heightOf = (width: number, horizontal: Axis, vertical: Axis) => {
    const { across, up } = chosen();
    const lengths = [across, up].every((i) => parameters()[i].kind === 'translation');
    const share = (vertical.high - vertical.low) / (horizontal.high - horizontal.low);
    if (!lengths || across === up || !(share > 0 && share < Infinity)) return upright * width;
    return Math.min(Math.max((width - margins.across) * share + margins.up, flattest * width), tallest * width);
  };

  /** What of the picture is forbidden, and what was not sampled. */
  const ground = ({ x, y }: Chart, horizontal: Axis, vertical: Axis, slice: Slice | null): SVGElement[] => {
    const box = (from: number, to: number, below: number, above: number) => `M${x(from)} ${y(below)}H${x(to)}V${y(above)}H${x(from)}Z`;
    const whole = box(horizontal.low, horizontal.high, vertical.low, vertical.high);
    const last = (borders: number[]) => borders[borders.length - 1];
    const sampled = slice ? box(slice.across[0], last(slice.across), slice.up[0], last(slice.up)) : '';
    const hatch = draw('pattern', { id: 'not-sampled', width: 8, height: 8, patternUnits: 'userSpaceOnUse', patternTransform: 'rotate(45)' },
      draw('rect', { width: 1.5, height: 8, class: 'hatch' }));
    const parts = [draw('defs', {}, hatch), draw('path', { d: whole + sampled, 'fill-rule': 'evenodd', fill: 'url(#not-sampled)', class: 'not-sampled' })];
    if (slice) {
      parts.push(draw('path', { d: rectangles(slice).map((each) => box(...each)).join(''), class: 'forbidden', 'shape-rendering': 'crispEdges' }));
    }
    return parts;
  };

  const tellRegion = (slice: Slice | null, section: Section, names: string[], beyond: boolean) => {
    const forbidden = grid();
    const swatch = (name: string) => make('span', { class: `swatch ${name}` });
    const valueOf = (i: number, each: number) => `${names[i]} ${number(each, 3)}${unitOf(i)}`;
    if (!forbidden) {
      region.replaceChildren(swatch('not-sampled'), `Hatched: where the robot may not stand was not sampled for this search. A run tells it of its first ${told} searches.`);
    } else if (!slice) {
      region.replaceChildren(swatch('not-sampled'), 'Hatched: where the robot may not stand was not sampled for these two parameters, only for ', named(forbidden.parameters.join(', ')), '.');
    } else {
      const on = slice.third === section.third ? ', the sampled value nearest to the slider' : ', as where the search began';
      const layer = slice.third < 0 ? [] : [' at ', named(valueOf(slice.third, slice.value)), on];
      const others = names.flatMap((_, i) => (sampledBy(forbidden, names).includes(i) || forbidden.at[i] === undefined ? [] : [valueOf(i, forbidden.at[i])]));
      region.replaceChildren(swatch('forbidden'), 'Grey: forbidden', ...layer, others.length ? `${layer.length ? ';' : ''} with ` : '', ...(others.length ? [named(others.join(', '))] : []),
        '. Each cell is judged in its middle, as the site is when the search begins. ', ...(beyond ? [swatch('not-sampled'), 'Hatched: not sampled.'] : []));
    }
  };

  const show = () => {
    if (!shown.now()) return;
    const focused = runs.focused(player);
    const at = [focused, ...runs.current(player.time)].map((run) => (run < 0 ? -1 : graphAt(film, run, player.time))).find((each) => each >= 0)
      ?? (searched?.at ?? graphAt(film, film.graphs[0].run, Infinity));
    const other = at !== searched?.at;
    if (other) take(at);
    if (other || painted !== widthNow()) paint();
    const { run, t } = film.graphs[at];
    const { robot, end, happened } = film.runs[run];
    const { across, up } = chosen();
    const [[q]] = withinATurn([Array.from({ length: 2 }, () => Array.from(motion.configuration(robot, player.time, happened ? -1 : run))) as Leg],
      parameters().map(({ cyclic }) => cyclic));
    now.setAttribute('visibility', player.time >= t && player.time <= (end ?? film.end) ? 'visible' : 'hidden');
    if (plot) [['cx', plot.x(q[across])], ['cy', plot.y(q[up])]].forEach(([name, place]) => now.setAttribute(String(name), String(place)));
  };

  const repaint = () => {
    paint();
    show();
  };
  const exportSvg = () => {
    if (!plot) return;
    const text = svgFile(plot.svg, palette().panel, [title.textContent, region.textContent, note.textContent]);
    download(fileName(film.header.plan, 'svg', 'configurations'), new Blob([text], { type: 'image/svg+xml' }));
  };
  for (const { select } of Object.values(axes)) {
    givesBackFocus(select);
    select.addEventListener('change', () => {
      chosenByHand = true;
      repaint();
    });
  }
  slider.addEventListener('input', repaint);
  shown.on(show);
  player.on(['time', 'record', 'selection'], onceAFrame(show));
}

function choice(name: string): { label: HTMLElement; select: HTMLSelectElement } {
  const select = make('select', { 'aria-label': name });
  return { label: make('label', { class: 'field' }, name, select), select };
}
