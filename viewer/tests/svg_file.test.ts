import { describe, expect, it } from 'vitest';
import { wrapped } from '../src/panels/svg_file';

describe('a drawing as a file', () => {
  it('has its paragraphs in lines', () => {
    expect(wrapped('', 10)).toEqual([]);
    expect(wrapped(' a robot  may not\nstand ', 9)).toEqual(['a robot', 'may not', 'stand']);
    expect(wrapped('no pneumonoultramicroscopic dust', 10)).toEqual(['no', 'pneumonoultramicroscopic', 'dust']);
  });
});
