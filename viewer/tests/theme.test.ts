import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

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
  const css = readFileSync(new URL('../src/styles/theme.css', import.meta.url), 'utf8');
  const blocks = [...css.matchAll(/\{([^{}]*--bg:[^{}]*)\}/g)].map(([, body]) =>
    Object.fromEntries([...body.matchAll(/--([a-z-]+): (#[0-9a-f]{6});/g)].map(([, name, value]) => [name, value])));

  it('is light once, and dark the same way whether asked for or chosen', () => {
    expect(blocks).toHaveLength(3);
    expect(blocks[1]).toEqual(blocks[2]);
    expect(Object.keys(blocks[0]).sort()).toEqual(Object.keys(blocks[1]).sort());
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
        for (const drawn of ['machine', 'crew', 'critical', 'focus']) expect(contrast(colours[drawn], colours[back]),
          `${drawn} on ${back}`).toBeGreaterThanOrEqual(3);
      }
      expect(contrast(colours['on-accent'], colours.accent)).toBeGreaterThanOrEqual(4.5);
    }
  });
});
