// Chains of arcs and lines as canvas paths: exact at every zoom.
//
// A segment is [x, y, angle of the outward normal, curvature, length]; all angles run clockwise from +y, lengths in mm.

import { unpacked } from "strainwave-drawing";

export const TURN = 2 * Math.PI;

/** Adds a chain of segments, whose frame stands at x, y and a clockwise angle, to a path in coordinates with y up. */
export function trace(path, segments, x = 0, y = 0, angle = 0, begin = true) {
  const cosine = Math.cos(angle), sine = Math.sin(angle);
  segments.forEach(([px, py, own, curvature, length], place) => {
    const sx = x + cosine * px + sine * py, sy = y - sine * px + cosine * py, normal = own + angle;
    if (place === 0) begin ? path.moveTo(sx, sy) : path.lineTo(sx, sy);
    if (curvature === 0) {
      path.lineTo(sx + length * Math.cos(normal), sy - length * Math.sin(normal));
      return;
    }
    const radius = 1 / curvature, convex = curvature > 0;
    const from = (convex ? 0.5 : 1.5) * Math.PI - normal;
    path.arc(sx - radius * Math.sin(normal), sy - radius * Math.cos(normal), Math.abs(radius), from,
      from - curvature * length, convex);
  });
}

/** The same chain with chords, for where a tooth is a few pixels high. */
export function traceCoarsely(path, segments, chord_mm) {
  const at = ([x, y, normal, curvature], s) => {
    const half = 0.5 * curvature * s, along = half === 0 ? s : s * Math.sin(half) / half;
    return [x + along * Math.cos(normal + half), y - along * Math.sin(normal + half)];
  };
  segments.forEach((segment, place) => {
    const longest = Math.sqrt(8 * chord_mm / Math.abs(segment[3])); // infinite for a line
    const count = Math.max(1, Math.ceil(segment[4] / longest));
    if (place === 0) path.moveTo(segment[0], segment[1]);
    for (let step = 1; step <= count; step++) path.lineTo(...at(segment, segment[4] * step / count));
  });
}

/** A smooth closed curve through points x0, y0, x1, …: cubics with the slopes of Catmull and Rom. */
export function traceCurve(path, points) {
  const count = points.length / 2;
  const x = (i) => points[2 * ((i + count) % count)], y = (i) => points[2 * ((i + count) % count) + 1];
  path.moveTo(x(0), y(0));
  for (let i = 0; i < count; i++) {
    path.bezierCurveTo(
      x(i) + (x(i + 1) - x(i - 1)) / 6, y(i) + (y(i + 1) - y(i - 1)) / 6,
      x(i + 1) - (x(i + 2) - x(i)) / 6, y(i + 1) - (y(i + 2) - y(i)) / 6, x(i + 1), y(i + 1));
  }
  path.closePath();
}

/** A body of curves, circles and lines. */
export function bodyPath(body) {
  const path = new Path2D();
  for (const curve of body.curves) traceCurve(path, unpacked(curve));
  for (const [x, y, radius] of body.circles) {
    path.moveTo(x + radius, y);
    path.arc(x, y, radius, 0, TURN);
  }
  for (const line of body.lines) line.forEach(([x, y], place) => (place ? path.lineTo(x, y) : path.moveTo(x, y)));
  return path;
}
