/**
 * An element with attributes and children. What plans say gets into the page here and as text only; styles and handlers are no
 * attributes (the page's policy refuses them).
 */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Record<string, string> = {}, ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

/** A button; with children it shows these, and its label is what is heard and hinted. */
export function button(
  label: string, press: () => void, attributes: Record<string, string> = {}, ...children: (Node | string)[]
): HTMLButtonElement {
  const element = make('button', { type: 'button', ...attributes }, ...(children.length ? children : [label]));
  if (children.length) {
    element.setAttribute('aria-label', label);
    element.title = label;
  }
  element.addEventListener('click', press);
  return element;
}

/** An icon of 16 x 16 from the path data of SVG. */
export function icon(path: string): SVGSVGElement {
  const space = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(space, 'svg');
  svg.setAttribute('viewBox', '0 0 16 16');
  svg.setAttribute('aria-hidden', 'true');
  const shape = document.createElementNS(space, 'path');
  shape.setAttribute('d', path);
  svg.append(shape);
  return svg;
}

/** At most so many characters of a text, none cut in two; an ellipsis says if there was more. */
export function cut(text: string, most: number): string {
  if (text.length <= most) return text;
  const last = text.charCodeAt(most - 1);
  return `${text.slice(0, last >= 0xd800 && last < 0xdc00 ? most - 1 : most)}…`;
}

/** A name or sentence out of a plan: set apart from the direction of the text around it; the whole of it (almost) as a hint. */
export function named(text: string, most = 300): HTMLElement {
  const element = make('bdi', {}, cut(text, most));
  element.title = cut(text, 300);
  return element;
}

/** A list that was opened with the mouse keeps no focus once something is chosen: keys go on meaning the page. */
export function givesBackFocus(select: HTMLSelectElement): void {
  let byMouse = false;
  select.addEventListener('pointerdown', () => { byMouse = true; });
  select.addEventListener('keydown', () => { byMouse = false; });
  select.addEventListener('change', () => { if (byMouse) select.blur(); });
}

/** Changes a text only if it is another. */
export function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** Calls at most once a frame, however often it is asked to. */
export function onceAFrame(action: () => void): () => void {
  let asked = false;
  return () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      action();
    });
  };
}
