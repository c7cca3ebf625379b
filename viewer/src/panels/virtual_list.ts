import { scrollToRow, visibleRows } from '../virtual';
import { make, onceAFrame } from './dom';

/** A long list of lines of the same height: only those that are seen are on the page. */
export class VirtualList {
  readonly element: HTMLElement;
  private readonly inner = make('div');
  private count = 0;

  /** `row` makes the element of a line; it is asked anew whenever the list scrolls or is refreshed. */
  constructor(
    attributes: Record<string, string>, private readonly rowHeight: number, private readonly row: (index: number) => HTMLElement
  ) {
    this.element = make('div', { tabindex: '0', ...attributes }, this.inner);
    const soon = onceAFrame(() => this.refresh());
    this.element.addEventListener('scroll', soon);
    new ResizeObserver(soon).observe(this.element);
  }

  setCount(count: number): void {
    this.count = count;
    this.refresh();
  }

  refresh(): void {
    const { scrollTop, clientHeight } = this.element;
    const seen = visibleRows(scrollTop, clientHeight, this.rowHeight, this.count);
    this.inner.style.height = `${seen.height}px`;
    const rows: HTMLElement[] = [];
    for (let i = seen.first; i < seen.after; ++i) {
      const element = this.row(i);
      element.style.transform = `translateY(${seen.top + (i - seen.first) * this.rowHeight}px)`;
      rows.push(element);
    }
    this.inner.replaceChildren(...rows);
  }

  /** Scrolls so that a line is seen, if it is not. */
  reveal(index: number): void {
    const { scrollTop, clientHeight } = this.element;
    const to = scrollToRow(index, scrollTop, clientHeight, this.rowHeight, this.count);
    // What is scrolled to must be there before the browser lets one scroll.
    this.refresh();
    if (to !== scrollTop) this.element.scrollTop = to;
    this.refresh();
  }
}
