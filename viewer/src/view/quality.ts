/** Pixels of the picture in one of the page: how sharp it may be, finest first. Above the screen's own it is smoother. */
const levels = [2, 1.5, 1, 0.8, 0.65, 0.5];
/** Milliseconds between pictures: above the first it gets coarser, below the second finer. */
const slow = 29;
const quick = 18;
/** Pictures after which the level is thought over. */
const window = 12;
/** How often in a row that must have been quick before it gets finer: else it would go to and fro. */
const patience = 12;
/** Milliseconds without change after which the picture is drawn once at its finest. */
const restAfter = 160;

/** Chooses how sharp pictures are: coarser while they come too slowly, at their finest when nothing moves. */
export class Quality {
  /** Drawn pictures a second, while they follow each other. */
  rate = 0;
  private level = 2;
  private fine = false;
  private last = 0;
  private quickOnes = 0;
  private readonly gaps: number[] = [];

  constructor(private readonly screen: () => number) {}

  get ratio(): number {
    const own = this.screen();
    return this.fine ? Math.max(levels[0], own) : levels[this.level] * Math.min(own, 1.5);
  }

  /** A picture is about to be drawn because something changed. */
  moved(now: number): void {
    const gap = now - this.last;
    this.last = now;
    this.fine = false;
    if (gap > 250) return;
    this.gaps.push(gap);
    if (this.gaps.length < window) return;
    const mean = this.gaps.reduce((sum, each) => sum + each, 0) / window;
    this.gaps.length = 0;
    this.rate = 1000 / mean;
    this.quickOnes = mean < quick ? this.quickOnes + 1 : 0;
    if (mean > slow && this.level < levels.length - 1) {
      ++this.level;
    } else if (this.quickOnes >= patience && this.level > 2) {
      --this.level;
      this.quickOnes = 0;
    }
  }

  /** Nothing changed; true if a finer picture is due now. */
  rests(now: number): boolean {
    if (this.fine || now - this.last < restAfter) return false;
    this.fine = true;
    return true;
  }
}
