// Keys for the whole page. In a field whose text is not taken over yet, undo and redo are the field's own.
const KEYS = { z: "undo", y: "redo", s: "save", o: "open" };
const TEXT = "textarea, [contenteditable=true], input:not([type=range], [type=checkbox], [type=radio], [type=file])";

function action(event) {
  if (event.altKey) return null;
  const key = event.key.toLowerCase();
  if (event.ctrlKey || event.metaKey) return key === "z" && event.shiftKey ? "redo" : event.shiftKey ? null : KEYS[key];
  return key === "?" && !event.target.closest?.(TEXT) ? "help" : null;
}

export default {
  template: `<span hidden></span>`,
  emits: ["act"],
  mounted() {
    let unfinished = null; // the field that has been typed in since its text was last taken over
    const finish = () => (unfinished = null);
    this.listeners = {
      input: (event) => (unfinished = event.target.matches?.(TEXT) ? event.target : unfinished),
      change: finish,
      focusout: finish,
      keydown: (event) => {
        const asked = action(event);
        if (!asked) {
          if (event.key === "Enter") finish();
          return;
        }
        if ((asked === "undo" || asked === "redo") && unfinished === document.activeElement && unfinished) return;
        event.preventDefault();
        if (asked === "save") document.activeElement?.blur(); // what is being typed is to be in the file
        this.$emit("act", asked);
      },
    };
    for (const [name, listener] of Object.entries(this.listeners)) document.addEventListener(name, listener, true);
  },
  unmounted() {
    for (const [name, listener] of Object.entries(this.listeners)) document.removeEventListener(name, listener, true);
  },
};
