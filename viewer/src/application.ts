// SPDX-License-Identifier: Apache-2.0
// Joins the 3D view, the controls and the panels: settings go to all of them, and what the user does comes back as settings.

import type { Theme } from "./math/color_maps.ts";
import { subtract, type Vector } from "./math/frame.ts";
import type { Degree } from "./math/harmonics.ts";
import { faults_of, is_drawn_anyway } from "./scene/faults.ts";
import type { Report } from "./scene/report.ts";
import { cell_count, cell_box, cell_center, type Scene } from "./scene/scene.ts";
import { SettingsStore, type CutAxis, type Settings } from "./settings.ts";
import { Stage } from "./view/stage.ts";
import { kViewNames, type ViewName } from "./view/camera_rig.ts";
import { answer_blocks, answer_of, place_of } from "./ui/answer.ts";
import { by_id, counted, measured } from "./ui/dom.ts";
import { describe_cell, show_cell, show_no_cell, type CellPanel } from "./ui/cell_panel.ts";
import { make_controls } from "./ui/controls.ts";
import { Keyboard } from "./ui/keyboard.ts";
import { key_groups } from "./ui/key_groups.ts";
import { legend_body } from "./ui/legend.ts";
import { place_groups, place_lists, type Place } from "./ui/places.ts";
import { make_toolbar } from "./ui/toolbar.ts";
import { PointerClicks } from "./ui/pointer_clicks.ts";
import { widest_cut } from "./view/widest_cut.ts";
import type { Tabs } from "./ui/tabs.ts";

export class Application {
  readonly store = new SettingsStore();
  readonly stage: Stage;
  private readonly follow: (settings: Settings) => void;
  private readonly keyboard: Keyboard;
  private readonly dark = matchMedia("(prefers-color-scheme: dark)");
  private readonly degree: Degree;
  private readonly places: Place[];
  private cell_panel: CellPanel | null = null;
  private shown_cell = -1;
  private visited = -1;

  constructor(readonly scene: Scene, report: Report, private readonly tabs: Tabs, context: WebGL2RenderingContext) {
    const canvas = by_id("view") as HTMLCanvasElement;
    this.degree = report.degree === 3 ? 3 : 4;
    const balls = faults_of(report).filter((fault) => !is_drawn_anyway(fault, report)).map(({ place, verdict }) => ({ point: subtract(place, scene.origin), verdict }));
    this.stage = new Stage(scene, balls, canvas, context, report.input?.closed ?? report.model?.watertight ?? false, this.store.current);
    const axis = widest_cut(scene);
    // The half that is taken away is the one towards the first view, which looks from the front, the right and above.
    this.store.change({ cut: { axis, flip: axis === "y" } });
    this.follow = make_controls(by_id("panel-view"), this.store, scene, { cut_across: (axis) => this.cut_across(axis) });
    const go = (place: Place): void => this.visit(place);
    const answer = answer_of(report);
    const groups = place_groups(report, scene.origin);
    this.places = apart([...(answer?.reasons ?? []).map((reason) => place_of(reason, scene.origin)), ...groups.flatMap((group) => group.places)]);
    by_id("answer").replaceChildren(...answer_blocks(answer, scene.origin, go));
    by_id("places").replaceChildren(...place_lists(groups, scene.origin, go));
    this.keyboard = new Keyboard(key_groups(this), by_id("help") as HTMLDialogElement);
    make_toolbar(by_id("toolbar"), this);
    new PointerClicks(canvas, (x, y) => this.pick_at(x, y), (x, y) => this.fly_at(x, y));
    this.stage.onmove = () => this.draw_plot();
    this.store.subscribe((settings) => this.apply(settings));
    this.dark.addEventListener("change", () => this.apply(this.store.current));
    by_id("shown").textContent = this.what_is_shown(report);
    canvas.setAttribute("aria-label", `${by_id("part-name").textContent} with its singular lines and the frames on a cut`);
    // A phone has no room for the legend until it is asked for.
    if (matchMedia("(max-width: 799px)").matches) by_id("legend").removeAttribute("open");
    this.expose();
  }

  async started(): Promise<void> {
    const observer = new ResizeObserver(() => this.resize());
    observer.observe(by_id("stage"));
    this.resize();
    this.apply(this.store.current);
    this.stage.rig.view("iso", false);
    await this.stage.drawn();
    by_id("message").hidden = true;
    document.body.classList.add("has-view");
  }

  get theme(): Theme {
    const { theme } = this.store.current;
    return theme === "auto" ? (this.dark.matches ? "dark" : "light") : theme;
  }

  help(): void {
    this.keyboard.help();
  }

  /** Cuts across an axis, or across the view; the half towards the camera is taken away. */
  cut_across(axis: CutAxis): void {
    const { direction } = this.stage.rig;
    const along = axis === "view" ? 1 : direction[["x", "y", "z"].indexOf(axis)];
    this.store.change({ cut: { axis, on: true, flip: along < 0, ...(axis === "view" ? { normal: direction } : {}) } });
  }

  view(name: ViewName): void {
    this.stage.rig.view(name, true);
  }

  /** Picks what is under a place of the canvas; nothing there clears the pick. */
  pick_at(x: number, y: number): number {
    const cell = this.stage.pick(x, y);
    this.store.change({ picked: cell });
    if (cell >= 0) {
      const { class: kind, energy_density } = describe_cell(this.scene, cell, this.degree);
      this.announce(`Cell ${counted(cell)} picked, ${kind}, energy density ${measured(energy_density)}.`);
      if (!matchMedia("(max-width: 799px)").matches || this.tabs.is_open()) this.tabs.select("cell");
    } else this.announce("Nothing there.");
    return cell;
  }

  pick_middle(): void {
    // The point that the camera turns around, which controls at the side may have moved from the middle of the canvas.
    const [x, y] = this.stage.on_screen(this.stage.rig.controls.target.toArray());
    this.pick_at(x, y);
  }

  fly_at(x: number, y: number): void {
    const cell = this.stage.pick(x, y);
    if (cell >= 0) this.stage.rig.approach(cell_center(this.scene, cell), true);
  }

  visit(place: Place): void {
    if (!place.point) return;
    this.visited = this.places.findIndex(({ point }) => is_same(point, place.point));
    this.store.change({ marked: { point: place.point, label: place.label, warn: place.warn } });
    this.stage.rig.approach(place.point, true);
    this.announce(`${place.label}: ${place.detail}`);
    if (matchMedia("(max-width: 799px)").matches) this.tabs.open(false);
  }

  visit_next(step: number): void {
    if (this.places.length === 0) return this.announce("There are no places to visit.");
    const next = this.visited < 0 && step < 0 ? this.places.length - 1 : (this.visited + step + this.places.length) % this.places.length;
    this.visit(this.places[next]);
  }

  clear(): void {
    this.store.change({ picked: -1, marked: null });
  }

  announce(text: string): void {
    by_id("announcement").textContent = text;
  }

  panels_changed(): void {
    this.draw_plot();
  }

  private resize(): void {
    const { clientWidth, clientHeight } = by_id("stage");
    if (clientWidth <= 0 || clientHeight <= 0) return;
    // The part is centred in what the controls leave free.
    const controls = by_id("panel-view");
    const left = getComputedStyle(controls).position === "fixed" ? controls.getBoundingClientRect().right : 0;
    const top = by_id("toolbar").getBoundingClientRect().bottom;
    // As high as the tallest legend, so that choosing another map does not move the part.
    this.stage.resize(clientWidth, clientHeight, { left, top, bottom: left > 0 ? 108 : 52 });
  }

  private apply(settings: Settings): void {
    const { theme } = settings;
    if (theme === "auto") delete document.documentElement.dataset.theme;
    else document.documentElement.dataset.theme = theme;
    this.stage.apply(settings, this.theme);
    this.follow(settings);
    by_id("legend-body").replaceChildren(...legend_body(settings, this.theme, this.scene, this.stage));
    this.show_picked(settings.picked);
  }

  private show_picked(cell: number): void {
    if (cell !== this.shown_cell) {
      this.shown_cell = cell;
      this.tabs.rename("cell", cell < 0 ? "Cell" : `Cell ${counted(cell)}`);
      if (cell < 0) {
        this.cell_panel = null;
        show_no_cell(by_id("panel-cell"));
      } else {
        this.cell_panel = show_cell(by_id("panel-cell"), describe_cell(this.scene, cell, this.degree), this.scene.unit, {
          go: () => this.stage.rig.approach(cell_center(this.scene, cell), true),
          close: () => this.clear(),
        });
      }
    }
    this.draw_plot();
  }

  private draw_plot(): void {
    if (!this.cell_panel || by_id("panel-cell").hidden) return;
    const { camera } = this.stage.rig;
    camera.updateMatrixWorld();
    const e = camera.matrixWorld.elements;
    const column = (k: number): Vector => [e[4 * k], e[4 * k + 1], e[4 * k + 2]];
    this.cell_panel.plot.draw(this.cell_panel.canvas, column(0), column(1), column(2), this.theme);
  }

  private what_is_shown(report: Report): string {
    const { cells, surface, unit } = this.scene;
    const parts: string[] = [];
    if (report.onto) parts.push("The view shows the field on the grid; the answer is about the field on the tets.");
    if (cells.merged_to !== null) {
      parts.push(`Cells smaller than ${measured(cells.merged_to)}${unit ? ` ${unit}` : ""} are shown merged: ${counted(cells.shown)} of ${counted(cells.total)} cells.`);
    } else if (cells.shown < cells.total) parts.push(`${counted(cells.shown)} of ${counted(cells.total)} cells are shown.`);
    if (surface.triangles_shown < surface.triangles_total) parts.push(`The surface is shown with ${counted(surface.triangles_shown)} of ${counted(surface.triangles_total)} triangles.`);
    return parts.join(" ");
  }

  /** What tests and scripts may rely on. */
  private expose(): void {
    const page = window as unknown as { crossgrain?: object };
    page.crossgrain = Object.assign(page.crossgrain ?? {}, {
      state: () => ({
        ...structuredClone(this.store.current),
        resolved_theme: this.theme,
        camera: { position: this.stage.rig.camera.position.toArray(), target: this.stage.rig.controls.target.toArray() },
        glyphs: this.stage.glyphs.count,
        frames_drawn: this.stage.frames_drawn,
        cells: cell_count(this.scene),
      }),
      setView: async (name: ViewName) => {
        if (!kViewNames.includes(name)) throw new Error(`no view ${name}: ${kViewNames.join(", ")}`);
        this.stage.rig.view(name, false);
        await this.stage.drawn();
      },
      pickAt: (x: number, y: number) => {
        const cell = this.pick_at(x, y);
        return cell < 0 ? null : describe_cell(this.scene, cell, this.degree);
      },
      describe: (cell: number) => describe_cell(this.scene, cell, this.degree),
      change: async (part: Parameters<SettingsStore["change"]>[0]) => {
        this.store.change(part);
        await this.stage.drawn();
      },
      screenOf: (point: Vector) => this.stage.on_screen(subtract(point, this.scene.origin)),
      cellBox: (cell: number) => cell_box(this.scene, cell),
      drawn: () => this.stage.drawn(),
    });
  }
}

const is_same = (a: Vector | null, b: Vector | null): boolean => a !== null && b !== null && a.every((value, k) => value === b[k]);

/** Those that have a point, each point once. */
const apart = (places: Place[]): Place[] => places.filter(({ point }, k) => point && places.findIndex((other) => is_same(other.point, point)) === k);
