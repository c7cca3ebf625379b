type Flat = [x: number, y: number];
type Segment = [number, number];

/** Corners of a digit, of height 1 and width 0.6: lower left and right, middle, upper; the ends of a one. */
const corners: Flat[] = [[0, 0], [0.6, 0], [0, 0.5], [0.6, 0.5], [0, 1], [0.6, 1], [0.3, 0], [0.3, 1]];
const top: Segment = [4, 5];
const middle: Segment = [2, 3];
const low: Segment = [0, 1];
const upperLeft: Segment = [2, 4];
const upperRight: Segment = [3, 5];
const lowerLeft: Segment = [0, 2];
const lowerRight: Segment = [1, 3];
/** The segments of each digit, as on a display of seven. */
const segments: Segment[][] = [
  [top, low, upperLeft, upperRight, lowerLeft, lowerRight],
  [[6, 7]],
  [top, upperRight, middle, lowerLeft, low],
  [top, upperRight, middle, lowerRight, low],
  [upperLeft, upperRight, middle, lowerRight],
  [top, upperLeft, middle, lowerRight, low],
  [top, upperLeft, middle, lowerLeft, lowerRight, low],
  [top, upperRight, lowerRight],
  [top, middle, low, upperLeft, upperRight, lowerLeft, lowerRight],
  [top, middle, low, upperLeft, upperRight, lowerRight],
];
/** From a digit to the next. */
const pitch = 0.85;

/** Lines of a whole number, in the middle of a place, so high. */
export function digitStrokes(value: number, [x, y]: Flat, height: number): [Flat, Flat][] {
  const text = String(value);
  const left = x - (((text.length - 1) * pitch + 0.6) * height) / 2;
  const at = (place: number, [u, v]: Flat): Flat => [left + (place * pitch + u) * height, y + (v - 0.5) * height];
  return [...text].flatMap((digit, place) => segments[Number(digit)].map(([a, b]): [Flat, Flat] => [at(place, corners[a]), at(place, corners[b])]));
}
