// SPDX-License-Identifier: Apache-2.0
// The 3D view: everything that is drawn, kept in step with the settings, and drawn only when something has changed.

import { Box3, Color, Scene as ThreeScene, Vector3, WebGLRenderer } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";

import type { Theme } from "../math/color_maps.ts";
import { dot, type Vector } from "../math/frame.ts";
import { build_octree, type Octree } from "../scene/octree.ts";
import type { Scene } from "../scene/scene.ts";
import { cut_normal, cut_offset, type Settings } from "../settings.ts";
import { CameraRig, type Covered } from "./camera_rig.ts";
import { CutFace } from "./cut_face.ts";
import { field_textures, set_palette, type FieldTextures } from "./field_textures.ts";
import { GlyphView } from "./glyphs.ts";
import { Marks } from "./marks.ts";
import { PartView } from "./part.ts";
import { Picker } from "./picking.ts";
import { ranges_of, type Ranges } from "./ranges.ts";
import { shared_uniforms, type SharedUniforms } from "./shared_uniforms.ts";
import { SingularLines, type FaultBall } from "./singular_lines.ts";
import { line_material, segments_of } from "./thin_lines.ts";
import { kViewColors, scene_color, shader_color } from "./view_colors.ts";

// A glyph needs this many pixels to be told from its neighbour.
const kGlyphPixels = 23;

export class Stage {
  readonly octree: Octree;
  readonly ranges: Ranges;
  readonly rig: CameraRig;
  readonly glyphs: GlyphView;
  frames_drawn = 0;
  private readonly renderer: WebGLRenderer;
  private readonly three = new ThreeScene();
  private readonly textures: FieldTextures;
  private readonly uniforms: SharedUniforms;
  private readonly part: PartView;
  private readonly face: CutFace;
  private readonly lines: SingularLines;
  private readonly streams: LineSegments2;
  private readonly marks: Marks;
  private readonly picker: Picker;
  private settings: Settings;
  private theme: Theme = "light";
  private pending = 0;
  private after_drawing: (() => void)[] = [];
  onmove: () => void = () => {};

  constructor(readonly scene: Scene, readonly faults: FaultBall[], readonly canvas: HTMLCanvasElement, context: WebGL2RenderingContext, closed: boolean, settings: Settings) {
    this.settings = settings;
    this.octree = build_octree(scene);
    this.ranges = ranges_of(scene);
    this.renderer = new WebGLRenderer({ canvas, context });
    // Asking whether a shader compiled waits until it has: half a second that is better spent on the rest.
    this.renderer.debug.checkShaderErrors = false;
    this.renderer.localClippingEnabled = true;
    this.textures = field_textures(scene, this.octree, this.ranges);
    this.uniforms = shared_uniforms(scene, this.octree, this.textures);
    this.rig = new CameraRig(new Box3(new Vector3(...scene.low), new Vector3(...scene.high)), scene.surface_vertices, canvas, () => {
      this.draw_soon();
      this.onmove();
    });
    this.part = new PartView(scene, this.uniforms);
    this.face = new CutFace(scene, this.uniforms, this.part.geometry, closed);
    this.lines = new SingularLines(scene, faults, this.uniforms);
    this.glyphs = new GlyphView(scene, this.octree);
    this.marks = new Marks(scene, this.uniforms);
    this.picker = new Picker(scene, this.octree, this.part.geometry);
    this.streams = new LineSegments2(segments_of(scene.streamline_points, scene.streamline_starts), line_material(1.6, 1));
    this.streams.renderOrder = 4;
    this.three.add(this.part.group, this.face.group, this.lines.group, this.glyphs.group, this.streams, this.marks.group);
  }

  resize(width: number, height: number, covered: Covered): void {
    // Beyond two device pixels a CSS pixel nothing is gained but work.
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio || 1));
    this.renderer.setSize(width, height, false);
    this.rig.resize(width, height, covered);
    this.uniforms.view_height.value = height;
    this.uniforms.pixel_ratio.value = this.renderer.getPixelRatio();
    this.draw_soon();
  }

  apply(settings: Settings, theme: Theme): void {
    if (theme !== this.theme || settings.map !== this.settings.map || this.frames_drawn === 0) this.recolor(settings, theme);
    this.settings = settings;
    const { layers, cut } = settings;
    const normal = cut_normal(settings);
    const offset = this.cut_offset;
    this.uniforms.cut.value.set(...normal, offset);
    this.uniforms.clip.value = cut.on && cut.clip;
    this.part.show(layers.part, layers.creases, settings.opacity);
    this.part.cut(normal, offset, cut.on && cut.clip);
    this.face.place(normal, offset);
    this.face.show(cut.on, layers.cells);
    this.lines.show(layers.arcs, layers.nodes);
    this.streams.visible = layers.streamlines && this.scene.streamline_starts.length > 1;
    this.marks.update(settings);
    this.draw_soon();
  }

  get cut_offset(): number {
    return cut_offset(this.settings, this.scene.low, this.scene.high);
  }

  private recolor(settings: Settings, theme: Theme): void {
    this.theme = theme;
    const colors = kViewColors[theme];
    this.renderer.setClearColor(new Color(colors.background));
    this.uniforms.map_kind.value = ["none", "alignment", "energy", "class"].indexOf(settings.map);
    set_palette(this.textures, settings.map, theme);
    this.uniforms.base_color.value.copy(shader_color(colors.part));
    this.uniforms.void_color.value.copy(shader_color(colors.nothing));
    this.uniforms.face_color.value.copy(shader_color(colors.cut));
    this.face.line_color.value.copy(shader_color(colors.cell_line));
    this.part.recolor(scene_color(colors.crease));
    this.streams.material.color = scene_color(colors.streamline);
    this.lines.recolor(colors);
    this.marks.recolor(colors);
  }

  /** Lattice units between glyphs: the power of two that leaves each enough pixels where the camera looks. */
  get glyph_spacing(): number {
    const { camera, controls } = this.rig;
    const distance = camera.position.distanceTo(controls.target);
    const pixel = (2 * distance * Math.tan((camera.fov * Math.PI) / 360)) / this.uniforms.view_height.value;
    // A cut that is seen at a slant is seen shortened one way: halfway to what that asks for, since the other way there is room.
    const slant = Math.max(0.15, Math.abs(dot(cut_normal(this.settings), this.rig.direction)));
    const cells = (kGlyphPixels * pixel) / Math.sqrt(slant) / this.scene.cells.unit;
    return 2 ** Math.max(0, Math.round(Math.log2(cells)) - this.settings.glyph.density);
  }

  /** The cell under a place of the canvas in CSS pixels, or -1. */
  pick(x: number, y: number): number {
    const { clientWidth, clientHeight } = this.canvas;
    return this.picker.pick((2 * x) / clientWidth - 1, 1 - (2 * y) / clientHeight, this.rig.camera, this.settings);
  }

  /** Where a point of the scene is in the canvas, in CSS pixels. */
  on_screen(point: Vector): [number, number] {
    const at = new Vector3(...point).project(this.rig.camera);
    return [((at.x + 1) / 2) * this.canvas.clientWidth, ((1 - at.y) / 2) * this.canvas.clientHeight];
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

  private draw(): void {
    this.pending = 0;
    const { glyph, layers, cut } = this.settings;
    this.glyphs.update(layers.glyphs && cut.on, {
      normal: cut_normal(this.settings),
      offset: this.cut_offset,
      spacing: this.glyph_spacing,
      shape: glyph.shape,
      color: glyph.color,
      theme: this.theme,
    });
    this.renderer.render(this.three, this.rig.camera);
    ++this.frames_drawn;
    for (const resolve of this.after_drawing.splice(0)) resolve();
  }
}
