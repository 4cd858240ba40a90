// SPDX-License-Identifier: MIT
// The models in double precision, from the shininess n and t = 1 - c. Equation numbers: see glint.h.
const power = (n, t) => Math.exp(n * Math.log1p(-t))

export const real = {
  msh: (n, t) => 2 * (1 - t) / (1.25 * (n * t + 1.25 * (1 - t)) ** 2), // (5)
  schlick: (n, t) => (1 - t) / (n * t + 1 - t), // (2)
  blinn: power, // (1)
  gauss: (n, t) => Math.exp(-n / 2 * Math.acos(1 - t) ** 2), // (1)
  cayley: (n, t) => n <= 4 ? power(n, t) : (Math.max(0, 4 * (2 - t) - n * t) / (4 * (2 - t) + n * t)) ** 4,
  lyon: (n, t) => Math.max(0, 1 - n * t / 4) ** 4
}
