import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { hasBrowser, openReport, startBrowser } from './browser';
import { command, runPlan } from './result';

// Plans that nobody should meet, and results that somebody made up: they show as text, and nothing of them runs.

const hostile = [
  '<img src=x onerror="document.title=`run`">', '</script><script>document.title="run"</script>', '"><svg onload=alert(1)>',
  "';document.title='run';//", '\u202Etfel ot thgir\u202C', '🏗️👷‍♀️𝔘', '<!--', ']]>', '&lt;b&gt;', '${document.title="run"}', 'x'.repeat(10_000),
];

/** A result whose names of tasks, components, machines, crews and the plan are the hostile ones in turn. */
function renameAll(folder: string): void {
  const trace = readFileSync(join(folder, 'trace.jsonl'), 'utf8');
  const schedule = readFileSync(join(folder, 'schedule.json'), 'utf8');
  const header = JSON.parse(trace.slice(0, trace.indexOf('\n')));
  const names: string[] = [header.plan, ...[...header.robots, ...header.crews, ...header.components, ...header.tasks].map(
    ({ name }: { name: string }) => name)];
  const other = new Map([...new Set(names)].map((name, i) => [name, `${hostile[i % hostile.length]}${i}`]));
  const renamed = (value: unknown): unknown => {
    if (typeof value === 'string') {
      const [robot, ...body] = value.split('.');
      return other.get(value) ?? (body.length > 0 && other.has(robot) ? [other.get(robot), ...body].join('.') : value);
    }
    if (Array.isArray(value)) return value.map(renamed);
    if (typeof value !== 'object' || value === null) return value;
    return Object.fromEntries(Object.entries(value).map(([key, each]) => [key, key === 'text' || key === 'type' ? each : renamed(each)]));
  };
  const lines = trace.trimEnd().split('\n').map((line) => JSON.stringify(renamed(JSON.parse(line))));
  writeFileSync(join(folder, 'trace.jsonl'), `${lines.join('\n')}\n`);
  writeFileSync(join(folder, 'schedule.json'), JSON.stringify(renamed(JSON.parse(schedule))));
}

describe.skipIf(!hasBrowser)('strange plans', () => {
  let browser: Browser;
  beforeAll(async () => { browser = await startBrowser(); });
  afterAll(() => browser.close());

  test('hostile names are text and run nothing', async () => {
    const result = runPlan('taskplans/two_cranes.plan');
    renameAll(result.folder);
    command('report', result.folder);
    for (const [width, height] of [[1280, 720], [1920, 1080]]) {
      const { page, complaints, requests, close } = await openReport(browser, result.report, { width, height });
      expect(await page.title()).toContain('RUBICON');
      const before = await page.title();
      for (const name of ['Overview', 'Tasks', 'Gantt', 'Steps']) {
        await page.getByRole('tab', { name, exact: true }).click();
        await page.evaluate(() => window.rubicon?.player.seek(2000));
        await page.waitForTimeout(200);
        expect(await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight])).toEqual([width, height]);
      }
      const { runs } = await page.evaluate(() => ({ runs: window.rubicon!.player.film.runs.length }));
      for (let run = 0; run < runs; ++run) await page.evaluate((index) => window.rubicon?.player.select({ kind: 'run', index }), run);
      expect(await page.locator('#app img, #app iframe, #app object, #app script').count()).toBe(0);
      expect(await page.title()).toBe(before);
      expect(complaints).toEqual([]);
      expect(requests).toEqual([]);
      await close();
    }
    result.remove();
  });

  test('a plan of nothing', async () => {
    const result = runPlan({ 'plan.plan': 'plan nothing {\n}\n' });
    const { page, complaints, close } = await openReport(browser, result.report);
    for (const name of ['Overview', 'Tasks', 'Gantt', 'Steps']) {
      await page.getByRole('tab', { name, exact: true }).click();
      expect((await page.locator('#side').innerText()).length).toBeGreaterThan(20);
    }
    await page.getByRole('button', { name: /^Play/ }).first().click();
    expect(complaints).toEqual([]);
    await close();
    result.remove();
  });

  test('a plan of which nothing is done', async () => {
    const result = runPlan({
      'plan.plan': `plan refused {
  robot gantry "gantry.robot";
  component block { shape box(0, 0, 0, 1, 1, 1); at trans(3, 0, 0); grip trans(0.5, 0.5, 1); }
  task too_far { by gantry; move block to trans(500, 0, 0); }
  task after_it { by gantry; move block to trans(5, 0, 0); after too_far; }
}
`,
      'gantry.robot': `robot gantry {
  body bridge { param x range(0, 20) step(1) speed(1); frame trans(x, 0, 0); }
  body hoist on bridge { param y range(-5, 5) step(0.5) speed(1); param z range(0, 10) step(0.5) speed(1) start(8); frame trans(0, y, z); }
  tool hoist;
  behaviour "gantry.motion";
}
`,
      'gantry.motion': 'chain { move_to(x, goal(x)) };\nchain { move_to(y, goal(y)) };\nchain { move_to(z, goal(z)) };\n',
    });
    const { page, complaints, close } = await openReport(browser, result.report);
    const badge = page.getByRole('button', { name: '1 rejected, 1 not reached of 2 tasks' });
    await badge.click();
    const side = await page.locator('#side').innerText();
    expect(side).toContain('too_far');
    expect(side).toContain('after_it');
    await page.getByRole('tab', { name: 'Gantt', exact: true }).click();
    await page.getByRole('tab', { name: 'Steps', exact: true }).click();
    expect(complaints).toEqual([]);
    await close();
    result.remove();
  });

  test('terminal, files and page count alike and in the same words', async () => {
    const result = runPlan('examples/08_what_cannot_be_done/site.plan');
    const schedule = JSON.parse(readFileSync(`${result.folder}/schedule.json`, 'utf8'));
    const tasks: { task: string; result: string; tried: number; accepted: number; parking?: boolean }[] = schedule.tasks;
    const planned = tasks.filter(({ parking }) => !parking);
    const count = (wanted: string) => planned.filter((each) => each.result === wanted).length;
    const [rejected, missed] = [count('rejected'), count('not reached')];
    expect(rejected).toBeGreaterThan(0);
    const words = [...(rejected ? [`${rejected} rejected`] : []), ...(missed ? [`${missed} not reached`] : [])].join(', ');
    expect(result.table).toContain(`${count('done')} of ${planned.length} tasks done, ${words}, process time`);
    const { page, complaints, close } = await openReport(browser, result.report);
    await page.getByRole('button', { name: `${words} of ${planned.length} tasks` }).click();
    const side = (await page.locator('#side').innerText()).replace(/\s+/g, ' ').toLowerCase();
    expect(side).toContain(`${count('done')} of ${planned.length}`);
    expect(side).toContain(`not done: ${words}`);
    const [tried, accepted] = [tasks.reduce((sum, each) => sum + each.tried, 0), tasks.reduce((sum, each) => sum + each.accepted, 0)];
    expect(side).toContain(
      `steps tried ${tried.toLocaleString('en-GB')} ${accepted.toLocaleString('en-GB')} accepted`);
    expect(complaints).toEqual([]);
    await close();
    result.remove();
  });

  test('the sum of waits says that it is one', async () => {
    const result = runPlan('taskplans/two_cranes.plan');
    const schedule = JSON.parse(readFileSync(`${result.folder}/schedule.json`, 'utf8'));
    for (const { waited } of schedule.tasks) {
      expect(waited.resource + waited.machine + waited.shift).toBeLessThanOrEqual(schedule.process_time);
    }
    const { page, close } = await openReport(browser, result.report);
    const side = (await page.locator('#side').innerText()).toLowerCase();
    expect(side).toContain('sum over tasks');
    expect(side).toContain('the sum over all of them may be longer than the plan');
    await close();
    result.remove();
  });

  test.each(['tasks', 'none'])('a trace with detail %s says what is missing', async (detail) => {
    const result = runPlan('taskplans/people_below.plan', '--trace-detail', detail);
    const { page, complaints, close } = await openReport(browser, result.report);
    await page.getByRole('tab', { name: 'Steps', exact: true }).click();
    expect(await page.locator('#side').innerText()).toMatch(/--trace-detail|no tasks/);
    expect(complaints).toEqual([]);
    await close();
    result.remove();
  });
});
