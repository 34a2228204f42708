// Pictures are unpacked and drawn when they come near the window, so that a long report opens at once; without a script,
// without this much of a browser, and in print the static ones stand in their place.
"use strict";

const unpack = async (element) => {
  const bytes = Uint8Array.from(atob(element.textContent), (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).text();
};

let plotly = null;
const loadPlotly = () => {
  plotly ??= unpack(document.getElementById("plotly")).then((source) => {
    const script = document.createElement("script");
    script.textContent = source;
    document.head.append(script);
    return window.Plotly;
  });
  return plotly;
};

const draw = async (figure) => {
  const [library, text] = await Promise.all([loadPlotly(), unpack(figure.querySelector(".data"))]);
  const { data, layout } = JSON.parse(text);
  // The page's own frame says how large; a fixed size would not follow the window.
  delete layout.width;
  delete layout.height;
  layout.autosize = true;
  await library.newPlot(figure.querySelector(".live"), data, layout, PLOTLY_CONFIG);
  figure.classList.add("drawn");
};

// Where there is no WebGL, or a picture cannot be drawn, its static one stays.
const canBeDrawn = (figure) =>
  !figure.classList.contains("turnable") || document.createElement("canvas").getContext("webgl") !== null;

const leaveStatic = (figure, reason) => {
  figure.classList.remove("interactive");
  if (reason) console.error(reason);
};

if ("DecompressionStream" in window && "IntersectionObserver" in window) {
  document.documentElement.classList.add("scripted");
  const nearing = new IntersectionObserver(
    (entries) => {
      for (const entry of entries.filter((each) => each.isIntersecting)) {
        nearing.unobserve(entry.target);
        if (canBeDrawn(entry.target)) draw(entry.target).catch((reason) => leaveStatic(entry.target, reason));
        else leaveStatic(entry.target);
      }
    },
    { rootMargin: "600px" },
  );
  document.querySelectorAll("figure.interactive").forEach((figure) => nearing.observe(figure));
}

// What is folded away on a screen is read on paper.
window.addEventListener("beforeprint", () => {
  document.querySelectorAll("details").forEach((details) => { details.open = true; });
});
