// SPDX-License-Identifier: Apache-2.0
// Joins the 3D view, the controls and the panels: settings go to all of them, and what the user does comes back as settings.

import type { Theme } from "./math/color_maps.ts";
import { subtract, type Vector } from "./math/frame.ts";
import type { Degree } from "./math/harmonics.ts";
import { faults_of, is_drawn_anyway, of_starting_grid } from "./scene/faults.ts";
import type { Report } from "./scene/report.ts";
import { cell_box, element_center, type Scene } from "./scene/scene.ts";
import { SettingsStore, type CutAxis, type FieldName, type Settings, type UpAxis } from "./settings.ts";
import type { FaultMark } from "./view/line_marks.ts";
import { Stage } from "./view/stage.ts";
import { kViewNames, type ViewName } from "./view/camera_rig.ts";
import { answer_blocks, answer_of, place_of, worst_places } from "./ui/answer.ts";
import { by_id, counted, measured, plural } from "./ui/dom.ts";
import { describe_hexahedron, hexahedra_shown, hexahedra_text, hexahedron_title, show_hexahedron, two_digits, type HexDescription } from "./ui/hex_panel.ts";
import { describe_element, show_cell, show_no_cell, title_of, type CellPanel } from "./ui/cell_panel.ts";
import type { Commands } from "./ui/commands.ts";
import { make_controls } from "./ui/controls.ts";
import { Keyboard } from "./ui/keyboard.ts";
import { key_groups } from "./ui/key_groups.ts";
import { legend_body } from "./ui/legend.ts";
import type { Place } from "./ui/place.ts";
import { place_groups, place_lists } from "./ui/places.ts";
import { make_toolbar } from "./ui/toolbar.ts";
import { PointerClicks } from "./ui/pointer_clicks.ts";
import { picture_of, save_picture } from "./ui/saved_picture.ts";
import { link_from, link_of } from "./view_link.ts";
import { widest_cut } from "./view/widest_cut.ts";
import type { Tabs } from "./ui/tabs.ts";

export class Application implements Commands {
  readonly store = new SettingsStore();
  readonly stage: Stage;
  private readonly follow: (settings: Settings) => void;
  private readonly keyboard: Keyboard;
  private readonly dark = matchMedia("(prefers-color-scheme: dark)");
  private readonly degree: Degree;
  private readonly places: Place[];
  private cell_panel: CellPanel | null = null;
  private shown_cell = -1;
  private shown_hexahedron = -1;
  private visited = -1;
  private note_timer = 0;
  private shown_size = "";

  constructor(readonly scene: Scene, report: Report, private readonly tabs: Tabs, context: WebGL2RenderingContext) {
    const canvas = by_id("view") as HTMLCanvasElement;
    this.degree = report.degree === 3 ? 3 : 4;
    const marks_of = (field: FieldName): FaultMark[] => faults_of(field === "grid" ? of_starting_grid(report) : report)
      .filter((fault) => !is_drawn_anyway(fault)).map(({ place, verdict }) => ({ point: subtract(place, scene.origin), verdict }));
    this.stage = new Stage(scene, marks_of, canvas, context, report.input?.closed ?? report.model?.watertight ?? false, this.store.current);
    const axis = scene.first_cut ?? widest_cut(scene);
    // The half that is taken away is the one towards the first view, which looks from the front, the right and above.
    this.store.change({ cut: { axis, flip: axis === "y" } });
    this.follow = make_controls(by_id("panel-view"), this.store, scene, { cut: (on) => this.cut(on), cut_across: (axis) => this.cut_across(axis), turn_up: (up) => this.turn_up(up) });
    const go = (place: Place): void => this.visit(place);
    const answer = answer_of(report);
    const groups = place_groups(report, scene.origin);
    const worst = worst_places(report, scene, scene.origin);
    this.places = apart([...worst, ...(answer?.reasons ?? []).map((reason) => place_of(reason, scene.origin)), ...groups.flatMap(({ kinds }) => kinds.flatMap(({ places }) => places))]);
    by_id("answer").replaceChildren(...answer_blocks(answer, worst, scene.origin, go));
    by_id("places").replaceChildren(...place_lists(groups, scene.origin, go));
    this.keyboard = new Keyboard(key_groups(this), by_id("help") as HTMLDialogElement);
    make_toolbar(by_id("toolbar"), this);
    new PointerClicks(canvas, (x, y) => this.pick_at(x, y), (x, y) => this.fly_at(x, y));
    this.stage.onmove = () => this.draw_plot();
    this.store.subscribe((settings) => this.apply(settings));
    this.dark.addEventListener("change", () => this.apply(this.store.current));
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
    this.stage.face_cut(false);
    this.restore(location.hash);
    addEventListener("hashchange", () => this.restore(location.hash));
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

  /** Shows what the part of an address behind # asks for. */
  private restore(hash: string): void {
    const { settings, camera } = link_from(hash);
    if (!this.scene.grid) delete settings.field;
    if (Object.keys(settings).length > 0) this.store.change(settings);
    if (camera) this.stage.rig.go_to(camera);
    else if (settings.up || settings.cut) this.stage.face_cut(false);
  }

  get link(): string {
    return location.href.split("#")[0] + link_of(this.store.current, this.stage.rig.place);
  }

  /** Puts a link to this view into the clipboard, and into the address. */
  async copy_link(): Promise<void> {
    const { link } = this;
    history.replaceState(null, "", link);
    try {
      await navigator.clipboard.writeText(link);
      this.say("A link to this view is in the clipboard.");
    } catch {
      this.say("The address of this page now leads to this view.");
    }
  }

  async save_picture(): Promise<void> {
    await save_picture(this.stage);
    this.say("The picture is saved.");
  }

  turn_up(up: UpAxis): void {
    this.store.change({ up });
    this.stage.face_cut(true);
  }

  /** Turns the cut on or off, and the view towards it. */
  cut(on: boolean): void {
    this.store.change({ cut: { on } });
    this.stage.face_cut(true);
  }

  /** Cuts across an axis, or across the view; the half towards the camera is taken away. */
  cut_across(axis: CutAxis): void {
    const { direction } = this.stage.rig;
    const along = axis === "view" ? 1 : direction[["x", "y", "z"].indexOf(axis)];
    this.store.change({ cut: { axis, on: true, flip: along < 0, ...(axis === "view" ? { normal: direction } : {}) } });
    // A cut across the view is looked at already.
    if (axis !== "view") this.stage.face_cut(true);
  }

  view(name: ViewName): void {
    this.stage.rig.view(name, true);
  }

  /** Picks what is under a place of the canvas; nothing there clears the pick. */
  pick_at(x: number, y: number): number {
    const hexahedron = this.stage.pick_hexahedron(x, y);
    if (hexahedron !== null) return this.take_hexahedron(hexahedron);
    const cell = this.stage.pick(x, y);
    this.store.change({ picked: cell, hexahedron: -1 });
    if (cell >= 0) {
      const { class: kind, energy_density } = this.describe(cell);
      this.announce(`${title_of(this.shown, cell)} picked, ${kind ? `${kind}, ` : ""}energy density ${measured(energy_density)}.`);
      this.show_panel_of_picked();
    } else this.announce("Nothing there.");
    return cell;
  }

  private take_hexahedron(hexahedron: number): number {
    this.store.change({ hexahedron, picked: -1 });
    if (hexahedron < 0) {
      this.announce("Nothing there.");
      return -1;
    }
    const described = this.describe_hexahedron(hexahedron);
    this.announce(`${hexahedron_title(described)} picked, scaled Jacobian ${two_digits(described.scaled_jacobian)}.`);
    this.show_panel_of_picked();
    return hexahedron;
  }

  private show_panel_of_picked(): void {
    if (!matchMedia("(max-width: 799px)").matches || this.tabs.is_open()) this.tabs.select("cell");
  }

  private describe_hexahedron(hexahedron: number): HexDescription {
    return describe_hexahedron(this.shown, this.stage.field.hexahedra!, hexahedron);
  }

  /** The scene of the field that is shown. */
  private get shown(): Scene {
    return this.stage.field.scene;
  }

  private describe(element: number): ReturnType<typeof describe_element> {
    return describe_element(this.shown, element, this.degree);
  }

  pick_middle(): void {
    // The point that the camera turns around, which controls at the side may have moved from the middle of the canvas.
    const [x, y] = this.stage.on_screen(this.stage.rig.controls.target.toArray());
    this.pick_at(x, y);
  }

  fly_at(x: number, y: number): void {
    const hexahedron = this.stage.pick_hexahedron(x, y);
    if (hexahedron !== null && hexahedron >= 0) return this.stage.rig.approach(this.stage.field.hexahedra!.center(hexahedron), true);
    if (hexahedron !== null) return;
    const cell = this.stage.pick(x, y);
    if (cell >= 0) this.stage.rig.approach(element_center(this.shown, cell), true);
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
    this.store.change({ picked: -1, hexahedron: -1, marked: null });
  }

  /** Says something on the screen for a while, and to who hears the page. */
  private say(text: string): void {
    this.announce(text);
    const note = by_id("note");
    note.textContent = text;
    note.hidden = false;
    clearTimeout(this.note_timer);
    this.note_timer = window.setTimeout(() => (note.hidden = true), 4000);
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
    const covered = { left, top, bottom: left > 0 ? 108 : 52 };
    // The observer calls at first too, and where nothing is any different.
    const size = JSON.stringify([clientWidth, clientHeight, covered, devicePixelRatio]);
    if (size === this.shown_size) return;
    this.shown_size = size;
    this.stage.resize(clientWidth, clientHeight, covered);
  }

  private apply(settings: Settings): void {
    const { theme } = settings;
    if (theme === "auto") delete document.documentElement.dataset.theme;
    else document.documentElement.dataset.theme = theme;
    this.stage.apply(settings, this.theme);
    this.follow(settings);
    by_id("legend-body").replaceChildren(...legend_body(settings, this.theme, this.stage.field));
    by_id("shown").textContent = this.what_is_shown();
    this.show_picked(settings);
  }

  private show_picked({ picked: cell, hexahedron }: Settings): void {
    const hexahedra = this.stage.field.hexahedra;
    if (hexahedra && hexahedron >= 0) {
      if (hexahedron === this.shown_hexahedron) return;
      this.shown_hexahedron = hexahedron;
      this.shown_cell = -2;
      this.cell_panel = null;
      const described = this.describe_hexahedron(hexahedron);
      this.tabs.rename("cell", hexahedron_title(described));
      return show_hexahedron(by_id("panel-cell"), described, this.scene.unit, {
        go: () => this.stage.rig.approach(hexahedra.center(hexahedron), true),
        close: () => this.clear(),
      });
    }
    this.shown_hexahedron = -1;
    if (cell !== this.shown_cell) {
      this.shown_cell = cell;
      this.tabs.rename("cell", cell < 0 ? (this.scene.tets ? "Tet" : "Cell") : title_of(this.shown, cell));
      if (cell < 0) {
        this.cell_panel = null;
        show_no_cell(by_id("panel-cell"));
      } else {
        this.cell_panel = show_cell(by_id("panel-cell"), this.describe(cell), this.scene.unit, {
          go: () => this.stage.rig.approach(element_center(this.shown, cell), true),
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

  private what_is_shown(): string {
    const { cells, surface, unit, tets, tet_counts } = this.shown;
    const parts: string[] = [];
    const { hexahedra } = this.stage.field;
    if (hexahedra && this.store.current.layers.hexahedra) return [`${hexahedra_text(hexahedra.count)} shown.`, hexahedra_shown(this.shown)].filter(Boolean).join(" ");
    if (tets) parts.push(`The field on ${plural(tets.corners.length / 4, "tet")}.`);
    else if (tet_counts) parts.push(`The field on ${plural(tet_counts.total, "tet")}; the cut shows the frames of those at the centres of ${plural(cells.shown, "cell")}.`);
    else if (this.scene.tets) parts.push(`The grid of ${plural(cells.total, "cell")} from which the field on the tets started; the answer is about the tets.`);
    if (!tets && !tet_counts && cells.merged_to !== null) {
      parts.push(`Cells smaller than ${measured(cells.merged_to)}${unit ? ` ${unit}` : ""} are shown merged: ${counted(cells.shown)} of ${plural(cells.total, "cell")}.`);
    }
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
        glyphs: this.stage.field.glyphs.count,
        frames_drawn: this.stage.frames_drawn,
        elements: this.stage.elements,
        hexahedra: this.stage.field.hexahedra?.count ?? null,
      }),
      setView: async (name: ViewName) => {
        if (!kViewNames.includes(name)) throw new Error(`no view ${name}: ${kViewNames.join(", ")}`);
        this.stage.rig.view(name, false);
        await this.stage.drawn();
      },
      pickAt: (x: number, y: number) => {
        const cell = this.pick_at(x, y);
        if (cell < 0) return null;
        return this.store.current.hexahedron >= 0 ? this.describe_hexahedron(cell) : this.describe(cell);
      },
      describe: (element: number) => this.describe(element),
      link: () => this.link,
      cutAcross: async (axis: CutAxis) => {
        this.cut_across(axis);
        await this.stage.drawn();
      },
      picture: async () => (await picture_of(this.stage)).toDataURL("image/png"),
      change: async (part: Parameters<SettingsStore["change"]>[0]) => {
        this.store.change(part);
        await this.stage.drawn();
      },
      screenOf: (point: Vector) => this.stage.on_screen(subtract(point, this.scene.origin)),
      cellBox: (cell: number) => cell_box(this.shown, cell),
      drawn: () => this.stage.drawn(),
    });
  }
}

const is_same = (a: Vector | null, b: Vector | null): boolean => a !== null && b !== null && a.every((value, k) => value === b[k]);

/** Those that have a point, each point once. */
const apart = (places: Place[]): Place[] => places.filter(({ point }, k) => point && places.findIndex((other) => is_same(other.point, point)) === k);
