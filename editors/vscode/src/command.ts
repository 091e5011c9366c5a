// Which urdfkit to start. Without the editor, so that it can be tested without one.
import { accessSync, constants } from "node:fs";
import { delimiter, dirname, join } from "node:path";

/** Where a urdfkit may be. */
export interface Places {
  /** The setting; empty if it is not set. */
  setting: string;
  /** The Python of the environment that is selected; undefined if none is, or it is not trusted. */
  python: string | undefined;
  /** The search path. */
  path: string;
}

const NAMES = process.platform === "win32" ? ["urdfkit.exe"] : ["urdfkit"];

/** The program to start, or undefined if there is none. A setting is taken at its word. */
export function findCommand(places: Places): string | undefined {
  if (places.setting) {
    return places.setting;
  }
  const folders = places.python ? [dirname(places.python)] : [];
  // Only absolute folders: "." would be whatever the workspace holds.
  folders.push(...places.path.split(delimiter).filter((folder) => /^([/\\]|[A-Za-z]:)/.test(folder)));
  for (const folder of folders) {
    for (const name of NAMES) {
      const file = join(folder, name);
      if (isExecutable(file)) {
        return file;
      }
    }
  }
  return undefined;
}

function isExecutable(file: string): boolean {
  try {
    accessSync(file, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}
