// The robot on a canvas. Points are [x, y, z] in the world, m; what is farther away is painted first.

const CORNERS = 8, BASE = 8;  // The first points are the corners of the base's box, then comes its middle. The last is the centre of mass.

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const mean = points => [0, 1, 2].map(i => points.reduce((sum, p) => sum + p[i], 0) / points.length);
const mix = (a, b, share) => a.map((x, i) => x + share * (b[i] - x));

// The four corners of each face of the box, in order around it.
const FACES = [0, 1, 2].flatMap(axis => [0, 1].map(side => {
  const [b, c] = [1 << (axis + 1) % 3, 1 << (axis + 2) % 3], first = side << axis;
  return [first, first + b, first + b + c, first + c];
}));

// 1, 2 or 5 times a power of ten, near a length.
function roundLength(length) {
  const power = 10 ** Math.floor(Math.log10(length));
  return power * [1, 2, 5].findLast(factor => factor * power <= length);
}

class View {
  constructor(canvas, motion, frames) {
    this.canvas = canvas;
    this.pen = canvas.getContext('2d');
    this.motion = motion;
    const first = frames[0].slice(0, motion.robot);
    this.size = Math.max(...first.map(p => Math.hypot(...minus(p, first[BASE]))), 1e-9);
    // What flies away leaves the picture.
    const near = frame => frame.filter((p, i) => i < motion.robot || Math.hypot(...minus(p, frame[BASE])) < 1.8 * this.size);
    const whole = frames.flatMap(near);
    const [low, high] = [Math.min, Math.max].map(end => [0, 1, 2].map(i => whole.reduce((m, p) => end(m, p[i]), first[0][i])));
    this.middle = mix(low, high, 0.5);
    this.reach = Math.max(0.5 * Math.max(...minus(high, low)), 0.5 * this.size);
    this.floor = low[2];
    this.step = roundLength(0.6 * this.size);
    const lengths = motion.segments.map(([a, b]) => Math.hypot(...minus(first[a], first[b])));
    const long = lengths.filter(length => length > 1e-3 * this.size).sort((a, b) => a - b);
    this.thickness = Math.min(0.24 * (long[long.length >> 1] ?? this.size), 0.06 * this.size);
    this.paths = [BASE, frames[0].length - 1].map(point => frames.map(frame => frame[point]));
    this.travels = this.reach > 1.5 * this.size;
    this.reset(this.travels);
  }

  // Looks at the whole motion, or at the robot if it is followed.
  reset(follow) {
    Object.assign(this, { yaw: -0.95, pitch: 0.38, distance: 4.8 * (follow ? this.size : this.reach) });
  }

  turn(right, up) {
    this.yaw -= right;
    this.pitch = Math.min(1.57, Math.max(-1.57, this.pitch + up));
  }

  zoom(factor) {
    this.distance *= factor;
  }

  aim(target) {
    const { clientWidth: width, clientHeight: height } = this.canvas, ratio = window.devicePixelRatio || 1;
    if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
    }
    this.pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.pen.clearRect(0, 0, width, height);
    const [sy, cy, sp, cp] = [Math.sin(this.yaw), Math.cos(this.yaw), Math.sin(this.pitch), Math.cos(this.pitch)];
    this.right = [-sy, cy, 0];
    this.up = [-sp * cy, -sp * sy, cp];
    this.back = [cp * cy, cp * sy, sp];
    Object.assign(this, { target, width, height, focal: 2 * Math.min(width, height) });
  }

  // Right and down on the canvas, and the depth in front of the camera.
  seen(point) {
    const from = minus(point, this.target), depth = this.distance - dot(from, this.back);
    const scale = this.focal / depth;
    return [0.5 * this.width + scale * dot(from, this.right), 0.5 * this.height - scale * dot(from, this.up), depth];
  }

  line(points, colour, width, alpha = 1) {
    const { pen } = this, near = 0.02 * this.distance;
    pen.beginPath();
    let before = Infinity;
    points.map(point => this.seen(point)).forEach(([x, y, depth]) => {
      if (depth > near) pen[before > near && before !== Infinity ? 'lineTo' : 'moveTo'](x, y);
      before = depth;
    });
    Object.assign(pen, { strokeStyle: colour, lineWidth: width, globalAlpha: alpha, lineCap: 'round', lineJoin: 'round' });
    pen.stroke();
    pen.globalAlpha = 1;
  }

  // The plane below the motion, around what is looked at, fading away; and the world's axes.
  ground(colour) {
    const { step, floor } = this, half = 9, [i0, j0] = this.target.slice(0, 2).map(x => Math.round(x / step));
    const at = (i, j) => [(i0 + i) * step, (j0 + j) * step, floor];
    for (let i = -half; i <= half; i++) {
      for (let j = -half; j < half; j++) {
        const fade = 0.55 * (1 - Math.hypot(i, j + 0.5) / half);
        if (fade <= 0) continue;
        this.line([at(i, j), at(i, j + 1)], colour, 1, fade);
        this.line([at(j, i), at(j + 1, i)], colour, 1, fade);
      }
    }
    ['#d55e00', '#009e73', '#0072b2'].forEach((axis, i) => {
      const tip = [0, 0, 0];
      tip[i] = 0.6 * step;
      this.line([[0, 0, 0], tip], axis, 2, 0.9);
      this.word('xyz'[i], tip, axis);
    });
  }

  word(text, point, colour) {
    const [x, y, depth] = this.seen(point), { pen } = this;
    if (depth <= 0) return;
    pen.font = '12px Helvetica, Arial, sans-serif';
    pen.fillStyle = colour;
    pen.fillText(text, x + 6, y - 5);
  }

  // The faces of a box that begins with a corner, each with its depth; light is what strikes it from above.
  box(points, seen, first, rgb, solid) {
    const { pen } = this, middle = mean(points.slice(first, first + CORNERS));
    return FACES.map(face => face.map(corner => first + corner)).map(face => {
      const centre = mean(face.map(corner => points[corner])), out = minus(centre, middle);
      const light = Math.abs(dot(out, [0.36, -0.48, 0.8])) / (Math.hypot(...out) || 1);
      return [this.seen(centre)[2], () => {
        pen.beginPath();
        face.forEach((corner, i) => pen[i ? 'lineTo' : 'moveTo'](seen[corner][0], seen[corner][1]));
        pen.closePath();
        pen.fillStyle = `rgba(${rgb}, ${solid * (0.1 + 0.22 * light)})`;
        pen.fill();
        Object.assign(pen, { strokeStyle: `rgba(${rgb}, ${0.75 * solid})`, lineWidth: 1.2 });
        pen.stroke();
      }];
    });
  }

  // What is to be painted of the robot and the bodies that it takes: each with its depth.
  parts(points, frame, colour) {
    const { pen, thickness, motion: { boxes, times } } = this, seen = points.map(point => this.seen(point)), time = times[frame];
    const parts = this.box(points, seen, 0, colour.box, 1);
    boxes.forEach(({ first, grasp, release }) => {
      const flies = (grasp !== null && time < grasp) || (release !== null && time >= release);
      parts.push(...this.box(points, seen, first, colour.load, flies ? 0.6 : 1));
    });
    // A joint lies on the segments that meet in it.
    const above = seen.map(([, , depth]) => depth);
    const thick = depth => Math.max(2, thickness * this.focal / depth);
    this.motion.segments.forEach(([a, b]) => {
      const depth = 0.5 * (seen[a][2] + seen[b][2]), wide = thick(depth);
      [a, b].forEach(point => { above[point] = Math.min(above[point], depth); });
      parts.push([depth, () => {
        this.line([points[a], points[b]], colour.edge, wide + 2);
        this.line([points[a], points[b]], colour.link, wide);
      }]);
    });
    this.motion.joints.forEach(({ point, slides }) => {
      const [x, y, depth] = seen[point], r = 0.42 * thick(depth) + 1;
      parts.push([above[point] - 1e-6 * this.size, () => {
        pen.beginPath();
        if (slides) pen.rect(x - r, y - r, 2 * r, 2 * r);
        else pen.arc(x, y, r, 0, 2 * Math.PI);
        Object.assign(pen, { fillStyle: colour.joint, strokeStyle: colour.edge, lineWidth: 1 });
        pen.fill();
        pen.stroke();
      }]);
    });
    return parts;
  }

  // A cross where a hand is to be.
  mark(point, colour) {
    const [x, y, depth] = this.seen(point), { pen } = this, r = 8;
    if (depth <= 0) return;
    pen.beginPath();
    [[r, 0], [0, r]].forEach(([a, b]) => { pen.moveTo(x - a, y - b); pen.lineTo(x + a, y + b); });
    Object.assign(pen, { strokeStyle: `rgb(${colour.load})`, lineWidth: 2.4 });
    pen.stroke();
  }

  // A circle in quarters, as on drawings.
  centre(point, colour) {
    const [x, y] = this.seen(point), { pen } = this, r = 6;
    [0, 1, 2, 3].forEach(i => {
      pen.beginPath();
      pen.moveTo(x, y);
      pen.arc(x, y, r, 0.5 * Math.PI * i, 0.5 * Math.PI * (i + 1));
      pen.fillStyle = i % 2 ? colour.card : colour.com;
      pen.fill();
    });
    pen.beginPath();
    pen.arc(x, y, r, 0, 2 * Math.PI);
    Object.assign(pen, { strokeStyle: colour.com, lineWidth: 1.5 });
    pen.stroke();
  }

  draw(points, frame, { follow, paths, names }) {
    const style = getComputedStyle(document.documentElement), of = name => style.getPropertyValue(`--${name}`).trim();
    const colour = Object.fromEntries(['link', 'edge', 'joint', 'box', 'load', 'com', 'card'].map(name => [name, of(name)]));
    this.aim(follow ? points[BASE] : this.middle);
    this.ground(of('grid'));
    if (paths) {
      this.paths.forEach((path, i) => {
        const ends = [points[BASE], points.at(-1)];
        this.line(path, [of('accent'), colour.com][i], 1, 0.25);
        this.line([...path.slice(0, frame + 1), ends[i]], [of('accent'), colour.com][i], 1.6, 0.9);
      });
    }
    this.parts(points, frame, colour).sort((a, b) => b[0] - a[0]).forEach(([, paint]) => paint());
    this.centre(points.at(-1), colour);
    const { joints, boxes, marks } = this.motion;
    marks.forEach(({ point }) => this.mark(points[point], colour));
    if (names) {
      [...joints, ...marks].forEach(({ point, name }) => this.word(name, points[point], of('text')));
      boxes.forEach(({ first, name }) => this.word(name, mean(points.slice(first, first + CORNERS)), of('text')));
    }
    this.pen.font = '12px Helvetica, Arial, sans-serif';
    this.pen.fillStyle = of('faint');
    this.pen.fillText(`grid ${Number(this.step.toPrecision(1))} m`, 14, this.height - 12);
  }
}
