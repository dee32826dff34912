// SPDX-License-Identifier: Apache-2.0
// The hooks behind register_typescript.mjs.

import { transform } from "esbuild";
import { readFile } from "node:fs/promises";

export async function load(url, context, next) {
  if (!url.endsWith(".ts")) return next(url, context);
  const source = await readFile(new URL(url), "utf8");
  const { code } = await transform(source, { loader: "ts", format: "esm", sourcemap: "inline" });
  return { format: "module", source: code, shortCircuit: true };
}
