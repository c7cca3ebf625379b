import type { Plugin } from 'vite';
import { palette, type Ground } from './src/palette';

/** The custom properties of the page for a ground. */
function properties(ground: Ground): string {
  const lines = Object.entries(palette[ground].page).map(([name, colour]) => `--${name}: ${colour};`);
  return [`color-scheme: ${ground};`, ...lines].join(' ');
}

/** The colours of the page as a style sheet: light, and dark where that is chosen, or the system has it and nothing is chosen. */
export function paletteCss(): string {
  return `:root { ${properties('light')} }\n`
    + `:root[data-theme='dark'] { ${properties('dark')} }\n`
    + `@media (prefers-color-scheme: dark) { :root:not([data-theme='light']) { ${properties('dark')} } }\n`;
}

/** Puts them behind what styles.css and study.css import. */
export function paletteStyles(): Plugin {
  return {
    name: 'palette',
    enforce: 'pre',
    transform: (code, id) => (/\/src\/(styles|study)\.css$/.test(id) ? code + paletteCss() : null),
  };
}
