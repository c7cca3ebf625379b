import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { hasBrowser, openReport, startBrowser } from './browser';
import { posesOf, seek } from './hook';
import { readTrace, runPlan } from './result';
import { TracePoses } from './trace_poses';

// The film shows what the trace tells: poses on the page against a second reading of the trace.

/** Metres, and parts of a rotation matrix. Values are kept to 1e-6, turns act over tens of metres. */
const near = 1e-5;

describe.skipIf(!hasBrowser)('poses', () => {
  let browser: Browser;
  beforeAll(async () => { browser = await startBrowser(); });
  afterAll(() => browser.close());

  const plans = ['taskplans/two_cranes.plan', 'taskplans/three_tow_motors.plan', 'taskplans/people_below.plan',
    'examples/08_what_cannot_be_done/site.plan', 'examples/05_level_bucket/site.plan'];
  test.each(plans)('of %s are those of the trace', async (plan) => {
    const result = runPlan(plan);
    const trace = new TracePoses(readTrace(result));
    const { page, complaints, close } = await openReport(browser, result.report);
    // Ten moments, none of them a round one; forward, then two of them again.
    const shares = [0, 0.037, 0.11, 0.213, 0.34, 0.457, 0.58, 0.701, 0.83, 0.999, 0.213, 0.037];
    for (const share of shares) {
      const time = share * trace.end;
      await seek(page, time);
      const shown = await posesOf(page);
      const told = trace.at(time);
      expect(Object.keys(shown).sort()).toEqual(Object.keys(told).sort());
      for (const [name, pose] of Object.entries(told)) {
        const off = Math.max(...pose.map((value, i) => Math.abs(value - shown[name][i])));
        expect(off, `${name} at ${time} s`).toBeLessThan(near);
      }
    }
    expect(complaints).toEqual([]);
    await close();
    result.remove();
  });
});
