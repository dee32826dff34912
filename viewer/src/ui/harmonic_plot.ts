// SPDX-License-Identifier: Apache-2.0
// The function on the sphere that stands for a frame, as a surface whose distance from the middle is its size; drawn on a flat canvas.

import { css_color, parse_color, type Color, type Theme } from "../math/color_maps.ts";
import { dot, type Vector } from "../math/frame.ts";
import { value_at, type Degree } from "../math/harmonics.ts";
import { kViewColors } from "../view/view_colors.ts";

const kAround = 76;
const kDown = 38;

export class HarmonicPlot {
  private readonly points: Vector[] = [];
  private readonly signs: number[] = [];

  constructor(degree: Degree, coefficients: number[]) {
    const values: number[] = [];
    const directions: Vector[] = [];
    for (let i = 0; i <= kDown; ++i) {
      for (let j = 0; j < kAround; ++j) {
        const polar = (Math.PI * i) / kDown;
        const around = (2 * Math.PI * j) / kAround;
        const direction: Vector = [Math.sin(polar) * Math.cos(around), Math.sin(polar) * Math.sin(around), Math.cos(polar)];
        directions.push(direction);
        values.push(value_at(degree, coefficients, direction));
      }
    }
    const largest = Math.max(...values.map(Math.abs), 1e-12);
    values.forEach((value, k) => {
      this.points.push(directions[k].map((part) => (part * Math.abs(value)) / largest) as Vector);
      this.signs.push(value);
    });
  }

  /** Seen as the camera sees: its unit right and up directions, and the one towards it. */
  draw(canvas: HTMLCanvasElement, right: Vector, up: Vector, toward: Vector, theme: Theme): void {
    const ratio = Math.min(2, devicePixelRatio || 1);
    const size = canvas.clientWidth || 132;
    canvas.width = canvas.height = Math.round(size * ratio);
    const context = canvas.getContext("2d");
    if (!context) return;
    const middle = canvas.width / 2;
    const reach = middle * 0.94;
    const flat = this.points.map((point): Vector => [middle + reach * dot(point, right), middle - reach * dot(point, up), dot(point, toward)]);
    const quads: { corners: number[]; depth: number }[] = [];
    for (let i = 0; i < kDown; ++i) {
      for (let j = 0; j < kAround; ++j) {
        const next = (j + 1) % kAround;
        const corners = [i * kAround + j, i * kAround + next, (i + 1) * kAround + next, (i + 1) * kAround + j];
        quads.push({ corners, depth: corners.reduce((sum, corner) => sum + flat[corner][2], 0) });
      }
    }
    quads.sort((a, b) => a.depth - b.depth);
    const positive = parse_color(kViewColors[theme].positive);
    const negative = parse_color(kViewColors[theme].negative);
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.lineWidth = 0.6 * ratio;
    for (const { corners } of quads) {
      const color = corners.reduce((sum, corner) => sum + this.signs[corner], 0) >= 0 ? positive : negative;
      const style = css_color(lit(color, this.brightness(corners, right, up, toward)));
      context.fillStyle = context.strokeStyle = style;
      context.beginPath();
      corners.forEach((corner, k) => (k === 0 ? context.moveTo(flat[corner][0], flat[corner][1]) : context.lineTo(flat[corner][0], flat[corner][1])));
      context.closePath();
      context.fill();
      context.stroke(); // closes the hairlines between quads
    }
  }

  private brightness(corners: number[], right: Vector, up: Vector, toward: Vector): number {
    const [a, b, c, d] = corners.map((corner) => this.points[corner]);
    const e = [0, 1, 2].map((k) => c[k] - a[k]);
    const f = [0, 1, 2].map((k) => d[k] - b[k]);
    const normal: Vector = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
    const length = Math.hypot(...normal) || 1;
    const light = [0, 1, 2].map((k) => (0.75 * toward[k] + 0.5 * up[k] - 0.35 * right[k]) / 0.967) as Vector;
    return 0.62 + 0.42 * (Math.abs(dot(normal, light)) / length);
  }
}

const lit = (color: Color, brightness: number): Color => color.map((channel) => Math.min(1, channel * brightness)) as Color;
