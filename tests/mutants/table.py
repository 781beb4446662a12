"""Tables of what became of mutants.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import csv
import json


def columns_of(result):
    """Suites of unit tests and cases of the catalogue that turned red, each with its count."""
    counts = {}
    for test in result["tests"]:
        suite = "test " + test.split("/")[0]
        counts[suite] = counts.get(suite, 0) + 1
    for check in result["checks"]:
        case = "case " + check.split("/")[0]
        counts[case] = counts.get(case, 0) + 1
    return counts


def score(results):
    """Killed ones in percent of those that are built and not equivalent."""
    judged = [r for r in results if r["outcome"] in ("killed", "survived")]
    killed = sum(r["outcome"] == "killed" for r in judged)
    return 100.0 * killed / len(judged) if judged else 0.0


def entry(result):
    """As the report's page of mutants reads it."""
    counts = columns_of(result)
    return {
        "name": result["name"], "room": result["room"], "kind": result["kind"],
        "what": result["what"], "patch": result["patch"], "outcome": result["outcome"],
        "equivalent": result["equivalent"], "fault": result.get("fault", ""),
        "killed_by": sorted(result["tests"] + result["checks"]),
        "only_killer": next(iter(counts)) if len(counts) == 1 else "",
        "whole": result["whole"], "seconds": result["seconds"],
    }


def write_json(path, about, results):
    document = {"format": 1, **about, "score": score(results),
                "mutants": [entry(r) for r in results]}
    path.write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")


def write_csv(path, results):
    counts = {r["name"]: columns_of(r) for r in results}
    columns = sorted({c for of in counts.values() for c in of})
    with path.open("w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file)
        rows.writerow(["mutant", "room", "kind", "outcome", *columns])
        for r in results:
            rows.writerow([r["name"], r["room"], r["kind"], r["outcome"],
                           *(counts[r["name"]].get(c, 0) for c in columns)])


def row(cells):
    return "| " + " | ".join(str(c).replace("|", "\\|") for c in cells) + " |\n"


def write_markdown(path, about, results):
    tests, checks = ({r["name"] for r in results if r[by]} for by in ("tests", "checks"))
    text = [f"# Mutants\n\n{sum(r['outcome'] == 'killed' for r in results)} of {len(results)} "
            f"killed, score {score(results):.1f} %, revision {about['revision']}; "
            f"{len(tests)} by unit tests, {len(checks)} by the catalogue, {len(checks - tests)} of "
            f"them by it alone.\n\n"]
    text += [row(["mutant", "room", "kind", "what", "outcome", "tests", "checks", "killers"]),
             row(["---"] * 8)]
    for r in results:
        killers = ", ".join(f"{name} {count}" for name, count in sorted(columns_of(r).items()))
        text.append(row([r["name"], r["room"], r["kind"], r["what"], r["outcome"],
                         len(r["tests"]), len(r["checks"]), killers or r["equivalent"]]))
    path.write_text("".join(text), encoding="utf-8")


def write_all(folder, about, results):
    results = sorted(results, key=lambda r: r["name"])
    write_json(folder / "mutants.json", about, results)
    write_csv(folder / "mutants.csv", results)
    write_markdown(folder / "mutants.md", about, results)
