/* What is checked within a page: the text of these functions is evaluated there. Each gives a
 * list of complaints, none if all is well.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
"use strict";

/* Every line of text that a reader sees, as { text, box }, its box cut by what scrolls; complaints
 * about those that an ancestor cuts off; nodes of more than one line. */
function textLines() {
  const SLACK = 1.5; /* px: descenders and rounding */
  const complaints = [], lines = [], folded = [];
  const seen = (element) => element.checkVisibility({ visibilityProperty: true, opacityProperty: true });
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const range = document.createRange();
  const styles = new Map();
  const styleOf = (element) => {
    if (!styles.has(element)) styles.set(element, getComputedStyle(element));
    return styles.get(element);
  };
  const boxes = new Map();
  const boxOf = (element) => {
    if (!boxes.has(element)) boxes.set(element, element.getBoundingClientRect());
    return boxes.get(element);
  };
  for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
    const parent = node.parentElement;
    if (node.data.trim() === "" || parent.closest("script, style, .skip") || !seen(parent) ||
      (parent.localName === "details" && !parent.open)) continue;
    range.selectNodeContents(node);
    const rects = range.getClientRects();
    if (rects.length > 1) folded.push(node);
    for (const rect of rects) {
      if (rect.width < 1 || rect.height < 1) continue;
      const box = { left: rect.left, right: rect.right, top: rect.top, bottom: rect.bottom };
      let scrolled = false;
      for (let a = parent; a !== null && a !== document.body; a = a.parentElement) {
        const style = styleOf(a), frame = boxOf(a);
        if (style.overflowX === "visible" && style.overflowY === "visible") continue;
        const scrolls = /auto|scroll/.test(style.overflowX + style.overflowY);
        const out = box.left < frame.left - SLACK || box.right > frame.right + SLACK ||
          box.top < frame.top - SLACK || box.bottom > frame.bottom + SLACK;
        if (out && !scrolls && !scrolled)
          complaints.push(`text is clipped: "${node.data.trim().slice(0, 60)}"`);
        scrolled = scrolled || scrolls;
        box.left = Math.max(box.left, frame.left); box.right = Math.min(box.right, frame.right);
        box.top = Math.max(box.top, frame.top); box.bottom = Math.min(box.bottom, frame.bottom);
      }
      if (!scrolled && (rect.left < -SLACK || rect.right > innerWidth + SLACK))
        complaints.push(`text leaves the page: "${node.data.trim().slice(0, 60)}"`);
      if (box.right - box.left > 1 && box.bottom - box.top > 1)
        lines.push({ text: node.data.trim().slice(0, 40), box, node });
    }
  }
  return { complaints, lines, folded };
}

/* Accents and limits of sums have boxes that reach over what they belong to. */
function sameFormula(one, other) {
  const formula = (node) => (node.closest ? node : node.parentElement).closest("math");
  return formula(one) !== null && formula(one) === formula(other);
}

/* Two texts on the same place. Line boxes are taller than letters: a third of the height is air. */
function overlaps(lines) {
  const found = [];
  const cut = lines.map(({ text, box, node }) => {
    const air = (box.bottom - box.top) * 0.2;
    return { text, node, left: box.left + 1, right: box.right - 1, top: box.top + air, bottom: box.bottom - air };
  }).sort((a, b) => a.top - b.top);
  for (let i = 0; i < cut.length; i++)
    for (let j = i + 1; j < cut.length && cut[j].top < cut[i].bottom; j++)
      if (cut[j].node !== cut[i].node && cut[j].left < cut[i].right && cut[i].left < cut[j].right &&
          !sameFormula(cut[i].node, cut[j].node))
        found.push(`texts overlap: "${cut[i].text}" and "${cut[j].text}"`);
  return found;
}

/* Words of tables that a narrow column breaks, of those for which there is room in it. A name breaks after
 * its underscores, and its parts are words; scripts without spaces break anywhere. */
function brokenWords(nodes) {
  const found = new Set(), range = document.createRange();
  for (const node of nodes) {
    const cell = node.parentElement.closest("td, th");
    if (cell === null) continue;
    for (const { 0: word, index } of node.data.matchAll(/[\p{Script=Latin}\p{Script=Greek}\p{N}]{2,}/gu)) {
      if (word.length > 24) continue; // longer than the words of a sentence
      range.setStart(node, index);
      range.setEnd(node, index + word.length);
      const boxes = Array.from(range.getClientRects()).filter(({ width }) => width > 0);
      const lines = new Set(boxes.map(({ top }) => Math.round(top)));
      if (lines.size > 1 && boxes.reduce((sum, { width }) => sum + width, 0) < cell.clientWidth)
        found.add(`a word is broken: "${word}" of "${cell.textContent.trim().slice(0, 40)}"`);
    }
  }
  return Array.from(found);
}

function layout() {
  const { complaints, lines, folded } = textLines();
  const page = document.documentElement;
  if (page.scrollWidth > innerWidth) {
    const wide = Array.from(document.body.querySelectorAll("*"))
      .find((e) => e.getBoundingClientRect().right > innerWidth + 1 && !e.closest(".scroll, pre, figure.wide"));
    complaints.push(`the page scrolls sideways: ${page.scrollWidth} px of ${innerWidth}` +
      (wide ? `, <${wide.localName} class="${wide.className}">` : ""));
  }
  return complaints.concat(overlaps(lines), brokenWords(folded));
}

/* Titles of a figure's axes: a text that is turned for y, for x a lowest text that is no number, the
 * stamp left out. Gnuplot leaves out a title for which there is no room, without a word. */
function axisTitles(texts) {
  const turned = (t) => { const m = t.getScreenCTM(); return Math.abs(m.b) > Math.abs(m.a); };
  const rows = texts.filter((t) => !turned(t) && !t.textContent.trim().startsWith("Touchstone "));
  const lowest = Math.max(...rows.map((t) => t.getBoundingClientRect().bottom));
  const title = rows.some((t) => t.getBoundingClientRect().bottom > lowest - 4 &&
    /\p{L}/u.test(t.textContent.replace(/\d[eE][-+]?\d/g, "")));
  return (texts.some(turned) ? [] : ["no title of the y axis"]).concat(title ? [] : ["no title of the x axis"]);
}

/* What is drawn of a picture: its view box, which a window of other proportions surrounds. */
function drawnFrame(svg) {
  const { x, y, width, height } = svg.viewBox.baseVal === null ? { width: 0 } : svg.viewBox.baseVal;
  if (width === 0) return svg.getBoundingClientRect();
  const matrix = svg.getScreenCTM();
  const corner = (across, up) => new DOMPoint(across, up).matrixTransform(matrix);
  const low = corner(x, y), high = corner(x + width, y + height);
  return { left: low.x, top: low.y, right: high.x, bottom: high.y };
}

/* Labels of a picture: inside it, and apart; both axes have a title. A sign alone is a mark, not a label; what is written
 * twice in one place (the stamp, by each panel) reads as once. A picture whose class says so has no axes, and frames of a
 * motion that are not shown at the moment have no labels. */
function picture() {
  const svg = document.documentElement, frame = drawnFrame(svg), places = new Set();
  const texts = Array.from(svg.querySelectorAll("text"))
    .filter((t) => /[\p{L}\p{N}]/u.test(t.textContent) && getComputedStyle(t).visibility !== "hidden");
  const lines = texts.map((t) => ({ text: t.textContent.trim().slice(0, 40), box: t.getBoundingClientRect(), node: t }))
    .filter(({ text, box }) => {
      const place = `${text} ${Math.round(box.left)} ${Math.round(box.top)}`;
      return !places.has(place) && places.add(place);
    });
  return lines.filter(({ box }) => box.left < frame.left - 1 || box.right > frame.right + 1 ||
      box.top < frame.top - 1 || box.bottom > frame.bottom + 1)
    .map(({ text }) => `text is clipped: "${text}"`)
    .concat(overlaps(lines), svg.classList.contains("free") ? [] : axisTitles(texts));
}

/* Links, pictures and places in the page, for the test to resolve. */
function references() {
  const hrefs = Array.from(document.querySelectorAll("a[href], link[href]")).map((a) => a.getAttribute("href"));
  const broken = Array.from(document.images).filter((i) => !i.complete || i.naturalWidth === 0)
    .map((i) => `picture not shown: ${i.getAttribute("src")}`);
  const silent = Array.from(document.images).filter((i) => !(i.alt || "").trim())
    .map((i) => `picture without a text in its place: ${i.getAttribute("src")}`);
  return { hrefs: Array.from(new Set(hrefs)), broken: broken.concat(silent),
    ids: Array.from(document.querySelectorAll("[id]")).map((e) => e.id) };
}

/* The order of a table's rows by a column. */
function isSorted(table, column, rising) {
  const complaints = [];
  for (const body of table.tBodies) {
    const keys = Array.from(body.rows).filter((row) => !row.querySelector("[scope=rowgroup]")).map((row) => {
      const text = row.cells[column].getAttribute("data-key");
      return text === null ? row.cells[column].textContent.trim() : text === "" ? null : Number(text);
    });
    const known = keys.filter((key) => key !== null);
    if (keys.slice(0, known.length).includes(null)) complaints.push("rows without a number are not last");
    for (let i = 1; i < known.length; i++) {
      const order = typeof known[i] === "number" ? known[i] - known[i - 1]
        : known[i].localeCompare(known[i - 1], "en", { numeric: true });
      if (rising ? order < 0 : order > 0) {
        complaints.push(`"${known[i - 1]}" stands before "${known[i]}"`);
        break;
      }
    }
  }
  return complaints;
}

/* Each heading of each table: pressed once and once more, the rows follow and screen readers are told. */
function sorting() {
  const complaints = [];
  document.querySelectorAll("table.sortable").forEach((table, place) => {
    const heads = Array.from(table.tHead.rows[0].cells);
    const rows = table.querySelectorAll("tbody tr").length;
    heads.forEach((head, column) => {
      const button = head.querySelector("button");
      if (button === null) {
        complaints.push(`table ${place}: heading "${head.textContent}" has no button`);
        return;
      }
      const states = [];
      for (let press = 0; press < 2; press++) {
        button.click();
        const state = head.getAttribute("aria-sort");
        states.push(state);
        isSorted(table, column, state === "ascending").forEach((text) =>
          complaints.push(`table ${place}, by "${button.textContent}", ${state}: ${text}`));
      }
      if (states.slice().sort().join() !== "ascending,descending")
        complaints.push(`table ${place}, "${button.textContent}": aria-sort said ${states.join(", then ")}`);
      if (table.querySelectorAll("thead [aria-sort]").length !== 1)
        complaints.push(`table ${place}: not one heading has aria-sort`);
    });
    if (table.querySelectorAll("tbody tr").length !== rows)
      complaints.push(`table ${place}: rows were lost`);
  });
  return complaints;
}

/* Each field above a table: rows that have every word of the last row's first cell stay, with it, and all
 * others go; an empty field brings all back; no row has a text that is in none. */
function filtering() {
  const complaints = [];
  const visible = (rows) => rows.filter((row) => !row.hidden && !row.parentNode.hidden);
  document.querySelectorAll("p.filter").forEach((line, place) => {
    const field = line.querySelector("input"), table = line.nextElementSibling.querySelector("table");
    const groups = Array.from(table.tBodies, (body) => { /* one search for each body: it may have 5000 rows */
      const heading = body.querySelector("[scope=rowgroup]");
      return Array.from(body.rows).filter((row) => heading === null || row !== heading.parentNode)
        .map((row) => ({ row, heading: heading === null ? "" : heading.textContent.toLowerCase() }));
    }).flat();
    const rows = groups.map(({ row }) => row), headings = groups.map(({ heading }) => heading);
    const type = (words) => { field.value = words; field.dispatchEvent(new Event("input")); };
    const all = visible(rows).length, name = rows[rows.length - 1].cells[0].textContent.trim().toLowerCase();
    type(name.toUpperCase());
    const fits = rows.filter((row, i) => name.split(/\s+/).every((word) =>
      row.textContent.toLowerCase().includes(word) || headings[i].includes(word)));
    if (visible(rows).length !== fits.length || fits.some((row) => row.hidden))
      complaints.push(`field ${place}: "${name}" leaves ${visible(rows).length} rows of ${fits.length}`);
    if (!line.querySelector("output").textContent.startsWith(`${fits.length} of`))
      complaints.push(`field ${place}: says "${line.querySelector("output").textContent}"`);
    type("no such text anywhere");
    if (visible(rows).length !== 0) complaints.push(`field ${place}: rows stay that have no such text`);
    type("");
    if (visible(rows).length !== all || all !== rows.length) complaints.push(`field ${place}: rows are lost`);
  });
  return complaints;
}

/* Rows with the same elements and classes are the same to axe, which takes a minute for a thousand of them:
 * the first few of each kind stay. */
function thin() {
  const KEPT = 3;
  document.querySelectorAll("table").forEach((table) => {
    const kinds = new Map();
    for (const row of Array.from(table.tBodies).flatMap((body) => Array.from(body.rows))) {
      const kind = Array.from(row.querySelectorAll("*:not(wbr, sup)"),
        (element) => `${element.localName} ${element.getAttribute("class")}`).join();
      kinds.set(kind, (kinds.get(kind) || 0) + 1);
      if (kinds.get(kind) > KEPT) row.remove();
    }
  });
}

const source = [textLines, sameFormula, overlaps, brokenWords, layout, axisTitles, drawnFrame, picture, references, isSorted, sorting, filtering, thin]
  .map(String).join("\n");

/* The expression that calls one of them. */
const call = (name) => `(() => { ${source}\nreturn ${name}(); })()`;

module.exports = { call };
