// SPDX-License-Identifier: Apache-2.0
// Frames on the cut as crosses of three bars or as cubes. They stand in front of its face, so that no half of them is sunk in it.

import { BoxGeometry, BufferAttribute, BufferGeometry, Group, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, ShaderMaterial, Vector3 } from "three";

import type { Theme } from "../math/color_maps.ts";
import type { Vector } from "../math/frame.ts";
import { element_quaternion, type Scene } from "../scene/scene.ts";
import type { GlyphColor, GlyphShape } from "../settings.ts";
import type { Cut } from "./cut.ts";
import { frame_color } from "./frame_colors.ts";
import { glyph_places } from "./glyph_places.ts";
import { kLight } from "./shader_parts.ts";
import { axis_colors, shader_color } from "./view_colors.ts";

type Shape = Exclude<GlyphShape, "curve">;
// Half of the length of bars and of the side of cubes, as shares of the distance between frames.
const kReach: Record<Shape, number> = { cross: 0.46, cube: 0.27 };

export interface GlyphChoice {
  normal: Vector;
  offset: number;
  /** Between frames, in model units. */
  spacing: number;
  shape: Shape;
  color: GlyphColor;
  theme: Theme;
}

export class GlyphView {
  readonly group = new Group();
  count = 0;
  private readonly meshes: Record<Shape, Mesh<InstancedBufferGeometry, ShaderMaterial>>;
  private readonly colors = { value: [0, 1, 2].map(() => new Vector3()) };
  private readonly normal = { value: new Vector3() };
  private drawn = "";

  constructor(private readonly scene: Scene, private readonly cut: Cut) {
    const uniforms = { axis_colors: this.colors, normal_of_cut: this.normal };
    this.meshes = { cross: glyph_mesh(cross_geometry(), kReach.cross, uniforms), cube: glyph_mesh(cube_geometry(), kReach.cube, uniforms) };
    this.group.add(this.meshes.cross, this.meshes.cube);
  }

  /** Draws the frames anew where anything about them has changed. */
  update(visible: boolean, choice: GlyphChoice): void {
    this.group.visible = visible;
    const key = JSON.stringify(choice);
    if (!visible || key === this.drawn) return;
    this.drawn = key;
    axis_colors(choice.theme).forEach((color, k) => this.colors.value[k].copy(shader_color(color)));
    this.normal.value.set(...choice.normal);
    const { pieces } = this.cut;
    const places = glyph_places(pieces, this.cut.map, this.cut.limits, choice.spacing);
    const centers = new Float32Array(4 * places.length);
    const turns = new Float32Array(4 * places.length);
    const names = new Float32Array(3 * places.length);
    const tints = new Float32Array(3 * places.length).fill(-1);
    places.forEach(({ piece, point }, k) => {
      const frame = element_quaternion(this.scene, pieces.element[piece]);
      const [w, x, y, z] = frame;
      centers.set([...point, choice.spacing], 4 * k);
      turns.set([x, y, z, w], 4 * k);
      if (choice.color === "axes") names.set(this.cut.named.names[piece], 3 * k);
      else tints.set(frame_color(frame, choice.color, choice.normal, choice.theme), 3 * k);
    });
    for (const shape of ["cross", "cube"] as const) {
      const mesh = this.meshes[shape];
      mesh.visible = shape === choice.shape && places.length > 0;
      if (!mesh.visible) continue;
      // Attributes of a new length cannot be updated in place.
      const geometry = new InstancedBufferGeometry();
      geometry.index = mesh.geometry.index;
      for (const name of ["position", "normal", "axis"]) geometry.setAttribute(name, mesh.geometry.getAttribute(name));
      geometry.setAttribute("center", new InstancedBufferAttribute(centers, 4));
      geometry.setAttribute("turn", new InstancedBufferAttribute(turns, 4));
      geometry.setAttribute("names", new InstancedBufferAttribute(names, 3));
      geometry.setAttribute("tint", new InstancedBufferAttribute(tints, 3));
      geometry.instanceCount = places.length;
      mesh.geometry.dispose();
      mesh.geometry = geometry;
    }
    this.count = places.length;
  }
}

/** Boxes in one geometry; each vertex knows to which axis it belongs. */
function joined(boxes: BufferGeometry[], axis_of: (box: number, normal: Vector) => number): BufferGeometry {
  const geometry = new BufferGeometry();
  const index: number[] = [];
  const axes: number[] = [];
  let corners = 0;
  boxes.forEach((box, k) => {
    index.push(...[...box.index!.array].map((corner) => corner + corners));
    const normals = box.getAttribute("normal").array;
    for (let corner = 0; corner < normals.length / 3; ++corner) axes.push(axis_of(k, [normals[3 * corner], normals[3 * corner + 1], normals[3 * corner + 2]]));
    corners += normals.length / 3;
  });
  for (const name of ["position", "normal"]) {
    geometry.setAttribute(name, new BufferAttribute(new Float32Array(boxes.flatMap((box) => [...box.getAttribute(name).array])), 3));
  }
  geometry.setAttribute("axis", new BufferAttribute(new Float32Array(axes), 1));
  geometry.setIndex(index);
  return geometry;
}

const kThickness = 0.17;

const cross_geometry = (): BufferGeometry =>
  joined([0, 1, 2].map((axis) => new BoxGeometry(...([0, 1, 2].map((k) => (k === axis ? 2 : kThickness)) as Vector))), (box) => box);

const cube_geometry = (): BufferGeometry => joined([new BoxGeometry(2, 2, 2)], (_, normal) => normal.findIndex((value) => Math.abs(value) > 0.5));

function glyph_mesh(shape: BufferGeometry, reach: number, uniforms: Record<string, { value: unknown }>): Mesh<InstancedBufferGeometry, ShaderMaterial> {
  const geometry = new InstancedBufferGeometry();
  geometry.index = shape.index;
  for (const name of ["position", "normal", "axis"]) geometry.setAttribute(name, shape.getAttribute(name));
  geometry.instanceCount = 0;
  const material = new ShaderMaterial({
    uniforms: { reach: { value: reach }, ...uniforms },
    vertexShader: /* glsl */ `
      in vec4 center; // and distance to the next
      in vec4 turn;
      in vec3 names;
      in vec3 tint;  // negative: by names
      in float axis;
      uniform float reach;
      uniform vec3 normal_of_cut;
      uniform vec3 axis_colors[3];
      out vec3 view_normal;
      out vec3 color;
      vec3 turned(vec3 v) { return v + 2.0 * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v); }
      void main() {
        vec3 n = normal_of_cut;
        // As far towards the camera as the glyph reaches through the plane.
        float depth = max(abs(dot(turned(vec3(1.0, 0.0, 0.0)), n)), max(abs(dot(turned(vec3(0.0, 1.0, 0.0)), n)), abs(dot(turned(vec3(0.0, 0.0, 1.0)), n))));
        float side = dot(cameraPosition - center.xyz, n) < 0.0 ? -1.0 : 1.0;
        vec3 at = center.xyz + side * n * (reach < 0.4 ? 1.3 : 1.0) * depth * reach * center.w;
        int name = int((axis < 0.5 ? names.x : axis < 1.5 ? names.y : names.z) + 0.5);
        color = tint.x < 0.0 ? axis_colors[name] : tint;
        view_normal = (modelViewMatrix * vec4(turned(normal), 0.0)).xyz;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(at + turned(position) * center.w * reach, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      in vec3 view_normal;
      in vec3 color;
      ${kLight}
      void main() { gl_FragColor = vec4(color * min(1.15 * light_on(view_normal), 1.1), 1.0); }`,
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.visible = false;
  mesh.renderOrder = 3;
  return mesh;
}
