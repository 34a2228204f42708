// Both teeth with their dimensions, or the wave generator while one of its fields has the focus. The number in focus is
// brought out, and named below.
export default {
  template: `
    <figure class="sketch">
      <svg class="sketch-svg" :viewBox="'0 0 ' + width + ' ' + height" role="img"
           :aria-label="'Sketch with dimensions: ' + caption">
        <g v-for="part in shown" :key="part.table" :class="'sketch-' + part.table">
          <path class="sketch-body" :d="part.body" />
          <path class="sketch-circles" :d="part.circles" />
          <path class="sketch-outline" :d="part.outline" />
        </g>
        <g v-for="stroke in strokes" :key="stroke.key" class="sketch-stroke" :data-key="stroke.key"
           :class="{ 'sketch-stroke--out': shows(stroke), 'sketch-stroke--dimmed': isOut && !shows(stroke) }"
           @click="edit(stroke)">
          <title>{{ stroke.words }}</title>
          <path class="sketch-hit" :d="stroke.path" />
          <path class="sketch-lines" :d="stroke.path" />
          <path class="sketch-heads" :d="stroke.heads" />
        </g>
      </svg>
      <figcaption class="sketch-caption">{{ caption }}</figcaption>
    </figure>`,
  props: { teeth: Array, generator: Array, width: Number, height: Number },
  data() { return { focused: "" }; },
  computed: {
    shown() { return this.focused.startsWith("wave_generator") ? this.generator : this.teeth; },
    strokes() {
      const all = this.shown.flatMap((part) => part.strokes);
      // The one that is brought out lies on top.
      return [...all.filter((stroke) => !this.shows(stroke)), ...all.filter((stroke) => this.shows(stroke))];
    },
    out() { return this.shown.flatMap((part) => part.strokes).filter((stroke) => this.shows(stroke)); },
    isOut() { return this.out.length > 0; },
    caption() {
      if (!this.isOut) {
        const words = this.shown.map((part) => part.title).join(" and ");
        return words[0].toUpperCase() + words.slice(1);
      }
      const more = this.out.length > 1 ? ` and ${this.out.length - 1} more` : "";
      return this.out[0].words + more;
    },
  },
  mounted() {
    this.listener = (event) => { this.focused = String(event.detail?.key ?? ""); };
    window.addEventListener("strainwave:dimension", this.listener);
  },
  unmounted() { window.removeEventListener("strainwave:dimension", this.listener); },
  methods: {
    // A field may hold a part of what a stroke shows (x of a centre), or all that several show (pieces).
    shows(stroke) {
      const lies = (key, within) => key === within || key.startsWith(within + "[") || key.startsWith(within + ".");
      return this.focused !== "" && (lies(this.focused, stroke.key) || lies(stroke.key, this.focused));
    },
    edit(stroke) {
      const fields = [...document.querySelectorAll(".form-input, .form-area")];
      const lies = (key, within) => key === within || key.startsWith(within + "[");
      const field = fields.find(({ dataset: { key } }) => lies(key, stroke.key) || lies(stroke.key, key));
      const group = field?.closest("details");
      if (group) group.open = true;
      field?.focus();
    },
  },
};
