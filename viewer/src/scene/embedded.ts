// SPDX-License-Identifier: Apache-2.0
// The report and the scene that the program wrote into the page's two script elements.

import type { Report } from "./report.ts";
import { decode_scene, type Scene } from "./scene.ts";

const text_of = (id: string): string => document.getElementById(id)?.textContent?.trim() ?? "";

/** The report, or null in a page that no program has filled yet. */
export function embedded_report(): Report | null {
  const text = text_of("crossgrain-report");
  return text.startsWith("{") ? (JSON.parse(text) as Report) : null;
}

/** The scene, or null where the page carries none. */
export function embedded_scene(): Promise<Scene> | null {
  const text = text_of("crossgrain-scene");
  return text === "" || text.startsWith("/*") ? null : unpacked(text);
}

async function unpacked(text: string): Promise<Scene> {
  const bytes = await gunzipped(bytes_of_base64(text));
  // Megabytes of text that nothing reads again.
  document.getElementById("crossgrain-scene")!.textContent = "";
  return decode_scene(bytes);
}

function bytes_of_base64(text: string): Uint8Array<ArrayBuffer> {
  const native = (Uint8Array as unknown as { fromBase64?: (text: string) => Uint8Array<ArrayBuffer> }).fromBase64;
  if (native) return native.call(Uint8Array, text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let k = 0; k < binary.length; ++k) bytes[k] = binary.charCodeAt(k);
  return bytes;
}

async function gunzipped(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
