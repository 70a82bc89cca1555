/** What a person chose about the page itself, remembered in this browser: its colours, which side panels and which groups are folded away. */

const PREFIX = "compose.";
/** Below it a window leaves too little for the house beside both panels: the text starts folded. */
const LAPTOP = "(width < 1500px)";
const COLOURS = ["light", "dark"];
const PANELS = ["controls", "reading"] as const;
/** The groups that few begin with. */
const LATER = ["home", "furnishing", "view", "files"];

export type Panel = (typeof PANELS)[number];

/** What was chosen under a name; null where nothing was. */
export function remembered(name: string, where: "localStorage" | "sessionStorage" = "localStorage"): string | null {
  try {
    return globalThis[where].getItem(PREFIX + name);
  } catch {
    return null; // a browser that keeps nothing
  }
}

/** Keeps what was chosen under a name. */
export function remember(name: string, value: string, where: "localStorage" | "sessionStorage" = "localStorage"): void {
  try {
    globalThis[where].setItem(PREFIX + name, value);
  } catch {
    // it holds until the page is left
  }
}

function tell(panel: Panel, isFolded: boolean): void {
  document.body.classList.toggle(`${panel}-folded`, isFolded);
  document.getElementById(`fold_${panel}`)?.setAttribute("aria-expanded", String(!isFolded));
}

/** Folds a side panel away, or shows it; where the window is narrow both stand below the house and none is folded. */
export function fold(panel: Panel, isFolded: boolean): void {
  remember(panel, isFolded ? "folded" : "shown");
  tell(panel, isFolded);
}

function paint(colours: string): void {
  if (COLOURS.includes(colours)) document.documentElement.dataset.colours = colours;
  else delete document.documentElement.dataset.colours;
}

/** Makes the page as it was left, and listens to what changes it. */
export function listenToPreferences(): void {
  const byDefault = { controls: "shown", reading: window.matchMedia(LAPTOP).matches ? "folded" : "shown" };
  for (const panel of PANELS) {
    tell(panel, (remembered(panel) ?? byDefault[panel]) === "folded");
    document.getElementById(`fold_${panel}`)?.addEventListener("click", () => fold(panel, !document.body.classList.contains(`${panel}-folded`)));
  }
  for (const id of LATER) {
    const group = document.getElementById(id) as HTMLDetailsElement;
    group.open = remembered(id) === "shown";
    group.querySelector("summary")?.addEventListener("click", () => remember(id, group.open ? "folded" : "shown"));
  }
  const choice = document.getElementById("colours") as HTMLSelectElement;
  const colours = remembered("colours") ?? "";
  paint(colours);
  choice.value = COLOURS.includes(colours) ? colours : "";
  choice.addEventListener("change", () => {
    remember("colours", choice.value);
    paint(choice.value);
  });
}
