import { statSync } from 'node:fs';
import { performance } from 'node:perf_hooks';
import { expect, test } from 'vitest';
import { hasBrowser, openReport, startBrowser } from '../e2e/browser';
import { readTrace, runPlan } from '../e2e/result';
import { blockPlan } from './block_plan';

// Figures of docs/benchmarks.md: how big a report is, how long it takes to open, how smoothly it plays, all with software rendering.
// `npm run bench` prints them; a machine at work makes them worse.

const sizes = [
  { panels: 2_000, steps: 100 },
  { panels: 10_000, steps: 100 },
];

test.skipIf(!hasBrowser)('big reports', { timeout: 1_800_000 }, async () => {
  for (const { panels, steps } of sizes) {
    const result = runPlan(blockPlan(panels, steps));
    const tries = readTraceTries(result);
    const megabytes = statSync(result.report).size / 1e6;
    const browser = await startBrowser();
    const begin = performance.now();
    const opened = await openReport(browser, result.report);
    const seconds = (performance.now() - begin) / 1000;
    const rate = await opened.page.evaluate(async () => {
      const hook = (window as unknown as { rubicon: { player: { setSpeed(x: number): void; play(): void } } }).rubicon;
      hook.player.setSpeed(60);
      hook.player.play();
      const frames: number[] = [];
      await new Promise<void>((done) => {
        const frame = (now: number) => {
          frames.push(now);
          if (now - frames[0] > 5000) done();
          else requestAnimationFrame(frame);
        };
        requestAnimationFrame(frame);
      });
      return ((frames.length - 1) * 1000) / (frames[frames.length - 1] - frames[0]);
    });
    console.log(`${panels} elements, ${tries} steps: report ${megabytes.toFixed(2)} MB, opens in ${seconds.toFixed(2)} s, `
      + `plays at ${rate.toFixed(1)} frames a second`);
    expect(opened.complaints).toEqual([]);
    await opened.close();
    await browser.close();
    result.remove();
  }
});

function readTraceTries(result: Parameters<typeof readTrace>[0]): number {
  return readTrace(result).reduce((sum, record) => sum + (record.type === 'end' ? (record.tries as number) : 0), 0);
}
