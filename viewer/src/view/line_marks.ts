// SPDX-License-Identifier: Apache-2.0
// Marks of singular lines: balls where they meet, discs where they end on the surface, double pyramids where they turn their sense; and
// cubes at creases and corners that hexahedra cannot have, or of which that is undecided.

import { BoxGeometry, CylinderGeometry, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, OctahedronGeometry, ShaderMaterial, SphereGeometry, type BufferGeometry, type Vector3 } from "three";

import type { Vector } from "../math/frame.ts";
import type { VerdictName } from "../scene/report.ts";
import type { Scene } from "../scene/scene.ts";
import { kPasses, pass_output, pass_state, pass_test, type Pass } from "./line_passes.ts";
import { kClip, kLight, kPixelSize } from "./shader_parts.ts";
import type { SharedUniforms } from "./shared_uniforms.ts";

/** A place that is marked besides those of the lines, in the scene's coordinates. */
export interface FaultMark {
  point: Vector;
  verdict: VerdictName;
}

/** How many marks have the colour of what is impossible, and of what is undecided. */
export function fault_counts(scene: Scene, faults: FaultMark[]): { impossible: number; undecided: number } {
  const nodes = (verdict: number): number => scene.node_verdict.filter((value) => value === verdict).length;
  const others = (verdict: VerdictName): number => faults.filter((fault) => fault.verdict === verdict).length;
  return { impossible: nodes(kImpossible) + others("not_meshable"), undecided: nodes(kUndecided) + others("undecided") };
}

/** How many nodes, ends on the surface and turning points there are, as `crossgrain check` counts them. */
export function mark_counts(scene: Scene): { nodes: number; ends: number; turns: number } {
  return {
    nodes: scene.node_degree.filter((degree) => degree > 1).length,
    ends: scene.node_on_boundary.filter((is_there) => is_there === 1).length,
    turns: scene.mark_shape.filter((shape) => shape === kShapes.indexOf("turn")).length,
  };
}

// As in the scene, and then the cubes.
const kShapes = ["node", "end", "turn", "fault"] as const;
type Shape = (typeof kShapes)[number];
const [kImpossible, kUndecided] = [1, 2];
// Places in the list of colours of singular lines.
const kInk = 4;
const kColorOf: Record<VerdictName, number> = { meshable: kInk, not_meshable: 3, undecided: 5 };
const kTurnColor = 6;

// Sizes in radii of singular lines. Discs and pyramids lie along the direction of their mark, which is z here.
const kGeometries: Record<Shape, () => BufferGeometry> = {
  node: () => new SphereGeometry(2.2, 20, 14),
  end: () => new CylinderGeometry(2.3, 2.3, 0.9, 24).rotateX(Math.PI / 2),
  turn: () => new OctahedronGeometry(2.6).scale(1, 1, 1.6),
  fault: () => new BoxGeometry(4.6, 4.6, 4.6),
};
// What is impossible or undecided is larger.
const kFaultSize = 1.3;

export function mark_meshes(scene: Scene, faults: FaultMark[], uniforms: SharedUniforms, colors: { value: Vector3[] }): Mesh[] {
  return kShapes.flatMap((shape) => {
    const geometry = mark_geometry(shape, scene, faults);
    if (geometry.instanceCount === 0) return [];
    return kPasses.map((pass) => {
      const mesh = new Mesh(geometry, mark_material(uniforms, colors, pass));
      mesh.frustumCulled = false;
      mesh.renderOrder = pass === "plain" ? 2 : 8;
      return mesh;
    });
  });
}

function mark_geometry(shape: Shape, scene: Scene, faults: FaultMark[]): InstancedBufferGeometry {
  const solid = kGeometries[shape]();
  const geometry = new InstancedBufferGeometry();
  geometry.index = solid.index;
  for (const name of ["position", "normal"]) geometry.setAttribute(name, solid.getAttribute(name));
  const [centers, directions, looks]: number[][] = [[], [], []];
  const add = (center: ArrayLike<number>, direction: ArrayLike<number>, color: number, wall: number): void => {
    for (let k = 0; k < 3; ++k) {
      centers.push(center[k]);
      directions.push(direction[k]);
    }
    // Shaders take no infinity.
    looks.push(color, Math.min(wall, 1e30), color === kInk || color === kTurnColor ? 1 : kFaultSize);
  };
  if (shape === "fault") for (const { point, verdict } of faults) add(point, [0, 0, 1], kColorOf[verdict], Infinity);
  scene.mark_shape.forEach((value, k) => {
    if (kShapes[value] !== shape) return;
    const color = shape === "turn" ? kTurnColor : kColorOf[(["meshable", "not_meshable", "undecided"] as const)[scene.mark_verdict[k]] ?? "meshable"];
    add(scene.mark_points.subarray(3 * k, 3 * k + 3), scene.mark_directions.subarray(3 * k, 3 * k + 3), color, scene.mark_wall[k] ?? Infinity);
  });
  geometry.setAttribute("center", new InstancedBufferAttribute(new Float32Array(centers), 3));
  geometry.setAttribute("direction", new InstancedBufferAttribute(new Float32Array(directions), 3));
  geometry.setAttribute("look", new InstancedBufferAttribute(new Float32Array(looks), 3));
  geometry.instanceCount = looks.length / 3;
  return geometry;
}

function mark_material(uniforms: SharedUniforms, colors: { value: Vector3[] }, pass: Pass): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: { view_height: uniforms.view_height, cut: uniforms.cut, clip: uniforms.clip, colors },
    ...pass_state(pass),
    vertexShader: /* glsl */ `
      in vec3 center;
      in vec3 direction;
      in vec3 look; // colour, wall, size
      out vec3 view_normal;
      out float color_number;
      out vec3 world_point;
      ${kPixelSize}
      void main() {
        vec3 z = dot(direction, direction) > 0.25 ? normalize(direction) : vec3(0.0, 0.0, 1.0);
        vec3 x = normalize(cross(abs(z.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0), z));
        mat3 turned = mat3(x, cross(z, x), z);
        float radius = line_radius(2.6, look.y, pixel_size_at(modelViewMatrix * vec4(center, 1.0)));
        view_normal = (modelViewMatrix * vec4(turned * normal, 0.0)).xyz;
        color_number = look.x;
        world_point = center;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(center + turned * position * radius * look.z, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 colors[7];
      in vec3 view_normal;
      in float color_number;
      in vec3 world_point;
      ${kClip}${kLight}
      void main() {
        ${pass_test(pass)}
        gl_FragColor = ${pass_output(pass, "colors[int(color_number + 0.5)] * light_on(view_normal)")};
      }`,
  });
}
