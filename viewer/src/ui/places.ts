// SPDX-License-Identifier: Apache-2.0
// Places worth a look, as lists of buttons that take the camera there: faults of singular lines, creases and corners, what was found
// wrong with the surface, and crowded corners.

import { add, subtract, type Vector } from "../math/frame.ts";
import type { Fault, FaultPart } from "../scene/faults.ts";
import type { Report } from "../scene/report.ts";
import { coordinates, counted, element, measured, plural } from "./dom.ts";
import type { Place } from "./place.ts";

/** Places of one kind, summed up in a few words; without any they are listed at once. */
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

/** What takes the camera to a place. */
export type Go = (place: Place) => void;

const kFaultNames: Record<FaultPart, string> = { line: "Line", node: "Node", end: "Node", crease: "Crease", corner: "Corner" };
// Lists begin this short: what matters is that there are many.
const kFirst = 6;

// What there is one of, and several of, for each kind of fault.
const kFaultKinds: Record<FaultPart, Record<Fault["verdict"], [string, string]>> = {
  line: { not_meshable: ["singular line that hexahedra cannot have", "singular lines that hexahedra cannot have"], undecided: ["undecided singular line", "undecided singular lines"] },
  node: { not_meshable: ["node at which no hexahedra meet", "nodes at which no hexahedra meet"], undecided: ["undecided node", "undecided nodes"] },
  end: { not_meshable: ["node at which no hexahedra meet", "nodes at which no hexahedra meet"], undecided: ["place where lines end close together", "places where lines end close together"] },
  crease: { not_meshable: ["edge below 45 degrees", "edges below 45 degrees"], undecided: ["edge where rounding decides", "edges where rounding decides"] },
  corner: { not_meshable: ["corner that no hexahedra fit around", "corners that no hexahedra fit around"], undecided: ["undecided corner", "undecided corners"] },
};

/** Faults that no reason names. */
export function fault_groups(faults: Fault[], origin: Vector): PlaceGroup[] {
  const kinds_of = (...parts: FaultPart[]): PlaceKind[] => parts.flatMap((part) => (["not_meshable", "undecided"] as const).flatMap((verdict) => {
    const places = faults.filter((fault) => fault.part === part && fault.verdict === verdict).map((fault) => place_of_fault(fault, origin));
    return places.length > 0 ? [{ summary: in_words(places.length, ...kFaultKinds[part][verdict]), places }] : [];
  }));
  return [{ name: "Faults of the singular lines", kinds: kinds_of("line", "node", "end") }, { name: "Creases and corners", kinds: kinds_of("crease", "corner") }];
}

/** What the reader found wrong with the model. */
export function input_groups(report: Report, origin: Vector): PlaceGroup[] {
  const local = (point: Vector | null | undefined): Vector | null => (point ? subtract(point, origin) : null);
  const crowded = (report.creases?.crowded_corner_places ?? []).map((point, k) => ({ label: `Corner ${k + 1}`, detail: "", point: local(point), warn: false }));
  return [
    {
      name: "Found in the input",
      kinds: (report.input?.findings ?? []).map((finding) => {
        const label = `${finding.at_least ? "at least " : ""}${plural(finding.count, finding.kind.replace(/s$/, ""), finding.kind)}`;
        const detail = [finding.length ? `${measured(finding.length)} long` : "", finding.done_text ?? ""].filter(Boolean).join("; ");
        return { summary: "", places: [{ label, detail, point: local(finding.place), warn: false }] };
      }),
      empty: report.input && !(report.warnings ?? []).some(({ kind }) => kind === "missing_faces") ? "Nothing: the surface is clean." : undefined,
    },
    { name: "Crowded corners", kinds: crowded.length > 0 ? [{ summary: in_words(crowded.length, "corner with more than three creases", "corners with more than three creases"), places: crowded }] : [] },
  ];
}

const kNumbers = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"];

/** "Ten edges"; numbers up to twelve in words. */
export function in_words(count: number, one: string, many: string): string {
  const number = kNumbers[count] ?? counted(count);
  return `${number[0].toUpperCase()}${number.slice(1)} ${count === 1 ? one : many}`;
}

export const place_of_fault = ({ part, number, verdict, place, words }: Fault, origin: Vector): Place =>
  ({ label: `${kFaultNames[part]} ${number}`, detail: words, point: subtract(place, origin), warn: verdict === "not_meshable" });

/** Lists of all groups; kinds with several places are summed up in a line that opens, if they have one. */
export function place_lists(groups: PlaceGroup[], origin: Vector, go: Go | null): HTMLElement[] {
  return groups.filter(({ kinds, empty }) => kinds.length > 0 || empty).map(({ name, kinds, empty }) => {
    const count = kinds.reduce((sum, { places }) => sum + places.length, 0);
    return element("section", { class: "block", "data-testid": `places-${name.toLowerCase().replaceAll(" ", "-")}` },
      element("h2", {}, name, count > 1 ? element("span", { class: "tally" }, counted(count)) : null),
      ...kinds.flatMap(({ summary, places }) => (places.length === 1
        ? [element("div", {}, summary ? element("p", { class: "fine" }, summary) : null, element("div", { class: "places" }, place_button(places[0], origin, go)))]
        : summary ? [folded_places(summary, places, origin, go)] : place_list(places, origin, go))),
      count === 0 ? element("p", { class: "fine" }, empty ?? "") : null,
    );
  });
}

/** Places beneath a line that opens them. */
export const folded_places = (summary: string, places: Place[], origin: Vector, go: Go | null): HTMLElement =>
  element("details", { class: "kind", "data-testid": "kind" }, element("summary", {}, summary), ...place_list(places, origin, go));

function place_list(places: Place[], origin: Vector, go: Go | null): (HTMLElement | null)[] {
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

/** A button where there is a view and a point to go to. */
export function place_button(place: Place, origin: Vector, go: Go | null): HTMLElement {
  const text = element("span", { class: "place-text" },
    element("strong", {}, place.warn ? "! " : "", place.label),
    place.detail ? element("span", {}, place.detail) : null,
  );
  const point = place.point;
  if (!point || !go) return element("div", { class: "place" }, text);
  return element("button", { class: `place${place.warn ? " warn" : ""}`, type: "button", title: at_point(point, origin), click: () => go(place), "data-testid": "place" },
    text, element("span", { class: "go", "aria-hidden": "true" }, "→"));
}

/** Where a point of the scene is in the model. */
export const at_point = (point: Vector, origin: Vector): string => `at ${coordinates(add(point, origin), 3)}`;

/** The places that are worst, as buttons beneath an answer. */
export function worst_buttons(places: Place[], origin: Vector, go: Go | null): HTMLElement | null {
  const shown = places.filter(({ point }) => point !== null && go !== null);
  if (shown.length === 0) return null;
  return element("div", { class: "worst", role: "group", "aria-label": "Worst places" }, ...shown.map((place, k) =>
    element("button", { type: "button", "data-testid": "worst-place", click: () => go!(place), title: at_point(place.point!, origin) },
      shown.length > 1 ? element("span", { class: "rank", "aria-hidden": "true" }, String(k + 1)) : null,
      element("span", {}, place.detail ? `${place.label}: ${place.detail}` : place.label))));
}
