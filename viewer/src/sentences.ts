import { duration, workingTime } from './clock';
import type { Film } from './film';

/** The word of a plan for crew work, for people: `takes` is the whole of what a crew does. */
export function workWord(what: string): string {
  return what === 'takes' ? 'crew work' : what;
}

/** What a record says, in one line for people. */
export function sentence(film: Film, record: number): string {
  const text = (column: string) => film.text(record, column);
  const number = (column: string) => film.number(record, column);
  const component = (column: string) => film.header.components[number(column)]?.name ?? '?';
  const run = film.runs[film.run(record)];
  switch (film.kind(record)) {
    case 'task_start': return run.because || 'begins';
    case 'goal': return `waypoint ${number('goal.k')} of ${number('goal.n')}`;
    case 'guide': {
      const cause = text('guide.cause');
      const way = `${number('guide.nodes')} nodes, ${number('guide.checks')} checks`;
      return `guide ${text('guide.name')} (${text('guide.kind')}) ${cause ? `found no way: ${cause}` : `has a way: ${way}`}${text('guide.events') && `; ${text('guide.events')}`}`;
    }
    case 'way_point': return `waypoint ${number('way_point.k')} of ${number('way_point.n')} of the guide`;
    case 'set': return `var(${text('set.var')}) = ${text('set.value')}`;
    case 'enter': return `${text('enter.kind')} {`;
    case 'exit': {
      const made = number('exit.successes');
      const how = number('exit.reached') ? 'reached' : 'exhausted';
      return `} ${text('exit.kind')} ${how}, ${made} ${made === 1 ? 'success' : 'successes'}`;
    }
    case 'which': return `which ${text('which.label')}`;
    case 'try': {
      const step = `${text('try.command')} ${text('try.parameter')}`;
      return number('try.ok') ? step : `${step} refused: ${refusal(film, record)}`;
    }
    case 'wait': return 'wait';
    case 'stop': return 'the machine comes to a stop';
    case 'work': {
      const crew = text('work.crew');
      return `${workWord(text('work.what'))}${crew && ` by ${crew}`}, ${workingTime(number('work.time'))}`;
    }
    case 'pause': {
      const why = text('pause.why');
      const whom = text('pause.for');
      const long = duration(film.time(record) - number('pause.from'));
      if (why === 'shift') return `waited ${long} for the next shift`;
      if (why === 'lift') return `its lift waited ${long}: ${whom}`;
      if (why === 'repair') return `${whom} was repaired for ${long}`;
      if (why === 'held') return `was held ${long} by ${whom}`;
      return `waited ${long} for ${whom}`;
    }
    case 'attach': return `takes up ${component('attach.component')}`;
    case 'turn': return turned(film, record, component('turn.component'));
    case 'detach': return `puts down ${component('detach.component')}`;
    case 'remove': return `removes ${component('remove.component')}`;
    case 'end': {
      const message = text('end.message');
      const status = text('end.status') + (number('end.reached') ? ', reached' : '');
      const tries = `${number('end.tries')} steps tried, ${number('end.accepted')} accepted`;
      return `motion ended: ${status}, ${tries}${message && ` (${message})`}`;
    }
    case 'think': return 'its guide thinks';
    case 'moving': case 'breakdown': case 'lost_days': case 'soil': return '';  // of no run
    case 'cold_joint': return coldJoint(film, record);
    case 'task_end': return `${run.result || 'over'}${run.reason && `: ${run.reason}`}`;
  }
}

/** `a cold joint of 3.20 m from (0.00, 4.00) to (3.20, 4.00): what was laid first had lain 1:35:20`. */
function coldJoint(film: Film, record: number): string {
  const [x, y, toX, toY] = film.numbers(record, 'cold_joint.ends', 4);
  const place = (a: number, b: number) => `(${a.toFixed(2)}, ${b.toFixed(2)})`;
  const age = duration(film.number(record, 'cold_joint.age'));
  return `a cold joint of ${Math.hypot(toX - x, toY - y).toFixed(2)} m from ${place(x, y)} to ${place(toX, toY)}: what was laid first had lain ${age}`;
}

/** `panel is turned by -90° by people`, and what barred the shorter way. */
function turned(film: Film, record: number, component: string): string {
  const met = film.text(record, 'turn.met');
  const longer = met && `: the shorter way ${film.text(record, 'turn.moved')} would have met ${met}`;
  return `${component} is turned by ${Number(film.number(record, 'turn.angle').toFixed(3))}° by people${longer}`;
}

/** Why an attempt was refused: `hit, low.jib meets high.hook`. */
export function refusal(film: Film, record: number): string {
  const reason = film.text(record, 'try.reason');
  const met = film.text(record, 'try.met');
  return met ? `${reason}, ${film.text(record, 'try.moved')} meets ${met}` : reason;
}
