import { expect, test } from 'vitest';
import { originOf, readRemarks, remarkOf } from '../src/remarks';
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

test.each([
  ["'00 begane grond', IfcSlab 'vloer_V0', 2dWeqcZXj94QwNPbNEIcDK",
    { storey: '00 begane grond', what: "IfcSlab 'vloer_V0'", guid: '2dWeqcZXj94QwNPbNEIcDK' }],
  ["5 elements that a rule leaves out\nIfcBeam, 0jxtYk_DPFmfsr5FLf4yfo",
    { storey: '', what: 'IfcBeam', guid: '0jxtYk_DPFmfsr5FLf4yfo' }],
  ["'it\'s', said', IfcWall 'a, b', 0GUGYII3j58vHPlOrLYtw3",
    { storey: "it's', said", what: "IfcWall 'a, b'", guid: '0GUGYII3j58vHPlOrLYtw3' }],
  ['it hangs over the place where a shall stand', null],
  ['', null],
])('%j tells the origin %j', (remark, origin) => {
  expect(originOf(remark)).toEqual(origin);
});
