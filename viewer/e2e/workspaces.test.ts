import { readFileSync } from 'node:fs';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { readFilm } from '../src/film';
import { poseMatrix } from '../src/kinematics';
import { Motion } from '../src/motion';
import { Workspaces, type Flat } from '../src/workspaces';
import { Vector3 } from 'three';
import { hasBrowser, openReport, startBrowser } from './browser';
import { seek } from './hook';
import { runPlan, type Result } from './result';

// What a machine would sweep until it stands: the page finds it by itself, of the film.

/** Whether two convex outlines, counter-clockwise, have more in common than `edge` m. */
function overlap(a: Flat[], b: Flat[], edge: number): boolean {
  const parted = (one: Flat[], other: Flat[]) => one.some((from, i) => {
    const to = one[(i + 1) % one.length];
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    return other.every(([x, y]) => ((to[1] - from[1]) * (x - from[0]) - (to[0] - from[0]) * (y - from[1])) / length >= -edge);
  });
  return !parted(a, b) && !parted(b, a);
}

describe('dynamic workspaces', () => {
  let result: Result;
  beforeAll(() => { result = runPlan('taskplans/dew.plan'); });
  afterAll(() => result.remove());

  test('never overlap, and come as near as what stopped a machine', async () => {
    const text = /<script type="text\/plain" id="film">([^<]*)</.exec(readFileSync(result.report, 'utf8'));
    const film = await readFilm(text?.[1] ?? '');
    const boxes = film.header.robots.map(({ bodies }) => bodies.map(({ shapes }) => shapes.flatMap(({ pose, lower = [], upper = [] }) =>
      [0, 1, 2, 3, 4, 5, 6, 7].map((i): [number, number, number] =>
        new Vector3(...[0, 1, 2].map((axis) => ((i >> axis) & 1 ? upper : lower)[axis])).applyMatrix4(poseMatrix(pose)).toArray()))));
    const spaces = new Workspaces(film, new Motion(film), (robot, body) => boxes[robot][body]);
    let overlaps = 0;
    let moments = 0;
    const met = (a: Flat[][], b: Flat[][], edge: number) => a.some((one) => b.some((other) => overlap(one, other, edge)));
    for (let time = 0; time < film.end; time += 0.05, ++moments) if (met(spaces.at(0, time), spaces.at(1, time), 1e-4)) ++overlaps;
    expect(moments).toBeGreaterThan(900);
    expect(overlaps).toBe(0);
    expect(spaces.stops.map(({ robot, by }) => [robot, by])).toEqual([[1, 0], [1, 0], [0, -1]]);
    // Had lorry 2 gone on when it was stopped, one step more of lorry 1, which goes first, would have met it.
    const [first] = spaces.stops;
    expect(met(spaces.at(0, first.from + 0.4), spaces.wantedBy(first) ?? [], 1e-4)).toBe(true);
  });

  describe.skipIf(!hasBrowser)('on the page', () => {
    let browser: Browser;
    beforeAll(async () => { browser = await startBrowser(); });
    afterAll(() => browser.close());

    test('are drawn and hidden', async () => {
      const { page, complaints } = await openReport(browser, result.report);
      await page.getByRole('button', { name: 'Top', exact: true }).click();
      await seek(page, 16.4);
      await page.waitForTimeout(600);
      const box = await page.locator('.view-canvas').boundingBox();
      if (!box) throw new Error('there is no view');
      const shoot = () => page.screenshot({ clip: { x: box.x + 80, y: box.y + 90, width: box.width - 90, height: box.height - 180 } });
      const drawn = await shoot();
      const button = page.getByRole('button', { name: 'Workspaces', exact: true });
      await button.click();
      await page.waitForTimeout(200);
      expect((await shoot()).equals(drawn)).toBe(false);
      await button.click();
      await page.waitForTimeout(200);
      expect((await shoot()).equals(drawn)).toBe(true);
      expect(complaints).toEqual([]);
    });
  });
});
