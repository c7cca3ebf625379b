import { Clock } from './clock';
import type { Film } from './film';
import { common, merged, onShift, type Interval } from './shifts';

/** Pauses in which nobody works for the task: till its shift, and held by a link to its finish. */
const idlePauses = ['shift', 'lift', 'held'];

/**
 * When some task goes on, in order and apart from each other: not in such pauses, and of crew work only the hours in which
 * somebody works.
 */
export function busyTimes(film: Film): Interval[] {
  const pieces: Interval[] = [];
  const from = film.runs.map((run) => run.start);
  for (let i = 0; i < film.records; ++i) {
    const kind = film.kind(i);
    const run = film.run(i);
    const isWork = kind === 'work';
    if (!film.runs[run].happened || !(isWork || (kind === 'pause' && idlePauses.includes(film.text(i, 'pause.why'))))) continue;
    pieces.push([from[run], film.number(i, isWork ? 'work.from' : 'pause.from')]);
    if (isWork) pieces.push(...workedHours(film, i));
    from[run] = film.time(i);
  }
  film.runs.forEach((run, i) => { if (run.happened) pieces.push([from[i], run.end ?? film.end]); });
  return merged(pieces.filter(([begin, end]) => end > begin));
}

/** The hours of a record of crew work in which somebody works: all of them, unless shifts end within. */
export function workedHours(film: Film, record: number): Interval[] {
  const { header } = film;
  const [begin, end] = [film.number(record, 'work.from'), film.time(record)];
  if (end - begin - film.number(record, 'work.time') < 1e-3) return [[begin, end]];
  const run = film.runs[film.run(record)];
  // Without a crew of its own it is done by those who hold the task.
  const name = film.text(record, 'work.crew');
  const crews = name ? [name] : header.tasks.find((task) => task.name === run.task)?.crews ?? [];
  const names = crews.map((crew) => header.crews.find((each) => each.name === crew)?.calendar ?? '');
  const machine = header.robots[run.robot];
  if (!name && machine) names.push(machine.calendar);
  const { epoch } = new Clock(header.start_at);
  return header.calendars.filter((calendar) => names.includes(calendar.name))
    .map((calendar) => onShift(calendar, epoch, begin, end)).reduce(common, [[begin, end]]);
}
