// SPDX-License-Identifier: Apache-2.0
// The face of a cut through tets: a polygon for each, coloured by its numbers, and their sides as thin lines.

import { BufferAttribute, BufferGeometry, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh, ShaderMaterial } from "three";

import { element_energy, element_region, type Scene } from "../scene/scene.ts";
import type { Cut } from "./cut.ts";
import { fraction_of, type Ranges } from "./ranges.ts";
import { kFieldColors } from "./shader_parts.ts";
import type { SharedUniforms } from "./shared_uniforms.ts";
import { scene_color } from "./view_colors.ts";

// Lines fade before the tets become a grey mass: from this many pixels a side, to none at a third of it.
const kClearPixels = 14;
const kLineOpacity = 0.3;

export class TetFace {
  readonly group = new Group();
  private readonly face: Mesh<BufferGeometry, ShaderMaterial>;
  private readonly lines: LineSegments<BufferGeometry, LineBasicMaterial>;
  private drawn: unknown = null;
  private shows_lines = true;
  /** Mean length of sides, in model units. */
  private side = 0;

  constructor(private readonly scene: Scene, uniforms: SharedUniforms, private readonly cut: Cut, private readonly ranges: Ranges) {
    this.face = new Mesh(new BufferGeometry(), face_material(uniforms));
    this.face.renderOrder = 1;
    this.lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ transparent: true, depthWrite: false }));
    this.lines.renderOrder = 2;
    for (const mesh of [this.face, this.lines]) {
      mesh.frustumCulled = false;
      this.group.add(mesh);
    }
  }

  recolor(line: string): void {
    this.lines.material.color = scene_color(line);
  }

  show(visible: boolean, lines: boolean): void {
    this.group.visible = visible;
    this.shows_lines = lines;
  }

  /** Draws the polygons anew where the cut has moved; `pixel` is the size of one there. */
  update(pixel: number): void {
    if (!this.group.visible) return;
    const { pieces } = this.cut;
    if (pieces !== this.drawn) {
      this.drawn = pieces;
      this.fill();
    }
    const share = Math.min(1, Math.max(0, (this.side / pixel - kClearPixels / 3) / (kClearPixels * (2 / 3))));
    this.lines.visible = this.shows_lines && share > 0;
    this.lines.material.opacity = kLineOpacity * share;
  }

  private fill(): void {
    const { count, element, starts, corners, side_ends } = this.cut.pieces;
    const index = new Uint32Array(3 * (corners.length / 3 - 2 * count));
    const numbers = new Float32Array(corners.length);
    let next = 0;
    for (let piece = 0; piece < count; ++piece) {
      const energy = fraction_of(this.ranges.energy, element_energy(this.scene, element[piece]));
      const region = element_region(this.scene, element[piece]);
      for (let k = starts[piece]; k < starts[piece + 1]; ++k) {
        numbers[3 * k + 1] = energy;
        numbers[3 * k + 2] = region;
        if (k < starts[piece] + 2) continue;
        index[next++] = starts[piece];
        index[next++] = k - 1;
        index[next++] = k;
      }
    }
    this.face.geometry.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(corners, 3));
    geometry.setAttribute("numbers", new BufferAttribute(numbers, 3));
    geometry.setIndex(new BufferAttribute(index, 1));
    this.face.geometry = geometry;
    this.lines.geometry.dispose();
    this.lines.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(side_ends, 3));
    let length = 0;
    for (let k = 0; k < side_ends.length; k += 6) length += Math.hypot(side_ends[k + 3] - side_ends[k], side_ends[k + 4] - side_ends[k + 1], side_ends[k + 5] - side_ends[k + 2]);
    this.side = length / Math.max(1, side_ends.length / 6);
  }
}

function face_material(uniforms: SharedUniforms): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: { ...uniforms },
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 0.5,
    polygonOffsetUnits: 1,
    vertexShader: /* glsl */ `
      in vec3 numbers;
      flat out vec3 shown;
      void main() {
        shown = numbers;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      precision highp int;
      uniform float pixel_ratio;
      uniform vec3 face_color;
      flat in vec3 shown;
      ${kFieldColors}
      void main() {
        vec3 color = face_color;
        if (map_kind == 2) color = ramp_color(shown.y);
        if (map_kind == 4) color = region_color(int(shown.z + 0.5));
        gl_FragColor = vec4(color, 1.0);
      }`,
  });
}
