import type { Runs } from './runs';

/** A row of the table of tasks; times in s, null: not known. */
export interface TableRow {
  run: number;
  name: string;
  who: string;
  start: number;
  duration: number | null;
  motion: number | null;
  work: number | null;
  /** For machines and crews that were busy, on its way, for shifts: not for the tasks before it. */
  waits: number | null;
  /** Total float: how much later it could be done and the plan end as it does. */
  float: number | null;
  cost: number | null;
  result: string;
  reason: string;
}

export type SortKey = Exclude<keyof TableRow, 'run' | 'reason'>;

export function tableRows(runs: Runs): TableRow[] {
  return runs.all.map((run, i) => {
    const row = runs.row(i);
    const waited = row ? row.waited.resource + row.waited.machine + row.waited.shift + (row.waited.repair ?? 0) : null;
    const crew = row?.crew ?? '';
    const machine = runs.machine(i);
    return {
      run: i, name: run.task, who: machine && crew ? `${machine}, ${crew}` : machine || runs.who(i), start: run.start,
      duration: row?.duration ?? (run.happened ? runs.end(i) - run.start : null),
      motion: row?.motion ?? null, work: row?.work ?? null, waits: waited,
      float: row?.float?.total ?? null, cost: row?.cost ?? null, result: run.result || row?.result || 'done', reason: run.reason,
    };
  });
}

/** The rows in which every word of a query is found, whatever its case. */
export function filtered(rows: TableRow[], query: string): TableRow[] {
  const words = query.toLowerCase().split(/\s+/).filter((word) => word !== '');
  if (words.length === 0) return rows;
  return rows.filter((row) => {
    const text = `${row.name} ${row.who} ${row.result} ${row.reason}`.toLowerCase();
    return words.every((word) => text.includes(word));
  });
}

/** In order of a column; what is not known comes last, equals stay as they were. */
export function sorted(rows: TableRow[], key: SortKey, down: boolean): TableRow[] {
  const names = new Intl.Collator('en', { numeric: true });
  const by = (a: TableRow, b: TableRow) => {
    const [left, right] = [a[key], b[key]];
    if (left === null || right === null) return (left === null ? 1 : 0) - (right === null ? 1 : 0);
    const order = typeof left === 'string' ? names.compare(left, String(right)) : left - Number(right);
    return down ? -order : order;
  };
  return [...rows].sort(by);
}
