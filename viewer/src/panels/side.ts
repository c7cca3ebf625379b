import { button, make } from './dom';
import type { TabName } from './page';

const narrowest = 400;
/** What is left to the site, at least (px). */
const leastView = 320;

/** Whether a tab is seen; calls when it comes to be seen (also when its size changed). */
export interface Shown {
  now(): boolean;
  on(listener: () => void): void;
}

export interface Side {
  open(tab: TabName): void;
  panel(tab: TabName): HTMLElement;
  shows(tab: TabName): Shown;
}

/** The tabs on the right, and the splitter that makes them wider. */
export function mountSide(host: HTMLElement, names: TabName[]): Side {
  const list = make('div', { role: 'tablist', 'aria-label': 'What is shown' });
  // The mouse takes no focus here: arrows go on meaning components, unless somebody came by the keyboard.
  list.addEventListener('mousedown', (event) => event.preventDefault());
  const tabs = new Map<TabName, HTMLButtonElement>();
  const panels = new Map<TabName, HTMLElement>();
  const listeners = new Map<TabName, (() => void)[]>();
  const isOpen = (name: TabName) => tabs.get(name)?.getAttribute('aria-selected') === 'true';
  const open = (name: TabName) => {
    for (const each of names) {
      const is = each === name;
      tabs.get(each)?.setAttribute('aria-selected', String(is));
      tabs.get(each)?.setAttribute('tabindex', is ? '0' : '-1');
      panels.get(each)?.toggleAttribute('hidden', !is);
    }
    for (const listener of listeners.get(name) ?? []) listener();
  };
  names.forEach((name, i) => {
    const tab = button(name, () => open(name), { role: 'tab', id: `tab-${name}`, 'aria-controls': `panel-${name}` });
    tab.addEventListener('keydown', (event) => {
      const to = { ArrowLeft: i - 1, ArrowRight: i + 1, Home: 0, End: names.length - 1 }[event.key];
      if (to === undefined || event.shiftKey) return;
      event.preventDefault();
      event.stopPropagation();
      const next = names[(to + names.length) % names.length];
      open(next);
      tabs.get(next)?.focus();
    });
    tabs.set(name, tab);
    panels.set(name, make('div', { role: 'tabpanel', id: `panel-${name}`, 'aria-labelledby': `tab-${name}` }));
    list.append(tab);
  });
  host.append(makeSplitter(host), list, ...panels.values());
  open('Overview');
  new ResizeObserver(() => {
    for (const name of names) if (isOpen(name)) for (const listener of listeners.get(name) ?? []) listener();
  }).observe(host);
  return {
    open,
    panel: (name) => panels.get(name) ?? make('div'),
    shows: (name) => ({
      now: () => isOpen(name),
      on: (listener) => { listeners.set(name, [...listeners.get(name) ?? [], listener]); },
    }),
  };
}

function makeSplitter(host: HTMLElement): HTMLElement {
  const splitter = make('div', { class: 'splitter', role: 'separator', tabindex: '0', 'aria-orientation': 'vertical',
    'aria-label': 'Width of the tables', 'aria-controls': host.id });
  const widest = () => Math.max(innerWidth - leastView, narrowest);
  const tell = () => {
    splitter.setAttribute('aria-valuemin', String(narrowest));
    splitter.setAttribute('aria-valuemax', String(widest()));
    splitter.setAttribute('aria-valuenow', String(Math.round(host.offsetWidth)));
  };
  const set = (width: number) => {
    const px = Math.round(Math.min(Math.max(width, narrowest), widest()));
    document.getElementById('app')?.style.setProperty('--side', `${px}px`);
    tell();
  };
  splitter.addEventListener('pointerdown', (event) => {
    splitter.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  splitter.addEventListener('pointermove', (event) => {
    if (splitter.hasPointerCapture(event.pointerId)) set(innerWidth - event.clientX);
  });
  splitter.addEventListener('keydown', (event) => {
    const by = { ArrowLeft: 20, ArrowRight: -20, Home: -1e4, End: 1e4 }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    set(host.offsetWidth + by);
  });
  splitter.addEventListener('dblclick', () => {
    document.getElementById('app')?.style.removeProperty('--side');
    tell();
  });
  addEventListener('resize', () => { if (host.offsetWidth > widest()) set(widest()); });
  new ResizeObserver(tell).observe(host);
  return splitter;
}
