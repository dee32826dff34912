// SPDX-License-Identifier: Apache-2.0
// Colour maps as tables of 256 sRGB colours.
//
// Quantities where zero is good run from a colour near the background to one far from it, in both themes, with a lightness that only
// rises or only falls: what needs attention stands out, and it does without hue, for any kind of colour vision and in grey.

export type Theme = "light" | "dark";
export type Color = [number, number, number];
export const kMaps = ["none", "alignment", "energy", "class", "region"] as const;
export type MapName = (typeof kMaps)[number];
export type RampName = "alignment" | "energy" | "tilt" | "turn" | "shape";

// Anchors at equal distances in value, chosen for steps of equal size in CIELAB lightness. `tilt` colours glyphs, which must be seen at
// zero too; `turn` is cyclic; of a `shape` zero is red, one is good and near the background.
const kRamps: Record<Theme, Record<RampName, string[]>> = {
  light: {
    alignment: ["#f1efe6", "#f8dcae", "#fbbd7f", "#f79a60", "#e9704f", "#cd4a55", "#a2315f", "#742062", "#481457", "#200b3c"],
    energy: ["#eef3f0", "#cfe6dc", "#a5d6c9", "#76c1ba", "#4fa8ae", "#398ca1", "#306f93", "#305283", "#313666", "#221c3d"],
    tilt: ["#7d8b9b", "#97877f", "#b28066", "#c6704c", "#cd573a", "#c43c40", "#a92655", "#831863", "#560f5e"],
    turn: ["#3f5fb5", "#6d8fc4", "#a9b7c6", "#cfa98f", "#c97a52", "#a9473f", "#823a5e", "#5c4590", "#3f5fb5"],
    shape: ["#7a0a2a", "#c02a32", "#ea6b3e", "#f9b55f", "#f1e3a4", "#d9e6ee"],
  },
  dark: {
    alignment: ["#2b2f36", "#45305a", "#64317c", "#89367f", "#ae4078", "#d2516c", "#ec6f61", "#f89868", "#fdc687", "#fcf3c0"],
    energy: ["#2b2f36", "#333a56", "#3a4b7c", "#3b6294", "#397a9e", "#3b93a7", "#47acac", "#68c5b0", "#a2dcc2", "#e2f6e6"],
    tilt: ["#7f8d9d", "#9d9690", "#bd9c7c", "#d8a168", "#eea65a", "#fbb36a", "#ffc58b", "#ffd9b3", "#fff0de"],
    turn: ["#5f83e0", "#8fb0e8", "#c4cfd8", "#e6c2a6", "#e5925f", "#cd5f53", "#a5567e", "#7f65bb", "#5f83e0"],
    shape: ["#ff5a5f", "#ea7044", "#c27c3c", "#8f7b50", "#627077", "#465d78"],
  },
};

/** A class of boundary cells: what the surface in them asks of a frame. */
export interface CellClass {
  name: string;
  meaning: string;
  color: Record<Theme, string>;
}

export const kClasses: CellClass[] = [
  { name: "inside", meaning: "no surface", color: { light: "#dfe3e8", dark: "#343a43" } },
  { name: "plane", meaning: "one axis along the normal", color: { light: "#b9c7d6", dark: "#4d6179" } },
  { name: "axis", meaning: "one axis, by compromise", color: { light: "#1f9a8a", dark: "#35c2ad" } },
  { name: "frame", meaning: "all three axes", color: { light: "#2a6fb8", dark: "#6aaef5" } },
  { name: "free", meaning: "any frame", color: { light: "#e3b43c", dark: "#f2cf63" } },
  { name: "conflicted", meaning: "no frame fits", color: { light: "#b3202c", dark: "#ff6b6b" } },
];

// Of neighbouring lightness, so that none looks like a fault; they repeat where there are more regions.
const kRegionColors = ["#8fb3d9", "#e3c07a", "#9ccf9a", "#d9a0bf", "#b7b0e0", "#8fd0cb", "#e2a98a", "#c4c98a"];

export const region_color = (region: number): string => kRegionColors[region % kRegionColors.length];

// Faces next to each other mostly have numbers next to each other: their hues are a golden section of a circle without magenta apart, which
// is the colour of what is picked, and their lightness differs.
const kGoldenSection = 0.618034;
const kFaceHues = 290;
const kFaceLightness = [0.72, 0.6, 0.5];

/** The colour of a face by its place among the faces. */
export function face_color(face: number): Color {
  const hue = kFaceHues * ((0.7 + kGoldenSection * face) % 1);
  const lightness = kFaceLightness[face % kFaceLightness.length];
  const chroma = 0.6 * (1 - Math.abs(2 * lightness - 1));
  const channel = (shift: number): number => lightness + chroma * (Math.min(1, Math.max(0, Math.abs((((hue / 60 + shift) % 6) + 6) % 6 - 3) - 1)) - 0.5);
  return [channel(0), channel(4), channel(2)];
}

export function parse_color(hex: string): Color {
  const value = parseInt(hex.slice(1), 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}

export function css_color([red, green, blue]: Color): string {
  return `rgb(${Math.round(red * 255)} ${Math.round(green * 255)} ${Math.round(blue * 255)})`;
}

/** The colour of a ramp at 0 ... 1. */
export function ramp_color(ramp: RampName, theme: Theme, value: number): Color {
  const anchors = kRamps[theme][ramp];
  const place = Math.min(1, Math.max(0, value)) * (anchors.length - 1);
  const low = Math.min(anchors.length - 2, Math.floor(place));
  const first = parse_color(anchors[low]);
  const second = parse_color(anchors[low + 1]);
  return first.map((channel, k) => channel + (place - low) * (second[k] - channel)) as Color;
}

/** 256 RGBA texels: of a ramp, or for "class" the class's colour at texel number `class`. */
export function palette_of(map: MapName, theme: Theme): Uint8Array<ArrayBuffer> {
  const texels = new Uint8Array(256 * 4);
  for (let k = 0; k < 256; ++k) {
    const color =
      map === "class" ? parse_color(kClasses[Math.min(k, kClasses.length - 1)].color[theme])
      : map === "region" ? parse_color(region_color(k))
      : map === "none" ? ([1, 1, 1] as Color)
      : ramp_color(map, theme, k / 255);
    texels.set([...color.map((channel) => Math.round(channel * 255)), 255], 4 * k);
  }
  return texels;
}

/** CSS gradient of a ramp, for legends. */
export function css_gradient(ramp: RampName, theme: Theme): string {
  return `linear-gradient(to right, ${kRamps[theme][ramp].join(", ")})`;
}
