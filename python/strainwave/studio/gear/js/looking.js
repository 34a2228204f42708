// The view of the mesh: whole, on a tooth, on its closest points.

const PITCHES_SEEN = 6, PITCHES_HIGH = 2.2, LOWERED = 0.35; // of the view of a tooth, in pitches
const GAP_PX = 90, LEAST_UM = 0.05; // what a gap is zoomed to, and what counts for smaller ones
const KEY_ZOOM = 1.25, KEY_PAN = 40;
const PANS = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

export const looking = {
  methods: {
    zoom(factor, x, y) {
      this.camera.zoom(factor, x, y);
      this.paint();
    },
    pan(dx, dy) {
      this.camera.pan(dx, dy);
      this.paint();
    },
    showWhole() {
      this.follows = null;
      this.camera.whole();
      this.paint();
    },
    /** A tooth upright in the middle, and so as the generator turns; without one the chosen or the closest tooth. */
    followTooth(number) {
      if (!this.teeth || number === null) return;
      number ??= this.hovered ?? this.follows ?? this.closest();
      this.follows = number;
      this.choose(number);
      const pitch = Math.PI * this.mesh.module, { width, height } = this.camera;
      const scale = Math.min(width / PITCHES_SEEN, height / PITCHES_HIGH) / pitch;
      this.camera.look(0, 0, this.mesh.ring_pitch_mm - LOWERED * pitch, scale);
      this.paint();
    },
    keepFollowing() {
      const tooth = this.teeth.find((each) => each.number === this.follows);
      this.camera.turn = Math.atan2(tooth.x, tooth.y);
    },
    /** Its closest points so large that their distance is seen, as soon as the server has said where they are. */
    showGap() {
      if (!this.teeth) return;
      if (this.follows === null || (this.hovered !== null && this.follows !== this.hovered)) this.followTooth();
      this.wantsGap = !this.isCurrent();
      if (this.wantsGap) {
        this.ask();
        return;
      }
      this.keepFollowing();
      const { tooth, closer, points_mm, gaps_um } = this.known, [one, other] = points_mm[closer];
      const turn = this.teeth.find((each) => each.number === tooth).turn - this.camera.turn;
      const [x, y] = [0, 1].map((axis) => 0.5 * (one[axis] + other[axis]));
      const cosine = Math.cos(turn), sine = Math.sin(turn);
      this.camera.look(this.camera.turn, x * cosine + y * sine, y * cosine - x * sine,
        GAP_PX / Math.max(Math.abs(gaps_um[closer]), LEAST_UM) * 1000);
      this.paint();
    },
    polar(px, py) {
      return Math.atan2(...this.camera.toWorld(px, py));
    },
    radius(px, py) {
      return Math.hypot(...this.camera.toWorld(px, py));
    },
    onGenerator(px, py) {
      return this.mesh !== null && this.radius(px, py) < this.mesh.rim_outer_mm;
    },
    meshKey(event) {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (event.key === "+" || event.key === "=") this.zoom(KEY_ZOOM);
      else if (event.key === "-") this.zoom(1 / KEY_ZOOM);
      else if (event.key === "0") this.showWhole();
      else if (event.key === "t") this.followTooth();
      else if (event.key === "g") this.showGap();
      else if (event.key === " ") this.play(!this.playing);
      else if (event.key in PANS) this.pan(...PANS[event.key].map((step) => KEY_PAN * step));
      else return;
      event.preventDefault();
    },
  },
};
