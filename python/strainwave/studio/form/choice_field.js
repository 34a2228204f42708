// One of several words: a select with its name.
export default {
  template: `
    <div class="form-row form-row--choice" :class="{ 'form-row--faulty': fault }" :data-key="field" @focusin="bringOut">
      <label class="form-label" :for="part('entry')" :title="hint">{{ label }}</label>
      <select class="form-select" :id="part('entry')" :data-key="field" :value="chosen" :title="about"
              :aria-invalid="fault ? 'true' : 'false'" :aria-describedby="part('hint') + ' ' + part('fault')"
              @change="choose">
        <option v-for="option in options" :key="option.value" :value="option.value">{{ option.label }}</option>
      </select>
      <span class="form-hidden" :id="part('hint')">{{ hint }}</span>
      <p v-if="about" class="form-about">{{ about }}</p>
      <p class="form-fault" :id="part('fault')" aria-live="polite">{{ fault }}</p>
    </div>`,
  props: {
    field: String, label: String, hint: String, fault: String,
    about: String, // what the chosen one is
    options: Array, // of { value, label }
    shown: Object, // { text, turn }: taken over whenever the server counts `turn` up
  },
  data() { return { chosen: this.shown.text }; },
  watch: { "shown.turn"() { this.chosen = this.shown.text; } },
  methods: {
    part(name) { return `form-${this.field}-${name}`.replace(/[^\w-]/g, "_"); },
    bringOut() {
      window.dispatchEvent(new CustomEvent("strainwave:dimension", { detail: { key: this.field } }));
    },
    choose(event) {
      this.chosen = event.target.value;
      this.$emit("edit", { text: this.chosen });
    },
  },
};
