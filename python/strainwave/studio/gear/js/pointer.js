// What pointers and the wheel do on the mesh: drag the generator, pan, zoom, point at a tooth.

const PER_WHEEL = 1.0015; // of scale, per pixel of the wheel
const CLICK_PX = 4;

/**
 * `acts` answers `turns(x, y)`: whether a drag that begins at that pixel turns the generator. It is told
 * `turn(from, to)`, `pan(dx, dy)`, `zoom(factor, x, y)`, `point(x, y)`, `leave()`, `click(x, y)`, and `follow(x, y)` on
 * a double click.
 */
export function listen(canvas, acts) {
  const down = new Map(); // pointers that press, by id
  let turning = false, spread = 0, moved = 0;
  const at = (event) => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const middle = () => {
    const places = [...down.values()];
    const x = places.reduce((sum, each) => sum + each.x, 0) / places.length;
    const y = places.reduce((sum, each) => sum + each.y, 0) / places.length;
    return { x, y, spread: places.length > 1 ? Math.hypot(places[0].x - places[1].x, places[0].y - places[1].y) : 0 };
  };
  const cursor = (x, y) => {
    canvas.style.cursor = acts.turns(x, y) ? (down.size ? "grabbing" : "grab") : down.size ? "move" : "crosshair";
  };
  const handlers = {
    pointerdown(event) {
      if (event.button !== 0) return;
      const place = at(event);
      canvas.setPointerCapture(event.pointerId);
      down.set(event.pointerId, place);
      if (down.size === 1) {
        turning = acts.turns(place.x, place.y);
        moved = 0;
      } else turning = false;
      spread = middle().spread;
      cursor(place.x, place.y);
    },
    pointermove(event) {
      const place = at(event), before = down.get(event.pointerId);
      if (!before) {
        cursor(place.x, place.y);
        acts.point(place.x, place.y);
        return;
      }
      moved += Math.hypot(place.x - before.x, place.y - before.y);
      const was = middle();
      down.set(event.pointerId, place);
      const now = middle();
      if (turning) acts.turn(before, place);
      else acts.pan(now.x - was.x, now.y - was.y);
      if (now.spread > 0 && spread > 0) acts.zoom(now.spread / spread, now.x, now.y);
      spread = now.spread;
    },
    pointerup(event) {
      const place = at(event);
      if (!down.delete(event.pointerId)) return;
      if (moved < CLICK_PX) acts.click(place.x, place.y);
      turning = false;
      spread = down.size ? middle().spread : 0;
      cursor(place.x, place.y);
    },
    pointerleave(event) {
      if (event.pointerType !== "touch" && !down.size) acts.leave();
    },
    dblclick(event) {
      const place = at(event);
      acts.follow(place.x, place.y);
    },
    wheel(event) {
      event.preventDefault();
      const place = at(event), pixels = event.deltaY * [1, 16, 400][event.deltaMode];
      acts.zoom(PER_WHEEL ** -Math.max(-300, Math.min(300, pixels)), place.x, place.y);
    },
  };
  handlers.pointercancel = handlers.pointerup;
  for (const [name, handler] of Object.entries(handlers)) canvas.addEventListener(name, handler, { passive: false });
}
