import './styles.css';
import { readFilm } from './film';
import { Motion } from './motion';
import { mountPanels } from './panels/mount';
import { Player } from './player';
import { openSiteView } from './view/open';
import type { SiteView } from './view/site_view';

declare global {
  interface Window {
    /** What tests of whole pages ask: see SiteView.poses, states, stats and whereIs. */
    rubicon?: { player: Player; view: SiteView | null };
  }
}

async function open(): Promise<void> {
  const film = await readFilm(document.getElementById('film')?.textContent ?? '');
  const player = new Player(film);
  const motion = new Motion(film);
  const host = document.getElementById('view');
  const view = host && openSiteView(host, film, motion, player);
  mountPanels(film, motion, player);
  window.rubicon = { player, view };
  document.documentElement.dataset.ready = '';
  let last = performance.now();
  const frame = (now: number) => {
    // Where a picture takes long the animation keeps its length; where the page was out of sight it stood still.
    player.tick(Math.min((now - last) / 1000, 1));
    last = now;
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}

open().catch((error: unknown) => {
  const view = document.getElementById('view');
  if (view) view.textContent = `This report cannot be shown: ${error instanceof Error ? error.message : String(error)}`;
});
