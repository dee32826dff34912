// SPDX-License-Identifier: Apache-2.0
// What buttons and keys may ask of the page.

import type { Scene } from "../scene/scene.ts";
import type { CutAxis, SettingsStore, UpAxis } from "../settings.ts";
import type { ViewName } from "../view/camera_rig.ts";
import type { Stage } from "../view/stage.ts";

export interface Commands {
  readonly scene: Scene;
  /** Whether hexahedra follow the field. */
  readonly follows_field: boolean;
  readonly stage: Stage;
  readonly store: SettingsStore;
  view(name: ViewName): void;
  turn_up(up: UpAxis): void;
  cut(on: boolean): void;
  cut_across(axis: CutAxis): void;
  pick_middle(): void;
  visit_next(step: number): void;
  clear(): void;
  copy_link(): Promise<void>;
  save_picture(): Promise<void>;
  help(): void;
  announce(text: string): void;
}
