// SPDX-License-Identifier: Apache-2.0
// Joins the 3D view, the controls and the panels: settings go to all of them, and what the user does comes back as settings.

import type { Theme } from "./math/color_maps.ts";
import { subtract, type Vector } from "./math/frame.ts";
import { share_below } from "./scene/hexahedra.ts";
import { faces_of_model, facing_of, point_of, triangles_of_face, type ModelFace } from "./scene/faces.ts";
import { faults_of, is_drawn_anyway, of_starting_grid } from "./scene/faults.ts";
import { has_field, is_of_lattice, type Report } from "./scene/report.ts";
import { cell_box, element_center, type Scene } from "./scene/scene.ts";
import { cut_normal, cut_offset, SettingsStore, type CutAxis, type FieldName, type Settings, type UpAxis } from "./settings.ts";
import type { FaultMark } from "./view/line_marks.ts";
import { Stage } from "./view/stage.ts";
import { kViewNames, type ViewName } from "./view/camera_rig.ts";
import { places_of_answer } from "./ui/answer.ts";
import { by_id, counted, measured, plural } from "./ui/dom.ts";
import { hexahedra_shown, hexahedron_title, shape_text } from "./ui/hex_panel.ts";
import { title_of } from "./ui/cell_panel.ts";
import type { Commands } from "./ui/commands.ts";
import { make_controls } from "./ui/controls.ts";
import { face_title } from "./ui/face_table.ts";
import { free_area, type FreeArea } from "./ui/free_area.ts";
import { Keyboard } from "./ui/keyboard.ts";
import { key_groups } from "./ui/key_groups.ts";
import { legend_body } from "./ui/legend.ts";
import { mesh_places } from "./ui/mesh_summary.ts";
import { PickedPanel } from "./ui/picked_panel.ts";
import type { Place } from "./ui/place.ts";
import { input_groups } from "./ui/places.ts";
import { report_blocks } from "./ui/report_panel.ts";
import { make_toolbar } from "./ui/toolbar.ts";
import { PointerClicks } from "./ui/pointer_clicks.ts";
import { picture_of, save_picture } from "./ui/saved_picture.ts";
import { Tag } from "./ui/tag.ts";
import { link_from, link_of } from "./view_link.ts";
import { widest_cut } from "./view/widest_cut.ts";
import type { Tabs } from "./ui/tabs.ts";

// What lies over the view.
const kOver = ["panel-view", "toolbar", "shown", "legend"];
// Height in pixels of the button that opens the legend on a phone, with what is around it.
const kLegendButton = 56;
// A cut that leaves less than this share of the hexahedra is not there at first; how far a plane through a layer takes it, as a share of the part.
const kLeastShown = 0.25;
const kIntoLayer = 1e-5;

const is_narrow = (): boolean => matchMedia("(max-width: 799px)").matches;

export class Application implements Commands {
  readonly store = new SettingsStore();
  readonly stage: Stage;
  readonly follows_field: boolean;
  private readonly follow: (settings: Settings) => void;
  private readonly keyboard: Keyboard;
  private readonly dark = matchMedia("(prefers-color-scheme: dark)");
  private readonly places: Place[];
  private readonly faces: ModelFace[];
  private readonly picked: PickedPanel;
  private readonly tag: Tag;
  private free: FreeArea = { left: 0, right: 1, top: 0, bottom: 1 };
  private visited = -1;
  private note_timer = 0;
  private shown_size = "";

  constructor(readonly scene: Scene, report: Report, private readonly tabs: Tabs, context: WebGL2RenderingContext) {
    const canvas = by_id("view") as HTMLCanvasElement;
    const marks_of = (field: FieldName): FaultMark[] => faults_of(field === "grid" ? of_starting_grid(report) : report)
      .filter((fault) => !is_drawn_anyway(fault)).map(({ place, verdict }) => ({ point: subtract(place, scene.origin), verdict }));
    // Without a field nothing was found in the input.
    const closed = (has_field(report) ? report.input?.closed : undefined) ?? report.model?.watertight ?? false;
    this.stage = new Stage(scene, marks_of, canvas, context, closed, this.store.current);
    this.follows_field = scene.has_field && !is_of_lattice(report);
    const axis = scene.first_cut ?? widest_cut(scene);
    // The half that is taken away is the one towards the first view, which looks from the front, the right and above.
    this.store.change({ cut: { axis, flip: axis === "y" } });
    this.store.change({ cut: { on: !this.cut_takes_most() } });
    this.follow = make_controls(by_id("panel-view"), this.store, scene, this.follows_field, { cut: (on) => this.cut(on), cut_across: (axis) => this.cut_across(axis), turn_up: (up) => this.turn_up(up) });
    this.faces = faces_of_model(report, scene);
    this.places = apart([...mesh_places(report, scene, scene.origin), ...(is_of_lattice(report) ? [] : places_of_answer(report, scene.origin)), ...input_groups(report, scene.origin).flatMap(({ kinds }) => kinds.flatMap(({ places }) => places))]);
    by_id("panel-field").replaceChildren(...report_blocks(report, this.faces, { scene, go: (place) => this.visit(place), show_face: (face) => this.show_face(face) }));
    this.picked = new PickedPanel(report, this.faces, this.stage, tabs, {
      show_hexahedron: (hexahedron) => this.show_alone(hexahedron), show_face: (face) => this.show_face(face), clear: () => this.clear(),
    });
    this.tag = new Tag(() => this.clear());
    this.keyboard = new Keyboard(key_groups(this), by_id("help") as HTMLDialogElement);
    make_toolbar(by_id("toolbar"), this);
    new PointerClicks(canvas, (x, y) => this.pick_at(x, y), (x, y) => this.fly_at(x, y));
    this.stage.onmove = () => this.moved();
    this.store.subscribe((settings) => this.apply(settings));
    this.dark.addEventListener("change", () => this.apply(this.store.current));
    canvas.setAttribute("aria-label", `${by_id("part-name").textContent} ${scene.hexahedra ? "in hexahedra, cut" : "with its singular lines and the frames on a cut"}`);
    // A phone has no room for the legend until it is asked for.
    if (is_narrow()) by_id("legend").removeAttribute("open");
    this.expose();
  }

  async started(): Promise<void> {
    this.apply(this.store.current);
    const observer = new ResizeObserver(() => this.resize());
    for (const part of ["stage", ...kOver]) observer.observe(by_id(part));
    this.resize();
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
    // The legend that it brings leaves less or more free: the camera is of a view that knew.
    this.resize();
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

  /** Whether the cut leaves few hexahedra, or none of the only layer of a plate. */
  private cut_takes_most(): boolean {
    const { hexahedra, low, high } = this.scene;
    if (!hexahedra) return false;
    const thickness = Math.hypot(...high.map((value, k) => value - low[k]));
    const plane = { normal: cut_normal(this.store.current), offset: cut_offset(this.store.current, low, high) - kIntoLayer * thickness };
    return share_below(hexahedra, plane) < kLeastShown;
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
    const { element, face } = this.stage.pick(x, y);
    const { hexahedron: before, alone } = this.store.current;
    const solid = this.stage.shows_hexahedra;
    // A click on the one that is shown alone keeps it so; beside it all are shown again.
    const stays = solid && alone && element === before;
    this.store.change({ picked: solid ? -1 : element, hexahedron: solid ? element : -1, face, alone: stays, ...(alone && !stays ? { marked: null } : {}) });
    if (element < 0 && !face) this.announce("Nothing there.");
    else {
      this.announce(`${[...(element < 0 ? [] : [this.words_of(element)]), ...(face ? [face_title(this.picked.face(face.number))] : [])].join(", on ")}.`);
      if (!is_narrow() || this.tabs.is_open()) this.tabs.select("cell");
    }
    return element;
  }

  private words_of(element: number): string {
    if (this.stage.shows_hexahedra) {
      const described = this.picked.describe_hexahedron(element);
      return `${hexahedron_title(described)} picked, scaled Jacobian ${shape_text(described.scaled_jacobian, described.inverted)}`;
    }
    const { class: kind, energy_density } = this.picked.describe(element);
    return `${title_of(this.shown, element)} picked, ${kind ? `${kind}, ` : ""}energy density ${measured(energy_density)}`;
  }

  /** The scene of the field that is shown. */
  private get shown(): Scene {
    return this.stage.field.scene;
  }

  pick_middle(): void {
    // The point that the camera turns around, which controls at the side may have moved from the middle of the canvas.
    const [x, y] = this.stage.on_screen(this.stage.rig.controls.target.toArray());
    this.pick_at(x, y);
  }

  fly_at(x: number, y: number): void {
    const { element } = this.stage.pick(x, y);
    if (element < 0) return;
    this.stage.rig.approach(this.stage.shows_hexahedra ? this.stage.field.hexahedra!.center(element) : element_center(this.shown, element), true);
  }

  /** Shows one hexahedron with those around it faintly. */
  private show_alone(hexahedron: number): void {
    this.store.change({ layers: { hexahedra: true }, field: "main", hexahedron, picked: -1, face: null, alone: true });
    const { hexahedra } = this.stage.field;
    this.stage.rig.approach(hexahedra!.center(hexahedron), true, hexahedra!.radius(hexahedron));
  }

  /** Shows a face of the model from outside. */
  private show_face(number: number): void {
    const corners = triangles_of_face(this.scene, number);
    const known = this.picked.face(number).center;
    const point = corners.length > 0 ? point_of(corners) : known;
    if (!point) return this.announce(`The view does not show face ${number}.`);
    // It may lie in the half that a cut takes away.
    this.store.change({ face: { number, point }, picked: -1, hexahedron: -1, marked: null, cut: { on: false } });
    const facing = facing_of(corners);
    if (facing) this.stage.rig.face(facing, true);
    else this.stage.rig.fit(true);
    this.announce(face_title(this.picked.face(number)));
    if (is_narrow()) this.tabs.open(false);
  }

  visit(place: Place): void {
    if (!place.point) return;
    this.visited = this.places.findIndex(({ point }) => is_same(point, place.point));
    this.store.change({ marked: { point: place.point, label: place.label, warn: place.warn }, alone: false });
    if (place.hexahedron !== undefined) this.show_alone(place.hexahedron);
    else this.approach(place);
    this.announce(`${place.label}${place.detail ? `: ${place.detail}` : ""}`);
    if (is_narrow()) this.tabs.open(false);
  }

  /** To a place; where what is shown lacks or hides it, the cut moves there first. */
  private approach({ point, of_mesh }: Place): void {
    if (of_mesh) this.store.change({ layers: { hexahedra: true }, field: "main" });
    if (this.stage.hides(point!)) {
      this.store.change({ cut: this.stage.cut_to(point!), below: 1 });
      this.stage.rig.face(cut_normal(this.store.current), false);
    }
    this.stage.rig.approach(point!, true);
  }

  visit_next(step: number): void {
    if (this.places.length === 0) return this.announce("There are no places to visit.");
    const next = this.visited < 0 && step < 0 ? this.places.length - 1 : (this.visited + step + this.places.length) % this.places.length;
    this.visit(this.places[next]);
  }

  clear(): void {
    this.store.change({ picked: -1, hexahedron: -1, face: null, alone: false, marked: null });
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
    this.picked.draw_plot(this.theme);
  }

  private moved(): void {
    this.picked.draw_plot(this.theme);
    this.place_tag(this.store.current);
  }

  /** Centres the part in what controls and legends leave free. */
  private resize(): void {
    const { clientWidth, clientHeight } = by_id("stage");
    if (clientWidth <= 0 || clientHeight <= 0) return;
    // A legend that is opened on a phone lies over the part for as long as it is open: what counts is its button.
    const is_over = is_narrow() && by_id("legend").hasAttribute("open");
    this.free = free_area(by_id("stage"), kOver.filter((part) => !is_over || part !== "legend").map(by_id));
    if (is_over) this.free.bottom = Math.min(this.free.bottom, clientHeight - kLegendButton);
    // The observer calls at first too, and where nothing is any different.
    const size = JSON.stringify([clientWidth, clientHeight, this.free, devicePixelRatio]);
    if (size === this.shown_size) return;
    this.shown_size = size;
    const { left, right, top, bottom } = this.free;
    by_id("note").style.left = `${(left + right) / 2}px`;
    this.stage.resize(clientWidth, clientHeight, { left, right: clientWidth - right, top, bottom: clientHeight - bottom });
    this.place_tag(this.store.current);
  }

  private apply(settings: Settings): void {
    const { theme } = settings;
    if (theme === "auto") delete document.documentElement.dataset.theme;
    else document.documentElement.dataset.theme = theme;
    this.stage.apply(settings, this.theme);
    this.follow(settings);
    by_id("legend-body").replaceChildren(...legend_body(settings, this.theme, this.stage.field));
    by_id("shown").textContent = this.what_is_shown();
    this.picked.show(settings, this.theme);
    this.place_tag(settings);
  }

  /** Names what is looked at, beside it. */
  private place_tag(settings: Settings): void {
    const { hexahedron, alone, face, marked } = settings;
    const solid = this.stage.shows_hexahedra;
    let [text, point, around]: [string, Vector | null, number] = ["", null, 0];
    if (alone && solid && hexahedron >= 0) {
      const described = this.picked.describe_hexahedron(hexahedron);
      const { hexahedra } = this.stage.field;
      [text, point, around] = [`${hexahedron_title(described)}: scaled Jacobian ${shape_text(described.scaled_jacobian, described.inverted)}`, hexahedra!.center(hexahedron), hexahedra!.radius(hexahedron) / this.stage.pixel];
    } else if (face) [text, point] = [face_title(this.picked.face(face.number)), face.point];
    else if (marked) [text, point] = [marked.label, marked.point];
    this.tag.show(text, point && this.stage.in_view(point), around, this.free);
  }

  private what_is_shown(): string {
    const { cells, surface, unit, tets, tet_counts } = this.shown;
    const parts: string[] = [];
    const { hexahedra } = this.stage.field;
    const { layers, alone, hexahedron } = this.store.current;
    if (hexahedra && layers.hexahedra && alone && hexahedron >= 0) return "One hexahedron, with those around it faintly.";
    if (hexahedra && layers.hexahedra) return hexahedra_shown(this.shown.hexahedra!, hexahedra.count);
    if (!this.scene.has_field) parts.push("The surface of the model.");
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
        const element = this.pick_at(x, y);
        if (element < 0) return null;
        return this.stage.shows_hexahedra ? this.picked.describe_hexahedron(element) : this.picked.describe(element);
      },
      describe: (element: number) => this.picked.describe(element),
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
      free: () => this.free,
      drawn: () => this.stage.drawn(),
    });
  }
}

const is_same = (a: Vector | null, b: Vector | null): boolean => a !== null && b !== null && a.every((value, k) => value === b[k]);

/** Those that have a point, each point once. */
const apart = (places: Place[]): Place[] => places.filter(({ point }, k) => point && places.findIndex((other) => is_same(other.point, point)) === k);
