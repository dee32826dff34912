// SPDX-License-Identifier: Apache-2.0
// The camera: orbit, zoom and pan by pointer and keys, named views, and flights to places. z is up.

import { Box3, MOUSE, PerspectiveCamera, Sphere, TOUCH, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

import type { Vector } from "../math/frame.ts";

export const kViewNames = ["iso", "front", "back", "left", "right", "top", "bottom"] as const;
export type ViewName = (typeof kViewNames)[number];

// From where each view looks. Straight from above or below `up` would be undefined: a hair to the front.
const kDirections: Record<ViewName, Vector> = {
  iso: [0.62, -1, 0.62],
  front: [0, -1, 0],
  back: [0, 1, 0],
  left: [-1, 0, 0],
  right: [1, 0, 0],
  top: [0, -1e-4, 1],
  bottom: [0, -1e-4, -1],
};

/** Pixels along the sides of the view that controls and legends lie over. */
export interface Covered {
  left: number;
  top: number;
  bottom: number;
}

const kFlightMilliseconds = 450;
// Of a large surface this many points stand for all when it is fitted to the view.
const kFittedPoints = 4000;

export class CameraRig {
  readonly camera = new PerspectiveCamera(28, 1, 0.1, 1000);
  readonly controls: OrbitControls;
  private flight = 0;

  private readonly sphere: Sphere;
  /** Shares of the view's width and height that nothing lies over. */
  private free = { width: 1, height: 1 };

  constructor(box: Box3, private readonly points: Float32Array, element: HTMLElement, private readonly changed: () => void) {
    this.sphere = box.getBoundingSphere(new Sphere());
    const { sphere } = this;
    sphere.radius = Math.max(sphere.radius, 1e-9);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, element);
    this.controls.zoomToCursor = true;
    this.controls.zoomSpeed = 1.4;
    this.controls.rotateSpeed = 0.8;
    this.controls.mouseButtons = { LEFT: MOUSE.ROTATE, MIDDLE: MOUSE.PAN, RIGHT: MOUSE.PAN };
    this.controls.touches = { ONE: TOUCH.ROTATE, TWO: TOUCH.DOLLY_PAN };
    this.controls.minDistance = sphere.radius * 0.01;
    this.controls.maxDistance = sphere.radius * 20;
    this.controls.addEventListener("change", () => this.moved());
    this.controls.addEventListener("start", () => cancelAnimationFrame(this.flight));
  }

  resize(width: number, height: number, { left, top, bottom }: Covered): void {
    // What fitted the view before fits it afterwards: a drawer that opens must not leave the part a dot.
    const offset = this.camera.position.clone().sub(this.controls.target);
    const before = offset.length() > 0 ? this.fitting_distance(offset.clone().normalize()) : 0;
    this.camera.aspect = width / height;
    this.free = { width: Math.max(0.2, 1 - left / width), height: Math.max(0.2, 1 - (top + bottom) / height) };
    this.camera.setViewOffset(width, height, -left / 2, (bottom - top) / 2, width, height);
    if (before > 0) this.zoom(this.fitting_distance(offset.normalize()) / before);
  }

  /** The distance from which the whole surface fits the view, with some room around. */
  private fitting_distance(direction: Vector3): number {
    const half = Math.tan((this.camera.fov * Math.PI) / 360) * 0.92;
    const upwards = half * this.free.height;
    const sideways = half * this.camera.aspect * this.free.width;
    const right = new Vector3().crossVectors(this.camera.up, direction).normalize();
    const up = new Vector3().crossVectors(direction, right);
    let distance = 0;
    const count = this.points.length / 3;
    const stride = Math.max(1, Math.floor(count / kFittedPoints));
    const point = new Vector3();
    for (let k = 0; k < count; k += stride) {
      point.fromArray(this.points, 3 * k).sub(this.sphere.center);
      const across = Math.max(Math.abs(point.dot(right)) / sideways, Math.abs(point.dot(up)) / upwards);
      distance = Math.max(distance, across + point.dot(direction));
    }
    return Math.max(distance, this.controls.minDistance);
  }

  view(name: ViewName, animated: boolean): void {
    this.look_from(kDirections[name], animated);
  }

  look_from(direction: Vector, animated: boolean): void {
    const target = this.sphere.center.clone();
    const toward = new Vector3(...direction).normalize();
    const position = target.clone().addScaledVector(toward, this.fitting_distance(toward));
    this.fly(position, target, animated);
  }

  /** The whole part, from where the camera looks now. */
  fit(animated: boolean): void {
    const direction = this.camera.position.clone().sub(this.controls.target);
    this.look_from(direction.toArray() as Vector, animated);
  }

  /** To a place, near enough to see what is around it. */
  approach(point: Vector, animated: boolean): void {
    const target = new Vector3(...point);
    const direction = this.camera.position.clone().sub(this.controls.target).normalize();
    const distance = Math.min(this.camera.position.distanceTo(this.controls.target), this.fitting_distance(direction) * 0.32);
    this.fly(target.clone().addScaledVector(direction, distance), target, animated);
  }

  /** Turns around the target, in radians. */
  turn(sideways: number, upwards: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    offset.applyAxisAngle(new Vector3(0, 0, 1), sideways);
    const right = new Vector3().crossVectors(offset, this.camera.up).normalize();
    const polar = offset.angleTo(this.camera.up);
    const change = Math.min(Math.PI - 0.02, Math.max(0.02, polar + upwards)) - polar;
    offset.applyAxisAngle(right, -change);
    this.jump(this.controls.target.clone().add(offset), this.controls.target.clone());
  }

  zoom(factor: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
    offset.clampLength(this.controls.minDistance, this.controls.maxDistance);
    this.jump(this.controls.target.clone().add(offset), this.controls.target.clone());
  }

  /** Moves sideways, in shares of the view's height. */
  pan(right: number, up: number): void {
    const height = 2 * this.camera.position.distanceTo(this.controls.target) * Math.tan((this.camera.fov * Math.PI) / 360);
    const shift = new Vector3(right * height, up * height, 0).applyQuaternion(this.camera.quaternion);
    this.jump(this.camera.position.clone().add(shift), this.controls.target.clone().add(shift));
  }

  get direction(): Vector {
    return this.camera.position.clone().sub(this.controls.target).normalize().toArray() as Vector;
  }

  private jump(position: Vector3, target: Vector3): void {
    cancelAnimationFrame(this.flight);
    this.camera.position.copy(position);
    this.controls.target.copy(target);
    this.controls.update();
    this.moved();
  }

  private fly(position: Vector3, target: Vector3, animated: boolean): void {
    const from = this.camera.position.clone().sub(this.controls.target);
    const to = position.clone().sub(target);
    const first_target = this.controls.target.clone();
    if (!animated || matchMedia("(prefers-reduced-motion: reduce)").matches || from.length() === 0) return this.jump(position, target);
    cancelAnimationFrame(this.flight);
    const start = performance.now();
    const step = (now: number): void => {
      const share = Math.min(1, (now - start) / kFlightMilliseconds);
      if (share >= 1) return this.jump(position, target);
      const eased = share * share * (3 - 2 * share);
      // Direction and distance apart: a straight path would pass through the part.
      const length = from.length() * (to.length() / from.length()) ** eased;
      const direction = from.clone().normalize().lerp(to.clone().normalize(), eased);
      if (direction.length() < 1e-3) return this.jump(position, target);
      this.controls.target.lerpVectors(first_target, target, eased);
      this.camera.position.copy(this.controls.target).addScaledVector(direction.normalize(), length);
      this.controls.update();
      this.moved();
      this.flight = requestAnimationFrame(step);
    };
    this.flight = requestAnimationFrame(step);
  }

  private moved(): void {
    // Near and far around the part: as much depth precision as there can be.
    const distance = this.camera.position.distanceTo(this.sphere.center);
    this.camera.near = Math.max(this.sphere.radius * 1e-3, distance - this.sphere.radius * 1.1);
    this.camera.far = distance + this.sphere.radius * 1.1;
    this.camera.updateProjectionMatrix();
    this.changed();
  }
}
