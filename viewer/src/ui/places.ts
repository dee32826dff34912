// SPDX-License-Identifier: Apache-2.0
// Places worth a look, as lists of buttons that take the camera there: faults of the singular lines, what was found wrong with the
// surface, knife edges and crowded corners.

import { add, subtract, type Vector } from "../math/frame.ts";
import type { Report } from "../scene/report.ts";
import type { Scene } from "../scene/scene.ts";
import { counted, element, measured, plural } from "./dom.ts";

export interface Place {
  label: string;
  detail: string;
  /** In the scene's coordinates; null where the report names none. */
  point: Vector | null;
  warn: boolean;
}

export interface PlaceGroup {
  name: string;
  places: Place[];
  /** Said where there is nothing to list; groups without it are left out then. */
  empty?: string;
}

const kArcTypes = ["of index +1/2", "rotation about an axis across it", "of changing index", "rotation about no axis of the frame"];
// Lists begin this short: what matters is that there are many.
const kFirst = 6;

export function place_groups(report: Report, scene: Scene | null): PlaceGroup[] {
  const origin: Vector = scene?.origin ?? [0, 0, 0];
  const local = (point: Vector | null | undefined): Vector | null => (point ? subtract(point, origin) : null);
  const numbered = (places: Vector[] | undefined, label: string, detail: string): Place[] =>
    (places ?? []).map((point, k) => ({ label: `${label} ${k + 1}`, detail, point: local(point), warn: false }));
  return [
    { name: "Faults of the singular lines", places: scene ? singular_faults(scene) : [] },
    {
      name: "Found in the input",
      places: (report.input?.findings ?? []).map((finding) => ({
        label: `${finding.at_least ? "at least " : ""}${counted(finding.count)} ${finding.kind}`,
        detail: [finding.length ? `${measured(finding.length)} long` : "", finding.done_text ?? ""].filter(Boolean).join("; "),
        point: local(finding.place),
        warn: false,
      })),
      empty: report.input ? "Nothing: the surface is clean." : undefined,
    },
    { name: "Knife edges", places: numbered(report.creases?.knife_edge_places, "Edge", "less than 45° of solid") },
    { name: "Crowded corners", places: numbered(report.creases?.crowded_corner_places, "Corner", "more than three creases") },
  ];
}

function singular_faults(scene: Scene): Place[] {
  const places: Place[] = [];
  for (let arc = 0; arc < scene.arc_verdict.length; ++arc) {
    if (scene.arc_verdict[arc] !== 1) continue;
    const middle = Math.floor((scene.arc_starts[arc] + scene.arc_starts[arc + 1] - 1) / 2);
    places.push({ label: `Line ${arc + 1}`, detail: kArcTypes[scene.arc_type[arc]] ?? "", point: triple(scene.arc_points, middle), warn: true });
  }
  for (let node = 0; node < scene.node_verdict.length; ++node) {
    const verdict = scene.node_verdict[node];
    if (scene.node_on_boundary[node] || verdict === 0) continue;
    const degree = scene.node_degree[node];
    places.push({
      label: `Node ${node + 1}`,
      detail: verdict === 1 ? `${plural(degree, "line")} here, as hexahedra cannot meet` : `${plural(degree, "line")} here: undecided`,
      point: triple(scene.node_points, node),
      warn: verdict === 1,
    });
  }
  return places;
}

const triple = (values: Float32Array, k: number): Vector => [values[3 * k], values[3 * k + 1], values[3 * k + 2]];

export function place_lists(groups: PlaceGroup[], origin: Vector, go: (place: Place) => void): HTMLElement[] {
  return groups.filter((group) => group.places.length > 0 || group.empty).map((group) => {
    const items = group.places.map((place) => element("li", {}, place_button(place, origin, go)));
    const list = element("ul", { class: "places" }, ...items.slice(0, kFirst));
    const rest = items.slice(kFirst);
    const more = element("button", { class: "quiet", type: "button", click: () => {
      list.append(...rest);
      rest[0].querySelector("button")?.focus();
      more.remove();
    } }, `Show ${counted(rest.length)} more`);
    return element("section", { class: "block", "data-testid": `places-${group.name.toLowerCase().replaceAll(" ", "-")}` },
      element("h2", {}, group.name, items.length > 0 ? element("span", { class: "tally" }, counted(items.length)) : null),
      items.length > 0 ? list : element("p", { class: "fine" }, group.empty ?? ""),
      rest.length > 0 && more,
    );
  });
}

function place_button(place: Place, origin: Vector, go: (place: Place) => void): HTMLElement {
  const text = element("span", { class: "place-text" },
    element("strong", {}, place.warn ? "! " : "", place.label),
    place.detail ? element("span", {}, place.detail) : null,
  );
  const point = place.point;
  if (!point) return element("div", { class: "place" }, text);
  const absolute = add(point, origin).map((value) => measured(value)).join(", ");
  return element("button", { class: `place${place.warn ? " warn" : ""}`, type: "button", title: `at ${absolute}`, click: () => go(place), "data-testid": "place" },
    text, element("span", { class: "go", "aria-hidden": "true" }, "→"));
}
