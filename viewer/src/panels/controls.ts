import { duration } from '../clock';
import { lengthName, lengths } from '../lengths';
import { button, cut, givesBackFocus, icon, make, named, onceAFrame, setText } from './dom';
import type { Page } from './page';
import { makeTimeline } from './timeline';

const icons = {
  play: 'M3.5 2v12l10-6z',
  fast: 'M1.5 2.5v11L8 8zM8 2.5v11L14.5 8z',
  previous: 'M3 2.5h2v11H3zM13.5 2.5v11L5.5 8z',
  next: 'M11 2.5h2v11h-2zM2.5 2.5v11l8-5.5z',
  pause: 'M3.5 2.5h3v11h-3zM9.5 2.5h3v11h-3z',
  stop: 'M3 3h10v10H3z',
};

/** The control panel: the time slider above, keys, clock, length and the tasks that go on below. */
export function mountControls(host: HTMLElement, page: Page): void {
  const row = make('div', { class: 'row' });
  row.append(makeKeys(page), makeClock(page), makeLength(page), makeChips(page));
  host.append(makeTimeline(page), row);
}

function makeKeys({ player }: Page): HTMLElement {
  const play = button('Play (space)', () => player.play(), { class: 'main' }, icon(icons.play));
  const fast = button('Fast play: components only', () => player.fastPlay(), {}, icon(icons.fast));
  const previous = button('Previous component (←)', () => player.previousComponent(), {}, icon(icons.previous));
  const next = button('Next component (→)', () => player.nextComponent(), {}, icon(icons.next));
  const pause = button('Pause (space)', () => player.pause(), {}, icon(icons.pause));
  const stop = button('Stop: back to the beginning', () => player.stop(), {}, icon(icons.stop));
  const keys = make('div', { class: 'keys', role: 'group', 'aria-label': 'Play' }, play, fast, previous, next, pause, stop);
  // The mouse takes no focus here, so that space goes on meaning play and pause.
  keys.addEventListener('mousedown', (event) => event.preventDefault());
  const show = () => {
    play.setAttribute('aria-pressed', String(player.playing && !player.fast));
    fast.setAttribute('aria-pressed', String(player.fast));
    pause.setAttribute('aria-pressed', String(!player.playing && player.time > 0 && player.time < player.end));
  };
  player.on(['playing', 'fast'], show);
  player.on('time', () => { if (!player.playing) show(); });
  show();
  return keys;
}

function makeClock({ player, clock }: Page): HTMLElement {
  const time = make('span');
  const since = make('small');
  const show = () => {
    setText(time, clock.full(player.time));
    setText(since, clock.dated ? `${duration(player.time)} since the beginning` : 'since the beginning');
  };
  player.on('time', onceAFrame(show));
  show();
  const kind = clock.dated ? 'clock dated' : 'clock';
  return make('div', { class: kind, role: 'timer', 'aria-label': 'Simulated time' }, time, since);
}

/** How long it takes to play, and how much faster than it was that is. */
function makeLength({ player }: Page): HTMLElement {
  const select = make('select', { 'aria-label': 'Length of the animation', title: 'How long it takes to play, never longer than it '
    + 'was (↑ shorter, ↓ longer). Nights and weekends are passed over, but not in real time.' });
  for (const length of lengths) select.append(make('option', { value: String(length) }, lengthName(length)));
  givesBackFocus(select);
  select.addEventListener('change', () => player.setLength(lengths[select.selectedIndex]));
  const speed = make('small', { class: 'speed muted', title: 'How much faster than it was' });
  const show = () => {
    select.selectedIndex = lengths.indexOf(player.length);
    setText(speed, speedText(player.speed));
  };
  player.on('length', show);
  show();
  return make('label', { class: 'field' }, 'Play in', select, speed);
}

/** `12×`, `9,270×`. */
function speedText(speed: number): string {
  return `${speed.toLocaleString('en-GB', { maximumSignificantDigits: speed < 100 ? 2 : 3 })}×`;
}

/** Tasks at a time that are looked at for a place in the line. */
const mostChips = 12;

/** Tasks that go on: one line, what has no room is counted. */
function makeChips({ player, runs }: Page): HTMLElement {
  const host = make('div', { class: 'chips', role: 'group', 'aria-label': 'Tasks that go on' });
  let shown = '';
  const show = () => {
    const tried = player.triedRun;
    const now = runs.shown(player);
    const picked = runs.focused(player);
    const room = host.clientWidth;
    const idle = player.time >= player.end ? 'the end' : 'nobody works';
    const key = `${now.join(' ')}/${picked}/${room}/${now.length === 0 ? idle : ''}`;
    if (key === shown) return;
    shown = key;
    const chips = now.slice(0, mostChips).map((run) => {
      const who = runs.who(run);
      const task = runs.all[run].task;
      const kind = run === tried ? 'tried' : run === picked ? 'picked' : '';
      const label = who ? `${cut(who, 40)}: ${cut(task, 80)}` : cut(task, 80);
      const chip = button(label, () => player.select({ kind: 'run', index: run }), kind ? { class: kind } : {},
        ...(run === tried ? [`${runs.all[run].result}: `] : []), ...(who ? [named(who, 40), ': '] : []), named(task, 80));
      chip.title = cut(`${who}: ${task}${run === tried ? ' (what is shown was only tried: it did not happen)' : ''}`, 300);
      return chip;
    });
    const more = make('span', { class: 'more' }, now.length === 0 && runs.all.length > 0 ? idle : '');
    host.replaceChildren(...chips, more);
    // Those that are there are read whole, as far as that goes; the others are counted.
    const count = () => setText(more, chips.length < now.length ? `+${now.length - chips.length}` : more.textContent ?? '');
    count();
    while (chips.length > 1 && host.scrollWidth > host.clientWidth) {
      chips.pop()?.remove();
      count();
    }
  };
  const soon = onceAFrame(show);
  player.on(['time', 'selection', 'record'], soon);
  new ResizeObserver(soon).observe(host);
  return host;
}
