// SPDX-License-Identifier: Apache-2.0
// What a link restores: the view and what is shown in it, as the part of the address behind #. It works for files on disk as well.

import { kMaps } from "./math/color_maps.ts";
import type { Vector } from "./math/frame.ts";
import { kHexColors } from "./scene/hexahedra.ts";
import type { Part, Settings } from "./settings.ts";

export interface Camera {
  position: Vector;
  target: Vector;
}

// Places in a link have this many significant digits: less than a pixel of difference.
const kDigits = 6;
const kLayers = ["part", "creases", "arcs", "nodes", "streamlines", "glyphs", "cells", "hexahedra", "mesh_lines"] as const;

export function link_of(settings: Settings, camera: Camera): string {
  const { cut, glyph } = settings;
  const numbers = (values: number[]): string => values.map((value) => Number(value.toPrecision(kDigits))).join();
  const parts: Record<string, string> = {
    camera: numbers([...camera.position, ...camera.target]),
    up: settings.up,
    field: settings.field,
    map: settings.map,
    opacity: numbers([settings.opacity]),
    cut: [cut.axis, numbers([cut.position]), ...[cut.on, cut.flip, cut.clip].map(Number), ...(cut.axis === "view" ? [numbers(cut.normal)] : [])].join(),
    frames: [glyph.shape, glyph.color, glyph.density].join(),
    show: kLayers.filter((layer) => settings.layers[layer]).join(),
    streams: settings.streams,
    ...(settings.hex_color === "shape" ? {} : { hexahedra: settings.hex_color }),
    ...(settings.below < 1 ? { below: numbers([settings.below]) } : {}),
  };
  return `#${Object.entries(parts).map(([name, value]) => `${name}=${value}`).join("&")}`;
}

/** What the part of an address behind # asks for; whatever it says that is unknown is left out. */
export function link_from(hash: string): { settings: Part; camera: Camera | null } {
  const given = new URLSearchParams(hash.replace(/^#/, ""));
  const settings: Part = {};
  const one_of = <T extends string>(name: string, allowed: readonly T[]): T | undefined => allowed.find((value) => value === given.get(name));
  settings.up = one_of("up", ["x", "y", "z"]);
  settings.field = one_of("field", ["main", "grid"]);
  settings.map = one_of("map", kMaps);
  settings.hex_color = one_of("hexahedra", kHexColors);
  settings.streams = one_of("streams", ["cut", "surface"]);
  const [opacity] = numbers_in(given.get("opacity"), 1);
  if (opacity !== undefined && opacity >= 0 && opacity <= 1) settings.opacity = opacity;
  const [below] = numbers_in(given.get("below"), 1);
  if (below !== undefined && below >= 0 && below <= 1) settings.below = below;
  const [axis, position, ...flags] = (given.get("cut") ?? "").split(",");
  if (["x", "y", "z", "view"].includes(axis) && Number(position) >= 0 && Number(position) <= 1) {
    const [on, flip, clip] = flags.map((flag) => flag === "1");
    settings.cut = { axis: axis as "x", position: Number(position), on, flip, clip };
    const normal = numbers_in(flags.slice(3).join(), 3);
    if (axis === "view" && normal.length === 3) settings.cut.normal = normal as Vector;
  }
  const [shape, color, density] = (given.get("frames") ?? "").split(",");
  if (["curve", "cross", "cube"].includes(shape) && ["axes", "tilt", "turn"].includes(color)) {
    settings.glyph = { shape: shape as "cross", color: color as "axes", density: Math.max(-2, Math.min(2, Math.round(Number(density) || 0))) };
  }
  if (given.has("show")) {
    const shown = given.get("show")!.split(",");
    settings.layers = Object.fromEntries(kLayers.map((layer) => [layer, shown.includes(layer)]));
  }
  for (const name of Object.keys(settings) as (keyof Part)[]) if (settings[name] === undefined) delete settings[name];
  const place = numbers_in(given.get("camera"), 6);
  return { settings, camera: place.length === 6 ? { position: place.slice(0, 3) as Vector, target: place.slice(3) as Vector } : null };
}

/** So many numbers, or none. */
function numbers_in(text: string | null, count: number): number[] {
  const values = (text ?? "").split(",").map((part) => (part.trim() === "" ? NaN : Number(part)));
  return values.length === count && values.every(Number.isFinite) ? values : [];
}
