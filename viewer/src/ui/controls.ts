// SPDX-License-Identifier: Apache-2.0
// The controls of the view. Each is bound to one setting: it changes the store, and follows it when keys or links change it.

import type { MapName } from "../math/color_maps.ts";
import type { Vector } from "../math/frame.ts";
import { hex_colors, type Hexahedra } from "../scene/hexahedra.ts";
import type { Scene } from "../scene/scene.ts";
import { cut_normal, cut_offset, is_of_hexahedra, type CutAxis, type Layer, type UpAxis, type Settings, type SettingsStore } from "../settings.ts";
import { element, measured } from "./dom.ts";
import { kHexColorNames } from "./hex_panel.ts";

type Follow = (settings: Settings) => void;

class Bindings {
  readonly follow: Follow[] = [];
  constructor(readonly store: SettingsStore) {}

  check(label: string, test: string, read: (settings: Settings) => boolean, write: (value: boolean) => void, title = ""): HTMLElement {
    const input = element("input", { type: "checkbox", "data-testid": test, change: () => write(input.checked) });
    this.follow.push((settings) => (input.checked = read(settings)));
    return element("label", { class: "check", title: title || undefined }, input, element("span", {}, label));
  }

  layer(label: string, layer: Layer): HTMLElement {
    return this.check(label, `show-${layer}`, (settings) => settings.layers[layer], (value) => this.store.change({ layers: { [layer]: value } }));
  }

  choice<T extends string>(label: string, test: string, options: [T, string][], read: (settings: Settings) => T, write: (value: T) => void): HTMLElement {
    const inputs = options.map(([value]) => element("input", { type: "radio", name: test, value, "data-testid": `${test}-${value}`, change: () => write(value) }));
    this.follow.push((settings) => inputs.forEach((input) => (input.checked = input.value === read(settings))));
    return element("div", { class: "segments", role: "radiogroup", "aria-label": label },
      ...options.map(([, text], k) => element("label", {}, inputs[k], element("span", {}, text))));
  }

  select<T extends string>(label: string, test: string, options: [T, string][], read: (settings: Settings) => T, write: (value: T) => void): HTMLElement {
    const select = element("select", { "data-testid": test, change: () => write(select.value as T) },
      ...options.map(([value, text]) => element("option", { value }, text)));
    this.follow.push((settings) => (select.value = read(settings)));
    return element("label", { class: "row" }, element("span", {}, label), select);
  }

  slider(label: string, test: string, [low, high, step]: Vector, read: (settings: Settings) => number, write: (value: number) => void, said: (settings: Settings) => string): HTMLElement {
    // The label names its control by id: inside it the output would be taken for what it labels.
    const input = element("input", { type: "range", id: `control-${test}`, min: low, max: high, step, "data-testid": test, input: () => write(Number(input.value)) });
    const output = element("output", {});
    this.follow.push((settings) => {
      input.value = String(read(settings));
      output.textContent = said(settings);
      input.setAttribute("aria-valuetext", said(settings));
    });
    return element("label", { class: "slider", for: input.id }, element("span", { class: "slider-name" }, element("span", {}, label), output), input);
  }
}

function group(name: string, ...children: (HTMLElement | null)[]): HTMLElement {
  return element("fieldset", { class: "group" }, element("legend", {}, name), ...children);
}

export interface ControlActions {
  cut(on: boolean): void;
  cut_across(axis: CutAxis): void;
  turn_up(up: UpAxis): void;
}

/** Fills a panel with the controls, and returns what makes them follow the settings. `follows_field`: whether hexahedra do. */
export function make_controls(panel: HTMLElement, store: SettingsStore, scene: Scene, follows_field: boolean, actions: ControlActions): Follow {
  const bind = new Bindings(store);
  const unit = scene.unit ? ` ${scene.unit}` : "";
  const has_streams = scene.streamline_starts.length > 1;
  const maps: [MapName, string][] = [["none", "Plain"], ["alignment", "Alignment"], ["energy", "Energy"]];
  // Classes of constraints are those of cells.
  if (!scene.tets && !scene.tet_counts) maps.push(["class", "Class"]);
  if (scene.regions.length > 1) maps.push(["region", "Regions"]);
  // What concerns the field alone is not there while hexahedra stand for it.
  const of_field = (...parts: HTMLElement[]): HTMLElement[] => {
    if (!scene.has_field) return [];
    if (scene.hexahedra) bind.follow.push((settings) => parts.forEach((part) => (part.hidden = is_of_hexahedra(settings))));
    return parts;
  };
  const of_mesh = (part: HTMLElement): HTMLElement => {
    bind.follow.push((settings) => (part.hidden = !is_of_hexahedra(settings)));
    return part;
  };
  panel.append(
    ...(scene.hexahedra ? [hexahedra_controls(bind, scene, scene.hexahedra, of_mesh)] : []),
    ...(scene.grid ? of_field(group("Field",
      bind.choice("Field", "field", [["main", "Tets"], ["grid", "Starting grid"]], (settings) => settings.field, (field) => store.change({ field, picked: -1, hexahedron: -1 })))) : []),
    ...of_field(group("Colour by",
      bind.choice("Colour by", "map", maps,
        (settings) => settings.map, (map) => store.change({ map, opacity: map !== "none" && store.current.opacity < 0.5 ? 0.85 : store.current.opacity })),
    )),
    group("Cut",
      bind.check("Cut through the part", "cut-on", (settings) => settings.cut.on, (on) => actions.cut(on)),
      bind.choice("Direction of the cut", "cut-axis", [["x", "X"], ["y", "Y"], ["z", "Z"], ["view", "View"]],
        (settings) => settings.cut.axis,
        (axis) => actions.cut_across(axis)),
      bind.slider("Position", "cut-position", [0, 1, 0.002], (settings) => settings.cut.position, (position) => store.change({ cut: { position, on: true } }),
        (settings) => `${measured(absolute_offset(settings, scene), 4)}${unit}`),
      element("div", { class: "pair" },
        bind.check("Take half away", "cut-clip", (settings) => settings.cut.clip, (clip) => store.change({ cut: { clip } })),
        element("button", { type: "button", "data-testid": "cut-flip", title: "Take the other half away (R)", click: () => store.change({ cut: { flip: !store.current.cut.flip } }) }, "Flip"),
      ),
      ...of_field(bind.layer(scene.tets ? "Sides of the tets" : "Sides of the cells", "cells")),
    ),
    ...of_field(group("Frames on the cut",
      bind.layer("Frames", "glyphs"),
      bind.choice("Shape of frames", "glyph-shape", [["curve", "Curves"], ["cross", "Crosses"], ["cube", "Cubes"]], (settings) => settings.glyph.shape, (shape) => store.change({ glyph: { shape } })),
      bind.select("Colour", "glyph-color", [["axes", "axes x, y, z"], ["tilt", "tilt out of the cut"], ["turn", "turn in the cut"]],
        (settings) => settings.glyph.color, (color) => store.change({ glyph: { color } })),
      bind.slider("Density", "glyph-density", [-2, 2, 1], (settings) => settings.glyph.density, (density) => store.change({ glyph: { density } }),
        ({ glyph: { density } }) => (density === 0 ? "automatic" : density > 0 ? `${2 ** density} × closer` : `${2 ** -density} × wider`)),
    )),
    group("Show",
      element("div", { class: "grid" },
        bind.layer("Part", "part"), bind.layer("Creases", "creases"), ...of_field(bind.layer("Singular lines", "arcs"), bind.layer("Nodes", "nodes")),
        scene.hexahedra && follows_field ? of_mesh(bind.layer("Singular lines", "mesh_lines")) : null,
        ...(has_streams ? of_field(bind.layer("Streamlines", "streamlines")) : []),
      ),
      ...(has_streams ? of_field(bind.select("Seeds", "streams", [["cut", "from the cut"], ["surface", "from the surface"]], (settings) => settings.streams, (streams) => store.change({ streams, layers: { streamlines: true } }))) : []),
      bind.slider("Opacity", "opacity", [0, 1, 0.05], (settings) => settings.opacity, (opacity) => store.change({ opacity }),
        (settings) => `${Math.round(100 * settings.opacity)} %`),
      element("div", { class: "row" }, element("span", {}, "Up"),
        bind.choice("Axis that points up", "up", [["x", "X"], ["y", "Y"], ["z", "Z"]], (settings) => settings.up, (up) => actions.turn_up(up))),
    ),
  );
  return (settings) => bind.follow.forEach((follow) => follow(settings));
}

function hexahedra_controls(bind: Bindings, { has_field }: Scene, hexahedra: Hexahedra, of_mesh: (part: HTMLElement) => HTMLElement): HTMLElement {
  const { store } = bind;
  const colors = hex_colors(hexahedra);
  return group("Mesh",
    bind.choice(has_field ? "Hexahedra or field" : "Hexahedra or model", "mesh", [["hexahedra", "Hexahedra"], ["field", has_field ? "Field" : "Model"]], (settings) => (is_of_hexahedra(settings) ? "hexahedra" : "field"),
      (choice) => store.change({ layers: { hexahedra: choice === "hexahedra" }, field: "main", picked: -1, hexahedron: -1 })),
    colors.length > 1 ? of_mesh(element("div", { class: "row" }, element("span", {}, "Colour"),
      bind.choice("Colour of hexahedra", "hex-color", colors.map((color) => [color, kHexColorNames[color]]), ({ hex_color }) => hex_color, (hex_color) => store.change({ hex_color })))) : null,
    bind.slider("Scaled Jacobian below", "below", [0, 1, 0.01], (settings) => settings.below, (below) => store.change({ below, layers: { hexahedra: true }, field: "main" }),
      ({ below }) => (below < 1 ? below.toFixed(2) : "all")));
}

/** Where the cut lies in the coordinates of the model. */
function absolute_offset(settings: Settings, scene: Scene): number {
  const upright: Settings = { ...settings, cut: { ...settings.cut, flip: false } };
  const normal = cut_normal(upright);
  return cut_offset(upright, scene.low, scene.high) + normal.reduce((sum, value, k) => sum + value * scene.origin[k], 0);
}
