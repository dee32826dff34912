// SPDX-License-Identifier: Apache-2.0
// Frames as crosses of three bars or as cubes, on the cut.

import { BoxGeometry, BufferAttribute, BufferGeometry, Group, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, ShaderMaterial } from "three";

import { parse_color, ramp_color, type Color, type Theme } from "../math/color_maps.ts";
import { axes_of, tangents_of, tilt_deg, turn_deg, type Vector } from "../math/frame.ts";
import type { Octree } from "../scene/octree.ts";
import { cell_quaternion, type Scene } from "../scene/scene.ts";
import type { GlyphColor, GlyphShape } from "../settings.ts";
import { fitting_glyph_places } from "./glyph_places.ts";
import { kLight } from "./shader_parts.ts";
import { kViewColors } from "./view_colors.ts";

export interface GlyphChoice {
  normal: Vector;
  offset: number;
  /** Lattice units, a power of two. */
  spacing: number;
  shape: GlyphShape;
  color: GlyphColor;
  theme: Theme;
}

/** Angles beyond this have the last colour of the scale: between two axes no direction is further off than 54.7 degrees. */
export const kTiltScale = 45;

export class GlyphView {
  readonly group = new Group();
  count = 0;
  private readonly meshes: Record<GlyphShape, Mesh<InstancedBufferGeometry, ShaderMaterial>>;
  private drawn = "";

  constructor(private readonly scene: Scene, private readonly octree: Octree) {
    this.meshes = { cross: glyph_mesh(cross_geometry(), 0.46), cube: glyph_mesh(new BoxGeometry(2, 2, 2), 0.3) };
    this.group.add(this.meshes.cross, this.meshes.cube);
  }

  /** Draws the frames anew where anything about them has changed. */
  update(visible: boolean, choice: GlyphChoice): void {
    this.group.visible = visible;
    const key = JSON.stringify(choice);
    if (!visible || key === this.drawn) return;
    this.drawn = key;
    const places = fitting_glyph_places(this.scene, this.octree, choice.normal, choice.offset, choice.spacing);
    const first = tangents_of(choice.normal)[0];
    const centers = new Float32Array(4 * places.length);
    const turns = new Float32Array(4 * places.length);
    const colors = new Float32Array(3 * places.length);
    places.forEach((place, k) => {
      const [w, x, y, z] = cell_quaternion(this.scene, place.cell);
      centers.set([...place.point, place.side], 4 * k);
      turns.set([x, y, z, w], 4 * k);
      colors.set(this.color_of(place.cell, choice, first), 3 * k);
    });
    for (const shape of ["cross", "cube"] as const) {
      const mesh = this.meshes[shape];
      mesh.visible = shape === choice.shape && places.length > 0;
      if (!mesh.visible) continue;
      // Attributes of a new length cannot be updated in place.
      const geometry = new InstancedBufferGeometry();
      geometry.index = mesh.geometry.index;
      geometry.setAttribute("position", mesh.geometry.getAttribute("position"));
      geometry.setAttribute("normal", mesh.geometry.getAttribute("normal"));
      geometry.setAttribute("center", new InstancedBufferAttribute(centers, 4));
      geometry.setAttribute("turn", new InstancedBufferAttribute(turns, 4));
      geometry.setAttribute("tint", new InstancedBufferAttribute(colors, 3));
      geometry.instanceCount = places.length;
      mesh.geometry.dispose();
      mesh.geometry = geometry;
    }
    this.count = places.length;
  }

  private color_of(cell: number, choice: GlyphChoice, first: Vector): Color {
    const axes = axes_of(cell_quaternion(this.scene, cell));
    switch (choice.color) {
      case "tilt":
        return ramp_color("tilt", choice.theme, tilt_deg(axes, choice.normal) / kTiltScale);
      case "turn":
        return ramp_color("turn", choice.theme, turn_deg(axes, choice.normal, first) / 90);
      default:
        return parse_color(kViewColors[choice.theme].glyph);
    }
  }
}

function cross_geometry(): BufferGeometry {
  const thin = 0.12;
  const bars = [new BoxGeometry(2, thin, thin), new BoxGeometry(thin, 2, thin), new BoxGeometry(thin, thin, 2)];
  const merged = new BufferGeometry();
  const corners = bars[0].getAttribute("position").count;
  const index: number[] = [];
  const joined = (name: string): Float32Array => {
    const values = bars.flatMap((bar) => [...bar.getAttribute(name).array]);
    return new Float32Array(values);
  };
  bars.forEach((bar, k) => index.push(...[...bar.index!.array].map((corner) => corner + k * corners)));
  merged.setAttribute("position", new BufferAttribute(joined("position"), 3));
  merged.setAttribute("normal", new BufferAttribute(joined("normal"), 3));
  merged.setIndex(index);
  return merged;
}

function glyph_mesh(shape: BufferGeometry, reach: number): Mesh<InstancedBufferGeometry, ShaderMaterial> {
  const geometry = new InstancedBufferGeometry();
  geometry.index = shape.index;
  geometry.setAttribute("position", shape.getAttribute("position"));
  geometry.setAttribute("normal", shape.getAttribute("normal"));
  geometry.instanceCount = 0;
  const material = new ShaderMaterial({
    uniforms: { reach: { value: reach } },
    vertexShader: /* glsl */ `
      in vec4 center; // and side of its room
      in vec4 turn;
      in vec3 tint;
      uniform float reach;
      out vec3 view_normal;
      out vec3 color;
      vec3 turned(vec3 v) { return v + 2.0 * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v); }
      void main() {
        view_normal = (modelViewMatrix * vec4(turned(normal), 0.0)).xyz;
        color = tint;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(center.xyz + turned(position) * center.w * reach, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      in vec3 view_normal;
      in vec3 color;
      ${kLight}
      void main() { gl_FragColor = vec4(color * light_on(view_normal), 1.0); }`,
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.visible = false;
  mesh.renderOrder = 3;
  return mesh;
}
