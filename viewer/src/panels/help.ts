import { button, make } from './dom';

const keys: [string, string][] = [
  ['Space', 'play, pause'],
  ['← →', 'previous, next component'],
  ['Shift ← →', 'previous, next attempt (the Steps follow)'],
  ['Home, End', 'beginning, end'],
  ['↑ ↓ or > <', 'faster, slower: the animation takes 30 s, 1 min, 3 min, or as long as it took'],
  ['Gantt: wheel, + −', 'zoom; 0 shows all'],
  ['Gantt: drag, arrows', 'move'],
  ['Gantt: Enter, Shift Enter', 'next, previous task'],
  ['Steps: ↑ ↓', 'previous, next record'],
  ['Steps: a line with a blue number', 'on to the next record from this line'],
  ['Site: drag, wheel', 'turn, zoom; right button moves; a click picks, a double click goes there'],
  ['Site: W A S D, + −', 'turn, zoom; with Shift move'],
  ['Site: F, 0, 1 2 3, 4', 'all; from the corner, above, front, side; ride on the machine'],
  ['Site: [ ], P, Z', 'section lower, higher; paths; zones'],
  ['Escape', 'pick nothing, leave the steps'],
  ['?', 'this list'],
];

/** What keys do. */
export function makeHelp(): HTMLDialogElement {
  const body = make('tbody');
  for (const [key, what] of keys) {
    body.append(make('tr', {}, make('th', { scope: 'row' }, make('kbd', {}, key)), make('td', { class: 'start' }, what)));
  }
  const dialog = make('dialog', { 'aria-label': 'Keys and hints' }, make('h2', {}, 'Keys and hints'), make('table', {}, body));
  dialog.append(button('Close', () => dialog.close()));
  document.addEventListener('keydown', (event) => {
    if (event.key !== '?' || dialog.open || event.target instanceof HTMLInputElement) return;
    event.preventDefault();
    dialog.showModal();
  });
  return dialog;
}
