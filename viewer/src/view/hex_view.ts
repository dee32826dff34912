// SPDX-License-Identifier: Apache-2.0
// Hexahedra: the outside of those that are shown, in the colours of their scaled Jacobians, with the edges of its faces.

import { BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, ShaderMaterial, Vector3 } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";

import { ramp_color, parse_color, type Color, type Theme } from "../math/color_maps.ts";
import type { Vector } from "../math/frame.ts";
import { hexahedron_along, hexahedron_center, hexahedron_edges, HexSkins, kInverted, type Hexahedra, type HexSkin } from "../scene/hexahedra.ts";
import type { Settings } from "../settings.ts";
import { kLight } from "./shader_parts.ts";
import type { SharedUniforms } from "./shared_uniforms.ts";
import { line_material } from "./thin_lines.ts";
import { kViewColors, scene_color, shader_color } from "./view_colors.ts";

// A plane through the centres of a layer takes that layer away as a whole: the cut lies deeper by this share of the part.
const kInto = 1e-5;

export const hexahedron_color = (shape: number, theme: Theme): Color =>
  shape > kInverted ? ramp_color("shape", theme, shape) : parse_color(kViewColors[theme].inverted);

export class HexView {
  readonly group = new Group();
  readonly skins: HexSkins;
  /** How many are shown. */
  count = 0;
  private readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private readonly picked = new LineSegments2(new LineSegmentsGeometry(), line_material(2.5, 1));
  private readonly into: number;
  private skin: HexSkin = { hexahedron: new Uint32Array(0), corners: new Uint32Array(0) };
  private theme: Theme = "light";
  private drawn = "";
  private outlined = -1;

  constructor(private readonly hexahedra: Hexahedra, low: Vector, high: Vector, uniforms: SharedUniforms) {
    this.skins = new HexSkins(hexahedra);
    this.into = kInto * Math.hypot(...high.map((value, k) => value - low[k]));
    this.mesh = new Mesh(new BufferGeometry(), material_of(uniforms));
    this.picked.material.depthTest = false;
    this.picked.material.transparent = true;
    this.picked.renderOrder = 30;
    this.picked.visible = false;
    for (const shape of [this.mesh, this.picked]) {
      shape.frustumCulled = false;
      this.group.add(shape);
    }
  }

  recolor(theme: Theme): void {
    this.mesh.material.uniforms.edge_color.value = shader_color(kViewColors[theme].hex_edge);
    this.picked.material.color = scene_color(kViewColors[theme].picked);
    if (theme === this.theme && this.drawn !== "") return;
    this.theme = theme;
    if (this.drawn !== "") this.fill();
  }

  /** Draws those below the cut, where it takes half away, and below the limit of shapes. */
  show({ layers, cut, below, hexahedron }: Settings, normal: Vector, offset: number): void {
    this.group.visible = layers.hexahedra;
    if (!layers.hexahedra) return;
    const plane = cut.on && cut.clip ? { normal, offset: offset - this.into } : null;
    const limit = below < 1 ? below : Infinity;
    const key = `${plane ? [...normal, offset] : ""} ${limit}`;
    if (key !== this.drawn) {
      this.drawn = key;
      const is_shown = this.skins.shown(plane, limit);
      this.count = is_shown.reduce((sum, flag) => sum + flag, 0);
      this.skin = this.skins.skin(is_shown);
      this.fill();
    }
    this.outline(hexahedron);
  }

  pick(origin: Vector, direction: Vector): number {
    return hexahedron_along(this.hexahedra, this.skin, origin, direction);
  }

  center(hexahedron: number): Vector {
    return hexahedron_center(this.skins, hexahedron);
  }

  private outline(hexahedron: number): void {
    this.picked.visible = hexahedron >= 0;
    if (hexahedron < 0 || hexahedron === this.outlined) return;
    this.outlined = hexahedron;
    this.picked.geometry.dispose();
    this.picked.geometry = new LineSegmentsGeometry().setPositions(hexahedron_edges(this.hexahedra, hexahedron).flat(2));
  }

  /** Two triangles for each face, with one normal, and its corners in the unit square, whose sides are the edges. */
  private fill(): void {
    const { points, shape } = this.hexahedra;
    const { hexahedron, corners } = this.skin;
    const positions = new Float32Array(18 * hexahedron.length);
    const normals = new Float32Array(positions.length);
    const colors = new Uint8Array(positions.length);
    const places = new Uint8Array(12 * hexahedron.length);
    const [along, across] = [new Vector3(), new Vector3()];
    const at = (corner: number): Vector3 => new Vector3().fromArray(points, 3 * corner);
    for (let face = 0; face < hexahedron.length; ++face) {
      const quad = [0, 1, 2, 3].map((k) => at(corners[4 * face + k]));
      across.subVectors(quad[3], quad[1]);
      along.subVectors(quad[2], quad[0]).cross(across).normalize();
      const color = hexahedron_color(shape[hexahedron[face]], this.theme).map((channel) => Math.round(255 * channel));
      kCorners.forEach((corner, k) => {
        const vertex = 6 * face + k;
        quad[corner].toArray(positions, 3 * vertex);
        along.toArray(normals, 3 * vertex);
        colors.set(color, 3 * vertex);
        places.set(kPlaces[corner], 2 * vertex);
      });
    }
    this.mesh.geometry.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("normal", new BufferAttribute(normals, 3));
    geometry.setAttribute("shown", new BufferAttribute(colors, 3, true));
    geometry.setAttribute("place", new BufferAttribute(places, 2));
    this.mesh.geometry = geometry;
  }
}

const kCorners = [0, 1, 2, 0, 2, 3];
const kPlaces = [[0, 0], [1, 0], [1, 1], [0, 1]];

function material_of(uniforms: SharedUniforms): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: { pixel_ratio: uniforms.pixel_ratio, edge_color: { value: new Vector3() } },
    side: DoubleSide,
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
      uniform vec3 edge_color;
      in vec3 color;
      in vec2 at;
      in vec3 view_normal;
      ${kLight}
      const float shading = 0.6; // enough to tell sides apart, in colours that can still be found in the legend
      void main() {
        vec3 lit = color * mix(1.0, light_on(gl_FrontFacing ? view_normal : -view_normal), shading);
        // Half a line on each side of an edge. Edges fade before small faces become a dark mass.
        vec2 step = max(fwidth(at), 1e-6) * pixel_ratio;
        vec2 pixels = min(at, 1.0 - at) / step;
        float line = 1.0 - smoothstep(0.3, 1.1, min(pixels.x, pixels.y));
        float room = 1.0 / max(step.x, step.y);
        gl_FragColor = vec4(mix(lit, edge_color, line * 0.8 * smoothstep(2.0, 10.0, room)), 1.0);
      }`,
  });
}
