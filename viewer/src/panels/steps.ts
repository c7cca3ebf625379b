import type { Place } from '../film';
import { fileText, isRefusal } from '../behaviour';
import { Refusals } from '../refusals';
import { sentence } from '../sentences';
import { Trail } from '../trail';
import { button, cut, givesBackFocus, icon, make, onceAFrame, setText } from './dom';
import { goToRun, goToStep, type Page } from './page';
import type { Shown } from './side';
import { showState } from './step_state';
import { VirtualList } from './virtual_list';

const lineHeight = 20;
/** What a row or a name in the list of tasks shows of a text at most: longer ones only slow the browser down. */
const longest = 400;
const longestName = 70;

/** A debugger's view: the records of a run, the script, and how it stands. */
export function mountSteps(host: HTMLElement, page: Page, shown: Shown): void {
  const { film, player, runs, clock } = page;
  host.classList.add('column', 'steps');
  let trail = new Trail(film, -1);
  let begun = false;
  /** The position of the record that is shown; -1: the run has none. */
  let at = -1;
  let place: Place | null = null;
  let script: string[] = [];

  const chooser = make('select', { 'aria-label': 'Task' });
  const note = make('p', { class: 'empty hidden' });
  const listAttributes = { class: 'list trail', role: 'listbox', 'aria-label': 'Records of the task' };
  const list = new VirtualList(listAttributes, lineHeight, recordRow);
  const file = make('bdi', { class: 'grow' });
  const count = make('span');
  const fileBar = make('div', { class: 'file' }, file, count);
  const text = new VirtualList({ class: 'list script', role: 'region', 'aria-label': 'Script' }, lineHeight, scriptRow);
  const state = make('div', { class: 'state', tabindex: '0', role: 'region', 'aria-label': 'State', 'aria-live': 'off' });
  const buttons = makeButtons();
  const refusals = new Refusals(runs);
  /** What a search found not; empty as long as there is nothing to say. */
  const found = make('p', { class: 'found muted', role: 'status' });
  host.append(make('div', { class: 'bar' }, chooser), buttons.element, found, list.element, note, fileBar, text.element, state);

  givesBackFocus(chooser);
  chooser.addEventListener('change', () => {
    const run = Number(chooser.value);
    if (runs.all[run].happened) goToRun(page, run);
    else goToStep(page, run, runs.refusedAt(run));
  });
  list.element.addEventListener('keydown', (event) => {
    const to = { ArrowUp: at - 1, ArrowDown: at + 1, Home: 0, End: trail.records.length - 1 }[event.key];
    if (to === undefined || event.shiftKey) return;
    event.preventDefault();
    go(to);
  });
  shown.on(show);
  const soon = onceAFrame(show);
  player.on(['time', 'record', 'selection'], soon);

  /** To the nearest refusal after or before this record, in whatever task it is. */
  function goToRefusal(by: 1 | -1): void {
    const record = refusals.next(Math.max(trail.run, 0), at, by);
    if (record >= 0) {
      goToStep(page, film.run(record), record);
      return;
    }
    const none = refusals.next(0, -1, 1) < 0;
    setText(found, none ? 'Nothing was refused, in any task.'
      : by > 0 ? 'No task has a later refusal: this was the last.' : 'No task has an earlier refusal: this was the first.');
  }

  function go(position: number): void {
    const record = trail.records[position];
    if (record !== undefined) player.goToRecord(record);
  }

  /** The run that is picked; else one that goes on, else the one shown before. */
  function wantedRun(): number {
    const focused = runs.focused(player);
    if (focused >= 0) return focused;
    const now = runs.current(player.time);
    if (now.includes(trail.run)) return trail.run;
    // A machine has steps to look at, a crew has none.
    return now.find((run) => runs.all[run].robot >= 0) ?? now[0] ?? (trail.run >= 0 ? trail.run : runs.all.length > 0 ? 0 : -1);
  }

  function show(): void {
    if (!shown.now()) return;
    fillChooser();
    const run = wantedRun();
    const changed = run !== trail.run || !begun;
    begun = true;
    if (changed) {
      trail = new Trail(film, run);
      chooser.value = String(run);
      list.setCount(trail.records.length);
      sayWhatIsMissing();
    }
    const record = run < 0 ? -1 : player.record ?? runs.recordAt(run, player.time);
    const position = record < 0 ? -1 : trail.positionOf(record);
    if (!changed && position === at) return;
    at = position;
    setText(found, '');
    list.reveal(Math.max(at, 0));
    list.element.setAttribute('aria-activedescendant', at >= 0 ? `record-${at}` : '');
    setText(count, at < 0 ? '' : `record ${at + 1} of ${trail.records.length}`);
    showScript();
    buttons.enable();
    showState(state, page, trail, at);
  }

  function sayWhatIsMissing(): void {
    const message = runs.all.length === 0 ? 'There are no tasks to step through.'
      : trail.records.length === 0 ? 'The trace tells nothing of this task.'
      : trail.hasSteps() || film.header.detail === 'steps' ? ''
      : 'The trace was written without single steps (--trace-detail steps has them): only what the task did as a whole is here.';
    setText(note, message);
    note.classList.toggle('hidden', message === '');
    for (const element of [fileBar, text.element]) element.classList.toggle('hidden', !trail.hasSteps());
    for (const element of [list.element, state]) element.classList.toggle('hidden', trail.records.length === 0);
    chooser.disabled = runs.all.length === 0;
  }

  function showScript(): void {
    const next = at >= 0 ? trail.placeAround(at) : null;
    if (next && next.file !== place?.file) {
      const whole = fileText(film, next.file);
      script = (whole ?? '').split(/\r\n|\r|\n/);
      setText(file, cut(next.file, 200) + (whole === null ? ' (its text is not in the trace)' : ''));
      file.title = cut(next.file, 300);
      text.setCount(script.length);
    }
    place = next;
    if (place) text.reveal(place.line - 1);
  }

  function recordRow(i: number): HTMLElement {
    const record = trail.records[i];
    const row = make('div', { role: 'option', id: `record-${i}`, 'aria-selected': String(i === at), class: classOf(record) },
      make('span', { class: 'time' }, clock.exact(film.time(record))),
      make('span', { class: 'line' }, String(trail.place(record)?.line ?? '')));
    if (i === at) row.classList.add('at');
    const words = make('bdi', {}, cut(sentence(film, record), longest));
    words.style.paddingInlineStart = `${Math.min(trail.depth[i], 12) * 12}px`;
    row.append(words);
    row.addEventListener('click', () => go(i));
    return row;
  }

  function classOf(record: number): string {
    switch (film.kind(record)) {
      case 'try': return isRefusal(film, record) ? 'refused' : film.number(record, 'try.ok') ? 'made' : 'idle';
      case 'end': return film.number(record, 'end.reached') ? 'event' : 'event warn';
      case 'task_end': return runs.isRefused(trail.run) ? 'event refused' : 'event';
      case 'guide': return film.text(record, 'guide.cause') ? 'event warn' : 'event';
      case 'task_start': case 'goal': case 'way_point': case 'attach': case 'detach': case 'remove': case 'work': case 'turn': return 'event';
      case 'pause': case 'wait': case 'stop': case 'think': return 'idle';
      default: return '';
    }
  }

  function scriptRow(i: number): HTMLElement {
    const row = make('div', i + 1 === place?.line ? { class: 'at', 'aria-current': 'step' } : {},
      make('span', { class: 'line' }, String(i + 1)), make('bdi', {}, cut(script[i], 2000)));
    const from = place?.file;
    if (from !== undefined && trail.hasLine(from, i + 1)) {
      row.classList.add('visited');
      row.title = 'On to the next record from this line';
      row.addEventListener('click', () => go(trail.nextFromLine(at, from, i + 1)));
    }
    return row;
  }

  /** Options for all tasks; made when they are first seen. */
  function fillChooser(): void {
    if (chooser.options.length > 0 || runs.all.length === 0) return;
    chooser.append(...runs.all.map((run, i) => {
      const refused = runs.isRefused(i) ? `✗ ${run.result}: ` : '';
      const where = `${cut(runs.who(i), 30)}, ${clock.brief(run.start)}`;
      return make('option', { value: String(i) }, `${refused}${cut(run.task, longestName)} (${where})`);
    }));
  }

  function makeButtons(): { element: HTMLElement; enable(): void } {
    const back = 'M12 2.5v11L4 8z';
    const on = 'M4 2.5v11L12 8z';
    const last = () => trail.records.length - 1;
    const wanted: [string, string, string, 1 | -1 | (() => number)][] = [
      ['First record', 'M3 2.5h2v11H3zM13 2.5v11L6 8z', '', () => (at > 0 ? 0 : -1)],
      ['Previous refusal, in whatever task', back, 'refusal', -1],
      ['Previous try (Shift ←)', back, 'try', () => trail.nextTry(at, -1)],
      ['Next try (Shift →)', on, 'try', () => trail.nextTry(at, 1)],
      ['Next refusal, in whatever task', on, 'refusal', 1],
      ['Last record', 'M11 2.5h2v11h-2zM3 2.5v11L10 8z', '', () => (at < last() ? last() : -1)],
    ];
    const element = make('div', { class: 'bar nav', role: 'group', 'aria-label': 'Step' });
    element.addEventListener('mousedown', (event) => event.preventDefault());
    const all = wanted.map(([label, path, word, to]) => {
      const face = make('span', { class: 'face' }, icon(path));
      if (word) face[path === back ? 'append' : 'prepend'](word);
      const press = typeof to === 'number' ? () => goToRefusal(to) : () => go(to());
      const made = button(label, press, word ? {} : { class: 'small' }, face);
      element.append(made);
      return { made, to };
    });
    // Those for refusals say themselves when there is none.
    return { element, enable: () => { for (const { made, to } of all) made.disabled = typeof to !== 'number' && to() < 0; } };
  }
}
