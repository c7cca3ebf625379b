// Big sites by number: panels in blocks, set by gantries in one step a metre, as many steps a panel as asked for.

const robot = (reach: number) => `robot gantry {
  body bridge { param x range(-10, 1e5) step(${reach}) speed(2); frame trans(x, 0, 0); shape box(-0.4, -40, 24, 0.4, 40, 25); }
  body hoist on bridge {
    param y range(-40, 40) step(${reach}) speed(1);
    param z range(0, 23) step(${reach}) speed(1) start(20);
    frame trans(0, y, z);
    shape box(-0.2, -0.2, 0, 0.2, 0.2, 0.4);
  }
  tool hoist;
  behaviour "gantry.motion";
}
`;
const script = `chain { move_to(z, 20) };
chain { move_to(x, goal(x)) };
chain { move_to(y, goal(y)) };
chain { move_to(z, goal(z)) };
`;

/** The files of a plan that sets `panels` panels in some `steps` motion steps each. */
export function blockPlan(panels: number, steps: number): Record<string, string> {
  // Up, over, down with the hook, then the same with the panel: some 80 m a panel.
  const lines = ['plan block {', '  start_at "2026-03-02 07:00";', '  robot gantry "gantry.robot" { cost 180 per h; }',
    '  crew riggers { cost 165 per h; }', `  site box(-20, -45, -1, ${panels + 20}, 45, 0);`];
  for (let i = 0; i < panels; ++i) {
    lines.push(`  component panel_${i} { shape box(-0.1, -2, 0, 0.1, 2, 3); at trans(${i}, -6, 0); grip trans(0, 0, 3); mass 2 t; }`);
  }
  for (let i = 0; i < panels; ++i) {
    lines.push(`  task set_${i} { by gantry; move panel_${i} to trans(${i}, 6, 0); hook 2 min by riggers; release 1 min by riggers; }`);
  }
  return { 'plan.plan': `${lines.join('\n')}\n}\n`, 'gantry.robot': robot(80 / steps), 'gantry.motion': script };
}
