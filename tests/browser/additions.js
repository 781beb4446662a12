/* What a report shows beside its own run, invented: so that its pages of mutants, headroom and
 * changes have tables as long as they come, without hours of runs.
 *
 *     node additions.js REPORT FOLDER
 *
 * writes to FOLDER: report/ (the run of REPORT without its pages), before/, clang/ and sanitized/
 * (the same run with other values), mutants.json. `mpm-verify report` puts them together.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
"use strict";
const fs = require("node:fs");
const path = require("node:path");

const MUTANTS = 120;
const ROOMS = ["action", "cracks", "loads", "shape functions", "step", "suite", "transfer"];
const OUTCOMES = ["killed", "killed", "killed", "killed", "killed", "equivalent", "survived", "not-built"];

/* A run with each check's record changed; its measurements as they are. */
function runOf(report, folder, change) {
  fs.mkdirSync(folder, { recursive: true });
  fs.copyFileSync(path.join(report, "measurements.jsonl"), path.join(folder, "measurements.jsonl"));
  const lines = fs.readFileSync(path.join(report, "checks.jsonl"), "utf8").trim().split("\n");
  let place = 0;
  fs.writeFileSync(path.join(folder, "checks.jsonl"), lines.map((line) => {
    const record = JSON.parse(line);
    return record.kind === "check" ? JSON.stringify(change(record, place++)) : line;
  }).join("\n") + "\n");
  return lines.map((line) => JSON.parse(line)).filter(({ kind }) => kind === "check");
}

/* Every 40th value moves, every 200th turns red. */
function earlier(check, place) {
  if (place % 200 === 7) return { ...check, status: "fail", margin: -0.5, reason: "invented for the test" };
  return place % 40 === 3 && check.value !== null ? { ...check, value: 1.01 * check.value } : check;
}

/* Another build's values: round-off; every 60th far off, every 90th none. */
function otherBuild(seed) {
  return (check, place) => {
    if ((place + seed) % 90 === 11) return { ...check, value: null };
    return { ...check, value: check.value * (1 + ((place + seed) % 60 === 5 ? 0.3 : 1e-9 * (seed + 1))) };
  };
}

function mutantOf(place, checks) {
  const outcome = OUTCOMES[place % OUTCOMES.length], room = ROOMS[place % ROOMS.length];
  const killers = outcome === "killed" ? 1 + (place * place) % 40 : 0;
  const nameOf = ({ case: of, check, variant }) => `${of}/${check}/${variant}`;
  return {
    name: `${room.replaceAll(" ", "-")}-mutant-with-a-rather-long-name-${place}`, room, outcome,
    what: `Mutant ${place}: the second term is left out where the domain of a particle reaches over the edge of its cell.`,
    patch: "--- a/solver/method/step.c\n+++ b/solver/method/step.c\n@@ -1,3 +1,3 @@\n" +
      "-    const double rate = mpm_nodal_rate(field, node, coefficients, time_step, MPM_TRUNCATED);\n" +
      "+    const double rate = -mpm_nodal_rate(field, node, coefficients, time_step, MPM_TRUNCATED);\n",
    killed_by: Array.from({ length: killers }, (_, k) => nameOf(checks[(97 * place + 31 * k) % checks.length])),
    equivalent: outcome === "equivalent" ? "no scene that the solver accepts gets there" : "",
    fault: outcome === "not-built" ? "step.c:12: error: 'rate' undeclared" : "",
  };
}

function main(report, folder) {
  fs.rmSync(folder, { recursive: true, force: true });
  const own = path.join(folder, "report");
  const checks = runOf(report, own, (check) => check);
  runOf(report, path.join(folder, "before"), earlier);
  ["clang", "sanitized"].forEach((name, seed) => runOf(report, path.join(folder, name), otherBuild(seed)));
  fs.writeFileSync(path.join(folder, "mutants.json"), JSON.stringify({ format: 1, revision: "0123456789ab",
    mutants: Array.from({ length: MUTANTS }, (_, place) => mutantOf(place, checks)) }));
}

main(...process.argv.slice(2));
