// SPDX-License-Identifier: Apache-2.0
// What the user has pointed at: a box around the picked cell with its frame, and a ring around a marked place. Seen through everything.

import { Group, Mesh, PlaneGeometry, ShaderMaterial, Vector3 } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";

import { axes_of, length_of, subtract } from "../math/frame.ts";
import { cell_box, element_center, element_quaternion, tet_corners, type Scene } from "../scene/scene.ts";
import type { Settings } from "../settings.ts";
import { kPixelSize } from "./shader_parts.ts";
import type { SharedUniforms } from "./shared_uniforms.ts";
import { box_edges, line_material } from "./thin_lines.ts";
import { scene_color, shader_color, type ViewColors } from "./view_colors.ts";

export class Marks {
  readonly group = new Group();
  private readonly box = new LineSegments2(new LineSegmentsGeometry(), line_material(2.5, 1));
  private readonly ring: Mesh<PlaneGeometry, ShaderMaterial>;
  /** Around the picked cell, where it is too small to be seen. */
  private readonly halo: Mesh<PlaneGeometry, ShaderMaterial>;
  private boxed = "";

  constructor(uniforms: SharedUniforms) {
    this.box.material.depthTest = false;
    this.box.material.transparent = true;
    this.box.frustumCulled = false;
    this.box.renderOrder = 30;
    this.box.visible = false;
    [this.ring, this.halo] = [true, false].map((ticks) => {
      const mesh = new Mesh(new PlaneGeometry(2, 2), ring_material(uniforms, ticks));
      mesh.frustumCulled = false;
      mesh.renderOrder = 31;
      mesh.visible = false;
      return mesh;
    });
    this.group.add(this.box, this.ring, this.halo);
  }

  recolor(colors: ViewColors): void {
    this.box.material.color = scene_color(colors.picked);
    this.ring.material.uniforms.plain.value = shader_color(colors.node);
    this.ring.material.uniforms.warning.value = shader_color(colors.warn);
    this.halo.material.uniforms.plain.value = shader_color(colors.picked);
    this.halo.material.uniforms.behind.value = this.ring.material.uniforms.behind.value = shader_color(colors.background);
  }

  update(scene: Scene, { field, picked, marked }: Settings): void {
    this.box.visible = this.halo.visible = picked >= 0;
    const key = `${field} ${picked}`;
    if (picked >= 0 && key !== this.boxed) {
      const { edges, side } = outline_of(scene, picked);
      const center = element_center(scene, picked);
      // The frame as three bars that reach a little out of it.
      for (const axis of axes_of(element_quaternion(scene, picked))) {
        for (const end of [-0.8, 0.8]) edges.push(...center.map((value, k) => value + end * side * axis[k]));
      }
      this.box.geometry.dispose();
      this.box.geometry = new LineSegmentsGeometry().setPositions(edges);
      this.boxed = key;
      this.halo.material.uniforms.center.value.set(...center);
      this.halo.material.uniforms.content.value = side;
    }
    this.ring.visible = marked !== null;
    if (marked) {
      this.ring.material.uniforms.center.value.set(...marked.point);
      this.ring.material.uniforms.warn.value = marked.warn ? 1 : 0;
    }
  }
}

/** The edges of a tet or cell, and about how large it is. */
function outline_of(scene: Scene, element: number): { edges: number[]; side: number } {
  if (!scene.tets) {
    const { low, side } = cell_box(scene, element);
    return { edges: box_edges(low, side), side };
  }
  const corners = tet_corners(scene.tets, element);
  const pairs = corners.flatMap((from, k) => corners.slice(k + 1).map((to) => [from, to]));
  return { edges: pairs.flat(2), side: pairs.reduce((sum, [from, to]) => sum + length_of(subtract(to, from)) / pairs.length, 0) };
}

function ring_material(uniforms: SharedUniforms, ticks: boolean): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: {
      view_height: uniforms.view_height,
      center: { value: new Vector3() },
      warn: { value: 0 },
      content: { value: 0 },
      ticks: { value: ticks ? 1 : 0 },
      plain: { value: new Vector3() },
      warning: { value: new Vector3() },
      behind: { value: new Vector3() },
    },
    transparent: true,
    depthTest: false,
    depthWrite: false,
    vertexShader: /* glsl */ `
      uniform vec3 center;
      uniform float content; // side of what the ring is around
      out vec2 at;
      ${kPixelSize}
      const float reach = 22.0; // pixels
      void main() {
        at = position.xy * reach;
        vec4 view = modelViewMatrix * vec4(center, 1.0);
        if (content > 18.0 * pixel_size_at(view)) at = vec2(0.0); // needs no ring
        gl_Position = projectionMatrix * (view + vec4(at * pixel_size_at(view), 0.0, 0.0));
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 plain;
      uniform vec3 warning;
      uniform vec3 behind;
      uniform float warn;
      uniform float ticks;
      in vec2 at;
      void main() {
        float radius = length(at);
        float ring = 1.0 - smoothstep(1.0, 2.0, abs(radius - 13.0));
        // Four ticks outwards, so that it is no ball and no end of a line.
        float tick = (1.0 - smoothstep(1.0, 2.0, min(abs(at.x), abs(at.y)))) * ticks * step(13.0, radius) * (1.0 - step(20.0, radius));
        float halo = 1.0 - smoothstep(2.5, 4.0, abs(radius - 13.0));
        float ink = max(ring, tick);
        gl_FragColor = vec4(mix(behind, mix(plain, warning, warn), ink), max(ink, 0.75 * halo));
      }`,
  });
}
