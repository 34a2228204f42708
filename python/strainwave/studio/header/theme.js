// Light, dark or as the system has it; remembered by this browser. Views that draw themselves listen to "strainwave:theme".
const KEY = "strainwave:theme";
const THEMES = {
  auto: { icon: "brightness_auto", dark: null, next: "light" },
  light: { icon: "light_mode", dark: false, next: "dark" },
  dark: { icon: "dark_mode", dark: true, next: "auto" },
};

function remembered() {
  try {
    const theme = localStorage.getItem(KEY);
    return theme in THEMES ? theme : "auto";
  } catch {
    return "auto"; // a browser that keeps nothing
  }
}

export default {
  template: `
    <q-btn flat dense :icon="icon" :aria-label="words" @click="turn"><q-tooltip>{{ words }}</q-tooltip></q-btn>
  `,
  data() {
    return { theme: remembered() };
  },
  computed: {
    icon() {
      return THEMES[this.theme].icon;
    },
    words() {
      return `Theme: ${this.theme}`;
    },
  },
  mounted() {
    this.system = matchMedia("(prefers-color-scheme: dark)");
    this.tell = () => this.apply();
    this.system.addEventListener("change", this.tell);
    this.apply();
  },
  unmounted() {
    this.system.removeEventListener("change", this.tell);
  },
  methods: {
    turn() {
      this.theme = THEMES[this.theme].next;
      try {
        localStorage.setItem(KEY, this.theme);
      } catch {}
      this.apply();
    },
    apply() {
      const wanted = THEMES[this.theme].dark;
      const dark = wanted ?? this.system.matches;
      setDark(dark);
      window.dispatchEvent(new CustomEvent("strainwave:theme", { detail: { dark } }));
    },
  },
};
