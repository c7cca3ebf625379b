import type { Film } from './film';

/** When a task is done (s), null: never. */
function doneAt({ runs }: Film, task: string): number | null {
  return runs.find((run) => run.task === task && run.result === 'done')?.end ?? null;
}

/** What a component is fixed to at a moment: `slab`; `slab, only after grout`. */
export function fixedTo(film: Film, component: number, time: number): string[] {
  const { fixed_to: names = [], fixed_after: after = [] } = film.header.components[component];
  return names.map((name, i) => {
    if (!after[i]) return name;
    const done = doneAt(film, after[i]);
    return done !== null && done <= time ? `${name}, since ${after[i]}` : `${name}, only after ${after[i]}`;
  });
}

/** What a plan asks of support, in words; null where it says nothing but the usual. */
export function supportWords({ header: { support } }: Film): { mode: string; more: string } | null {
  if (!support) return null;
  const balance = support.friction === undefined ? '' : `forces balance, friction ${support.friction}`;
  const gap = `gap ${Math.round(support.gap * 1000)} mm`;
  if (support.mode === 'on' && balance === '') return null;
  return { mode: support.mode === 'on' ? 'examined' : support.mode === 'warn' ? 'warns only' : 'not examined',
    more: support.mode === 'off' ? '' : [balance, gap].filter((each) => each !== '').join(', ') };
}
