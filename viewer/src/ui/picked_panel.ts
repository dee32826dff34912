// SPDX-License-Identifier: Apache-2.0
// The panel with what is picked: a tet, cell or hexahedron, and the face of the model that it was picked on.

import type { Theme } from "../math/color_maps.ts";
import type { Vector } from "../math/frame.ts";
import type { Degree } from "../math/harmonics.ts";
import type { ModelFace } from "../scene/faces.ts";
import type { Report } from "../scene/report.ts";
import { element_center } from "../scene/scene.ts";
import type { Settings } from "../settings.ts";
import type { Stage } from "../view/stage.ts";
import { describe_element, show_cell, show_no_cell, title_of, type CellPanel } from "./cell_panel.ts";
import { by_id } from "./dom.ts";
import { face_block, noun_of } from "./face_table.ts";
import { describe_hexahedron, hexahedron_title, show_hexahedron, type HexDescription } from "./hex_panel.ts";
import type { Tabs } from "./tabs.ts";

export interface PickedActions {
  show_hexahedron(hexahedron: number): void;
  show_face(face: number): void;
  clear(): void;
}

export class PickedPanel {
  private readonly panel = by_id("panel-cell");
  private cell_panel: CellPanel | null = null;
  private shown = "";

  constructor(private readonly report: Report, private readonly faces: ModelFace[], private readonly stage: Stage, private readonly tabs: Tabs, private readonly actions: PickedActions) {}

  private get degree(): Degree {
    return this.report.degree === 3 ? 3 : 4;
  }

  describe(element: number): ReturnType<typeof describe_element> {
    return describe_element(this.stage.field.scene, element, this.degree);
  }

  describe_hexahedron(hexahedron: number): HexDescription {
    return describe_hexahedron(this.stage.field.scene, this.stage.field.hexahedra!, hexahedron);
  }

  /** What the report says of the face of a number. */
  face(number: number): ModelFace {
    return this.faces.find((face) => face.number === number) ?? { number, kind: null, area: null, center: null, quads: null };
  }

  show({ picked, hexahedron, face, field }: Settings, theme: Theme): void {
    const key = JSON.stringify([picked, hexahedron, face?.number, field]);
    if (key !== this.shown) {
      this.shown = key;
      this.fill(picked, this.stage.field.hexahedra ? hexahedron : -1, face?.number ?? 0);
    }
    this.draw_plot(theme);
  }

  private fill(cell: number, hexahedron: number, face: number): void {
    const { scene } = this.stage.field;
    const { unit } = scene;
    const close = (): void => this.actions.clear();
    this.cell_panel = null;
    let title = scene.hexahedra ? "Hexahedron" : scene.tets ? "Tet" : "Cell";
    if (hexahedron >= 0) {
      const described = this.describe_hexahedron(hexahedron);
      title = hexahedron_title(described);
      show_hexahedron(this.panel, described, unit, { go: () => this.actions.show_hexahedron(hexahedron), close });
    } else if (cell >= 0) {
      title = title_of(scene, cell);
      const center: Vector = element_center(scene, cell);
      this.cell_panel = show_cell(this.panel, this.describe(cell), unit, { go: () => this.stage.rig.approach(center, true), close });
    } else if (face === 0) show_no_cell(this.panel, scene.hexahedra !== null);
    else this.panel.replaceChildren();
    if (face !== 0) {
      const alone = hexahedron < 0 && cell < 0;
      if (alone) title = `${noun_of(this.face(face).kind)} ${face}`;
      const block = face_block(this.face(face), this.report, unit, { go: () => this.actions.show_face(face), close: alone ? close : null });
      // Where a cell has much to say, the face that was clicked comes first.
      if (this.cell_panel) this.panel.prepend(block);
      else this.panel.append(block);
    }
    this.tabs.rename("cell", title);
  }

  /** Draws the harmonic of the picked cell as the camera sees it. */
  draw_plot(theme: Theme): void {
    if (!this.cell_panel || this.panel.hidden) return;
    const { camera } = this.stage.rig;
    camera.updateMatrixWorld();
    const e = camera.matrixWorld.elements;
    const column = (k: number): Vector => [e[4 * k], e[4 * k + 1], e[4 * k + 2]];
    this.cell_panel.plot.draw(this.cell_panel.canvas, column(0), column(1), column(2), theme);
  }
}
