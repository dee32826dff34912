// SPDX-License-Identifier: Apache-2.0
// What each key does.

import type { MapName } from "../math/color_maps.ts";
import { hex_colors } from "../scene/hexahedra.ts";
import { is_of_hexahedra, type CutAxis, type Layer } from "../settings.ts";
import type { ViewName } from "../view/camera_rig.ts";
import type { Commands } from "./commands.ts";
import type { Key, KeyGroup } from "./keyboard.ts";
import { kHexColorNames } from "./hex_panel.ts";
import { next_theme } from "./toolbar.ts";

const kTurn = Math.PI / 24;
const kStep = 0.06;

export function key_groups(commands: Commands): KeyGroup[] {
  const { store, stage, scene: { has_field, hexahedra } } = commands;
  const of_field = (...keys: Key[]): Key[] => (has_field ? keys : []);
  const arrow = (shown: string, key: string, right: number, up: number): Key => ({
    keys: [key], shown, does: "",
    act: (event) => (event.shiftKey ? stage.rig.pan(right * kStep, up * kStep) : stage.rig.turn(right * kTurn, -up * kTurn)),
  });
  const view = (key: string, name: ViewName, does: string): Key => ({ keys: [key], shown: key, does, act: () => commands.view(name) });
  const layer = (key: string, name: Layer, does: string): Key => ({
    keys: [key], shown: key.toUpperCase(), does, act: () => store.change({ layers: { [name]: !store.current.layers[name] } }),
  });
  // Those of the mesh and those of the field are shown each for itself. A lattice has none.
  const lines = (key: string, name: Layer, does: string): Key => ({
    keys: [key], shown: key.toUpperCase(), does,
    act: () => {
      const is_solid = hexahedra && is_of_hexahedra(store.current);
      if (is_solid && !commands.follows_field) return;
      const shown = is_solid ? "mesh_lines" : name;
      store.change({ layers: { [shown]: !store.current.layers[shown] } });
    },
  });
  const axis = (key: string, name: CutAxis, does: string): Key => ({
    keys: [key], shown: key.toUpperCase(), does,
    act: () => commands.cut_across(name),
  });
  const move = (key: string, direction: number): Key => ({
    keys: direction < 0 ? ["[", "{"] : ["]", "}"], shown: key, does: direction < 0 ? "cut lower; Shift: a little" : "cut higher; Shift: a little",
    act: (event) => {
      const step = event.shiftKey ? 0.002 : 0.02;
      store.change({ cut: { on: true, position: Math.min(1, Math.max(0, store.current.cut.position + direction * step)) } });
    },
  });
  const arrows = [arrow("←", "ArrowLeft", -1, 0), arrow("→", "ArrowRight", 1, 0), arrow("↑", "ArrowUp", 0, 1), arrow("↓", "ArrowDown", 0, -1)];
  return [
    {
      name: "Camera",
      keys: [
        { keys: arrows.flatMap(({ keys }) => keys), shown: "← → ↑ ↓", does: "turn; Shift: move", act: (event) => arrows.find(({ keys }) => keys.includes(event.key))?.act(event) },
        { keys: ["+", "="], shown: "+", does: "nearer", act: () => stage.rig.zoom(1 / 1.15) },
        { keys: ["-", "_"], shown: "−", does: "further", act: () => stage.rig.zoom(1.15) },
        { keys: ["f"], shown: "F", does: "the whole part", act: () => stage.rig.fit(true) },
        { keys: ["u"], shown: "U", does: "another axis up", act: () => commands.turn_up(({ x: "y", y: "z", z: "x" } as const)[store.current.up]) },
        view("0", "iso", "at an angle"), view("1", "front", "front"), view("2", "back", "back"), view("3", "right", "right"),
        view("4", "left", "left"), view("5", "top", "top"), view("6", "bottom", "bottom"),
      ],
    },
    {
      name: "Cut",
      keys: [
        { keys: ["c"], shown: "C", does: "cut or whole", act: () => commands.cut(!store.current.cut.on) },
        axis("x", "x", "across x"), axis("y", "y", "across y"), axis("z", "z", "across z"), axis("v", "view", "across the view"),
        move("[", -1), move("]", 1),
        { keys: ["r"], shown: "R", does: "other half", act: () => store.change({ cut: { flip: !store.current.cut.flip } }) },
        { keys: ["h"], shown: "H", does: "take half away, or not", act: () => store.change({ cut: { clip: !store.current.cut.clip } }) },
      ],
    },
    {
      name: "Show",
      keys: [
        layer("p", "part", "part"), layer("k", "creases", "creases"),
        ...of_field(lines("s", "arcs", "singular lines"), lines("n", "nodes", "nodes"),
          layer("l", "streamlines", "streamlines"), layer("g", "glyphs", "frames"), layer("e", "cells", "cells")),
        ...(hexahedra ? [layer("q", "hexahedra", has_field ? "hexahedra or the field" : "hexahedra or the model")] : []),
        ...of_field({ keys: ["b"], shown: "B", does: "curves, crosses or cubes", act: () => store.change({ glyph: { shape: ({ curve: "cross", cross: "cube", cube: "curve" } as const)[store.current.glyph.shape] } }) }),
        { keys: ["m"], shown: "M", does: "next colour", act: () => next_map(commands) },
        { keys: ["t"], shown: "T", does: "light or dark", act: () => next_theme(commands) },
      ],
    },
    {
      name: has_field ? "Places and cells" : "Places and hexahedra",
      keys: [
        { keys: ["Enter"], shown: "Enter", does: "pick what is in the middle", act: () => commands.pick_middle() },
        { keys: [".", ">"], shown: ".", does: "next place", act: () => commands.visit_next(1) },
        { keys: [",", "<"], shown: ",", does: "place before", act: () => commands.visit_next(-1) },
        { keys: ["Escape"], shown: "Esc", does: "clear pick and mark", act: () => commands.clear() },
        { keys: ["?"], shown: "?", does: "this list", act: () => commands.help() },
      ],
    },
  ];
}

function next_map(commands: Commands): void {
  const { hexahedra } = commands.scene;
  if (hexahedra && is_of_hexahedra(commands.store.current)) {
    const colors = hex_colors(hexahedra);
    const hex_color = colors[(colors.indexOf(commands.store.current.hex_color) + 1) % colors.length];
    commands.store.change({ hex_color });
    return commands.announce(`Coloured by ${kHexColorNames[hex_color].toLowerCase()}`);
  }
  if (!commands.scene.has_field) return;
  const maps: MapName[] = ["none", "alignment", "energy"];
  if (!commands.scene.tets) maps.push("class");
  if (commands.scene.regions.length > 1) maps.push("region");
  const { map, opacity } = commands.store.current;
  const next = maps[(maps.indexOf(map) + 1) % maps.length];
  commands.store.change({ map: next, opacity: next !== "none" && opacity < 0.5 ? 0.85 : opacity });
  commands.announce(`Coloured by ${next === "none" ? "nothing" : next}`);
}
