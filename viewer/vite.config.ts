import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { defineConfig, type Plugin } from 'vite';
import { paletteStyles } from './palette_css';

/** What the page owes to those whose code it carries: each report is handed on alone. */
const NOTICE = `This page contains three.js (https://threejs.org).\n\n${
    readFileSync(new URL('node_modules/three/LICENSE', import.meta.url), 'utf8').trim()}`;
if (NOTICE.includes('--')) throw new Error('the licence of three.js cannot stand in a comment');

/**
 * Puts the built script and style sheet into the page itself, which then needs no other file, and lets the page run nothing
 * but this script: the browser refuses whatever a text of a plan might smuggle in.
 */
function onePage(name: string, notice: string): Plugin {
  const hash = (text: string) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
  return {
    name: 'one-page',
    enforce: 'post',
    generateBundle(_, bundle) {
      const page = bundle[name];
      if (!page || page.type !== 'asset') throw new Error(`no ${name} was built`);
      let script = '';
      let style = '';
      for (const [key, file] of Object.entries(bundle)) {
        if (file.type === 'chunk') script += file.code;
        else if (key.endsWith('.css')) style += String(file.source);
        if (key !== name) delete bundle[key];
      }
      script = script.trim().replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
      const policy = [
        "default-src 'none'", `script-src ${hash(script)}`, `style-src ${hash(style)}`, 'img-src data: blob:',
        "base-uri 'none'", "form-action 'none'",
      ].join('; ');
      page.source = String(page.source)
        .replace(/\s*<script type="module"[^>]*><\/script>/, '')
        .replace(/\s*<link rel="stylesheet"[^>]*>/, '')
        .replace('<meta charset="utf-8">',
                 () => `<meta charset="utf-8">\n${notice}<meta http-equiv="Content-Security-Policy" content="${policy}">`)
        .replace('</head>', () => `<style>${style}</style>\n</head>`)
        .replace('</body>', () => `<script type="module">${script}</script>\n</body>`);
    },
  };
}

// `vite build` makes the report page, `vite build --mode study` that of studies.
export default defineConfig(({ mode }) => ({
  plugins: [paletteStyles(), mode === 'study' ? onePage('study.html', '') : onePage('index.html', `<!--\n${NOTICE}\n-->\n`)],
  build: {
    target: 'es2022',
    assetsInlineLimit: 1e8,
    cssCodeSplit: false,
    modulePreload: false,
    chunkSizeWarningLimit: 2000,
    emptyOutDir: false,
    rollupOptions: { input: mode === 'study' ? 'study.html' : 'index.html', output: { inlineDynamicImports: true } },
  },
}));
