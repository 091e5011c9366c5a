// Which urdfkit is started.
import assert from "node:assert/strict";
import { chmodSync, mkdtempSync, mkdirSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";
import { test } from "node:test";

import { findCommand } from "../src/command";

/** A folder with a program in it. */
function folder(mode = 0o755): string {
  const path = mkdtempSync(join(tmpdir(), "urdfkit-"));
  writeFileSync(join(path, "urdfkit"), "#!/bin/sh\n");
  chmodSync(join(path, "urdfkit"), mode);
  return path;
}

const nothing = { setting: "", python: undefined, path: "" };

test("the setting goes before the environment, and that before the search path", () => {
  const [first, second] = [folder(), folder()];
  const places = { setting: "/opt/urdfkit", python: join(first, "python"), path: second };
  assert.equal(findCommand(places), "/opt/urdfkit");
  assert.equal(findCommand({ ...places, setting: "" }), join(first, "urdfkit"));
  assert.equal(findCommand({ ...nothing, path: second }), join(second, "urdfkit"));
});

test("an environment without urdfkit is passed over", () => {
  const empty = mkdtempSync(join(tmpdir(), "urdfkit-"));
  const found = folder();
  const places = { ...nothing, python: join(empty, "python"), path: [empty, found].join(delimiter) };
  assert.equal(findCommand(places), join(found, "urdfkit"));
});

test("a program of the workspace is never taken from a relative search path", () => {
  const here = mkdtempSync(join(tmpdir(), "urdfkit-"));
  mkdirSync(join(here, "bin"));
  writeFileSync(join(here, "bin", "urdfkit"), "#!/bin/sh\n", { mode: 0o755 });
  const before = process.cwd();
  process.chdir(here);
  try {
    assert.equal(findCommand({ ...nothing, path: ["", ".", "bin", "./bin"].join(delimiter) }), undefined);
  } finally {
    process.chdir(before);
  }
});

test("what may not be run is not found", () => {
  assert.equal(findCommand({ ...nothing, path: folder(0o644) }), undefined);
});
