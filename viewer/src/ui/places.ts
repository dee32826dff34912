// SPDX-License-Identifier: Apache-2.0
// Places worth a look, as lists of buttons that take the camera there: faults of singular lines, creases and corners, what was found
// wrong with the surface, and crowded corners.

import { add, subtract, type Vector } from "../math/frame.ts";
import { faults_of, type Fault, type FaultPart } from "../scene/faults.ts";
import type { Report } from "../scene/report.ts";
import { counted, element, measured, plural } from "./dom.ts";
import { hexahedra_places } from "./hex_panel.ts";
import type { Place } from "./place.ts";

/** Places of one kind, summed up in a few words. */
export interface PlaceKind {
  summary: string;
  places: Place[];
}

export interface PlaceGroup {
  name: string;
  kinds: PlaceKind[];
  /** Said where there is nothing to list; groups without it are left out then. */
  empty?: string;
}

const kFaultNames: Record<FaultPart, string> = { line: "Line", node: "Node", crease: "Crease", corner: "Corner" };
// Lists begin this short: what matters is that there are many.
const kFirst = 6;

// What there is one of, and several of, for each kind of fault.
const kFaultKinds: Record<FaultPart, Record<Fault["verdict"], [string, string]>> = {
  line: { not_meshable: ["singular line that hexahedra cannot have", "singular lines that hexahedra cannot have"], undecided: ["undecided singular line", "undecided singular lines"] },
  node: { not_meshable: ["node at which no hexahedra meet", "nodes at which no hexahedra meet"], undecided: ["undecided node", "undecided nodes"] },
  crease: { not_meshable: ["edge below 45 degrees", "edges below 45 degrees"], undecided: ["edge where rounding decides", "edges where rounding decides"] },
  corner: { not_meshable: ["corner that no hexahedra fit around", "corners that no hexahedra fit around"], undecided: ["undecided corner", "undecided corners"] },
};

export function place_groups(report: Report, origin: Vector): PlaceGroup[] {
  const local = (point: Vector | null | undefined): Vector | null => (point ? subtract(point, origin) : null);
  const faults = faults_of(report);
  const kinds_of = (...parts: FaultPart[]): PlaceKind[] => parts.flatMap((part) => (["not_meshable", "undecided"] as const).flatMap((verdict) => {
    const places = faults.filter((fault) => fault.part === part && fault.verdict === verdict).map((fault) => place_of(fault, origin));
    return places.length > 0 ? [{ summary: in_words(places.length, ...kFaultKinds[part][verdict]), places }] : [];
  }));
  const crowded = (report.creases?.crowded_corner_places ?? []).map((point, k) => ({ label: `Corner ${k + 1}`, detail: "more than three creases", point: local(point), warn: false }));
  const unmeshed = report.hexahedra?.outcome === "all-hex" ? [] : hexahedra_places(report, origin).slice(1);
  return [
    { name: "Faults of the singular lines", kinds: kinds_of("line", "node") },
    { name: "Creases and corners", kinds: kinds_of("crease", "corner") },
    {
      name: "Found in the input",
      kinds: (report.input?.findings ?? []).map((finding) => {
        const label = `${finding.at_least ? "at least " : ""}${plural(finding.count, finding.kind.replace(/s$/, ""), finding.kind)}`;
        const detail = [finding.length ? `${measured(finding.length)} long` : "", finding.done_text ?? ""].filter(Boolean).join("; ");
        return { summary: label, places: [{ label, detail, point: local(finding.place), warn: false }] };
      }),
      empty: report.input ? "Nothing: the surface is clean." : undefined,
    },
    { name: "Where hexahedra fail", kinds: unmeshed.length > 0 ? [{ summary: in_words(unmeshed.length, "place", "places"), places: unmeshed }] : [] },
    { name: "Crowded corners", kinds: crowded.length > 0 ? [{ summary: in_words(crowded.length, "corner with more than three creases", "corners with more than three creases"), places: crowded }] : [] },
  ];
}

const kNumbers = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"];

/** "Ten edges"; numbers up to twelve in words. */
function in_words(count: number, one: string, many: string): string {
  const number = kNumbers[count] ?? counted(count);
  return `${number[0].toUpperCase()}${number.slice(1)} ${count === 1 ? one : many}`;
}

function place_of({ part, number, verdict, place, words }: Fault, origin: Vector): Place {
  return { label: `${kFaultNames[part]} ${number}`, detail: verdict === "undecided" ? `undecided: ${words}` : words, point: subtract(place, origin), warn: verdict === "not_meshable" };
}

/** Lists of all groups; kinds with several places are summed up in a line that opens. */
export function place_lists(groups: PlaceGroup[], origin: Vector, go: (place: Place) => void): HTMLElement[] {
  return groups.filter(({ kinds, empty }) => kinds.length > 0 || empty).map(({ name, kinds, empty }) => {
    const count = kinds.reduce((sum, { places }) => sum + places.length, 0);
    return element("section", { class: "block", "data-testid": `places-${name.toLowerCase().replaceAll(" ", "-")}` },
      element("h2", {}, name, count > 1 ? element("span", { class: "tally" }, counted(count)) : null),
      ...kinds.map(({ summary, places }) => (places.length === 1
        ? element("div", { class: "places" }, place_button(places[0], origin, go))
        : element("details", { class: "kind", "data-testid": "kind" }, element("summary", {}, summary), ...place_list(places, origin, go)))),
      count === 0 ? element("p", { class: "fine" }, empty ?? "") : null,
    );
  });
}

function place_list(places: Place[], origin: Vector, go: (place: Place) => void): (HTMLElement | null)[] {
  const items = places.map((place) => element("li", {}, place_button(place, origin, go)));
  const list = element("ul", { class: "places" }, ...items.slice(0, kFirst));
  const rest = items.slice(kFirst);
  const more = element("button", { class: "quiet", type: "button", click: () => {
    list.append(...rest);
    rest[0].querySelector("button")?.focus();
    more.remove();
  } }, `Show ${counted(rest.length)} more`);
  return [list, rest.length > 0 ? more : null];
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
