// SPDX-License-Identifier: Apache-2.0
// `node --import ./tests/register_typescript.mjs` lets Node.js 20 import the page's TypeScript: esbuild strips the types.

import { register } from "node:module";

register("./typescript_hooks.mjs", import.meta.url);
