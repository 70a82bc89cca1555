/** The page's own types held against those that the service declares (served.ts): tsc judges it. */
import type * as Page from "../src/contract";
import type * as Served from "./served";

/** Holds where the first type can be read as the second; tsc judges it. */
type Fits<One extends Other, Other> = One;

/** What the page reads, as the service says it; a generated scene has what `null` stands for elsewhere. */
export type Read = [
  Fits<Served.Opening, Page.Opening>,
  Fits<Served.Furniture, Page.Furniture>,
  Fits<Served.Decoration, Page.Decoration>,
  Fits<Served.Level, Page.Level>,
  Fits<Served.Size, Page.Scene["size"]>,
  Fits<Served.Sides, Page.Sides>,
  Fits<Served.Issue, Page.Issue>,
  Fits<Served.Conflict, Page.Conflict>,
  Fits<Served.Lines, Page.ViewAnswer>,
  Fits<Served.FloorAnswer, Page.FloorAnswer>,
  Fits<Served.ProblemDocument, Page.ProblemDocument>,
  Fits<Served.Move, Page.FixAnswer["moves"][number]>,
  Fits<Served.Removal, Page.FixAnswer["removed"][number]>,
  Fits<Served.Solid, Page.CatalogPart>,
  Fits<Served.Material, Page.CatalogMaterial>,
];

/** What the page sends, as the service takes it: no key that is not declared. */
export type Sent = [
  Fits<keyof Page.HouseRequest, keyof Served.Request>,
  Fits<keyof Page.FixRequest, keyof Served.FixBody>,
  Fits<Page.Pose, Served.Pose>,
  Fits<keyof Page.Room, keyof Served.Room>,
  Fits<keyof Page.Furniture, keyof Served.Furniture>,
  Fits<keyof Page.Decoration, keyof Served.Decoration>,
  Fits<keyof Page.Dynamic, keyof Served.Dynamic>,
];
