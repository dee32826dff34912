// SPDX-License-Identifier: Apache-2.0
// Singular lines and their marks are drawn as they are, faintly where the cut or an opaque part hides them, and more faintly in the half
// that is taken away.

import { GreaterDepth, LessEqualDepth, type DepthModes } from "three";

export const kPasses = ["plain", "hidden", "taken"] as const;
export type Pass = (typeof kPasses)[number];

const kAlpha: Record<Pass, string> = { plain: "1.0", hidden: "0.36", taken: "0.2" };

export const pass_state = (pass: Pass): { transparent: boolean; depthWrite: boolean; depthFunc: DepthModes } =>
  ({ transparent: pass !== "plain", depthWrite: pass === "plain", depthFunc: pass === "hidden" ? GreaterDepth : LessEqualDepth });

/** Leaves to each pass its half. */
export const pass_test = (pass: Pass): string => `if (${pass === "taken" ? "!" : ""}is_taken(world_point)) discard;`;

export const pass_output = (pass: Pass, color: string): string => `vec4(${color}, ${kAlpha[pass]})`;
