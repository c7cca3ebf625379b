import { expect, test } from 'vitest';
import { sentence } from '../src/sentences';
import { makeFilm, type MadeRecord } from './make_film';

test('cold joints are told from end to end, each with its age', () => {
  const joint = (t: number, ends: number[], age: number): MadeRecord =>
    ({ kind: 'cold_joint', run: 0, t, columns: { 'cold_joint.ends': ends, 'cold_joint.age': age } });
  const film = makeFilm({
    header: {}, runs: [{ task: 'pour', robot: 0, start: 0, end: 9000, result: 'done' }], end: 9000,
    records: [joint(9000, [0, 4, 3, 8], 5720), joint(9000, [7, 0, 7, 1], 5401)],
  });
  expect(sentence(film, 0)).toBe('a cold joint of 5.00 m from (0.00, 4.00) to (3.00, 8.00): what was laid first had lain 1:35:20');
  expect(sentence(film, 1)).toBe('a cold joint of 1.00 m from (7.00, 0.00) to (7.00, 1.00): what was laid first had lain 1:30:01');
});
