import { describe, expect, it } from 'vitest';
import { fixedTo, supportWords } from '../src/holding';
import type { Header } from '../src/header';
import { makeFilm } from './film_maker';

const component = { name: 'panel', pose: [], grip: [], mass: 0, shapes: [], fixed_to: ['slab', 'site'], fixed_after: ['grout', ''] };
const film = (support?: Header['support']) => makeFilm({ header: { support, components: [component] as unknown as Header['components'] }, end: 100,
  runs: [{ task: 'grout', start: 0, end: 50, result: 'rejected', happened: false }, { task: 'grout', start: 10, end: 60 }] });

describe('what holds a component', () => {
  it('is told with the task after which it does', () => {
    expect(fixedTo(film(), 0, 59)).toEqual(['slab, only after grout', 'site']);
    expect(fixedTo(film(), 0, 60)).toEqual(['slab, since grout', 'site']);
  });

  it('is told of the plan where it is not as usual', () => {
    expect(supportWords(film())).toBeNull();
    expect(supportWords(film({ mode: 'on', gap: 0.01 }))).toBeNull();
    expect(supportWords(film({ mode: 'on', gap: 0.01, friction: 0.5 }))).toEqual({ mode: 'examined', more: 'forces balance, friction 0.5, gap 10 mm' });
    expect(supportWords(film({ mode: 'warn', gap: 0.02 }))).toEqual({ mode: 'warns only', more: 'gap 20 mm' });
    expect(supportWords(film({ mode: 'off', gap: 0.01 }))).toEqual({ mode: 'not examined', more: '' });
  });
});
