/* The files of a report, and whether a link in one leads anywhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
"use strict";
const fs = require("node:fs");
const path = require("node:path");

/* Folders whose files are not the report's own: api/ has Doxygen's pages. */
const OTHERS = ["source", "style", "api"];

/* Names of the report's files below `folder` that end so, in order; links to folders are followed. */
function filesOf(folder, ending, depth = 3) {
  const found = [];
  const visit = (name, left) => {
    for (const entry of fs.readdirSync(path.join(folder, name)).sort()) {
      const file = path.join(name, entry);
      if (fs.statSync(path.join(folder, file)).isDirectory()) {
        if (left > 1 && !OTHERS.includes(entry)) visit(file, left - 1);
      } else if (entry.endsWith(ending)) found.push(file);
    }
  };
  visit("", depth);
  return found;
}

const known = new Map();
function idsOf(file) {
  if (!known.has(file)) {
    const text = fs.readFileSync(file, "utf8");
    known.set(file, new Set(Array.from(text.matchAll(/\sid="([^"]+)"/g), (match) => match[1])));
  }
  return known.get(file);
}

/* Complaints about the links of a page: every one is to a file that is there, and to a place in it;
 * none is to the network. */
function linksOf(folder, page, hrefs, ids) {
  const complaints = [];
  for (const href of hrefs) {
    if (/^(data|blob):/.test(href)) continue;
    if (/^[a-z]+:/.test(href)) {
      complaints.push(`link out of the report: ${href}`);
      continue;
    }
    const [name, place] = href.split("#").map(decodeURIComponent);
    const file = path.join(folder, path.dirname(page), name);
    if (name !== "" && !fs.existsSync(file)) complaints.push(`broken link: ${href}`);
    else if (name !== "" && fs.statSync(file).isDirectory()) complaints.push(`link to a folder: ${href}`);
    else if (place && !(name === "" ? new Set(ids) : idsOf(file)).has(place))
      complaints.push(`link to a place that is not there: ${href}`);
  }
  return complaints;
}

module.exports = { filesOf, linksOf };
