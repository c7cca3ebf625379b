import type { Activity } from '../activity';
import { attributeRows } from '../attributes';
import { Clock } from '../clock';
import type { Film } from '../film';
import { fixedTo } from '../holding';
import type { Player } from '../player';
import { make } from './elements';
import { icon } from './icons';
import { quantity } from './quantity';
import type { SiteModel } from './site_model';

type Row = [name: string, value: string];

const stateWords = { waiting: 'waits where it was at first', placed: 'placed', removed: 'has left the site' };
/** Letters of a name or an attribute that are shown; all of it is in the tooltip. */
const longest = 300;

/** What is picked, in words: at the lower left of the view. */
export class Card {
  readonly element = make('section', 'view-card');
  private readonly title = make('h2');
  private readonly list = make('dl');
  private readonly clock: Clock;
  private shown = '';

  constructor(private readonly film: Film, private readonly player: Player, private readonly model: SiteModel,
              private readonly activity: Activity) {
    this.clock = new Clock(film.header.start_at, film.schedule?.process_time ?? film.end);
    this.element.setAttribute('aria-label', 'What is picked');
    this.element.hidden = true;
    const close = make('button', 'view-close');
    close.type = 'button';
    close.title = 'Pick nothing (Escape in the view)';
    close.setAttribute('aria-label', 'Pick nothing');
    close.append(icon('close'));
    close.addEventListener('click', () => player.select(null));
    this.element.append(close, this.title, this.list);
  }

  show(): void {
    const { selection } = this.player;
    this.element.hidden = selection === null;
    if (!selection) {
      this.shown = '';
      return;
    }
    const [title, rows] = selection.kind === 'component' ? this.component(selection.index)
      : selection.kind === 'robot' ? this.robot(selection.index) : this.run(selection.index);
    const all = JSON.stringify([title, rows]);
    if (all === this.shown) return;
    this.shown = all;
    put(this.title, title);
    this.list.replaceChildren(...rows.flatMap(([name, value]) => {
      const text = make('dd');
      put(text, value);
      return [make('dt', '', name), text];
    }));
  }

  private component(index: number): [string, Row[]] {
    const { header } = this.film;
    const { name, mass, attributes } = header.components[index];
    const rows: Row[] = [];
    const item = this.model.stock.items[index];
    const carrier = header.robots[item.robot]?.name ?? 'a machine';
    const now = item.state === 'carried' ? `carried by ${carrier}` : stateWords[item.state];
    rows.push(['Now', now]);
    if (mass > 0) rows.push(['Mass', mass >= 1000 ? `${quantity(mass / 1000, 2)} t` : `${quantity(mass, 0)} kg`]);
    const fixed = fixedTo(this.film, index, this.player.time);
    if (fixed.length > 0) rows.push(['Fixed to', fixed.join('; ')]);
    const { braced_by: things = [], braced_by_crews: crews = [] } = header.components[index];
    const braced = [...things, ...crews];
    if (braced.length > 0) rows.push(['Braced by', braced.join(', ')]);
    for (const task of header.tasks) if (task.move === name) rows.push(['Task', task.name], ...this.times(task.name));
    return [name, [...attributeRows(attributes), ...rows]];
  }

  private robot(index: number): [string, Row[]] {
    const robot = this.film.header.robots[index];
    const { time, triedRun } = this.player;
    const run = this.activity.running(time, triedRun).find((each) => this.film.runs[each].robot === index);
    const rows: Row[] = [['Now', run === undefined ? 'stands still' : this.activity.words(run, time)]];
    if (run !== undefined) rows.push(['Task', this.film.runs[run].task]);
    const load = this.model.stock.items.flatMap((item, i) => (item.state === 'carried' && item.robot === index ? [i] : []));
    if (load.length > 0) rows.push(['Load', load.map((i) => this.film.header.components[i].name).join(', ')]);
    const { q } = this.model.robots[index];
    robot.parameters.forEach((parameter, i) => {
      if (parameter.derived !== undefined) return;
      rows.push([parameter.name, parameter.kind === 'rotation' ? `${quantity(q[i], 1)}°` : `${quantity(q[i], 2)} m`]);
    });
    return [robot.name, [['Type', robot.type.replaceAll('_', ' ')], ...rows]];
  }

  private run(index: number): [string, Row[]] {
    const { film, player: { time } } = this;
    const run = film.runs[index];
    const task = film.header.tasks.find((each) => each.name === run.task);
    const rows: Row[] = [];
    if (run.robot >= 0) rows.push(['Machine', film.header.robots[run.robot].name]);
    if (task?.move) rows.push(['Moves', task.move]);
    if (task && task.crews.length > 0) rows.push(['Crews', task.crews.join(', ')]);
    const on = time >= run.start && time < (run.end ?? film.end);
    if (run.happened && on) rows.push(['Now', this.activity.words(index, time)]);
    return [run.task, [...attributeRows(task?.attributes), ...rows, ...this.times(run.task)]];
  }

  /** When a task went on, or why it did not. */
  private times(task: string): Row[] {
    const { film } = this;
    return film.runs.filter((run) => run.task === task).map((run): Row => {
      if (!run.happened) return [run.result === 'rejected' ? 'Rejected' : 'Not reached', run.reason];
      return ['When', this.clock.span(run.start, run.end ?? film.end)];
    });
  }
}

function put(element: HTMLElement, text: string): void {
  element.textContent = text.length > longest ? `${text.slice(0, longest)}…` : text;
  element.title = text.length > longest ? text.slice(0, 4 * longest) : '';
}
