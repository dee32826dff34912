// SPDX-License-Identifier: Apache-2.0
// What the user has chosen to see: one record, changed in one place, of which the 3D view and the controls are told.

import type { MapName } from "./math/color_maps.ts";
import type { Vector } from "./math/frame.ts";
import type { HexColor } from "./scene/hexahedra.ts";

export type Layer = "part" | "creases" | "arcs" | "nodes" | "streamlines" | "glyphs" | "cells" | "hexahedra" | "mesh_lines";
export type CutAxis = "x" | "y" | "z" | "view";
export type GlyphShape = "curve" | "cross" | "cube";
export type GlyphColor = "axes" | "tilt" | "turn";
export type UpAxis = "x" | "y" | "z";
/** Of a page of tets: the field on them, or the grid from which it started. */
export type FieldName = "main" | "grid";
export type StreamSet = "cut" | "surface";
export type ThemeChoice = "auto" | "light" | "dark";

export interface Settings {
  theme: ThemeChoice;
  field: FieldName;
  up: UpAxis;
  layers: Record<Layer, boolean>;
  /** Of the part, 0 ... 1. */
  opacity: number;
  map: MapName;
  cut: {
    on: boolean;
    axis: CutAxis;
    /** Unit normal of a cut across the view; cuts along axes do not use it. */
    normal: Vector;
    /** Along the normal, 0 ... 1 from the lowest to the highest corner of the part's box. */
    position: number;
    /** Whether the half that is taken away is the one below. */
    flip: boolean;
    clip: boolean;
  };
  glyph: {
    shape: GlyphShape;
    color: GlyphColor;
    /** Steps of a factor of two away from the automatic distance between frames. */
    density: number;
  };
  /** Where the streamlines begin that are shown. */
  streams: StreamSet;
  /** The tet or cell that is picked, or -1. */
  picked: number;
  hex_color: HexColor;
  /** Hexahedra are shown with a scaled Jacobian below this; all of them from 1. */
  below: number;
  /** The hexahedron that is picked, or -1: its place in the scene. */
  hexahedron: number;
  /** Whether only this one is shown, with those around it faintly. */
  alone: boolean;
  /** The face of the model that is picked, and a point of it in the scene's coordinates. */
  face: { number: number; point: Vector } | null;
  /** A place that is marked, in the scene's coordinates. */
  marked: { point: Vector; label: string; warn: boolean } | null;
}

export type Part = Partial<Omit<Settings, "cut" | "glyph" | "layers">> & {
  cut?: Partial<Settings["cut"]>;
  glyph?: Partial<Settings["glyph"]>;
  layers?: Partial<Settings["layers"]>;
};

export class SettingsStore {
  current: Settings = {
    theme: "auto",
    field: "main",
    up: "z",
    layers: { part: true, creases: true, arcs: true, nodes: true, streamlines: false, glyphs: true, cells: true, hexahedra: true, mesh_lines: false },
    opacity: 0.35,
    map: "none",
    cut: { on: true, axis: "y", normal: [0, 1, 0], position: 0.5, flip: false, clip: true },
    glyph: { shape: "curve", color: "axes", density: 0 },
    streams: "cut",
    picked: -1,
    hex_color: "shape",
    below: 1,
    hexahedron: -1,
    alone: false,
    face: null,
    marked: null,
  };
  private listeners: ((settings: Settings) => void)[] = [];

  subscribe(listener: (settings: Settings) => void): void {
    this.listeners.push(listener);
  }

  change(part: Part): void {
    const { cut, glyph, layers, ...rest } = part;
    // Who asks for another cut or other hexahedra wants to see them.
    const shows_others = cut !== undefined || rest.below !== undefined || rest.field !== undefined || layers?.hexahedra !== undefined;
    this.current = {
      ...this.current,
      ...(shows_others ? { alone: false } : {}),
      ...rest,
      cut: { ...this.current.cut, ...cut },
      glyph: { ...this.current.glyph, ...glyph },
      layers: { ...this.current.layers, ...layers },
    };
    for (const listener of this.listeners) listener(this.current);
  }
}

/** Whether hexahedra are looked at, on a page that has some. */
export const is_of_hexahedra = ({ layers, field }: Settings): boolean => layers.hexahedra && field === "main";

/** The unit normal of the cut; what lies further along it is taken away. */
export function cut_normal({ cut }: Settings): Vector {
  const normal: Vector = cut.axis === "x" ? [1, 0, 0] : cut.axis === "y" ? [0, 1, 0] : cut.axis === "z" ? [0, 0, 1] : cut.normal;
  return cut.flip ? [-normal[0], -normal[1], -normal[2]] : normal;
}

/** Where the cut lies along its normal: points p of it have dot(normal, p) = this. */
export function cut_offset(settings: Settings, low: Vector, high: Vector): number {
  const normal = cut_normal({ ...settings, cut: { ...settings.cut, flip: false } });
  let least = 0;
  let most = 0;
  for (let axis = 0; axis < 3; ++axis) {
    least += Math.min(normal[axis] * low[axis], normal[axis] * high[axis]);
    most += Math.max(normal[axis] * low[axis], normal[axis] * high[axis]);
  }
  const offset = least + settings.cut.position * (most - least);
  return settings.cut.flip ? -offset : offset;
}
