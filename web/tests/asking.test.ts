// @vitest-environment happy-dom
import { expect, it } from "vitest";
import { Asking } from "../src/asking";
import type { Progress } from "../src/panel/progress";

it("leaves the progress to the newer question, however the older one ends", async () => {
  document.body.innerHTML = '<div><b class="notice-title"></b><i class="notice-detail"></i><form class="notice-key"><input></form><button class="notice-again"></button></div>';
  const told: string[] = [];
  const progress = { start: (what: string) => told.push(what), stop: () => told.push("stop") } as unknown as Progress;
  const asking = new Asking(document.querySelector("div") as HTMLElement, progress);
  let endFirst = (): void => undefined;
  let endSecond = (): void => undefined;
  const first = asking.run("first", () => new Promise((resolve) => { endFirst = resolve; }));
  const second = asking.run("second", () => new Promise((resolve) => { endSecond = resolve; }));
  endFirst();
  await first;
  expect(told).toEqual(["first", "second"]);
  endSecond();
  await second;
  expect(told).toEqual(["first", "second", "stop"]);
});
