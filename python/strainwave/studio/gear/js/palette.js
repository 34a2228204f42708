// The colours of the page's theme, from its style sheets.

import { gapColour } from "strainwave-drawing";

const isDark = () => document.body.classList.contains("body--dark");
const ROLES = ["circular-spline", "flexspline", "bearing", "wave-generator", "neutral-curve", "major-axis"];

/** `scale` goes from touching to far as in the pictures on paper; on a dark page what is closer is brighter instead. */
export function palette(element, scale, overlap) {
  const styles = getComputedStyle(element), of = (name) => styles.getPropertyValue(name).trim();
  const shown = isDark() ? [...scale].reverse() : scale;
  return {
    surface: of("--surface"), ink: of("--ink"), quiet: of("--quiet"), line: of("--line"), accent: of("--accent"),
    bad: of("--bad"), reference: of("--reference"), edge: of("--gear-edge"), overlap, scale: shown,
    witness: of("--gear-witness"),
    faces: Object.fromEntries(ROLES.map((role) => [role.replace("-", " "), of(`--gear-${role}`)])),
    gap: (gap_um, far_um) => gapColour(gap_um, far_um, shown, overlap),
  };
}

/** Calls back whenever the theme has changed; gives what ends that. */
export function onTheme(changed) {
  let dark = isDark();
  const observer = new MutationObserver(() => {
    if (dark !== isDark()) changed((dark = isDark()));
  });
  observer.observe(document.body, { attributes: true, attributeFilter: ["class"] });
  return () => observer.disconnect();
}
