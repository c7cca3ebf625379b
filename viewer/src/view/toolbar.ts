import { make } from './elements';
import { icon, type IconName } from './icons';

export interface Tool {
  name: IconName;
  label: string;
  title: string;
  /** Whether it is switched on and off. */
  toggle?: boolean;
  press: () => void;
}

/** Buttons of the view. */
export class Toolbar {
  readonly element = make('div', 'view-tools');
  private readonly buttons = new Map<IconName, HTMLButtonElement>();

  constructor(groups: Tool[][]) {
    this.element.setAttribute('role', 'toolbar');
    this.element.setAttribute('aria-label', 'Views');
    for (const tools of groups) {
      const group = make('div', 'view-group');
      for (const tool of tools) {
        const button = make('button');
        button.type = 'button';
        button.title = tool.title;
        // Its name is what is seen, also where there is no room for words; the rest is its description.
        button.setAttribute('aria-label', tool.label);
        button.dataset.tool = tool.name;
        button.append(icon(tool.name), make('span', '', tool.label));
        button.addEventListener('click', tool.press);
        if (tool.toggle) button.setAttribute('aria-pressed', 'false');
        this.buttons.set(tool.name, button);
        group.append(button);
      }
      this.element.append(group);
    }
  }

  setPressed(name: IconName, pressed: boolean): void {
    this.buttons.get(name)?.setAttribute('aria-pressed', String(pressed));
  }

  setEnabled(name: IconName, enabled: boolean): void {
    const button = this.buttons.get(name);
    if (button) button.disabled = !enabled;
  }
}
