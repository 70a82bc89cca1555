/** How often to repeat something: `some` times; in `make targets`, as often as `everything` says. */
export const times = (everything: number, some: number): number => (process.env.SWEEPS === "all" ? everything : some);
