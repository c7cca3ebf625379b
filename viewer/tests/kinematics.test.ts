import { expect, test } from 'vitest';
import { Mechanism, poseMatrix, poseRows, quaternionMatrix } from '../src/kinematics';
import { identity, makeHoist } from './make_film';
import type { RobotData } from '../src/header';

/** Largest difference of two poses. */
function apart(a: number[], b: number[]): number {
  return Math.max(...a.map((value, i) => Math.abs(value - b[i])));
}

type Body = [name: string, parent: string | null, frame: string];

function robot(bodies: Body[], tool: [string, string], parameters: string[], pose = identity): RobotData {
  return {
    ...makeHoist('made', pose),
    bodies: bodies.map(([name, parent, frame]) => ({ name, parent, frame, shapes: [] })),
    parameters: parameters.map((name) => ({ ...makeHoist('').parameters[0], name })),
    tool: { body: tool[0], frame: tool[1] },
  };
}

// Out of traces of taskplans/two_cranes.plan and crane_and_trucks.plan: the configuration at a detach, X_TO of the attach, X_WO.
const crane: Body[] = [
  ['mast', null, 'trans(0, 0, 0)'], ['jib', 'mast', 'rotz(jib.theta)'], ['trolley', 'jib', 'trans(x, 0, 31.2)'],
  ['hook', 'trolley', 'trans(0, 0, hook.z - 31.2) * rotz(hook.theta)'],
];
const high: Body[] = [
  ['mast', null, 'trans(0, 0, 0)'], ['jib', 'mast', 'rotz(jib.theta)'], ['trolley', 'jib', 'trans(x, 0, 49.7)'],
  ['hook', 'trolley', 'trans(0, 0, 0.2923 * hook.z - 27.7)'],
];
const parameters = ['jib.theta', 'x', 'hook.z', 'hook.theta'];
const at = (x: number, y: number) => [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, 0];

test.each([
  ['a low crane sets wall_1', robot(crane, ['hook', 'trans(0, 0, 0)'], parameters, at(-25, 0)),
    [30.46554491945988, 19.72308292331602, 3.8000000000000007, 59.53445508054012], [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -3.8],
    [0, -1, 0, -8, 1, 0, 0, 10, 0, 0, 1, 0]],
  ['a high crane sets wall_2',
    robot(high, ['hook', 'trans(0, 0, 0.7077 * hook.z - 22) * rotz(hook.theta)'], parameters, at(25, 0)),
    [162.12130340415865, 32.57299494980467, 3.7999999999999976, -72.12130340415865], [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -3.8],
    [0, -1, 0, -6, 1, 0, 0, 10, 0, 0, 1, 0]],
  ['a tow motor brings mortar_2',
    robot([['truck', null, 'trans(x, y, 0) * rotz(theta)'], ['forks', 'truck', 'trans(0.5, 0, z)']],
          ['forks', 'trans(0.6, 0, 2)'], ['x', 'y', 'theta', 'z']),
    [11.4, 7.9, 90, 2.0816681711721685e-16], [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -2], [0, -1, 0, 11.4, 1, 0, 0, 9, 0, 0, 1, 0]],
])('%s where the simulator says', (_, made, q, X_TO, X_WO) => {
  const mechanism = new Mechanism(made);
  mechanism.place(q);
  expect(apart(poseRows(mechanism.tool.clone().multiply(poseMatrix(X_TO))), X_WO)).toBeLessThan(1e-4);
});

test('turns about each axis go by the right hand', () => {
  const turned = (frame: string) => {
    const mechanism = new Mechanism(robot([['body', null, frame]], ['body', 'trans(0, 0, 0)'], ['a']));
    mechanism.place([90]);
    return poseRows(mechanism.bodies[0]);
  };
  expect(turned('rotx(a)')).toEqual([1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0]);
  expect(turned('roty(a)')).toEqual([0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0]);
  expect(turned('rotz(a)')).toEqual([0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0]);
  expect(turned('trans(1, 2, 3) * rotz(a) * trans(1, 0, 0)')).toEqual([0, -1, 0, 1, 1, 0, 0, 3, 0, 0, 1, 3]);
});

test('a body may stand before its parent in the header', () => {
  const bodies: Body[] = [['hook', 'jib', 'trans(0, 0, 1)'], ['jib', null, 'trans(a, 0, 0)']];
  const mechanism = new Mechanism(robot(bodies, ['hook', 'trans(0, 0, 1)'], ['a']));
  mechanism.place([5]);
  expect(poseRows(mechanism.tool)).toEqual([1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 2]);
  expect(mechanism.chain()).toEqual([1, 0]);
});

test('poses go to matrices and back', () => {
  const rows = [0, -1, 0, 4, 1, 0, 0, 5, 0, 0, 1, 6];
  expect(poseRows(poseMatrix(rows))).toEqual(rows);
  expect(apart(poseRows(quaternionMatrix([4, 5, 6, 0, 0, Math.SQRT1_2, Math.SQRT1_2])), rows)).toBeLessThan(1e-12);
});
