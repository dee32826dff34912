// SPDX-License-Identifier: Apache-2.0
// The buttons over the 3D view: views along the axes, the whole part, a picture, light or dark, help.

import type { ThemeChoice } from "../settings.ts";
import type { ViewName } from "../view/camera_rig.ts";
import type { Commands } from "./commands.ts";
import { drawing, element } from "./dom.ts";

const kViews: [ViewName, string, string][] = [
  ["iso", "Iso", "From above at an angle (0)"],
  ["front", "Front", "From the front, along y (1)"],
  ["right", "Right", "From the right, along x (3)"],
  ["top", "Top", "From above, along z (5)"],
];
const kThemes: ThemeChoice[] = ["auto", "light", "dark"];

export function make_toolbar(bar: HTMLElement, commands: Commands): void {
  const button = (test: string, title: string, content: Node | string, act: () => void): HTMLButtonElement =>
    element("button", { type: "button", title, "aria-label": title, "data-testid": test, click: act }, content);
  const theme = button("theme", "", icon("M12 3a9 9 0 1 0 0 18V3z M12 3a9 9 0 0 1 0 18"), () => next_theme(commands));
  commands.store.subscribe((settings) => {
    const title = `Light or dark: ${settings.theme === "auto" ? "as the system" : settings.theme} (T)`;
    theme.title = title;
    theme.setAttribute("aria-label", title);
  });
  bar.append(
    element("div", { class: "bar-group" }, ...kViews.map(([name, text, title]) => button(`view-${name}`, title, text, () => commands.view(name)))),
    element("div", { class: "bar-group" },
      button("fit", "The whole part (F)", icon("M4 9V4h5 M15 4h5v5 M20 15v5h-5 M9 20H4v-5"), () => commands.stage.rig.fit(true)),
      button("link", "Copy a link to this view", icon("M10 14a4 4 0 0 0 6 0l3-3a4 4 0 0 0-6-6l-1 1 M14 10a4 4 0 0 0-6 0l-3 3a4 4 0 0 0 6 6l1-1"), () => void commands.copy_link()),
      button("picture", "Save a picture of this view", icon("M4 8h3l2-3h6l2 3h3v11H4z M12 10a3.5 3.5 0 1 0 0 7a3.5 3.5 0 0 0 0-7"), () => void commands.save_picture()),
      theme,
      button("help-open", "Keys and gestures (?)", "?", () => commands.help()),
    ),
  );
}

export function next_theme(commands: Commands): void {
  const { theme } = commands.store.current;
  commands.store.change({ theme: kThemes[(kThemes.indexOf(theme) + 1) % kThemes.length] });
  commands.announce(`Light or dark: ${commands.store.current.theme}`);
}

function icon(path: string): SVGElement {
  return drawing("svg", { viewBox: "0 0 24 24", class: "icon", "aria-hidden": "true" }, drawing("path", { d: path }));
}
