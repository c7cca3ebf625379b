import type { Film } from '../film';
import type { Motion } from '../motion';
import type { Player } from '../player';
import { make } from './elements';
import { SiteView } from './site_view';

/** The 3D view, or, where it cannot be, a note in its place that says why: the rest of the page works without. */
export function openSiteView(host: HTMLElement, film: Film, motion: Motion, player: Player): SiteView | null {
  let why = 'this browser has no WebGL 2, or it is switched off';
  try {
    if (document.createElement('canvas').getContext('webgl2')) return new SiteView(host, film, motion, player);
  } catch (error) {
    why = error instanceof Error ? error.message : String(error);
  }
  const note = `The site cannot be shown in 3D: ${why}. Schedule, numbers and steps are there without it.`;
  host.replaceChildren(make('p', 'view-note', note));
  return null;
}
