import { nextLength } from '../lengths';
import type { Player } from '../player';

/** The keys of the page, unless what has the focus needs the key itself. */
export function listenToKeys(player: Player): void {
  document.addEventListener('keydown', (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey) return;
    if (document.querySelector('dialog[open]')) return;
    if (event.target instanceof Element && needs(event.target, event.key)) return;
    const action = actionOf(player, event);
    if (!action) return;
    event.preventDefault();
    action();
  });
}

function actionOf(player: Player, { key, shiftKey }: KeyboardEvent): (() => void) | null {
  switch (key) {
    case ' ': return () => player.toggle();
    case 'ArrowRight': return () => { if (shiftKey) player.step(1); else player.nextComponent(); };
    case 'ArrowLeft': return () => { if (shiftKey) player.step(-1); else player.previousComponent(); };
    case 'Escape': return () => { player.goToRecord(null); player.select(null); };
    case 'Home': return () => player.seek(0);
    case 'End': return () => player.seek(player.end);
    case 'ArrowUp': case '>': return () => player.setLength(nextLength(player.length, 1));
    case 'ArrowDown': case '<': return () => player.setLength(nextLength(player.length, -1));
    default: return null;
  }
}

/** Whether an element does something of its own with a key. */
function needs(target: Element, key: string): boolean {
  if (target.matches('input[type="checkbox"], button, [role="button"], summary')) return key === ' ' || key === 'Enter';
  if (target.closest('.scrolls, .rows, .list')) return ['ArrowUp', 'ArrowDown', 'Home', 'End'].includes(key);
  return target.matches('input, select, textarea, [contenteditable]');
}
