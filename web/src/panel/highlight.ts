/** Highlighting of the readable YAML: a line becomes tokens that, joined, are the line again. Pure. */

export type TokenKind = "comment" | "key" | "punctuation" | "number" | "text" | "space";

export interface Token {
  readonly kind: TokenKind;
  readonly text: string;
}

const KEY = /^("[^"]*"|'[^']*'|[^\s#:,[\]{}"'][^:#]*?)(:)(?=\s|$)/;
const VALUE = /(\s+)|([[\]{},]|↔|→)|("[^"]*"|'[^']*')|([^\s[\]{},]+)/gy;
const NUMBER = /^[-+]?[\d.]+(?:[×x%a-zA-Z²°][\d.×a-zA-Z²°]*)?$/;

/** Where a comment starts: a # at the line's start or after a space. */
function commentStart(line: string): number {
  const match = /(^|\s)#/.exec(line);
  return match ? match.index + (match[1]?.length ?? 0) : line.length;
}

function valueTokens(text: string): Token[] {
  return [...text.matchAll(VALUE)].map(([all, space, mark]): Token => {
    if (space !== undefined) return { kind: "space", text: all };
    if (mark !== undefined || all === "×") return { kind: "punctuation", text: all };
    return { kind: NUMBER.test(all) ? "number" : "text", text: all };
  });
}

function contentTokens(content: string): Token[] {
  const lead = /^\s*/.exec(content)?.[0] ?? "";
  const dash = /^(?:-\s+|-$)/.exec(content.slice(lead.length))?.[0] ?? "";
  const rest = content.slice(lead.length + dash.length);
  const key = KEY.exec(rest);
  const tokens: Token[] = [
    { kind: "space", text: lead },
    { kind: "punctuation", text: dash },
    { kind: "key", text: key?.[1] ?? "" },
    { kind: "punctuation", text: key?.[2] ?? "" },
    ...valueTokens(rest.slice(key?.[0].length ?? 0)),
  ];
  return tokens.filter((token) => token.text !== "");
}

/** Splits one line of readable YAML into tokens. */
export function tokensOf(line: string): Token[] {
  const start = commentStart(line);
  const comment = line.slice(start);
  const tokens = contentTokens(line.slice(0, start));
  return comment ? [...tokens, { kind: "comment", text: comment }] : tokens;
}

/** Appends a line's tokens to an element as text nodes in spans; nothing of the line is ever read as markup. */
export function writeHighlighted(line: string, into: HTMLElement): void {
  for (const { kind, text } of tokensOf(line)) {
    if (kind === "space" || kind === "text") {
      into.append(text);
      continue;
    }
    const span = document.createElement("span");
    span.className = `yaml-${kind}`;
    span.textContent = text;
    into.append(span);
  }
}
