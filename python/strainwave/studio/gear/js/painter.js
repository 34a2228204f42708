// The mesh on a canvas.

import { drawCross, fillHatched, hatch } from "strainwave-drawing";

import { bodyPath, trace, traceCoarsely, TURN } from "./paths.js";

// A tooth of so few pixels is drawn with chords, and without hatch or number.
const SMALL_TOOTH = 9, NUMBERED_TOOTH = 34;
// Beyond so many teeth in sight the circular spline is one path for good.
const MANY_TEETH = 80;
const LENGTHS_UM = [1, 2, 5];

export class Painter {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.ratio = 1;
  }
  resize(width, height) {
    this.ratio = globalThis.devicePixelRatio || 1;
    this.canvas.width = Math.round(width * this.ratio);
    this.canvas.height = Math.round(height * this.ratio);
    this.hatched = null;
  }
  /** Take another design. */
  take(mesh) {
    const tooth = new Path2D(), closed = new Path2D(), coarse = new Path2D();
    trace(tooth, mesh.tooth);
    closed.addPath(tooth);
    closed.closePath();
    traceCoarsely(coarse, mesh.tooth, 0.02 * mesh.module);
    coarse.closePath();
    Object.assign(this, {
      mesh, tooth, closed, coarse, rim: bodyPath(mesh.rim), ring: null,
      bodies: mesh.generator.map((body) => ({ ...body, path: bodyPath(body) })),
    });
  }
  /** `view` has camera, colours, angle, fixed, teeth, the hovered tooth and what is known of it. */
  draw(view) {
    const { context, mesh } = this, { camera, colours } = view;
    this.view = view;
    this.pixel = 1 / camera.scale;
    if (this.hatched !== colours) this.hatch = hatch(context, colours.edge, this.ratio);
    this.hatched = colours;
    const ring = mesh.turned(view.angle, view.fixed)[0] * Math.PI / 180;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.lineJoin = "round";
    this.circularSpline(ring);
    camera.place(context, this.ratio, 0, 0, view.angle * Math.PI / 180);
    this.body({ role: "flexspline", path: this.rim });
    for (const body of this.bodies) this.body(body);
    this.small = mesh.module * Math.PI * camera.scale < SMALL_TOOTH;
    const { reach, at } = camera.sight(), near = reach + 4 * mesh.module;
    const seen = view.teeth.filter((tooth) => Math.hypot(tooth.x - at[0], tooth.y - at[1]) < near);
    for (const tooth of seen) this.flexsplineTooth(tooth);
    if (!this.small) this.strokeRing(ring); // so that overlaps are seen
    for (const tooth of seen) if (tooth.number !== view.hovered) this.note(tooth);
    const hovered = view.teeth.find((tooth) => tooth.number === view.hovered);
    if (hovered) this.highlight(hovered);
    if (hovered && view.known) this.witnesses(hovered, view.known);
    this.scaleBar(colours);
  }
  body({ role, path }) {
    const { context } = this, { colours } = this.view, face = colours.faces[role];
    const line = role === "neutral curve";
    if (!line) {
      context.fillStyle = face;
      context.fill(path, "evenodd");
    }
    context.strokeStyle = line ? face : colours.edge;
    context.lineWidth = (line ? 1.2 : 0.7) * this.pixel;
    if (line) context.setLineDash([6, 2, 1.5, 2].map((dash) => dash * this.pixel));
    context.stroke(path);
    context.setLineDash([]);
  }
  /** The circular spline's teeth in sight and the body behind them, in the frame of the tooth in their middle. */
  circularSpline(turned) {
    const { context, mesh } = this, { camera, colours } = this.view, { reach, at } = camera.sight();
    const radius = Math.hypot(...at), pitch = TURN / mesh.ring_teeth;
    const count = radius > reach ? 2 * Math.ceil(Math.asin(reach / radius) / pitch) + 3 : Infinity;
    const whole = count > Math.min(MANY_TEETH, mesh.ring_teeth);
    const middle = whole ? 0 : Math.round((Math.atan2(at[0], at[1]) - turned) / pitch - 0.5);
    const key = whole ? "whole" : `${middle} ${count}`;
    if (this.ring?.key !== key) this.ring = { key, path: whole ? this.wholeRing() : this.someRing(middle, count) };
    this.ring.frame = whole ? { x: 0, y: 0, angle: 0 } : mesh.ringTooth(middle);
    this.placeRing(turned);
    context.fillStyle = colours.faces["circular spline"];
    context.fill(this.ring.path, "evenodd");
    this.strokeRing(turned);
  }
  placeRing(turned) {
    const { x, y, angle } = this.ring.frame, cosine = Math.cos(turned), sine = Math.sin(turned);
    this.view.camera.place(this.context, this.ratio, x * cosine + y * sine, y * cosine - x * sine, angle + turned);
  }
  strokeRing(turned) {
    const { context, mesh } = this, { camera, colours } = this.view;
    this.placeRing(turned);
    context.strokeStyle = colours.edge;
    context.lineWidth = (camera.scale * mesh.module < 4 ? 0.4 : 0.8) * this.pixel;
    context.stroke(this.ring.path);
  }
  wholeRing() {
    const { mesh } = this, path = new Path2D();
    for (let space = mesh.ring_teeth; space-- > 0; ) {
      const { x, y, angle } = mesh.ringTooth(space);
      trace(path, mesh.ring_tooth, x, y, angle, space === mesh.ring_teeth - 1);
    }
    path.closePath();
    path.moveTo(mesh.ring_outer_mm, 0);
    path.arc(0, 0, mesh.ring_outer_mm, 0, TURN);
    return path;
  }
  someRing(middle, count) {
    const { mesh } = this, path = new Path2D(), pitch = TURN / mesh.ring_teeth, half = count >> 1;
    // In the middle tooth's frame its tip points to the axis, which lies a pitch radius along +y; so places run the
    // other way round.
    const at = (steps, radius) =>
      [radius * Math.sin(steps * pitch), mesh.ring_pitch_mm - radius * Math.cos(steps * pitch)];
    for (let step = half; step >= -half; step--) {
      const [x, y] = at(-step, mesh.ring_pitch_mm);
      trace(path, mesh.ring_tooth, x, y, step * pitch, step === half);
    }
    const outer = mesh.ring_outer_mm, end = (half + 0.5) * pitch, up = -0.5 * Math.PI;
    path.lineTo(...at(half + 0.5, outer));
    path.arc(0, mesh.ring_pitch_mm, outer, up + end, up - end, true);
    path.closePath();
    return path;
  }
  put(tooth) {
    this.view.camera.place(this.context, this.ratio, tooth.x, tooth.y, tooth.angle);
  }
  flexsplineTooth(tooth) {
    const { context, mesh, small } = this, { colours } = this.view;
    this.put(tooth);
    context.fillStyle = colours.gap(tooth.gap, mesh.far_um);
    context.fill(small ? this.coarse : this.closed);
    context.strokeStyle = colours.edge;
    if (tooth.gap < 0 && !small) fillHatched(context, this.closed, this.hatch, this.ratio / this.pixel);
    context.lineWidth = (small ? 0.3 : 0.8) * this.pixel;
    context.stroke(small ? this.coarse : this.tooth);
  }
  /** Below a large tooth its number; beyond a small one that overlaps, a cross. */
  note(tooth) {
    const { mesh, small } = this, { camera, colours } = this.view, module = mesh.module;
    if (small && tooth.gap < 0) {
      const beyond = (mesh.ring_pitch_mm + 3.2 * module) / Math.hypot(tooth.x, tooth.y);
      this.cross(...camera.toScreen(tooth.x * beyond, tooth.y * beyond));
    } else if (module * Math.PI * camera.scale > NUMBERED_TOOTH) {
      const [px, py] = this.below(tooth);
      this.text(`${tooth.number}`.replace("-", "−"), px, py, colours.ink, tooth.gap < 0 ? "bold " : "");
    }
  }
  below(tooth) {
    const share = 1 - this.mesh.number_below_mm / Math.hypot(tooth.x, tooth.y);
    return this.view.camera.toScreen(tooth.x * share, tooth.y * share);
  }
  cross(px, py) {
    const { context } = this, { camera, colours } = this.view;
    const size = Math.min(Math.max(2, 1.7 * this.mesh.module * camera.scale), 4);
    this.screen();
    drawCross(context, px, py, size, colours.ink, colours.overlap);
  }
  highlight(tooth) {
    const { context, small } = this, { colours } = this.view;
    this.put(tooth);
    this.twice(colours.witness, (small ? 1.8 : 2.2) * this.pixel, 2.5 * this.pixel, small ? this.coarse : this.tooth);
    this.note(tooth);
  }
  /** The closest points of both flanks, the closer one's stronger. They are known in the frame of the tooth's lobe. */
  witnesses(tooth, known) {
    const { context } = this, { camera, colours } = this.view;
    const cosine = Math.cos(tooth.turn), sine = Math.sin(tooth.turn);
    this.screen();
    known.points_mm.forEach((pair, flank) => {
      const ends = pair.map(([x, y]) => camera.toScreen(x * cosine + y * sine, y * cosine - x * sine));
      const closer = flank === known.closer, between = new Path2D();
      between.moveTo(...ends[0]);
      between.lineTo(...ends[1]);
      this.twice(closer ? colours.witness : colours.quiet, closer ? 2.2 : 1.2, 3, between);
      context.fillStyle = colours.surface;
      for (const end of ends) {
        context.beginPath();
        context.arc(...end, closer ? 4 : 3, 0, TURN);
        context.fill();
        context.stroke();
      }
    });
  }
  /** A line with a rim, which sets it off from whatever lies below it. */
  twice(colour, width, rim, path) {
    const { context } = this;
    for (const [each, wide] of [[this.view.colours.surface, width + rim], [colour, width]]) {
      context.strokeStyle = each;
      context.lineWidth = wide;
      context.stroke(path);
    }
  }
  /** A round length below the picture, so that a zoom can be read. */
  scaleBar(colours) {
    const { context } = this, camera = this.view.camera, most_um = 120 / camera.scale * 1000;
    const power = 10 ** Math.floor(Math.log10(most_um));
    const length = power * LENGTHS_UM.findLast((each) => each * power <= most_um), wide = length / 1000 * camera.scale;
    const words = length < 1000 ? `${+length.toPrecision(1)} µm` : `${length / 1000} mm`;
    const x = 10, y = camera.height - 10, bar = new Path2D(`M${x} ${y - 4}V${y}H${x + wide}V${y - 4}`);
    this.screen();
    this.twice(colours.ink, 1.5, 3, bar);
    this.text(words, x + 0.5 * wide, y - 10, colours.ink);
  }
  screen() {
    this.context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
  }
  text(words, px, py, colour, weight = "") {
    const { context } = this;
    this.screen();
    context.font = `${weight}11px "DejaVu Sans", Verdana, sans-serif`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    // Legible over dark teeth too.
    context.strokeStyle = this.view.colours.surface;
    context.lineWidth = 3;
    context.strokeText(words, px, py);
    context.fillStyle = colour;
    context.fillText(words, px, py);
  }
}
