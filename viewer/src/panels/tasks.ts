import { duration, money } from '../clock';
import { visibleRows, scrollToRow } from '../virtual';
import { button, cut, make, named, onceAFrame, setText } from './dom';
import { goToRun, type Page } from './page';
import type { Shown } from './side';
import { filtered, sorted, tableRows, type SortKey, type TableRow } from '../task_table';

const rowHeight = 26;
const headHeight = 28;

/** Widths in px; the names take what is left. */
const columns: { key: SortKey; title: string; width: number }[] = [
  { key: 'name', title: 'Task', width: 0 }, { key: 'start', title: 'Start', width: 104 },
  { key: 'duration', title: 'Duration', width: 84 }, { key: 'result', title: 'Result', width: 90 },
  { key: 'waits', title: 'Waited', width: 80 }, { key: 'motion', title: 'Motion', width: 76 },
  { key: 'work', title: 'Crew work', width: 92 }, { key: 'float', title: 'Float', width: 80 }, { key: 'cost', title: 'Cost', width: 84 },
  { key: 'who', title: 'By', width: 130 },
];

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
  const heads = columns.map(({ key, title, width }) => {
    const cell = make('th', { scope: 'col', class: key === 'who' ? 'start' : '' }, button(title, () => sortBy(key)));
    if (key === 'waits') cell.title = 'For busy machines and crews, on the way, for shifts; not for the tasks before it';
    if (key === 'float') cell.title = 'Total float: how much later the task could be done and the plan end as it does';
    if (width > 0) cell.style.width = `${width}px`;
    headRow.append(cell);
    return cell;
  });
  const body = make('tbody');
  const table = make('table', { class: 'tasks fixed', 'aria-label': 'Tasks' }, make('thead', {}, headRow), body);
  const scroller = make('div', { class: 'rows', tabindex: '0', role: 'region', 'aria-label': 'Tasks' }, table);
  const empty = make('p', { class: 'empty hidden' }, runs.all.length === 0 ? 'There are no tasks.' : 'No task is called so.');
  host.append(make('div', { class: 'bar' }, search, count), scroller, empty);

  const fill = () => {
    if (!shown.now()) return;
    const { first, after } = visibleRows(scroller.scrollTop, scroller.clientHeight, rowHeight, order.length);
    const gap = (height: number) => {
      const cell = make('td', { colspan: String(columns.length) });
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
    const cell = (content: Node | string, kind = '') => element.append(make('td', kind ? { class: kind } : {}, content));
    const seconds = (value: number | null) => cell(value === null ? '' : duration(value));
    cell(named(row.name, 200));
    cell(clock.short(row.start));
    seconds(row.duration);
    const result = make('span', row.reason ? { title: cut(row.reason, 300) } : {}, row.result);
    cell(result, row.result === 'done' ? 'good' : row.result === 'rejected' || row.result === 'short' ? 'bad' : 'muted');
    seconds(row.waits);
    seconds(row.motion);
    seconds(row.work);
    seconds(row.float);
    cell(row.cost === null ? '' : money(row.cost, ''));
    cell(named(row.who, 100), 'start');
    element.addEventListener('click', () => goToRun(page, row.run));
    return element;
  };

  const arrange = () => {
    order = sorted(filtered(rows, search.value), sortKey, down);
    heads.forEach((cell, i) => {
      const is = columns[i].key === sortKey;
      cell.setAttribute('aria-sort', is ? down ? 'descending' : 'ascending' : 'none');
      const label = cell.querySelector('button');
      if (label) setText(label, columns[i].title + (is ? down ? ' ▾' : ' ▴' : ''));
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
