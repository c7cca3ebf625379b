import { expect, test } from 'vitest';
import { readRemarks, remarkOf } from '../src/remarks';
import { makeHeader } from './make_film';

const text = `# a plan
plan made {
  // IfcSlab 'Deck' of 'Level 2', 2O2Fr$t4X7Zf8NOew3FLOH
  component deck_1 {
    shape box(0, 0, 0, 1, 1, 1);  // not this
  }
  component bare { shape box(0, 0, 0, 1, 1, 1); }
  # one

  # two, <b>three</b>
  # four
  component wall{
  module unit {
    // in a module
    component door {
`;
const remarks = readRemarks(makeHeader({ files: [{ path: 'other.robot', text: '' }, { path: 'made.plan', text }] }));

test.each([
  ['deck_1', "IfcSlab 'Deck' of 'Level 2', 2O2Fr$t4X7Zf8NOew3FLOH"],
  ['bare', ''],
  ['wall', 'two, <b>three</b>\nfour'],
  ['u_1_2.door', 'in a module'],
  ['unknown', ''],
])('above %s stands %j', (name, remark) => {
  expect(remarkOf(remarks, name)).toBe(remark);
});
