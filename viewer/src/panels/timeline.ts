import { duration } from '../clock';
import { mark, sliderMarks } from '../marks';
import { ticks } from '../ticks';
import { make, onceAFrame } from './dom';
import { hideHint, showHint } from './hint';
import type { Page } from './page';
import { onTheme, palette } from './theme';

/** By what share of the whole keys move the slider. */
const shares: Record<string, number | undefined> = { ArrowLeft: -0.01, ArrowDown: -0.01, ArrowRight: 0.01, ArrowUp: 0.01,
  PageUp: 0.1, PageDown: -0.1, Home: -1, End: 1 };

/** The time slider: where tasks start and where something was refused; drag, arrows, Page Up and Page Down. */
export function makeTimeline({ film, player, runs, clock }: Page): HTMLElement {
  const canvas = make('canvas', { 'aria-hidden': 'true' });
  const thumb = make('div', { class: 'thumb' });
  const slider = make('div', { class: 'timeline', role: 'slider', tabindex: '0', 'aria-label': 'Time', 'aria-valuemin': '0',
    'aria-valuemax': String(Math.ceil(film.end)) }, canvas, thumb);
  let marks: Uint8Array = new Uint8Array();

  const draw = () => {
    const { clientWidth: width, clientHeight: height } = canvas;
    if (width === 0) return;
    if (marks.length !== width) marks = sliderMarks(film, player.busy, width);
    const ratio = devicePixelRatio || 1;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    const pen = canvas.getContext('2d');
    if (!pen) return;
    const colour = palette();
    pen.scale(ratio, ratio);
    pen.fillStyle = colour.raised;
    pen.fillRect(0, 0, width, height);
    const band = height - 15;
    const paint = (bit: number, fill: string, top: number, tall: number) => {
      pen.fillStyle = fill;
      for (let x = 0; x < width; ++x) if (marks[x] & bit) pen.fillRect(x, top, 1, tall);
    };
    pen.globalAlpha = 0.28;
    paint(mark.busy, colour.machine, 0, band);
    pen.globalAlpha = 1;
    paint(mark.start, colour.machine, 0, 9);
    paint(mark.blocked, colour.wait, band - 6, 6);
    pen.fillStyle = colour.bad;
    for (let x = 0; x < width; ++x) {
      if (!(marks[x] & mark.refused)) continue;
      pen.beginPath();
      const middle = Math.min(Math.max(x + 0.5, 6), width - 6);
      pen.moveTo(middle, band - 12);
      pen.lineTo(middle + 6, band);
      pen.lineTo(middle - 6, band);
      pen.fill();
    }
    pen.font = `11px ${getComputedStyle(slider).fontFamily}`;
    pen.textBaseline = 'bottom';
    let right = -10;
    for (const { t, label } of ticks(clock, 0, film.end, width / 90)) {
      const x = t / film.end * width;
      pen.fillStyle = colour.muted;
      pen.fillRect(x, band, 1, 4);
      const wide = pen.measureText(label).width;
      const at = Math.min(Math.max(x - wide / 2, 2), width - wide - 2);
      if (at < right + 10) continue;
      pen.fillText(label, at, height);
      right = at + wide;
    }
  };

  const follow = () => {
    const share = film.end > 0 ? Math.min(player.time / film.end, 1) : 0;
    thumb.style.transform = `translateX(${(share * slider.clientWidth).toFixed(1)}px)`;
    slider.setAttribute('aria-valuenow', String(Math.round(player.time)));
    slider.setAttribute('aria-valuetext', clock.full(player.time));
  };

  const timeAt = (event: PointerEvent) => {
    const box = slider.getBoundingClientRect();
    return Math.min(Math.max((event.clientX - box.left) / box.width, 0), 1) * film.end;
  };
  slider.addEventListener('pointerdown', (event) => {
    slider.setPointerCapture(event.pointerId);
    player.seek(timeAt(event));
  });
  slider.addEventListener('pointermove', (event) => {
    const t = timeAt(event);
    if (slider.hasPointerCapture(event.pointerId)) player.seek(t);
    const near = film.end / Math.max(slider.clientWidth, 1) * 2;
    const refused = runs.all.filter((run) => !run.happened && Math.abs(run.start - t) <= near);
    const now = runs.current(t);
    showHint(event.clientX, slider.getBoundingClientRect().top, [
      clock.dated ? `${clock.full(t)} (${duration(t)})` : clock.full(t),
      ...refused.slice(0, 2).map((run) => `${run.result}: ${run.task}`),
      ...now.slice(0, 3).map((run) => `${runs.who(run) || 'nobody'}: ${runs.all[run].task}`),
      ...(now.length > 3 ? [`and ${now.length - 3} more`] : []),
    ], true);
  });
  slider.addEventListener('pointerleave', hideHint);
  slider.addEventListener('keydown', (event) => {
    const by = shares[event.key];
    if (by === undefined || event.shiftKey) return;
    event.preventDefault();
    player.seek(player.time + by * film.end);
  });

  new ResizeObserver(onceAFrame(() => {
    draw();
    follow();
  })).observe(slider);
  onTheme(draw);
  player.on('time', onceAFrame(follow));
  follow();
  return slider;
}
