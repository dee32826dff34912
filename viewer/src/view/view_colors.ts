// SPDX-License-Identifier: Apache-2.0
// Colours of what is drawn in 3D, for the light and the dark page. Singular lines: blue and gold differ for every kind of colour vision,
// red is kept for what hexahedral meshes cannot have, and each kind has a pattern of its own besides. Balls whose verdict is undecided
// are as violet as in pictures.

import { Color, Vector3 } from "three";

import { parse_color, type Theme } from "../math/color_maps.ts";

export interface ViewColors {
  background: string;
  part: string;
  cut: string;
  cell_line: string;
  nothing: string;
  crease: string;
  glyph: string;
  streamline: string;
  positive: string;
  negative: string;
  half: string;
  warn: string;
  node: string;
  undecided: string;
  picked: string;
}

export const kViewColors: Record<Theme, ViewColors> = {
  light: {
    background: "#f7f8fa",
    part: "#8fa3b8",
    cut: "#e6eaef",
    cell_line: "#5d6b7b",
    nothing: "#c9cdd3",
    crease: "#3d4856",
    glyph: "#2d3b4d",
    streamline: "#00796b",
    positive: "#1667c4",
    negative: "#d98f00",
    half: "#8a4fb5",
    warn: "#c8102e",
    node: "#1d2530",
    undecided: "#7a4fd0",
    picked: "#d6006c",
  },
  dark: {
    background: "#14171c",
    part: "#7d93ab",
    cut: "#2a3038",
    cell_line: "#9fb0c3",
    nothing: "#3a3f47",
    crease: "#b6c2d0",
    glyph: "#d5dde7",
    streamline: "#4fd0bd",
    positive: "#58a6ff",
    negative: "#f0b429",
    half: "#c297ee",
    warn: "#ff5468",
    node: "#f2f5f9",
    undecided: "#b79cff",
    picked: "#ff5fae",
  },
};

/** An sRGB colour for the shaders of this page. */
export const shader_color = (hex: string): Vector3 => new Vector3(...parse_color(hex));
/** A colour for materials of three.js, which convert it. */
export const scene_color = (hex: string): Color => new Color(hex);
