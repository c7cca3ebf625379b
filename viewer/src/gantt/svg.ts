import { fontFamily, fontSize, type Painter } from './painter';

/** Draws into the text of an SVG file. */
export class SvgPainter implements Painter {
  private readonly parts: string[] = [];
  private clips = 0;

  rect(x: number, y: number, width: number, height: number, fill: string): void {
    if (width <= 0 || height <= 0) return;
    this.parts.push(`<rect x="${px(x)}" y="${px(y)}" width="${px(width)}" height="${px(height)}" fill="${escaped(fill)}"/>`);
  }

  frame(x: number, y: number, width: number, height: number, stroke: string): void {
    this.parts.push(`<rect x="${px(x + 1)}" y="${px(y + 1)}" width="${px(Math.max(width - 2, 1))}" `
      + `height="${px(Math.max(height - 2, 1))}" fill="none" stroke="${escaped(stroke)}" stroke-width="2"/>`);
  }

  line(x0: number, y0: number, x1: number, y1: number, stroke: string, width: number): void {
    this.parts.push(`<line x1="${px(x0)}" y1="${px(y0)}" x2="${px(x1)}" y2="${px(y1)}" `
      + `stroke="${escaped(stroke)}" stroke-width="${px(width)}"/>`);
  }

  diamond(x: number, y: number, radius: number, fill: string): void {
    const corners = [[x, y - radius], [x + radius, y], [x, y + radius], [x - radius, y]];
    this.parts.push(`<polygon points="${corners.map(([a, b]) => `${px(a)},${px(b)}`).join(' ')}" fill="${escaped(fill)}"/>`);
  }

  text(x: number, y: number, text: string, fill: string, bold = false): void {
    // A third of the size below the middle is the base line.
    const weight = bold ? ' font-weight="600"' : '';
    this.parts.push(`<text x="${px(x)}" y="${px(y + fontSize * 0.35)}" fill="${escaped(fill)}"${weight} unicode-bidi="isolate">`
      + `${escaped(text)}</text>`);
  }

  clip(x: number, y: number, width: number, height: number, draw: () => void): void {
    const id = `clip${++this.clips}`;
    this.parts.push(`<clipPath id="${id}"><rect x="${px(x)}" y="${px(y)}" width="${px(Math.max(width, 0))}" `
      + `height="${px(Math.max(height, 0))}"/></clipPath><g clip-path="url(#${id})">`);
    draw();
    this.parts.push('</g>');
  }

  /** The file; `title` is what it is called where pictures have names. */
  document(width: number, height: number, title: string): string {
    return '<?xml version="1.0" encoding="UTF-8"?>\n'
      + `<svg xmlns="http://www.w3.org/2000/svg" width="${px(width)}" height="${px(height)}" `
      + `viewBox="0 0 ${px(width)} ${px(height)}" font-family="${escaped(fontFamily)}" font-size="${fontSize}">\n`
      + `<title>${escaped(title)}</title>\n${this.parts.join('\n')}\n</svg>\n`;
  }
}

/** Text for XML: markup as entities, what XML does not know (control characters, halves of surrogate pairs) as U+FFFD. */
export function escaped(text: string): string {
  const known = text.replace(/[\u0000-\u0008\u000b\u000c\u000e-\u001f\ufffe\uffff]|\p{Cs}/gu, '\ufffd');
  return known.replace(/[&<>"']/g, (letter) => `&#${letter.charCodeAt(0)};`);
}

function px(value: number): string {
  return String(Number(value.toFixed(2)));
}
