import { readFileSync } from 'node:fs';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { hasBrowser, openReport, startBrowser, type Opened } from './browser';
import { placeOf, posesOf, seek, timeOf } from './hook';
import { readTrace, runPlan, type Result } from './result';

// A real report, used as people use it.

describe.skipIf(!hasBrowser)('the page', () => {
  let browser: Browser;
  let result: Result;
  let opened: Opened;
  let page: Page;
  const tab = (name: string) => page.getByRole('tab', { name, exact: true }).click();
  const press = (name: string | RegExp) => page.getByRole('button', { name }).first().click();

  beforeAll(async () => {
    browser = await startBrowser();
    result = runPlan('taskplans/two_cranes.plan');
    opened = await openReport(browser, result.report);
    page = opened.page;
  });
  afterAll(async () => {
    expect(opened.complaints).toEqual([]);
    expect(opened.requests).toEqual([]);
    await browser.close();
    result.remove();
  });

  test('shows the numbers of the schedule', async () => {
    const schedule = JSON.parse(readFileSync(`${result.folder}/schedule.json`, 'utf8'));
    const top = await page.locator('#top').innerText();
    expect(top).toContain('two_cranes');
    expect(top).toContain('feasible: all 18 tasks done');
    expect(top).toContain('Mon 4 May 2026 13:02');
    const seconds = Math.round(schedule.process_time);
    expect(top).toContain(`${Math.floor(seconds / 3600)}:${String(Math.floor(seconds / 60) % 60).padStart(2, '0')}`);
    expect(top).toContain(schedule.cost.toLocaleString('en', { minimumFractionDigits: 2 }));
    await tab('Tasks');
    const first = page.getByRole('row').filter({ hasText: 'set_wall_1' }).first();
    expect(await first.isVisible()).toBe(true);
  });

  test('has all of it in reach on a phone', async () => {
    const phone = await openReport(browser, result.report, { width: 390, height: 844 });
    const within = async (what: string) => {
      const box = await phone.page.locator(what).first().boundingBox();
      expect(box, what).not.toBeNull();
      expect(box!.x, what).toBeGreaterThanOrEqual(0);
      expect(box!.x + box!.width, what).toBeLessThanOrEqual(390);
      expect(box!.y + box!.height, what).toBeLessThanOrEqual(844);
      expect(Math.min(box!.width, box!.height), what).toBeGreaterThan(10);
    };
    for (const what of ['#view canvas', '#side', '#top dd >> nth=-1', '#top button >> nth=-1', '.clock', '#controls select']) await within(what);
    for (const name of ['Tasks', 'Gantt', 'Steps']) {
      await phone.page.getByRole('tab', { name, exact: true }).click();
      await within('[role=tabpanel]:not([hidden])');
    }
    expect(phone.complaints).toEqual([]);
    await phone.close();
  });

  test('plays, pauses, stops, and goes from component to component', async () => {
    await seek(page, 0);
    await press(/^Play/);
    await page.waitForFunction(() => (window.rubicon?.player.time ?? 0) > 5);
    await press(/^Pause/);
    const paused = await timeOf(page);
    await page.waitForTimeout(300);
    expect(await timeOf(page)).toBe(paused);

    await seek(page, 0); // a busy machine may have played past the first component
    await press(/^Next component/);
    const placed = readTrace(result).filter((record) => record.type === 'detach').map((record) => record.t as number);
    placed.sort((a, b) => a - b);
    expect(await timeOf(page)).toBeCloseTo(placed[0], 5);
    await press(/^Next component/);
    expect(await timeOf(page)).toBeCloseTo(placed[1], 5);
    await press(/^Previous component/);
    expect(await timeOf(page)).toBeCloseTo(placed[0], 5);

    await press(/^Fast play/);
    await page.waitForFunction((t) => (window.rubicon?.player.time ?? 0) > t, placed[3]);
    expect(await page.evaluate(() => window.rubicon?.player.fast)).toBe(true);
    await press(/^Stop/);
    expect(await timeOf(page)).toBe(0);
    expect(await page.evaluate(() => window.rubicon?.player.fast)).toBe(false);
  });

  test('hears the keys', async () => {
    await page.locator('#view').click({ position: { x: 5, y: 560 } });
    await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
    await page.keyboard.press('End');
    expect(await timeOf(page)).toBe(await page.evaluate(() => window.rubicon?.player.end));
    await page.keyboard.press('Home');
    expect(await timeOf(page)).toBe(0);
    await page.keyboard.press('ArrowRight');
    const one = await timeOf(page);
    expect(one).toBeGreaterThan(0);
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowLeft');
    expect(await timeOf(page)).toBe(one);
    await page.keyboard.press(' ');
    expect(await page.evaluate(() => window.rubicon?.player.playing)).toBe(true);
    await page.keyboard.press(' ');
    expect(await page.evaluate(() => window.rubicon?.player.playing)).toBe(false);
    const length = () => page.evaluate(() => window.rubicon?.player.length);
    expect(await length()).toBe(60);
    await page.keyboard.press('ArrowUp');
    expect(await length()).toBe(30);
    for (const next of [60, 180, 'real', 'real']) {
      await page.keyboard.press('ArrowDown');
      expect(await length()).toBe(next);
    }
    await page.getByLabel('Length of the animation').selectOption('1 min');
    expect(await length()).toBe(60);
  });

  test('draws the way that a guide walked, by its mode', async () => {
    const yard = runPlan('taskplans/yard_without_map.plan');
    const look = await openReport(browser, yard.report);
    const legend = look.page.locator('.view-legend');
    const modes: string[] = [];
    const end = await look.page.evaluate(() => window.rubicon?.player.end ?? 0);
    for (let time = 1; time < end; time += 4) {
      await seek(look.page, time);
      await look.page.waitForTimeout(60);
      const now = await legend.locator('.view-now').allInnerTexts();
      expect(now).toHaveLength(1);
      if (modes.at(-1) !== now[0]) modes.push(now[0]);
    }
    // Into the store, along its wall, in its trap out of it; then one thing after the other.
    expect(modes.slice(0, 4)).toEqual(['towards', 'searching', 'tracking', 'towards']);
    expect(await legend.innerText()).toContain('line to the destination');
    await look.page.getByRole('button', { name: 'Paths' }).click();
    await expect.poll(() => legend.isVisible()).toBe(false);
    expect(look.complaints).toEqual([]);
    await look.close();
    yard.remove();
  });

  test('shows what a guide searched through, with a slider for a third parameter', async () => {
    expect(await page.getByRole('tab', { name: 'Guides' }).count()).toBe(0);
    const trench = runPlan('taskplans/trench.plan', '--trace-detail', 'full');
    const look = await openReport(browser, trench.report);
    await seek(look.page, 8);
    await look.page.getByRole('tab', { name: 'Guides' }).click();
    const panel = look.page.locator('.guides');
    const guide = readTrace(trench).find((record) => record.type === 'guide' && record.task === 'to_truck_1');
    expect(await panel.locator('h2').innerText()).toBe(`to_truck_1 (${guide?.legs} legs searched)`);
    const [now, ring, near] = [panel.locator('.now'), panel.locator('.ring'), panel.locator('.near')];
    const before = [await now.getAttribute('cx'), await ring.first().getAttribute('cx'), await near.getAttribute('d')];
    await panel.getByLabel('Value of the third parameter').fill('120');
    await seek(look.page, 10);
    await expect.poll(() => now.getAttribute('cx')).not.toBe(before[0]);
    expect(await ring.first().getAttribute('cx')).not.toBe(before[1]);
    expect(await near.getAttribute('d')).not.toBe(before[2]);
    // Where the robot may not stand: of the search's own parameters, in the layer that is nearest to the slider.
    const grid = readTrace(trench).find((record) => record.type === 'forbidden' && record.task === 'to_truck_1');
    const [region, cells] = [panel.locator('.region'), panel.locator('path.forbidden')];
    const sampled = grid?.parameters as string[];
    expect(sampled).toEqual(await Promise.all(['Across', 'Up', 'Slider'].map((name) =>
      panel.getByLabel(name, { exact: true }).locator('option:checked').innerText())));
    const told = async () => [await region.innerText(), (await cells.count()) ? await cells.getAttribute('d') : null];
    const [words, shape] = await told();
    expect(words).toContain(`forbidden at ${sampled[2]} `);
    await panel.getByLabel('Value of the third parameter').fill('40');
    expect((await told())[0]).not.toBe(words);
    expect((await told())[1]).not.toBe(shape);
    const [file] = await Promise.all([look.page.waitForEvent('download'), panel.getByRole('button', { name: 'Export SVG' }).click()]);
    const svg = readFileSync((await file.path())!, 'utf8');
    expect(svg).toContain('fill="rgb(91, 100, 112)"');
    expect(svg.replaceAll(/<[^>]*>/g, ' ')).toMatch(/to_truck_1 \(\d+ legs searched\) .*forbidden at/s);
    await panel.getByLabel('Slider').selectOption('none');
    expect((await told())[0]).toContain('as where the search began');
    expect(await ring.count()).toBe(0);
    // Without a third parameter every leg is near.
    expect((await near.getAttribute('d'))?.match(/M/g)?.length).toBe(guide?.legs);
    await panel.getByLabel('Up').selectOption('stick.phi');
    expect(await cells.count()).toBe(0);
    expect((await told())[0]).toContain('not sampled for these two parameters');
    await seek(look.page, 90);
    await expect.poll(() => panel.locator('h2').innerText()).toContain('return_3');
    expect(look.complaints).toEqual([]);
    await look.close();
    trench.remove();
  });

  test('says what goes on until the end', async () => {
    const pour = runPlan({ 'plan.plan': `plan pour {
  crew masons {}
  task walls { by masons; takes 1 h; }
  task slab { by masons; takes 10 min; after walls FS + 30 h; }
}
` });
    const look = await openReport(browser, pour.report);
    const chips = look.page.getByLabel('Tasks that go on');
    const shows = async (time: number, text: string) => {
      await seek(look.page, time);
      await expect.poll(() => chips.innerText()).toBe(text);
    };
    await shows(7200, 'nobody works');
    await shows(31 * 3600 + 600, 'the end');
    await shows(7200, 'nobody works');
    await shows(31 * 3600 + 595, 'masons: slab');
    await look.page.getByRole('button', { name: /^Play/ }).first().click();
    await expect.poll(() => chips.innerText(), { timeout: 20_000 }).toBe('the end');
    // Days are said as days, everywhere.
    await expect.poll(() => look.page.locator('#app').innerText()).toContain('1 d 07:10');
    for (const name of ['Overview', 'Tasks', 'Gantt', 'Steps']) {
      await look.page.getByRole('tab', { name, exact: true }).click();
      expect(await look.page.locator('#app').innerText()).not.toMatch(/\b(2[4-9]|[3-9]\d|\d{3,}):\d\d:\d\d/);
    }
    expect(look.complaints).toEqual([]);
    await look.close();
    pour.remove();
  });

  test('steps forth and back through what was tried', async () => {
    await tab('Steps');
    await page.evaluate(() => window.rubicon?.player.select({ kind: 'run', index: 0 }));
    await seek(page, 0);
    const tries = readTrace(result).filter((record) => record.type === 'try' && record.task === 'set_wall_1');
    const seen: string[] = [];
    const look = async () => JSON.stringify([
      // What stands on the page follows in the next frame.
      await page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(() => done(0))); })),
      await page.evaluate(() => window.rubicon?.player.record), await posesOf(page), await page.locator('.state').innerText()]);
    for (let i = 0; i < 30; ++i) {
      await page.keyboard.press('Shift+ArrowRight');
      seen.push(await look());
    }
    // What stands at a step is the trace's try, with its line.
    const shown = await page.evaluate(() => {
      const { player } = window.rubicon!;
      const record = player.record!;
      return { ...player.film.place(record), time: player.time, ok: player.film.number(record, 'try.ok') === 1 };
    });
    const told = tries.find((record) => Math.abs((record.t as number) - shown.time) < 1e-5 && record.ok === shown.ok);
    expect(told).toBeDefined();
    expect({ file: shown.file, line: shown.line }).toEqual({ file: told?.file, line: told?.line });
    for (let i = seen.length - 2; i >= 0; --i) {
      await page.keyboard.press('Shift+ArrowLeft');
      expect(await look()).toBe(seen[i]);
    }
  });

  test('goes to a refusal and says who is in the way', async () => {
    await tab('Steps');
    await page.evaluate(() => window.rubicon?.player.select({ kind: 'run', index: 0 }));
    await seek(page, 0);
    await press(/^Next refusal/);
    const first = readTrace(result).find((record) => record.type === 'try' && record.task === 'set_wall_1' && record.reason === 'hit');
    const [moved, met] = first?.hit as [string, string];
    await expect.poll(() => page.locator('.state').innerText()).toContain(`${moved} meets ${met}`);
    expect(await timeOf(page)).toBeCloseTo(first?.t as number, 5);
  });

  test('goes to refusals of other tasks, and says when there is no more', async () => {
    await tab('Steps');
    const refusals = await page.evaluate(() => {
      const { film } = window.rubicon!.player;
      const found: { record: number; run: number }[] = [];
      for (let run = 0; run < film.runs.length; ++run) {
        for (const record of film.recordsOf(run)) {
          if (film.kind(record) !== 'try' || film.number(record, 'try.ok') === 1) continue;
          if (/^(hit|limit)/.test(film.text(record, 'try.reason'))) found.push({ record, run });
        }
      }
      return found;
    });
    const at = async (wanted: { record: number; run: number }) => {
      await expect.poll(() => page.evaluate(() => window.rubicon!.player.record)).toBe(wanted.record);
      await expect.poll(() => page.getByLabel('Task', { exact: true }).inputValue()).toBe(String(wanted.run));
    };
    const goTo = async (wanted: { record: number; run: number }) => {
      await page.evaluate((record) => window.rubicon!.player.goToRecord(record), wanted.record);
      await at(wanted);
    };
    const change = refusals.findIndex(({ run }, i) => i > 0 && run !== refusals[i - 1].run);
    expect(change).toBeGreaterThan(0);
    await goTo(refusals[change - 1]);
    await press(/^Next refusal/);
    await at(refusals[change]);
    await press(/^Previous refusal/);
    await at(refusals[change - 1]);
    await goTo(refusals.at(-1)!);
    await press(/^Next refusal/);
    await expect.poll(() => page.locator('.steps').innerText()).toContain('No task has a later refusal');
    await press(/^Previous refusal/);
    await at(refusals.at(-2)!);
    await expect.poll(() => page.locator('.steps').innerText()).not.toContain('No task has a later refusal');
    await goTo(refusals[0]);
    await press(/^Previous refusal/);
    await expect.poll(() => page.locator('.steps').innerText()).toContain('No task has an earlier refusal');
  });

  test('tells what is picked', async () => {
    await seek(page, 0);
    await page.evaluate(() => window.rubicon?.player.select(null));
    const index = await page.evaluate(() => window.rubicon!.player.film.header.components.findIndex(({ name }) => name === 'wall_1'));
    const place = await placeOf(page, { kind: 'component', index });
    expect(place).not.toBeNull();
    await page.mouse.click(place!.x, place!.y);
    await expect.poll(() => page.evaluate(() => window.rubicon?.player.selection?.kind)).toBe('component');
    const picked = await page.evaluate(() => window.rubicon?.player.selection);
    const name = await page.evaluate((i) => window.rubicon!.player.film.header.components[i].name, picked!.index);
    const card = page.getByLabel('What is picked');
    await expect.poll(() => card.locator('h2').innerText()).toBe(name);
    expect(await card.innerText()).toContain('3.9 t');
    expect(await card.innerText()).toContain(`set_${name}`);
  });

  test('goes to a task that is clicked in the table', async () => {
    await tab('Tasks');
    await page.getByRole('row').filter({ hasText: 'set_wall_4' }).first().click();
    const start = readTrace(result).find((record) => record.type === 'task_start' && record.task === 'set_wall_4')?.t as number;
    expect(await timeOf(page)).toBeCloseTo(start, 5);
    expect(await page.evaluate(() => {
      const { selection, film } = window.rubicon!.player;
      return selection?.kind === 'run' ? film.runs[selection.index].task : '';
    })).toBe('set_wall_4');
  });

  test.each([900, 1400])('has room for names and buttons in a window of %i px', async (width) => {
    const look = await openReport(browser, result.report, { width, height: 700 });
    await look.page.getByRole('tab', { name: 'Tasks', exact: true }).click();
    const names = look.page.locator('.tasks tbody td:first-child:not([colspan])');
    expect(await names.count()).toBeGreaterThan(10);
    expect(await names.evaluateAll((cells) => cells.filter((cell) => cell.scrollWidth > cell.clientWidth).map((cell) => cell.textContent))).toEqual([]);
    expect(await names.first().locator('bdi').getAttribute('title')).toBe('set_wall_1');
    const heads = await look.page.locator('.tasks th').evaluateAll((cells) => cells.map((cell) => [cell.textContent, getComputedStyle(cell).textAlign]));
    expect(heads.slice(0, 4)).toEqual([['Task', 'start'], ['Start ▴', 'end'], ['Duration', 'end'], ['Result', 'start']]);
    for (const name of ['Keys and hints', /colours$/]) {
      const box = await look.page.getByRole('button', { name }).boundingBox();
      expect((box?.x ?? width) + (box?.width ?? 0)).toBeLessThanOrEqual(width);
    }
    await look.close();
  });

  test('hands the chart out', async () => {
    await tab('Gantt');
    const [svg] = await Promise.all([page.waitForEvent('download'), press('Export SVG')]);
    const text = readFileSync((await svg.path())!, 'utf8');
    expect(text).toMatch(/^(<\?xml[^>]*>\s*)?<svg /);
    for (const name of ['low', 'high', 'erectors', 'grout']) expect(text).toContain(`>${name}<`);
    const error = await page.evaluate((xml) => new DOMParser().parseFromString(xml, 'image/svg+xml').querySelector('parsererror')?.textContent, text);
    expect(error ?? '').toBe('');
    const [png] = await Promise.all([page.waitForEvent('download'), press('Export PNG')]);
    expect(readFileSync((await png.path())!).subarray(1, 4).toString()).toBe('PNG');
  });

  test('bears every button being pressed', async () => {
    for (const name of ['Overview', 'Tasks', 'Gantt', 'Steps']) {
      await tab(name);
      const count = await page.locator('button:visible').count();
      expect(count).toBeGreaterThan(12);
      for (let i = 0; i < count; ++i) {
        const button = page.locator('button:visible').nth(i);
        if (!(await button.count()) || !(await button.isEnabled())) continue;
        expect(await button.evaluate((it) => it.getAttribute('aria-label') ?? it.textContent?.trim()), 'its name').not.toBe('');
        await button.click({ timeout: 5000 });
        if (await page.locator('dialog[open]').count()) await page.keyboard.press('Escape');
        // A tab that was pressed leads elsewhere: back to the one under test.
        await tab(name);
      }
    }
    await press(/^Stop/);
    expect(opened.complaints).toEqual([]);
  });

  test.each([[1280, 720], [1920, 1080]])('stays in its place at %i x %i', async (width, height) => {
    const look = await openReport(browser, result.report, { width, height, dark: width > 1500 });
    const shift = await look.page.evaluate(async () => {
      let sum = 0;
      new PerformanceObserver((list) => {
        for (const entry of list.getEntries()) sum += (entry as unknown as { value: number }).value;
      }).observe({ type: 'layout-shift', buffered: true });
      window.rubicon?.player.play();
      await new Promise((done) => { setTimeout(done, 1500); });
      return sum;
    });
    expect(shift).toBeLessThan(0.001);
    const scrolls = await look.page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight]);
    expect(scrolls).toEqual([width, height]);
    expect(look.complaints).toEqual([]);
    await look.close();
  });
});
