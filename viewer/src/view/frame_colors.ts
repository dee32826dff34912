// SPDX-License-Identifier: Apache-2.0
// Colours of frames on a cut that depend on how they lie in it.

import { ramp_color, type Color, type Theme } from "../math/color_maps.ts";
import { axes_of, tangents_of, tilt_deg, turn_deg, type Quaternion, type Vector } from "../math/frame.ts";

// Tilts are drawn up to this many degrees: half of what is possible, since larger ones are rare.
export const kTiltScale = 30;

export function frame_color(frame: Quaternion, by: "tilt" | "turn", normal: Vector, theme: Theme): Color {
  const axes = axes_of(frame);
  if (by === "tilt") return ramp_color("tilt", theme, tilt_deg(axes, normal) / kTiltScale);
  return ramp_color("turn", theme, turn_deg(axes, normal, tangents_of(normal)[0]) / 90);
}
