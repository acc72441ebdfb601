// Tangled from paper/J-live-page.md; edit there.
/// Answers the page's questions. The module is the text of its gzip file in base64; post sends an
/// answer. Returns the function that takes questions.
function engine(post) {
  let compiled, solver;

  const text = (at) => {
    const bytes = new Uint8Array(solver.memory.buffer, at);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  };
  const refuse = (why) => { throw new Error(text(why)); };

  async function compile(base64) {
    const packed = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    compiled = await WebAssembly.compile(await new Response(stream).arrayBuffer());
  }

  function start() {
    const files = {};
    for (const { module, name } of WebAssembly.Module.imports(compiled))
      if (module !== "page") files[name] = () => 52;
    const imports = { page: { refuse }, wasi_snapshot_preview1: files };
    const started = new WebAssembly.Instance(compiled, imports).exports;
    started._initialize();
    solver = started;
  }

  const names = ["friction", "peclet", "heating", "conductivity_ratio", "heating_2", "direction",
    "law", "law_temperature", "law_floor", "quantity", "value", "tolerance", "method"];

  const numbers = (at, count) => Array.from(new Float64Array(solver.memory.buffer, at, count));

  function with_solver(question, work) {
    if (!solver) start();
    const at = new Float64Array(solver.memory.buffer, solver.thermoroll_question(), names.length);
    at.set(names.map((name) => question[name]));
    try {
      return work();
    } catch (error) {
      solver = null;
      throw error;
    }
  }

  const read = () => {
    const [model, unknowns, inadmissible, largest, its_creep, ...results] =
      numbers(solver.thermoroll_answer(), 27);
    return { model, unknowns, inadmissible, largest, its_creep, reason: text(solver.thermoroll_reason()),
      value: results.slice(0, 11), error: results.slice(11) };
  };

  const curve = (name) => numbers(solver.thermoroll_curve(), solver[name]());

  function times(question) {
    const all = [];
    for (let digits = 2; digits <= 10; ++digits) {
      const tolerance = Number(`1e-${digits}`);
      const found = with_solver({ ...question, tolerance }, () => {
        solver.thermoroll_solve();
        let count = 0, milliseconds = 0;
        for (const begin = performance.now(); milliseconds < 8; milliseconds = performance.now() - begin) {
          solver.thermoroll_solve();
          ++count;
        }
        return { tolerance, microseconds: (1000 * milliseconds) / count, ...read() };
      });
      all.push(found);
      if (found.microseconds > 60000) break;
    }
    return all;
  }

  function top_of(question, rows) {
    const half = Math.max(0, ...rows.filter((_, k) => k % 3 === 1)) / 2;
    try {
      const found = kinds.solve({ ...question, quantity: 2, value: half, tolerance: 1e-4, method: 0 });
      return Number.isFinite(found.largest) ? [found.its_creep, found.largest] : null;
    } catch {
      return null; // the curve is shown without it
    }
  }

  const kinds = {
    solve: (question) => with_solver(question, () => {
      const begin = performance.now();
      solver.thermoroll_solve();
      return { milliseconds: performance.now() - begin, ...read() };
    }),
    draw: (question) => {
      const found = kinds.solve(question);
      if (question.tolerance < 1e-6) kinds.solve({ ...question, tolerance: 1e-6 });
      return with_solver(question, () => ({ ...found, contact: curve("thermoroll_contact"),
        temperature: curve("thermoroll_temperature") }));
    },
    creep: (question) => {
      const rows = with_solver(question, () => curve("thermoroll_creep_curve"));
      return { rows, top: question.law < 0 ? null : top_of(question, rows) };
    },
    times,
    wheel: (question) => with_solver(question, () => curve("thermoroll_wheel")),
  };

  return async ({ kind, question, module }) => {
    try {
      if (module) await compile(module);
      post({ answer: module ? "ready" : kinds[kind](question) });
    } catch (error) {
      post({ refusal: error.message });
    }
  };
}
