import type { Clock } from '../clock';
import type { Film } from '../film';
import type { Motion } from '../motion';
import type { Player } from '../player';
import type { Runs } from '../runs';

export type TabName = 'Overview' | 'Tasks' | 'Gantt' | 'Steps' | 'Guides';

/** What every panel works with. */
export interface Page {
  film: Film;
  motion: Motion;
  player: Player;
  runs: Runs;
  clock: Clock;
  open(tab: TabName): void;
}

/** Picks a run and goes to its beginning; of a rejected one to the attempt for which it was. */
export function goToRun({ film, player, runs }: Page, run: number): void {
  player.pause();
  player.select({ kind: 'run', index: run });
  const refused = film.runs[run].result === 'rejected' ? runs.refusedAt(run) : -1;
  if (refused >= 0) player.goToRecord(refused);
  else player.seek(film.runs[run].start);
}

/** Picks a run and puts the debugger at one of its records, if it has any. */
export function goToStep(page: Page, run: number, record: number): void {
  page.player.pause();
  page.player.select({ kind: 'run', index: run });
  if (record >= 0) page.player.goToRecord(record);
  page.open('Steps');
}
