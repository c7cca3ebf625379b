import { draw } from '../study/chart';

/** What the style sheets of the page give to parts of a drawing. */
const looks = ['fill', 'fill-opacity', 'stroke', 'stroke-opacity', 'stroke-width', 'stroke-linecap', 'paint-order', 'font-family', 'font-size', 'font-weight', 'text-anchor'];
const hidden = new Set(['none', 'hidden']);
/** Of the lines below the drawing (px). */
const lineHeight = 16;
const letter = 6.2;

/** A text in lines of so many letters at most, longer words apart. */
export function wrapped(text: string, most: number): string[] {
  const lines: string[] = [];
  for (const word of text.split(/\s+/).filter((each) => each !== '')) {
    const last = lines[lines.length - 1];
    if (last !== undefined && last.length + 1 + word.length <= most) lines[lines.length - 1] = `${last} ${word}`;
    else lines.push(word);
  }
  return lines;
}

/** A drawing of the page as a file of its own: with its looks, on the ground of the page, and paragraphs below it. */
export function svgFile(svg: SVGElement, ground: string, paragraphs: string[]): string {
  const copy = svg.cloneNode(true) as SVGElement;
  const [originals, copies] = [svg, copy].map((each) => Array.from(each.querySelectorAll<SVGElement>('*')));
  originals.forEach((original, i) => {
    const style = getComputedStyle(original);
    for (const name of looks) copies[i].setAttribute(name, style.getPropertyValue(name).replaceAll('"', "'"));
    copies[i].removeAttribute('class');
    if (hidden.has(style.visibility) || hidden.has(style.display)) copies[i].setAttribute('visibility', 'hidden');
  });
  const [, , width, height] = (svg.getAttribute('viewBox') ?? '0 0 0 0').split(' ').map(Number);
  const style = getComputedStyle(svg);
  const lines = paragraphs.flatMap((each) => wrapped(each, Math.floor((width - 24) / letter)));
  const whole = height + (lines.length + 1) * lineHeight;
  copy.removeAttribute('class');
  for (const [name, value] of [['xmlns', 'http://www.w3.org/2000/svg'], ['width', width], ['height', whole], ['viewBox', `0 0 ${width} ${whole}`]]) {
    copy.setAttribute(String(name), String(value));
  }
  copy.prepend(draw('rect', { width, height: whole, fill: ground }));
  lines.forEach((line, i) => copy.append(draw('text', { x: 12, y: height + (i + 1) * lineHeight, fill: style.color, 'font-size': 11, 'font-family': 'sans-serif' }, line)));
  return new XMLSerializer().serializeToString(copy);
}
