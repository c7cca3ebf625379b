import { describe, expect, it } from 'vitest';
import { escaped, SvgPainter } from '../src/gantt/svg';
import { fileName } from '../src/panels/download';

describe('svg', () => {
  it('has names as text, never as markup', () => {
    const painter = new SvgPainter();
    painter.text(1, 2, '</text><script>alert(1)</script>&"\'', '"><script>');
    const text = painter.document(10, 10, ']]><x>');
    expect(text).not.toContain('<script');
    expect(text).not.toContain('<x>');
    expect(text.match(/<[a-zA-Z]+/g)).toEqual(['<svg', '<title', '<text']);
    expect(text).toContain('&#60;/text&#62;&#60;script&#62;');
  });

  it('replaces what XML does not know', () => {
    expect(escaped('a\u0000b\u0008c\u000bd\u001fe\ufffef')).toBe('a\ufffdb\ufffdc\ufffdd\ufffde\ufffdf');
    expect(escaped('tab\tline\n')).toBe('tab\tline\n');
    expect(escaped('\ud83c half \udfd7')).toBe('\ufffd half \ufffd');
    expect(escaped('whole \u{1f3d7} \u05d1')).toBe('whole \u{1f3d7} \u05d1');
  });

  it('closes every group it opens', () => {
    const painter = new SvgPainter();
    painter.clip(0, 0, 10, 10, () => painter.clip(1, 1, -5, 2, () => painter.diamond(1, 2, 3, 'red')));
    painter.rect(0, 0, -1, 5, 'red');
    const text = painter.document(10, 10, '');
    expect(text.match(/<g /g)).toHaveLength(2);
    expect(text.match(/<\/g>/g)).toHaveLength(2);
    expect(new Set(text.match(/clipPath id="[^"]+"/g)).size).toBe(2);
    expect(text).not.toMatch(/(width|height)="-/);
  });

  it('is saved under a name that every file system takes', () => {
    expect(fileName('../a b\u202e"<c>', 'svg')).toBe('a_b_c_gantt.svg');
    expect(fileName('\u{1f3d7}', 'png')).toBe('plan_gantt.png');
    expect(fileName('x'.repeat(10000), 'svg').length).toBeLessThan(100);
  });
});
