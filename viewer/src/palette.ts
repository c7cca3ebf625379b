import table from '../../src/results/palette/palette.json';

/** The one table of colours, of which the chart, the glTF and the terminal of the command are made too. */
export const palette = table;
export type Ground = 'light' | 'dark';
