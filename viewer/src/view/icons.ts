/** Strokes of 16 x 16 drawings. */
const drawings = {
  fit: 'M2 6V2h4M10 2h4v4M14 10v4h-4M6 14H2v-4M6 6h4v4H6z',
  top: 'M3 3h10v10H3zM3 8h10M8 3v10',
  front: 'M2 13h12M4 13V5l4-2.5L12 5v8M7 13V9h2v4',
  side: 'M2 13h12M3 13V6l10-3v10M6 13V9.5M10 13V8.5',
  machine: 'M2 14h5M4.5 14V2M2 4.5h12M4.5 2L14 4.5M12 4.5v4M10.5 8.5h3v2.5h-3z',
  paths: 'M2.5 13.5c4-1 2-6 5.5-7s2.5-3 5-4M2.5 13.5h.01M13 2.5h.01',
  zones: 'M3 3h10v10H3zM3 9l6-6M3 13L13 3M7 13l6-6',
  workspaces: 'M2 8l3-5h6l3 5-3 5H5zM6.5 6.5h3v3h-3z',
  search: 'M2 14l4-4M6 10l1-5M6 10l5 1M7 5l-3-3M7 5l5-3M11 11l3-3M11 11l2 3',
  beams: 'M2 5h12M2 11h12M5 2v12M11 2v12',
  cells: 'M2.5 2.5h11v11h-11zM8 2.5v11M8 8h5.5',
  adjacency: 'M2 2h4v4H2zM10 10h4v4h-4zM10 2h4v4h-4zM6 4h4M12 6v4',
  order: 'M3 4.5l1.5-1.5v5M9 3h4.5M12 1.5L13.5 3 12 4.5M3 11h3v1.5H3V14h3M9 12.5h4.5M12 11l1.5 1.5L12 14',
  lines: 'M2 3h11.5v3.5H2.5V10H14M2 13.5h12',
  close: 'M4 4l8 8M12 4l-8 8',
} as const;
export type IconName = keyof typeof drawings;

export function icon(name: IconName): SVGSVGElement {
  const space = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(space, 'svg');
  svg.setAttribute('viewBox', '0 0 16 16');
  svg.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(space, 'path');
  path.setAttribute('d', drawings[name]);
  svg.append(path);
  return svg;
}
