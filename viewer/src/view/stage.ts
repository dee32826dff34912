// SPDX-License-Identifier: Apache-2.0
// The 3D view: everything that is drawn, kept in step with the settings, and drawn only when something has changed.

import { Box3, Color, Scene as ThreeScene, Vector3, WebGLRenderer } from "three";

import type { Theme } from "../math/color_maps.ts";
import { dot, type Vector } from "../math/frame.ts";
import { element_count, type Scene } from "../scene/scene.ts";
import { surface_normal } from "../scene/surface_normal.ts";
import { cut_normal, type FieldName, type Settings } from "../settings.ts";
import { CameraRig, type Covered } from "./camera_rig.ts";
import { kRest } from "./curve_view.ts";
import { FieldView } from "./field_view.ts";
import { Marks } from "./marks.ts";
import type { FaultMark } from "./line_marks.ts";
import type { Hit } from "./picking.ts";
import { StreamlineView } from "./streamlines.ts";
import { kViewColors } from "./view_colors.ts";

// Frames on the cut are this many pixels apart, so that each can be read, and curves so many.
const kGlyphPixels = 30;
const kCurvePixels = 24;

export class Stage {
  readonly rig: CameraRig;
  frames_drawn = 0;
  private readonly renderer: WebGLRenderer;
  private readonly three = new ThreeScene();
  private readonly fields = new Map<FieldName, FieldView>();
  private readonly streams: StreamlineView;
  private readonly marks: Marks;
  private settings: Settings;
  private theme: Theme = "light";
  private height = 1;
  private pending = 0;
  private at_rest = 0;
  private after_drawing: (() => void)[] = [];
  onmove: () => void = () => {};

  constructor(
    private readonly scene: Scene, private readonly faults_of: (field: FieldName) => FaultMark[], readonly canvas: HTMLCanvasElement,
    context: WebGL2RenderingContext, private readonly closed: boolean, settings: Settings,
  ) {
    this.settings = settings;
    this.renderer = new WebGLRenderer({ canvas, context });
    // Asking whether a shader compiled waits until it has: half a second that is better spent on the rest.
    this.renderer.debug.checkShaderErrors = false;
    this.renderer.localClippingEnabled = true;
    this.rig = new CameraRig(new Box3(new Vector3(...scene.low), new Vector3(...scene.high)), scene.surface_vertices, canvas, () => {
      this.draw_soon();
      this.onmove();
    });
    this.marks = new Marks(this.field.uniforms);
    this.streams = new StreamlineView(scene);
    this.three.add(this.streams.group, this.marks.group);
  }

  /** The field that is shown; made when it is first asked for. */
  get field(): FieldView {
    const name = this.scene.grid ? this.settings.field : "main";
    let view = this.fields.get(name);
    if (!view) {
      view = new FieldView(name === "grid" ? this.scene.grid! : this.scene, this.faults_of(name), this.closed);
      view.resize(this.height, this.renderer.getPixelRatio());
      this.fields.set(name, view);
      this.three.add(view.group);
    }
    return view;
  }

  resize(width: number, height: number, covered: Covered): void {
    this.height = height;
    // Beyond two device pixels a CSS pixel nothing is gained but work.
    this.set_size(width, height, Math.min(2, devicePixelRatio || 1));
    this.rig.resize(width, height, covered);
    this.draw_soon();
  }

  private set_size(width: number, height: number, pixel_ratio: number): void {
    this.renderer.setPixelRatio(pixel_ratio);
    this.renderer.setSize(width, height, false);
    for (const view of this.fields.values()) view.resize(height, pixel_ratio);
  }

  apply(settings: Settings, theme: Theme): void {
    const other = settings.field !== this.settings.field;
    const recolored = theme !== this.theme || settings.map !== this.settings.map || other || this.frames_drawn === 0;
    const turned = settings.up !== this.settings.up;
    this.settings = settings;
    this.theme = theme;
    const { field } = this;
    for (const view of this.fields.values()) view.group.visible = view === field;
    if (recolored) {
      this.renderer.setClearColor(new Color(kViewColors[theme].background));
      field.recolor(settings, theme);
      this.marks.recolor(kViewColors[theme]);
    }
    field.apply(settings);
    const { layers, cut } = settings;
    this.streams.show(layers.streamlines && !field.shows_hexahedra(settings), settings.streams, theme);
    this.streams.cut(field.cut.normal, field.cut.offset, cut.on && cut.clip);
    this.marks.update(field.scene, settings);
    if (turned) this.rig.set_up(settings.up);
    this.draw_soon();
  }

  get cut_offset(): number {
    return this.field.offset_of(this.settings);
  }

  /** Looks at the cut from a little beside its normal, or at the whole part without one. */
  face_cut(animated: boolean): void {
    if (!this.settings.cut.on) return this.rig.view("iso", animated);
    this.rig.face(cut_normal(this.settings), animated);
  }

  /** Whether hexahedra hide a place from where the camera looks, or the cut has taken away those that are there. */
  hides(point: Vector): boolean {
    if (!this.shows_hexahedra) return false;
    const { cut: { normal, offset }, hexahedra } = this.field;
    const { on, clip } = this.settings.cut;
    return (on && clip && dot(normal, point) > offset) || hexahedra!.hides(point, this.rig.direction);
  }

  /** The cut that takes away what is in front of a place on the surface, as seen against its normal, and nothing behind it. */
  cut_to(point: Vector): Partial<Settings["cut"]> {
    const { low, high } = this.scene;
    const normal = surface_normal(this.scene, point);
    const axis = normal.reduce((best, value, k) => (Math.abs(value) > Math.abs(normal[best]) ? k : best), 0);
    const position = Math.min(1, Math.max(0, (point[axis] - low[axis]) / Math.max(high[axis] - low[axis], 1e-30)));
    return { on: true, clip: true, axis: (["x", "y", "z"] as const)[axis], flip: normal[axis] < 0, position };
  }

  /** Size of a pixel where the camera looks, in model units. */
  get pixel(): number {
    const { camera, controls } = this.rig;
    return (2 * camera.position.distanceTo(controls.target) * Math.tan((camera.fov * Math.PI) / 360)) / this.height;
  }

  /** Between frames on the cut: steps of the square root of two, so that frames stay where they are while the camera moves a little. */
  get glyph_spacing(): number {
    // A cut that is seen at a slant is seen shortened one way: halfway to what that asks for, since the other way there is room.
    const slant = Math.max(0.15, Math.abs(dot(cut_normal(this.settings), this.rig.direction)));
    const pixels = this.settings.glyph.shape === "curve" ? kCurvePixels : kGlyphPixels;
    const wanted = ((pixels * this.pixel) / Math.sqrt(slant)) * 2 ** -this.settings.glyph.density;
    const unit = Math.max(this.field.least_spacing, 1e-12);
    return unit * Math.SQRT2 ** Math.round(2 * Math.log2(wanted / unit));
  }

  /** Whether hexahedra are shown, and picked, instead of the field. */
  get shows_hexahedra(): boolean {
    return this.field.shows_hexahedra(this.settings);
  }

  /** What is under a place of the canvas in CSS pixels. */
  pick(x: number, y: number): Hit {
    const { field, rig: { camera } } = this;
    const { clientWidth, clientHeight } = this.canvas;
    const [right, up] = [(2 * x) / clientWidth - 1, 1 - (2 * y) / clientHeight];
    if (!this.shows_hexahedra) return field.pick(right, up, camera, this.settings);
    const behind = new Vector3(right, up, 0.5).unproject(camera);
    return field.hexahedra!.pick(camera.position.toArray(), behind.sub(camera.position).normalize().toArray());
  }

  get elements(): number {
    return element_count(this.field.scene);
  }

  /** Where a point of the scene is in the canvas, in CSS pixels. */
  on_screen(point: Vector): [number, number] {
    const at = new Vector3(...point).project(this.rig.camera);
    return [((at.x + 1) / 2) * this.canvas.clientWidth, ((1 - at.y) / 2) * this.canvas.clientHeight];
  }

  /** The same, or null where it is not in view. */
  in_view(point: Vector): [number, number] | null {
    const { camera } = this.rig;
    camera.updateMatrixWorld();
    const at = new Vector3(...point).project(camera);
    return Math.abs(at.x) <= 1 && Math.abs(at.y) <= 1 && at.z < 1 ? this.on_screen(point) : null;
  }

  /** Calls back with the canvas drawn at so many of its pixels a CSS pixel. */
  at_scale(scale: number, take: (canvas: HTMLCanvasElement) => void): void {
    const before = this.renderer.getPixelRatio();
    const { clientWidth, clientHeight } = this.canvas;
    this.set_size(clientWidth, clientHeight, scale);
    this.draw(true);
    take(this.canvas);
    this.set_size(clientWidth, clientHeight, before);
    this.draw();
  }

  draw_soon(): void {
    if (this.pending === 0) this.pending = requestAnimationFrame(() => this.draw());
  }

  /** Resolves when what is asked for now has been drawn. */
  drawn(): Promise<void> {
    return new Promise((resolve) => {
      this.after_drawing.push(resolve);
      this.draw_soon();
    });
  }

  private draw(hurry = this.after_drawing.length > 0): void {
    cancelAnimationFrame(this.pending);
    clearTimeout(this.at_rest);
    this.pending = 0;
    const eye = this.rig.camera.position.toArray();
    const is_drawn = this.field.update(this.settings, { theme: this.theme, spacing: this.glyph_spacing, pixel: this.pixel, eye, hurry });
    if (!is_drawn) this.at_rest = window.setTimeout(() => this.draw_soon(), kRest);
    this.renderer.render(this.three, this.rig.camera);
    ++this.frames_drawn;
    for (const resolve of this.after_drawing.splice(0)) resolve();
  }
}
