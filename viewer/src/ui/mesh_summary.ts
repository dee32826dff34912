// SPDX-License-Identifier: Apache-2.0
// A mesh of hexahedra in numbers: the answer, sizes and numbers beside those asked for, the worst hexahedron, how it fits the model, the
// way to it, files.

import { subtract, type Vector } from "../math/frame.ts";
import { hexahedron_centered_at, is_inverted, number_of } from "../scene/hexahedra.ts";
import { is_of_lattice, type HexDistances, type HexFeatures, type HexReport, type Report } from "../scene/report.ts";
import type { Scene } from "../scene/scene.ts";
import { advice_on } from "./advice.ts";
import { sign, type Badge } from "./badge.ts";
import { coordinates, counted, duration, element, measured, memory, plural } from "./dom.ts";
import { hexahedra_text, hexahedron_title, shape_text } from "./hex_panel.ts";
import type { Place } from "./place.ts";
import { place_lists, worst_buttons, type Go } from "./places.ts";
import { number } from "./summary.ts";

const kOutcomes: Record<string, Badge> = {
  "all-hex": { judgement: "good", short: "all-hex", sign: "✓" },
  approximate: { judgement: "unsure", short: "approximate mesh", sign: "!" },
  partial: { judgement: "unsure", short: "partial mesh", sign: "!" },
  none: { judgement: "bad", short: "no mesh", sign: "!" },
};

/** Whether hexahedra fill the model, and whether something is wrong all the same; null if none were asked for. */
export function hexahedra_badge({ hexahedra }: Report): Badge | null {
  if (!hexahedra) return null;
  const outcome = kOutcomes[hexahedra.outcome] ?? kOutcomes.partial;
  const badge = is_of_lattice({ hexahedra }) ? { ...outcome, short: `${outcome.short} by a lattice` } : outcome;
  return badge.judgement === "good" && hexahedra.reason ? { ...badge, judgement: "unsure", sign: "!" } : badge;
}

/** The answer, why it is not another, and the worst hexahedron. */
export function mesh_card(report: Report, scene: Scene | null, origin: Vector, go: Go | null): HTMLElement {
  const outcome = hexahedra_badge(report)!;
  const { hexahedra, reason, remedy, remedy_number, next, is_stopped } = report.hexahedra!;
  const why = [lacking(report.hexahedra!), reason, advice_on(remedy, remedy_number, next)].filter(Boolean).join("; ");
  return element("div", { class: `verdict ${outcome.judgement}`, "data-testid": "hexahedra" },
    sign(outcome),
    element("div", {},
      element("p", { class: "words" }, element("strong", { class: "verdict-text" }, outcome.short), `${is_stopped ? ", the search was stopped" : ""}: ${hexahedra_text(hexahedra)}`),
      why ? element("p", { class: "fine" }, `${why}.`) : null,
      worst_buttons([...worst_hexahedron(report, scene, origin), ...worst_fit(report, origin)], origin, go)),
  );
}

/** What a part of the model lacks, and where. */
export function lacking({ outcome, left_out, left_out_place }: HexReport): string {
  if (outcome !== "partial" || !left_out) return "";
  return `${plural(left_out, "cell")} left out${left_out_place ? ` near ${coordinates(left_out_place)}` : ""}`;
}

// Above it a hexahedron is a box, and the worst of a perfect mesh is none to look at.
const kPerfect = 1 - 1e-6;

/** The worst hexahedron; none if the report names none, or all are boxes. */
function worst_hexahedron({ hexahedra }: Report, scene: Scene | null, origin: Vector): Place[] {
  const shapes = hexahedra?.scaled_jacobian;
  if (!hexahedra || hexahedra.hexahedra === 0 || !shapes?.worst_place || shapes.min > kPerfect) return [];
  const place = place_of_hexahedron(subtract(shapes.worst_place, origin), scene);
  return [{ ...place, label: "Worst hexahedron", detail: shape_text(shapes.min), warn: shapes.inverted > 0 }];
}

/** A hexahedron, where one has its centre there, or a point. */
function place_of_hexahedron(point: Vector, scene: Scene | null): Pick<Place, "point" | "hexahedron" | "of_mesh"> {
  const hexahedron = scene?.hexahedra ? hexahedron_centered_at(scene.hexahedra, point) : -1;
  return { point, of_mesh: true, ...(hexahedron < 0 ? {} : { hexahedron }) };
}

/** The worst hexahedron, the worst fit, and where the mesh lacks some or has bad ones. */
export function mesh_places(report: Report, scene: Scene | null, origin: Vector): Place[] {
  return [...worst_hexahedron(report, scene, origin), ...worst_fit(report, origin), ...failing_places(report, scene, origin), ...lacking_places(report.hexahedra, origin)];
}

function failing_places({ hexahedra }: Report, scene: Scene | null, origin: Vector): Place[] {
  if (!hexahedra || hexahedra.outcome === "all-hex") return [];
  return (hexahedra.places ?? []).map((at) => {
    const place = place_of_hexahedron(subtract(at, origin), scene);
    if (place.hexahedron === undefined) return { ...place, label: words_of_place(at, hexahedra), detail: coordinates(at), warn: true };
    const label = hexahedron_title({ number: number_of(scene!.hexahedra!, place.hexahedron) });
    const shape = shape_text(scene!.hexahedra!.shape[place.hexahedron], is_inverted(scene!.hexahedra!, place.hexahedron));
    return { ...place, label, detail: `scaled Jacobian ${shape}`, warn: true };
  });
}

// Places in sentences are rounded: by less than this share of their largest coordinate.
const kRounded = 1e-3;

/** What is wrong at a place, in the words of the reason: the part of it that ends in this place. */
function words_of_place(at: Vector, { reason = "", left_out_place }: HexReport): string {
  const size = Math.max(...at.map(Math.abs));
  const is_at = (place: readonly number[]): boolean => place.every((value, k) => Math.abs(value - at[k]) <= kRounded * size);
  for (const part of reason.split(/; |, and /)) {
    const [, words, ...place] = /^(.*?),? (?:\([^)]*)?(?:around|at|near) (\S+) (\S+) ([^\s,;)]+)/.exec(part) ?? [];
    if (words && is_at(place.map(Number))) return words[0].toUpperCase() + words.slice(1);
  }
  return left_out_place && is_at(left_out_place) ? "Cell left out" : "Place of the reason";
}

/** The places that the reason counts, without those that have a button beneath it. */
export function failing_list(report: Report, scene: Scene | null, origin: Vector, go: Go | null): HTMLElement[] {
  const named = [...worst_hexahedron(report, scene, origin), ...worst_fit(report, origin)];
  const places = failing_places(report, scene, origin).filter(({ point }) => !named.some((other) => other.point!.every((value, k) => value === point![k])));
  return place_lists([{ name: "Where it fails", kinds: places.length === 0 ? [] : [{ summary: "", places }] }], origin, go);
}

/** Used size and number beside those asked for, shapes, fit, way, files, cost. */
export function mesh_numbers(report: Report, scene: Scene | null): HTMLElement[] {
  const mesh = report.hexahedra!;
  const unit = report.model?.unit ? ` ${report.model.unit}` : "";
  const list = element("dl", { class: "numbers", "data-testid": "numbers" });
  const { scaled_jacobian: shapes } = mesh;
  list.append(...size_number(report, unit));
  list.append(number("Hexahedra", counted(mesh.hexahedra), expected_text(mesh), "number-hexahedra"));
  if (shapes && mesh.hexahedra > 0) list.append(number("Worst scaled Jacobian", shape_text(shapes.min), [worst_number(mesh, scene), `${measured(shapes.mean, 2)} in the mean`].filter(Boolean).join(", "), "number-worst"));
  if (report.seconds?.total !== undefined) list.append(number("Time", duration(report.seconds.total), report.peak_memory_bytes ? memory(report.peak_memory_bytes) : ""));
  const facts: [string, string, string][] = [["Fit", fit_text(mesh, unit), "mesh-fit"], ["Features", mesh.features ? kept_text(mesh.features) : "", "mesh-features"], ["Inverted", shapes?.inverted ? counted(shapes.inverted) : "", "mesh-inverted"], ["Way", mesh.way ?? "", "mesh-way"], ["Files", files_of(report).join(", "), "mesh-files"]];
  const told = facts.filter(([, text]) => text !== "");
  return [list, element("dl", { class: "facts" }, ...told.flatMap(([name, text, test]) => [element("dt", {}, name), element("dd", { "data-testid": test }, text)]))];
}

/** The size beside that asked for. Layers along features make hexahedra of a lattice smaller than its cells: what counts is their mean. */
function size_number(report: Report, unit: string): HTMLElement[] {
  const { size, used_size, mean_edge, hexahedra } = report.hexahedra!;
  if (!used_size) return [];
  const text = (length: number): string => `${measured(length)}${unit}`;
  if (!is_of_lattice(report) || hexahedra === 0 || !mean_edge) return [number("Size of hexahedra", text(used_size), size && size !== used_size ? `not ${text(size)}` : "", "number-size")];
  const notes = [size ? `asked for: ${text(size)}` : "", size !== used_size ? `lattice: ${text(used_size)}` : ""];
  return [number("Mean edge", text(mean_edge), notes.filter(Boolean).join(", "), "number-size")];
}

/** What is kept of the model's features, in the words of the terminal. */
export function kept_text({ corners, creases, faces, small = 0, too_small = [] }: HexFeatures): string {
  const parts = ([[corners, "corner", "corners"], [creases, "crease", "creases"], [faces, "face", "faces"]] as const)
    .filter(([{ all }]) => all > 0).map(([{ all, kept }, one, many]) => `${kept} of ${all} ${all === 1 ? one : many}`);
  const kept = parts.length > 0 ? `${parts.join(", ")} kept` : "";
  const others = parts.length === 0 ? plural(small, "feature") : `${small} ${small === 1 ? "other" : "others"}`;
  return [kept, small > 0 ? `${others} smaller than the hexahedra, ${too_small.length === 0 ? "kept too" : `${too_small.length} of which are not kept`}` : ""].filter(Boolean).join("; ");
}

const kLackNames: Record<string, string> = { corner: "Corner", crease: "Crease", face: "Face" };

/** The corners, creases and faces that the mesh lacks of those that it has room for. */
export function lacking_list({ hexahedra }: Report, origin: Vector, go: Go | null): HTMLElement[] {
  const places = lacking_places(hexahedra, origin);
  return place_lists([{ name: "Not kept of the model", kinds: places.length === 0 ? [] : [{ summary: "", places }] }], origin, go);
}

function lacking_places(hexahedra: HexReport | undefined, origin: Vector): Place[] {
  return (hexahedra?.features?.lacking ?? []).filter(({ kind }) => kind in kLackNames).map(({ kind, number: at, place, share }) => ({
    label: `${kLackNames[kind]}${at ? ` ${at}` : ""}`, detail: kind === "face" ? "no quads" : kind === "crease" ? `${Math.round(100 * share)} % kept` : "no vertex on it", point: subtract(place, origin), warn: true, of_mesh: true,
  }));
}

/** How many were expected before the work, at the size given or by default; of hexahedra that were given nothing. */
function expected_text({ expected, attempts }: HexReport): string {
  if (!expected || attempts?.length === 0) return "";
  return `about ${measured(Number(Math.max(1, expected).toPrecision(2)), 2)} expected`;
}

function worst_number({ scaled_jacobian: shapes }: HexReport, scene: Scene | null): string {
  if (!scene?.hexahedra || !shapes?.worst_place) return "";
  const hexahedron = hexahedron_centered_at(scene.hexahedra, subtract(shapes.worst_place, scene.origin));
  return hexahedron < 0 ? "" : `of hexahedron ${counted(number_of(scene.hexahedra, hexahedron))}`;
}

const kModels: Record<string, string> = { cad: "CAD model", surface: "given surface", tets: "given tets" };

function fit_text(mesh: HexReport, unit: string): string {
  const { hexahedra, volume, model_volume, area, model_area, model } = mesh;
  if (hexahedra === 0) return "";
  const off = (name: string, of: number | undefined, all: number | undefined): string => (of !== undefined && all ? `${name} ${percent(of / all)}` : "");
  const sizes = [off("volume", volume, model_volume), off("area", area, model_area)].filter(Boolean).join(", ");
  const distances = distances_of(mesh);
  const apart = distances.length === 0 ? "" : distances.filter(({ distance }) => distance > 0).map(({ words, distance }) => words(`${measured(distance, 2)}${unit}`)).join(", ") || "on the surface";
  return [sizes && model ? `${sizes} of the ${kModels[model] ?? model}` : sizes, apart].filter(Boolean).join("; ");
}

const is_off = (distance: number, { size = 1 }: Pick<HexReport, "size">): boolean => distance > kLeastDistance * size;

interface Farthest {
  distance: number;
  place?: Vector;
  /** With a length. */
  words: (length: string) => string;
}

/** The largest distances, the larger last: of the mesh from the model, and of the model from the mesh. */
function distances_of(mesh: HexReport): Farthest[] {
  const { size = 1, features } = mesh;
  if (mesh.largest_distance === undefined) return [];
  // At vertices, or within quads and triangles.
  const farther = (at_vertices: number, place: Vector | undefined, within: HexDistances | undefined): { distance: number; place?: Vector } => {
    const found = size * (within?.largest_in_all ?? 0) > at_vertices ? { distance: size * within!.largest_in_all, place: within!.place_in_all } : { distance: at_vertices, place };
    return is_off(found.distance, mesh) ? found : { ...found, distance: 0 };
  };
  const both: Farthest[] = [
    { ...farther(mesh.largest_distance, mesh.largest_distance_place, features?.of_mesh), words: (length) => `mesh up to ${length} off the surface` },
    { ...farther(mesh.largest_distance_of_model ?? 0, mesh.largest_distance_of_model_place, features?.of_model), words: (length) => `surface up to ${length} from the mesh` },
  ];
  return both.sort((a, b) => a.distance - b.distance);
}

/** Where the mesh fits worst. */
function worst_fit({ hexahedra, model }: Report, origin: Vector): Place[] {
  const farthest = hexahedra && hexahedra.hexahedra > 0 ? distances_of(hexahedra).at(-1) : null;
  if (!farthest?.place || !is_off(farthest.distance, hexahedra!)) return [];
  return [{ label: "Worst fit", detail: farthest.words(`${measured(farthest.distance, 2)}${model?.unit ? ` ${model.unit}` : ""}`), point: subtract(farthest.place, origin), warn: false, of_mesh: true }];
}

// Below this a share is rounding: of volume and area in percent, of a distance in sizes asked for.
const kLeastPercent = 0.001;
const kLeastDistance = 1e-6;

/** With its sign: +0.12 %. */
function percent(ratio: number): string {
  const off = 100 * (ratio - 1);
  return Math.abs(off) < kLeastPercent ? "±0 %" : `${off < 0 ? "−" : "+"}${measured(Math.abs(off), 2)} %`;
}

// What any result with hexahedra has, and how names of what was asked for besides begin.
const kMeshFileStart = "hexahedra";

/** Those of every mesh. One with inverted hexahedra is for display alone. */
function mesh_files({ outcome, scaled_jacobian }: HexReport): string[] {
  const start = outcome === "partial" ? `${kMeshFileStart}.partial` : kMeshFileStart;
  return (scaled_jacobian?.inverted ? ["vtu"] : ["vtu", "msh", "mesh", "inp"]).map((format) => `${start}.${format}`);
}

/** The files that have the mesh, and its map. */
function files_of({ hexahedra, files = [] }: Report): string[] {
  if (!hexahedra || hexahedra.hexahedra === 0) return [];
  return [...new Set([...mesh_files(hexahedra), ...files.map(({ name }) => name).filter((name) => name.startsWith(kMeshFileStart))])];
}

/** The file with this ending that has the mesh; none if there is none. */
export const mesh_file = (report: Report, ending: "inp" | "msh"): string | undefined => files_of(report).find((name) => name.endsWith(`.${ending}`));
