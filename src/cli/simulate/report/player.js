// Time: what plays it, what shows it, and the pictures that tell the values at it.

const element = id => document.getElementById(id);
const motion = JSON.parse(element('motion').textContent);
const { times, values } = motion;
const end = times.at(-1);
const frames = motion.points.map(flat => {
  const points = [];
  for (let i = 0; i < flat.length; i += 3) points.push(flat.slice(i, i + 3).map(x => x * motion.unit));
  return points;
});
const view = new View(element('view'), motion, frames);
const [play, slider, speed, follow, paths, names] = ['play', 'slider', 'speed', 'follow', 'paths', 'names'].map(element);

function number(x) {
  if (x === null) return '–';
  const short = x === 0 || (Math.abs(x) >= 1e-3 && Math.abs(x) < 1e5) ? Number(x.toPrecision(4)).toString() : x.toExponential(3);
  return short.replaceAll('-', '−');
}

let time = 0;
let looked = null;  // The time under the pointer, if it is over a picture.
let playing = false;
let last = null;

// The frames around a time, and where it is between them.
function around(time) {
  let [low, high] = [0, times.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle; else high = middle;
  }
  const span = times[high] - times[low];
  return [low, high, span > 0 ? (time - times[low]) / span : 0];
}

function nearest(time) {
  const [low, high, share] = around(time);
  return share < 0.5 ? low : high;
}

// Cursors and values of the pictures. The names of the lines stand in the order of the values.
const ROOM = 80;  // For a value, right of the names.
const make = (parent, kind, attributes) => {
  const child = document.createElementNS(parent.namespaceURI, kind);
  for (const [key, value] of Object.entries(attributes)) child.setAttribute(key, value);
  return parent.appendChild(child);
};
const told = [];
const pictures = [...document.querySelectorAll('figure svg')].map(svg => {
  const { width, height } = svg.viewBox.baseVal;
  svg.setAttribute('viewBox', `0 0 ${width + ROOM} ${height}`);
  svg.setAttribute('width', width + ROOM);
  svg.querySelectorAll('.name').forEach(name => {
    const place = { x: width + ROOM - 14, y: name.getAttribute('y'), 'text-anchor': 'end', fill: '#555' };
    told.push(make(svg, 'text', place));
  });
  const panels = [...svg.querySelectorAll('.panel')];
  const cursor = (colour, dash) => panels.map(panel => make(svg, 'path', { stroke: colour, 'stroke-dasharray': dash }));
  const picture = { svg, panels, now: cursor('#0072b2', 'none'), looked: cursor('#888', '4 3') };
  picture.label = make(svg, 'text', { y: panels[0].y.baseVal.value - 6, 'font-size': 12, fill: '#0072b2' });
  const at = event => {
    const box = svg.getBoundingClientRect(), { x, width: wide } = panels[0];
    const right = (event.clientX - box.left) * (width + ROOM) / box.width - x.baseVal.value;
    return Math.min(1, Math.max(0, right / wide.baseVal.value)) * end;
  };
  svg.addEventListener('pointermove', event => { looked = times[nearest(at(event))]; tell(); });
  svg.addEventListener('pointerleave', () => { looked = null; tell(); });
  svg.addEventListener('click', event => go(at(event)));
  return picture;
});

function tell() {
  const shown = looked ?? time, row = values[nearest(shown)];
  told.forEach((text, i) => { text.textContent = number(row[i]); });
  const across = (panel, time) => panel.x.baseVal.value + panel.width.baseVal.value * (end > 0 ? time / end : 0);
  const put = (path, panel, time) => path.setAttribute('d', time === null ? ''
    : `M${across(panel, time)} ${panel.y.baseVal.value}v${panel.height.baseVal.value}`);
  pictures.forEach(({ panels, now, looked: hover, label }) => {
    panels.forEach((panel, i) => { put(now[i], panel, time); put(hover[i], panel, looked); });
    const x = across(panels[0], shown);
    label.setAttribute('x', x);
    label.setAttribute('text-anchor', shown > 0.8 * end ? 'end' : 'start');
    label.textContent = `t = ${shown.toFixed(3)} s`;
  });
}

function show() {
  const [low, high, share] = around(time);
  view.draw(frames[low].map((point, i) => mix(point, frames[high][i], share)), low,
    { follow: follow.checked, paths: paths.checked, names: names.checked });
  slider.value = time;
  element('time').textContent = `${time.toFixed(3)} s`;
  tell();
}

function go(to) {
  time = Math.min(end, Math.max(0, to));
  show();
}

function run(on) {
  if (on && time >= end) time = 0;
  playing = on && end > 0;
  last = null;
  play.textContent = playing ? '❚❚' : '▶';
  play.setAttribute('aria-label', playing ? 'Pause' : 'Play');
  if (playing) requestAnimationFrame(tick);
}

function tick(now) {
  if (!playing) return;
  if (last !== null) go(time + (now - last) / 1000 * Number(speed.value));
  last = now;
  if (time < end) requestAnimationFrame(tick); else run(false);
}

function byAddress() {
  const asked = Number.parseFloat(location.hash.replace('#t=', ''));
  if (Number.isFinite(asked)) { run(false); go(asked); }
  return Number.isFinite(asked);
}

slider.max = end;
slider.addEventListener('input', () => go(Number(slider.value)));
play.addEventListener('click', () => run(!playing));
follow.addEventListener('change', () => { view.reset(follow.checked); show(); });
[paths, names].forEach(box => box.addEventListener('change', show));
view.canvas.addEventListener('pointerdown', event => view.canvas.setPointerCapture(event.pointerId));
view.canvas.addEventListener('pointermove', event => {
  if (event.buttons) { view.turn(0.008 * event.movementX, 0.008 * event.movementY); show(); }
});
view.canvas.addEventListener('wheel', event => {
  event.preventDefault();
  view.zoom(Math.exp(0.001 * event.deltaY));
  show();
}, { passive: false });
view.canvas.addEventListener('dblclick', () => { view.reset(follow.checked); show(); });
document.addEventListener('keydown', event => {
  if (event.target.matches('select, button, [type=checkbox]') || event.ctrlKey || event.metaKey || event.altKey) return;
  const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if (event.key === ' ') run(!playing);
  else if (step) { run(false); go(times[Math.min(times.length - 1, Math.max(0, nearest(time) + step))]); }
  else return;
  event.preventDefault();
});
new ResizeObserver(show).observe(view.canvas);
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', show);
addEventListener('hashchange', byAddress);
follow.checked = view.travels;
show();
if (!byAddress() && !matchMedia('(prefers-reduced-motion: reduce)').matches) run(true);
