// Tables whose columns sort: upwards, downwards, as they were.

/** The number that a cell begins with; NaN for a text. */
function number_in(text) {
  const match = text.trim().replace("−", "-").match(/^[≥≤<>=± ]*([-+]?\d+(\.\d+)?(e[-+]?\d+)?)/i);
  return match ? Number(match[1]) : NaN;
}

/** Numbers before texts, texts by the alphabet, what is not known last in either direction. */
function compare_cells(a, b, sign) {
  const missing = (text) => text === "" || text === "-" || text === "–";
  if (missing(a) || missing(b)) return missing(a) - missing(b);
  const x = number_in(a), y = number_in(b);
  if (Number.isNaN(x) || Number.isNaN(y)) return Number.isNaN(x) - Number.isNaN(y) || sign * a.localeCompare(b);
  return sign * (x - y);
}

function sort_rows(table, rows, column, direction) {
  const cell = (row) => row.cells[column].textContent.trim();
  const sign = direction === "ascending" ? 1 : -1;
  const sorted = direction === "none" ? rows : [...rows].sort((a, b) => compare_cells(cell(a), cell(b), sign));
  table.tBodies[0].append(...sorted);
}

function make_sortable(table) {
  const rows = [...table.tBodies[0].rows], heads = [...table.tHead.rows[0].cells];
  if (rows.length < 2) return;
  const next = {none: "ascending", ascending: "descending", descending: "none"};
  heads.forEach((head, column) => {
    const button = element("button", {type: "button"}, ...head.childNodes);
    head.setAttribute("aria-sort", "none");
    head.append(button);
    button.addEventListener("click", () => {
      const direction = next[head.getAttribute("aria-sort")];
      for (const other of heads) other.setAttribute("aria-sort", "none");
      head.setAttribute("aria-sort", direction);
      sort_rows(table, rows, column, direction);
    });
  });
}

/** A box that scrolls can be reached and scrolled by keys. */
function make_scrollable(box) {
  const tell = () => {
    if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
    else box.removeAttribute("tabindex");
  };
  box.setAttribute("role", "region");
  box.setAttribute("aria-label", "table");
  new ResizeObserver(tell).observe(box);
  tell();
}

