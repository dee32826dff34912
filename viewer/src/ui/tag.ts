// SPDX-License-Identifier: Apache-2.0
// The name of what is looked at, beside it in the view.

import { by_id, element } from "./dom.ts";
import type { FreeArea } from "./free_area.ts";

// Above the ring around a place.
const kAbove = 30;

export class Tag {
  private readonly box = by_id("tag");
  private readonly text = element("span", { "data-testid": "tag" });

  constructor(clear: () => void) {
    this.box.append(this.text, element("button", { type: "button", class: "quiet", "aria-label": "Clear the mark", "data-testid": "tag-clear", click: clear }, "×"));
  }

  /** Says something above a place of the canvas and what reaches so far around it, within what is free; nothing where there is no place. */
  show(text: string, at: [number, number] | null, around: number, free: FreeArea): void {
    this.box.hidden = at === null;
    if (!at) return;
    this.text.textContent = text;
    const { offsetWidth, offsetHeight } = this.box;
    const within = (value: number, low: number, high: number): number => Math.max(low, Math.min(value, Math.max(low, high)));
    this.box.style.left = `${within(at[0] - offsetWidth / 2, free.left, free.right - offsetWidth)}px`;
    // Beneath the place where there is no room above it.
    const away = Math.max(kAbove, around);
    const above = at[1] - away - offsetHeight;
    this.box.style.top = `${within(above < free.top ? at[1] + away : above, free.top, free.bottom - offsetHeight)}px`;
  }
}
