/** Browsers lay out no element higher than some millions of pixels. */
const highest = 8e6;

export interface Window {
  /** The first row to draw, and the one after the last. */
  first: number;
  after: number;
  /** Where the first row stands in what is scrolled (px). */
  top: number;
  /** How high what is scrolled is (px). */
  height: number;
}

/** Which rows of a long list are seen: all lengths in px. Rows stand `rowHeight` apart, whatever their number. */
export function visibleRows(scrollTop: number, viewHeight: number, rowHeight: number, count: number, spare = 4): Window {
  const real = count * rowHeight;
  const height = Math.min(real, Math.max(highest, viewHeight));
  const at = realTop(scrollTop, viewHeight, real, height);
  const first = Math.min(Math.max(Math.floor(at / rowHeight) - spare, 0), count);
  const after = Math.min(Math.max(Math.ceil((at + viewHeight) / rowHeight) + spare, first), count);
  return { first, after, top: scrollTop - at + first * rowHeight, height };
}

/** The scroll position that shows a row: unchanged if it is seen, else a third from the top. */
export function scrollToRow(row: number, scrollTop: number, viewHeight: number, rowHeight: number, count: number): number {
  const real = count * rowHeight;
  const height = Math.min(real, Math.max(highest, viewHeight));
  const at = realTop(scrollTop, viewHeight, real, height);
  if (row * rowHeight >= at && (row + 1) * rowHeight <= at + viewHeight) return scrollTop;
  const above = Math.floor(viewHeight / 3 / rowHeight);
  const wanted = Math.min(Math.max(row - above, 0) * rowHeight, Math.max(real - viewHeight, 0));
  return real <= height ? wanted : wanted * (height - viewHeight) / (real - viewHeight);
}

function realTop(scrollTop: number, viewHeight: number, real: number, height: number): number {
  if (real <= height) return scrollTop;
  return scrollTop * (real - viewHeight) / (height - viewHeight);
}
