// SPDX-License-Identifier: Apache-2.0
// Lists of items by the bin that they lie in, one after the other in one array.

/** Items of a list that lie in each of so many bins. */
export class Bins {
  private readonly begin: Uint32Array;
  readonly items: Uint32Array;

  /** `each` calls back with the bins of all items; it is called twice. */
  constructor(count: number, each: (add: (bin: number, item: number) => void) => void) {
    this.begin = new Uint32Array(count + 1);
    each((bin) => ++this.begin[bin + 1]);
    for (let k = 0; k < count; ++k) this.begin[k + 1] += this.begin[k];
    this.items = new Uint32Array(this.begin[count]);
    const next = this.begin.slice();
    each((bin, item) => (this.items[next[bin]++] = item));
  }

  first(bin: number): number {
    return this.begin[bin];
  }

  last(bin: number): number {
    return this.begin[bin + 1];
  }
}
