import { expect, test } from 'vitest';
import { Stock, turnLeft } from '../src/stock';
import { identity, makeBox, makeFilm, makeHoist, type MadeRecord } from './make_film';

const component = (name: string, x: number) =>
  ({ name, pose: [1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0], grip: identity, mass: 1, shapes: [makeBox([0, 0, 0], [1, 1, 1])] });
const pose = (x: number) => [x, 0, 0, 0, 0, 0, 1];
const attach = (run: number, t: number, which: number): MadeRecord =>
  ({ kind: 'attach', run, t, columns: { 'attach.component': which, 'attach.pose': pose(-1) } });
const detach = (run: number, t: number, which: number, x: number): MadeRecord =>
  ({ kind: 'detach', run, t, columns: { 'detach.component': which, 'detach.pose': pose(x) } });
const remove = (run: number, t: number, which: number): MadeRecord =>
  ({ kind: 'remove', run, t, columns: { 'remove.component': which } });

/** How all components are, short: state, robot and x of the pose. */
function shown(stock: Stock): string {
  return stock.items.map(({ state, robot, pose: at }) => `${state} ${robot} ${at.elements[12]}`).join(', ');
}

const made = {
  header: { components: [component('a', 0), component('b', 1), component('c', 2)], robots: [makeHoist('one'), makeHoist('two')] },
  runs: [{ task: 'first', robot: 0, start: 0, end: 20 }, { task: 'again', robot: 1, start: 20, end: 40 },
    { task: 'no', robot: 0, start: 20, end: 50, result: 'rejected' as const, happened: false },
    { task: 'after', robot: 0, start: 20, end: 30 }],
  records: [
    attach(0, 5, 0), detach(0, 10, 0, 7), attach(2, 25, 2), detach(2, 35, 2, 8), attach(3, 22, 1), detach(3, 28, 1, 3),
    attach(1, 24, 0), detach(1, 36, 0, 9), remove(1, 38, 0),
  ],
};

test('components go from hand to hand', () => {
  const stock = new Stock(makeFilm(made));
  expect(shown(stock)).toBe('waiting -1 0, waiting -1 1, waiting -1 2');
  stock.seek(5);
  expect(shown(stock)).toBe('carried 0 -1, waiting -1 1, waiting -1 2');
  stock.seek(10);
  expect(shown(stock)).toBe('placed -1 7, waiting -1 1, waiting -1 2');
  stock.seek(24.5);
  expect(shown(stock)).toBe('carried 1 -1, carried 0 -1, waiting -1 2');
  stock.seek(37);
  expect(shown(stock)).toBe('placed -1 9, placed -1 3, waiting -1 2');
  stock.seek(99);
  expect(shown(stock)).toBe('removed -1 0, placed -1 3, waiting -1 2');
});

test('people turn what hangs, evenly', () => {
  const turn: MadeRecord = { kind: 'turn', run: 0, t: 9,
    columns: { 'turn.component': 0, 'turn.angle': -90, 'turn.from': 7, 'turn.pose': pose(-2) } };
  const stock = new Stock(makeFilm({ ...made, records: [attach(0, 5, 0), turn, detach(0, 10, 0, 7)] }));
  stock.seek(6);
  expect(stock.items[0].turn).toBeUndefined();
  stock.seek(8);
  expect(shown(stock)).toBe('carried 0 -2, waiting -1 1, waiting -1 2');
  const turning = stock.items[0].turn ?? { angle: 0, from: 0, to: 0 };
  expect([7, 8, 9, 10].map((time) => turnLeft(turning, time))).toEqual([-90, -45, 0, 0]);
  stock.seek(10);
  expect(shown(stock)).toBe('placed -1 7, waiting -1 1, waiting -1 2');
});

test('seek tells what is not as it was', () => {
  const stock = new Stock(makeFilm(made));
  expect([...stock.seek(4)]).toEqual([]);
  expect([...stock.seek(23)].sort()).toEqual([0, 1]);
  expect([...stock.seek(23.5)]).toEqual([]);
  expect([...stock.seek(4.9)].sort()).toEqual([0, 1]);
});

test('a rejected run is laid over what happened, without what its robot did instead', () => {
  const stock = new Stock(makeFilm(made));
  stock.seek(29, 2);
  expect(shown(stock)).toBe('carried 1 -1, waiting -1 1, carried 0 -1');
  stock.seek(37, 2);
  expect(shown(stock)).toBe('placed -1 9, waiting -1 1, placed -1 8');
  stock.seek(21, 2);
  expect(shown(stock)).toBe('placed -1 7, waiting -1 1, waiting -1 2');
  expect([...stock.seek(29)].sort()).toEqual([0, 1]);
  expect(shown(stock)).toBe('carried 1 -1, placed -1 3, waiting -1 2');
});

test('forwards, backwards and anywhere the states are the same', () => {
  let seed = 7;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  const records: MadeRecord[] = [];
  for (let t = 0; t < 600; ++t) {
    const which = Math.floor(random() * 12);
    const kind = random();
    records.push(kind < 0.45 ? attach(0, t / 2, which) : kind < 0.95 ? detach(0, t / 2, which, t) : remove(0, t / 2, which));
  }
  const film = makeFilm({
    header: { components: Array.from({ length: 12 }, (_, i) => component(`c${i}`, i)), robots: [makeHoist('one')] },
    runs: [{ robot: 0 }], records,
  });
  const wandering = new Stock(film);
  for (let i = 0; i < 60; ++i) {
    const t = random() * 320 - 5;
    wandering.seek(t);
    const fresh = new Stock(film);
    fresh.seek(t);
    expect(shown(wandering)).toBe(shown(fresh));
  }
});
