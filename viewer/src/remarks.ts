import type { Header } from './header';

/**
 * What the plan's texts say in the lines directly above `component NAME {`: for imported elements their storey, type, name and
 * GlobalId. By the name in the text; that of a component of a module is the last part of its full name.
 */
export function readRemarks(header: Header): Map<string, string> {
  const remarks = new Map<string, string>();
  for (const { text } of header.files) {
    let lines: string[] = [];
    for (const line of text.split('\n')) {
      const remark = /^\s*(?:\/\/|#)\s?(.*?)\s*$/.exec(line);
      if (remark) {
        lines.push(remark[1]);
        continue;
      }
      const name = /^\s*component\s+([^\s{;]+)/.exec(line)?.[1];
      if (name !== undefined && lines.length > 0 && !remarks.has(name)) remarks.set(name, lines.join('\n').trim());
      lines = [];
    }
  }
  return remarks;
}

/** What an import writes above an element of a building model. */
export interface Origin {
  storey: string;
  /** `IfcSlab 'vloer_V0'` */
  what: string;
  guid: string;
}

/**
 * The origin that a remark tells in its last line: `'ground floor', IfcSlab 'Deck', 2O2Fr$t4X7Zf8NOew3FLOH`. What stands above is
 * about the plan, not about the element. Null: it is a remark in somebody's own words.
 */
export function originOf(remark: string): Origin | null {
  const line = remark.slice(remark.lastIndexOf('\n') + 1);
  const parts = /^(?:'(.*)', )?(Ifc\w+(?: '.*')?), ([0-9A-Za-z_$]{22})$/.exec(line);
  return parts && { storey: parts[1] ?? '', what: parts[2], guid: parts[3] };
}

/** The remark of a component by its full name, such as `u_1_2.wall_3`; empty if it has none. */
export function remarkOf(remarks: Map<string, string>, component: string): string {
  return remarks.get(component) ?? remarks.get(component.slice(component.lastIndexOf('.') + 1)) ?? '';
}
