/** The piece of time that is seen (s) on so many px. */
export interface TimeView {
  from: number;
  to: number;
  width: number;
}

/** No closer than this many seconds over the whole width. */
const shortest = 2;

export function xOf(view: TimeView, t: number): number {
  return (t - view.from) / (view.to - view.from) * view.width;
}

export function timeOf(view: TimeView, x: number): number {
  return view.from + x / view.width * (view.to - view.from);
}

/** All of a plan with a little room at both ends. */
export function wholeView(end: number, width: number): TimeView {
  const long = Math.max(end, 1);
  return { from: -0.03 * long, to: 1.03 * long, width };
}

/** Where to zoom without a pointer: at `t` if that is to be seen, else in the middle. */
export function zoomPlace(view: TimeView, t: number): number {
  return t >= view.from && t <= view.to ? xOf(view, t) : view.width / 2;
}

/** Zooms by a factor (below 1: closer); what is at x stays there, unless the ends of the plan are met. */
export function zoomed(view: TimeView, x: number, factor: number, end: number): TimeView {
  const whole = wholeView(end, view.width);
  const longest = whole.to - whole.from;
  const span = Math.min(Math.max((view.to - view.from) * factor, shortest), longest);
  const from = timeOf(view, x) - x / view.width * span;
  return within({ from, to: from + span, width: view.width }, end);
}

export function panned(view: TimeView, px: number, end: number): TimeView {
  const by = px / view.width * (view.to - view.from);
  return within({ ...view, from: view.from + by, to: view.to + by }, end);
}

/** The same view, moved only if `t` is not in it: then `t` is a fifth from its left. */
export function showing(view: TimeView, t: number, end: number): TimeView {
  if (t >= view.from && t <= view.to) return view;
  const span = view.to - view.from;
  return within({ ...view, from: t - span / 5, to: t + span * 4 / 5 }, end);
}

function within(view: TimeView, end: number): TimeView {
  const whole = wholeView(end, view.width);
  const span = view.to - view.from;
  const from = Math.min(Math.max(view.from, whole.from), whole.to - span);
  return { ...view, from, to: from + span };
}
