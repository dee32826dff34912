// SPDX-License-Identifier: Apache-2.0
// Runs files of tests in one process: what they share, as compiled sources, scenes and the browser, is made once.
//   node --import ./tests/register_typescript.mjs tests/in_one_process.mjs FILE...

import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

const files = process.argv.slice(2);
if (files.length === 0) throw new Error("no file of tests is named");
for (const file of files) await import(pathToFileURL(resolve(file)).href);
