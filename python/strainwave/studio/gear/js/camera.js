// From where the mesh is looked at. All in double precision and relative to the middle of the view, so that nothing
// jitters at the finest zoom.

const FINEST = 1e6; // pixels per mm: a pixel is a nanometre
const COARSEST = 0.5; // of the scale at which the whole gear fits

export class Camera {
  constructor() {
    this.width = this.height = 1;
    this.turn = 0; // clockwise turn of the world that is seen upright, radians
    this.x = this.y = 0; // middle of the view in the frame so turned, mm
    this.scale = 1; // pixels per mm
    this.fitting = 1; // scale at which the whole fits
    this.isWhole = true;
  }
  resize(width, height, reach_mm) {
    const before = Math.min(this.width, this.height);
    this.width = width;
    this.height = height;
    this.fitting = Math.min(width, height) / (2 * reach_mm);
    if (this.isWhole) this.whole();
    else this.scale *= Math.min(width, height) / before;
  }
  whole() {
    Object.assign(this, { turn: 0, x: 0, y: 0, scale: this.fitting, isWhole: true });
  }
  look(turn, x, y, scale) {
    Object.assign(this, { turn, x, y, scale: this.bounded(scale), isWhole: false });
  }
  bounded(scale) {
    return Math.min(Math.max(scale, COARSEST * this.fitting), FINEST);
  }
  /** Go over to a gear whose lengths are so many times as large, looking at the same part of it. */
  grow(times) {
    this.x *= times;
    this.y *= times;
    this.scale /= times;
  }
  /** Zoom, what is at a pixel staying there. */
  zoom(factor, px = 0.5 * this.width, py = 0.5 * this.height) {
    const scale = this.bounded(this.scale * factor), dx = px - 0.5 * this.width, dy = 0.5 * this.height - py;
    this.x += dx / this.scale - dx / scale;
    this.y += dy / this.scale - dy / scale;
    this.scale = scale;
    this.isWhole = false;
  }
  pan(px, py) {
    this.x -= px / this.scale;
    this.y += py / this.scale;
    this.isWhole = false;
  }
  toScreen(x, y) {
    const cosine = Math.cos(this.turn), sine = Math.sin(this.turn);
    return [0.5 * this.width + (x * cosine - y * sine - this.x) * this.scale,
      0.5 * this.height - (x * sine + y * cosine - this.y) * this.scale];
  }
  toWorld(px, py) {
    const x = this.x + (px - 0.5 * this.width) / this.scale, y = this.y + (0.5 * this.height - py) / this.scale;
    const cosine = Math.cos(this.turn), sine = Math.sin(this.turn);
    return [x * cosine + y * sine, y * cosine - x * sine];
  }
  /** Let a context draw in mm in a frame that stands at x, y and a clockwise angle. */
  place(context, ratio, x, y, angle) {
    const [px, py] = this.toScreen(x, y), scale = this.scale * ratio;
    const cosine = scale * Math.cos(angle - this.turn), sine = scale * Math.sin(angle - this.turn);
    context.setTransform(cosine, sine, sine, -cosine, px * ratio, py * ratio);
  }
  /** Radius of a circle about the middle of the view that holds all of it, mm, and where that middle is. */
  sight() {
    const reach = 0.5 * Math.hypot(this.width, this.height) / this.scale;
    return { reach, at: this.toWorld(0.5 * this.width, 0.5 * this.height) };
  }
}
