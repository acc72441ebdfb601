// Tangled from paper/J-live-page.md; edit there.
/// Fills every element of the class live; engine is the function of engine.js.
function live_page(engine) {
  "use strict";

  const longest = 5000; // milliseconds, then the worker is stopped and another one started
  let send, stop, timer, flight = null, generation = 0; // of the solver: a stopped one is not listened to
  const waiting = new Map(); // by asker and kind

  function next() {
    const first = waiting.entries().next();
    if (flight || first.done) return;
    const [key, task] = first.value;
    waiting.delete(key);
    flight = task;
    timer = setTimeout(give_up, longest, "this takes longer than five seconds");
    send(task.message);
  }

  function settle({ answer, refusal }) {
    if (!flight) return;
    clearTimeout(timer);
    const { done, failed } = flight;
    flight = null;
    if (refusal === undefined) done(answer); else failed(new Error(refusal));
    next();
  }

  function give_up(why) {
    const { failed } = flight;
    clearTimeout(timer);
    stop();
    begin_solver().catch(() => {});
    failed(new Error(why));
  }

  const ask = (kind, question, asker = "") => new Promise((done, failed) => {
    waiting.set(asker + kind, { message: { kind, question }, done, failed });
    next();
  });

  const module_text = document.getElementById("solver").textContent.trim();

  function begin_in_page() {
    const mine = ++generation;
    const answer = engine((message) => setTimeout(() => mine === generation && settle(message)));
    send = (message) => setTimeout(answer, 0, message);
    stop = () => {};
  }

  function begin_solver() {
    const source = `const answer = (${engine})((message) => postMessage(message));
      onmessage = ({ data }) => answer(data);`;
    try {
      const worker = new Worker(URL.createObjectURL(new Blob([source], { type: "text/javascript" })));
      const mine = ++generation;
      worker.onmessage = ({ data }) => mine === generation && settle(data);
      worker.onerror = () => { worker.terminate(); begin_in_page(); send({ module: module_text }); };
      send = (message) => worker.postMessage(message);
      stop = () => worker.terminate();
    } catch {
      begin_in_page();
    }
    return new Promise((done, failed) => {
      flight = { done, failed };
      send({ module: module_text });
    });
  }

  const border = 0, traction = 2, creep = 4; // of Quantity
  const paper = { friction: 0.6, peclet: 4360, heating: 0.0175, roller: "insulated", direction: "driving",
    law: "constant", law_temperature: 0.02, given: "traction", value: 5 / 6, digits: 4, method: "auto", speed: 0 };
  const choices = {
    roller: ["insulated", "identical"],
    direction: ["driving", "braking"],
    law: ["constant", "linear", "exponential", "rational", "piecewise-linear"],
    given: ["traction", "creep", "stick-slip-border"],
    method: ["auto", "closed-form", "first-order", "coupled"],
  };
  const ranges = { friction: [0.05, 1], peclet: [1, 1e6], heating: [0, 2], law_temperature: [1e-3, 1],
    value: [-1, 5], digits: [2, 10], speed: [0, 100] };

  const given_traction = (x) => x.value * x.friction;
  const tolerance_of = (x) => Number(`1e-${x.digits}`); // 10 ** -4 is not the nearest number

  function question_of(x) {
    const same = x.roller === "identical";
    return { friction: x.friction, peclet: x.peclet, heating: x.heating, conductivity_ratio: same ? 1 : 0,
      heating_2: same ? x.heating : 0, direction: choices.direction.indexOf(x.direction),
      law: choices.law.indexOf(x.law) - 1, law_temperature: x.law_temperature, law_floor: 0,
      quantity: { traction, creep, "stick-slip-border": border }[x.given],
      value: x.given === "traction" ? given_traction(x) : x.value,
      tolerance: tolerance_of(x), method: choices.method.indexOf(x.method) };
  }

  function command_of(x) {
    const sign = x.direction === "braking" ? -1 : 1, number = (y) => String(Number(y.toPrecision(12)));
    const asked = { traction: number(sign * given_traction(x)), creep: number(sign * x.value),
      "stick-slip-border": number(x.value) }[x.given];
    const words = ["thermoroll solve", "--friction", number(x.friction), `--${x.given}`, asked,
      "--peclet", number(x.peclet), "--heating", number(x.heating), "--tolerance", `1e-${x.digits}`];
    if (x.roller !== "insulated") words.push("--roller", x.roller);
    if (x.given === "stick-slip-border" && sign < 0) words.push("--direction braking");
    if (x.law !== "constant")
      words.push("--friction-law", x.law, "--friction-temperature", number(x.law_temperature));
    if (x.method !== "auto") words.push("--method", x.method);
    return words.join(" ");
  }

  const address_of = (x) => "#live?" + Object.keys(paper).filter((key) => x[key] !== paper[key])
    .map((key) => `${key}=${typeof x[key] === "number" ? Number(x[key].toPrecision(12)) : x[key]}`).join("&");

  function scene_from(text, start = paper) {
    const x = { ...start };
    for (const part of text.split("&")) {
      const [key, value] = part.split("=");
      const number = Number(value);
      if (Object.hasOwn(choices, key) && choices[key].includes(value)) x[key] = value;
      else if (Object.hasOwn(ranges, key) && value && number >= ranges[key][0] && number <= ranges[key][1]) x[key] = number;
    }
    x.digits = Math.round(x.digits);
    return x;
  }

  function carter_of(x) {
    const f = x.friction, share = x.value;
    const half = { traction: 1 - Math.sqrt(Math.max(0, 1 - share)), creep: Math.min(1, (Math.PI * share) / (2 * f)),
      "stick-slip-border": (1 - share) / 2 }[x.given];
    const c0 = 1 - 2 * half, hertz = (s) => (2 / Math.PI) * Math.sqrt(Math.max(0, 1 - s * s));
    const pull = (s) => f * hertz(s) - ((2 * f) / Math.PI) * Math.sqrt(Math.max(0, (1 + s) * (c0 - s)));
    return { hertz, pull, curve: (h) => [((2 * f) / Math.PI) * h, f * h * (2 - h)] };
  }

  function marks(low, high) {
    const rough = (high - low) / 4, power = 10 ** Math.floor(Math.log10(rough));
    const step = power * [1, 2, 5, 10].find((k) => k * power >= rough);
    const all = [];
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) all.push(k * step);
    return all.map((x) => [x, String(Number(x.toPrecision(6))).replace("-", "−")]);
  }

  const width = 340, height = 210, left = 44, right = 12, top = 14, bottom = 30;
  const element = (name, attributes = {}, inside = "") => {
    const space = name === "svg" || name === "g" ? "http://www.w3.org/2000/svg" : "http://www.w3.org/1999/xhtml";
    const made = document.createElementNS(space, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    made.innerHTML = inside;
    return made;
  };
  const renew = (place, text) => { if (place.drawn !== text) place.innerHTML = place.drawn = text; };

  function plot(title, note) {
    const figure = element("div", { class: "live-plot" }, `<p><b>${title}</b> <span>${note}</span></p>`);
    const svg = element("svg", { viewBox: `0 0 ${width} ${height}`, role: "group", "aria-label": title });
    const frame = element("g"), picture = element("g", { class: "curves" });
    svg.append(frame, picture);
    figure.append(svg);
    return { figure, svg, picture, frame: (drawing) => renew(frame, drawing) };
  }

  function scales([x0, x1], [y0, y1]) {
    const x = (v) => left + ((v - x0) / (x1 - x0)) * (width - left - right);
    const y = (v) => height - bottom - ((v - y0) / (y1 - y0)) * (height - top - bottom);
    return { x, y, back: (px) => x0 + ((px - left) / (width - left - right)) * (x1 - x0), x0, x1, y0, y1 };
  }

  function axes(to, x_marks, y_marks, x_name, y_name) {
    const line = (x1, y1, x2, y2) => `<path class="axis" d="M${x1} ${y1}L${x2} ${y2}"/>`;
    const word = (x, y, text, anchor) => `<text x="${x}" y="${y}" text-anchor="${anchor}">${text}</text>`;
    const base = height - bottom;
    return x_marks.map(([v, text]) => line(to.x(v), base, to.x(v), base + 4) + word(to.x(v), base + 15, text, "middle")).join("") +
      y_marks.map(([v, text]) => line(left, to.y(v), width - right, to.y(v)) + word(left - 5, to.y(v) + 4, text, "end")).join("") +
      word(width - right, height - 3, x_name, "end") + word(4, 10, y_name, "start");
  }

  const path = (to, rows, name) => {
    const seen = rows.filter(([, y]) => Number.isFinite(y));
    return `<path class="${name}" d="M${seen.map(([x, y]) => `${to.x(x).toFixed(1)} ${to.y(y).toFixed(1)}`).join("L")}"/>`;
  };
  const dot = (to, x, y, name) => `<circle class="${name}" cx="${to.x(x).toFixed(1)}" cy="${to.y(y).toFixed(1)}" r="4"/>`;
  const say = (x, y, text, name = "") => `<text class="${name}" x="${x.toFixed(1)}" y="${y.toFixed(1)}">${text}</text>`;

  function handle(shape, label, moved, stepped) {
    const knob = element("g", { class: "handle", tabindex: 0, role: "slider", "aria-label": label },
      '<circle class="reach" r="16"/><circle r="7"/>');
    shape.svg.append(knob);
    const place = (event) => {
      const box = shape.svg.getBoundingClientRect();
      moved(((event.clientX - box.left) / box.width) * width);
    };
    shape.svg.addEventListener("pointerdown", (event) => {
      if (event.target.closest(".handle") !== knob) return;
      knob.setPointerCapture(event.pointerId);
      knob.addEventListener("pointermove", place);
      knob.addEventListener("lostpointercapture", () => knob.removeEventListener("pointermove", place), { once: true });
    });
    knob.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
    knob.addEventListener("keydown", (event) => {
      const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 5, PageDown: -5,
        Home: -Infinity, End: Infinity }[event.key];
      if (!by || !knob.hasAttribute("aria-valuenow")) return; // nothing is drawn yet
      event.preventDefault();
      stepped((by / 50) * (event.shiftKey ? 0.2 : 1));
    });
    return (x, y, [least, now, most], words) => {
      knob.setAttribute("transform", `translate(${x.toFixed(1)} ${y.toFixed(1)})`);
      knob.setAttribute("aria-valuenow", now);
      knob.setAttribute("aria-valuemin", least);
      knob.setAttribute("aria-valuemax", most);
      knob.setAttribute("aria-valuetext", words);
    };
  }

  const rows_of = (list, count) => {
    const rows = [];
    for (let i = 0; i < list.length; i += count) rows.push(list.slice(i, i + count));
    return rows;
  };
  const nice = (x) => 10 ** (Math.ceil(20 * Math.log10(1.12 * x)) / 20);
  const at_border = (x) => Math.min(0.995, Math.max(-0.995, x));

  const views = {};
  views.contact = (instance) => {
    const view = plot("Pressure and traction", "dotted: no heat");
    let to = scales([-1.05, 1.05], [0, 0.74]);
    const give = (c0) => instance.change({ given: "stick-slip-border", value: at_border(c0) });
    const put = handle(view, "border between stick and slip", (px) => give(to.back(px)),
      (by) => give(instance.now(border) + 2 * by));
    view.draw = ({ value, contact }, x) => {
      const rows = rows_of(contact, 5), c0 = value[border], cold = carter_of(x), sign = x.direction === "braking" ? -1 : 1;
      const across = Array.from({ length: 101 }, (_, i) => -Math.cos((Math.PI * i) / 100));
      const column = (k) => rows.map((row) => [row[0], row[k]]);
      to = scales([-1.05, 1.05], [0, Math.max(0.74, nice(Math.max(...rows.map((row) => row[1]))))]);
      const middle = to.x((1 + c0) / 2);
      view.frame(axes(to, marks(-1, 1), marks(0, 0.6), "s", "p*, q*"));
      view.picture.innerHTML =
        `<rect class="slips" x="${to.x(c0)}" y="${top}" width="${to.x(1) - to.x(c0)}" height="${height - top - bottom}"/>` +
        path(to, across.map((s) => [s, cold.hertz(s)]), "cold") + path(to, across.map((s) => [s, cold.pull(s)]), "cold") +
        path(to, column(2), "bound") + path(to, column(1), "line-p") + path(to, column(3), "line-q") +
        say(to.x(-0.62), to.y(0.56), "p*", "name-p") + say(Math.min(middle, 300), to.y(0.08), sign < 0 ? "q* < 0, slip" : "q*, slip", "name-q") +
        (c0 > -0.7 ? say(to.x((c0 - 1) / 2) - 12, to.y(0.03), "stick") : "");
      put(to.x(c0), top + 4, [-1, c0.toFixed(3), 1], `border at ${c0.toFixed(3)} half-widths`);
    };
    return view;
  };

  views.slip = () => {
    const view = plot("Slip velocity", "");
    view.draw = ({ value, contact }) => {
      const rows = rows_of(contact, 5).map((row) => [row[0], row[4]]);
      const most = nice(Math.max(...rows.map((row) => row[1]), 1e-9)), to = scales([-1.05, 1.05], [0, most]);
      view.frame(axes(to, marks(-1, 1), marks(0, most), "s", "v*"));
      view.picture.innerHTML = path(to, rows, "line-v");
      view.svg.setAttribute("aria-label", value[border] === -1 ? "Slip velocity, above 0 in the whole contact" :
        `Slip velocity, rising from 0 at ${value[border].toFixed(2)}`);
    };
    return view;
  };
  views.temperature = (instance) => {
    const view = plot("Surface temperature", "");
    view.draw = ({ value, temperature }, x) => {
      const unit = instance.degrees(x), rows = rows_of(temperature, 2).map(([s, t]) => [s, t * unit]);
      const hottest = value[8] * unit, most = nice(hottest), to = scales([-1.4, 3], [0, most]);
      const name = hottest.toPrecision(4) + (unit === 1 ? "" : " °C");
      view.frame(axes(to, marks(-1, 3), marks(0, most), "s", unit === 1 ? "T*" : "°C"));
      view.picture.innerHTML =
        `<rect class="slips" x="${to.x(value[border])}" y="${top}" width="${to.x(1) - to.x(value[border])}" height="${height - top - bottom}"/>` +
        path(to, rows, "line-t") +
        dot(to, value[9], hottest, "hot") + say(Math.min(to.x(value[9]) + 3, 250), to.y(hottest) - 7, name, "name-t");
      view.svg.setAttribute("aria-label", `Surface temperature, at most ${name} at ${value[9].toFixed(2)}`);
    };
    return view;
  };

  views.creep = (instance) => {
    const view = plot("Creep curve", "dotted: Carter");
    let to = scales([0, 1], [0, 1]), rows = [], peak = null;
    const end = () => (rows.length ? rows[rows.length - 1][0] : to.x1);
    const give = (xi) => instance.change({ given: "creep", value: Math.max(1e-4, Math.min(xi, end())) });
    const put = handle(view, "creep", (px) => give(to.back(px)), (by) => give(instance.now(creep) + by * to.x1));
    view.curve = ({ rows: list, top }) => { rows = rows_of(list, 3); peak = top; };
    view.draw = ({ value }, x) => {
      const last = rows.length ? rows[rows.length - 1][0] : value[creep], f = x.friction;
      const most = Math.max(f, ...rows.map((row) => row[1])) * 1.15;
      to = scales([0, Math.max(last, value[creep]) * 1.02], [0, most]);
      const cold = carter_of(x).curve, early = Array.from({ length: 41 }, (_, i) => cold(i / 40));
      view.frame(axes(to, marks(0, to.x1), marks(0, most), "creep ξ*", "traction Q*"));
      view.picture.innerHTML =
        path(to, [...early, [to.x1, f]].filter(([xi]) => xi <= to.x1), "cold") +
        path(to, [[0, 0], ...rows.map((row) => row.slice(0, 2))], "line-c") +
        (peak ? dot(to, ...peak, "peak") + say(Math.min(to.x(peak[0]) + 6, 232), to.y(peak[1]) - 9, `at most ${peak[1].toPrecision(4)}`, "peak") : "");
      put(to.x(value[creep]), to.y(value[traction]), [0, value[creep].toFixed(4), to.x1.toFixed(4)], `creep ${value[creep].toFixed(4)}, traction ${value[traction].toFixed(4)}`);
    };
    return view;
  };

  const models = ["closed form", "one linear correction", "coupled solver"];
  views.time = () => {
    const view = plot("Time of a solve here",
      '<i class="model-0">closed form</i>, <i class="model-1">one linear correction</i>, <i class="model-2">coupled</i>');
    const powers = [[-5, "10 µs"], [-4, "0.1 ms"], [-3, "1 ms"], [-2, "10 ms"], [-1, "0.1 s"], [0, "1 s"]];
    const to = scales([2, 10], [-5.3, 0]);
    view.times = (all, x) => {
      const rows = all.map((t) => [-Math.log10(t.tolerance), Math.min(0, Math.max(-5.3, Math.log10(t.microseconds) - 6))]);
      const labels = [2, 4, 6, 8, 10].map((d) => [d, `10<tspan dy="-4" font-size="8">−${d}</tspan>`]);
      view.frame(axes(to, labels, powers, "tolerance", ""));
      view.picture.innerHTML = path(to, rows, "line-c") +
        rows.map(([d, y], i) => dot(to, d, y, `model-${all[i].model}${d === x.digits ? " now" : ""}`)).join("");
      view.svg.setAttribute("aria-label", "Time of a solve in this browser: " +
        all.map((t) => `${t.microseconds.toPrecision(2)} microseconds to ${t.tolerance} by the ${models[t.model]}`).join(", "));
    };
    view.draw = () => {};
    return view;
  };

  const sliders = {
    friction: ["friction f", 0.05, 1],
    traction: ["traction Q*/f", 0.01, 0.999],
    peclet: ["Péclet number Pe", 1, 1e6, "log"],
    speed: ["speed, m/s", 0.5, 100],
    heating: ["heating H", 1e-4, 2, "log"],
    size: ["a/R, of steel", 2e-4, 5, "log"],
    law_temperature: ["T₀* of the law", 1e-3, 1, "log"],
    digits: ["tolerance", 2, 10],
  };

  function slider(key, changed) {
    const [name, low, high, log] = sliders[key], steps = key === "digits" ? 8 : 200;
    const label = element("label", { class: `live-slider ${key}` },
      `<span>${name}</span><input type="range" min="0" max="${steps}" aria-label="${name}" /><output aria-live="off"></output>`);
    const [, input, output] = label.children;
    const value = () => {
      const t = input.value / steps;
      if (t === 0 && (key === "heating" || key === "size")) return 0;
      return log ? low * (high / low) ** t : low + (high - low) * t;
    };
    input.addEventListener("input", () => changed(Number(value().toPrecision(4))));
    return { label, show(v) {
      const t = log ? Math.log(Math.max(v, low) / low) / Math.log(high / low) : (v - low) / (high - low);
      input.value = Math.round(steps * Math.min(1, Math.max(0, t)));
      const off = key === "speed" && v === 0;
      output.textContent = off ? "–" : key === "digits" ? `1e−${v}` : String(Number(v.toPrecision(3)));
      input.setAttribute("aria-valuetext", output.textContent);
    } };
  }

  function list(key, name, changed) {
    const label = element("label", { class: "live-list" }, `<span>${name}</span><select>` +
      choices[key].map((choice) => `<option>${choice}</option>`).join("") + "</select>");
    label.lastChild.addEventListener("change", (event) => changed(event.target.value));
    return { label, show(v) { label.lastChild.value = v; } };
  }

  const examples = {
    "the paper’s wheel": {},
    "strong heat": { peclet: 43.6, heating: 0.5 },
    "two steel bodies": { roller: "identical" },
    "falling friction": { law: "linear", law_temperature: 0.02, peclet: 100, given: "creep", value: 0.35 },
    "°C, at a speed": { speed: 22.2 },
  };

  const results = [["traction Q*", 2], ["creep ξ*", 4], ["border c₀", 0], ["load ratio κ", 5], ["heat ∫v*p*", 7],
    ["hottest T*", 8], ["at s =", 9]];

  const written = (x, error) => {
    const decimals = error > 0 ? Math.min(12, Math.max(0, 1 - Math.floor(Math.log10(error)))) : 6;
    return x.toFixed(decimals).replace("-", "−");
  };
  const brief = (x, exactly = "exact") => x > 0 ? `± ${x.toExponential(0).replace("-", "−")}` : exactly;

  const sign_of = (x) => x.direction === "braking" ? -1 : 1;

  function table_of(answer, x, instance) {
    const sign = sign_of(x);
    const rows = results.map(([name, i]) => {
      const value = answer.value[i] * (i === traction || i === creep ? sign : 1), error = answer.error[i];
      return [name, written(value, error), brief(error, i === question_of(x).quantity ? "given" : "exact")];
    });
    const unit = instance.degrees(x);
    if (unit !== 1) rows.push(["hottest, °C", written(answer.value[8] * unit, answer.error[8] * unit), brief(answer.error[8] * unit)]);
    return rows.map((row) => `<tr>${row.map((cell) => `<td>${cell}</td>`).join("")}</tr>`).join("");
  }

  function story_of(answer, x) {
    const full = answer.value[border] === -1 ? " The whole contact slips." : "";
    const wrong = answer.inadmissible ? " This is no contact: pressure or slip has the wrong sign." : "";
    const signed = (value, digits) => (sign_of(x) * value).toPrecision(digits).replace("-", "−");
    const limit = Number.isFinite(answer.largest)
      ? ` The traction is at ${sign_of(x) < 0 ? "least" : "most"} ${signed(answer.largest, 4)}, at the creep ${signed(answer.its_creep, 3)}.` : "";
    const grid = answer.model === 2 ? `, ${answer.unknowns} unknowns` : "";
    const steel = x.speed > 0 && wheel ? ` The paper’s wheel: half-width ${(1000 * wheel[3]).toPrecision(3)} mm, Hertz’s pressure ${(wheel[4] / 1e6).toFixed(0)} MPa.` : "";
    return `Model: ${models[answer.model]}${grid} (${answer.reason}).${full}${limit}${wrong}${steel}`;
  }

  function error_of(answer, all, x) {
    const best = all[all.length - 1], relative = [3, 4, 7, 8];
    if (best.tolerance > 0.101 * tolerance_of(x)) return "";
    const off = (i, x) => x / (relative.includes(i) ? Math.abs(best.value[i]) || 1 : 1);
    const largest = (list) => Math.max(...[0, 2, 3, 4, 5, 6, 7, 8].map((i) => off(i, list(i))));
    const stated = largest((i) => answer.error[i]), made = largest((i) => Math.abs(answer.value[i] - best.value[i]));
    return `Estimated error ${stated.toExponential(0)}; off by ${made.toExponential(0)} from the solution to ${best.tolerance.toExponential(0)}.`
      .replaceAll("e-", "e−");
  }

  let wheel = null; // Pe, H and °C at 1 m/s and f = 1; half-width in m, largest pressure in Pa, a/R
  const per_size = () => (wheel ? wheel[1] / wheel[5] : 1); // H by a/R

  function instance_in(root, number) {
    const names = (root.dataset.views || "contact").split(" ");
    const large = "large" in root.dataset, me = { answer: null };
    let scene = scene_from(root.dataset.scene || ""), later, slow, curve_of = "";
    me.now = (what) => ({ "stick-slip-border": border, creep }[scene.given] === what ? scene.value : me.answer.value[what]);
    me.degrees = (x) => (x.speed > 0 && wheel ? wheel[2] * x.speed * x.friction : 1);
    root.replaceChildren();
    const shown = names.map((name) => views[name](me));
    const keys = (root.dataset.sliders || Object.keys(sliders).join(" ")).split(" ");
    const changes = { traction: (value) => ({ given: "traction", value }), peclet: (peclet) => ({ peclet, speed: 0 }),
      heating: (heating) => ({ heating, speed: 0 }), size: (size) => ({ heating: size * per_size(), speed: 0 }) };
    const controls = keys.map((key) => [key, slider(key, (value) => me.change(changes[key] ? changes[key](value) : { [key]: value }))]);
    const lists = large ? [["roller", "roller"], ["direction", "wheel"], ["law", "friction law"], ["method", "model"]]
      .map(([key, name]) => [key, list(key, name, (value) => me.change({ [key]: value }))]) : [];
    const panel = element("div", { class: "live-panel" });
    panel.append(...controls.map(([, c]) => c.label), ...lists.map(([, c]) => c.label));
    const buttons = element("p", { class: "live-buttons" });
    for (const [name, some] of large ? Object.entries(examples) : []) {
      const button = element("button", { type: "button" }, name);
      button.addEventListener("click", () => me.change({ ...paper, digits: scene.digits, ...some }));
      buttons.append(button);
    }
    const story = element("p", { class: "live-story", role: "status" }), made = element("p", { class: "live-story" });
    const table = element("div", { class: "live-results" }, "<table><tbody></tbody></table>"), links = element("p", { class: "live-links" });
    panel.append(buttons, story, made, ...(large ? [table, links] : []));
    root.append(...shown.map((view) => view.figure), panel);

    function show_controls() {
      const now = { ...scene, size: scene.heating / per_size(),
        traction: scene.given === "traction" ? scene.value : Math.abs(me.answer ? me.answer.value[traction] / scene.friction : 0.5) };
      for (const [key, control] of [...controls, ...lists]) control.show(now[key]);
      root.classList.toggle("with-law", scene.law !== "constant");
    }
    function show_table(asked) {
      const body = table.querySelector("tbody");
      body.innerHTML = table_of(me.answer, asked, me);
      table.style.setProperty("--rows", body.children.length);
    }

    const tell = (words) => { if (story.textContent !== words) story.textContent = words; };

    async function redraw() {
      const asked = scene, question = question_of(asked);
      clearTimeout(later);
      clearTimeout(slow);
      slow = setTimeout(show_controls, 50);
      try {
        me.answer = await ask("draw", question, number);
        for (const view of shown) view.draw(me.answer, asked);
        tell(story_of(me.answer, asked));
        show_table(asked);
        root.classList.remove("refused");
      } catch (error) {
        tell(`Refused: ${error.message}`);
        root.classList.add("refused");
      }
      clearTimeout(slow);
      show_controls();
      if (asked !== scene) return;
      later = setTimeout(slower, curve_of ? 250 : 0, asked, question);
    }

    async function slower(asked, question) {
      const creep_view = shown.find((view) => view.curve), time_view = shown.find((view) => view.times);
      const key = JSON.stringify({ ...question, quantity: 0, value: 0, tolerance: 0, method: 0 });
      if (large) show_links(asked);
      try {
        if (creep_view && key !== curve_of) {
          creep_view.curve(await ask("creep", question, number));
          curve_of = key;
          if (asked !== scene) return;
          creep_view.draw(me.answer, asked);
        }
        if (time_view && !root.classList.contains("refused")) {
          const all = await ask("times", question, number);
          if (asked !== scene) return;
          time_view.times(all, asked);
          made.textContent = asked.method === "auto" || asked.method === "coupled" ? error_of(me.answer, all, asked) : "";
        }
      } catch {
        made.textContent = "";
        if (creep_view && curve_of !== key) creep_view.curve({ rows: [], top: null });
      }
    }

    function show_links(asked) {
      const in_its_direction = ([s, pressure, bound, q, v]) => [s, pressure, bound, sign_of(asked) * q, sign_of(asked) * v].join();
      const csv = me.answer && !root.classList.contains("refused") ? "s,pressure,bound,traction,slip\n" + rows_of(me.answer.contact, 5).map(in_its_direction).join("\n") +
        "\n\ns,temperature\n" + rows_of(me.answer.temperature, 2).map((row) => row.join()).join("\n") + "\n" : "";
      const address = address_of(asked);
      links.innerHTML = `<code>${command_of(asked).replace(/--\S+/g, "<span>$&</span>")}</code><br/><a href="${address}">Link to this scene</a> · ` +
        `<a download="contact.csv" href="data:text/csv,${encodeURIComponent(csv)}">Curves as CSV</a>`;
      try {
        if (me.touched || location.hash.startsWith("#live?")) history.replaceState(null, "", address);
      } catch { /* the address is not ours to change */ }
    }
    me.change = (some) => {
      me.touched = true;
      scene = { ...scene, ...some };
      if (scene.speed > 0 && wheel) Object.assign(scene, { peclet: wheel[0] * scene.speed, heating: wheel[1] });
      return redraw();
    };
    me.move = (text) => me.change(scene_from(text));
    redraw();
    show_controls();
    return me;
  }

  const roots = [...document.querySelectorAll(".live")], whole = roots.find((root) => "large" in root.dataset);
  const begun = new Map();

  function begin_at(root) {
    if (begun.has(root)) return begun.get(root);
    begun.set(root, instance_in(root, String(roots.indexOf(root))));
    return begun.get(root);
  }

  const from_address = () => {
    if (!whole || !location.hash.startsWith("#live?")) return;
    begin_at(whole).move(location.hash.slice(6));
    whole.scrollIntoView();
  };

  async function begin() {
    await begin_solver();
    wheel = await ask("wheel", question_of(paper));
    const near = new IntersectionObserver((seen) => {
      for (const { target, isIntersecting } of seen) if (isIntersecting) begin_at(target);
    }, { rootMargin: "600px" });
    for (const root of roots) near.observe(root);
    addEventListener("hashchange", from_address);
    from_address();
  }

  window.thermoroll = { ask, begin_at, roots };
  return begin().catch((error) => {
    for (const root of roots) root.append(` The solver does not run here (${error.message}).`);
  });
}
