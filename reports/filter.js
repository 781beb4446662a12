/* Tables with many rows get a field above them that filters: a row stays that has every word typed, in itself or
 * in the heading of its group. `?find=words` in the address fills the fields. Written without the characters
 * that XML takes for its own. SPDX-License-Identifier: GPL-3.0-or-later */
(function () {
  var LEAST_ROWS = 12;
  var asked = new URLSearchParams(location.search).get("find");
  function words(text) { return text.toLowerCase().split(/\s+/).filter(Boolean); }
  function textOf(row) { return row.textContent.toLowerCase(); }
  function rowsOf(table) {
    return Array.from(table.tBodies).map(function (body) {
      var heading = body.querySelector("[scope=rowgroup]");
      return { body: body, heading: heading === null ? "" : textOf(heading), rows: Array.from(body.rows)
        .filter(function (row) { return heading === null ? true : row !== heading.parentNode; }) };
    });
  }
  function filter(groups, wanted, all) {
    var shown = 0;
    groups.forEach(function (group) {
      var before = shown;
      group.rows.forEach(function (row) {
        var text = wanted.length === 0 ? "" : group.heading + " " + textOf(row);
        var fits = wanted.every(function (word) { return text.includes(word); });
        row.hidden = !fits;
        if (fits) shown += 1;
      });
      group.body.hidden = shown === before;
    });
    return shown + " of " + all + " rows";
  }
  document.querySelectorAll("table.sortable").forEach(function (table, place) {
    var groups = rowsOf(table);
    var all = groups.reduce(function (sum, group) { return sum + group.rows.length; }, 0);
    if (LEAST_ROWS > all) return;
    var box = table.closest(".scroll"), line = document.createElement("p");
    var label = document.createElement("label"), field = document.createElement("input");
    var count = document.createElement("output");
    line.className = "filter";
    field.type = "search";
    field.id = "filter-" + place;
    label.htmlFor = field.id;
    label.textContent = "Filter";
    field.setAttribute("aria-label", "Filter: " + (box.getAttribute("aria-label") || "rows"));
    count.setAttribute("for", field.id);
    line.append(label, field, count);
    box.before(line);
    function apply() { count.textContent = filter(groups, words(field.value), all); }
    field.addEventListener("input", apply);
    field.value = asked === null ? "" : asked;
    apply();
  });
}());
