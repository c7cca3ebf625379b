/** How the page calls the attributes that the language knows; all others are called as in the plan. */
const labels = new Map([['name', 'Name'], ['storey', 'Storey'], ['type', 'Type'], ['guid', 'GUID']]);

/** The attributes of a component or a task, label and text: those that the language knows first, then the others in their order. */
export function attributeRows(attributes: Record<string, string> = {}): [label: string, text: string][] {
  const entries = Object.entries(attributes);
  const known = [...labels].flatMap(([key, label]) => entries.filter(([name]) => name === key)
    .map(([, text]): [string, string] => [label, text]));
  return [...known, ...entries.filter(([name]) => !labels.has(name))];
}
