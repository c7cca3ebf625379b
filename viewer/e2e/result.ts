import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

export const root = resolve(__dirname, '../..');

/** The command under test: RUBICON, else the release build. */
export const rubicon = process.env.RUBICON ?? join(root, 'build/release/bin/rubicon');

export interface Result {
  folder: string;
  report: string;
  /** What the command printed. */
  table: string;
  remove(): void;
}

/** Runs a plan (a path from the project's folder, or files to write with plan.plan among them) into a new folder. */
export function runPlan(plan: string | Record<string, string>, ...options: string[]): Result {
  const folder = mkdtempSync(join(tmpdir(), 'rubicon-report-'));
  let path = typeof plan === 'string' ? join(root, plan) : join(folder, 'plan.plan');
  if (typeof plan !== 'string') {
    for (const [name, text] of Object.entries(plan)) writeFileSync(join(folder, name), text);
    path = join(folder, 'plan.plan');
  }
  const run = spawnSync(rubicon, ['run', path, '--out', folder, ...options], { encoding: 'utf8', maxBuffer: 1 << 28 });
  // 1: a task was rejected, which some of these plans want.
  if (run.status !== 0 && run.status !== 1) throw new Error(`rubicon run ${path}: exit code ${run.status}\n${run.stderr}`);
  return { folder, report: join(folder, 'report.html'), table: run.stdout, remove: () => rmSync(folder, { recursive: true }) };
}

/** The records of a result's trace, the header first. */
export function readTrace(result: Result): Record<string, unknown>[] {
  return readFileSync(join(result.folder, 'trace.jsonl'), 'utf8').trimEnd().split('\n').map((line) => JSON.parse(line));
}

export function command(...words: string[]): string {
  return execFileSync(rubicon, words, { encoding: 'utf8' });
}
