// SPDX-License-Identifier: Apache-2.0
// Colours of what is drawn in 3D, for the light and the dark page. Singular lines: blue and orange differ for every kind of colour
// vision, crimson is kept for what hexahedral meshes cannot have, and each kind has a pattern of its own besides. Balls whose verdict is undecided
// are as violet as in pictures. Edges of hexahedra are dark on light faces and light on dark ones, in both themes.

import { Color, Vector3 } from "three";

import { parse_color, type Theme } from "../math/color_maps.ts";

export interface ViewColors {
  background: string;
  part: string;
  cut: string;
  cell_line: string;
  nothing: string;
  crease: string;
  seam: string;
  positive: string;
  negative: string;
  half: string;
  warn: string;
  node: string;
  undecided: string;
  turn: string;
  picked: string;
  inverted: string;
}

export const kViewColors: Record<Theme, ViewColors> = {
  light: {
    background: "#f7f8fa",
    part: "#8fa3b8",
    cut: "#e6eaef",
    cell_line: "#5d6b7b",
    nothing: "#c9cdd3",
    crease: "#3d4856",
    seam: "#5b6675",
    positive: "#1272c4",
    negative: "#f09a1a",
    half: "#12916f",
    warn: "#d3125f",
    node: "#1d2530",
    undecided: "#8b5cc7",
    turn: "#ffd23e",
    picked: "#d6006c",
    inverted: "#d916d3",
  },
  dark: {
    background: "#14171c",
    part: "#7d93ab",
    cut: "#2a3038",
    cell_line: "#9fb0c3",
    nothing: "#3a3f47",
    crease: "#b6c2d0",
    seam: "#a9b6c6",
    positive: "#58a6ff",
    negative: "#f0b429",
    half: "#3cc79f",
    warn: "#ff4d8d",
    node: "#f2f5f9",
    undecided: "#b79cff",
    turn: "#ffd23e",
    picked: "#ff5fae",
    inverted: "#f04bff",
  },
};

// Of axes named x, y and z: those of pictures, lighter on the dark page.
const kAxisColors: Record<Theme, [string, string, string]> = { light: ["#c8423b", "#5f9e3a", "#3d3a9e"], dark: ["#e8746c", "#86c45c", "#918ef0"] };

export const axis_colors = (theme: Theme): [string, string, string] => kAxisColors[theme];

/** An sRGB colour for the shaders of this page. */
export const shader_color = (hex: string): Vector3 => new Vector3(...parse_color(hex));
/** A colour for materials of three.js, which convert it. */
export const scene_color = (hex: string): Color => new Color(hex);

/** Of hexahedra: on light faces, and on dark ones. */
export const kHexEdges = { dark: "#1a222b", light: "#eef3f8" };
