// SPDX-License-Identifier: Apache-2.0
// Small symmetric matrices: unpacking the upper triangle that scenes carry, eigenvalues, and the value of a quadratic form.

/** Full rows of the matrix whose upper triangle is given row by row. */
export function unpacked(upper: ArrayLike<number>, size: number): number[][] {
  const matrix = Array.from({ length: size }, () => new Array<number>(size).fill(0));
  let next = 0;
  for (let row = 0; row < size; ++row) {
    for (let column = row; column < size; ++column) {
      matrix[row][column] = matrix[column][row] = upper[next++];
    }
  }
  return matrix;
}

/** Eigenvalues in ascending order, by cyclic Jacobi rotations. */
export function eigenvalues(symmetric: number[][]): number[] {
  const a = symmetric.map((row) => row.slice());
  const size = a.length;
  const scale = Math.sqrt(a.flat().reduce((sum, value) => sum + value * value, 0)) || 1;
  // Jacobi converges quadratically: matrices of nine rows are diagonal to rounding after six or seven sweeps.
  for (let sweep = 0; sweep < 30; ++sweep) {
    let off_diagonal = 0;
    for (let p = 0; p < size; ++p) for (let q = p + 1; q < size; ++q) off_diagonal = Math.max(off_diagonal, Math.abs(a[p][q]));
    if (off_diagonal < 1e-15 * scale) break;
    for (let p = 0; p < size; ++p) for (let q = p + 1; q < size; ++q) rotate_away(a, p, q);
  }
  return a.map((row, k) => row[k]).sort((x, y) => x - y);
}

/** Turns the plane of rows p and q so that entry (p, q) becomes zero. */
function rotate_away(a: number[][], p: number, q: number): void {
  if (a[p][q] === 0) return;
  const theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const tangent = (theta >= 0 ? 1 : -1) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
  const cosine = 1 / Math.sqrt(tangent * tangent + 1);
  const sine = tangent * cosine;
  for (let k = 0; k < a.length; ++k) {
    const kp = a[k][p];
    const kq = a[k][q];
    a[k][p] = cosine * kp - sine * kq;
    a[k][q] = sine * kp + cosine * kq;
  }
  for (let k = 0; k < a.length; ++k) {
    const pk = a[p][k];
    const qk = a[q][k];
    a[p][k] = cosine * pk - sine * qk;
    a[q][k] = sine * pk + cosine * qk;
  }
}

/** h'Ah - 2 b'h + c. */
export function form_value(matrix: number[][], linear: ArrayLike<number>, constant: number, h: number[]): number {
  let value = constant;
  for (let row = 0; row < h.length; ++row) {
    value -= 2 * linear[row] * h[row];
    for (let column = 0; column < h.length; ++column) value += h[row] * matrix[row][column] * h[column];
  }
  return value;
}
