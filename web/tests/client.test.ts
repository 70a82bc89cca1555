/** The TypeScript client: what it sends, what it makes of answers and refusals. */
import { describe, expect, it } from "vitest";
import { Client, ServiceRefusal, type HomeHead, type Scene } from "../client/index";

interface Sent {
  readonly url: string;
  readonly method: string;
  readonly headers: Readonly<Record<string, string>>;
  readonly body: string | null;
}

function answering(...answers: readonly Response[]): { readonly client: Client; readonly sent: Sent[] } {
  const sent: Sent[] = [];
  const left = [...answers];
  const ask = async (url: URL, init: RequestInit): Promise<Response> => {
    sent.push({ url: String(url), method: init.method ?? "", headers: init.headers as Record<string, string>, body: init.body as string | null });
    return left.shift() as Response;
  };
  return { client: new Client("http://homes.example/base", { key: "a-key", fetch: ask as typeof fetch }), sent };
}

const HEAD = { id: "a-b", revision: 3 } as HomeHead;

describe("the client", () => {
  it("sends a call with the key and reads its answer", async () => {
    const { client, sent } = answering(Response.json({ scene: { seed: 3 }, issues: [], timing_ms: {} }));
    expect((await client.generate({ seed: 3, program: "studio" })).scene.seed).toBe(3);
    expect(sent[0]).toMatchObject({ url: "http://homes.example/base/generate", method: "POST", body: '{"seed":3,"program":"studio"}' });
    expect(sent[0]?.headers).toMatchObject({ "X-API-Key": "a-key", "Content-Type": "application/json" });
  });

  it("names the revision of a home that it changes or removes", async () => {
    const { client, sent } = answering(Response.json(HEAD), new Response(null, { status: 204 }));
    await client.changeHome(HEAD, { name: "<b>" });
    await client.removeHome(HEAD);
    expect(sent.map(({ method, headers }) => [method, headers["If-Match"]])).toEqual([["PATCH", '"3"'], ["DELETE", '"3"']]);
  });

  it("restyles a home, and reads the catalog", async () => {
    const { client, sent } = answering(Response.json({ scene: {}, issues: [], timing_ms: {} }), Response.json({ styles: {} }));
    await client.restyle({ rooms: [] } as unknown as Scene, { style: "rustic", decorate: true });
    expect(await client.catalog()).toEqual({ styles: {} });
    expect(sent.map(({ method, url, body }) => [method, url.slice("http://homes.example/base/".length), body])).toEqual([
      ["POST", "generate", '{"scene":{"rooms":[]},"style":"rustic","decorate":true}'], ["GET", "catalog", null],
    ]);
  });

  it("asks for pages by words and tags", async () => {
    const { client, sent } = answering(Response.json({ homes: [], total: 0, after: null }));
    await client.listHomes({ search: "a b", tags: ["x&y", "z"], after: "1-a" });
    expect(sent[0]?.url).toBe("http://homes.example/base/homes?tag=x%26y&tag=z&search=a+b&after=1-a");
  });

  it("follows a job until its events end", async () => {
    const head = (done: number): string => JSON.stringify({ id: "j", done, count: 2 });
    const pieces = [`event: progress\ndata: ${head(0)}\n\n: still`, ` there\n\nevent: progress\nda`, `ta: ${head(1)}\n\nevent: done\ndata: ${head(2)}\n\n`, "event: removed\ndata: {}\n\n"];
    const stream = new ReadableStream({ start(to) { for (const piece of pieces) to.enqueue(new TextEncoder().encode(piece)); to.close(); } });
    const { client, sent } = answering(Response.json({ id: "j" }, { status: 202 }), new Response(stream), Response.json({ issues: [] }), new Response(null, { status: 204 }));
    expect((await client.addJob({ call: "generate", seeds: [1, 2] })).id).toBe("j");
    const done: number[] = [];
    for await (const told of client.followJob("j")) done.push(told.done);
    expect(done).toEqual([0, 1, 2]);
    expect(await client.jobResult("j", 1)).toEqual({ issues: [] });
    await client.removeJob("j");
    expect(sent.map(({ method, url }) => `${method} ${url.slice("http://homes.example/base/".length)}`)).toEqual(["POST jobs", "GET jobs/j/events", "GET jobs/j/results/1", "DELETE jobs/j"]);
  });

  it("throws refusals in the service's words, and asks a busy service again", async () => {
    const problem = { title: "A field is wrong", detail: "seed: is -1", errors: [{ field: "seed", problem: "is -1", allowed: "0" }] };
    const busy = (): Response => Response.json({}, { status: 503, headers: { "Retry-After": "0" } });
    const { client, sent } = answering(busy(), busy(), Response.json(problem, { status: 422 }), busy(), busy(), busy());
    const refused = await client.generate({ seed: -1 }).catch((reason: unknown) => reason);
    expect(refused).toBeInstanceOf(ServiceRefusal);
    expect(refused).toMatchObject({ status: 422, title: "A field is wrong", errors: problem.errors });
    await expect(client.generate()).rejects.toMatchObject({ status: 503, retryAfter: 0 });
    expect(sent.length).toBe(6);
  });
});
