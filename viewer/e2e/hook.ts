import type { Page } from 'playwright-core';
import type { Player, Selection } from '../src/player';
import type { SiteView } from '../src/view/site_view';

// What tests ask of a page that is open: window.rubicon, see viewer/README.md.

declare global {
  interface Window {
    rubicon?: { player: Player; view: SiteView | null };
  }
}

export type Poses = Record<string, number[]>;

export async function seek(page: Page, time: number): Promise<void> {
  await page.evaluate((t) => window.rubicon?.player.seek(t), time);
}

export async function timeOf(page: Page): Promise<number> {
  return page.evaluate(() => window.rubicon?.player.time ?? Number.NaN);
}

/** World poses of bodies (robot.body) and of components that are on the site, as rows, at the moment shown. */
export async function posesOf(page: Page): Promise<Poses> {
  return page.evaluate(() => {
    const view = window.rubicon?.view;
    if (!view) throw new Error('the page has no view');
    const { bodies, components } = view.poses();
    const states = view.states();
    const there = Object.entries(components).filter(([name]) => states[name] !== 'removed');
    return { ...bodies, ...Object.fromEntries(there) };
  });
}

/** Where something is in the window, null if it is out of sight. */
export async function placeOf(page: Page, what: Selection): Promise<{ x: number; y: number } | null> {
  return page.evaluate((it) => window.rubicon?.view?.whereIs(it) ?? null, what);
}
