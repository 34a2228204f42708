// The address bar follows the design without new entries in the history, so that a reload or a copied link shows it.
const PAUSE_MS = 400; // browsers allow some hundred changes in half a minute

export default {
  template: `<span hidden></span>`,
  props: { parameters: Object, title: String },
  emits: ["copied"],
  watch: {
    parameters() {
      this.timer ??= setTimeout(() => this.write(), PAUSE_MS);
    },
    title() {
      document.title = this.title;
    },
  },
  mounted() {
    this.timer = null;
    this.flush = () => this.timer && this.write();
    this.write();
    window.addEventListener("beforeunload", this.flush);
  },
  unmounted() {
    clearTimeout(this.timer);
    window.removeEventListener("beforeunload", this.flush);
  },
  methods: {
    address(parameters) {
      const address = new URL(location.href);
      for (const [name, value] of Object.entries(parameters)) {
        if (value) address.searchParams.set(name, value);
        else address.searchParams.delete(name);
      }
      return address;
    },
    write() {
      clearTimeout(this.timer);
      this.timer = null;
      history.replaceState(history.state, "", this.address(this.parameters));
    },
    async copy(parameters) {
      const text = this.address(parameters).href;
      try {
        await navigator.clipboard.writeText(text);
        this.$emit("copied", "");
      } catch {
        this.$emit("copied", text); // not allowed: to be copied by hand
      }
    },
  },
};
