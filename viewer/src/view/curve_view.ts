// SPDX-License-Identifier: Apache-2.0
// Frames on the cut as evenly spaced curves along their axes. While the cut or the camera moves and curves take long, the last ones go
// along, faintly, until it rests.

import { Vector3 } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";

import type { Color, Theme } from "../math/color_maps.ts";
import type { Vector } from "../math/frame.ts";
import { cut_curves, type CutCurves } from "../scene/cut_curves.ts";
import { element_quaternion, type Scene } from "../scene/scene.ts";
import type { GlyphColor } from "../settings.ts";
import type { Cut } from "./cut.ts";
import { frame_color } from "./frame_colors.ts";
import { line_material } from "./thin_lines.ts";
import { axis_colors, scene_color } from "./view_colors.ts";

const kWidth = 2.2;
const kFaint = 0.25;
// Curves that take at most so many milliseconds are drawn while the cut moves; others once nothing has moved for a while.
const kQuick = 30;
export const kRest = 150;
// Points that lie this near to the straight line between others are left out, as a share of the distance between curves.
const kStraight = 0.01;

export interface CurveChoice {
  normal: Vector;
  offset: number;
  /** Between curves, in model units. */
  spacing: number;
  color: GlyphColor;
  theme: Theme;
}

export class CurveView {
  readonly lines = new LineSegments2(new LineSegmentsGeometry(), line_material(kWidth, 1));
  private drawn: CurveChoice | null = null;
  private drawn_key = "";
  private asked_key = "";
  private asked_at = -Infinity;
  private took = 0;

  constructor(private readonly scene: Scene, private readonly cut: Cut) {
    this.lines.material.vertexColors = true;
    this.lines.material.transparent = true;
    this.lines.renderOrder = 3;
    this.lines.frustumCulled = false;
  }

  /** Draws what is chosen, at once or, if that takes long and is not in a hurry, once it is asked for again at rest; whether it is drawn. */
  update(visible: boolean, choice: CurveChoice, hurry: boolean): boolean {
    this.lines.visible = visible;
    if (!visible) return true;
    const key = JSON.stringify(choice);
    if (key !== this.drawn_key) {
      const now = performance.now();
      const moving = now - this.asked_at < kRest;
      if (key !== this.asked_key) this.asked_at = now;
      this.asked_key = key;
      if (moving && !hurry && this.took > kQuick && this.drawn) {
        this.carry_along(this.drawn, choice);
        return false;
      }
      this.draw(choice);
      this.drawn_key = key;
      this.took = performance.now() - now;
    }
    this.lines.visible = this.lines.geometry.instanceCount > 0;
    this.lines.material.opacity = 1;
    this.lines.position.set(0, 0, 0);
    return true;
  }

  /** Leaves curves of a parallel plane where they are in it, and hides others. */
  private carry_along(drawn: CurveChoice, choice: CurveChoice): void {
    const parallel = drawn.normal.every((value, k) => value === choice.normal[k]);
    this.lines.visible = parallel && this.lines.geometry.instanceCount > 0;
    this.lines.material.opacity = drawn.offset === choice.offset ? 1 : kFaint;
    this.lines.position.copy(new Vector3(...choice.normal).multiplyScalar(choice.offset - drawn.offset));
  }

  private draw(choice: CurveChoice): void {
    const { pieces, map } = this.cut;
    const curves = cut_curves(pieces, this.cut.named.names, map, choice.normal, (piece) => element_quaternion(this.scene, pieces.element[piece]), choice.spacing);
    const { keys, colors } = this.colored(curves, choice);
    const positions: number[] = [];
    const tints: number[] = [];
    for (let curve = 0; curve + 1 < curves.starts.length; ++curve) {
      const end = curves.starts[curve + 1];
      for (let from = curves.starts[curve]; from + 1 < end;) {
        let to = from + 1;
        while (to + 1 < end && keys[to] === keys[from] && is_straight(curves.points, from, to + 1, kStraight * choice.spacing)) ++to;
        for (const point of [from, to]) {
          positions.push(...map.point_at(curves.points[2 * point], curves.points[2 * point + 1]));
          tints.push(...colors(keys[from]));
        }
        from = to;
      }
    }
    this.lines.geometry.dispose();
    this.lines.geometry = new LineSegmentsGeometry();
    if (positions.length > 0) this.lines.geometry.setPositions(positions).setColors(tints);
    else this.lines.geometry.instanceCount = 0;
    this.drawn = choice;
  }

  /** Of each segment a number of its colour, and the colour of each number. */
  private colored({ pieces, axes }: CutCurves, { color, theme, normal }: CurveChoice): { keys: ArrayLike<number>; colors: (key: number) => Color } {
    if (color === "axes") {
      const { names } = this.cut.named;
      const tints = axis_colors(theme).map((tint) => scene_color(tint).toArray() as Color);
      return { keys: axes.map((axis, k) => names[pieces[k]][axis]), colors: (name) => tints[name] };
    }
    const { element } = this.cut.pieces;
    return { keys: pieces, colors: (piece) => linear(frame_color(element_quaternion(this.scene, element[piece]), color, normal, theme)) };
  }
}

/** As materials of three.js expect vertex colours. */
const linear = (color: Color): Color => scene_color("#000").setRGB(...color, "srgb").toArray() as Color;

function is_straight(points: Float32Array, from: number, to: number, tolerance: number): boolean {
  const [u, v] = [points[2 * from], points[2 * from + 1]];
  const [along_u, along_v] = [points[2 * to] - u, points[2 * to + 1] - v];
  const most = tolerance * Math.hypot(along_u, along_v);
  for (let k = from + 1; k < to; ++k) if (Math.abs((points[2 * k] - u) * along_v - (points[2 * k + 1] - v) * along_u) > most) return false;
  return true;
}
