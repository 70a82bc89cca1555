/** The keys, told in a dialog. */

function within<T extends HTMLElement>(id: string): T {
  return document.getElementById(id) as T;
}

export class Keys {
  readonly #dialog = within<HTMLDialogElement>("keys_dialog");

  constructor() {
    within("keys").addEventListener("click", () => this.open());
    within("keys_close").addEventListener("click", () => this.#dialog.close());
    // Keys pressed in the dialog are no shortcuts of the page behind it.
    this.#dialog.addEventListener("keydown", (event) => { if (this.#dialog.open) event.stopPropagation(); });
  }

  open(): void {
    if (!this.#dialog.open) this.#dialog.showModal();
  }
}
