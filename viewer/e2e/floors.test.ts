import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { hasBrowser, openReport, startBrowser } from './browser';
import { runPlan } from './result';

// The steps of a way over an area: a button each, and something to see.

describe.skipIf(!hasBrowser)('the steps of a way over an area', () => {
  let browser: Browser;
  beforeAll(async () => {
    browser = await startBrowser();
  });
  afterAll(() => browser.close());

  test('are shown one by one, and hidden again', async () => {
    const result = runPlan('examples/18_cover_a_floor/site.plan');
    const { page, complaints } = await openReport(browser, result.report);
    await page.getByRole('button', { name: 'Top', exact: true }).click();
    await page.waitForTimeout(600);
    // The view without its buttons.
    const box = await page.locator('.view-canvas').boundingBox();
    if (!box) throw new Error('there is no view');
    const shoot = () => page.screenshot({ clip: { x: box.x + 80, y: box.y + 90, width: box.width - 90, height: box.height - 180 } });
    const plain = await shoot();
    const seen = [plain.toString('base64')];
    for (const name of ['Beams', 'Cells', 'Adjacency', 'Order', 'Lines']) {
      const button = page.getByRole('button', { name, exact: true });
      await button.click();
      expect(await button.getAttribute('aria-pressed')).toBe('true');
      await page.waitForTimeout(200);
      const picture = (await shoot()).toString('base64');
      expect(seen).not.toContain(picture);
      seen.push(picture);
      await button.click();
      expect(await button.getAttribute('aria-pressed')).toBe('false');
    }
    await page.waitForTimeout(200);
    expect((await shoot()).equals(plain)).toBe(true);
    expect(complaints).toEqual([]);
    result.remove();
  });

  test('have no buttons where nothing is covered', async () => {
    const result = runPlan('examples/02_over_the_wall/site.plan');
    const { page } = await openReport(browser, result.report);
    expect(await page.getByRole('button', { name: 'Zones', exact: true }).count()).toBe(1);
    expect(await page.getByRole('button', { name: 'Cells', exact: true }).count()).toBe(0);
    result.remove();
  });
});
