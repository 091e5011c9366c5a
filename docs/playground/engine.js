// What the scripts of the report's 3D view expect around them: three.js, and the words of a page.
import * as three from "three";

globalThis.THREE = three;
globalThis.urdfkit = { word: (text) => text };
