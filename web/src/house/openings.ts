/** Openings in house coordinates: both rooms of a door list it, the wall is cut once. */
import type { Opening, OpeningKind, Room, Side } from "../contract";
import type { Axis } from "./boxes";
import { edgesOf, onLattice, type Edge } from "./plan";
import { thick, WallBands } from "./wall_bands";

/** An opening on the middle line of a wall so thick [m]. */
export interface PlacedOpening {
  readonly id: string;
  readonly kind: OpeningKind;
  readonly level: number;
  readonly axis: Axis;
  readonly line: number;
  readonly thickness: number;
  readonly from: number;
  readonly to: number;
  readonly sill: number;
  readonly head: number;
  /** The end the hinge is at: "start" is the west or north one. */
  readonly hinge: "start" | "end";
  /** Towards which side of the line the leaf swings: 1 towards greater coordinates. */
  readonly opensTowards: 1 | -1;
  readonly mainEntrance: boolean;
  /** How far its leaf stands open in the scene, 0 to 1. */
  readonly open?: number;
}

const NEGLIGIBLE = 1e-6;

/** Where an opening is: the edge it lies on, and where on its line positions are counted from [m]. */
interface Spot {
  readonly edge: Edge;
  readonly start: number;
}

function spotOf(room: Room, edges: readonly Edge[], opening: Opening): Spot | null {
  const named = opening.edge !== null && opening.edge !== undefined ? edges[opening.edge] : undefined;
  if (named) return { edge: named, start: named.from };
  return opening.wall && (opening.edge ?? null) === null ? onWall(room, edges, opening.wall, opening.position) : null;
}

/** The outermost edge of a wall at a position, or else the line of the room's rectangle. */
function onWall(room: Room, edges: readonly Edge[], wall: Side, position: number): Spot {
  const [rectangle] = edgesOf({ ...room, outline: null }).filter((edge) => edge.side === wall) as [Edge];
  const [start, line] = [rectangle.from, rectangle.line];
  const here = edges.filter(({ side, from, to }) => (
    side === wall && from <= start + position + NEGLIGIBLE && start + position <= to + NEGLIGIBLE
  ));
  const [outermost] = here.sort((a, b) => Math.abs(a.line - line) - Math.abs(b.line - line));
  return { edge: outermost ?? rectangle, start };
}

function place({ edge, start }: Spot, opening: Opening, id: string, bands: WallBands | null): PlacedOpening {
  const outward = edge.inward === 1 ? -1 : 1;
  const centre = start + opening.position;
  const wall = bands?.at(edge, centre) ?? { line: edge.line, thickness: 0 };
  return {
    id,
    kind: opening.kind,
    level: edge.level,
    axis: edge.axis,
    line: wall.line,
    thickness: thick(wall.thickness),
    from: onLattice(centre - opening.width / 2),
    to: onLattice(centre + opening.width / 2),
    sill: opening.kind === "window" ? (opening.sill ?? 0) : 0,
    head: (opening.kind === "window" ? (opening.sill ?? 0) : 0) + opening.height,
    hinge: opening.hinge ?? "start",
    opensTowards: opening.swing === "out" ? outward : edge.inward,
    mainEntrance: opening.main_entrance === true,
    open: Math.min(1, Math.max(0, opening.open ?? 0)),
  };
}

/**
 * Every opening of a house once. Of the entries under one id the one that draws the leaf is kept:
 * hinge and swing are told from its room. `thickness` is the scene's [m]; with null they
 * lie on the line of the room that draws them, not in the middle of its wall.
 */
export function openingsOf(rooms: readonly Room[], thickness: number | null): PlacedOpening[] {
  const bands = thickness === null ? null : new WallBands(rooms, thickness);
  const kept = new Map<string, { placed: PlacedOpening; drawsLeaf: boolean }>();
  for (const room of rooms) {
    const edges = edgesOf(room);
    for (const [i, opening] of room.openings.entries()) {
      const spot = spotOf(room, edges, opening);
      if (!spot) continue;
      const id = opening.id ?? `${room.id}/opening_${i}`;
      const drawsLeaf = opening.render_panel !== false;
      if (!kept.has(id) || (drawsLeaf && !kept.get(id)?.drawsLeaf)) kept.set(id, { placed: place(spot, opening, id, bands), drawsLeaf });
    }
  }
  return [...kept.values()].map((entry) => entry.placed);
}
