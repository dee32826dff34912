// SPDX-License-Identifier: Apache-2.0
// Singular lines as tubes of constant width on the screen, thinner in thin walls. Kinds differ by colour, by pattern and, for what no
// hexahedral mesh can have, by width.

import { BufferAttribute, BufferGeometry, Group, Mesh, ShaderMaterial, Vector3 } from "three";

import { add, cross, scaled, subtract, tangents_of, unit, dot, type Vector } from "../math/frame.ts";
import type { Scene } from "../scene/scene.ts";
import { mark_meshes, type FaultMark } from "./line_marks.ts";
import { kPasses, pass_output, pass_state, pass_test, type Pass } from "./line_passes.ts";
import { kClip, kLight, kPixelSize } from "./shader_parts.ts";
import type { SharedUniforms } from "./shared_uniforms.ts";
import { shader_color, type ViewColors } from "./view_colors.ts";

export const kArcKinds = ["positive", "negative", "half", "warn", "undecided"] as const;
export type ArcKind = (typeof kArcKinds)[number];

/** How an arc is drawn: by its index, or as a warning where a hexahedral mesh cannot have it. */
export function arc_kind(scene: Scene, arc: number): ArcKind {
  if (scene.arc_verdict[arc] === 1 || scene.arc_type[arc] !== 0) return "warn";
  if (scene.arc_verdict[arc] === 2) return "undecided";
  const index = scene.arc_index[arc];
  if (Math.abs(index) > 0.4) return "half";
  return index > 0 ? "positive" : "negative";
}

const kSides = 10;
// Of each kind the place of its colour among those of lines and marks.
const kColors = [0, 1, 2, 3, 5];

export class SingularLines {
  readonly group = new Group();
  private readonly tubes: Mesh[];
  private readonly marks: Mesh[];
  private readonly colors = { value: [0, 1, 2, 3, 4, 5, 6].map(() => new Vector3()) };

  constructor(scene: Scene, faults: FaultMark[], uniforms: SharedUniforms) {
    const tubes = tube_geometry(scene);
    this.tubes = kPasses.map((pass) => {
      const mesh = new Mesh(tubes, tube_material(uniforms, this.colors, pass));
      mesh.frustumCulled = false;
      mesh.renderOrder = pass === "plain" ? 2 : 8;
      return mesh;
    });
    this.marks = mark_meshes(scene, faults, uniforms, this.colors);
    this.group.add(...this.tubes, ...this.marks);
  }

  recolor(colors: ViewColors): void {
    [colors.positive, colors.negative, colors.half, colors.warn, colors.node, colors.undecided, colors.turn].forEach((color, k) => this.colors.value[k].copy(shader_color(color)));
  }

  show(arcs: boolean, nodes: boolean): void {
    for (const mesh of this.tubes) mesh.visible = arcs;
    for (const mesh of this.marks) mesh.visible = nodes;
  }
}

function tube_geometry(scene: Scene): BufferGeometry {
  const centers: number[] = [];
  const normals: number[] = [];
  const looks: number[] = [];
  const triangles: number[] = [];
  const point = (k: number): Vector => [scene.arc_points[3 * k], scene.arc_points[3 * k + 1], scene.arc_points[3 * k + 2]];
  for (let arc = 0; arc + 1 < scene.arc_starts.length; ++arc) {
    const first = scene.arc_starts[arc];
    const last = scene.arc_starts[arc + 1] - 1;
    const kind = kColors[kArcKinds.indexOf(arc_kind(scene, arc))];
    let normal: Vector | null = null;
    let length = 0;
    for (let k = first; k <= last; ++k) {
      const tangent = unit(subtract(point(Math.min(last, k + 1)), point(Math.max(first, k - 1))));
      // The ring's first direction is carried along with as little twist as can be.
      normal = normal ? unit(subtract(normal, scaled(tangent, dot(normal, tangent)))) : tangents_of(tangent)[0];
      const other = cross(tangent, normal);
      if (k > first) length += Math.hypot(...subtract(point(k), point(k - 1)));
      const base = centers.length / 3;
      for (let side = 0; side < kSides; ++side) {
        const angle = (2 * Math.PI * side) / kSides;
        centers.push(...point(k));
        normals.push(...add(scaled(normal, Math.cos(angle)), scaled(other, Math.sin(angle))));
        // Shaders take no infinity.
        looks.push(kind, length, Math.min(scene.arc_wall[k] ?? 1e30, 1e30));
        if (k === first) continue;
        const next = (side + 1) % kSides;
        triangles.push(base - kSides + side, base - kSides + next, base + side, base + side, base - kSides + next, base + next);
      }
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(centers), 3));
  geometry.setAttribute("normal", new BufferAttribute(new Float32Array(normals), 3));
  geometry.setAttribute("look", new BufferAttribute(new Float32Array(looks), 3));
  geometry.setIndex(triangles);
  return geometry;
}

function tube_material(uniforms: SharedUniforms, colors: { value: Vector3[] }, pass: Pass): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: { view_height: uniforms.view_height, cut: uniforms.cut, clip: uniforms.clip, colors },
    ...pass_state(pass),
    vertexShader: /* glsl */ `
      in vec3 look; // colour, length so far, wall
      out vec3 view_normal;
      out float arc_kind;
      out float pattern_place;
      out vec3 world_point;
      ${kPixelSize}
      void main() {
        vec4 view = modelViewMatrix * vec4(position, 1.0);
        float pixel = pixel_size_at(view);
        float radius = line_radius(look.x > 2.5 && look.x < 3.5 ? 4.4 : 2.6, look.z, pixel);
        world_point = position;
        view_normal = (modelViewMatrix * vec4(normal, 0.0)).xyz;
        arc_kind = look.x;
        // Patterns repeat at powers of two of a length in the model, now 12 to 24 pixels: they do not swim with the camera.
        float repeat = exp2(ceil(log2(12.0 * pixel_size_at(modelViewMatrix * vec4(0.0, 0.0, 0.0, 1.0)))));
        pattern_place = look.y / max(repeat, 1e-9);
        gl_Position = projectionMatrix * (view + vec4(normalize(view_normal) * radius, 0.0));
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 colors[7];
      in vec3 view_normal;
      in float arc_kind;
      in float pattern_place;
      in vec3 world_point;
      ${kClip}${kLight}
      void main() {
        ${pass_test(pass)}
        int kind = int(arc_kind + 0.5);
        vec3 color = colors[kind];
        float phase = fract(pattern_place);
        // +1/4 plain, -1/4 rings, halves double rings, irregular ones broad bands.
        float band = 0.0;
        if (kind == 1) band = step(phase, 0.16);
        if (kind == 2) band = max(step(phase, 0.12), step(abs(phase - 0.30), 0.06));
        if (kind == 3) band = step(phase, 0.5);
        color = mix(color, kind == 3 ? vec3(1.0) : color * 0.45, band * (kind == 3 ? 0.55 : 1.0));
        gl_FragColor = ${pass_output(pass, "color * light_on(view_normal)")};
      }`,
  });
}
