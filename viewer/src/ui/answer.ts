// SPDX-License-Identifier: Apache-2.0
// Whether a hexahedral mesh can follow the field, in the words of the report: a badge, and a card with all reasons.

import { add, subtract, type Vector } from "../math/frame.ts";
import type { Reason, Report, VerdictName } from "../scene/report.ts";
import { element, measured, plural } from "./dom.ts";
import { place_lists, type Place } from "./places.ts";

type Judgement = "good" | "unsure" | "bad";

const kVerdicts: Record<VerdictName, { judgement: Judgement; short: string; sign: string }> = {
  meshable: { judgement: "good", short: "can be meshed locally", sign: "✓" },
  not_meshable: { judgement: "bad", short: "cannot be meshed", sign: "!" },
  undecided: { judgement: "unsure", short: "undecided", sign: "?" },
};

export interface Answer {
  judgement: Judgement;
  short: string;
  sign: string;
  sentence: string;
  /** Those of the verdict first; the sentence has the first. */
  reasons: Reason[];
}

/** The answer of the report; null where it has none. */
export function answer_of(report: Report): Answer | null {
  const verdict = report.verdict && kVerdicts[report.verdict];
  return verdict ? { ...verdict, sentence: report.answer ?? verdict.short, reasons: report.reasons ?? [] } : null;
}

export function badge(answer: Answer | null): Node[] {
  return answer ? [sign(answer), element("span", { class: "words" }, answer.short)] : [];
}

const sign = ({ judgement, sign: text }: Answer): HTMLElement => element("span", { class: `sign ${judgement}`, "aria-hidden": "true" }, text);

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

/** The card, and the reasons that its sentence does not have. */
export function answer_blocks(answer: Answer | null, origin: Vector, go: (place: Place) => void): HTMLElement[] {
  if (!answer) return [];
  const [first, ...further] = answer.reasons.map((reason) => place_of(reason, origin));
  return [answer_card(answer, first, origin, go), ...place_lists([{ name: "Further reasons", places: further }], origin, go)];
}

function answer_card(answer: Answer, first: Place | undefined, origin: Vector, go: (place: Place) => void): HTMLElement {
  const { short, sentence, judgement } = answer;
  const rest = sentence.startsWith(short) ? sentence.slice(short.length) : ` (${sentence})`;
  return element("div", { class: `verdict ${judgement}`, "data-testid": "verdict" },
    sign(answer),
    element("div", {},
      element("p", { class: "words", "data-testid": "answer" }, element("strong", { class: "verdict-text" }, short), rest),
      first?.point ? element("button", { type: "button", title: `at ${add(first.point, origin).map((value) => measured(value)).join(", ")}`, click: () => go(first), "data-testid": "answer-place" }, "Show the place") : null,
    ),
  );
}
