import { day, decimal, duration, money, number, roughly, workingTime } from '../clock';
import type { ScheduleData, ScheduledTask, Waited } from '../header';
import { supportWords } from '../holding';
import { tallyText } from '../runs';
import { button, cut, make, named } from './dom';
import { lanesOf } from './lanes';
import { materialOf } from './material';
import { goToRun, goToStep, type Page } from './page';

/** Longer lists are cut: the tables have them whole. */
const mostListed = 300;

/** Numbers, machines and crews, costs, waits, refusals, critical path. */
export function mountOverview(host: HTMLElement, page: Page): { showRefusals(): void } {
  const { film } = page;
  host.classList.add('scrolls');
  host.tabIndex = 0;
  const refusals = refusalsOf(page);
  host.append(numbersOf(page));
  const say = (text: string) => host.append(make('p', { class: 'muted' }, text));
  if (!film.schedule) say('There is no schedule: cost, utilisation, waits and the critical path are missing.');
  if (film.runs.length === 0) say(nothing(page));
  if (refusals) host.append(refusals);
  if (film.schedule) host.append(...lateOf(page, film.schedule), ...supportOf(page, film.schedule), ...missedOf(page, film.schedule), ...resourcesOf(page, film.schedule), ...earthworkOf(page, film.schedule), ...costsOf(page, film.schedule),
    ...waitsOf(film.schedule), ...breakdownsOf(page, film.schedule), ...timetablesOf(film.schedule));
  if (film.flow) host.append(...lanesOf(film.flow, film.header.networks ?? []), ...materialOf(film.flow));
  if (film.schedule) host.append(...chainOf(page, film.schedule));
  return {
    showRefusals: () => {
      refusals?.scrollIntoView({ block: 'start' });
      refusals?.querySelector('button')?.focus();
    },
  };
}

function nothing({ film }: Page): string {
  if (film.header.detail === 'none') {
    return 'The trace tells of no task: it was written without detail. Run the plan with all detail to see them.';
  }
  return 'This plan has no tasks: there is nothing to play.';
}

function numbersOf({ film, runs, clock }: Page): HTMLElement {
  const { schedule, header } = film;
  const list = make('dl', { class: 'numbers' });
  const add = (name: string, value: string, more = '') => {
    const shown = make('dd', { title: more }, value);
    if (more) shown.append(make('small', {}, more));
    list.append(make('div', {}, make('dt', {}, name), shown));
  };
  const long = schedule?.process_time ?? film.end;
  if (clock.dated) add('Finishes', clock.brief(long), `${clock.dayName(long)}, begins ${clock.brief(0)}`);
  add('Process time', duration(long), long < day ? roughly(long) : 'from beginning to end');
  if (schedule?.uncertain) {
    const { sample, uncertain } = schedule;
    add('Uncertain durations', uncertain.toLocaleString('en-GB'), sample ? `drawn: seed ${sample.seed}, run ${sample.run}` : 'stand for their means');
  }
  for (const { calendar, lost, working_days, dates } of (schedule?.lost_days ?? []).slice(0, 3)) {
    const which = dates.slice(0, 6).join(', ') + (dates.length > 6 ? ' ...' : '');
    add(`Days lost, ${cut(calendar, 12)}`, `${lost} of ${working_days}`, which);
  }
  if (schedule?.cost !== undefined) add('Cost', money(schedule.cost, ''), cut(schedule.currency ?? header.currency, 12));
  const support = supportWords(film);
  if (support) add('Support', support.mode, support.more);
  const tally = runs.tally();
  add('Tasks done', `${tally.done} of ${tally.tasks}`, tallyText(tally));
  if (tally.elements > 0) add('Elements in place', `${tally.placed} of ${tally.elements}`);
  let tried = 0;
  let accepted = 0;
  for (const task of schedule?.tasks ?? []) [tried, accepted] = [tried + task.tried, accepted + task.accepted];
  if (tried > 0) add('Steps tried', tried.toLocaleString('en-GB'), `${accepted.toLocaleString('en-GB')} accepted`);
  return list;
}

function refusalsOf(page: Page): HTMLElement | null {
  const { runs } = page;
  const refused = runs.all.map((_, i) => i)
    .filter((i) => (runs.isRefused(i) || runs.all[i].result === 'short') && runs.isTask(runs.all[i].task));
  if (refused.length === 0) return null;
  const list = make('ul', { class: 'refusals' });
  for (const i of refused.slice(0, mostListed)) {
    const { task, result, reason } = runs.all[i];
    const name = button(task, () => goToStep(page, i, runs.refusedAt(i)), { class: 'link' }, named(task, 200));
    const why = make('div', { class: 'reason' }, named(reason, 600));
    list.append(make('li', { class: result === 'not reached' ? 'later' : '' }, name, ` ${result} `, why));
  }
  const section = make('section', {}, make('h2', { class: 'bad' }, `Not done: ${tallyText(runs.tally())}`), list);
  const more = refused.length - mostListed;
  if (more > 0) section.append(make('p', { class: 'muted' }, `and ${more} more: see Tasks`));
  return section;
}

/** The run of a task that happened. */
function runsByName(page: Page): Map<string, number> {
  const byName = new Map<string, number>();
  page.runs.all.forEach((run, i) => { if (run.happened) byName.set(run.task, i); });
  return byName;
}

function taskButton(page: Page, byName: Map<string, number>, task: string): HTMLElement {
  const run = byName.get(task);
  return run === undefined ? named(task, 200) : button(task, () => goToRun(page, run), { class: 'link' }, named(task, 200));
}

/** Tasks that were done later than they were due, or were not done. */
function lateOf(page: Page, schedule: ScheduleData): HTMLElement[] {
  const due = schedule.tasks.filter((task) => task.due !== undefined);
  const undone = due.filter((task) => task.result !== 'done');
  const late = due.filter((task) => task.result !== 'done' || (task.late ?? 0) > 0);
  if (late.length === 0) return [];
  const byName = runsByName(page);
  const body = make('tbody');
  for (const task of late.slice(0, mostListed)) {
    const times = task.result === 'done' ? [page.clock.short(task.start + task.duration), duration(task.late ?? 0)] : ['', task.result];
    const cells = [page.clock.short(task.due ?? 0), ...times];
    body.append(make('tr', {}, make('th', { scope: 'row' }, taskButton(page, byName, task.task)),
      ...cells.map((text) => make('td', {}, text))));
  }
  const notDone = undone.length > 0 ? `, ${undone.length} not done` : '';
  return [make('h2', { class: 'bad' }, `Late: ${late.length - undone.length} of ${due.length} due${notDone}`),
    make('table', {}, head('Task', 'Due', 'Finish', 'Late'), body)];
}

/** What does not stand, where the plan only warns. */
function supportOf(page: Page, schedule: ScheduleData): HTMLElement[] {
  return remarksOf(page, schedule, (task) => task.support,
    (count) => `Support: ${count} ${count === 1 ? 'task leaves' : 'tasks leave'} something that does not stand`);
}

/** Waypoints that scripts left without reaching them. */
function missedOf(page: Page, schedule: ScheduleData): HTMLElement[] {
  return remarksOf(page, schedule, (task) => task.missed,
    (count) => `Waypoints not reached in ${count} ${count === 1 ? 'task' : 'tasks'}`);
}

/** A heading over the tasks of which something is to be said, each with its texts. */
function remarksOf(page: Page, schedule: ScheduleData, textsOf: (task: ScheduledTask) => string[] | undefined,
  title: (count: number) => string): HTMLElement[] {
  const concerned = schedule.tasks.filter((task) => textsOf(task) !== undefined);
  if (concerned.length === 0) return [];
  const byName = runsByName(page);
  const list = make('ul', { class: 'refusals' });
  for (const task of concerned.slice(0, mostListed)) {
    list.append(make('li', {}, taskButton(page, byName, task.task),
      ...(textsOf(task) ?? []).map((text) => make('div', { class: 'reason' }, named(text, 600)))));
  }
  const more = concerned.length - mostListed;
  return [make('h2', {}, title(concerned.length)), list, ...(more > 0 ? [make('p', { class: 'muted' }, `and ${more} more`)] : [])];
}

function head(...names: string[]): HTMLElement {
  return make('thead', {}, make('tr', {}, ...names.map((name) => make('th', { scope: 'col' }, name))));
}

function litres(perVolume: number | undefined): string {
  return perVolume === undefined ? '' : decimal(perVolume, 3);
}

/** What tasks dug, how fast, and who waited for whom. */
function earthworkOf(page: Page, schedule: ScheduleData): HTMLElement[] {
  const digs = schedule.tasks.flatMap(({ task, dig }) => (dig ? [{ task, dig }] : []));
  if (digs.length === 0) return bucketsOf(page, schedule);
  const byName = runsByName(page);
  const isCosted = digs.some(({ dig }) => dig.cost_per_m3 !== undefined);
  const burns = digs.some(({ dig }) => dig.fuel_per_m3 !== undefined);
  const production = make('tbody');
  const queues = make('tbody');
  for (const { task, dig } of digs.slice(0, mostListed)) {
    const cells = [decimal(dig.tipped, 1), dig.loads.toLocaleString('en-GB'), decimal(dig.per_hour, 1), decimal(dig.match_factor, 2)];
    if (burns) cells.push(litres(dig.fuel_per_m3));
    if (isCosted) cells.push(dig.cost_per_m3 === undefined ? '' : decimal(dig.cost_per_m3, 2));
    production.append(make('tr', {}, make('th', { scope: 'row' }, taskButton(page, byName, task)), ...cells.map((text) => make('td', {}, text))));
    for (const queue of dig.queues) {
      const by = queue.servers > 1 ? `${queue.by} (${queue.servers})` : queue.by;
      const times = [duration(queue.mean_wait), duration(queue.longest_wait), decimal(queue.mean_length, 2), `${number(100 * queue.utilisation, 0)} %`];
      queues.append(make('tr', {}, make('th', { scope: 'row' }, named(`${task}.${queue.stage}`), make('small', {}, ` before ${by}`)), ...times.map((text) => make('td', {}, text))));
    }
  }
  const unit = schedule.currency ?? page.film.header.currency;
  const note = 'Match factor below 1: diggers wait for trucks; above 1: trucks queue. m³ are of the volume in the ground, hours are worked.';
  return [make('h2', {}, 'Earthwork'), make('p', { class: 'muted' }, note),
    make('table', {}, head('Task', 'm³', 'Loads', 'm³ per h', 'Match factor', ...(burns ? ['l per m³'] : []), ...(isCosted ? [unit ? `${cut(unit, 12)} per m³` : 'Cost per m³'] : [])), production),
    make('table', {}, head('Queue', 'Mean wait', 'Longest', 'Trucks in it', 'Busy'), queues), ...bucketsOf(page, schedule)];
}

/** What robots dug bucket by bucket. */
function bucketsOf(page: Page, schedule: ScheduleData): HTMLElement[] {
  const digs = schedule.tasks.flatMap(({ task, motion_dig: dig }) => (dig ? [{ task, dig }] : []));
  if (digs.length === 0) return [];
  const byName = runsByName(page);
  const burns = digs.some(({ dig }) => dig.fuel_per_m3 !== undefined);
  const rows = make('tbody');
  const parts = make('tbody');
  for (const { task, dig } of digs.slice(0, mostListed)) {
    const { mean } = dig;
    const row = (cells: string[]) => make('tr', {}, make('th', { scope: 'row' }, taskButton(page, byName, task)), ...cells.map((text) => make('td', {}, text)));
    rows.append(row([decimal(dig.dug, 1), dig.buckets.toLocaleString('en-GB'), decimal(dig.per_hour, 1), `${decimal(mean.cycle, 1)} s`, ...(burns ? [litres(dig.fuel_per_m3)] : [])]));
    parts.append(row([mean.to_the_cut, mean.cut, mean.swing, mean.dump].map((seconds) => `${decimal(seconds, 1)} s`)));
  }
  return [make('h2', {}, 'Digging'), make('p', { class: 'muted' }, 'm³ are of the volume in the ground, hours are worked. A cycle and its parts, on average.'),
    make('table', {}, head('Task', 'm³', 'Buckets', 'm³ per h', 'Cycle', ...(burns ? ['l per m³'] : [])), rows),
    make('table', {}, head('Parts of a cycle', 'To the cut', 'Cut', 'Swing', 'Dump'), parts)];
}

/** Which machines broke down, and when. */
function breakdownsOf({ clock }: Page, schedule: ScheduleData): HTMLElement[] {
  const all = schedule.breakdowns ?? [];
  if (all.length === 0) return [];
  const body = make('tbody');
  for (const each of all.slice(0, mostListed)) {
    const cells = [named(each.during), workingTime(each.worked), clock.short(each.from), clock.short(each.to), duration(each.repair)];
    body.append(make('tr', {}, make('th', { scope: 'row' }, named(each.robot)), ...cells.map((text) => make('td', {}, text))));
  }
  return [make('h2', {}, 'Breakdowns'), make('table', {}, head('Machine', 'During', 'After work of', 'From', 'To', 'Repair'), body)];
}

/** What keeps a timetable, where it had to stop. */
function timetablesOf(schedule: ScheduleData): HTMLElement[] {
  const stopped = (schedule.timetables ?? []).filter(({ stops }) => stops > 0);
  if (stopped.length === 0) return [];
  const body = make('tbody');
  for (const each of stopped) {
    const cells = [String(each.stops), duration(each.late), named(each.stands_before || '-')];
    body.append(make('tr', {}, make('th', { scope: 'row' }, named(each.name)), ...cells.map((text) => make('td', {}, text))));
  }
  return [make('h2', {}, 'Timetables'), make('table', {}, head('Name', 'Stops', 'Late by', 'Stands before'), body)];
}

function resourcesOf({ film }: Page, schedule: ScheduleData): HTMLElement[] {
  if (schedule.resources.length === 0) return [];
  const hasCost = schedule.resources.some((resource) => resource.cost !== undefined && resource.cost !== null);
  const hasFuel = schedule.fuel !== undefined;
  const body = make('tbody');
  for (const resource of schedule.resources) {
    const share = (seconds: number) => `${Math.min(resource.shifts > 0 ? 100 * seconds / resource.shifts : 0, 100).toFixed(1)}%`;
    const held = make('i', { class: 'held' });
    const busy = make('i', { class: 'busy' });
    held.style.width = share(resource.held);
    busy.style.width = share(resource.busy);
    const percent = `${number(100 * resource.utilisation, 0)} %`;
    const used = `held ${share(resource.held)}, busy ${share(resource.busy)} of its shifts`;
    const meter = make('div', { class: resource.kind === 'crew' ? 'meter crew' : 'meter', role: 'img', 'aria-label': used,
      title: used }, held, busy);
    body.append(make('tr', {}, make('th', { scope: 'row' }, named(resource.name), meter), make('td', {}, String(resource.tasks)),
      make('td', {}, workingTime(resource.held)), make('td', {}, workingTime(resource.busy)), make('td', {}, percent),
      ...(hasFuel ? [make('td', {}, resource.fuel === undefined ? '' : decimal(resource.fuel, 1))] : []),
      ...(hasCost ? [make('td', {}, resource.cost === undefined ? '' : money(resource.cost, ''))] : [])));
  }
  const currency = cut(schedule.currency ?? film.header.currency, 8);
  const costs = currency ? `Cost, ${currency}` : 'Cost';
  return [make('h2', {}, 'Machines and crews'),
    make('p', { class: 'muted' }, 'Held: from the beginning to the end of its tasks. Busy: it moves or works. '
      + 'Used: how much of its shifts it is held.'
      + (schedule.fuel === undefined ? '' : ` Fuel of all: ${number(schedule.fuel, 1)} l.`)),
    make('table', { class: 'resources' }, head('Name', 'Tasks', 'Held', 'Busy', 'Used', ...(hasFuel ? ['Fuel, l'] : []), ...(hasCost ? [costs] : [])), body)];
}

/** What the money goes for, in the words of the command's table. */
function costsOf({ film }: Page, schedule: ScheduleData): HTMLElement[] {
  if (!schedule.cost_by_kind) return [];
  const row = (name: string, value: number) => make('tr', {}, make('th', { scope: 'row' }, named(name)), make('td', {}, money(value, '')));
  const currency = cut(schedule.currency ?? film.header.currency, 8);
  const total = row('total', schedule.cost ?? 0);
  total.className = 'total';
  return [make('h2', {}, 'Costs'), make('table', { class: 'costs' }, head('Kind', currency ? `Cost, ${currency}` : 'Cost'),
    make('tbody', {}, ...Object.entries(schedule.cost_by_kind).map(([kind, value]) => row(kind, value)), total))];
}

const waitNames: [Exclude<keyof Waited, 'predecessor'>, string][] = [
  ['resource', 'for a machine or crew that was busy'],
  ['machine', 'on the way, for another machine or a zone'],
  ['shift', 'for the next shift'],
  ['repair', 'for its repair'],
];

/** What tasks waited for once those before them were done: `waited` of the schedule. */
function waitsOf(schedule: ScheduleData): HTMLElement[] {
  const body = make('tbody');
  for (const [kind, name] of waitNames) {
    const waits = schedule.tasks.map((task) => task.waited[kind] ?? 0).filter((wait) => wait > 0);
    if (waits.length === 0) continue;
    const sum = waits.reduce((a, b) => a + b, 0);
    const longest = waits.reduce((a, b) => Math.max(a, b), 0);
    const cells = [String(waits.length), duration(longest), duration(sum)].map((text) => make('td', {}, text));
    body.append(make('tr', {}, make('th', { scope: 'row' }, name), ...cells));
  }
  if (body.rows.length === 0) return [];
  return [make('h2', {}, 'Waits'),
    make('p', { class: 'muted' }, 'Tasks wait side by side: the sum over all of them may be longer than the plan.'),
    make('table', {}, head('Waited', 'Tasks', 'Longest', 'Sum over tasks'), body)];
}

function chainOf(page: Page, schedule: ScheduleData): HTMLElement[] {
  if (schedule.critical.length === 0) return [];
  const byName = runsByName(page);
  const list = make('ol', { class: 'chain' });
  for (const link of schedule.critical.slice(0, mostListed)) {
    const run = byName.get(link.task);
    const text = named(link.text, 400);
    const item = make('li', {}, run === undefined ? text : button(link.text, () => goToRun(page, run), { class: 'link' }, text));
    list.append(item);
  }
  const more = schedule.critical.length - mostListed;
  return [make('h2', {}, 'Critical path'), list, ...(more > 0 ? [make('p', { class: 'muted' }, `and ${more} more`)] : [])];
}
