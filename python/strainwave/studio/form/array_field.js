// Many values at once, as text in the notation of the design file; sent when the typing rests, and on leaving.
const REST_MS = 700;

export default {
  template: `
    <div class="form-row form-row--array" :class="{ 'form-row--faulty': fault }" :data-key="field" @focusin="bringOut">
      <label class="form-label" :for="part('entry')" :title="hint">{{ label }}
        <span class="form-count">{{ summary }}</span></label>
      <textarea class="form-area" :rows="rows" spellcheck="false" autocomplete="off" maxlength="100000" wrap="off"
                :id="part('entry')" :data-key="field" :placeholder="placeholder" v-model="typed"
                :aria-invalid="fault ? 'true' : 'false'" :aria-describedby="part('hint') + ' ' + part('fault')"
                @input="onTyped" @change="commit" @blur="commit"></textarea>
      <span class="form-hidden" :id="part('hint')">{{ hint }}</span>
      <p class="form-fault" :id="part('fault')" aria-live="polite">{{ fault }}</p>
    </div>`,
  props: {
    field: String, label: String, hint: String, placeholder: String, fault: String, summary: String,
    shown: Object, // { text, turn }: taken over whenever the server counts `turn` up
  },
  data() { return { typed: this.shown.text, sent: this.shown.text }; },
  computed: { rows() { return Math.min(Math.max(this.typed.split("\n").length + 1, 2), 7); } },
  watch: {
    "shown.turn"() { clearTimeout(this.resting); this.typed = this.sent = this.shown.text; },
    fault(now) {
      const group = now && this.$el.closest("details");
      if (group) group.open = true;
    },
  },
  beforeUnmount() { clearTimeout(this.resting); },
  methods: {
    part(name) { return `form-${this.field}-${name}`.replace(/[^\w-]/g, "_"); },
    bringOut() {
      window.dispatchEvent(new CustomEvent("strainwave:dimension", { detail: { key: this.field } }));
    },
    onTyped() {
      clearTimeout(this.resting);
      this.resting = setTimeout(this.commit, REST_MS);
    },
    commit() {
      clearTimeout(this.resting);
      if (this.typed === this.sent) return;
      this.sent = this.typed;
      this.$emit("edit", { text: this.typed });
    },
  },
};
