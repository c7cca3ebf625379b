// Formulas and frames as the trace writes them (docs/trace.md): what a body's frame is made of.

/** The value of a formula at a configuration: the parameters in the order of the header (m, degrees). */
export type Formula = (q: ArrayLike<number>) => number;

/** One factor of a frame: a shift (m) or a turn about an axis (degrees). */
export type FrameElement =
  | { kind: 'trans'; x: Formula; y: Formula; z: Formula }
  | { kind: 'rotx' | 'roty' | 'rotz'; angle: Formula };

export class FormulaError extends Error {}

const degree = Math.PI / 180;

/** Sine of degrees; exact at the right angles, as the simulator's is. */
export function sinDegrees(a: number): number {
  const turn = ((a % 360) + 360) % 360;
  if (turn % 180 === 0) return 0;
  if (turn === 90) return 1;
  if (turn === 270) return -1;
  return Math.sin(turn * degree);
}

export function cosDegrees(a: number): number {
  return sinDegrees(a + 90);
}

/**
 * Parses a frame such as `trans(x, 0, z - 9) * rotz(jib.theta)`; `names` are the parameters' in the order of their values. Throws
 * FormulaError.
 */
export function parseFrame(text: string, names: string[]): FrameElement[] {
  return new Parser(text, names).frame();
}

/** Parses a formula such as `(2 * hook.z - 68) / 3`. Throws FormulaError. */
export function parseFormula(text: string, names: string[]): Formula {
  return new Parser(text, names).formula();
}

/** Recursive descent; what it has read ends at `at`. */
class Parser {
  private readonly tokens: string[];
  private at = 0;

  constructor(private readonly text: string, private readonly names: string[]) {
    this.tokens = text.match(/\d+\.?\d*(?:e[+-]?\d+)?|\.\d+(?:e[+-]?\d+)?|[^\s()*/+,-]+|\S/gi) ?? [];
  }

  frame(): FrameElement[] {
    const elements = [this.element()];
    while (this.take('*')) elements.push(this.element());
    this.finish();
    return elements;
  }

  formula(): Formula {
    const value = this.sum();
    this.finish();
    return value;
  }

  private element(): FrameElement {
    const kind = this.tokens[this.at++];
    if (kind !== 'trans' && kind !== 'rotx' && kind !== 'roty' && kind !== 'rotz') throw this.wrong('trans, rotx, roty or rotz');
    this.expect('(');
    const first = this.sum();
    if (kind !== 'trans') {
      this.expect(')');
      return { kind, angle: first };
    }
    this.expect(',');
    const y = this.sum();
    this.expect(',');
    const z = this.sum();
    this.expect(')');
    return { kind, x: first, y, z };
  }

  private sum(): Formula {
    let left = this.product();
    for (;;) {
      const a = left;
      if (this.take('+')) {
        const b = this.product();
        left = (q) => a(q) + b(q);
      } else if (this.take('-')) {
        const b = this.product();
        left = (q) => a(q) - b(q);
      } else {
        return left;
      }
    }
  }

  private product(): Formula {
    let left = this.factor();
    for (;;) {
      const a = left;
      if (this.take('*')) {
        const b = this.factor();
        left = (q) => a(q) * b(q);
      } else if (this.take('/')) {
        const b = this.factor();
        left = (q) => a(q) / b(q);
      } else {
        return left;
      }
    }
  }

  private factor(): Formula {
    if (this.take('-')) {
      const a = this.factor();
      return (q) => -a(q);
    }
    if (this.take('(')) {
      const inner = this.sum();
      this.expect(')');
      return inner;
    }
    const token = this.tokens[this.at++] ?? '';
    const place = this.names.indexOf(token);
    if (place >= 0) return (q) => q[place];
    if ((token === 'sin' || token === 'cos') && this.take('(')) {
      const a = this.sum();
      this.expect(')');
      return token === 'sin' ? (q) => sinDegrees(a(q)) : (q) => cosDegrees(a(q));
    }
    if (/^[.\d]/.test(token)) {
      const value = Number(token);
      return () => value;
    }
    throw this.wrong('a number, a parameter, sin, cos or (');
  }

  private take(token: string): boolean {
    if (this.tokens[this.at] !== token) return false;
    ++this.at;
    return true;
  }

  private expect(token: string): void {
    if (this.take(token)) return;
    ++this.at;
    throw this.wrong(token);
  }

  private finish(): void {
    if (this.at === this.tokens.length) return;
    ++this.at;
    throw this.wrong('the end');
  }

  private wrong(expected: string): FormulaError {
    return new FormulaError(`expected ${expected}, found '${this.tokens[this.at - 1] ?? ''}' in '${this.text}'`);
  }
}
