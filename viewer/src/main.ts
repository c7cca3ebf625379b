import { readFilm } from './film';
import { Player } from './player';

async function open(): Promise<void> {
  const film = await readFilm(document.getElementById('film')?.textContent ?? '');
  const player = new Player(film);
  let last = performance.now();
  const frame = (now: number) => {
    player.tick(Math.min((now - last) / 1000, 0.25));
    last = now;
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}

open().catch((error: unknown) => {
  const view = document.getElementById('view');
  if (view) view.textContent = `This report cannot be shown: ${error instanceof Error ? error.message : String(error)}`;
});
