// The backlash over the tooth index: ECharts has the axes and what changes with the design only; the bars, which change
// with every angle, lie on a canvas of their own below it.

import { drawCross } from "strainwave-drawing";

import { GapTable } from "./mesh.js";

const GRID = { left: 54, right: 14, top: 6, bottom: 36 };
const WIDEST_BAR = 16, NEAREST_LABELS = 0.1;

export class Distribution {
  constructor(echarts, host, bars) {
    this.chart = echarts.init(host, null, { renderer: "canvas" });
    this.bars = bars;
    this.context = bars.getContext("2d");
    this.mesh = this.reference = null;
  }
  resize(width, height) {
    this.ratio = globalThis.devicePixelRatio || 1;
    this.bars.width = Math.round(width * this.ratio);
    this.bars.height = Math.round(height * this.ratio);
    this.width = width;
    this.height = height;
    this.chart.resize({ width, height });
  }
  refer(message) {
    this.reference = message && { ...message, curve: new GapTable(message).curve() };
  }
  /** Another design or, with `whole`, another theme or reference too: what stays is not made anew then. */
  redraw(mesh, colours, whole) {
    this.mesh = mesh;
    this.colours = colours;
    this.chart.setOption(whole ? this.whole() : this.changing(), { notMerge: whole, silent: true });
    this.chart.getZr().flush();
    const [x0, y0] = this.chart.convertToPixel({ gridIndex: 0 }, [0, 0]);
    const [x1, y1] = this.chart.convertToPixel({ gridIndex: 0 }, [1, 1]);
    Object.assign(this, { x0, y0, dx: x1 - x0, dy: y1 - y0 });
  }
  /** What changes with a design. */
  changing() {
    const { mesh, reference, colours } = this, both = [mesh, ...(reference ? [reference] : [])];
    const low = Math.min(...both.map((each) => each.low_um)), high = Math.max(...both.map((each) => each.high_um));
    const side = Math.max(...both.map((each) => each.side)) + 1, { index, gap_um, words } = mesh.least;
    const level = (y, color, type, said) =>
      ({ yAxis: y, lineStyle: { color, type, width: 1 }, label: { formatter: said } });
    const places = index > NEAREST_LABELS * mesh.side ? [-index, index] : [0];
    return {
      xAxis: { min: -side, max: side },
      yAxis: { min: low, max: high },
      series: [
        { id: "reference", data: reference ? reference.curve : [] },
        { id: "curve", data: mesh.curve(),
          markArea: { data: [[{ yAxis: low }, { yAxis: 0 }]] },
          markLine: { data: [level(0, colours.overlap, "solid", ""),
            level(mesh.threshold_um, colours.reference, [5, 3], `${mesh.threshold_um} µm`)] },
          markPoint: { data: [-index, index].map((x) => ({ coord: [x, gap_um] })) } },
        { id: "least", data: places.map((x) => [x, gap_um]), label: { formatter: words } },
      ],
    };
  }
  whole() {
    const { colours } = this, changing = this.changing(), [reference, curve, least] = changing.series;
    const words = { fontFamily: "DejaVu Sans, Verdana, sans-serif", fontSize: 11, color: colours.ink };
    const axis = (name, nameGap) => ({
      type: "value", name, nameGap, nameLocation: "middle", nameTextStyle: words,
      axisLabel: { ...words, color: colours.quiet, formatter: (value) => `${value}`.replace("-", "−"),
        showMinLabel: false, showMaxLabel: false },
      axisLine: { show: true, onZero: false, lineStyle: { color: colours.quiet } },
      axisTick: { show: true }, splitLine: { lineStyle: { color: colours.line, width: 0.5 } },
    });
    const line = (color, width, type) => ({ type: "line", showSymbol: false, silent: true, clip: true,
      lineStyle: { color, width, type } });
    return {
      animation: false, backgroundColor: "transparent",
      grid: GRID,
      xAxis: { ...axis("tooth index from the major axis", 22), ...changing.xAxis },
      yAxis: { ...axis("normal backlash, µm", 36), ...changing.yAxis },
      series: [
        { ...line(colours.reference, 1.2, [4, 3]), ...reference },
        { ...line(colours.accent, 1.5, "solid"), ...curve,
          markArea: { silent: true, itemStyle: { color: colours.overlap, opacity: 0.12 }, ...curve.markArea },
          markLine: { silent: true, symbol: "none", ...curve.markLine,
            label: { position: "insideEndTop", ...words, color: colours.quiet } },
          markPoint: { silent: true, symbol: "diamond", symbolSize: 10, label: { show: false },
            itemStyle: { color: colours.ink, borderColor: colours.surface, borderWidth: 1 }, ...curve.markPoint } },
        // The least gap's words are a series of their own, so that they lie over everything.
        { ...least, type: "scatter", symbolSize: 0.01, silent: true, clip: false,
          label: { show: true, position: "bottom", distance: 10, ...words, fontWeight: "bold",
            textBorderColor: colours.surface, textBorderWidth: 2, ...least.label } },
      ],
    };
  }
  /** The bars of the teeth that stand in the upper lobe, and of the one that is pointed at. */
  glide(teeth, hovered) {
    const { context, mesh, colours } = this;
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    context.clearRect(0, 0, this.width, this.height);
    const wide = Math.min(0.72 * this.dx, WIDEST_BAR);
    for (const tooth of teeth) {
      const own = tooth.number === hovered;
      if (!tooth.upper && !own) continue;
      const x = this.x0 + tooth.index * this.dx, y = Math.max(this.y0 + tooth.gap * this.dy, GRID.top);
      if (own) this.column(x, wide);
      context.fillStyle = colours.gap(tooth.gap, mesh.far_um);
      context.fillRect(x - 0.5 * wide, Math.min(y, this.y0), wide, Math.abs(y - this.y0));
      if (tooth.gap < 0) drawCross(context, x, y, Math.min(0.6 * wide, 3), colours.surface, colours.ink);
    }
  }
  /** What marks the tooth that is pointed at, however low its bar. */
  column(x, wide) {
    const { context, colours } = this;
    context.fillStyle = colours.witness;
    context.globalAlpha = 0.3;
    context.fillRect(x - 0.5 * wide - 2, GRID.top, wide + 4, this.height - GRID.top - GRID.bottom);
    context.globalAlpha = 1;
  }
  /** The tooth whose bar is nearest to a pixel across the chart. */
  nearest(teeth, px) {
    const index = (px - this.x0) / this.dx, upper = teeth.filter((tooth) => tooth.upper);
    return upper.reduce((best, tooth) => (Math.abs(tooth.index - index) < Math.abs(best.index - index) ? tooth : best));
  }
  dispose() {
    this.chart.dispose();
  }
}
