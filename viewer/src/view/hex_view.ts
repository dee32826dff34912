// SPDX-License-Identifier: Apache-2.0
// Hexahedra: the outside of those that are shown, in the colours of scaled Jacobians, faces or regions, with the edges of its faces. One alone is
// shown with those around it faintly.

import { BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, ShaderMaterial, Vector3 } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";

import { face_color, parse_color, ramp_color, region_color, type Color, type Theme } from "../math/color_maps.ts";
import { add, dot, scaled, subtract, type Vector } from "../math/frame.ts";
import {
  faces_of_hexahedra, hex_colors, hexahedron_center, hexahedron_edges, hexahedron_of, hexahedron_radius, HexSkins, is_inverted, side_along, type HexColor, type Hexahedra, type HexSkin,
} from "../scene/hexahedra.ts";
import type { Scene } from "../scene/scene.ts";
import type { Settings } from "../settings.ts";
import { face_at, kNothingHit, type Hit } from "./picking.ts";
import { kLight } from "./shader_parts.ts";
import type { SharedUniforms } from "./shared_uniforms.ts";
import { line_material } from "./thin_lines.ts";
import { kHexEdges, kViewColors, scene_color, shader_color } from "./view_colors.ts";

// A plane through the centres of a layer takes that layer away as a whole: the cut lies deeper by this share of the part.
const kInto = 1e-5;
// How much of the colour of what is picked the face of the model has that is picked.
const kTint = 0.55;
const kNoSkin: HexSkin = { side: new Uint32Array(0), corners: new Uint32Array(0) };

const shape_color = (hexahedra: Hexahedra, hexahedron: number, theme: Theme): Color =>
  is_inverted(hexahedra, hexahedron) ? parse_color(kViewColors[theme].inverted) : ramp_color("shape", theme, hexahedra.shape[hexahedron]);

export class HexView {
  readonly group = new Group();
  readonly skins: HexSkins;
  /** How many are shown. */
  count = 0;
  private readonly solid: Mesh<BufferGeometry, ShaderMaterial>;
  /** Those around one that is shown alone. */
  private readonly faint: Mesh<BufferGeometry, ShaderMaterial>;
  private readonly picked = new LineSegments2(new LineSegmentsGeometry(), line_material(3.5, 1));
  private readonly size: number;
  private readonly into: number;
  private skin = kNoSkin;
  private skin_around = kNoSkin;
  private theme: Theme = "light";
  private face = 0;
  private color: HexColor = "shape";
  /** Of each face that hexahedra lie on its place among them. */
  private readonly place_of_face: Map<number, number>;
  private drawn = "";
  private outlined = -1;

  constructor({ low, high }: Scene, private readonly hexahedra: Hexahedra, uniforms: SharedUniforms) {
    this.skins = new HexSkins(hexahedra);
    this.place_of_face = new Map(faces_of_hexahedra(hexahedra).map((number, place) => [number, place]));
    this.size = Math.hypot(...high.map((value, k) => value - low[k]));
    this.into = kInto * this.size;
    this.solid = new Mesh(new BufferGeometry(), material_of(uniforms, 1));
    this.faint = new Mesh(new BufferGeometry(), material_of(uniforms, 0.12));
    this.faint.renderOrder = 9;
    this.picked.material.depthTest = false;
    this.picked.material.transparent = true;
    this.picked.renderOrder = 30;
    this.picked.visible = false;
    for (const shape of [this.solid, this.faint, this.picked]) {
      shape.frustumCulled = false;
      this.group.add(shape);
    }
  }

  recolor(theme: Theme): void {
    this.picked.material.color = scene_color(kViewColors[theme].picked);
    if (theme === this.theme && this.drawn !== "") return;
    this.theme = theme;
    if (this.drawn !== "") this.fill();
  }

  /** Draws those below the cut, where it takes half away, and below the limit of shapes; or one alone. */
  show({ layers, cut, below, hex_color, hexahedron, alone, face }: Settings, normal: Vector, offset: number): void {
    this.group.visible = layers.hexahedra;
    if (!layers.hexahedra) return;
    const plane = cut.on && cut.clip ? { normal, offset: offset - this.into } : null;
    const limit = below < 1 ? below : Infinity;
    const single = alone ? hexahedron : -1;
    const key = single >= 0 ? `alone ${single}` : `${plane ? [...normal, offset] : ""} ${limit}`;
    const color = hex_colors(this.hexahedra).includes(hex_color) ? hex_color : "shape";
    if (key !== this.drawn || color !== this.color || (face?.number ?? 0) !== this.face) {
      this.drawn = key;
      this.color = color;
      this.face = face?.number ?? 0;
      const is_shown = single >= 0 ? this.only(single) : this.skins.shown(plane, limit);
      this.count = is_shown.reduce((sum, flag) => sum + flag, 0);
      this.skin = this.skins.skin(is_shown);
      this.faint.visible = single >= 0;
      this.skin_around = single >= 0 ? this.skins.skin(this.skins.around(single)) : kNoSkin;
      this.fill();
    }
    this.outline(hexahedron);
  }

  private only(hexahedron: number): Uint8Array {
    const is_shown = new Uint8Array(this.hexahedra.shape.length);
    is_shown[hexahedron] = 1;
    return is_shown;
  }

  pick(origin: Vector, direction: Vector): Hit {
    const met = side_along(this.hexahedra, this.skin, origin, direction);
    return met ? { element: hexahedron_of(met.side), face: face_at(this.hexahedra.face[met.side] ?? 0, met.point) } : kNothingHit;
  }

  /** Whether those that are shown lie in front of a place, seen from this direction. */
  hides(point: Vector, direction: Vector): boolean {
    const met = side_along(this.hexahedra, this.skin, add(point, scaled(direction, this.size)), scaled(direction, -1));
    // The place may lie beneath the side that it is of.
    return met !== null && dot(subtract(met.point, point), direction) > hexahedron_radius(this.hexahedra, hexahedron_of(met.side));
  }

  lie_on(face: number): boolean {
    return this.place_of_face.has(face);
  }

  center(hexahedron: number): Vector {
    return hexahedron_center(this.skins, hexahedron);
  }

  radius(hexahedron: number): number {
    return hexahedron_radius(this.hexahedra, hexahedron);
  }

  private outline(hexahedron: number): void {
    this.picked.visible = hexahedron >= 0;
    if (hexahedron < 0 || hexahedron === this.outlined) return;
    this.outlined = hexahedron;
    this.picked.geometry.dispose();
    this.picked.geometry = new LineSegmentsGeometry().setPositions(hexahedron_edges(this.hexahedra, hexahedron).flat(2));
  }

  private fill(): void {
    for (const [mesh, skin] of [[this.solid, this.skin], [this.faint, this.skin_around]] as const) {
      mesh.geometry.dispose();
      mesh.geometry = this.geometry_of(skin);
    }
  }

  /** Two triangles for each face, with one normal, and its corners in the unit square, whose sides are the edges. */
  private geometry_of({ side, corners }: HexSkin): BufferGeometry {
    const { points } = this.hexahedra;
    const positions = new Float32Array(18 * side.length);
    const normals = new Float32Array(positions.length);
    const colors = new Uint8Array(positions.length);
    const places = new Uint8Array(12 * side.length);
    const [along, across] = [new Vector3(), new Vector3()];
    const at = (corner: number): Vector3 => new Vector3().fromArray(points, 3 * corner);
    for (let face = 0; face < side.length; ++face) {
      const quad = [0, 1, 2, 3].map((k) => at(corners[4 * face + k]));
      across.subVectors(quad[3], quad[1]);
      along.subVectors(quad[2], quad[0]).cross(across).normalize();
      const color = this.color_of(side[face]).map((channel) => Math.round(255 * channel));
      kCorners.forEach((corner, k) => {
        const vertex = 6 * face + k;
        quad[corner].toArray(positions, 3 * vertex);
        along.toArray(normals, 3 * vertex);
        colors.set(color, 3 * vertex);
        places.set(kPlaces[corner], 2 * vertex);
      });
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("normal", new BufferAttribute(normals, 3));
    geometry.setAttribute("shown", new BufferAttribute(colors, 3, true));
    geometry.setAttribute("place", new BufferAttribute(places, 2));
    return geometry;
  }

  private color_of(side: number): Color {
    const color = this.plain_color_of(side);
    if (this.face === 0 || this.hexahedra.face[side] !== this.face) return color;
    const tint = parse_color(kViewColors[this.theme].picked);
    return color.map((channel, k) => channel + kTint * (tint[k] - channel)) as Color;
  }

  private plain_color_of(side: number): Color {
    const hexahedron = hexahedron_of(side);
    if (this.color === "shape") return shape_color(this.hexahedra, hexahedron, this.theme);
    if (this.color === "region") return parse_color(region_color(this.hexahedra.region[hexahedron]));
    const place = this.place_of_face.get(this.hexahedra.face[side]);
    return place === undefined ? parse_color(kViewColors[this.theme].cut) : face_color(place);
  }
}

const kCorners = [0, 1, 2, 0, 2, 3];
const kPlaces = [[0, 0], [1, 0], [1, 1], [0, 1]];

function material_of({ pixel_ratio }: SharedUniforms, opacity: number): ShaderMaterial {
  const [dark, light] = [kHexEdges.dark, kHexEdges.light].map(shader_color);
  return new ShaderMaterial({
    uniforms: { pixel_ratio, opacity: { value: opacity }, dark_edge: { value: dark }, light_edge: { value: light } },
    side: DoubleSide,
    transparent: opacity < 1,
    depthWrite: opacity >= 1,
    // Pushed back a little, so that creases and singular lines on the surface are not half hidden in it.
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
    vertexShader: /* glsl */ `
      in vec3 shown;
      in vec2 place;
      out vec3 color;
      out vec2 at;
      out vec3 view_normal;
      void main() {
        color = shown;
        at = place;
        view_normal = normalMatrix * normal;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      uniform float pixel_ratio;
      uniform float opacity;
      uniform vec3 dark_edge;
      uniform vec3 light_edge;
      in vec3 color;
      in vec2 at;
      in vec3 view_normal;
      ${kLight}
      const float shading = 0.6; // enough to tell sides apart, in colours that can still be found in the legend
      // Between the luminances of the two edges so that the contrast of each is the same at it, above 3.
      const float dark_face = 0.17;
      float luminance_of(vec3 srgb) { return dot(pow(srgb, vec3(2.2)), vec3(0.2126, 0.7152, 0.0722)); }
      void main() {
        vec3 lit = color * mix(1.0, light_on(gl_FrontFacing ? view_normal : -view_normal), shading);
        vec3 edge_color = luminance_of(lit) < dark_face ? light_edge : dark_edge;
        // Half a line on each side of an edge. Edges fade before small faces become a mass of lines.
        vec2 step = max(fwidth(at), 1e-6) * pixel_ratio;
        vec2 pixels = min(at, 1.0 - at) / step;
        float line = 1.0 - smoothstep(0.3, 1.1, min(pixels.x, pixels.y));
        float room = 1.0 / max(step.x, step.y);
        float ink = line * 0.85 * smoothstep(1.5, 6.0, room);
        gl_FragColor = vec4(mix(lit, edge_color, ink), mix(opacity, min(1.0, 4.0 * opacity), ink));
      }`,
  });
}
