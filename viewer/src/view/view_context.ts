// SPDX-License-Identifier: Apache-2.0
// The WebGL 2 context that everything is drawn in.

/** Null where the browser has none. Making a context takes long enough that nothing makes a second one to find out. */
export function view_context(canvas: HTMLCanvasElement): WebGL2RenderingContext | null {
  return canvas.getContext("webgl2", {
    antialias: true,
    depth: true,
    stencil: true, // carries the face of the cut
    alpha: false,
    preserveDrawingBuffer: true, // pictures can be saved and read back at any time
    powerPreference: "high-performance",
  });
}
