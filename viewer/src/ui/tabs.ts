// SPDX-License-Identifier: Apache-2.0
// The panels beside the view, or on a phone in the drawer below it. On wide pages the controls of the view have a place of their own, and
// their tab is hidden.

import { by_id, element } from "./dom.ts";

export const kPanels = ["field", "view", "cell"] as const;
export type Panel = (typeof kPanels)[number];

const kNames: Record<Panel, string> = { field: "Field", view: "View", cell: "Cell" };

export class Tabs {
  private readonly tabs = new Map<Panel, HTMLButtonElement>();
  private readonly narrow = matchMedia("(max-width: 799px)");
  /** Whether the controls of the view lie over it. */
  private readonly wide = matchMedia("(min-width: 1100px)");
  current: Panel = "field";

  constructor(private readonly changed: () => void) {
    for (const panel of kPanels) {
      const tab = element("button", {
        type: "button", role: "tab", id: `tab-${panel}`, "aria-controls": `panel-${panel}`, "data-testid": `tab-${panel}`,
        click: () => (this.narrow.matches && panel === this.current && this.is_open() ? this.open(false) : this.select(panel)),
        keydown: (event) => this.arrow(event as KeyboardEvent),
      }, kNames[panel]);
      this.tabs.set(panel, tab);
      by_id("tabs").append(tab);
      by_id(`panel-${panel}`).setAttribute("role", "tabpanel");
    }
    // The controls' own panel is no tab's on wide pages.
    const adapt = (): void => {
      by_id("panel-view").setAttribute("role", this.wide.matches ? "region" : "tabpanel");
      if (this.wide.matches && this.current === "view") this.current = "field";
      this.show();
    };
    for (const size of [this.narrow, this.wide]) size.addEventListener("change", adapt);
    adapt();
    if (this.narrow.matches) this.open(false);
  }

  select(panel: Panel): void {
    this.current = panel;
    this.open(true);
    this.show();
  }

  is_open(): boolean {
    return !document.body.classList.contains("drawer-closed");
  }

  open(open: boolean): void {
    document.body.classList.toggle("drawer-closed", !open);
    this.show();
  }

  /** A tab may say more than its name: the cell that is picked, or that the numbers are those of a mesh. */
  rename(panel: Panel, text: string): void {
    this.tabs.get(panel)!.textContent = text;
    by_id(`panel-${panel}`).setAttribute("aria-label", text);
  }

  private show(): void {
    document.body.dataset.panel = this.current;
    for (const [panel, tab] of this.tabs) {
      const chosen = panel === this.current;
      const wide_view = panel === "view" && this.wide.matches;
      tab.hidden = wide_view;
      tab.setAttribute("aria-selected", String(chosen));
      tab.setAttribute("aria-expanded", String(chosen && this.is_open()));
      tab.tabIndex = chosen ? 0 : -1;
      by_id(`panel-${panel}`).hidden = !wide_view && (!chosen || (this.narrow.matches && !this.is_open()));
    }
    this.changed();
  }

  private arrow(event: KeyboardEvent): void {
    const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (step === 0) return;
    event.preventDefault();
    const shown = kPanels.filter((panel) => !this.tabs.get(panel)!.hidden);
    const next = shown[(shown.indexOf(this.current) + step + shown.length) % shown.length];
    this.select(next);
    this.tabs.get(next)!.focus();
  }
}
