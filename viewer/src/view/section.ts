import type { Player } from '../player';
import { make } from './elements';

/** Steps of the slider from the ground to the top. */
const steps = 200;

/** The slider at the left: above its height nothing is drawn. At its top nothing is cut. */
export class Section {
  readonly element = make('div', 'view-section');
  private readonly slider = make('input');
  private readonly height = make('output');

  /** From `low` to `high` (m). */
  constructor(private readonly player: Player, private readonly low: number, private readonly high: number) {
    const { slider, height } = this;
    slider.type = 'range';
    slider.min = '0';
    slider.max = String(steps);
    slider.step = '1';
    slider.title = 'Cut the building open at a height ([ and ] in the view)';
    slider.setAttribute('aria-label', 'Section height');
    slider.setAttribute('aria-orientation', 'vertical');
    slider.addEventListener('input', () => this.set(Number(slider.value)));
    // The arrows are the slider's here, not the playback's.
    slider.addEventListener('keydown', (event) => event.stopPropagation());
    const label = make('span', '', 'Section');
    label.setAttribute('aria-hidden', 'true');
    // What the slider says need not be said twice.
    height.setAttribute('aria-hidden', 'true');
    this.element.append(label, slider, height);
    this.show();
  }

  /** Lower (negative) or higher by so many steps. */
  nudge(by: number): void {
    this.set(Math.min(Math.max(Number(this.slider.value) + by, 0), steps));
  }

  show(): void {
    const { section } = this.player;
    const value = section === null ? steps : Math.round(((section - this.low) / (this.high - this.low)) * steps);
    this.slider.value = String(value);
    const text = section === null ? 'off' : `${section.toFixed(1)} m`;
    this.height.textContent = text;
    this.slider.setAttribute('aria-valuetext', section === null ? 'nothing is cut' : `cut at ${text}`);
  }

  private set(value: number): void {
    this.player.setSection(value >= steps ? null : this.low + ((this.high - this.low) * value) / steps);
  }
}
