import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { paletteCss } from '../palette_css';
import { palette } from '../src/palette';

describe('theme', () => {
  /** WCAG 2.1, 1.4.3: relative luminance of #rrggbb. */
  const luminance = (colour: string) => {
    const [r, g, b] = [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16) / 255).map((c) =>
      (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const contrast = (a: string, b: string) => {
    const [light, dark] = [luminance(a), luminance(b)].sort((x, y) => y - x);
    return (light + 0.05) / (dark + 0.05);
  };
  const blocks = [palette.light.page, palette.dark.page] as Record<string, string>[];

  it('has the same colours on both grounds, and no other in its style sheets', () => {
    for (const part of ['page', 'site'] as const) {
      expect(Object.keys(palette.light[part]).sort()).toEqual(Object.keys(palette.dark[part]).sort());
    }
    for (const colour of Object.values({ ...palette.light, ...palette.dark }).flatMap((part) => Object.values(part).flat())) {
      expect(colour).toMatch(/^#[0-9a-f]{6}$/);
    }
    const folders = ['../src/styles/', '../src/view/', '../src/gantt/', '../src/panels/'].map((name) => new URL(name, import.meta.url));
    for (const folder of folders) {
      for (const file of readdirSync(folder)) {
        const text = readFileSync(new URL(file, folder), 'utf8');
        expect(text.match(/#[0-9a-f]{6}\b/gi) ?? [], file).toEqual([]);
        for (const [, name] of text.matchAll(/var\(--([a-z-]+)\)/g)) {
          if (!['side', 'key'].includes(name)) expect(Object.keys(palette.light.page), `${name} in ${file}`).toContain(name);
        }
      }
    }
  });

  it('goes into the page: light, and dark whether asked for or chosen', () => {
    const rules = [...paletteCss().matchAll(/\{([^{}]+)\}/g)].map(([, body]) =>
      Object.fromEntries([...body.matchAll(/--([a-z-]+): (#[0-9a-f]{6});/g)].map(([, name, value]) => [name, value])));
    expect(rules).toEqual([palette.light.page, palette.dark.page, palette.dark.page]);
  });

  it('tells motion, crew work and waiting apart, also for the colour-blind', () => {
    // Viénot, Brettel and Mollon, 1999: what is left of a colour (linear) without the long, or the medium cones.
    const kinds: ((rgb: number[]) => number[])[] = [
      (rgb) => rgb,
      ([r, g, b]) => [0.11238 * r + 0.88762 * g, 0.11238 * r + 0.88762 * g, 0.00401 * r - 0.00401 * g + b],
      ([r, g, b]) => [0.29275 * r + 0.70725 * g, 0.29275 * r + 0.70725 * g, -0.02234 * r + 0.02234 * g + b],
    ];
    const linear = (colour: string) => [1, 3, 5].map((i) => (parseInt(colour.slice(i, i + 2), 16) / 255) ** 2.2);
    for (const colours of blocks) {
      for (const [seen, marks] of kinds.flatMap((each) => [['machine', 'crew', 'wait'], ['towards', 'searching', 'tracking']]
        .map((names) => [each, names.map((name) => linear(colours[name]))] as const))) {
        for (const [a, b] of [[0, 1], [0, 2], [1, 2]]) {
          const [left, right] = [seen(marks[a]), seen(marks[b])].map((rgb) => rgb.map((c) => Math.max(c, 0) ** (1 / 2.2)));
          expect(Math.hypot(...left.map((c, i) => c - right[i]))).toBeGreaterThan(0.2);
        }
      }
    }
  });

  it('can be read: 4.5 to 1 for text, 3 to 1 for what is drawn', () => {
    for (const colours of blocks) {
      for (const back of ['bg', 'panel', 'pick', 'raised']) {
        for (const text of ['text', 'muted']) expect(contrast(colours[text], colours[back]),
          `${text} on ${back}`).toBeGreaterThanOrEqual(4.5);
      }
      for (const back of ['bg', 'panel']) {
        for (const text of ['accent', 'good', 'bad', 'warn']) expect(contrast(colours[text], colours[back]),
          `${text} on ${back}`).toBeGreaterThanOrEqual(4.5);
        for (const drawn of ['machine', 'crew', 'critical', 'focus', 'towards', 'searching', 'tracking']) expect(contrast(colours[drawn], colours[back]),
          `${drawn} on ${back}`).toBeGreaterThanOrEqual(3);
      }
      expect(contrast(colours['on-accent'], colours.accent)).toBeGreaterThanOrEqual(4.5);
    }
  });
});
