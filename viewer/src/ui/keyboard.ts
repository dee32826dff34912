// SPDX-License-Identifier: Apache-2.0
// Keys, and the dialog that lists them: one table for both.

import { element } from "./dom.ts";

export interface Key {
  /** As in KeyboardEvent.key, letters in lower case; several do the same. */
  keys: string[];
  shown: string;
  does: string;
  act: (event: KeyboardEvent) => void;
}

export interface KeyGroup {
  name: string;
  keys: Key[];
}

export class Keyboard {
  private enabled = true;

  constructor(private readonly groups: KeyGroup[], private readonly dialog: HTMLDialogElement) {
    document.addEventListener("keydown", (event) => this.pressed(event));
    this.fill_dialog();
  }

  help(): void {
    if (!this.dialog.open) this.dialog.showModal();
  }

  private pressed(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || this.dialog.open) return;
    const target = event.target as HTMLElement;
    const control = target.closest("input, select, textarea, button, summary, [role=tab], .matrix-scroll");
    // Controls keep the keys that they use themselves; letters go through, but not from lists, which find entries by them.
    const own = ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End", "Enter", " ", "PageUp", "PageDown"];
    if (control && (own.includes(event.key) || control.tagName === "SELECT")) return;
    if (!this.enabled && event.key.length === 1 && event.key !== "?") return;
    // Keys that turn or move the view belong to it alone: elsewhere they scroll.
    if (own.includes(event.key) && target.id !== "view" && target !== document.body) return;
    for (const group of this.groups) {
      const key = group.keys.find(({ keys }) => keys.includes(event.key.length === 1 ? event.key.toLowerCase() : event.key));
      if (!key) continue;
      event.preventDefault();
      key.act(event);
      return;
    }
  }

  private fill_dialog(): void {
    const single = element("input", { type: "checkbox", checked: true, change: () => (this.enabled = single.checked), "data-testid": "keys-on" });
    this.dialog.append(
      element("div", { class: "help-head" }, element("h2", { id: "help-title" }, "Keys and gestures"),
        element("button", { type: "button", autofocus: true, click: () => this.dialog.close(), "data-testid": "help-close" }, "Close")),
      element("div", { class: "help-body" },
        element("section", {}, element("h3", {}, "Pointer"), element("dl", { class: "keys-list" },
          ...[["drag", "turn"], ["right drag, or two fingers", "move"], ["wheel, or pinch", "zoom to the pointer"], ["click, or tap", "pick what is there"], ["double click", "fly to what is there"]]
            .flatMap(([shown, does]) => [element("dt", {}, shown), element("dd", {}, does)]))),
        ...this.groups.map((group) => element("section", {}, element("h3", {}, group.name), element("dl", { class: "keys-list" },
          ...group.keys.flatMap(({ shown, does }) => [element("dt", {}, ...shown.split(" ").map((one) => element("kbd", {}, one))), element("dd", {}, does)])))),
      ),
      element("label", { class: "check" }, single, element("span", {}, "Single letters are shortcuts")),
    );
    this.dialog.addEventListener("click", (event) => {
      if (event.target === this.dialog) this.dialog.close();
    });
  }
}
