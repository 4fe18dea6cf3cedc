add_theme_switch();
for (const table of document.querySelectorAll("table")) if (table.tHead && table.tBodies[0]) make_sortable(table);
for (const box of document.querySelectorAll(".wide")) make_scrollable(box);
for (const figure of document.querySelectorAll("figure[data-chart]")) add_chart(figure, data.charts[Number(figure.dataset.chart)]);
for (const figure of document.querySelectorAll("figure[data-sheets]")) add_sheets(figure, data.sheets);
addEventListener("beforeprint", () => document.querySelectorAll("details").forEach((closed) => (closed.open = true)));
})();
