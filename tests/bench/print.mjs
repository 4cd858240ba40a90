// SPDX-License-Identifier: MIT
// A line of a table.
export function line(first, cells, last = '', width = 8, name = 34) {
  console.log(first.padEnd(name) + cells.map((x) => String(x).padStart(width)).join('') + '  ' + last)
}
