// SPDX-License-Identifier: Apache-2.0
// Whether a hexahedral mesh can follow the field, in the words of the report: a badge, and a card with all reasons, each once, with its
// places.

import { subtract, type Vector } from "../math/frame.ts";
import { reasons_with_faults, type Fault } from "../scene/faults.ts";
import type { Reason, Report, VerdictName } from "../scene/report.ts";
import { element_alignment, element_center, element_count, element_energy, type Scene } from "../scene/scene.ts";
import { sign, type Badge, type Judgement } from "./badge.ts";
import { element, measured } from "./dom.ts";
import type { Place } from "./place.ts";
import { fault_groups, folded_places, in_words, place_button, place_lists, place_of_fault, worst_buttons, type Go } from "./places.ts";

const kVerdicts: Record<VerdictName, { judgement: Judgement; short: string; sign: string }> = {
  meshable: { judgement: "good", short: "hexahedra fit locally", sign: "✓" },
  not_meshable: { judgement: "bad", short: "hexahedra cannot follow this field", sign: "!" },
  undecided: { judgement: "unsure", short: "undecided", sign: "?" },
};

interface Answer extends Badge {
  /** It has the first reason. */
  sentence: string;
}

/** The answer of the report; null where it has none. */
export function answer_of(report: Report): Answer | null {
  const verdict = report.verdict && kVerdicts[report.verdict];
  return verdict ? { ...verdict, sentence: report.answer ?? verdict.short } : null;
}

/** A reason with the places that it is about: its faults, or the one that it names. */
interface Because {
  reason: Reason;
  places: Place[];
}

// What is at the place of a reason that has none of the faults.
const kNamedPlaces: Record<string, string> = { other_at_half: "Differing line", creases: "Worst crease" };

function reasons_of(report: Report, origin: Vector): { reasons: Because[]; others: Fault[] } {
  const { reasons, others } = reasons_with_faults(report);
  const named = ({ kind, place, verdict, count }: Reason): Place[] =>
    (count > 0 ? [{ label: `${kNamedPlaces[kind] ?? "Place"}${count > 1 ? `, one of ${count}` : ""}`, detail: "", point: subtract(place, origin), warn: verdict === "not_meshable" }] : []);
  return { reasons: reasons.map(({ reason, faults }) => ({ reason, places: faults.length > 0 ? faults.map((fault) => place_of_fault(fault, origin)) : named(reason) })), others };
}

/** All places that the answer is about, the first of each reason first. */
export function places_of_answer(report: Report, origin: Vector): Place[] {
  const { reasons, others } = reasons_of(report, origin);
  return [...reasons.flatMap(({ places }) => places.slice(0, 1)), ...reasons.flatMap(({ places }) => places.slice(1)), ...others.map((fault) => place_of_fault(fault, origin))];
}

/** The card with the worst places beneath the answer, then the further reasons, and faults that no reason names. */
export function answer_blocks(report: Report, scene: Scene | null, origin: Vector, go: Go | null): HTMLElement[] {
  const answer = answer_of(report);
  const { reasons, others } = reasons_of(report, origin);
  const [first, ...rest] = reasons;
  // That a solve was stopped has a card of its own.
  const further = rest.filter(({ reason }) => reason.kind !== "unfinished" || !report.unfinished);
  const blocks = answer ? [answer_card(answer, worst_places(report, scene, origin), first?.places ?? [], origin, go)] : [];
  if (further.length > 0) {
    blocks.push(element("section", { class: "block", "data-testid": "further-reasons" }, element("h2", {}, "Further reasons"),
      element("ul", { class: "reasons" }, ...further.map((because) => reason_item(because, origin, go)))));
  }
  return [...blocks, ...place_lists(fault_groups(others, origin), origin, go)];
}

function answer_card(answer: Answer, worst: Place[], of_first: Place[], origin: Vector, go: Go | null): HTMLElement {
  const { short, sentence, judgement } = answer;
  const rest = sentence.startsWith(short) ? sentence.slice(short.length) : ` (${sentence})`;
  return element("div", { class: `verdict ${judgement}`, "data-testid": "verdict" },
    sign(answer),
    element("div", {},
      element("p", { class: "words", "data-testid": "answer" }, element("strong", { class: "verdict-text" }, short), rest),
      worst_buttons(worst, origin, go),
      of_first.length > 1 && go ? folded_places(in_words(of_first.length, "place", "places"), of_first, origin, go) : null,
    ),
  );
}

function reason_item({ reason: { text, next }, places }: Because, origin: Vector, go: Go | null): HTMLElement {
  return element("li", {},
    element("p", { class: "words" }, text, next ? element("span", { class: "soft" }, `; next: ${next}`) : null),
    places.length === 1 && go ? element("div", { class: "places" }, place_button(places[0], origin, go)) : null,
    places.length > 1 && go ? folded_places(in_words(places.length, "place", "places"), places, origin, go) : null);
}

// Beyond this an angle is worth a look: below it a field follows its surface.
const kLeastTilt = 5;
const kWorst = 3;

/** The worst three places: what is impossible or undecided, then where the field is farthest off its surface, then where it turns most. */
export function worst_places(report: Report, scene: Scene | null, origin: Vector): Place[] {
  const places: Place[] = [];
  for (const place of [...places_of_answer(report, origin), ...(scene ? extremes(scene) : [])]) {
    if (places.length === kWorst) break;
    if (place.point && !places.some(({ point }) => point!.every((value, k) => value === place.point![k]))) places.push(place);
  }
  return places;
}

function extremes(scene: Scene): Place[] {
  let [tilt, tilted] = [kLeastTilt, -1];
  let [energy, tense] = [0, -1];
  for (let element = 0; element < element_count(scene); ++element) {
    const angle = element_alignment(scene, element) ?? 0;
    if (angle > tilt) [tilt, tilted] = [angle, element];
    if (element_energy(scene, element) > energy) [energy, tense] = [element_energy(scene, element), element];
  }
  const places: Place[] = [];
  const unit = scene.unit ? ` ${scene.unit}⁻²` : "";
  if (tilted >= 0) places.push({ label: "Worst alignment", detail: `${measured(tilt)}°`, point: element_center(scene, tilted), warn: false });
  if (tense >= 0) places.push({ label: "Largest energy density", detail: `${measured(energy)}${unit}`, point: element_center(scene, tense), warn: false });
  return places;
}
