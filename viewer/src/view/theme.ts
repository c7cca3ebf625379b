import { palette, type Ground } from '../palette';

/** Red, green, blue in 0..1, as the screen shows them (sRGB). */
export type Colour = readonly [number, number, number];

function hex(text: string): Colour {
  const value = Number.parseInt(text.slice(1), 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}

/** What things are drawn in. */
export interface Theme {
  dark: boolean;
  skyTop: Colour;
  skyBelow: Colour;
  ground: Colour;
  /** Site shapes other than the ground. */
  fixture: Colour;
  /** Ground that is dug in, and what is dug of it. */
  earth: Colour;
  soil: Colour;
  grid: Colour;
  label: Colour;
  /** Edges of shapes. */
  edge: Colour;
  waiting: Colour;
  carried: Colour;
  selected: Colour;
  /** Of a refused step: what moved and what it met. */
  moved: Colour;
  met: Colour;
  zone: Colour;
  goal: Colour;
  rope: Colour;
  /** The ways of guides in the plan view, by mode: towards the goal, round an obstacle, in a trap. */
  modes: Colour[];
  machines: Colour[];
  components: Colour[];
}

function themeOn(ground: Ground): Theme {
  const { page, site } = palette[ground];
  return {
    dark: ground === 'dark', skyTop: hex(site.skyTop), skyBelow: hex(site.skyBelow), ground: hex(site.ground), fixture: hex(site.fixture),
    earth: hex(site.earth), soil: hex(site.soil),
    grid: hex(site.grid), label: hex(site.label), edge: hex(site.edge), waiting: hex(site.waiting), carried: hex(site.carried),
    selected: hex(site.selected), moved: hex(page.moved), met: hex(page.met), zone: hex(site.zone), goal: hex(site.goal),
    rope: hex(site.rope), modes: [page.towards, page.searching, page.tracking].map(hex), machines: site.machines.map(hex), components: site.components.map(hex),
  };
}

const light = themeOn('light');
const dark = themeOn('dark');

/** The theme that goes with the page: dark if its background is. */
export function themeOf(element: Element): Theme {
  const style = getComputedStyle(element);
  const background = colourOf(style.getPropertyValue('--bg'));
  if (background) return luminance(background) < 0.4 ? dark : light;
  return matchMedia('(prefers-color-scheme: dark)').matches ? dark : light;
}

/** `#rrggbb` or `rgb(r, g, b)`; anything else is null. */
function colourOf(text: string): Colour | null {
  const full = /^\s*#([0-9a-f]{6})\s*$/i.exec(text);
  if (full) return hex(`#${full[1]}`);
  const short = /^\s*#([0-9a-f])([0-9a-f])([0-9a-f])\s*$/i.exec(text);
  if (short) return hex(`#${short.slice(1).map((digit) => digit + digit).join('')}`);
  const numbers = /^\s*rgb\(\s*(\d+)[ ,]+(\d+)[ ,]+(\d+)/.exec(text);
  return numbers ? [Number(numbers[1]) / 255, Number(numbers[2]) / 255, Number(numbers[3]) / 255] : null;
}

function luminance([r, g, b]: Colour): number {
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/** Between two colours; share 0: the first. */
export function mixed(a: Colour, b: Colour, share: number): Colour {
  return [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])];
}
