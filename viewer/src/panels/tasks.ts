import { duration, money, workingTime, type Clock } from '../clock';
import { visibleRows, scrollToRow } from '../virtual';
import { button, cut, make, named, onceAFrame, setText } from './dom';
import { goToRun, type Page } from './page';
import type { Shown } from './side';
import { filtered, sorted, tableRows, type SortKey, type TableRow } from '../task_table';

const rowHeight = 26;
const headHeight = 28;

interface Column {
  key: SortKey;
  title: string;
  hint?: string;
  /** Of words, not numbers: no wider than this, however long (px). */
  most?: number;
  text(row: TableRow, clock: Clock): string;
}

const seconds = (value: number | null) => (value === null ? '' : duration(value));
const worked = (value: number | null) => (value === null ? '' : workingTime(value));
const columns: Column[] = [
  { key: 'name', title: 'Task', most: 220, text: ({ name }) => name },
  { key: 'start', title: 'Start', text: ({ start }, clock) => clock.brief(start) },
  { key: 'duration', title: 'Duration', text: (row) => seconds(row.duration) },
  { key: 'result', title: 'Result', most: 110, text: ({ result }) => result },
  { key: 'who', title: 'By', most: 130, text: ({ who }) => who },
  { key: 'waits', title: 'Waited', hint: 'For busy machines and crews, on the way, for shifts; not for the tasks before it', text: ({ waits }) => seconds(waits) },
  { key: 'motion', title: 'Motion', text: ({ motion }) => worked(motion) },
  { key: 'work', title: 'Crew work', text: ({ work }) => worked(work) },
  { key: 'float', title: 'Float', hint: 'Total float: how much later the task could be done and the plan end as it does, in working time', text: ({ float }) => worked(float) },
  { key: 'cost', title: 'Cost', text: ({ cost }) => (cost === null ? '' : money(cost, '')) },
];
/** Of a cell, both sides (px). */
const padding = 14;
/** So many of the longest texts of a column are measured. */
const measured = 20;

/** How wide columns must be for what they say. */
function widthsOf(shown: Column[], rows: TableRow[], clock: Clock): number[] {
  const { fontSize, fontFamily } = getComputedStyle(document.body);
  const pen = make('canvas').getContext('2d');
  const widest = (weight: number, texts: string[]) => {
    if (!pen) return 80;
    pen.font = `${weight} ${fontSize} ${fontFamily}`;
    return Math.max(0, ...texts.map((text) => pen.measureText(text).width));
  };
  return shown.map(({ title, most, text }) => {
    const texts = [...new Set(rows.map((row) => text(row, clock)))].sort((a, b) => b.length - a.length).slice(0, measured);
    const said = widest(400, texts);
    return padding + Math.ceil(Math.max(widest(600, [`${title} ▾`]), Math.min(said, most ?? said)));
  });
}

/** The table of all tasks: sorted, filtered, only what is seen is there. */
export function mountTasks(host: HTMLElement, page: Page, shown: Shown): void {
  const { player, runs, clock } = page;
  host.classList.add('column');
  const rows = tableRows(runs);
  let order: TableRow[] = rows;
  let sortKey: SortKey = 'start';
  let down = false;

  const search = make('input', { type: 'search', class: 'grow', placeholder: 'Find a task, machine, crew or result',
    'aria-label': 'Find tasks' });
  const count = make('span', { class: 'muted' });
  const own = rows.filter((row) => runs.isTask(row.name)).length;
  const whole = own === rows.length ? `${own} tasks` : `${own} tasks, ${rows.length - own} × out of the way`;
  const headRow = make('tr');
  // What no row knows has no column.
  const told = columns.filter(({ text }, i) => i === 0 || rows.length === 0 || rows.some((row) => text(row, clock) !== ''));
  const widths = widthsOf(told, rows, clock);
  const heads = told.map(({ title, key, hint, most }, i) => {
    const cell = make('th', { scope: 'col', class: most ? 'start' : '', ...(hint ? { title: hint } : {}) }, button(title, () => sortBy(key)));
    // The names take what is left.
    if (i > 0) cell.style.width = `${widths[i]}px`;
    headRow.append(cell);
    return cell;
  });
  const body = make('tbody');
  const table = make('table', { class: 'tasks fixed', 'aria-label': 'Tasks' }, make('thead', {}, headRow), body);
  table.style.minWidth = `${widths.reduce((a, b) => a + b, 0)}px`;
  const scroller = make('div', { class: 'rows', tabindex: '0', role: 'region', 'aria-label': 'Tasks' }, table);
  const empty = make('p', { class: 'empty hidden' }, runs.all.length === 0 ? 'There are no tasks.' : 'No task is called so.');
  host.append(make('div', { class: 'bar' }, search, count), scroller, empty);

  const fill = () => {
    if (!shown.now()) return;
    const { first, after } = visibleRows(scroller.scrollTop, scroller.clientHeight, rowHeight, order.length);
    const gap = (height: number) => {
      const cell = make('td', { colspan: String(told.length) });
      cell.style.height = `${height}px`;
      return make('tr', { class: 'gap', 'aria-hidden': 'true' }, cell);
    };
    const picked = runs.focused(player);
    const now = new Set(runs.current(player.time));
    const lines = order.slice(first, after).map((row, i) => rowElement(row, first + i, row.run === picked, now.has(row.run)));
    body.replaceChildren(gap(first * rowHeight), ...lines, gap((order.length - after) * rowHeight));
    lastNow = [...now].join(' ');
  };
  let lastNow = '';

  const rowElement = (row: TableRow, at: number, picked: boolean, now: boolean) => {
    const element = make('tr', { 'aria-rowindex': String(at + 2), 'aria-selected': String(picked), class: now ? 'now' : '' });
    for (const { key, most, text } of told) {
      if (!most) {
        element.append(make('td', {}, text(row, clock)));
        continue;
      }
      const words = named(text(row, clock), 200);
      const cell = make('td', { class: 'start' }, words);
      if (key === 'result') {
        cell.classList.add(row.result === 'done' ? 'good' : ['rejected', 'short'].includes(row.result) ? 'bad' : 'muted');
        if (row.reason) words.title = cut(row.reason, 300);
      }
      element.append(cell);
    }
    element.addEventListener('click', () => goToRun(page, row.run));
    return element;
  };

  const arrange = () => {
    order = sorted(filtered(rows, search.value), sortKey, down);
    heads.forEach((cell, i) => {
      const { key, title } = told[i];
      const is = key === sortKey;
      cell.setAttribute('aria-sort', is ? down ? 'descending' : 'ascending' : 'none');
      const label = cell.querySelector('button');
      if (label) setText(label, title + (is ? down ? ' ▾' : ' ▴' : ''));
    });
    table.setAttribute('aria-rowcount', String(order.length + 1));
    setText(count, order.length === rows.length ? whole : `${order.length} of ${rows.length}`);
    empty.classList.toggle('hidden', order.length > 0);
    fill();
  };
  const sortBy = (key: SortKey) => {
    down = key === sortKey ? !down : false;
    sortKey = key;
    arrange();
  };
  const reveal = () => {
    const at = order.findIndex((row) => row.run === runs.focused(player));
    if (at >= 0) {
      scroller.scrollTop = scrollToRow(at, scroller.scrollTop, scroller.clientHeight - headHeight, rowHeight, order.length);
    }
    fill();
  };

  scroller.addEventListener('keydown', (event) => {
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (by === undefined || event.shiftKey || order.length === 0) return;
    event.preventDefault();
    const at = order.findIndex((row) => row.run === runs.focused(player));
    goToRun(page, order[Math.min(Math.max(at + by, 0), order.length - 1)].run);
  });
  search.addEventListener('input', arrange);
  const soon = onceAFrame(fill);
  scroller.addEventListener('scroll', soon);
  shown.on(fill);
  player.on(['selection', 'record'], onceAFrame(() => { if (shown.now()) reveal(); }));
  player.on('time', onceAFrame(() => {
    if (shown.now() && runs.current(player.time).join(' ') !== lastNow) fill();
  }));
  arrange();
}
