// SPDX-License-Identifier: Apache-2.0
// One field in the view: its part, its cut with the frames on it, and its singular lines. A page of tets has two, one of which is shown.

import { Group, type PerspectiveCamera } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";

import { kMaps, type Theme } from "../math/color_maps.ts";
import { dot, scaled, type Vector } from "../math/frame.ts";
import { build_octree, type Octree } from "../scene/octree.ts";
import { element_size, type Scene } from "../scene/scene.ts";
import { cut_normal, cut_offset, type Settings } from "../settings.ts";
import { Cut } from "./cut.ts";
import { CurveView } from "./curve_view.ts";
import { CutFace } from "./cut_face.ts";
import { corner_texture, field_textures, set_palette, type FieldTextures } from "./field_textures.ts";
import { FaceHighlight } from "./face_highlight.ts";
import { GlyphView } from "./glyphs.ts";
import { HexView } from "./hex_view.ts";
import type { FaultMark } from "./line_marks.ts";
import { PartView } from "./part.ts";
import { Picker, type Hit } from "./picking.ts";
import { ranges_of, type Ranges } from "./ranges.ts";
import { shared_uniforms, type SharedUniforms } from "./shared_uniforms.ts";
import { SingularLines } from "./singular_lines.ts";
import { TetFace } from "./tet_face.ts";
import { line_material } from "./thin_lines.ts";
import { kViewColors, scene_color, shader_color } from "./view_colors.ts";

// Lines on the cut stand this share of the distance between frames in front of it, so that its face does not hide half of them.
const kLift = 0.04;
// Opacity of the part around hexahedra of some shapes.
const kAround = 0.2;

/** How the view is looked at. */
export interface Look {
  theme: Theme;
  /** Between frames on the cut, in model units. */
  spacing: number;
  /** Size of one where the camera looks. */
  pixel: number;
  eye: Vector;
  /** Whether everything has to be drawn now, however long it takes. */
  hurry: boolean;
}

export class FieldView {
  readonly group = new Group();
  readonly octree: Octree;
  readonly ranges: Ranges;
  readonly uniforms: SharedUniforms;
  readonly glyphs: GlyphView;
  readonly cut: Cut;
  readonly hexahedra: HexView | null;
  private readonly textures: FieldTextures;
  private readonly part: PartView;
  private readonly cell_face: CutFace | null;
  private readonly tet_face: TetFace | null;
  private readonly lines: SingularLines;
  private readonly curves: CurveView;
  /** What is drawn on the face of the cut. */
  private readonly on_cut = new Group();
  private readonly seams = new LineSegments2(new LineSegmentsGeometry(), line_material(1.4, 0.75));
  private readonly outline = new LineSegments2(new LineSegmentsGeometry(), line_material(1.6, 1));
  private readonly picker: Picker;
  private readonly highlight: FaceHighlight;
  private drawn_seams: unknown = null;
  private drawn_outline: unknown = null;

  constructor(readonly scene: Scene, readonly faults: FaultMark[], closed: boolean) {
    this.octree = build_octree(scene);
    this.ranges = ranges_of(scene);
    this.textures = field_textures(scene, this.octree, this.ranges);
    this.uniforms = shared_uniforms(scene, this.octree, this.textures);
    // The boundary of tets is closed, and so is the model of hexahedra without a field.
    this.cut = new Cut(scene, this.octree, closed || scene.tets !== null);
    this.part = new PartView(scene, this.uniforms, this.ranges);
    this.tet_face = scene.tets ? new TetFace(scene, this.uniforms, this.cut, this.ranges) : null;
    this.cell_face = scene.tets ? null : new CutFace(scene, this.uniforms, this.part.geometry, closed);
    this.hexahedra = scene.hexahedra ? new HexView(scene, scene.hexahedra, this.uniforms) : null;
    this.highlight = new FaceHighlight(scene, this.uniforms);
    this.lines = new SingularLines(scene, faults, this.uniforms);
    this.glyphs = new GlyphView(scene, this.cut);
    this.picker = new Picker(scene, this.octree, this.part.geometry, this.cut);
    this.curves = new CurveView(scene, this.cut);
    this.seams.material.dashed = true;
    for (const lines of [this.seams, this.outline]) {
      lines.renderOrder = 3;
      lines.frustumCulled = false;
    }
    this.on_cut.add(this.seams, this.outline, this.curves.lines);
    this.group.add(this.part.group, this.lines.group, this.glyphs.group, this.on_cut, this.highlight.mesh);
    for (const face of [this.tet_face, this.cell_face, this.hexahedra]) if (face) this.group.add(face.group);
  }

  resize(view_height: number, pixel_ratio: number): void {
    this.uniforms.view_height.value = view_height;
    this.uniforms.pixel_ratio.value = pixel_ratio;
  }

  apply(settings: Settings): void {
    const { layers, cut } = settings;
    const normal = cut_normal(settings);
    const offset = this.offset_of(settings);
    this.cut.place(normal, offset);
    this.uniforms.cut.value.set(...normal, offset);
    const is_solid = this.shows_hexahedra(settings);
    const is_alone = is_solid && settings.alone && settings.hexahedron >= 0;
    const clips = cut.on && cut.clip && !is_alone;
    this.uniforms.clip.value = clips;
    this.hexahedra?.show(settings, normal, offset);
    // Around some of the hexahedra it tells where these are.
    this.part.show(is_alone || (layers.part && (!is_solid || settings.below < 1)), layers.creases, is_solid ? Math.min(settings.opacity, kAround) : settings.opacity);
    this.part.cut(normal, offset, clips);
    const face = settings.face?.number ?? 0;
    // Hexahedra have the colour of a face that they lie on.
    this.highlight.show(is_solid && this.hexahedra!.lie_on(face) ? 0 : face);
    this.cell_face?.place(normal, offset);
    this.cell_face?.show(cut.on && !is_solid, layers.cells);
    this.tet_face?.show(cut.on && !is_solid, layers.cells);
    this.lines.show(is_solid ? layers.mesh_lines && !is_alone : layers.arcs, is_solid ? layers.mesh_lines && !is_alone : layers.nodes);
  }

  /** Whether hexahedra stand for the part and the face of the cut. */
  shows_hexahedra({ layers }: Settings): boolean {
    return this.hexahedra !== null && layers.hexahedra;
  }

  offset_of(settings: Settings): number {
    return cut_offset(settings, this.scene.low, this.scene.high);
  }

  recolor(settings: Settings, theme: Theme): void {
    const colors = kViewColors[theme];
    this.uniforms.map_kind.value = kMaps.indexOf(settings.map);
    set_palette(this.textures, settings.map, theme);
    if (!this.scene.tets && (settings.map === "alignment" || settings.map === "energy")) this.uniforms.corner_values.value ??= corner_texture(this.scene, this.ranges);
    this.uniforms.base_color.value.copy(shader_color(colors.part));
    this.uniforms.void_color.value.copy(shader_color(colors.nothing));
    this.uniforms.face_color.value.copy(shader_color(colors.cut));
    this.cell_face?.line_color.value.copy(shader_color(colors.cell_line));
    this.tet_face?.recolor(colors.cell_line);
    this.hexahedra?.recolor(theme);
    this.part.recolor(scene_color(colors.crease));
    this.highlight.recolor(colors.picked);
    this.part.set_mapped(settings.map !== "none");
    this.lines.recolor(colors);
    this.seams.material.color = scene_color(colors.seam);
    this.outline.material.color = scene_color(colors.crease);
  }

  /** What depends on the camera: frames on the cut, and lines that fade. Whether all of it is drawn; if not, it wants to be once more, at rest. */
  update(settings: Settings, { theme, spacing, pixel, eye, hurry }: Look): boolean {
    const { glyph: { shape, color }, layers, cut } = settings;
    const { normal, offset } = this.cut;
    const is_solid = this.shows_hexahedra(settings);
    const shown = this.scene.has_field && layers.glyphs && cut.on && !is_solid;
    const choice = { normal, offset, spacing, color, theme };
    const in_front = dot(normal, eye) < offset ? -1 : 1;
    this.on_cut.position.set(...scaled(normal, in_front * kLift * spacing));
    this.glyphs.update(shown && shape !== "curve", { ...choice, shape: shape === "cube" ? "cube" : "cross" });
    const is_drawn = this.curves.update(shown && shape === "curve", choice, hurry);
    this.tet_face?.update(pixel);
    if (is_drawn) this.update_seams(shown && color === "axes", spacing);
    else this.seams.visible = false;
    this.update_outline(cut.on && layers.creases && !is_solid);
    return is_drawn;
  }

  private update_seams(visible: boolean, spacing: number): void {
    const segments = visible ? this.cut.named.seams : null;
    this.seams.visible = segments !== null && segments.length > 0;
    if (!segments || !this.seams.visible) return;
    this.seams.material.dashSize = this.seams.material.gapSize = spacing / 5;
    if (segments === this.drawn_seams) return;
    this.drawn_seams = segments;
    this.seams.geometry.dispose();
    this.seams.geometry = new LineSegmentsGeometry().setPositions(segments);
    this.seams.computeLineDistances();
  }

  /** Of the part and of its regions. */
  private update_outline(visible: boolean): void {
    const { outline, interfaces } = this.cut;
    this.outline.visible = visible && outline.length + interfaces.length > 0;
    if (!this.outline.visible || interfaces === this.drawn_outline) return;
    this.drawn_outline = interfaces;
    const segments = new Float32Array(outline.length + interfaces.length);
    segments.set(outline);
    segments.set(interfaces, outline.length);
    this.outline.geometry.dispose();
    this.outline.geometry = new LineSegmentsGeometry().setPositions(segments);
  }

  /** At a place of the view, both coordinates -1 ... 1 and y up. */
  pick(x: number, y: number, camera: PerspectiveCamera, settings: Settings): Hit {
    return this.picker.pick(x, y, camera, settings);
  }

  /** The smallest distance between frames that shows each of them. */
  get least_spacing(): number {
    return element_size(this.scene);
  }
}
