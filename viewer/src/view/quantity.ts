/** A number with at most so many decimals, and no -0. */
export function quantity(value: number, decimals: number): string {
  return String(Number(value.toFixed(decimals)) + 0);
}
