/** The colours of the page now, by the name of their custom property without the dashes. */
export function palette(): Record<string, string> {
  const style = getComputedStyle(document.documentElement);
  const names = ['bg', 'panel', 'raised', 'text', 'muted', 'line', 'accent', 'good', 'bad', 'warn', 'focus', 'machine', 'crew',
    'wait', 'critical', 'off', 'pick'];
  return Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
}

const dark = matchMedia('(prefers-color-scheme: dark)');
const key = 'rubicon-theme';

/** Whether the page is dark now: what was chosen, else what the system says. */
export function isDark(): boolean {
  const chosen = document.documentElement.dataset.theme;
  return chosen ? chosen === 'dark' : dark.matches;
}

/** Takes up what was chosen before, where the browser lets a page remember. */
export function restoreTheme(): void {
  try {
    const chosen = localStorage.getItem(key);
    if (chosen === 'dark' || chosen === 'light') document.documentElement.dataset.theme = chosen;
  } catch {
    // A page from disk may have no storage; then the system's theme it is.
  }
  dark.addEventListener('change', tell);
}

export function toggleTheme(): void {
  const next = isDark() ? 'light' : 'dark';
  document.documentElement.dataset.theme = next;
  try {
    localStorage.setItem(key, next);
  } catch {
    // Not remembered, but shown.
  }
  tell();
}

/** Calls when the colours changed: what is drawn on a canvas must be drawn anew. */
export function onTheme(listener: () => void): void {
  document.addEventListener('rubicon-theme', listener);
}

function tell(): void {
  document.dispatchEvent(new Event('rubicon-theme'));
}
