// A page of the guide: Markdown in, a page out.

import markdown, { type Options, type Renderer, type Token } from "markdown-it";
import anchor from "markdown-it-anchor";

const writer = markdown({ html: true, linkify: false }).use(anchor, { tabIndex: false, slugify });
writer.renderer.rules.link_open = (tokens, i, options, _env, self) => linked(tokens, i, options, self);
writer.renderer.rules.image = (tokens, i, options, env, self) => {
  tokens[i].attrSet("loading", "lazy");
  tokens[i].attrSet("alt", self.renderInlineAsText(tokens[i].children ?? [], options, env));
  return self.renderToken(tokens, i, options);
};

/** Returns the page of a text, whose algorithm may be played; null: there is none. */
export function pageOf(text: string, algorithm: string | null): string {
  const title = /^# (.*)$/m.exec(text)?.[1] ?? "Guide";
  const play = algorithm ? `<a href="../#algorithm=${algorithm}">Play it</a>` : `<a href="../">Theatre</a>`;
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'self'; img-src 'self'; base-uri 'none'; form-action 'none'">
<meta name="color-scheme" content="light dark">
<title>${writer.utils.escapeHtml(title)} – Delone</title>
<link rel="icon" type="image/svg+xml" href="../icon.svg">
<link rel="stylesheet" href="guide.css">
</head>
<body>
<nav aria-label="Guide"><a href="index.html">All algorithms</a> ${play}</nav>
<main>
${writer.render(text)}</main>
</body>
</html>
`;
}

/** Names a heading as sites of repositories do, for which the links are written. */
function slugify(heading: string): string {
  const letters = heading.toLowerCase().replace(/[^\p{L}\p{N}\s_-]/gu, "");
  return letters.trim().replace(/\s/g, "-");
}

/** Sends links to other texts to their pages. */
function linked(tokens: Token[], i: number, options: Options, self: Renderer): string {
  const page = pageAt(tokens[i].attrGet("href") ?? "");
  // A link without an address is plain text.
  tokens[i].attrs = page === null ? [] : [["href", page]];
  return self.renderToken(tokens, i, options);
}

/** Returns the page to which a link leads that is written for a reader of the repository; null: it is none of these. */
export function pageAt(link: string): string | null {
  const [path, place = ""] = link.split(/(?=#)/);
  if (/^[a-z]+:/.test(path) || !path.endsWith(".md")) return link;
  if (path === "../../REFERENCES.md") return `references.html${place}`;
  if (path.includes("/")) return null;
  const page = path === "README.md" ? "index" : path.replace(/\.md$/, "");
  return `${page}.html${place}`;
}
