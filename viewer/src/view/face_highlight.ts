// SPDX-License-Identifier: Apache-2.0
// The face of the model that is picked, as a film over the part.

import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, ShaderMaterial, Vector3 } from "three";

import { triangles_of_face } from "../scene/faces.ts";
import type { Scene } from "../scene/scene.ts";
import { kClip } from "./shader_parts.ts";
import type { SharedUniforms } from "./shared_uniforms.ts";
import { shader_color } from "./view_colors.ts";

export class FaceHighlight {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private shown = 0;

  constructor(private readonly scene: Scene, uniforms: SharedUniforms) {
    this.mesh = new Mesh(new BufferGeometry(), film_material(uniforms));
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
    this.mesh.renderOrder = 13;
  }

  recolor(color: string): void {
    this.mesh.material.uniforms.color.value = shader_color(color);
  }

  /** Shows the face of this number; 0 is none. */
  show(face: number): void {
    this.mesh.visible = face !== 0;
    if (face === 0 || face === this.shown) return;
    this.shown = face;
    this.mesh.geometry.dispose();
    this.mesh.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(triangles_of_face(this.scene, face), 3));
  }
}

function film_material({ cut, clip }: SharedUniforms): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: { cut, clip, color: { value: new Vector3() } },
    side: DoubleSide,
    transparent: true,
    depthWrite: false,
    vertexShader: /* glsl */ `
      out vec3 world_point;
      void main() {
        world_point = position;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 color;
      in vec3 world_point;
      ${kClip}
      void main() {
        clip_at_cut(world_point);
        gl_FragColor = vec4(color, 0.45);
      }`,
  });
}
