// What the animation's page and the studio draw alike: colours of clearances, and marks that are seen without colours.

/** The numbers in a text of single-precision bytes. */
export const unpacked = (text) => new Float32Array(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer);

/** `colours` run evenly from touching to `far_um`; what overlaps has one of its own. */
export function gapColour(gap_um, far_um, colours, overlap) {
  if (gap_um < 0) return overlap;
  return colours[Math.min(colours.length - 1, Math.floor(gap_um / far_um * colours.length))];
}

/** Crossed lines as a pattern, some pixels apart. */
export function hatch(context, colour, ratio) {
  const tile = document.createElement("canvas"), side = Math.round(9 * ratio), pen = tile.getContext("2d");
  tile.width = tile.height = side;
  pen.strokeStyle = colour;
  pen.lineWidth = 0.8 * ratio;
  for (const shift of [-side, 0, side]) {
    pen.moveTo(shift - 1, -1);
    pen.lineTo(shift + side + 1, side + 1);
    pen.moveTo(shift + side + 1, -1);
    pen.lineTo(shift - 1, side + 1);
  }
  pen.stroke();
  return context.createPattern(tile, "repeat");
}

/** Fills a path with a hatch whose lines stay as they are, however many pixels a unit of the context has. */
export function fillHatched(context, path, pattern, pixels) {
  pattern.setTransform(new DOMMatrix().scale(1 / pixels));
  context.fillStyle = pattern;
  context.fill(path);
}

/** A cross in pixels, with a rim. */
export function drawCross(context, x, y, size, rim, face) {
  context.beginPath();
  for (const s of [1, -1]) {
    context.moveTo(x - size, y - s * size);
    context.lineTo(x + size, y + s * size);
  }
  for (const [colour, width] of [[rim, 0.9 * size + 0.6], [face, 0.5 * size + 0.3]]) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.stroke();
  }
}
