// The mesh with its controls, and the distribution below it. The server sends a design once; turning, zooming and
// playing happen here. What is said in numbers about a tooth comes from the server, exactly.

import { Camera } from "strainwave-gear/camera.js";
import { Distribution } from "strainwave-gear/distribution.js";
import { looking } from "strainwave-gear/looking.js";
import { Mesh } from "strainwave-gear/mesh.js";
import { Painter } from "strainwave-gear/painter.js";
import { onTheme, palette } from "strainwave-gear/palette.js";
import { listen } from "strainwave-gear/pointer.js";
import { pointing } from "strainwave-gear/pointing.js";
import { turning } from "strainwave-gear/turning.js";

const AROUND = 6; // modules beyond the pitch circle in a view of the whole gear

export default {
  mixins: [turning, looking, pointing],
  template: `
    <div class="gear">
      <div class="gear-mesh" ref="frame">
        <canvas ref="canvas" tabindex="0" role="application" :aria-label="meshLabel" @keydown="meshKey"></canvas>
        <div class="gear-card" v-show="card" :class="{ 'gear-late': late }" :aria-live="playing ? 'off' : 'polite'">
          <template v-if="card">
            <b>Tooth <span data-of="tooth">{{ card.tooth }}</span></b> index
            <span data-of="index">{{ card.index }}</span>
            <dl>
              <dt :class="{ 'gear-closer': card.flank === 0 }">left flank</dt><dd data-of="left">{{ card.left }}</dd>
              <dt :class="{ 'gear-closer': card.flank === 1 }">right flank</dt><dd data-of="right">{{ card.right }}</dd>
            </dl>
            <span data-of="closer">{{ card.closer }}</span>
          </template>
        </div>
        <output class="gear-turned">{{ turnedWords }}</output>
        <div class="gear-note" v-if="missing">The generator's parts are not drawn: {{ missing }}</div>
        <div class="gear-scale" aria-hidden="true">
          <div :style="{ background: gradient }"></div>
          <p><span>0</span><span>{{ far / 2 }}</span><span>{{ far }} µm +</span></p>
          <p v-if="interferes"><i :style="{ background: overlapFace }"></i>interferes</p>
        </div>
        <div class="gear-views">
          <button type="button" @click="showWhole" title="The whole gear (0)">Whole</button>
          <button type="button" @click="followTooth()"
            title="Follow the tooth that is chosen, or the closest one (T)">Tooth</button>
          <button type="button" @click="showGap" title="Zoom in on that tooth's closest points (G)">Gap</button>
          <button type="button" @click="zoom(1.6)" aria-label="Zoom in" title="Zoom in (+)">+</button>
          <button type="button" @click="zoom(1 / 1.6)" aria-label="Zoom out" title="Zoom out (−)">−</button>
        </div>
      </div>
      <div class="gear-controls">
        <button type="button" class="gear-play" @click="play(!playing)" title="Turn the wave generator (space)">
          {{ playing ? "Pause" : "Play" }}</button>
        <select v-model.number="speed" aria-label="Speed of the generator" title="Speed of the generator">
          <option v-for="each in [1, 5, 15, 60, 180]" :key="each" :value="each">{{ each }} °/s</option>
        </select>
        <input type="range" min="0" max="360" step="0.1" :value="wrapped" @input="slide"
          aria-label="Generator angle within a turn, degrees">
        <label title="Angle of the wave generator"><input type="number" step="1" :value="shownAngle" @change="type"
          aria-label="Generator angle, degrees"> °</label>
        <select v-model="fixed" aria-label="Spline held fixed" title="Which spline stands still">
          <option value="circular-spline">circular spline fixed</option>
          <option value="flexspline">flexspline fixed</option>
        </select>
      </div>
      <p class="gear-keys"><span>{{ beyond }}</span><span><i class="gear-curve"></i>every generator angle</span><span><i
        class="gear-bar"></i>teeth now</span><span v-if="reference"
        class="gear-name"><i class="gear-reference"></i>{{ reference }}</span></p>
      <div class="gear-chart" ref="plot" tabindex="0" role="application" :aria-label="chartLabel" @keydown="chartKey"
           @pointermove="chartPoint" @pointerdown="chartPoint" @pointerleave="leave" @dblclick="followTooth()">
        <canvas ref="bars"></canvas>
        <div ref="chart"></div>
      </div>
    </div>`,
  props: { scale: Array, overlap: String },
  data: () => ({ missing: "", far: 40, gradient: "", reference: "", least: "", beyond: "", interferes: false }),
  computed: {
    overlapFace() { return `repeating-linear-gradient(45deg, #222 0 1px, transparent 1px 4px), ${this.overlap}`; },
    meshLabel() { return "The mesh. Plus and minus zoom, arrows move the view, 0 shows the whole gear."; },
    chartLabel() { return `Backlash of every tooth, least in motion ${this.least}. Arrows go from tooth to tooth.`; },
  },
  async mounted() {
    // What is not to be watched by Vue.
    const nothing = { mesh: null, known: null, next: null, follows: null, chosen: null };
    Object.assign(this, nothing, { dirty: false, chartDirty: false });
    this.camera = new Camera();
    this.painter = new Painter(this.$refs.canvas);
    this.endTheme = onTheme(() => this.recolour());
    this.sizes = new ResizeObserver(() => this.resize());
    this.sizes.observe(this.$refs.frame);
    this.sizes.observe(this.$refs.plot);
    listen(this.$refs.canvas, {
      turns: (x, y) => this.onGenerator(x, y),
      turn: (from, to) => this.drag(this.polar(from.x, from.y), this.polar(to.x, to.y)),
      pan: (dx, dy) => this.pan(dx, dy),
      zoom: (factor, x, y) => this.zoom(factor, x, y),
      point: (x, y) => this.point(this.toothUnder(x, y)),
      leave: () => this.leave(),
      click: (x, y) => this.choose(this.toothUnder(x, y)),
      follow: (x, y) => this.followTooth(this.toothUnder(x, y)),
    });
    const { echarts } = await import("nicegui-echart");
    if (!this.$el.isConnected) return;
    this.distribution = new Distribution(echarts, this.$refs.chart, this.$refs.bars);
    this.distribution.refer(this.referred);
    this.recolour();
    this.resize();
  },
  activated() {
    if (this.wasAway) this.$emit("awake", this.mesh?.number ?? 0);
    this.wasAway = false;
    this.paint();
  },
  deactivated() {
    this.wasAway = true;
    this.play(false);
  },
  beforeUnmount() {
    this.playing = false;
    this.endTheme?.();
    this.sizes?.disconnect();
    this.distribution?.dispose();
  },
  methods: {
    /** Another design. Of those that come between two frames only the last is drawn. */
    show(message) {
      this.next = message;
      this.paint();
    },
    /** Another reference, or none. */
    refer(message) {
      this.referred = message;
      this.reference = message?.name ?? "";
      this.distribution?.refer(message);
      this.redrawChart();
    },
    paint() {
      if (this.dirty) return;
      this.dirty = true;
      requestAnimationFrame((now) => this.frame(now));
    },
    redrawChart() {
      this.chartDirty = true;
      this.paint();
    },
    frame(now) {
      this.dirty = false;
      if (!this.distribution || !this.camera.seen || !(this.next || this.mesh)) return;
      const number = this.take();
      if (this.playing) this.advance(now);
      this.teeth = this.mesh.all(this.angle, this.fixed);
      if (this.follows !== null) this.keepFollowing();
      this.late = !this.isCurrent();
      if (this.late) this.ask();
      this.painter.draw({ camera: this.camera, colours: this.colours, angle: this.angle, fixed: this.fixed,
        teeth: this.teeth, hovered: this.hovered, known: this.late ? null : this.known });
      if (number || this.chartDirty) this.distribution.redraw(this.mesh, this.colours, this.chartDirty);
      this.chartDirty = false;
      this.distribution.glide(this.teeth, this.hovered);
      if (number) document.documentElement.dataset.drawn = number;
      if (this.playing) this.paint();
    },
    /** Go over to the design that waits, if one does; gives its number. */
    take() {
      const message = this.next, before = this.mesh;
      if (!message) return 0;
      this.next = this.known = null;
      this.mesh = new Mesh(message);
      this.painter.take(this.mesh);
      const { missing, far_um: far, least, beyond } = message;
      Object.assign(this, { missing, far, least: least.words, beyond, interferes: least.gap_um < 0 });
      this.forget(this.mesh.numbers);
      // Only where it has changed, so that an enlarged gap stays in sight while w0 is changed.
      if (before && before.ring_pitch_mm !== this.mesh.ring_pitch_mm) {
        this.camera.grow(this.mesh.ring_pitch_mm / before.ring_pitch_mm);
      }
      this.camera.resize(this.camera.width, this.camera.height, this.reach());
      if (!before || (this.follows !== null && !this.mesh.numbers.includes(this.follows))) this.showWhole();
      this.sayTurned();
      return message.number;
    },
    reach() {
      return this.mesh.ring_pitch_mm + AROUND * this.mesh.module;
    },
    resize() {
      const { clientWidth: width, clientHeight: height } = this.$refs.frame, plot = this.$refs.plot;
      this.camera.seen = width > 0 && height > 0;
      if (!this.camera.seen || !this.distribution) return;
      this.painter.resize(width, height);
      this.camera.resize(width, height, this.mesh ? this.reach() : 1);
      this.distribution.resize(plot.clientWidth, plot.clientHeight);
      this.redrawChart();
    },
    recolour() {
      this.colours = palette(this.$el, this.scale, this.overlap);
      this.gradient = `linear-gradient(to right, ${this.colours.scale.join(", ")})`;
      this.redrawChart();
    },
  },
};
