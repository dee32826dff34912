// SPDX-License-Identifier: Apache-2.0
// The face of the cut: a plane as large as the part, drawn where the part is, coloured by the cell at each pixel, with the cells' edges.
//
// Where the surface is closed the stencil buffer says where the part is: faces of the kept half that look away count up, those that look
// at the camera count down, and what is left over one is seen through the cut. This follows the surface exactly, walls thinner than a
// cell too. A surface with holes would bleed; there the cells themselves say where the part is.

import {
  AlwaysStencilFunc, BackSide, DecrementWrapStencilOp, DoubleSide, FrontSide, Group, IncrementWrapStencilOp, KeepStencilOp, Mesh,
  NotEqualStencilFunc, PlaneGeometry, ShaderMaterial, Vector3, type BufferGeometry, type Side,
} from "three";

import { tangents_of, type Vector } from "../math/frame.ts";
import type { Scene } from "../scene/scene.ts";
import { kClip, kFieldLookup } from "./shader_parts.ts";
import type { SharedUniforms } from "./shared_uniforms.ts";

export class CutFace {
  readonly group = new Group();
  readonly line_color = { value: new Vector3() };
  private readonly face: Mesh<PlaneGeometry, ShaderMaterial>;
  private readonly show_cells = { value: true };
  private readonly middle: Vector3;

  constructor(scene: Scene, uniforms: SharedUniforms, surface: BufferGeometry, closed: boolean) {
    const low = new Vector3(...scene.low);
    const high = new Vector3(...scene.high);
    this.middle = low.clone().add(high).multiplyScalar(0.5);
    const size = low.distanceTo(high) * 1.02;
    if (closed) {
      for (const [side, order] of [[BackSide, -2], [FrontSide, -1]] as const) {
        const mesh = new Mesh(surface, stencil_material(uniforms, side));
        mesh.renderOrder = order;
        this.group.add(mesh);
      }
    }
    this.face = new Mesh(new PlaneGeometry(size, size), face_material(uniforms, this.line_color, this.show_cells, closed));
    this.face.renderOrder = 1;
    this.group.add(this.face);
  }

  place(normal: Vector, offset: number): void {
    const direction = new Vector3(...normal);
    const [first, second] = tangents_of(normal);
    const center = this.middle.clone().addScaledVector(direction, offset - this.middle.dot(direction));
    this.face.matrixAutoUpdate = false;
    this.face.matrix.makeBasis(new Vector3(...first), new Vector3(...second), direction).setPosition(center);
    this.face.matrixWorldNeedsUpdate = true;
  }

  show(visible: boolean, cells: boolean): void {
    this.group.visible = visible;
    this.show_cells.value = cells;
  }
}

function stencil_material(uniforms: SharedUniforms, side: Side): ShaderMaterial {
  const operation = side === BackSide ? IncrementWrapStencilOp : DecrementWrapStencilOp;
  return new ShaderMaterial({
    uniforms: { cut: uniforms.cut },
    side,
    colorWrite: false,
    depthWrite: false,
    depthTest: false,
    stencilWrite: true,
    stencilFunc: AlwaysStencilFunc,
    stencilFail: operation,
    stencilZFail: operation,
    stencilZPass: operation,
    vertexShader: /* glsl */ `
      out vec3 world_point;
      void main() {
        world_point = position;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      uniform vec4 cut;
      in vec3 world_point;
      void main() {
        if (dot(cut.xyz, world_point) > cut.w) discard;
        gl_FragColor = vec4(0.0);
      }`,
  });
}

function face_material(
  uniforms: SharedUniforms, line_color: { value: Vector3 }, show_cells: { value: boolean }, closed: boolean,
): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: { ...uniforms, line_color, show_cells, face_color: uniforms.face_color },
    side: DoubleSide,
    stencilWrite: closed,
    stencilRef: 0,
    stencilFunc: NotEqualStencilFunc,
    stencilFail: KeepStencilOp,
    stencilZFail: KeepStencilOp,
    stencilZPass: KeepStencilOp,
    polygonOffset: true,
    polygonOffsetFactor: 0.5,
    polygonOffsetUnits: 1,
    vertexShader: /* glsl */ `
      out vec3 world_point;
      void main() {
        vec4 world = modelMatrix * vec4(position, 1.0);
        world_point = world.xyz;
        gl_Position = projectionMatrix * viewMatrix * world;
      }`,
    fragmentShader: /* glsl */ `
      precision highp int;
      uniform float pixel_ratio;
      uniform vec3 line_color;
      uniform vec3 face_color;
      uniform bool show_cells;
      in vec3 world_point;
      ${kClip}${kFieldLookup}
      void main() {
        vec3 at = (world_point - lattice_low) / lattice_unit;
        // On a face between cells rounding would choose a side pixel by pixel: the kept side it is.
        vec3 sample_at = at - 1e-3 * cut.xyz;
        vec3 across = vec3(length(vec2(dFdx(at.x), dFdy(at.x))), length(vec2(dFdx(at.y), dFdy(at.y))), length(vec2(dFdx(at.z), dFdy(at.z))));
        Cell cell = cell_at(sample_at);
        if (cell.number < 0) {
          ${closed ? "gl_FragColor = vec4(map_kind <= 1 ? face_color : void_color, 1.0); return;" : "discard;"}
        }
        vec3 color = map_kind == 0 || map_kind == 1 ? face_color : field_color(cell, sample_at);
        if (show_cells) {
          // Distance to the cell's nearest side, in pixels along the cut; sides that the cut runs along do not count.
          vec3 to_side = min(at - cell.low, cell.low + cell.side - at);
          vec3 pixels = mix(vec3(1e6), to_side / max(across, vec3(1e-9)), step(vec3(1e-6), across));
          float nearest = min(pixels.x, min(pixels.y, pixels.z)) / pixel_ratio;
          float size = cell.side / max(across.x, max(across.y, across.z)) / pixel_ratio;
          // Lines fade before the cells become a grey mass.
          float strength = 0.26 * smoothstep(3.0, 12.0, size);
          color = mix(color, line_color, strength * (1.0 - smoothstep(0.25, 0.85, nearest)));
        }
        gl_FragColor = vec4(color, 1.0);
      }`,
  });
}
