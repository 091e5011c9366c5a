// Starts the language server, and nothing more: everything else is in it.
import * as vscode from "vscode";
import { LanguageClient } from "vscode-languageclient/node";

import { findCommand } from "./command";

const ROBOTS = "**/*.{urdf,xacro,srdf,launch}";

let client: LanguageClient | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  context.subscriptions.push(
    vscode.commands.registerCommand("urdfkit.restart", start),
    vscode.workspace.onDidGrantWorkspaceTrust(start),
    vscode.workspace.onDidChangeConfiguration((change) => {
      if (change.affectsConfiguration("urdfkit.path")) {
        void start();
      }
    }),
  );
  await start();
}

export async function deactivate(): Promise<void> {
  await client?.stop();
  client = undefined;
}

async function start(): Promise<void> {
  await deactivate();
  const command = findCommand({
    setting: vscode.workspace.getConfiguration("urdfkit").get<string>("path", ""),
    python: vscode.workspace.isTrusted ? await selectedPython() : undefined,
    path: process.env["PATH"] ?? "",
  });
  if (command === undefined) {
    void vscode.window.showWarningMessage(
      'urdfkit is not found. Install it with: pip install "urdfkit[lsp]", or set urdfkit.path.',
    );
    return;
  }
  client = new LanguageClient(
    "urdfkit",
    "urdfkit",
    { command, args: ["lsp"] },
    {
      documentSelector: [
        { language: "urdf" },
        { scheme: "file", language: "xml", pattern: ROBOTS },
        // From a launch file to the robot that it starts.
        { scheme: "file", language: "python", pattern: "**/*launch.py" },
        // Of controllers: what they name leads to the robot, and is renamed with it.
        { scheme: "file", language: "yaml" },
      ],
    },
  );
  await client.start();
}

/** The Python of the environment that the Python extension has selected. */
async function selectedPython(): Promise<string | undefined> {
  const extension = vscode.extensions.getExtension<PythonExtension>("ms-python.python");
  try {
    const python = await extension?.activate();
    const path = python?.environments.getActiveEnvironmentPath().path;
    const found = path && (await python?.environments.resolveEnvironment(path));
    return found ? found.executable.uri?.fsPath : undefined;
  } catch {
    return undefined; // another version of that extension: the search path is left
  }
}

/** What is used of the Python extension. */
interface PythonExtension {
  environments: {
    getActiveEnvironmentPath(): { path: string };
    resolveEnvironment(path: string): Promise<{ executable: { uri?: vscode.Uri } } | undefined>;
  };
}
