// The generator's angle: by the slider, by its number, by dragging, or playing. The angle is not wrapped, for after a
// turn each tooth stands elsewhere.

const DEGREE = Math.PI / 180;
const MOST_DEG = 360000;
const LONGEST_STEP_S = 0.1;

export const turning = {
  data: () => ({ playing: false, speed: 15, angle: 0, fixed: "circular-spline", turnedWords: "" }),
  computed: {
    wrapped() { return ((this.angle % 360) + 360) % 360; },
    shownAngle() { return Math.round(this.angle * 100) / 100; },
  },
  watch: {
    angle() { this.turned(); },
    fixed() { this.turned(); },
  },
  methods: {
    play(on) {
      this.playing = on;
      this.playedAt = null;
      if (on) this.paint();
    },
    /** The next frame while playing. A page that was out of sight does not catch up. */
    advance(now) {
      const seconds = this.playedAt === null ? 0 : Math.min((now - this.playedAt) / 1000, LONGEST_STEP_S);
      this.playedAt = now;
      this.turnTo(this.angle + seconds * this.speed);
    },
    turnTo(degrees) {
      if (Number.isFinite(degrees)) this.angle = Math.abs(degrees) > MOST_DEG ? 0 : degrees;
    },
    /** Follow a pointer from one polar angle to another, the shorter way round. */
    drag(from, to) {
      this.play(false);
      this.turnTo(this.angle + Math.atan2(Math.sin(to - from), Math.cos(to - from)) / DEGREE);
    },
    slide(event) {
      this.turnTo(this.angle - this.wrapped + Number(event.target.value));
    },
    type(event) {
      this.turnTo(event.target.value === "" ? NaN : Number(event.target.value));
      event.target.value = this.shownAngle;
    },
    turned() {
      this.sayTurned();
      this.paint();
    },
    sayTurned() {
      if (!this.mesh) return;
      const free = this.fixed === "flexspline" ? 0 : 1, degrees = this.mesh.turned(this.angle, this.fixed)[free];
      this.turnedWords = `${["circular spline", "flexspline"][free]} at ${degrees.toFixed(3).replace("-", "−")}°`;
    },
  },
};
