// SPDX-License-Identifier: Apache-2.0
// Streamlines, each in the colour of the axis that it follows: those from seeds on the first cut, or on the surface.

import { Plane } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";

import type { Theme } from "../math/color_maps.ts";
import type { Vector } from "../math/frame.ts";
import type { Scene } from "../scene/scene.ts";
import type { StreamSet } from "../settings.ts";
import { coloured_segments, line_material } from "./thin_lines.ts";
import { axis_colors, scene_color } from "./view_colors.ts";

const kSets: StreamSet[] = ["cut", "surface"];

export class StreamlineView {
  readonly lines: LineSegments2;
  private readonly kept = new Plane();
  private drawn = "";

  constructor(private readonly scene: Scene) {
    const material = line_material(2, 1);
    material.vertexColors = true;
    this.lines = new LineSegments2(undefined, material);
    this.lines.renderOrder = 4;
    this.lines.frustumCulled = false;
  }

  show(visible: boolean, set: StreamSet, theme: Theme): void {
    this.lines.visible = visible && this.scene.streamline_starts.length > 1;
    const key = `${set} ${theme}`;
    if (!this.lines.visible || key === this.drawn) return;
    this.drawn = key;
    const colors = axis_colors(theme).map((color) => scene_color(color).toArray() as Vector);
    const { streamline_axis, streamline_set } = this.scene;
    const chosen = kSets.indexOf(set);
    this.lines.geometry.dispose();
    this.lines.geometry = coloured_segments(this.scene.streamline_points, this.scene.streamline_starts, (line) =>
      ((streamline_set[line] ?? 0) === chosen ? colors[streamline_axis[line] ?? 0] : null));
  }

  /** Takes away what lies beyond the cut. */
  cut(normal: Vector, offset: number, clip: boolean): void {
    this.kept.normal.set(-normal[0], -normal[1], -normal[2]);
    this.kept.constant = offset;
    this.lines.material.clippingPlanes = clip ? [this.kept] : null;
  }
}
