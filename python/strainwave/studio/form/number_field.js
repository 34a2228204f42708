// A number of the design: its name, an entry that takes what is typed, its unit, and a slider with fine steps.
//
// What is typed goes to the server as it stands: at once where it is a plain number in range, else when the typing
// rests, on Enter and on leaving. The slider sends at most a change every SEND_EVERY_MS, and always its last one.
const SEND_EVERY_MS = 1000 / 30;
const REST_MS = 500;
const PLAIN = /^\s*[+\-−]?(\d+\.?\d*|\.\d+)\s*$/;
const BIG_STEPS = 10;

export default {
  template: `
    <div class="form-row" :class="{ 'form-row--faulty': fault }" :data-key="field" @focusin="bringOut">
      <label class="form-label" :for="part('entry')" :title="hint">{{ label }}</label>
      <span class="form-entry">
        <input class="form-input" type="text" inputmode="decimal" autocomplete="off" spellcheck="false" maxlength="200"
               ref="entry" :id="part('entry')" :data-key="field" :placeholder="placeholder" v-model="typed" :title="typed.length > 9 ? typed : null"
               :aria-invalid="fault ? 'true' : 'false'" :aria-describedby="part('hint') + ' ' + part('fault')"
               @input="onTyped" @change="commit" @blur="commit" @keydown="onEntryKey" />
        <button v-if="clearable && typed" class="form-clear" type="button" :aria-label="'Leave out ' + label"
                title="Leave out" @click="clear">×</button>
      </span>
      <span class="form-unit" :title="unitWord">{{ unit }}</span>
      <input v-if="hasSlider" class="form-slider" type="range" :aria-label="label + ', slider'" :data-key="field"
             :min="low" :max="high" :step="'any'" :value="at" :aria-valuetext="(typed || placeholder) + ' ' + unitWord"
             @input="onSlid" @change="onReleased" @keydown="onSliderKey" />
      <span class="form-hidden" :id="part('hint')">{{ hint }}</span>
      <p class="form-fault" :id="part('fault')" aria-live="polite">{{ fault }}</p>
    </div>`,
  props: {
    field: String, label: String, hint: String, unit: String, unitWord: String,
    placeholder: String, clearable: Boolean, fault: String,
    // { text, number, turn }: what the server knows. Taken over when it counts `turn` up; else, if that is still what
    // is typed here, its number is (an angle's degrees, or what an empty entry comes to).
    shown: Object,
    low: Number, high: Number, step: Number, digits: Number, least: Number, greatest: Number, whole: Boolean,
  },
  data() {
    return { typed: this.shown.text, number: this.shown.number, sent: this.shown.text };
  },
  computed: {
    hasSlider() { return this.number !== null; },
    at() { return Math.min(Math.max(this.number, this.low), this.high); },
  },
  watch: {
    shown(now, before) {
      if (now.turn !== before.turn) {
        this.forget();
        this.typed = this.sent = now.text;
      }
      if (this.typed === now.text) this.number = now.number;
    },
    fault(now) {
      const group = now && this.$el.closest("details");
      if (group) group.open = true;
    },
  },
  beforeUnmount() { this.forget(); },
  methods: {
    part(name) { return `form-${this.field}-${name}`.replace(/[^\w-]/g, "_"); },
    bringOut() { window.dispatchEvent(new CustomEvent("strainwave:dimension", { detail: { key: this.field } })); },
    forget() { clearTimeout(this.resting); clearTimeout(this.sending); this.sending = this.waiting = undefined; this.settles = false; },

    onTyped() {
      clearTimeout(this.resting);
      const value = Number(this.typed.replace("−", "-"));
      const goesAtOnce = !this.whole && PLAIN.test(this.typed) && value >= this.least && value <= this.greatest;
      if (goesAtOnce) this.commit();
      else this.resting = setTimeout(this.commit, REST_MS);
    },
    commit() {
      clearTimeout(this.resting);
      if (this.typed === this.sent) return;
      this.sent = this.typed;
      if (PLAIN.test(this.typed)) this.number = Number(this.typed.replace("−", "-"));
      this.send({ text: this.typed });
    },
    clear() { this.typed = ""; this.commit(); this.$refs.entry.focus(); },

    // At once where there has been none for a while; else the last one when its time comes.
    send(change) {
      this.waiting = change;
      if (!this.sending) this.flush();
    },
    flush() {
      this.sending = undefined;
      if (this.waiting === undefined) return;
      this.$emit("edit", this.waiting);
      this.waiting = undefined;
      this.sending = setTimeout(this.flush, SEND_EVERY_MS);
      if (this.settles) this.settle();
    },
    // The slider is let go: after its last change, so that its window is around that one.
    settle() {
      this.settles = this.waiting !== undefined;
      if (!this.settles) this.$emit("settle");
    },

    // To the step's digits, or those that the number had already, so that no rounding noise shows.
    tidy(value, digits) { return Number(value.toFixed(Math.min(digits, 12))); },
    take(value) {
      value = Math.min(Math.max(value, this.least), this.greatest);
      this.number = value;
      this.typed = this.sent = String(value);
      clearTimeout(this.resting);
      this.send({ number: value });
    },
    onSlid(event) {
      this.take(this.tidy(Number(event.target.value), this.digits));
    },
    onReleased() { this.settle(); },
    moveBy(steps) {
      if (this.number === null) return;
      const own = (/\.(\d+)/.exec(String(this.number))?.[1] ?? "").length;
      this.take(this.tidy(this.number + steps * this.step, Math.max(this.digits, own)));
      this.settle();
    },

    // How many steps a key moves; 0 where it is no such key.
    steps(event) {
      const up = { ArrowUp: 1, ArrowDown: -1, PageUp: BIG_STEPS, PageDown: -BIG_STEPS }[event.key] ?? 0;
      return event.shiftKey && Math.abs(up) === 1 ? BIG_STEPS * up : up;
    },
    onSliderKey(event) {
      const sideways = { ArrowRight: 1, ArrowLeft: -1 }[event.key] ?? 0;
      const steps = this.steps(event) || (event.shiftKey ? BIG_STEPS : 1) * sideways;
      if (steps) { event.preventDefault(); this.moveBy(steps); }
    },
    onEntryKey(event) {
      const steps = this.steps(event);
      if (steps) { event.preventDefault(); this.commit(); this.moveBy(steps); }
      else if (event.key === "Enter") this.commit();
    },
  },
};
