import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { hasBrowser, openReport, startBrowser, type Opened } from './browser';
import { seek } from './hook';
import { runPlan, type Result } from './result';

// A way that lies in the face of the ground: seen from above all of it, behind a thin wall nothing of it.

const files = {
  'plan.plan': `plan along_the_wall {
  robot cart "cart.robot" at rotz(20);
  site box(-200, -200, -0.5, 260, 200, 0);
  site box(-5, -0.5, 0, 65, -0.4, 6);
  support off;
  task along { by cart; go x 60; }
}
`,
  'cart.robot': `robot cart {
  body base { param x range(0, 60) step(1) speed(1); frame trans(x, 0, 0); shape box(-0.3, -0.3, 0.2, 0.3, 0.3, 1); }
  tool base;
  behaviour "cart.motion";
}
`,
  'cart.motion': 'chain { move_to(x, goal(x)) };\n',
};

describe.skipIf(!hasBrowser)('lines on the ground', () => {
  let browser: Browser;
  let result: Result;
  let opened: Opened;
  let page: Page;
  let blank: Page;

  beforeAll(async () => {
    browser = await startBrowser();
    result = runPlan(files);
    opened = await openReport(browser, result.report);
    page = opened.page;
    blank = await browser.newPage();
    await seek(page, 59.9);
  });
  afterAll(async () => {
    expect(opened.complaints).toEqual([]);
    await browser.close();
    result.remove();
  });

  /** How many pixels of each column of the view the button Paths changes. */
  async function changedBy(view: string, nearer: number): Promise<number[]> {
    await page.getByRole('button', { name: view, exact: true }).click();
    const box = await page.locator('.view-canvas').boundingBox();
    if (!box) throw new Error('there is no view');
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    for (let i = 0; i < nearer; ++i) await page.mouse.wheel(0, -120);
    await page.waitForTimeout(1200);
    const shoot = async () => (await page.screenshot({ clip: { x: box.x + 80, y: box.y + 90, width: box.width - 90, height: box.height - 180 } })).toString('base64');
    const pictures = [await shoot()];
    const button = page.getByRole('button', { name: 'Paths', exact: true });
    await button.click();
    await page.waitForTimeout(600);
    pictures.push(await shoot());
    await button.click();
    return blank.evaluate(async (both) => {
      const pixels = await Promise.all(both.map(async (text) => {
        const picture = await createImageBitmap(await (await fetch(`data:image/png;base64,${text}`)).blob());
        const pen = new OffscreenCanvas(picture.width, picture.height).getContext('2d')!;
        pen.drawImage(picture, 0, 0);
        return pen.getImageData(0, 0, picture.width, picture.height);
      }));
      const { width, height } = pixels[0];
      return Array.from({ length: width }, (_, x) => {
        let count = 0;
        for (let y = 0; y < height; ++y) {
          const at = 4 * (y * width + x);
          if ([0, 1, 2].some((i) => Math.abs(pixels[0].data[at + i] - pixels[1].data[at + i]) > 24)) ++count;
        }
        return count;
      });
    }, pictures);
  }

  test.each([0, 6])('are whole from above, the wheel turned by %i', async (nearer) => {
    const columns = await changedBy('Top', nearer);
    const seen = columns.flatMap((count, x) => (count > 0 ? [x] : []));
    expect(seen.length).toBeGreaterThan(300);
    expect(seen.length).toBe(seen[seen.length - 1] - seen[0] + 1);
    // As thick as drawn, all along: nowhere half below the ground.
    const inner = columns.slice(seen[2], seen[seen.length - 3]);
    expect(Math.min(...inner)).toBeGreaterThanOrEqual(2);
  });

  test('do not shine through a wall', async () => {
    expect(Math.max(...await changedBy('Front', 0))).toBe(0);
  });
});
