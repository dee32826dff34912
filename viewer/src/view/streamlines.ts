// SPDX-License-Identifier: Apache-2.0
// Streamlines, each in the colour of the axis that it follows: those from seeds on the first cut, or on the surface.

import { GreaterDepth, Group, Plane } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";

import type { Theme } from "../math/color_maps.ts";
import type { Vector } from "../math/frame.ts";
import type { Scene } from "../scene/scene.ts";
import type { StreamSet } from "../settings.ts";
import { coloured_segments, line_material } from "./thin_lines.ts";
import { axis_colors, scene_color } from "./view_colors.ts";

const kHiddenOpacity = 0.3;
// Lines within this share of the part's size beyond the cut are shown.
const kSlack = 0.02;
const kSets: StreamSet[] = ["cut", "surface"];

export class StreamlineView {
  readonly group = new Group();
  /** As they are, and faintly where something is before them: lines along a cut run in and out of its face. */
  private readonly lines: LineSegments2[];
  private readonly kept = new Plane();
  private readonly slack: number;
  private drawn = "";

  constructor(private readonly scene: Scene) {
    this.lines = [1, kHiddenOpacity].map((opacity) => {
      const material = line_material(2.2, opacity);
      material.vertexColors = true;
      if (opacity < 1) material.depthFunc = GreaterDepth;
      const lines = new LineSegments2(undefined, material);
      lines.renderOrder = opacity < 1 ? 9 : 4;
      lines.frustumCulled = false;
      return lines;
    });
    this.group.add(...this.lines);
    this.slack = kSlack * Math.hypot(...scene.high.map((value, k) => value - scene.low[k]));
  }

  show(visible: boolean, set: StreamSet, theme: Theme): void {
    this.group.visible = visible && this.scene.streamline_starts.length > 1;
    const key = `${set} ${theme}`;
    if (!this.group.visible || key === this.drawn) return;
    this.drawn = key;
    const colors = axis_colors(theme).map((color) => scene_color(color).toArray() as Vector);
    const { streamline_axis, streamline_set } = this.scene;
    const chosen = kSets.indexOf(set);
    this.lines[0].geometry.dispose();
    const geometry = coloured_segments(this.scene.streamline_points, this.scene.streamline_starts, (line) =>
      ((streamline_set[line] ?? 0) === chosen ? colors[streamline_axis[line] ?? 0] : null));
    for (const lines of this.lines) lines.geometry = geometry;
  }

  /** Takes away what lies beyond the cut, but for what runs along it. */
  cut(normal: Vector, offset: number, clip: boolean): void {
    this.kept.normal.set(-normal[0], -normal[1], -normal[2]);
    this.kept.constant = offset + this.slack;
    for (const { material } of this.lines) material.clippingPlanes = clip ? [this.kept] : null;
  }
}
