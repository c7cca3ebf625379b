import { duration, workingTime } from '../clock';
import { layoutGantt, stretched } from '../gantt/layout';
import { axisHeight, paintGantt, runsAt, type Scene } from '../gantt/paint';
import { CanvasPainter } from '../gantt/painter';
import { SvgPainter } from '../gantt/svg';
import { panned, showing, wholeView, zoomed, zoomPlace, type TimeView } from '../gantt/view';
import { button, make, onceAFrame, setText } from './dom';
import { download, fileName } from './download';
import { hideHint, showHint } from './hint';
import { goToRun, type Page } from './page';
import type { Shown } from './side';
import { onTheme, palette } from './theme';

/** No canvas is larger than this (px), in most browsers. */
const largestCanvas = 16000;

/** An exported chart is so wide at least (px): names of tasks have room. */
const exportWidth = 1600;

/** The Gantt chart: machines and crews, with what held them. */
export function mountGantt(host: HTMLElement, page: Page, shown: Shown): void {
  const { film, player, runs, clock } = page;
  host.classList.add('column');
  const canvas = make('canvas', { tabindex: '0', role: 'application',
    'aria-label': 'Gantt chart: arrows move, plus and minus zoom, Enter goes to the next task' });
  const said = make('div', { class: 'unseen', 'aria-live': 'polite' });
  const chart = make('div', { class: 'gantt' }, canvas, said);
  let layout = layoutGantt(runs);
  const { labelWidth } = layout;
  /** The height (px) that the rows were stretched for. */
  let room = 0;
  const byStart = runs.all.map((_, i) => i).sort((a, b) => runs.all[a].start - runs.all[b].start || a - b);
  let view: TimeView = wholeView(film.end, 1);
  let scroll = 0;

  const nameOf = (run: number) => runs.all[run].task;
  const scene = (width: number, height: number): Scene => ({ layout, view, scroll, width, height, clock, nameOf,
    picked: runs.focused(player), now: player.time, colours: palette() });
  const draw = onceAFrame(() => {
    const { clientWidth: width, clientHeight: height } = chart;
    if (!shown.now() || width === 0) return;
    if (height !== room) layout = stretched(layout, height - axisHeight);
    room = height;
    view = { ...view, width: width - labelWidth };
    scroll = Math.min(Math.max(scroll, 0), Math.max(layout.height - (height - axisHeight), 0));
    const ratio = devicePixelRatio || 1;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    const pen = canvas.getContext('2d');
    if (!pen) return;
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    paintGantt(new CanvasPainter(pen), scene(width, height));
  });
  const look = (next: TimeView) => {
    view = next;
    draw();
  };
  const zoom = (factor: number, x = zoomPlace(view, player.time)) => look(zoomed(view, x, factor, film.end));
  const all = () => look(wholeView(film.end, view.width));
  const pick = (run: number) => {
    goToRun(page, run);
    setText(said, cardOf(run).slice(0, 3).join(', ').slice(0, 300));
    look(showing(view, runs.all[run].start, film.end));
  };
  const pickNext = (by: 1 | -1) => {
    const at = byStart.indexOf(runs.focused(player));
    const next = at < 0 ? (by > 0 ? 0 : byStart.length - 1) : at + by;
    if (byStart[next] !== undefined) pick(byStart[next]);
  };

  listenToPointer();
  canvas.addEventListener('keydown', (event) => {
    const actions: Record<string, () => void> = {
      ArrowLeft: () => look(panned(view, -80, film.end)), ArrowRight: () => look(panned(view, 80, film.end)),
      ArrowUp: () => { scroll -= 40; draw(); }, ArrowDown: () => { scroll += 40; draw(); },
      '+': () => zoom(0.7), '=': () => zoom(0.7), '-': () => zoom(1 / 0.7), '0': all,
      Enter: () => pickNext(event.shiftKey ? -1 : 1),
    };
    const action = actions[event.key];
    if (!action || event.ctrlKey || (event.shiftKey && event.key.startsWith('Arrow'))) return;
    event.preventDefault();
    action();
  });

  host.append(toolbar(), chart, legend());
  shown.on(draw);
  onTheme(draw);
  player.on('time', () => {
    if (player.playing) view = showing(view, player.time, film.end);
    draw();
  });
  player.on(['selection', 'record'], () => {
    const run = runs.focused(player);
    if (run >= 0 && !shown.now()) view = showing(view, runs.all[run].start, film.end);
    draw();
  });

  function listenToPointer(): void {
    let pressed: { x: number; y: number; view: TimeView; scroll: number; moved: boolean } | null = null;
    const at = (event: MouseEvent) => {
      const box = canvas.getBoundingClientRect();
      return { x: event.clientX - box.left, y: event.clientY - box.top };
    };
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      const { x } = at(event);
      hideHint();
      if (event.shiftKey || x < labelWidth) {
        scroll += event.deltaY || event.deltaX;
        draw();
      } else {
        zoom(Math.exp(Math.min(Math.max(event.deltaY, -200), 200) * 0.002), x - labelWidth);
      }
    }, { passive: false });
    canvas.addEventListener('pointerdown', (event) => {
      pressed = { ...at(event), view, scroll, moved: false };
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener('pointermove', (event) => {
      const { x, y } = at(event);
      if (!pressed) {
        hover(event, x, y);
        return;
      }
      pressed.moved ||= Math.hypot(x - pressed.x, y - pressed.y) > 4;
      if (!pressed.moved) return;
      hideHint();
      scroll = pressed.scroll - (y - pressed.y);
      look(panned({ ...pressed.view, width: view.width }, pressed.x - x, film.end));
    });
    canvas.addEventListener('pointerup', (event) => {
      const click = pressed && !pressed.moved;
      pressed = null;
      if (!click) return;
      const { x, y } = at(event);
      const [run] = runsAt(scene(chart.clientWidth, chart.clientHeight), x, y);
      if (run !== undefined) pick(run);
      else if (y < axisHeight && x > labelWidth) player.seek(view.from + (x - labelWidth) / view.width * (view.to - view.from));
    });
    canvas.addEventListener('pointercancel', () => { pressed = null; });
    canvas.addEventListener('pointerleave', hideHint);
  }

  function hover(event: PointerEvent, x: number, y: number): void {
    const found = runsAt(scene(chart.clientWidth, chart.clientHeight), x, y);
    canvas.style.cursor = found.length > 0 ? 'pointer' : 'grab';
    if (found.length === 0) hideHint();
    else showHint(event.clientX, event.clientY, found.length === 1 ? cardOf(found[0]) : [`${found.length} tasks here:`,
      ...found.slice(0, 5).map((run) => `${runs.all[run].task}: ${runs.all[run].result}`)]);
  }

  function cardOf(run: number): string[] {
    const { task, start, result, reason, because } = runs.all[run];
    const lines = [task];
    if (!runs.all[run].happened) return [...lines, `${result}: ${reason}`];
    const end = runs.end(run);
    lines.push(`${clock.span(start, end)} (${duration(end - start)})`);
    const row = runs.row(run);
    const crew = row?.crew ?? '';
    if (runs.machine(run) || crew) lines.push([runs.machine(run), crew].filter((name) => name !== '').join(', '));
    if (row) lines.push(`motion ${workingTime(row.motion)}, crew work ${workingTime(row.work)}`);
    const wait = runs.spansOf(run).find((span) => span.kind === 'wait' && span.from <= player.time && player.time < span.to)
      ?? runs.spansOf(run).find((span) => span.kind === 'wait');
    if (wait) lines.push(`${wait.text}: ${duration(wait.to - wait.from)}`);
    if (because) lines.push(because);
    if (runs.isCritical(run)) lines.push('on the critical path');
    return lines;
  }

  /** All rows and the piece of time that is seen, as wide as a sheet of paper is. */
  function wholeScene(): Scene {
    const width = Math.max(chart.clientWidth, exportWidth);
    return { ...scene(width, layout.height + axisHeight), view: { ...view, width: width - labelWidth }, scroll: 0, now: null,
      picked: -1 };
  }

  function exportSvg(): void {
    const painter = new SvgPainter();
    const whole = wholeScene();
    paintGantt(painter, whole);
    const text = painter.document(whole.width, whole.height, `${film.header.plan}: Gantt chart`);
    download(fileName(film.header.plan, 'svg'), new Blob([text], { type: 'image/svg+xml' }));
  }

  function exportPng(): void {
    const whole = wholeScene();
    const scale = Math.min(2, largestCanvas / Math.max(whole.width, whole.height));
    const paper = make('canvas');
    paper.width = Math.ceil(whole.width * scale);
    paper.height = Math.ceil(whole.height * scale);
    const pen = paper.getContext('2d');
    if (!pen) return;
    pen.scale(scale, scale);
    paintGantt(new CanvasPainter(pen), whole);
    paper.toBlob((blob) => { if (blob) download(fileName(film.header.plan, 'png'), blob); });
  }

  function toolbar(): HTMLElement {
    return make('div', { class: 'bar', role: 'group', 'aria-label': 'Chart' },
      button('Closer', () => zoom(0.6), {}, '+'), button('Farther', () => zoom(1 / 0.6), {}, '−'), button('All', all),
      make('span', { class: 'grow' }), button('Export SVG', exportSvg), button('Export PNG', exportPng));
  }
}

function legend(): HTMLElement {
  const names = [['machine', 'motion'], ['crew', 'crew work'], ['wait', 'waiting'], ['off', 'no shift'], ['critical', 'critical'],
    ['refused', 'not done']];
  const entries = names.map(([key, text]) => make('span', { class: key }, text));
  return make('div', { class: 'legend', 'aria-hidden': 'true' }, ...entries);
}
