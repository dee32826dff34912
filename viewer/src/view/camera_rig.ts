// SPDX-License-Identifier: Apache-2.0
// The camera: orbit, zoom and pan by pointer and keys, named views, and flights to places. Any axis of the
// model may be up: directions are given with z up and turned.

import { Box3, MOUSE, PerspectiveCamera, Sphere, TOUCH, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

import { add, cross, dot, scaled, subtract, unit, type Vector } from "../math/frame.ts";
import type { UpAxis } from "../settings.ts";

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

/** A direction given with z up, in a model with another axis up: the axes keep their cyclic order, and y up has +z in front. */
const kTurned: Record<UpAxis, (direction: Vector) => Vector> = {
  x: ([x, y, z]) => [z, x, y],
  y: ([x, y, z]) => [x, z, -y],
  z: (direction) => direction,
};

/** Pixels along the sides of the view that are not free for the part. */
export interface Covered {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

const kFlightMilliseconds = 450;
// Of a large surface this many points stand for all when it is fitted to the view.
const kFittedPoints = 4000;
// Share of what is free that the part fills in one direction.
const kFilled = 0.92;
// How often the middle of what is seen is moved to the middle of the view: perspective makes each step a little wrong.
const kFitRounds = 6;
// What is approached reaches over this share of what is free, so that what is around it is seen too.
const kApproached = 0.3;
// A cut is looked at from this angle beside its normal, so that frames on it show all their axes.
const kBesideNormal = (28 * Math.PI) / 180;

interface Place {
  position: Vector3;
  target: Vector3;
}

export class CameraRig {
  readonly camera = new PerspectiveCamera(28, 1, 0.1, 1000);
  controls: OrbitControls;
  private flight = 0;
  private up: UpAxis = "z";

  private readonly sphere: Sphere;
  /** Shares of the view's width and height that nothing lies over. */
  private free = { width: 1, height: 1 };

  constructor(box: Box3, private readonly points: Float32Array, private readonly element: HTMLElement, private readonly changed: () => void) {
    this.sphere = box.getBoundingSphere(new Sphere());
    const { sphere } = this;
    sphere.radius = Math.max(sphere.radius, 1e-9);
    this.camera.up.set(0, 0, 1);
    this.controls = this.made_controls();
  }

  private made_controls(): OrbitControls {
    const controls = new OrbitControls(this.camera, this.element);
    controls.zoomToCursor = true;
    controls.zoomSpeed = 1.4;
    controls.rotateSpeed = 0.8;
    controls.mouseButtons = { LEFT: MOUSE.ROTATE, MIDDLE: MOUSE.PAN, RIGHT: MOUSE.PAN };
    controls.touches = { ONE: TOUCH.ROTATE, TWO: TOUCH.DOLLY_PAN };
    controls.minDistance = this.sphere.radius * 0.01;
    controls.maxDistance = this.sphere.radius * 20;
    controls.addEventListener("change", () => this.moved());
    controls.addEventListener("start", () => cancelAnimationFrame(this.flight));
    return controls;
  }

  /** Makes another axis of the model point up; the view stays on what it looks at. */
  set_up(up: UpAxis): void {
    if (up === this.up) return;
    this.up = up;
    const target = this.controls.target.clone();
    this.controls.dispose();
    this.camera.up.set(...kTurned[up]([0, 0, 1]));
    // The controls remember which way was up when they were made.
    this.controls = this.made_controls();
    this.jump(this.camera.position.clone(), target);
  }

  resize(width: number, height: number, { left, right, top, bottom }: Covered): void {
    // What fitted the view before fits it afterwards: a drawer that opens must not leave the part a dot.
    const offset = this.camera.position.clone().sub(this.controls.target);
    const before = offset.length() > 0 ? this.fitting_distance(offset) : 0;
    this.camera.aspect = width / height;
    this.free = { width: Math.max(0.2, 1 - (left + right) / width), height: Math.max(0.2, 1 - (top + bottom) / height) };
    this.camera.setViewOffset(width, height, (right - left) / 2, (bottom - top) / 2, width, height);
    if (before > 0) this.zoom(this.fitting_distance(offset) / before);
  }

  private fitting_distance(offset: Vector3): number {
    const { position, target } = this.fitted(offset.clone().normalize().toArray() as Vector, this.points);
    return position.distanceTo(target);
  }

  /** From where these points fill the view, looking from a direction. */
  private fitted(direction: Vector, points: Float32Array): Place {
    const half = Math.tan((this.camera.fov * Math.PI) / 360) * kFilled;
    const shares = [half * this.camera.aspect * this.free.width, half * this.free.height];
    const right = unit(cross(this.camera.up.toArray() as Vector, direction));
    const axes = [right, cross(direction, right)];
    const stride = 3 * Math.max(1, Math.floor(points.length / 3 / kFittedPoints));
    let middle = this.sphere.center.toArray() as Vector;
    let distance = this.sphere.radius * 4;
    for (let round = 0; round < kFitRounds; ++round) {
      const low = [Infinity, Infinity];
      const high = [-Infinity, -Infinity];
      let nearest = this.controls.minDistance;
      for (let k = 0; k < points.length; k += stride) {
        const at = subtract([points[k], points[k + 1], points[k + 2]], middle);
        const toward = dot(at, direction);
        axes.forEach((axis, m) => {
          // Where it is seen at this distance, and how far away the camera must be to see it.
          const across = dot(at, axis) / Math.max(distance - toward, 1e-9);
          low[m] = Math.min(low[m], across);
          high[m] = Math.max(high[m], across);
          nearest = Math.max(nearest, Math.abs(dot(at, axis)) / shares[m] + toward);
        });
      }
      if (!Number.isFinite(low[0])) break;
      distance = nearest;
      if (round + 1 < kFitRounds) axes.forEach((axis, m) => (middle = add(middle, scaled(axis, ((low[m] + high[m]) / 2) * distance))));
    }
    const target = new Vector3(...middle);
    return { position: target.clone().addScaledVector(new Vector3(...direction), distance), target };
  }

  view(name: ViewName, animated: boolean): void {
    this.look_from(kTurned[this.up](kDirections[name]), animated);
  }

  look_from(direction: Vector, animated: boolean, points = this.points): void {
    const { position, target } = this.fitted(unit(direction), points);
    this.fly(position, target, animated);
  }

  /** Looks at a face with this normal from a little beside it, on the side of the first view. */
  face(normal: Vector, animated: boolean, points = this.points): void {
    const first = unit(kTurned[this.up](kDirections.iso));
    const beside = unit(subtract(first, scaled(normal, dot(first, normal))));
    this.look_from(add(scaled(normal, Math.cos(kBesideNormal)), scaled(beside, Math.sin(kBesideNormal))), animated, points);
  }

  /** The whole part, from where the camera looks now. */
  fit(animated: boolean): void {
    this.look_from(this.direction, animated);
  }

  /** To a place, near enough to see what is around it; `radius` is of what is there, 0 if it is a point. */
  approach(point: Vector, animated: boolean, radius = 0): void {
    const target = new Vector3(...point);
    const direction = this.camera.position.clone().sub(this.controls.target).normalize();
    const distance = radius > 0 ? this.distance_to_show(radius / kApproached)
      : Math.min(this.camera.position.distanceTo(this.controls.target), this.fitting_distance(direction) * 0.32);
    this.fly(target.clone().addScaledVector(direction, distance), target, animated);
  }

  /** From where a ball of this radius fills what is free. */
  private distance_to_show(radius: number): number {
    const share = Math.min(this.free.height, this.camera.aspect * this.free.width);
    return Math.max(this.controls.minDistance, radius / (share * Math.tan((this.camera.fov * Math.PI) / 360)));
  }

  /** Turns around the target, in radians. */
  turn(sideways: number, upwards: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    offset.applyAxisAngle(this.camera.up, sideways);
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

  /** Where the camera is, as numbers for a link. */
  get place(): { position: Vector; target: Vector } {
    return { position: this.camera.position.toArray() as Vector, target: this.controls.target.toArray() as Vector };
  }

  go_to({ position, target }: { position: Vector; target: Vector }): void {
    this.jump(new Vector3(...position), new Vector3(...target));
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
