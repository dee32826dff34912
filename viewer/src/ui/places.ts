// SPDX-License-Identifier: Apache-2.0
// Places worth a look, as lists of buttons that take the camera there: faults of singular lines, creases and corners, what was found
// wrong with the surface, and crowded corners.

import { add, subtract, type Vector } from "../math/frame.ts";
import { faults_of, type Fault, type FaultPart } from "../scene/faults.ts";
import type { Report } from "../scene/report.ts";
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

const kFaultNames: Record<FaultPart, string> = { line: "Line", node: "Node", crease: "Crease", corner: "Corner" };
// Lists begin this short: what matters is that there are many.
const kFirst = 6;

export function place_groups(report: Report, origin: Vector): PlaceGroup[] {
  const local = (point: Vector | null | undefined): Vector | null => (point ? subtract(point, origin) : null);
  const faults = faults_of(report);
  const places_of = (...parts: FaultPart[]): Place[] => faults.filter(({ part }) => parts.includes(part)).map((fault) => place_of(fault, origin));
  return [
    { name: "Faults of the singular lines", places: places_of("line", "node") },
    { name: "Creases and corners", places: places_of("crease", "corner") },
    {
      name: "Found in the input",
      places: (report.input?.findings ?? []).map((finding) => ({
        label: `${finding.at_least ? "at least " : ""}${plural(finding.count, finding.kind.replace(/s$/, ""), finding.kind)}`,
        detail: [finding.length ? `${measured(finding.length)} long` : "", finding.done_text ?? ""].filter(Boolean).join("; "),
        point: local(finding.place),
        warn: false,
      })),
      empty: report.input ? "Nothing: the surface is clean." : undefined,
    },
    {
      name: "Crowded corners",
      places: (report.creases?.crowded_corner_places ?? []).map((point, k) => ({ label: `Corner ${k + 1}`, detail: "more than three creases", point: local(point), warn: false })),
    },
  ];
}

function place_of({ part, number, verdict, place, words }: Fault, origin: Vector): Place {
  return { label: `${kFaultNames[part]} ${number}`, detail: verdict === "undecided" ? `undecided: ${words}` : words, point: subtract(place, origin), warn: verdict === "not_meshable" };
}

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
