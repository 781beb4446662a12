/* Tables of class sortable: a button in each heading sorts the rows by that column, best first,
 * and turns them round when pressed again. Rows without a number stay last, equal ones in the order of
 * the page. Rows in groups stay in their group, under its heading.
 * Written without the characters that XML takes for its own. SPDX-License-Identifier: GPL-3.0-or-later */
document.querySelectorAll("table.sortable").forEach(function (table) {
  var words = new Intl.Collator("en", { numeric: true });
  var heads = Array.from(table.tHead.rows[0].cells);
  var groups = Array.from(table.tBodies).map(function (body) {
    return { body: body, page: Array.from(body.rows).filter(function (row) {
      return row.querySelector("[scope=rowgroup]") === null; }) };
  });
  function key(row, column) {
    var text = row.cells[column].getAttribute("data-key");
    return text === null ? row.cells[column].textContent.trim() : text === "" ? null : Number(text);
  }
  function compare(a, b) {
    return typeof a === "number" ? a - b : words.compare(a, b);
  }
  function sort(column, rising) {
    groups.forEach(function (group) {
      var rows = group.page.map(function (row, place) { return { row: row, key: key(row, column), place: place }; });
      rows.sort(function (a, b) {
        if (a.key === null) return b.key === null ? a.place - b.place : 1;
        if (b.key === null) return -1;
        var order = compare(a.key, b.key);
        return order === 0 ? a.place - b.place : rising ? order : -order;
      });
      rows.forEach(function (entry) { group.body.appendChild(entry.row); });
    });
    heads.forEach(function (head, place) {
      if (place === column) head.setAttribute("aria-sort", rising ? "ascending" : "descending");
      else head.removeAttribute("aria-sort");
    });
  }
  heads.forEach(function (head, column) {
    var button = document.createElement("button");
    button.type = "button";
    while (head.firstChild) button.appendChild(head.firstChild);
    head.appendChild(button);
    button.addEventListener("click", function () {
      var first = head.getAttribute("data-first") !== "descending";
      var now = head.getAttribute("aria-sort");
      sort(column, now === null ? first : now !== "ascending");
    });
  });
});
