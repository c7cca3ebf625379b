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
  machines: Colour[];
  components: Colour[];
}

const light: Theme = {
  dark: false,
  skyTop: hex('#d3dfec'), skyBelow: hex('#f6f7f8'), ground: hex('#e4e2dc'), fixture: hex('#c9c5bb'), grid: hex('#a9a69d'),
  label: hex('#6b6f76'), edge: hex('#2c333d'), waiting: hex('#bcc0c5'), carried: hex('#ff9d1c'), selected: hex('#1664d9'),
  moved: hex('#d6243a'), met: hex('#f08a12'), zone: hex('#e8a400'), goal: hex('#2a8a4a'), rope: hex('#3b434e'),
  machines: ['#e8b63a', '#4d8fc4', '#5aa886', '#a97bb8', '#cf7560', '#7f8ea3'].map(hex),
  components: ['#c98f6b', '#8fae9b', '#93a7c4', '#d3ba84', '#b490a8', '#7fb0b5', '#c4a3a0', '#a5b57c', '#8c93b3', '#d0a56f',
    '#9db8a8', '#b8a58f'].map(hex),
};

const dark: Theme = {
  dark: true,
  skyTop: hex('#10161f'), skyBelow: hex('#2a323d'), ground: hex('#363d46'), fixture: hex('#4c545e'), grid: hex('#606a76'),
  label: hex('#a3adb9'), edge: hex('#0c1015'), waiting: hex('#727a84'), carried: hex('#ffae42'), selected: hex('#5aa2ff'),
  moved: hex('#ff4a5e'), met: hex('#ffa336'), zone: hex('#ffc93c'), goal: hex('#5fd38a'), rope: hex('#c4ccd6'),
  machines: ['#d9a630', '#4a88bb', '#509a7a', '#9d70ac', '#bf6a57', '#74839a'].map(hex),
  components: ['#bd8561', '#7f9f8b', '#8297b6', '#c1a973', '#a58099', '#70a1a6', '#b59491', '#95a56d', '#7d85a6', '#be9561',
    '#8daa99', '#a8957f'].map(hex),
};

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
