/** Hands a file to the one who reads the page. */
export function download(name: string, content: Blob): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** A name that every file system takes: letters and digits of a plan's name. */
export function fileName(plan: string, ending: string, what = 'gantt'): string {
  const plain = plan.replace(/[^A-Za-z0-9_-]+/g, '_').replace(/^_+|_+$/g, '').slice(0, 60);
  return `${plain || 'plan'}_${what}.${ending}`;
}
