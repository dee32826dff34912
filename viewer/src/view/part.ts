// SPDX-License-Identifier: Apache-2.0
// The part: its surface, translucent and coloured by the field, and its creases.

import { BackSide, BufferAttribute, BufferGeometry, FrontSide, Group, Mesh, Plane, ShaderMaterial, type Color, type Side } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";

import type { Vector } from "../math/frame.ts";
import type { Scene } from "../scene/scene.ts";
import { shaded_triangles } from "./creased_normals.ts";
import { fraction_of, type Ranges } from "./ranges.ts";
import { kClip, kFieldColors, kFieldLookup, kLight } from "./shader_parts.ts";
import type { SharedUniforms } from "./shared_uniforms.ts";
import { line_material, segments_of } from "./thin_lines.ts";

export class PartView {
  readonly group = new Group();
  readonly geometry: BufferGeometry;
  private readonly sides: Mesh<BufferGeometry, ShaderMaterial>[];
  private readonly opacity = { value: 0.35 };
  /** On the half that is there, and faintly on the one that is cut away. */
  private readonly creases: [LineSegments2, LineSegments2];
  private readonly kept = new Plane();
  private readonly taken = new Plane();

  constructor(scene: Scene, uniforms: SharedUniforms, ranges: Ranges) {
    const has_numbers = scene.surface_alignment_deg.length > 0;
    const { positions, normals } = shaded_triangles(scene);
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute("position", new BufferAttribute(positions, 3));
    this.geometry.setAttribute("normal", new BufferAttribute(normals, 3));
    // Numbers at vertices are interpolated; without them the cells there give the colours.
    if (has_numbers) this.geometry.setAttribute("numbers", new BufferAttribute(corner_numbers(scene, ranges), 3));
    this.geometry.computeBoundingSphere();
    // What faces away first, then what faces the camera: right for convex parts, and calm for others.
    this.sides = [BackSide, FrontSide].map((side, order) => {
      const mesh = new Mesh(this.geometry, part_material(uniforms, this.opacity, side, has_numbers));
      mesh.renderOrder = 10 + order;
      return mesh;
    });
    const segments = segments_of(scene.crease_points, scene.crease_starts);
    this.creases = [new LineSegments2(segments, line_material(1.2, 0.8)), new LineSegments2(segments, line_material(1, 0.3))];
    for (const lines of this.creases) lines.renderOrder = 12;
    this.creases[1].material.clippingPlanes = [this.taken];
    this.group.add(...this.sides, ...this.creases);
  }

  recolor(crease: Color): void {
    for (const lines of this.creases) lines.material.color = crease;
  }

  /** Whether a map colours the surface. Without one the shader does not look for cells, and is sooner compiled. */
  set_mapped(mapped: boolean): void {
    for (const { material } of this.sides) {
      if ("MAPPED" in material.defines === mapped) continue;
      if (mapped) material.defines.MAPPED = 1;
      else delete material.defines.MAPPED;
      material.needsUpdate = true;
    }
  }

  cut(normal: Vector, offset: number, clip: boolean): void {
    this.taken.normal.set(...normal);
    this.taken.constant = -offset;
    this.kept.copy(this.taken).negate();
    const [kept, taken] = this.creases;
    kept.material.clippingPlanes = clip ? [this.kept] : null;
    taken.visible = kept.visible && clip;
  }

  show(visible: boolean, creases: boolean, opacity: number): void {
    this.opacity.value = opacity;
    for (const mesh of this.sides) {
      mesh.visible = visible && opacity > 0;
      const opaque = opacity >= 1;
      if (mesh.material.transparent === opaque) mesh.material.needsUpdate = true;
      mesh.material.transparent = !opaque;
      mesh.material.depthWrite = opaque;
    }
    this.creases[0].visible = creases;
  }
}

/** Alignment and energy density as shares of their ranges, and the region, at each corner of each triangle. */
function corner_numbers(scene: Scene, ranges: Ranges): Float32Array {
  const numbers = new Float32Array(3 * scene.surface_triangles.length);
  scene.surface_triangles.forEach((vertex, corner) => {
    numbers[3 * corner] = fraction_of(ranges.alignment, scene.surface_alignment_deg[vertex]);
    numbers[3 * corner + 1] = fraction_of(ranges.energy, scene.surface_energy_density[vertex]);
    numbers[3 * corner + 2] = scene.surface_region[Math.floor(corner / 3)] ?? 0;
  });
  return numbers;
}

function part_material(uniforms: SharedUniforms, opacity: { value: number }, side: Side, has_numbers: boolean): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: { ...uniforms, opacity, inward: { value: side === BackSide } },
    side,
    transparent: true,
    depthWrite: false,
    // Pushed back a little, so that creases and lines on the surface are not half hidden in it.
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
    vertexShader: /* glsl */ `
      out vec3 world_point;
      out vec3 world_normal;
      out vec3 view_point;
      ${has_numbers ? "in vec3 numbers; out vec3 shown;" : ""}
      void main() {
        ${has_numbers ? "shown = numbers;" : ""}
        world_point = position;
        world_normal = normal;
        vec4 view = modelViewMatrix * vec4(position, 1.0);
        view_point = view.xyz;
        gl_Position = projectionMatrix * view;
      }`,
    fragmentShader: /* glsl */ `
      precision highp int;
      uniform float pixel_ratio;
      uniform float opacity;
      uniform bool inward;
      in vec3 world_point;
      in vec3 world_normal;
      in vec3 view_point;
      ${has_numbers ? "in vec3 shown;" : ""}
      uniform vec3 base_color;
      ${kClip}${kLight}
      #ifdef MAPPED
      ${has_numbers ? kFieldColors : kFieldLookup}
      #endif
      void main() {
        clip_at_cut(world_point);
        vec3 outward = normalize(world_normal);
        vec3 toward = normalize((viewMatrix * vec4(outward, 0.0)).xyz) * (inward ? -1.0 : 1.0);
        vec3 color = base_color;
        #ifdef MAPPED
        ${has_numbers
          ? "if (map_kind == 1) color = ramp_color(shown.x); if (map_kind == 2) color = ramp_color(shown.y); if (map_kind == 4) color = region_color(int(shown.z + 0.5));"
          : "color = surface_color(world_point, outward);"}
        #endif
        float facing = abs(dot(toward, normalize(view_point)));
        // Glass: nearly clear where it is looked at straight, denser where it turns away, so that shape shows at any opacity.
        float rim = pow(1.0 - facing, 2.5);
        float alpha = opacity >= 1.0 ? 1.0 : mix(opacity * (inward ? 0.55 : 0.8), min(1.0, opacity * 1.6 + 0.15), rim);
        gl_FragColor = vec4(color * light_on(toward), alpha);
      }`,
  });
}
