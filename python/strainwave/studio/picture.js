// A plotly picture that follows the theme of the page.
//
// Figures come in the house's light colours. On a dark page each of those colours is replaced wherever the figure names
// it; a figure's own colours, such as a scale of clearances, stay.

const DARK = {
  "#ffffff": "--surface", white: "--surface", "#222222": "--ink", "#d9d9d9": "--line", "#767676": "--reference",
  "#0072b2": "#3a9bdc", "#d55e00": "--bad", "#009e73": "--good", "#595959": "--quiet",
};
// What is many numbers holds no colours.
const DATA = new Set(["x", "y", "z", "i", "j", "k", "customdata", "text", "bdata", "intensity", "colorscale"]);
const MARGIN = { l: 58, r: 14, t: 14, b: 44 };
const ABOVE_PANEL = 6, ABOVE_TITLES = 22; // pixels between a panel's upper edge and the legend, with titles in between
const CONFIG = {
  displaylogo: false, scrollZoom: true, displayModeBar: "hover",
  modeBarButtonsToRemove: ["lasso2d", "select2d", "zoomIn2d", "zoomOut2d", "autoScale2d"],
  toImageButtonOptions: { format: "svg", filename: "strainwave" },
};

const isDark = () => document.body.classList.contains("body--dark");

function recoloured(value, styles, key) {
  if (typeof value === "string") {
    const found = DARK[value.toLowerCase()];
    return found?.startsWith("--") ? styles.getPropertyValue(found).trim() : (found ?? value);
  }
  if (value === null || typeof value !== "object" || DATA.has(key)) return value;
  if (Array.isArray(value)) return value.map((each) => recoloured(each, styles, key));
  return Object.fromEntries(Object.entries(value).map(([name, each]) => [name, recoloured(each, styles, name)]));
}

export default {
  template: '<div class="picture" role="img" :aria-label="label"></div>',
  props: { figure: Object, label: String, compact: Boolean, picks: Boolean },
  async mounted() {
    this.moved = {}; // by the name of the trace, so that a change of theme keeps what has moved
    this.Plotly = (await import("nicegui-plotly")).Plotly;
    if (!this.$el.isConnected) return;
    this.theme = new MutationObserver(() => this.drawnDark !== isDark() && this.draw());
    this.theme.observe(document.body, { attributes: true, attributeFilter: ["class"] });
    this.size = new ResizeObserver(() => this.resize());
    this.size.observe(this.$el);
    this.draw();
  },
  unmounted() {
    this.theme?.disconnect();
    this.size?.disconnect();
    if (this.drawn) this.Plotly.purge(this.$el);
  },
  watch: {
    figure() {
      this.moved = {};
      this.draw();
    },
  },
  methods: {
    // Out of sight the element has no size; plotly is drawn when it has one.
    visible() {
      return this.$el.clientWidth > 0 && this.$el.clientHeight > 0;
    },
    resize() {
      if (!this.visible() || !this.figure) return;
      if (this.drawn) this.Plotly.Plots.resize(this.$el);
      else this.draw();
    },
    async draw() {
      if (!this.Plotly) return;
      if (!this.figure) {
        if (this.drawn) this.Plotly.purge(this.$el);
        this.drawn = false;
        return;
      }
      if (!this.visible()) return;
      this.drawnDark = isDark();
      const figure = this.themed();
      // Whoever has zoomed stays there while the same kind of figure is drawn again.
      await this.Plotly.react(this.$el, figure.data, { ...figure.layout, uirevision: "kept" }, CONFIG);
      if (!this.drawn && this.picks) {
        this.$el.on("plotly_click", this.pick);
      }
      this.drawn = true;
      for (const [name, what] of Object.entries(this.moved)) this.restyle(name, what);
    },
    themed() {
      const { data, layout } = JSON.parse(JSON.stringify(this.figure));
      if (this.compact) {
        layout.title = undefined;
        layout.margin = MARGIN;
        const own = layout.legend?.y !== undefined ? layout.legend : {};
        const titled = layout.annotations?.some((each) => each.yref === "paper" && each.y >= 1);
        const height = Math.max(this.$el.clientHeight - MARGIN.b - 60, 60);
        const y = 1 + (titled ? ABOVE_TITLES : ABOVE_PANEL) / height;
        layout.legend = { ...layout.legend, x: 0, y, yanchor: "bottom", font: { size: 11 }, ...own };
        layout.modebar = { orientation: "v" };
      }
      return isDark() ? recoloured({ data, layout }, getComputedStyle(document.body)) : { data, layout };
    },
    moveTrace(name, x, y, words) {
      this.moved[name] = { x, y, words };
      if (this.drawn) this.restyle(name, this.moved[name]);
    },
    restyle(name, { x, y, words }) {
      this.$el.data.forEach((trace, place) => {
        if (trace.meta !== name) return;
        this.Plotly.restyle(this.$el, { x: [x], y: [y], ...(words ? { name: words } : {}) }, [place]);
      });
    },
    pick(event) {
      const point = event.points?.[0];
      if (!point) return;
      const box = this.$el.getBoundingClientRect();
      const at = (axis, pixel, from) => axis.p2d(pixel - from - axis._offset);
      const mouse = event.event;
      this.$emit("pick", {
        x: at(point.xaxis, mouse.clientX, box.left),
        y: at(point.yaxis, mouse.clientY, box.top),
        data: point.customdata ?? null,
      });
    },
  },
};
