/* Tables of class sortable: a button in each heading sorts the rows by that column, best first,
 * and turns them round when pressed again. Rows without a number stay last, equal ones in the order of
 * the page.
 * Written without the characters that XML takes for its own. SPDX-License-Identifier: GPL-3.0-or-later */
document.querySelectorAll("table.sortable").forEach(function (table) {
  var heads = Array.from(table.tHead.rows[0].cells), body = table.tBodies[0], page = Array.from(body.rows);
  function key(row, column) {
    var text = row.cells[column].getAttribute("data-key");
    return text === null ? row.cells[column].textContent : text === "" ? null : Number(text);
  }
  function sort(column, rising) {
    var rows = page.map(function (row, place) { return { row: row, key: key(row, column), place: place }; });
    rows.sort(function (a, b) {
      if (a.key === null) return b.key === null ? a.place - b.place : 1;
      if (b.key === null) return -1;
      var order = a.key > b.key ? 1 : b.key > a.key ? -1 : 0;
      return order === 0 ? a.place - b.place : rising ? order : -order;
    });
    rows.forEach(function (entry) { body.appendChild(entry.row); });
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
