// SPDX-License-Identifier: Apache-2.0
// Points with directions in a plane, to find whether another that runs the same way has room.

// Cosine of the angle within which two curves run along the same axis.
const kSameWay = Math.SQRT1_2;

/** The points in each square of the spacing, as linked lists. */
export class SpacedPoints {
  private readonly heads: Int32Array;
  private readonly used: number[] = [];
  private next = new Int32Array(256);
  private values = new Float64Array(4 * 256);
  private count = 0;

  constructor(private readonly low: readonly number[], private readonly spacing: number, private readonly columns: number, private readonly rows: number) {
    this.heads = new Int32Array(columns * rows).fill(-1);
  }

  private square_of(place: number, side: number, most: number): number {
    return Math.min(most - 1, Math.max(0, Math.floor((place - this.low[side]) / this.spacing)));
  }

  add(u: number, v: number, du: number, dv: number): void {
    if (this.count === this.next.length) {
      const [next, values] = [new Int32Array(2 * this.count), new Float64Array(8 * this.count)];
      next.set(this.next);
      values.set(this.values);
      [this.next, this.values] = [next, values];
    }
    const square = this.square_of(v, 1, this.rows) * this.columns + this.square_of(u, 0, this.columns);
    if (this.heads[square] < 0) this.used.push(square);
    this.next[this.count] = this.heads[square];
    this.heads[square] = this.count;
    this.values[4 * this.count] = u;
    this.values[4 * this.count + 1] = v;
    this.values[4 * this.count + 2] = du;
    this.values[4 * this.count + 3] = dv;
    ++this.count;
  }

  clear(): void {
    for (const square of this.used) this.heads[square] = -1;
    this.used.length = this.count = 0;
  }

  /** Whether no point along the same axis is nearer than `distance`, at most the spacing. */
  has_room(u: number, v: number, du: number, dv: number, distance: number): boolean {
    const { values } = this;
    const [left, right] = [this.square_of(u - distance, 0, this.columns), this.square_of(u + distance, 0, this.columns)];
    const last = this.square_of(v + distance, 1, this.rows);
    for (let row = this.square_of(v - distance, 1, this.rows); row <= last; ++row) {
      for (let column = left; column <= right; ++column) {
        for (let k = this.heads[row * this.columns + column]; k >= 0; k = this.next[k]) {
          const [off_u, off_v] = [values[4 * k] - u, values[4 * k + 1] - v];
          if (off_u * off_u + off_v * off_v < distance * distance && Math.abs(values[4 * k + 2] * du + values[4 * k + 3] * dv) > kSameWay) return false;
        }
      }
    }
    return true;
  }
}
