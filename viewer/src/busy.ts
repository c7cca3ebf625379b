import { Clock } from './clock';
import type { Film } from './film';
import { merged, onShift, type Interval } from './shifts';

/**
 * When some task goes on, in order and apart from each other: not while it waits for its shift, and of crew work only the hours in
 * which somebody works.
 */
export function busyTimes(film: Film): Interval[] {
  const { header } = film;
  const clock = new Clock(header.start_at);
  const pieces: Interval[] = [];
  const from = film.runs.map((run) => run.start);
  const leave = (run: number, begin: number, end: number) => {
    if (film.runs[run].happened && begin > from[run]) pieces.push([from[run], begin]);
    from[run] = end;
  };
  const calendars = new Map(header.calendars.map((calendar) => [calendar.name, calendar]));
  const calendarOf = new Map(header.crews.map((crew) => [crew.name, crew.calendar]));
  const crews = new Map(header.tasks.map((task) => [task.name, task.crews]));
  for (let i = 0; i < film.records; ++i) {
    const kind = film.kind(i);
    const run = film.run(i);
    if (kind === 'pause' && film.text(i, 'pause.why') === 'shift') leave(run, film.number(i, 'pause.from'), film.time(i));
    if (kind !== 'work') continue;
    const [begin, end] = [film.number(i, 'work.from'), film.time(i)];
    if (end - begin - film.number(i, 'work.time') < 1e-3) continue;
    // It lasts longer than its work: through hours in which its crew (or those who hold the task) has no shift.
    const crew = film.text(i, 'work.crew') || (crews.get(film.runs[run].task)?.[0] ?? '');
    const name = calendarOf.get(crew) ?? header.robots[film.runs[run].robot]?.calendar ?? '';
    const calendar = calendars.get(name);
    if (!calendar) continue;
    leave(run, begin, end);
    if (film.runs[run].happened) pieces.push(...onShift(calendar, clock.epoch, begin, end));
  }
  film.runs.forEach((run, i) => { if (run.happened) pieces.push([from[i], run.end ?? film.end]); });
  return merged(pieces);
}
