#include "measure/report/page.h"

namespace sandbox::report_page {

// Series colours keep apart for colour-blind readers, and in grey by their markers.
const char *const style = R"(:root {
  --page: #fbfbf9; --card: #ffffff; --ink: #1c1f24; --muted: #5d6570; --rule: #dfe2e6; --faint: #eef0f2;
  --accent: #0b5cad; --warn: #8a3b00; --warn-page: #fff1e2; --front: #f2b705;
  --s0: #7a7f87; --s1: #d1495b; --s2: #0072b2; --s3: #2a9d6a; --s4: #9a57c8;
  --p0: #d1495b; --p1: #e9a23b; --p2: #3b8ea5; --p3: #b9c0c8; }
@media (prefers-color-scheme: dark) { :root {
  --page: #14161a; --card: #1b1e24; --ink: #e8eaed; --muted: #a0a8b3; --rule: #343a43; --faint: #262b32;
  --accent: #74b6ff; --warn: #ffc58a; --warn-page: #3a2712; --front: #b98d0a;
  --s0: #a9b0ba; --s1: #ff7b8a; --s2: #5db7f5; --s3: #5fd3a0; --s4: #c79bf0;
  --p0: #e86a79; --p1: #e9b04f; --p2: #55aec7; --p3: #5b636e; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--ink);
  font: 16px/1.55 system-ui, "Segoe UI", Roboto, "Helvetica Neue", "Noto Sans", Arial, sans-serif; }
main { max-width: 1160px; margin: 0 auto; padding: 40px 28px 80px; }
h1 { font-size: 2.3rem; line-height: 1.15; margin: 0 0 10px; letter-spacing: -0.015em; }
h2 { font-size: 1.4rem; margin: 56px 0 6px; letter-spacing: -0.01em; }
h3 { font-size: 1.05rem; margin: 28px 0 8px; }
p { margin: 0 0 12px; max-width: 78ch; }
header { border-bottom: 1px solid var(--rule); padding-bottom: 18px; }
header + section > h2 { margin-top: 32px; }
main > header:not(:first-child) { margin-top: 96px; border-top: 4px solid var(--ink); padding-top: 28px; }
.kicker { color: var(--accent); font-weight: 600; letter-spacing: 0.02em; margin: 0 0 4px; }
.lead { font-size: 1.1rem; }
.facts { max-width: none; }
.facts, .note, figcaption, .why { color: var(--muted); font-size: 0.92rem; }
.warning { background: var(--warn-page); color: var(--warn); padding: 10px 14px; border-radius: 6px; font-weight: 600; }
.cards { display: grid; grid-template-columns: repeat(auto-fit, minmax(230px, 1fr)); gap: 14px; margin: 24px 0 0; }
.card { background: var(--card); border: 1px solid var(--rule); border-radius: 8px; padding: 14px 16px; }
.card b { display: block; font-size: 1.45rem; line-height: 1.2; letter-spacing: -0.01em; overflow-wrap: anywhere; }
.card b.words { font-size: 1.12rem; line-height: 1.35; }
.card span { color: var(--muted); font-size: 0.9rem; }
.card span.top { display: block; margin-bottom: 4px; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(300px, 1fr)); gap: 18px; margin-top: 16px; }
figure { margin: 0; }
figure img { width: 100%; height: auto; display: block; border-radius: 6px; background: #000; }
figcaption { margin-top: 8px; line-height: 1.4; overflow-wrap: anywhere; }
figcaption b { color: var(--ink); display: block; }
.plots { display: grid; grid-template-columns: repeat(2, minmax(0, 1fr)); gap: 14px; }
.plots > div, .bars { background: var(--card); border: 1px solid var(--rule); border-radius: 8px; padding: 10px; }
.plots.three { grid-template-columns: repeat(3, minmax(0, 1fr)); }
@media (max-width: 820px) { .plots, .plots.three { grid-template-columns: 1fr; } }
svg { width: 100%; height: auto; display: block; font: 12px system-ui, "Segoe UI", Roboto, "Noto Sans", Arial, sans-serif; }
svg text { fill: var(--ink); }
svg .title { font-weight: 600; font-size: 13px; }
svg .label, svg .tick, svg .guide-label { fill: var(--muted); }
svg .guide-label { font-size: 10.5px; paint-order: stroke; stroke: var(--card); stroke-width: 3px; }
svg .mid { text-anchor: middle; } svg .end { text-anchor: end; }
svg .grid { stroke: var(--rule); } svg .minor { stroke: var(--faint); }
svg .guide { stroke: var(--muted); stroke-dasharray: 2 4; }
svg .front { fill: none; stroke: var(--front); stroke-width: 6; stroke-opacity: 0.55; stroke-linejoin: round; }
svg .line { fill: none; stroke: var(--c); stroke-width: 1.8; }
svg .spread { stroke: var(--c); stroke-width: 1; stroke-opacity: 0.55; }
svg .dot { fill: var(--c); stroke: var(--card); stroke-width: 0.8; }
.s0 { --c: var(--s0); } .s1 { --c: var(--s1); } .s2 { --c: var(--s2); } .s3 { --c: var(--s3); } .s4 { --c: var(--s4); }
.p0 { fill: var(--p0); background: var(--p0); } .p1 { fill: var(--p1); background: var(--p1); }
.p2 { fill: var(--p2); background: var(--p2); } .p3 { fill: var(--p3); background: var(--p3); }
.legend { display: flex; flex-wrap: wrap; gap: 4px 22px; font-size: 0.92rem; margin: 10px 0; max-width: none; }
.legend span { display: inline-flex; align-items: center; gap: 7px; }
.legend svg { width: 30px; height: 12px; }
.legend i { width: 14px; height: 12px; border-radius: 2px; }
.scroll { overflow-x: auto; margin: 12px 0; }
table { border-collapse: collapse; font-size: 0.9rem; font-variant-numeric: tabular-nums; width: 100%; }
caption { text-align: left; font-weight: 600; padding: 6px 0; }
th { text-align: left; color: var(--muted); font-weight: 600; border-bottom: 2px solid var(--rule);
  padding: 5px 12px 5px 0; vertical-align: bottom; }
td { border-bottom: 1px solid var(--faint); padding: 5px 12px 5px 0; vertical-align: top; }
th.n, td.n { text-align: right; }
td.n { white-space: nowrap; }
td.q, span.q { color: var(--muted); }
td.unsettled { color: var(--muted); font-style: italic; }
td.good { font-weight: 600; color: var(--accent); }
td.bad { color: var(--warn); font-weight: 600; }
.rows .scroll { width: min(97vw, 1440px); margin-left: calc(50% - min(48.5vw, 720px)); }
.rows table { font-size: 0.76rem; } .rows td, .rows th { padding-right: 9px; }
th[data-sort] button { all: unset; cursor: pointer; } th[data-sort] button:focus-visible { outline: 2px solid var(--accent); }
th[aria-sort=ascending] button::after { content: " \2191"; } th[aria-sort=descending] button::after { content: " \2193"; }
code { font: 0.94em ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; overflow-wrap: anywhere; }
td code { white-space: nowrap; } .rows td code { font-size: 0.95em; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 4px 20px; font-size: 0.94rem; }
dt { color: var(--muted); } dd { margin: 0; }
@media print {
  @page { size: A4; margin: 13mm; } @page wide { size: A4 landscape; margin: 11mm; } .rows { page: wide; }
  :root { --page: #fff; --card: #fff; --ink: #000; --muted: #444; --rule: #bbb; --faint: #e2e2e2; --accent: #003f7f;
    --s0: #7a7f87; --s1: #d1495b; --s2: #0072b2; --s3: #2a9d6a; --s4: #9a57c8; --front: #f2b705;
    --p0: #d1495b; --p1: #e9a23b; --p2: #3b8ea5; --p3: #b9c0c8; }
  body { font-size: 10.5pt; } main { max-width: none; padding: 0; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  h2, h3 { break-after: avoid; } figure, .card, .plots > div, tr, .legend { break-inside: avoid; }
  .scroll, .rows .scroll { overflow: visible; width: auto; margin-left: 0; } .rows table { font-size: 5.6pt; } .rows td, .rows th { padding: 1.5px 4px 1.5px 0; }
  .plots { grid-template-columns: repeat(2, minmax(0, 1fr)); } .plots.three { grid-template-columns: repeat(3, minmax(0, 1fr)); }
  h2 { margin-top: 30px; } .cards { grid-template-columns: repeat(4, 1fr); gap: 8px; } .card { padding: 8px 10px; }
  table { font-size: 8pt; } td code { white-space: normal; } .rows td code { white-space: nowrap; } .figures { grid-template-columns: repeat(3, 1fr); }
}
)";

const char *const script = R"(for (const th of document.querySelectorAll('th')) {
  const button = document.createElement('button');
  button.append(...th.childNodes);
  th.append(button);
  th.dataset.sort = '';
  button.addEventListener('click', () => {
    const table = th.closest('table'), column = th.cellIndex, up = th.getAttribute('aria-sort') !== 'ascending';
    const key = row => { const cell = row.cells[column]; return cell ? cell.dataset.v ?? cell.textContent : ''; };
    const compare = (a, b) => {
      const x = parseFloat(a), y = parseFloat(b);
      return isNaN(x) || isNaN(y) ? a.localeCompare(b) : x - y;
    };
    const rows = [...table.tBodies[0].rows].sort((a, b) => (up ? 1 : -1) * compare(key(a), key(b)));
    table.tBodies[0].append(...rows);
    for (const other of table.querySelectorAll('th')) other.removeAttribute('aria-sort');
    th.setAttribute('aria-sort', up ? 'ascending' : 'descending');
  });
}
)";

} // namespace sandbox::report_page
