// A design on the page: where each of its teeth stands and how close it is, at any angle of the generator.

import { unpacked } from "strainwave-drawing";

const DEGREE = Math.PI / 180;
export const SPLINES = ["circular-spline", "flexspline"];

/** The gaps of either flank over the tooth index; even rows, between which cubics run. */
export class GapTable {
  constructor(message) {
    this.step = message.step;
    this.gaps = unpacked(message.gaps_um);
    this.last = this.gaps.length / 2 - 2; // rows from the major axis on
  }
  /** The row left of an index >= 0 and the weights of four rows from there on (Lagrange). */
  stencil(index) {
    const place = index / this.step, row = Math.min(Math.floor(place), this.last - 2), t = place - row;
    return [row, [-t * (t - 1) * (t - 2) / 6, (t + 1) * (t - 1) * (t - 2) / 2, -(t + 1) * t * (t - 2) / 2,
      (t + 1) * t * (t - 1) / 6]];
  }
  value(numbers, width, column, [row, weights]) {
    let sum = 0;
    for (let i = 0; i < 4; i++) sum += weights[i] * numbers[width * (row + i) + column];
    return sum;
  }
  /** The lesser gap of both flanks at an index of the lobe. */
  gap(index) {
    const at = this.stencil(Math.abs(index));
    return Math.min(this.value(this.gaps, 2, 0, at), this.value(this.gaps, 2, 1, at));
  }
  /** Every other row on both sides of the axis: as fine as a chart's pixels. */
  curve() {
    const points = [];
    for (let row = -this.last; row <= this.last; row += 2) {
      const at = 2 * (Math.abs(row) + 1);
      points.push([row * this.step, Math.min(this.gaps[at], this.gaps[at + 1])]);
    }
    return points;
  }
}

export class Mesh extends GapTable {
  constructor(message) {
    super(message);
    Object.assign(this, message);
    this.gaps = unpacked(message.gaps_um);
    this.poses = unpacked(message.poses);
    const half = (this.teeth - 1) >> 1;
    this.numbers = Array.from({ length: this.teeth }, (_, i) => i - half);
  }
  /** How far the circular spline and the flexspline have turned, degrees. */
  turned(generator_deg, fixed) {
    return this.turns[fixed].map((share) => share * generator_deg);
  }
  /** The generator's angle against the circular spline, on which all engagement depends, degrees. */
  relative(generator_deg, fixed) {
    return generator_deg - this.turned(generator_deg, fixed)[0];
  }
  /**
   * A tooth: its index folded into the lobe, which lobe that is, its gap, and where its frame stands at rest: x, y,
   * and a clockwise angle. `turn` is the clockwise turn of its lobe's frame.
   */
  toothAt(number, generator_deg, fixed) {
    const unfolded = number - this.relative(generator_deg, fixed) / 360 * this.ring_teeth;
    const lobe = Math.round(2 * unfolded / this.teeth), index = unfolded - 0.5 * lobe * this.teeth;
    const at = this.stencil(Math.abs(index)), side = index < 0 ? -1 : 1;
    const [x, y, tilt] = [0, 1, 2].map((column) => this.value(this.poses, 3, column, at));
    const turn = generator_deg * DEGREE + lobe * Math.PI, space = turn + 2 * Math.PI * index / this.ring_teeth;
    const cosine = Math.cos(space), sine = Math.sin(space), out = this.ring_pitch_mm + y;
    return {
      number, index, turn,
      upper: lobe % 2 === 0, // in the lobe of the axis's head
      gap: Math.min(this.value(this.gaps, 2, 0, at), this.value(this.gaps, 2, 1, at)),
      x: side * x * cosine + out * sine, y: out * cosine - side * x * sine, angle: space + side * tilt,
    };
  }
  all(generator_deg, fixed) {
    return this.numbers.map((number) => this.toothAt(number, generator_deg, fixed));
  }
  /** The frame of the circular spline's tooth clockwise of a space, before the spline has turned. */
  ringTooth(space) {
    const angle = 2 * Math.PI * (space + 0.5) / this.ring_teeth;
    return { x: this.ring_pitch_mm * Math.sin(angle), y: this.ring_pitch_mm * Math.cos(angle), angle: angle + Math.PI };
  }
}
