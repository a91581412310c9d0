// A preprocessor of mdBook: brings texts of the repository that lie outside of `docs` into the book, and sends links
// there. So pages have the links that work in the repository, and nothing is written twice. What is neither in `docs`
// nor among these texts (sources, licences) is no part of the book: such links become plain text.

import { readFileSync } from "node:fs";
import { join, posix } from "node:path";
import { argv, exit, stdin, stdout } from "node:process";
import { text as allOf } from "node:stream/consumers";

const { dirname, normalize, relative } = posix;

// Every kind of output is supported.
if (argv[2] === "supports") exit(0);

const [context, book] = JSON.parse(await allOf(stdin));
const texts = context.config.preprocessor.outside.texts;
const items = book.items ?? book.sections;

/** Returns where a file of the repository is in the book, where a folder's README is its index; null: nowhere. */
function placeInBook(file) {
  if (texts.includes(file)) return `repository/${file.replace("README", "readme")}`;
  return file.startsWith("docs/") ? file.slice("docs/".length).replace(/README\.md$/, "index.md") : null;
}

/** Blocks of code, code in lines, and links with label and address; whatever begins first. */
const parts = /^```[\s\S]*?^```|`[^`]+`|(!?)\[((?:[^\[\]]|\[[^\]]*\]\([^)]*\))*)\]\(([^)\s]+)\)/gm;

/** Rewrites links of a text, which is `file` in the repository, but for those in code. */
function relinked(text, file) {
  const here = dirname(placeInBook(file));
  return text.replace(parts, (whole, bang, label, link) => {
    if (!link) return whole;
    const inside = label.includes("](") ? relinked(label, file) : label;
    const [path, anchor = ""] = link.split(/(?=#)/);
    if (/^([a-z]+:|#)/.test(link)) return `${bang}[${inside}](${link})`;
    const target = placeInBook(normalize(posix.join(dirname(file), path)).replace(/\/$/, "/README.md"));
    return target === null ? inside : `${bang}[${inside}](${relative(here, target)}${anchor})`;
  });
}

function visit(list) {
  for (const { Chapter: chapter } of list) {
    if (!chapter) continue;
    if (chapter.source_path) chapter.content = relinked(chapter.content, `docs/${chapter.source_path}`);
    visit(chapter.sub_items);
  }
}

/** Makes a chapter of a text outside of `docs`. */
function chapterOf(file) {
  const content = readFileSync(join(context.root, "..", file), "utf8");
  const path = placeInBook(file);
  const name = /^# (.*)$/m.exec(content)[1];
  return {
    Chapter: {
      name,
      content: relinked(content, file),
      number: null,
      sub_items: [],
      path,
      source_path: path,
      parent_names: [],
    },
  };
}

visit(items);
items.push({ PartTitle: "The repository" }, ...texts.map(chapterOf));
stdout.write(JSON.stringify(book));
