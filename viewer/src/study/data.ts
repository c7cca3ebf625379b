import { Clock, hours, money } from '../clock';

/** A study as `rubicon study --format json` writes it (docs/studies.md). Numbers that are not finite are null. */
export interface Interval { 0: number | null; 1: number | null }

export interface Quantile { p: number; value: number | null; interval: Interval; run?: number }

export interface Answer {
  finished?: number;
  mean?: number;
  mean_interval?: Interval;
  deviation?: number;
  least?: number;
  most?: number;
  quantiles?: Quantile[];
  /** This less the first variant that runs, run by run. */
  difference?: { mean: number; interval?: Interval; runs: number };
}

export interface Variant {
  variant: number;
  set: Record<string, string>;
  fault?: string;
  again?: string;
  start_at?: string;
  currency?: string;
  runs?: number;
  unfinished?: number;
  answers?: Answer[];
  critical?: { task: string; runs: number }[];
  drivers?: { duration: string; correlation: number; low?: number; high?: number }[];
  rejected?: { task: string; runs: number; first_run: number; reason?: string }[];
  progress?: { p10: number[]; p50: number[]; p90: number[] };
  histogram?: number[];
}

export type Unit = 's' | 'moment' | 'money' | 'share' | 'number';

export interface Choice {
  direction: string;
  statistic: string;
  with: string[];
  chosen?: number;
  equal: number[];
  passed_over: { variant: number; why: string }[];
}

export interface Study {
  study: string;
  plan: string;
  design: string;
  sampled: boolean;
  runs: number;
  until?: string;
  seed?: number;
  questions: { text: string; unit: Unit }[];
  asked: number[];
  parameters: string[];
  variants: Variant[];
  pareto: number[];
  choice?: Choice;
  /** Runs whose results are kept, each in a folder. */
  films?: { variant: number; run: number; folder: string }[];
}

/** The first questions of every study. */
export const MAKESPAN = 0;
export const COST = 1;
export const REJECTED = 2;

/** h:mm:ss, rounded. */
export function clock(seconds: number): string {
  const whole = Math.round(Math.abs(seconds));
  return (seconds < 0 && whole > 0 ? '-' : '') + hours(whole);
}

/** The date so many seconds after "YYYY-MM-DD HH:MM", down to its minute; there are no time zones. */
export function moment(start: string, seconds: number): string {
  const at = new Clock(start).epoch / 60 + Math.floor(seconds / 60 + 1e-9);
  return new Date(at * 60000).toISOString().slice(0, 16).replace('T', ' ');
}

/** A number for people. */
export function shown(unit: Unit, value: number | null | undefined, variant: Variant): string {
  if (value === undefined) return '–';
  if (value === null) return 'never';
  if (unit === 'money') return money(value, '');
  if (unit === 'number') return value.toFixed(3);
  if (unit === 'share') return `${(100 * value).toFixed(1)} %`;
  if (unit === 'moment' && variant.start_at) return moment(variant.start_at, value);
  return clock(value);
}

/** How much more or less than the first variant that runs, with half of its 95 % interval where there is one. */
export function differenceText(unit: Unit, answer: Answer | undefined, variant: Variant): string {
  const difference = answer?.difference;
  if (!difference) return '';
  const of = unit === 'moment' ? 's' : unit;
  const text = `${difference.mean > 0 ? '+' : ''}${shown(of, difference.mean, variant)}`;
  const [low, high] = [difference.interval?.[0], difference.interval?.[1]];
  return low == null || high == null ? text : `${text} ± ${shown(of, (high - low) / 2, variant)}`;
}

/** The variant with which the others are compared. */
export function comparedWith(study: Study): Variant | undefined {
  return study.variants.find((each) => (each.runs ?? 0) > 0);
}

/** What a variant sets, in one line. */
export function settings(variant: Variant): string {
  const parts = Object.entries(variant.set).map(([name, value]) => `${name} ${value}`);
  return parts.length ? parts.join(', ') : 'as the plan says';
}

/** The command for one run of a variant; `again` is that of run 0. */
export function command(variant: Variant, run: number): string {
  return (variant.again ?? '').replace(/:0$/, `:${run}`);
}

/** The page of a run that is kept, undefined: it is not. */
export function filmOf(study: Study, variant: Variant, run: number): string | undefined {
  const film = study.films?.find((each) => each.variant === variant.variant && each.run === run);
  return film && `${film.folder}/report.html`;
}

/** The one to be shown first: the chosen, else the fastest of the Pareto front, else the first that runs. */
export function firstShown(study: Study): Variant {
  const number = study.choice?.chosen ?? study.pareto[0];
  return study.variants.find((each) => each.variant === number)
    ?? study.variants.find((each) => (each.runs ?? 0) > (each.unfinished ?? 0))
    ?? study.variants[0];
}

/** What the table sorts by: columns are settings by name, or numbers of a question. */
export type Key = { parameter: string } | { question: number; of: 'mean' | 'difference' | number } | 'variant' | 'rejected';

/** The number or text of a variant in a column; what is not there comes last. */
export function cell(variant: Variant, key: Key): number | string | undefined {
  if (key === 'variant') return variant.variant;
  if (key === 'rejected') return variant.runs ? (variant.unfinished ?? 0) / variant.runs : undefined;
  if ('parameter' in key) {
    const text = variant.set[key.parameter];
    const number = Number.parseFloat(text);
    return Number.isNaN(number) ? text : number;
  }
  const answer = variant.answers?.[key.question];
  if (!answer?.quantiles) return undefined;
  if (key.of === 'mean') return answer.mean;
  if (key.of === 'difference') return answer.difference?.mean;
  const value = answer.quantiles.find((each) => each.p === key.of)?.value;
  return value === null ? Infinity : value;
}

/** Variants whose settings hold all words of the filter ("floors 3"), in the order of a column. */
export function rowsOf(study: Study, filter: string, key: Key, down: boolean): Variant[] {
  const words = filter.toLowerCase().split(/\s+/).filter(Boolean);
  const found = study.variants.filter((each) => {
    const text = `${each.variant} ${settings(each)}`.toLowerCase();
    return words.every((word) => text.includes(word));
  });
  const sign = down ? -1 : 1;
  return found.sort((a, b) => {
    const x = cell(a, key);
    const y = cell(b, key);
    if (x === undefined || y === undefined) return Number(x === undefined) - Number(y === undefined) || a.variant - b.variant;
    const order = typeof x === 'number' && typeof y === 'number' ? x - y : String(x).localeCompare(String(y), 'en');
    return (Number.isNaN(order) ? 0 : sign * order) || a.variant - b.variant;
  });
}
