// SPDX-License-Identifier: BSD-3-Clause
// 4 x 4 matrices, column by column, for the 3D view.
"use strict";

function multiplied(a, b) {
  const out = new Float32Array(16);
  for (let c = 0; c < 4; ++c)
    for (let r = 0; r < 4; ++r)
      for (let k = 0; k < 4; ++k) out[4 * c + r] += a[4 * k + r] * b[4 * c + k];
  return out;
}

function perspective(fieldOfView, aspect, near, far) {
  const f = 1 / Math.tan(fieldOfView / 2);
  const out = new Float32Array(16);
  out[0] = f / aspect;
  out[5] = f;
  out[10] = (far + near) / (near - far);
  out[11] = -1;
  out[14] = 2 * far * near / (near - far);
  return out;
}

/** From the world, z up, to an eye that looks at the world's origin from yaw, pitch, distance. */
function orbit(yaw, pitch, distance) {
  const cy = Math.cos(yaw), sy = Math.sin(yaw), cp = Math.cos(pitch), sp = Math.sin(pitch);
  return new Float32Array([
    -sy, -sp * cy, cp * cy, 0,
    cy, -sp * sy, cp * sy, 0,
    0, cp, sp, 0,
    0, 0, -distance, 1,
  ]);
}

/** A point through a matrix to -1..1, and its w; w <= 0: behind the eye. */
function projected(m, x, y, z) {
  const w = m[3] * x + m[7] * y + m[11] * z + m[15];
  return {x: (m[0] * x + m[4] * y + m[8] * z + m[12]) / w,
          y: (m[1] * x + m[5] * y + m[9] * z + m[13]) / w, w};
}
