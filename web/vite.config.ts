import { defineConfig } from "vitest/config";
import { leanThree } from "./lean_three";

/** Where the service looks for the built page: git-ignored, packed into the wheel. */
const STATIC_DIRECTORY = "../service/static";

/** For `npm run dev`: the running service that answers the page's calls. */
const SERVICE = "http://127.0.0.1:8000";
const CALLS = [
  "/generate", "/furnish", "/import", "/fix", "/place", "/explain", "/drag", "/core.wasm", "/validate", "/view", "/floor", "/export", "/catalog", "/asset", "/schema",
  "/healthz", "/homes",
];

const GUARD_MS = 600_000;

export default defineConfig({
  base: "./",
  plugins: [leanThree()],
  build: {
    outDir: STATIC_DIRECTORY,
    emptyOutDir: true,
    rolldownOptions: { input: ["index.html", "embed.html"] },
    target: "es2022",
    cssTarget: ["chrome123", "firefox120", "safari17.5"], // those that know light-dark()
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 900,
  },
  server: { proxy: Object.fromEntries(CALLS.map((call) => [call, SERVICE])) },
  // No test is about time: the limits are guards against one that never ends. All files share a process: starting many takes longer.
  test: { include: ["tests/**/*.test.ts"], environment: "node", isolate: false, testTimeout: GUARD_MS, hookTimeout: GUARD_MS, teardownTimeout: GUARD_MS },
});
