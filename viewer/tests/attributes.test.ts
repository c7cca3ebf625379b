import { expect, test } from 'vitest';
import { attributeRows } from '../src/attributes';

test('attributes the language knows come first, under their labels', () => {
  expect(attributeRows({ fire: '60 min', guid: '2O2Fr$t4X7Zf8NOew3FLOH', toString: '<b>no</b>', storey: '00', name: 'Deck', type: 'IfcSlab' }))
    .toEqual([['Name', 'Deck'], ['Storey', '00'], ['Type', 'IfcSlab'], ['GUID', '2O2Fr$t4X7Zf8NOew3FLOH'], ['fire', '60 min'],
      ['toString', '<b>no</b>']]);
});

test('without attributes there are no rows', () => {
  expect(attributeRows()).toEqual([]);
});
