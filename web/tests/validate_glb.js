/** Judges .glb files with Khronos' validator: `node validate_glb.js REPORT FILE...` writes what it finds, a list of its reports. */
import { readFileSync, writeFileSync } from "node:fs";
import { validateBytes } from "gltf-validator";

const [report, ...files] = process.argv.slice(2);
const reports = [];
for (const file of files) reports.push(await validateBytes(new Uint8Array(readFileSync(file)), { maxIssues: 20 }));
writeFileSync(report, JSON.stringify(reports));
