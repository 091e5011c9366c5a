// A session of the bundle's own client library with the real server, without an editor.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

import { StreamMessageReader, StreamMessageWriter, createMessageConnection } from "vscode-jsonrpc/node";

import { findCommand } from "../src/command";

const ROBOT = resolve(__dirname, "../../../models/gazebo_pkg/urdf/waking_robot_new.xacro");
const command = process.env["URDFKIT"] || findCommand({ setting: "", python: undefined, path: process.env["PATH"] ?? "" });

interface Published {
  uri: string;
  diagnostics: { code: string; range: { start: { line: number } } }[];
}

test("the server tells what is wrong with a robot", { skip: command ? false : "there is no urdfkit" }, async () => {
  const server = spawn(command!, ["lsp"], { stdio: ["pipe", "pipe", "inherit"] });
  const connection = createMessageConnection(
    new StreamMessageReader(server.stdout),
    new StreamMessageWriter(server.stdin),
  );
  const published = new Promise<Published>((done) =>
    connection.onNotification("textDocument/publishDiagnostics", done),
  );
  connection.listen();
  const { capabilities } = await connection.sendRequest<{ capabilities: Record<string, unknown> }>("initialize", {
    processId: process.pid,
    rootUri: null,
    capabilities: {},
  });
  for (const wanted of ["hoverProvider", "completionProvider", "renameProvider", "codeActionProvider"]) {
    assert.ok(capabilities[wanted], wanted);
  }
  await connection.sendNotification("initialized", {});
  const uri = pathToFileURL(ROBOT).href;
  const textDocument = { uri, languageId: "urdf", version: 1, text: readFileSync(ROBOT, "utf8") };
  await connection.sendNotification("textDocument/didOpen", { textDocument });
  const { uri: told, diagnostics } = await published;
  assert.equal(told, uri);
  const missing = diagnostics.find((one) => one.code === "MSH001");
  assert.equal(missing?.range.start.line, 265);
  await connection.sendRequest("shutdown");
  await connection.sendNotification("exit");
  const code = await new Promise((done) => server.on("exit", done));
  assert.equal(code, 0);
  connection.dispose();
});
