import { cut, make } from './dom';

/** A small card beside the pointer; there is one on the page. */
let card: HTMLElement | null = null;

/** Shows lines of text beside a point of the window (px), or above it. */
export function showHint(x: number, y: number, lines: string[], above = false): void {
  if (!card) {
    card = make('div', { class: 'hint', role: 'tooltip' });
    document.body.append(card);
  }
  card.classList.remove('hidden');
  card.replaceChildren(...lines.map((line) => make('p', {}, make('bdi', {}, cut(line, 200)))));
  const { offsetWidth, offsetHeight } = card;
  const left = x + 14 + offsetWidth > innerWidth ? x - 10 - offsetWidth : x + 14;
  const top = above || y + 16 + offsetHeight > innerHeight ? y - 12 - offsetHeight : y + 16;
  card.style.transform = `translate(${Math.max(left, 4)}px, ${Math.max(top, 4)}px)`;
}

export function hideHint(): void {
  card?.classList.add('hidden');
}
