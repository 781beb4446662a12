/* What is checked within a figure that gnuplot drew: the text of these functions is evaluated there.
 * Each gives a list of complaints, none if all is well.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
"use strict";

/* Sizes of letters where the page has all the width that it takes. A raised or lowered digit counts with
 * its line; the stamp in the corner is no part of the picture. */
function smallText() {
  const LEAST = 9; /* px */
  const found = new Map(), svg = document.documentElement, own = svg.getScreenCTM();
  const width = svg.viewBox.baseVal !== null && svg.viewBox.baseVal.width > 0
    ? svg.viewBox.baseVal.width : svg.getBoundingClientRect().width;
  /* beside another one in two columns; wide ones, and that of a comparison, have a line of their own */
  const alone = width > 780 || document.querySelector("g[id^='comparison_plot_']") !== null;
  const shown = Math.min(1, (alone ? 1040 : 632) / width);
  for (const text of document.querySelectorAll("text")) {
    const matrix = text.getScreenCTM(), words = text.textContent.trim();
    const size = parseFloat(getComputedStyle(text).fontSize) * shown * Math.hypot(matrix.a, matrix.b) / Math.hypot(own.a, own.b);
    if (words !== "" && !words.startsWith("Touchstone ") && size < LEAST - 0.01) found.set(size.toFixed(1), words);
  }
  return Array.from(found, ([size, words]) => `text of ${size} px: "${words.slice(0, 40)}"`);
}

/* Where a curve goes: points along its lines, and the middle of its marks. */
function pointsOf(shape) {
  const STEP = 3; /* px */
  const box = shape.getBoundingClientRect();
  if (shape.localName !== "path") return [{ x: (box.left + box.right) / 2, y: (box.top + box.bottom) / 2 }];
  const matrix = shape.getScreenCTM(), length = shape.getTotalLength(), points = [];
  for (let at = 0; at <= length; at += STEP) {
    const point = shape.getPointAtLength(at).matrixTransform(matrix);
    points.push({ x: point.x, y: point.y });
  }
  return points;
}

/* The curves of a figure: boxes of the entry in the legend, points of marks and lines. Gnuplot writes all of a
 * curve into one group: its title, the entry in the legend if it has one, then the data. The sample in the
 * legend is beside its text, and short. */
function curvesOf(svg) {
  const SAMPLE = 110; /* px: its length with the room to the text */
  return Array.from(svg.querySelectorAll("g[id*='_plot_']"), (group) => {
    const title = group.querySelector("title"), first = group.querySelector("text");
    const named = title !== null && first !== null && title.textContent.trim() === first.textContent.trim();
    const curve = { legend: named ? [first.getBoundingClientRect()] : [], points: [] };
    const text = curve.legend[0];
    for (const shape of group.querySelectorAll("path, use, rect, circle, polygon")) {
      const box = shape.getBoundingClientRect(), middle = (box.top + box.bottom) / 2;
      if (named && curve.points.length === 0 && box.width < SAMPLE && middle > text.top - 1 && middle < text.bottom + 1 &&
          box.left > text.left - SAMPLE && box.right < text.right + SAMPLE) curve.legend.push(box);
      else curve.points.push(...pointsOf(shape));
    }
    return curve;
  });
}

/* Entries that are near each other are one legend; each panel of a figure may have its own. */
function legendsOf(curves) {
  const NEAR = { across: 120, down: 30 }; /* px */
  const legends = [];
  const near = (a, b) => Math.max(a.left, b.left) - Math.min(a.right, b.right) < NEAR.across &&
    Math.max(a.top, b.top) - Math.min(a.bottom, b.bottom) < NEAR.down;
  for (const { legend } of curves.filter((curve) => curve.legend.length > 0)) {
    const joined = legends.filter((boxes) => boxes.some((box) => legend.some((own) => near(box, own))));
    joined.forEach((boxes) => legends.splice(legends.indexOf(boxes), 1));
    legends.push(joined.flat().concat(legend));
  }
  return legends;
}

/* The legend is beside the data, and leaves most of the figure to them: it may take a quarter of the width
 * or of the height. */
function legend(svg, frame) {
  const SHARE = 0.25;
  const curves = curvesOf(svg), points = curves.flatMap((curve) => curve.points), complaints = new Set();
  for (const boxes of legendsOf(curves)) {
    const extent = (low, high) => Math.max(...boxes.map((b) => b[high])) - Math.min(...boxes.map((b) => b[low]));
    const share = Math.min(extent("left", "right") / frame.width, extent("top", "bottom") / frame.height);
    if (boxes.some((box) => points.some(({ x, y }) =>
      x > box.left && x < box.right && y > box.top + 2 && y < box.bottom - 2)))
      complaints.add("the legend is on a curve");
    if (share > SHARE) complaints.add(`the legend takes ${Math.round(100 * share)} % of width and height`);
  }
  return Array.from(complaints);
}

/* A name of an axis has its unit in brackets at the end, or is a number for which there is none: a ratio
 * ("over", "/"), a count, an angle of the paper's own, or one of those that have no unit by definition. */
function withoutUnit(words) {
  const NUMBERS = /\b(over|number|turns|cells|count|order|weight|ratio|share|of particles|times|coefficient|refinement)\b|\/|\|/;
  const COORDINATE = /^[xyzr]$/; // of a scene that declares no unit
  return !COORDINATE.test(words) && !/\([^()]*\)|%/.test(words) && !NUMBERS.test(words);
}

function axisUnits(svg) {
  const titles = Array.from(svg.querySelectorAll("text")).filter((text) => {
    const matrix = text.getScreenCTM();
    return Math.abs(matrix.b) > Math.abs(matrix.a) && /\p{L}/u.test(text.textContent);
  });
  return titles.map((text) => text.textContent.trim()).filter(withoutUnit)
    .map((words) => `an axis without a unit: "${words}"`);
}

function figure() {
  const svg = document.documentElement;
  const units = svg.classList.contains("free") ? [] : axisUnits(svg); // pictures of scenes have no axes
  return smallText().concat(legend(svg, svg.getBoundingClientRect()), units);
}

const source = [smallText, pointsOf, curvesOf, legendsOf, legend, withoutUnit, axisUnits, figure].map(String).join("\n");

/* The expression that calls one of them. */
const call = (name) => `(() => { ${source}\nreturn ${name}(); })()`;

module.exports = { call };
