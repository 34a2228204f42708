// The tooth that is pointed at in the mesh or in the chart, and what the server says of it. A tooth that has been
// clicked stays chosen while nothing else is pointed at.

const ASK_MS = 50; // between two questions
const LOST_MS = 2000; // an answer that has not come by then will not

export const pointing = {
  data: () => ({ hovered: null, card: null, late: false }),
  watch: {
    hovered() {
      this.known = null;
      if (this.hovered === null) this.card = null;
      this.paint();
    },
  },
  methods: {
    upper() {
      return this.teeth.filter((tooth) => tooth.upper);
    },
    closest() {
      return this.upper().reduce((best, tooth) => (tooth.gap < best.gap ? tooth : best)).number;
    },
    toothUnder(px, py) {
      if (!this.teeth || this.onGenerator(px, py)) return null;
      if (this.radius(px, py) > this.mesh.ring_pitch_mm + 3 * this.mesh.module) return null;
      const [x, y] = this.camera.toWorld(px, py), far = (tooth) => Math.hypot(tooth.x - x, tooth.y - y);
      return this.teeth.reduce((best, tooth) => (far(tooth) < far(best) ? tooth : best)).number;
    },
    point(number) { this.hovered = number ?? this.chosen; },
    choose(number) { this.hovered = this.chosen = number; },
    leave() { this.hovered = this.chosen; },
    /** Another design may have fewer teeth. */
    forget(numbers) {
      if (!numbers.includes(this.chosen)) this.chosen = null;
      if (!numbers.includes(this.hovered)) this.hovered = this.chosen;
    },
    /** Whether what is known is of the tooth that is pointed at, where it stands now. */
    isCurrent() {
      return this.known !== null && this.known.tooth === this.hovered
        && this.known.relative_deg === this.mesh.relative(this.angle, this.fixed);
    },
    /** One question at a time; what has changed meanwhile is asked after its answer. */
    ask() {
      if (this.hovered === null || !this.mesh) return;
      const now = performance.now();
      this.askAgain = this.asking && now - this.askedAt < LOST_MS;
      if (this.askAgain) return;
      this.asking = true;
      const wait = Math.max(0, ASK_MS - (now - (this.askedAt ?? -ASK_MS)));
      this.askedAt = now + wait;
      setTimeout(() => {
        if (this.hovered === null) this.asking = false;
        else this.$emit("point", { tooth: this.hovered, relative_deg: this.mesh.relative(this.angle, this.fixed) });
      }, wait);
    },
    answer(known) {
      this.asking = false;
      if (known && known.tooth === this.hovered) {
        this.known = known;
        this.card = { ...known.words, flank: known.closer };
        this.paint();
        if (this.wantsGap && this.isCurrent()) this.showGap();
      }
      if (this.askAgain) this.ask();
    },
    chartPoint(event) {
      if (!this.teeth || !this.distribution) return;
      const across = event.clientX - this.$refs.plot.getBoundingClientRect().left;
      const { number } = this.distribution.nearest(this.teeth, across);
      if (event.type === "pointerdown") this.choose(number);
      else this.point(number);
    },
    /** From tooth to tooth by arrows, beginning at the closest one. */
    chartKey(event) {
      const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (event.key === "Escape") this.choose(null);
      else if (event.key === "Enter" && this.hovered !== null) this.followTooth();
      else if (step && this.teeth) {
        const upper = this.upper().sort((a, b) => a.index - b.index), numbers = upper.map((tooth) => tooth.number);
        const place = numbers.indexOf(this.hovered ?? this.closest()) + (this.hovered === null ? 0 : step);
        this.choose(numbers[Math.min(Math.max(place, 0), numbers.length - 1)]);
      } else return;
      event.preventDefault();
    },
  },
};
