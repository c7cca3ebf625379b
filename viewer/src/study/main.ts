import '../study.css';
import { button, make, named } from '../panels/dom';
import { command, comparedWith, differenceText, filmOf, firstShown, MAKESPAN, REJECTED, rowsOf, settings, shown, type Key, type Study, type Variant } from './data';
import { criticality, finishText, paretoPicture, progressPicture, sureness, tornado } from './pictures';

const MOST_ROWS = 500;

/** The page of a study. */
class Page {
  private selected: Variant;
  private question: number;
  private key: Key = 'variant';
  private down = false;
  private filter = '';
  private readonly table = make('div', { class: 'rows' });
  private readonly pareto = make('div', { class: 'picture' });
  private readonly details = make('section', { class: 'card', 'aria-label': 'Variant', 'aria-live': 'polite' });

  constructor(private readonly study: Study, private readonly root: HTMLElement) {
    this.selected = firstShown(study);
    this.question = study.asked.find((each) => each !== REJECTED) ?? MAKESPAN;
    const top = make('header', {}, make('h1', {}, named(study.study)), make('p', { class: 'muted' }, this.summary()));
    const choice = this.choice();
    const variants = make('section', { class: 'card', 'aria-label': 'Variants' }, make('h2', {}, 'Variants'), this.controls(), this.table);
    const compare = make('section', { class: 'card', 'aria-label': 'Time and cost' }, make('h2', {}, 'Time and cost'), this.pareto,
      make('p', { class: 'muted' }, 'Means; bars from P10 to P95. On the line: no other variant is both faster and cheaper. A variant in which anything is rejected is never on it.'));
    const grid = make('div', { class: 'columns' }, variants, compare);
    if (!paretoPicture(study, this.selected, () => {})) compare.classList.add('hidden');
    this.root.append(top, ...(choice ? [choice] : []), grid, this.details);
    this.show();
  }

  private summary(): string {
    const { study } = this;
    const runs = study.sampled
      ? `${study.until ? `at most ${study.runs} runs each, until ${study.until}` : `${study.runs} runs each`}, seed ${study.seed}`
      : 'durations at their means';
    return `${study.variants.length} variant${study.variants.length === 1 ? '' : 's'} of ${study.plan}, ${runs}`;
  }

  private choice(): HTMLElement | null {
    const { choice } = this.study;
    if (!choice) return null;
    const rule = `${choice.direction} ${choice.statistic}${choice.with.length ? ` with ${choice.with.join(', ')}` : ''}`;
    const box = make('section', { class: 'card choice', 'aria-label': 'Choice' });
    if (choice.chosen === undefined) {
      box.append(make('p', { class: 'bad' }, make('strong', {}, 'No variant fits the rule'), ` (${rule}).`));
    } else {
      const variant = this.study.variants[choice.chosen - 1];
      box.append(make('p', {}, make('strong', {}, `Variant ${choice.chosen}: ${settings(variant)}`), ` (${rule}).`));
      const others = choice.equal.filter((each) => each !== choice.chosen);
      if (others.length) box.append(make('p', {}, `As good, as far as these runs can tell: variant${others.length === 1 ? '' : 's'} ${others.join(', ')}.`));
    }
    if (choice.passed_over.length) {
      const list = make('ul', {}, ...choice.passed_over.slice(0, 20).map((each) => make('li', {}, `variant ${each.variant}: `, named(each.why))));
      if (choice.passed_over.length > 20) list.append(make('li', {}, `${choice.passed_over.length - 20} more`));
      box.append(make('details', {}, make('summary', {}, `${choice.passed_over.length} passed over`), list));
    }
    return box;
  }

  private controls(): HTMLElement {
    const filter = make('input', { type: 'search', placeholder: 'filter, such as floors 3', 'aria-label': 'Filter' });
    filter.addEventListener('input', () => {
      this.filter = filter.value;
      this.showTable();
    });
    const asked = make('select', { 'aria-label': 'Question' },
      ...this.study.asked.filter((each) => each !== REJECTED).map((each) => make('option', { value: String(each) }, this.study.questions[each].text)));
    asked.addEventListener('change', () => {
      this.question = Number(asked.value);
      if (typeof this.key === 'object' && 'question' in this.key) this.key = { ...this.key, question: this.question };
      this.showTable();
    });
    return make('div', { class: 'controls' }, filter, asked);
  }

  private select(variant: Variant): void {
    this.selected = variant;
    this.show();
  }

  private show(): void {
    this.showTable();
    this.pareto.replaceChildren(...[paretoPicture(this.study, this.selected, (each) => this.select(each))].filter((each) => each !== null));
    this.showDetails();
  }

  private heading(text: string, key: Key): HTMLElement {
    const same = JSON.stringify(key) === JSON.stringify(this.key);
    const press = () => {
      this.down = same && !this.down;
      this.key = key;
      this.showTable();
    };
    return make('th', { scope: 'col', ...(same ? { 'aria-sort': this.down ? 'descending' : 'ascending' } : {}) },
      button(`${text}${same ? (this.down ? ' ▾' : ' ▴') : ''}`, press, { class: 'sort' }));
  }

  private showTable(): void {
    const { unit } = this.study.questions[this.question];
    const quantiles = this.study.sampled ? [0.1, 0.5, 0.8, 0.95] : [];
    const base = this.study.variants.length > 1 ? comparedWith(this.study) : undefined;
    const rows = rowsOf(this.study, this.filter, this.key, this.down);
    const head = make('tr', {}, this.heading('variant', 'variant'), ...this.study.parameters.map((each) => this.heading(each, { parameter: each })),
      this.heading('rejected', 'rejected'), this.heading(this.study.sampled ? 'mean' : this.study.questions[this.question].text, { question: this.question, of: 'mean' }),
      ...quantiles.map((p) => this.heading(`P${Math.round(100 * p)}`, { question: this.question, of: p })),
      ...(base ? [this.heading(`less variant ${base.variant}`, { question: this.question, of: 'difference' })] : []));
    const body = make('tbody');
    for (const each of rows.slice(0, MOST_ROWS)) {
      const answer = each.answers?.[this.question];
      const row = make('tr', { 'aria-selected': String(each === this.selected), tabindex: '0' });
      const chosen = this.study.choice?.chosen === each.variant;
      row.append(make('td', {}, chosen ? `★ ${each.variant}` : String(each.variant)),
        ...this.study.parameters.map((name) => make('td', {}, named(each.set[name] ?? '', 60))));
      if (each.fault !== undefined) {
        row.append(make('td', { colspan: String(2 + quantiles.length + (base ? 1 : 0)), class: 'bad start' }, named(`cannot run: ${each.fault}`)));
      } else {
        const share = (each.unfinished ?? 0) / (each.runs || 1);
        row.append(make('td', share > 0 ? { class: 'bad' } : {}, shown('share', share, each)), make('td', {}, shown(unit, answer?.quantiles ? answer.mean ?? null : undefined, each)),
          ...quantiles.map((p) => make('td', {}, shown(unit, answer?.quantiles?.find((one) => one.p === p)?.value, each))),
          ...(base ? [make('td', {}, differenceText(unit, answer, each))] : []));
        row.addEventListener('click', () => this.select(each));
        row.addEventListener('keydown', (event) => {
          if (event.key === 'Enter') this.select(each);
        });
      }
      body.append(row);
    }
    const more = rows.length > MOST_ROWS ? [make('p', { class: 'muted' }, `${MOST_ROWS} of ${rows.length} shown: filter for the others`)] : [];
    this.table.replaceChildren(make('table', {}, make('thead', {}, head), body), ...more);
  }

  private showDetails(): void {
    const variant = this.selected;
    const parts: Node[] = [make('h2', {}, `Variant ${variant.variant}: `, named(settings(variant)))];
    if (variant.fault !== undefined) {
      this.details.replaceChildren(...parts, make('p', { class: 'bad' }, named(`cannot run: ${variant.fault}`)));
      return;
    }
    const numbers = make('dl', { class: 'numbers' });
    for (const each of this.study.asked) {
      if (each === REJECTED && !variant.unfinished) continue;
      const { text, unit } = this.study.questions[each];
      const answer = variant.answers?.[each];
      if (!answer?.quantiles) continue;
      const interval = answer.mean_interval;
      const half = interval && interval[0] !== null && interval[1] !== null ? (interval[1] - interval[0]) / 2 : null;
      numbers.append(make('div', {}, make('dt', {}, named(text)), make('dd', {}, shown(unit, answer.mean ?? null, variant),
        ...(half ? [make('small', {}, `mean, ± ${shown(unit === 'moment' ? 's' : unit, half, variant)}`)] : []))));
    }
    const pictures = make('div', { class: 'columns' });
    const add = (title: string, picture: SVGElement | null, note: string) => {
      if (picture) pictures.append(make('figure', {}, make('figcaption', {}, title), picture, make('p', { class: 'muted' }, note)));
    };
    const runs = variant.runs ?? 0;
    add('How sure the time is', sureness(this.study, variant), `Bars: ${runs} runs by their process time. Line: the share that is done by then.`);
    add('Progress', progressPicture(variant), this.study.sampled ? 'Line: the median of the first runs. Band: from P10 to P90.' : 'When which share is done.');
    add('What drives the time', tornado(variant), 'From the mean of the runs in which the duration was in its lowest tenth to that of its highest.');
    add('Critical tasks', criticality(variant), 'The share of runs in which the task is on the critical path.');
    parts.push(numbers);
    if (variant.rejected?.length) {
      parts.push(make('h3', {}, 'Rejected'), make('ul', { class: 'refusals' }, ...variant.rejected.slice(0, 30).map((each) =>
        make('li', {}, make('strong', {}, named(each.task)), this.study.sampled ? ` in ${each.runs} of ${runs} runs, first in run ${each.first_run}` : '',
          ...(each.reason ? [make('br'), named(each.reason)] : [])))));
    }
    parts.push(pictures, ...this.again(variant));
    this.details.replaceChildren(...parts);
  }

  /** How to see single runs: those at the quantiles of the process time. */
  private again(variant: Variant): Node[] {
    if (!variant.again) return [];
    const rows = this.study.sampled
      ? (variant.answers?.[MAKESPAN]?.quantiles ?? []).filter((each) => each.value !== null && each.run !== undefined)
        .map((each) => ({ name: `P${Math.round(100 * each.p)}: ${finishText(variant, each.value!)}`, run: each.run! }))
      : [{ name: 'the run', run: 0 }];
    return [make('h3', {}, 'Watch a run'),
      make('p', { class: 'muted' }, this.study.films?.some((each) => each.variant === variant.variant)
        ? 'Links open the animation of a run. The commands make it again, in the folder of the study: film/report.html.'
        : 'In the folder of the study; film/report.html is its animation.'),
      make('ul', { class: 'commands' }, ...rows.map((row) => {
        const text = `${this.study.sampled ? command(variant, row.run) : variant.again!} --out film`;
        const copy = button('copy', () => void navigator.clipboard?.writeText(text).then(() => { copy.textContent = 'copied'; }), { class: 'link' });
        const film = filmOf(this.study, variant, row.run);
        const name = film ? make('a', { href: film }, row.name) : make('span', { class: 'muted' }, row.name);
        return make('li', {}, name, ' ', make('code', {}, text), ' ', copy);
      }))];
  }
}

function start(): void {
  const root = document.getElementById('study-page')!;
  const text = document.getElementById('study')!.textContent ?? '';
  if (!text.trim()) {
    root.append(make('p', {}, 'There is no study in this page: rubicon study STUDY --out DIR makes one that has.'));
    return;
  }
  new Page(JSON.parse(text) as Study, root);
}

start();
