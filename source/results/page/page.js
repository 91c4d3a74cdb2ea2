// A click on a table's head, or Enter, sorts by that column; another one turns the order round. (By delegation: tables may
// come later.)
function sortBy(head) {
  const table = head.closest('table'), place = head.cellIndex;
  const turned = table.dataset.by == place ? -1 : 1;
  table.dataset.by = turned < 0 ? '' : place;
  const key = row => row.cells[place].textContent.trim();
  const compare = (a, b) => {
    const x = parseFloat(key(a)), y = parseFloat(key(b));
    return isNaN(x) || isNaN(y) ? key(a).localeCompare(key(b), 'en', {numeric: true}) : x - y;
  };
  for (const other of head.parentElement.cells) other.removeAttribute('aria-sort');
  head.setAttribute('aria-sort', turned < 0 ? 'descending' : 'ascending');
  [...table.tBodies[0].rows].sort((a, b) => turned * compare(a, b))
    .forEach(row => table.tBodies[0].append(row));
}
document.addEventListener('click', event => {
  const head = event.target.closest('th');
  if (head) sortBy(head);
});
document.addEventListener('keydown', event => {
  if (event.key === 'Enter' && event.target.tagName === 'TH') sortBy(event.target);
});
for (const head of document.querySelectorAll('th')) head.tabIndex = 0;
for (const window of document.querySelectorAll('.scroll'))
  if (window.scrollWidth > window.clientWidth || window.scrollHeight > window.clientHeight) {
    window.tabIndex = 0; // to be scrolled by keys
    window.setAttribute('role', 'region');
    window.setAttribute('aria-label', 'table');
  }
