/** Prints the plan to scale: the service's sheet alone on the paper, in its own millimetres. */

/** Shows a sheet to the printer, and leaves the page as it was. */
export async function printSheet(svg: string, image: HTMLImageElement, print = (): void => window.print()): Promise<void> {
  const url = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  image.src = url;
  try {
    await image.decode();
    image.hidden = false;
    print();
  } finally {
    image.hidden = true;
    image.removeAttribute("src");
    URL.revokeObjectURL(url);
  }
}
