// What package.json promises is there.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { resolve } from "node:path";
import { test } from "node:test";

const folder = resolve(__dirname, "..");
const manifest = JSON.parse(readFileSync(resolve(folder, "package.json"), "utf8"));
const source = readFileSync(resolve(folder, "src/extension.ts"), "utf8");

test("the files that it contributes exist and are JSON", () => {
  const { languages, grammars } = manifest.contributes;
  for (const path of [languages[0].configuration, grammars[0].path]) {
    assert.ok(existsSync(resolve(folder, path)), path);
    JSON.parse(readFileSync(resolve(folder, path), "utf8"));
  }
});

test("every command is registered and every setting is read", () => {
  for (const { command } of manifest.contributes.commands) {
    assert.ok(source.includes(`registerCommand("${command}"`), command);
  }
  for (const setting of Object.keys(manifest.contributes.configuration.properties)) {
    assert.ok(source.includes(`affectsConfiguration("${setting}")`), setting);
  }
});

test("a workspace cannot choose what is run", () => {
  assert.equal(manifest.contributes.configuration.properties["urdfkit.path"].scope, "machine");
  assert.deepEqual(manifest.capabilities.untrustedWorkspaces.restrictedConfigurations, ["urdfkit.path"]);
});
