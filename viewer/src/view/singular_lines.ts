// SPDX-License-Identifier: Apache-2.0
// Singular lines as tubes of constant width on the screen, and their nodes as balls. Kinds differ by colour, by pattern and, for what no
// hexahedral mesh can have, by width. Balls also mark other places that it cannot have, or of which that is undecided.

import {
  BufferAttribute, BufferGeometry, GreaterDepth, Group, InstancedBufferAttribute, InstancedBufferGeometry, LessEqualDepth, Mesh,
  ShaderMaterial, SphereGeometry, Vector3, type DepthModes,
} from "three";

import { add, cross, scaled, subtract, tangents_of, unit, dot, type Vector } from "../math/frame.ts";
import type { VerdictName } from "../scene/report.ts";
import type { Scene } from "../scene/scene.ts";
import { kClip, kLight, kPixelSize } from "./shader_parts.ts";
import type { SharedUniforms } from "./shared_uniforms.ts";
import { shader_color, type ViewColors } from "./view_colors.ts";

export const kArcKinds = ["positive", "negative", "half", "warn"] as const;
export type ArcKind = (typeof kArcKinds)[number];

/** How an arc is drawn: by its index, or as a warning where a hexahedral mesh cannot have it. */
export function arc_kind(scene: Scene, arc: number): ArcKind {
  if (scene.arc_verdict[arc] === 1 || scene.arc_type[arc] !== 0) return "warn";
  const index = scene.arc_index[arc];
  if (Math.abs(index) > 0.4) return "half";
  return index > 0 ? "positive" : "negative";
}

/** A place that is marked by a ball besides the nodes, in the scene's coordinates. */
export interface FaultBall {
  point: Vector;
  verdict: VerdictName;
}

/** How many balls have the colour of what is impossible, and of what is undecided. */
export function ball_counts(scene: Scene, faults: FaultBall[]): { impossible: number; undecided: number } {
  const kinds = ball_kinds(scene, faults);
  return { impossible: kinds.filter((kind) => kind === kImpossible).length, undecided: kinds.filter((kind) => kind === kUndecided).length };
}

// Ends on the surface are small, meetings inside larger, what is undecided or what no hexahedral mesh can have largest.
const [kEnd, kMeeting, kUndecided, kImpossible] = [0, 1, 2, 3];

function ball_kinds(scene: Scene, faults: FaultBall[]): number[] {
  const nodes = Array.from(scene.node_verdict, (verdict, node) =>
    (verdict === 1 ? kImpossible : verdict === 2 ? kUndecided : scene.node_on_boundary[node] ? kEnd : kMeeting));
  return [...nodes, ...faults.map(({ verdict }) => (verdict === "undecided" ? kUndecided : kImpossible))];
}

const kSides = 10;

export class SingularLines {
  readonly group = new Group();
  private readonly tubes: Mesh[];
  private readonly balls: Mesh[];
  private readonly colors = { value: [0, 1, 2, 3, 4, 5].map(() => new Vector3()) };

  constructor(scene: Scene, faults: FaultBall[], uniforms: SharedUniforms) {
    const tubes = tube_geometry(scene);
    const balls = ball_geometry(scene, faults);
    this.tubes = kPasses.map((pass) => new Mesh(tubes, tube_material(uniforms, this.colors, pass)));
    this.balls = kPasses.map((pass) => new Mesh(balls, ball_material(uniforms, this.colors, pass)));
    for (const mesh of [...this.tubes, ...this.balls]) {
      mesh.frustumCulled = false;
      mesh.renderOrder = 2;
      this.group.add(mesh);
    }
    for (const later of [1, 2]) this.tubes[later].renderOrder = this.balls[later].renderOrder = 8;
  }

  recolor(colors: ViewColors): void {
    [colors.positive, colors.negative, colors.half, colors.warn, colors.node, colors.undecided].forEach((color, k) => this.colors.value[k].copy(shader_color(color)));
  }

  show(arcs: boolean, nodes: boolean): void {
    for (const mesh of this.tubes) mesh.visible = arcs;
    for (const mesh of this.balls) mesh.visible = nodes;
  }
}

function tube_geometry(scene: Scene): BufferGeometry {
  const centers: number[] = [];
  const normals: number[] = [];
  const kinds: number[] = [];
  const along: number[] = [];
  const triangles: number[] = [];
  const point = (k: number): Vector => [scene.arc_points[3 * k], scene.arc_points[3 * k + 1], scene.arc_points[3 * k + 2]];
  for (let arc = 0; arc + 1 < scene.arc_starts.length; ++arc) {
    const first = scene.arc_starts[arc];
    const last = scene.arc_starts[arc + 1] - 1;
    const kind = kArcKinds.indexOf(arc_kind(scene, arc));
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
        kinds.push(kind);
        along.push(length);
        if (k === first) continue;
        const next = (side + 1) % kSides;
        triangles.push(base - kSides + side, base - kSides + next, base + side, base + side, base - kSides + next, base + next);
      }
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(centers), 3));
  geometry.setAttribute("normal", new BufferAttribute(new Float32Array(normals), 3));
  geometry.setAttribute("kind", new BufferAttribute(new Float32Array(kinds), 1));
  geometry.setAttribute("along", new BufferAttribute(new Float32Array(along), 1));
  geometry.setIndex(triangles);
  return geometry;
}

// Drawn as they are, faintly where the cut or an opaque part hides them, and more faintly in the half that is taken away.
const kPasses = ["plain", "hidden", "taken"] as const;
type Pass = (typeof kPasses)[number];
const kAlpha: Record<Pass, string> = { plain: "1.0", hidden: "0.36", taken: "0.2" };

const pass_state = (pass: Pass): { transparent: boolean; depthWrite: boolean; depthFunc: DepthModes } =>
  ({ transparent: pass !== "plain", depthWrite: pass === "plain", depthFunc: pass === "hidden" ? GreaterDepth : LessEqualDepth });

/** Leaves to each pass its half. */
const pass_test = (pass: Pass): string => `if (${pass === "taken" ? "!" : ""}is_taken(world_point)) discard;`;

function tube_material(uniforms: SharedUniforms, colors: { value: Vector3[] }, pass: Pass): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: { view_height: uniforms.view_height, cut: uniforms.cut, clip: uniforms.clip, colors },
    ...pass_state(pass),
    vertexShader: /* glsl */ `
      in float kind;
      in float along;
      out vec3 view_normal;
      out float arc_kind;
      out float pattern_place;
      out vec3 world_point;
      ${kPixelSize}
      void main() {
        vec4 view = modelViewMatrix * vec4(position, 1.0);
        float pixel = pixel_size_at(view);
        float radius = (kind > 2.5 ? 4.4 : 2.6) * pixel;
        world_point = position;
        view_normal = (modelViewMatrix * vec4(normal, 0.0)).xyz;
        arc_kind = kind;
        // Patterns repeat at powers of two of a length in the model, now 12 to 24 pixels: they do not swim with the camera.
        float repeat = exp2(ceil(log2(12.0 * pixel_size_at(modelViewMatrix * vec4(0.0, 0.0, 0.0, 1.0)))));
        pattern_place = along / max(repeat, 1e-9);
        gl_Position = projectionMatrix * (view + vec4(normalize(view_normal) * radius, 0.0));
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 colors[6];
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
        gl_FragColor = vec4(color * light_on(view_normal), ${kAlpha[pass]});
      }`,
  });
}

function ball_geometry(scene: Scene, faults: FaultBall[]): InstancedBufferGeometry {
  const sphere = new SphereGeometry(1, 20, 14);
  const geometry = new InstancedBufferGeometry();
  geometry.index = sphere.index;
  geometry.setAttribute("position", sphere.getAttribute("position"));
  const kinds = ball_kinds(scene, faults);
  geometry.setAttribute("center", new InstancedBufferAttribute(new Float32Array([...scene.node_points, ...faults.flatMap(({ point }) => point)]), 3));
  geometry.setAttribute("kind", new InstancedBufferAttribute(new Float32Array(kinds), 1));
  geometry.instanceCount = kinds.length;
  return geometry;
}

function ball_material(uniforms: SharedUniforms, colors: { value: Vector3[] }, pass: Pass): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: { view_height: uniforms.view_height, cut: uniforms.cut, clip: uniforms.clip, colors },
    ...pass_state(pass),
    vertexShader: /* glsl */ `
      in vec3 center;
      in float kind;
      out vec3 view_normal;
      out float ball_kind;
      out vec3 world_point;
      ${kPixelSize}
      void main() {
        vec4 view = modelViewMatrix * vec4(center, 1.0);
        float pixels = kind > 1.5 ? 8.0 : kind > 0.5 ? 5.6 : 3.4;
        view_normal = position;
        ball_kind = kind;
        world_point = center;
        // The ball is a little nearer than its centre, so that the ends of tubes do not stick out of it.
        vec4 moved = view + vec4(position * pixels * pixel_size_at(view), 0.0);
        gl_Position = projectionMatrix * moved;
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 colors[6];
      in vec3 view_normal;
      in float ball_kind;
      in vec3 world_point;
      ${kClip}${kLight}
      void main() {
        ${pass_test(pass)}
        vec3 color = ball_kind > 2.5 ? colors[3] : ball_kind > 1.5 ? colors[5] : colors[4];
        gl_FragColor = vec4(color * light_on(view_normal), ${kAlpha[pass]});
      }`,
  });
}
