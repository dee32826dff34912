// SPDX-License-Identifier: Apache-2.0
// A judgement in a sign and a few words.

import { element } from "./dom.ts";

export type Judgement = "good" | "unsure" | "bad";

export interface Badge {
  judgement: Judgement;
  short: string;
  sign: string;
}

export function badge(judged: Badge | null): Node[] {
  return judged ? [sign(judged), element("span", { class: "words" }, judged.short)] : [];
}

export const sign = ({ judgement, sign: text }: Badge): HTMLElement => element("span", { class: `sign ${judgement}`, "aria-hidden": "true" }, text);
