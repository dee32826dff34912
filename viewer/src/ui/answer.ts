// SPDX-License-Identifier: Apache-2.0
// Whether a hexahedral mesh can follow the field, in the words of the report: a badge, and a card with all reasons.

import { add, subtract, type Vector } from "../math/frame.ts";
import type { Reason, Report, VerdictName } from "../scene/report.ts";
import { element_alignment, element_center, element_count, element_energy, type Scene } from "../scene/scene.ts";
import { sign, type Badge, type Judgement } from "./badge.ts";
import { element, measured, plural } from "./dom.ts";
import { hexahedra_places } from "./hex_panel.ts";
import type { Place } from "./place.ts";
import { place_groups, place_lists } from "./places.ts";

const kVerdicts: Record<VerdictName, { judgement: Judgement; short: string; sign: string }> = {
  meshable: { judgement: "good", short: "hexahedra fit locally", sign: "✓" },
  not_meshable: { judgement: "bad", short: "this field has no hexahedra", sign: "!" },
  undecided: { judgement: "unsure", short: "undecided", sign: "?" },
};

export interface Answer extends Badge {
  sentence: string;
  /** Those of the verdict first; the sentence has the first. */
  reasons: Reason[];
}

/** The answer of the report; null where it has none. */
export function answer_of(report: Report): Answer | null {
  const verdict = report.verdict && kVerdicts[report.verdict];
  return verdict ? { ...verdict, sentence: report.answer ?? verdict.short, reasons: report.reasons ?? [] } : null;
}

/** The place of a reason in the scene's coordinates. */
export function place_of(reason: Reason, origin: Vector): Place {
  const at = reason.count > 1 ? `at ${plural(reason.count, "place")}` : "";
  return {
    label: reason.text.replace(/^./, (letter) => letter.toUpperCase()),
    detail: [at, reason.next ? `next: ${reason.next}` : ""].filter(Boolean).join("; "),
    point: reason.count > 0 ? subtract(reason.place, origin) : null,
    warn: reason.verdict === "not_meshable",
  };
}

/** The card with the worst places beneath the answer, and all reasons besides the one in its sentence. */
export function answer_blocks(answer: Answer | null, worst: Place[], origin: Vector, go: (place: Place) => void): HTMLElement[] {
  if (!answer) return [];
  const further = answer.reasons.slice(1).map((reason) => place_of(reason, origin));
  return [answer_card(answer, worst, origin, go), ...place_lists([{ name: "Further reasons", kinds: further.map((place) => ({ summary: place.label, places: [place] })) }], origin, go)];
}

function answer_card(answer: Answer, worst: Place[], origin: Vector, go: (place: Place) => void): HTMLElement {
  const { short, sentence, judgement } = answer;
  const rest = sentence.startsWith(short) ? sentence.slice(short.length) : ` (${sentence})`;
  return element("div", { class: `verdict ${judgement}`, "data-testid": "verdict" },
    sign(answer),
    element("div", {},
      element("p", { class: "words", "data-testid": "answer" }, element("strong", { class: "verdict-text" }, short), rest),
      worst.length > 0 ? element("div", { class: "worst", role: "group", "aria-label": "Worst places" }, ...worst.map((place, k) =>
        element("button", {
          type: "button", "data-testid": "worst-place", click: () => go(place),
          title: `${place.label}${place.detail ? `; ${place.detail}` : ""}, at ${add(place.point!, origin).map((value) => measured(value)).join(", ")}`,
        }, element("span", { class: "rank", "aria-hidden": "true" }, String(k + 1)), element("span", {}, place.short ?? place.label)))) : null,
    ),
  );
}

// Beyond these an angle or an energy is worth a look: below them a field follows its surface.
const kLeastTilt = 5;
const kWorst = 3;

/** The worst three places: what is impossible or undecided, then where the field is farthest off its surface, then where it turns most. */
export function worst_places(report: Report, scene: Scene | null, origin: Vector): Place[] {
  const found = [...hexahedra_places(report, origin).slice(0, 1), ...(report.reasons ?? []).map((reason) => place_of(reason, origin)), ...place_groups(report, origin).slice(0, 2).flatMap(({ kinds }) => kinds.flatMap(({ places }) => places))];
  if (scene) found.push(...extremes(scene));
  const places: Place[] = [];
  for (const place of found) {
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
  if (tilted >= 0) places.push({ label: `Surface ${measured(tilt)}° off the nearest axis`, detail: "worst alignment", point: element_center(scene, tilted), warn: false });
  if (tense >= 0) places.push({ label: `Energy density ${measured(energy)}${unit}`, detail: "largest energy density", short: "Largest energy density", point: element_center(scene, tense), warn: false });
  return places;
}
