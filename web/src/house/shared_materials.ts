/** Materials that outlive a house. With a house's last material of a kind its shader would go too, and be made anew for the next. */
import type { Material } from "three";

const made = new Map<string, Material>();

/** The material of this name, made once for the life of the page; `disposeOf` leaves it alone. */
export function sharedMaterial<Kind extends Material>(name: string, make: () => Kind): Kind {
  const material = (made.get(name) as Kind | undefined) ?? make();
  material.userData.kept = true;
  made.set(name, material);
  return material;
}
