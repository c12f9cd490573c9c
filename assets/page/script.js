// Tables sort by the column whose head is clicked.
for (const th of document.querySelectorAll('th')) {
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
