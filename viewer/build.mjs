// SPDX-License-Identifier: Apache-2.0
// Makes dist/report.html, the page that the program fills with a report and a scene: one file, nothing loaded from elsewhere.
//   node build.mjs           writes it
//   node build.mjs --check   fails where it is not what the sources give

import { build, transform } from "esbuild";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const output = here("dist/report.html");

/** The whole page as text. */
export async function page() {
  const bundle = await build({
    entryPoints: [here("src/main.ts")],
    bundle: true,
    minify: true,
    format: "iife",
    target: "es2022",
    charset: "utf8",
    legalComments: "eof", // the licence of three.js stays in the page
    write: false,
  });
  const style = await transform(await readFile(here("src/page.css"), "utf8"), { loader: "css", minify: true });
  const template = await readFile(here("src/page.html"), "utf8");
  // Replacements as functions: `$` in the script is no pattern. `</script` cannot stand in a script element.
  const script = bundle.outputFiles[0].text.replaceAll("</script", "<\\/script");
  return template.replace("/*STYLE*/", () => style.code.trim()).replace("/*SCRIPT*/", () => script.trim());
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const text = await page();
  for (const placeholder of ["/*REPORT*/", "/*SCENE*/"]) {
    if (text.split(placeholder).length !== 2) throw new Error(`${placeholder} must stand in the page exactly once`);
  }
  if (process.argv.includes("--check")) {
    const written = await readFile(output, "utf8").catch(() => "");
    if (written !== text) {
      console.error("dist/report.html is not what src/ gives: run `npm run build` in viewer/");
      process.exit(1);
    }
  } else {
    await mkdir(here("dist"), { recursive: true });
    await writeFile(output, text);
    console.log(`dist/report.html: ${(text.length / 1000).toFixed(0)} kB`);
  }
}
