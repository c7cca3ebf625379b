import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { validateBytes } from 'gltf-validator';
import { expect, test } from 'vitest';
import { command, runPlan } from './result';

// The film as glTF 2.0, held to the rules of Khronos by their own validator.

const plans = ['taskplans/two_cranes.plan', 'taskplans/three_tow_motors.plan', 'taskplans/people_below.plan', 'taskplans/unit.plan',
  'examples/08_what_cannot_be_done/site.plan'];

test.each(plans)('the film of %s keeps the rules', async (plan) => {
  const result = runPlan(plan);
  for (const name of ['film.glb', 'film.gltf']) {
    const file = join(result.folder, name);
    command('export', result.folder, '--gltf', file);
    const { issues } = await validateBytes(new Uint8Array(readFileSync(file)));
    expect(issues.messages.filter(({ severity }) => severity < 2)).toEqual([]);
  }
  result.remove();
});
