import { Clock } from '../clock';
import type { Film } from '../film';
import type { Motion } from '../motion';
import type { Player } from '../player';
import { Runs } from '../runs';
import { mountControls } from './controls';
import { mountGantt } from './gantt';
import { mountGuides } from './guides';
import { listenToKeys } from './keyboard';
import { mountOverview } from './overview';
import type { Page } from './page';
import { mountSide } from './side';
import { mountSteps } from './steps';
import { mountTasks } from './tasks';
import { restoreTheme } from './theme';
import { mountTopBar } from './top_bar';

/** Fills #top, #side and #controls. */
export function mountPanels(film: Film, motion: Motion, player: Player): void {
  restoreTheme();
  document.title = `${film.header.plan.slice(0, 80)} · RUBICON`;
  const searched = film.graphs.length > 0;
  const side = mountSide(element('side'), ['Overview', 'Tasks', 'Gantt', 'Steps', ...(searched ? ['Guides' as const] : [])]);
  const page: Page = { film, motion, player, runs: new Runs(film), clock: new Clock(film.header.start_at, film.schedule?.process_time ?? film.end), open: side.open };
  const overview = mountOverview(side.panel('Overview'), page);
  mountTasks(side.panel('Tasks'), page, side.shows('Tasks'));
  mountGantt(side.panel('Gantt'), page, side.shows('Gantt'));
  mountSteps(side.panel('Steps'), page, side.shows('Steps'));
  if (searched) mountGuides(side.panel('Guides'), page, side.shows('Guides'));
  mountTopBar(element('top'), page, () => {
    side.open('Overview');
    overview.showRefusals();
  });
  mountControls(element('controls'), page);
  listenToKeys(player);
}

function element(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no #${id}`);
  return found;
}
