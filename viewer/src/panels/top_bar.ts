import { duration, money } from '../clock';
import { tallyText } from '../runs';
import { button, cut, icon, make, named } from './dom';
import { makeHelp } from './help';
import type { Page } from './page';
import { isDark, onTheme, toggleTheme } from './theme';

const sun = 'M8 4.5a3.5 3.5 0 1 0 0 7 3.5 3.5 0 0 0 0-7zM7.3 0h1.4v2.6H7.3zM7.3 13.4h1.4V16H7.3zM0 7.3h2.6v1.4H0zM13.4 7.3H16v1.4'
  + 'h-2.6zM2 3l1-1 1.8 1.8-1 1zM11.2 12.2l1-1 1.8 1.8-1 1zM13 2l1 1-1.8 1.8-1-1zM3.8 11.2l1 1L3 14l-1-1z';
const moon = 'M6.2 1.2a7 7 0 1 0 8.6 8.6A6 6 0 0 1 6.2 1.2z';

/** Name, whether the plan can be done, process time and cost, theme, help. */
export function mountTopBar(host: HTMLElement, page: Page, showRefusals: () => void): void {
  const { clock, film, runs } = page;
  const { schedule, header } = film;
  const title = make('h1', {}, named(header.plan || 'a plan without a name', 300));

  const tally = runs.tally();
  const { tasks } = tally;
  let badge: HTMLElement;
  if (tally.done < tasks) {
    badge = button(`${tallyText(tally)} of ${tasks} ${tasks === 1 ? 'task' : 'tasks'}`, showRefusals, { class: 'badge bad' });
  } else if (tasks === 0) {
    badge = make('span', { class: 'badge muted' }, header.tasks.length === 0 ? 'nothing to do' : 'no results in the trace');
  } else {
    badge = make('span', { class: 'badge good' }, `feasible: ${tasks === 1 ? 'the task' : `all ${tasks} tasks`} done`);
  }

  const facts = make('dl');
  const fact = (name: string, value: string) => facts.append(make('div', {}, make('dt', {}, name), make('dd', {}, value)));
  const long = schedule?.process_time ?? film.end;
  if (clock.dated) fact('Finishes', `${clock.dayName(long)} ${clock.time(long)}`);
  fact('Process time', duration(long));
  if (schedule?.cost !== undefined) fact('Cost', money(schedule.cost, cut(schedule.currency ?? header.currency, 8)));

  const help = makeHelp();
  const themeButton = button('Light or dark', toggleTheme, {}, icon(moon));
  const show = () => {
    themeButton.replaceChildren(icon(isDark() ? sun : moon));
    themeButton.title = isDark() ? 'Light colours' : 'Dark colours';
    themeButton.setAttribute('aria-label', themeButton.title);
  };
  show();
  onTheme(show);
  host.append(make('span', { class: 'brand' }, 'RUBICON'), title, badge, make('span', { class: 'grow' }), facts, themeButton,
    button('Keys and hints', () => help.showModal(), {}, '?'));
  document.body.append(help);
}
