// The whole page as a place to drop a design file on. What is dropped goes to the uploader, as if it had been picked.
export default {
  template: `<div v-show="over" class="header-drop" aria-hidden="true"><div>{{ words }}</div></div>`,
  props: { uploader: Number, words: String },
  data() {
    return { over: false };
  },
  mounted() {
    // Every element under the pointer sends an enter and a leave; the file is gone when all have been left.
    let depth = 0;
    const withFile = (act) => (event) => {
      if (!event.dataTransfer?.types.includes("Files")) return;
      event.preventDefault();
      act(event);
      this.over = depth > 0;
    };
    this.listeners = {
      dragenter: withFile(() => depth++),
      dragover: withFile((event) => (event.dataTransfer.dropEffect = "copy")),
      dragleave: withFile(() => depth--),
      drop: withFile((event) => {
        depth = 0;
        runMethod(this.uploader, "addFiles", [event.dataTransfer.files]);
      }),
    };
    for (const [name, listener] of Object.entries(this.listeners)) window.addEventListener(name, listener);
  },
  unmounted() {
    for (const [name, listener] of Object.entries(this.listeners)) window.removeEventListener(name, listener);
  },
};
