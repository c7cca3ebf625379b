/** What a chart is drawn with: on a canvas, or as SVG. Lengths in px, y downwards. */
export interface Painter {
  rect(x: number, y: number, width: number, height: number, fill: string): void;
  /** A frame of two px, inside of the rectangle. */
  frame(x: number, y: number, width: number, height: number, stroke: string): void;
  line(x0: number, y0: number, x1: number, y1: number, stroke: string, width: number): void;
  diamond(x: number, y: number, radius: number, fill: string): void;
  /** `y` is the middle of the line of text. */
  text(x: number, y: number, text: string, fill: string, bold?: boolean): void;
  /** What `draw` draws outside of the rectangle is not seen. */
  clip(x: number, y: number, width: number, height: number, draw: () => void): void;
}

export const fontFamily = "system-ui, 'Segoe UI', Roboto, 'DejaVu Sans', sans-serif";
export const fontSize = 11;

export class CanvasPainter implements Painter {
  constructor(private readonly pen: CanvasRenderingContext2D) {}

  rect(x: number, y: number, width: number, height: number, fill: string): void {
    this.pen.fillStyle = fill;
    this.pen.fillRect(x, y, width, height);
  }

  frame(x: number, y: number, width: number, height: number, stroke: string): void {
    this.pen.strokeStyle = stroke;
    this.pen.lineWidth = 2;
    this.pen.strokeRect(x + 1, y + 1, Math.max(width - 2, 1), Math.max(height - 2, 1));
  }

  line(x0: number, y0: number, x1: number, y1: number, stroke: string, width: number): void {
    this.pen.strokeStyle = stroke;
    this.pen.lineWidth = width;
    this.pen.beginPath();
    this.pen.moveTo(x0, y0);
    this.pen.lineTo(x1, y1);
    this.pen.stroke();
  }

  diamond(x: number, y: number, radius: number, fill: string): void {
    this.pen.fillStyle = fill;
    this.pen.beginPath();
    this.pen.moveTo(x, y - radius);
    this.pen.lineTo(x + radius, y);
    this.pen.lineTo(x, y + radius);
    this.pen.lineTo(x - radius, y);
    this.pen.fill();
  }

  text(x: number, y: number, text: string, fill: string, bold = false): void {
    this.pen.fillStyle = fill;
    this.pen.font = `${bold ? '600 ' : ''}${fontSize}px ${fontFamily}`;
    this.pen.textBaseline = 'middle';
    // First strong isolate: a name that runs from right to left leaves the rest of the line alone.
    this.pen.fillText(`\u2068${text}\u2069`, x, y);
  }

  clip(x: number, y: number, width: number, height: number, draw: () => void): void {
    this.pen.save();
    this.pen.beginPath();
    this.pen.rect(x, y, width, height);
    this.pen.clip();
    draw();
    this.pen.restore();
  }
}
