import type { ViewName } from './rig';

/** What keys do while the view has the focus; those of the playback (space, arrows, Home, End) stay the page's. */
export interface KeyActions {
  nudge: (right: number, up: number, nearer: number, sideways: boolean) => void;
  fit: () => void;
  look: (view: ViewName) => void;
  machine: () => void;
  toggle: (what: 'paths' | 'zones') => void;
  section: (by: number) => void;
  drop: () => void;
}

const keyHelp = 'F fits; 1, 2, 3 look from above, the front, the side; 4 rides on the machine; 0 looks from the corner; '
  + 'W A S D turn, with Shift they move; + and - bring near and away; [ and ] lower and raise the section; P paths, Z zones; '
  + 'Escape picks nothing';

export function bindKeys(canvas: HTMLCanvasElement, actions: KeyActions): void {
  canvas.setAttribute('role', 'application');
  canvas.setAttribute('aria-label', 'The site in 3D');
  canvas.setAttribute('aria-description', `Keys: ${keyHelp}.`);
  canvas.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || !act(event.key, event.shiftKey, actions)) return;
    event.preventDefault();
    event.stopPropagation();
  });
}

function act(key: string, shift: boolean, actions: KeyActions): boolean {
  switch (key.toLowerCase()) {
    case 'w': actions.nudge(0, 1, 0, shift); break;
    case 's': actions.nudge(0, -1, 0, shift); break;
    case 'a': actions.nudge(-1, 0, 0, shift); break;
    case 'd': actions.nudge(1, 0, 0, shift); break;
    case '+': case '=': actions.nudge(0, 0, 1, false); break;
    case '-': case '_': actions.nudge(0, 0, -1, false); break;
    case 'f': actions.fit(); break;
    case '0': actions.look('free'); break;
    case '1': actions.look('top'); break;
    case '2': actions.look('front'); break;
    case '3': actions.look('side'); break;
    case '4': actions.machine(); break;
    case 'p': actions.toggle('paths'); break;
    case 'z': actions.toggle('zones'); break;
    case '[': actions.section(-4); break;
    case ']': actions.section(4); break;
    case 'escape': actions.drop(); break;
    default: return false;
  }
  return true;
}
