import { number } from '../clock';
import { crossings, graphAt, legsOfGraph, nearPart, variedOf, wayAfter, withinATurn, type Leg, type Section } from '../configurations';
import { chart, draw, padded, path, type Chart } from '../study/chart';
import { givesBackFocus, make, named, onceAFrame, setText } from './dom';
import type { Page } from './page';
import type { Shown } from './side';

/** Of the picture (px): at least and at most, and its height as a share of its width. */
const narrowest = 340;
const widest = 640;
const upright = 0.85;
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
  const slider = make('input', { type: 'range', 'aria-label': 'Value of the third parameter', max: String(steps) });
  const value = make('output');
  const picture = make('div');
  const note = make('p', { class: 'muted' }, 'Pale: what the guide searched through; strong what of it is near the value of the slider. Thick: how the machine went, with a ring '
    + 'where it has that value, and a dot where it is now. What is forbidden is in no trace: rubicon guides --page draws it.');
  host.append(title, make('div', { class: 'axes' }, ...Object.values(axes).map(({ label }) => label), make('label', { class: 'field' }, slider, value)), picture, note);
  let searched: Searched | null = null;
  let plot: Chart | null = null;
  let painted = 0;
  const widthNow = () => Math.min(Math.max(host.clientWidth - 24, narrowest), widest);
  const now = draw('circle', { r: 5, class: 'now' });

  const parameters = () => film.header.robots[film.runs[film.graphs[searched?.at ?? 0].run].robot].parameters;
  const unitOf = (i: number) => (parameters()[i].kind === 'rotation' ? '°' : ' m');
  const chosen = (): Section => {
    const [across, up, third] = [axes.across, axes.up, axes.third].map(({ select }) => Number(select.value));
    const { low, high } = searched?.ranges.get(third) ?? { low: 0, high: 0 };
    return { across, up, third, value: low + (high - low) * Number(slider.value) / steps, reach: nearShare * (high - low) };
  };

  /** Another search: the three parameters that it changed most. */
  const take = (at: number) => {
    const { run } = film.graphs[at];
    const { parameters: all } = film.header.robots[film.runs[run].robot];
    const names = all.map(({ name }) => name);
    const cyclic = all.map((each) => each.cyclic);
    const legs = withinATurn(legsOfGraph(film, at), cyclic);
    const way = withinATurn(wayAfter(film, motion, at), cyclic);
    const varied = variedOf([...legs, ...way].flat(), names.length);
    const before = searched && film.runs[film.graphs[searched.at].run].robot === film.runs[run].robot;
    searched = { at, legs, way, ranges: new Map(varied.map((each) => [each.parameter, each])) };
    title.replaceChildren(named(film.runs[run].task, 200), ` (${film.graphs[at].legs.toLocaleString('en-GB')} legs searched)`);
    if (before) return;
    Object.values(axes).forEach(({ select }, i) => {
      select.replaceChildren(...(i === 2 ? [make('option', { value: '-1' }, 'none')] : []), ...names.map((name, p) => make('option', { value: String(p) }, name)));
      select.value = String(varied[i]?.parameter ?? (i === 2 ? -1 : 0));
    });
    slider.value = String(steps / 2);
  };

  const paint = () => {
    if (!searched) return;
    const section = chosen();
    const axis = (i: number) => {
      const { low, high } = searched?.ranges.get(i) ?? { low: 0, high: 0 };
      return { ...padded([low, high]), label: parameters()[i].name + (unitOf(i) === '°' ? ', degrees' : ', m'),
        text: (each: number) => number(each, 3), seconds: false };
    };
    painted = widthNow();
    plot = chart(painted, upright * painted, axis(section.across), axis(section.up), 'Configurations of the guide');
    const { svg, x, y } = plot;
    const line = (points: [number, number][]) => path(points.map(([a, b]) => [x(a), y(b)]));
    const near = searched.legs.map((leg) => nearPart(leg, section)).filter((part) => part !== null);
    const whole = (legs: Leg[]) => legs.map((leg) => line(leg.map((q): [number, number] => [q[section.across], q[section.up]]))).join('');
    svg.append(draw('path', { d: whole(searched.legs), class: 'searched' }),
      draw('path', { d: near.map(line).join(''), class: 'near' }), draw('path', { d: whole(searched.way), class: 'way' }));
    for (const [a, b] of crossings(searched.way, section)) svg.append(draw('circle', { cx: x(a), cy: y(b), r: 7, class: 'ring' }));
    svg.append(now);
    picture.replaceChildren(svg);
    slider.disabled = section.third < 0;
    setText(value, section.third < 0 ? '' : number(section.value, 2) + unitOf(section.third));
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
  for (const { select } of Object.values(axes)) {
    givesBackFocus(select);
    select.addEventListener('change', repaint);
  }
  slider.addEventListener('input', repaint);
  shown.on(show);
  player.on(['time', 'record', 'selection'], onceAFrame(show));
}

function choice(name: string): { label: HTMLElement; select: HTMLSelectElement } {
  const select = make('select', { 'aria-label': name });
  return { label: make('label', { class: 'field' }, name, select), select };
}
