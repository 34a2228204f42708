// A plotly figure in space, fetched from an address of this studio, with a box for each body that hides it.

const CONFIG = {
  displaylogo: false, scrollZoom: true, displayModeBar: "hover",
  modeBarButtonsToRemove: ["tableRotation", "hoverClosest3d"],
  toImageButtonOptions: { format: "png", filename: "strainwave", scale: 2 },
};
const NO_WEBGL =
  "This browser draws nothing in space (WebGL is switched off or missing); all figures hold without the picture.";

const isDark = () => document.body.classList.contains("body--dark");
const hasWebgl = () => {
  const context = document.createElement("canvas").getContext("webgl");
  context?.getExtension("WEBGL_lose_context")?.loseContext(); // browsers allow few at once
  return context !== null;
};

export default {
  template: `
    <div class="space-turnable">
      <fieldset class="space-bodies" v-show="bodies.length && !problem">
        <legend class="space-hidden">Bodies</legend>
        <label v-for="(body, place) in bodies" :key="body.name">
          <input type="checkbox" v-model="body.shown" @change="show(place)">
          <span class="space-swatch" :style="{ background: body.colour }"></span>{{ body.name }}
        </label>
      </fieldset>
      <p v-if="problem" class="space-problem" role="status">{{ problem }}</p>
      <div ref="picture" class="space-picture" role="img" :aria-label="label" v-show="!problem"></div>
    </div>
  `,
  props: { address: String, label: String },
  data() {
    return { bodies: [], problem: "" };
  },
  async mounted() {
    if (!hasWebgl()) {
      this.problem = NO_WEBGL;
      return;
    }
    this.Plotly = (await import("nicegui-plotly")).Plotly;
    if (!this.$el.isConnected) return;
    this.theme = new MutationObserver(() => this.figure && this.drawnDark !== isDark() && this.draw());
    this.theme.observe(document.body, { attributes: true, attributeFilter: ["class"] });
    this.size = new ResizeObserver(() => this.resize());
    this.size.observe(this.$refs.picture);
    this.fetch();
  },
  // Seen again after another tab: what could not be drawn then may be drawn now.
  activated() {
    if (this.problem) this.fetch();
  },
  unmounted() {
    this.theme?.disconnect();
    this.size?.disconnect();
    if (this.drawn) this.Plotly.purge(this.$refs.picture);
  },
  watch: {
    address() {
      this.fetch();
    },
  },
  methods: {
    async fetch() {
      const address = this.address;
      if (!this.Plotly || !address) return;
      try {
        const answer = await fetch(window.path_prefix + address);
        if (!answer.ok) throw new Error(answer.statusText);
        const figure = await answer.json();
        if (address !== this.address) return;
        this.figure = figure;
        await this.draw();
      } catch (error) {
        // A figure that has been replaced is gone; the newer one is on its way.
        if (address === this.address) this.problem = `The picture cannot be drawn: ${error.message}`;
      }
    },
    // Out of sight the element has no size, and plotly would take one of its own.
    visible() {
      return this.$refs.picture.clientWidth > 0 && this.$refs.picture.clientHeight > 0;
    },
    resize() {
      if (!this.figure || !this.visible()) return;
      if (this.drawn) this.Plotly.Plots.resize(this.$refs.picture);
      else this.draw();
    },
    async draw() {
      this.problem = "";
      this.name();
      await this.$nextTick();
      if (!this.visible()) return;
      this.drawnDark = isDark();
      const picture = this.$refs.picture;
      const data = this.figure.data.map((trace, place) => ({ ...trace, visible: this.bodies[place].shown }));
      await this.Plotly.react(picture, data, this.themed(), CONFIG);
      if (!this.drawn) picture.on("plotly_webglcontextlost", () => this.lose());
      this.drawn = true;
      picture.dataset.drawn = this.address;
    },
    // Bodies keep their names from one design to the next, and with them whether they are hidden.
    name() {
      const hidden = new Set(this.bodies.filter((body) => !body.shown).map((body) => body.name));
      this.bodies = this.figure.data.map(({ name, color, colorscale }) => ({
        name, shown: !hidden.has(name), colour: color ?? colorscale?.at(-3)?.[1],
      }));
    },
    themed() {
      const styles = getComputedStyle(document.body);
      const colour = (name) => styles.getPropertyValue(name).trim();
      const clear = "rgba(0, 0, 0, 0)";
      const layout = this.figure.layout;
      return {
        ...layout,
        scene: { ...layout.scene, bgcolor: clear },
        paper_bgcolor: clear,
        font: { color: colour("--ink") },
        modebar: { bgcolor: clear, color: colour("--quiet"), activecolor: colour("--ink") },
        uirevision: "kept", // whoever has turned the gear sees the next one from there
      };
    },
    show(place) {
      if (this.drawn) this.Plotly.restyle(this.$refs.picture, { visible: this.bodies[place].shown }, [place]);
    },
    lose() {
      this.problem = "The browser has taken the picture's memory away. Open another tab and this one again to have it " +
        "drawn anew, or choose coarser detail.";
      this.Plotly.purge(this.$refs.picture);
      this.drawn = false;
    },
  },
};
