"""live_test.py CASE: the solver in build/report.html, asked and moved as a reader would."""

import csv
import io
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile
import urllib.parse

from browser import Browser

REPORT = "file://" + os.path.abspath("build/report.html")
FOLDER = tempfile.TemporaryDirectory()
PAGE = FOLDER.name + "/page.html"


def make_page():
    """The report's head, its large live part and its scripts: a page that opens at once."""
    with open("build/report.html", encoding="utf-8") as file:
        report = file.read()
    part = re.search(r'<div class="live" data-large="yes".*?</div>', report, re.S).group()
    scripts = report[report.index('<script type="application/octet-stream"'):]
    with open(PAGE, "w", encoding="utf-8") as file:
        file.write(report[:report.index("<body")] + "<body><main><article>" + part + "</article></main>" + scripts)
    return "file://" + PAGE


PAGE_ADDRESS = make_page()
LARGE = "document.querySelector('.live[data-large]')"
BORDER, TRACTION, CREEP = 0, 2, 4
COLUMNS = ["stick_slip_border", None, "traction", "creep_constant", "creep", "load_ratio", "gamma0",
           "heat_integral", "max_temperature", "max_temperature_at"]
RELATIVE = {"creep_constant", "creep", "heat_integral", "max_temperature"}


def opened(browser, state="", address=None, **how):
    """The small page, or another, with a state behind #live?"""
    browser.open((address or PAGE_ADDRESS) + (state and "#live?" + state), **how)
    browser.run(LARGE + ".scrollIntoView()")


def drawn(browser):
    browser.wait(f"!!{LARGE}.querySelector('.line-t') && !!{LARGE}.querySelector('.live-links code')")


def state(browser):
    """Border, traction and creep of the scene that is shown."""
    return browser.run(f"window.thermoroll.begin_at({LARGE}).answer.value.slice(0, 5)")


def command(browser):
    return browser.run(LARGE + ".querySelector('.live-links code').textContent")


def changed(browser, act, words=""):
    """The scene's command after an action that changes it, into one with these words.

    A hand that rests within a drag, as on a busy machine, has commands of its own on the way.
    """
    before = command(browser)
    act()
    browser.wait(f"(text => text !== {before!r} && text.includes({words!r}))"
                 f"({LARGE}.querySelector('.live-links code').textContent)")
    return command(browser)


# --- The numbers ------------------------------------------------------------------------------------

def random_scenes(count):
    draw = random.Random(20261123)
    log = lambda low, high: low * (high / low) ** draw.random()
    for _ in range(count):
        f = round(log(0.05, 1), 6)
        scene = {"friction": f, "peclet": float(f"{log(1, 1e6):.6g}"),
                 "heating": float(f"{log(1e-4, 2):.6g}"), "roller": draw.choice(["insulated", "identical"]),
                 "direction": draw.choice(["driving", "braking"]), "tolerance": draw.choice([1e-3, 1e-6])}
        scene["law"] = draw.choice(["constant"] * 4 + ["linear", "exponential", "rational"])
        scene["scale"] = float(f"{f / (math.sqrt(scene['peclet']) * log(0.3, 3)):.6g}")
        kind = draw.choice(["traction", "creep", "stick-slip-border"])
        share = 0.02 + 0.96 * draw.random()
        half = 1 - math.sqrt(1 - share)
        scene["kind"], scene["value"] = kind, float(f"{ {'traction': f * share * (0.5 if scene['law'] != 'constant' else 1), 'creep': 2 * f / math.pi * half, 'stick-slip-border': 1 - 2 * half}[kind]:.6g}")
        yield scene


def by_program(scenes):
    """What the program's sweep says of them."""
    rows = []
    for x in scenes:
        sign = -1 if x["direction"] == "braking" else 1
        given = {"traction": "", "creep": "", "stick-slip-border": ""}
        given[x["kind"]] = x["value"] * (1 if x["kind"] == "stick-slip-border" else sign)
        law = x["law"] != "constant"
        rows.append({"friction": x["friction"], "peclet": x["peclet"], "heating": x["heating"],
                     "roller": x["roller"], "tolerance": x["tolerance"], **given,
                     "direction": x["direction"] if x["kind"] == "stick-slip-border" else "",
                     "friction-law": x["law"] if law else "", "friction-temperature": x["scale"] if law else ""})
    table = io.StringIO()
    writer = csv.DictWriter(table, rows[0])
    writer.writeheader()
    writer.writerows(rows)
    done = subprocess.run(["build/thermoroll", "sweep"], input=table.getvalue(), capture_output=True, text=True)
    found = list(csv.DictReader(io.StringIO(done.stdout)))
    assert len(found) == len(scenes), done.stderr
    return found


def question(x):
    same = x["roller"] == "identical"
    return {"friction": x["friction"], "peclet": x["peclet"], "heating": x["heating"],
            "conductivity_ratio": int(same), "heating_2": x["heating"] if same else 0,
            "direction": int(x["direction"] == "braking"),
            "law": ["constant", "linear", "exponential", "rational"].index(x["law"]) - 1,
            "law_temperature": x["scale"], "law_floor": 0,
            "quantity": {"traction": TRACTION, "creep": CREEP, "stick-slip-border": BORDER}[x["kind"]],
            "value": x["value"], "tolerance": x["tolerance"], "method": 0}


def NumbersAreThoseOfTheProgram():
    scenes = list(random_scenes(300))
    expected = by_program(scenes)
    models = ["closed-form", "first-order", "coupled"]
    solved = refused = 0
    with Browser() as browser:
        opened(browser)
        drawn(browser)
        for x, row in zip(scenes, expected):
            got = browser.run("window.thermoroll.ask('solve', %s, 'test').catch((e) => e.message)" %
                              str(question(x)).replace("'", '"'))
            if row["status"] not in ("0", "5"):  # the page draws what is no contact and says so
                assert isinstance(got, str) and got in row["error"], (x, row["error"], got)
                refused += 1
                continue
            assert not isinstance(got, str), (x, got)
            assert got["inadmissible"] == (row["status"] == "5"), (x, row["status"])
            assert models[got["model"]] == row["model"], (x, row["model"], got["model"])
            if got["model"] == 2:
                assert got["unknowns"] == int(row["unknowns"]), (x, row["unknowns"], got["unknowns"])
            sign = -1 if x["direction"] == "braking" else 1
            for i, name in enumerate(COLUMNS):
                if not name:
                    continue
                value = got["value"][i] * (sign if name in ("traction", "creep") else 1)
                truth = float(row[name if name in row else name.replace("_", "-")])
                # The two differ by the roundings of other C libraries, some hundred units in the last
                # place of sums; the place of a flat maximum by the root of that.
                allowed = 1e-12 * (abs(truth) if name in RELATIVE else 1)
                if name == "max_temperature_at":
                    allowed = 1e-6
                assert abs(value - truth) <= allowed, (x, name, value, truth)
            solved += 1
        assert not browser.complaints(), browser.complaints()
    with Browser() as browser:  # and the whole report asks for nothing
        opened(browser, address=REPORT)
        drawn(browser)
        assert not browser.complaints() and not browser.requests(), (browser.complaints(), browser.requests())
    print(f"{solved} solved, {refused} refused alike")
    assert solved > 250


def CurvesCarryTheHeat():
    """The curves' f phi p* v* along the slip zone is the heat, to the error of a trapezoidal rule on 60
    points that crowd at both ends, about their number squared; friction falls, and all may slip."""
    hot = {"friction": 0.6, "peclet": 100, "heating": 0.0175, "roller": "insulated", "direction": "driving",
           "tolerance": 1e-6, "law": "linear", "scale": 0.02, "kind": "creep"}
    with Browser() as browser:
        opened(browser)
        drawn(browser)
        for x in ({**hot, "value": 0.35}, {**hot, "value": 1}, {**hot, "law": "constant", "value": 0.3}):
            found = browser.run("window.thermoroll.ask('draw', %s, 'test').then((x) => ({heat: x.value[%d], rows: [...x.contact]}))" %
                                (str(question(x)).replace("'", '"'), COLUMNS.index("heat_integral")))
            rows = [found["rows"][i:i + 5] for i in range(0, len(found["rows"]), 5)]
            slips = [(s, bound * v / x["friction"]) for s, _, bound, _, v in rows if v > 0]
            heat = sum((t - s) * (a + b) / 2 for (s, a), (t, b) in zip(slips, slips[1:]))
            assert abs(heat / found["heat"] - 1) < 5e-3, (x, heat, found["heat"])


# --- Handles, keys, links ---------------------------------------------------------------------------

def place_of(browser, handle):
    return browser.run(f"(() => {{ const b = {LARGE}.querySelectorAll('.handle')[{handle}].lastChild"
                       ".getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; })()")


def drag(browser, handle, dx):
    """Drag a handle to the right by so many pixels, by the mouse."""
    box = place_of(browser, handle)
    mouse = lambda kind, x: browser.call("Input.dispatchMouseEvent", type=kind, x=x, y=box[1], button="left",
                                         buttons=1, clickCount=1)
    mouse("mousePressed", box[0])
    for step in range(1, 6):
        mouse("mouseMoved", box[0] + dx * step / 5)
    mouse("mouseReleased", box[0] + dx)


def key(browser, name):
    browser.call("Input.dispatchKeyEvent", type="keyDown", key=name)
    browser.call("Input.dispatchKeyEvent", type="keyUp", key=name)


def HandlesAndKeys():
    with Browser() as browser:
        opened(browser)
        drawn(browser)
        browser.wait(f"!!{LARGE}.querySelector('.line-c')")
        start = state(browser)
        changed(browser, lambda: drag(browser, 0, 40), "--stick-slip-border")
        browser.wait(f"window.thermoroll.begin_at({LARGE}).answer.value[0] > {start[BORDER] + 0.1}")
        moved = state(browser)
        assert moved[TRACTION] < start[TRACTION] and moved[CREEP] < start[CREEP], (start, moved)
        changed(browser, lambda: drag(browser, 1, 30), "--creep")
        browser.wait(f"window.thermoroll.begin_at({LARGE}).answer.value[4] > {moved[CREEP]}")
        for handle in (0, 1):
            browser.run(f"{LARGE}.querySelectorAll('.handle')[{handle}].focus()")
            changed(browser, lambda: key(browser, "ArrowLeft"))
            assert browser.run(f"document.activeElement === {LARGE}.querySelectorAll('.handle')[{handle}]")
        changed(browser, lambda: browser.run(
            f"(() => {{ const i = {LARGE}.querySelector('.traction input'); i.value = 100;"
            "i.dispatchEvent(new Event('input')); })()"), "--traction")
        # To the ends, and by a tenth of the range, which for the border is 2.
        browser.run(f"{LARGE}.querySelector('.handle').focus()")
        now = lambda: float(browser.run(f"{LARGE}.querySelector('.handle').getAttribute('aria-valuenow')"))
        for name, place in (("Home", -0.995), ("PageUp", -0.795), ("End", 0.995), ("PageDown", 0.795)):
            changed(browser, lambda: key(browser, name), f"--stick-slip-border {place} ")
            browser.wait(f"Math.abs(window.thermoroll.begin_at({LARGE}).answer.value[0] - {place}) < 1e-9")
            assert abs(now() - place) <= 5e-4, (name, now())
        # The command is that of the numbers shown.
        browser.wait(f"!!{LARGE}.querySelector('.now')")
        shown = state(browser)
        text = command(browser)
        out = subprocess.run(["build/" + text + " --format json"], shell=True, capture_output=True, text=True)
        assert f'"creep": {shown[CREEP]:.6g}'[:16] in out.stdout, (text, shown, out.stdout, out.stderr)
        assert not browser.complaints(), browser.complaints()


def Touch():
    """A finger drags the border, and the page does not scroll under it; beside the handle it scrolls."""
    with Browser(390, 740) as browser:
        browser.call("Emulation.setTouchEmulationEnabled", enabled=True)
        opened(browser)
        drawn(browser)
        finger = lambda kind, *at: browser.call("Input.dispatchTouchEvent", type=kind,
                                                touchPoints=[{"x": x, "y": y} for x, y in at])
        start, scrolled = state(browser), browser.run("scrollY")
        x, y = place_of(browser, 0)

        def swipe():
            finger("touchStart", (x, y))
            for step in range(1, 9):
                finger("touchMove", (x + 5 * step, y + 9 * step))  # more down than along
            finger("touchEnd")

        changed(browser, swipe, "--stick-slip-border")
        browser.wait(f"window.thermoroll.begin_at({LARGE}).answer.value[0] > {start[BORDER] + 0.1}")
        assert browser.run("scrollY") == scrolled
        moved = state(browser)
        assert moved[TRACTION] < start[TRACTION] and moved[CREEP] < start[CREEP], (start, moved)
        assert not browser.complaints(), browser.complaints()


def SlidersAndMarks():
    with Browser() as browser:
        opened(browser, "peclet=100&law=linear&law_temperature=0.02&given=creep&value=0.35")
        drawn(browser)
        # The maximum of the creep curve is that of the program, though no traction is prescribed here.
        browser.wait(f"!!{LARGE}.querySelector('circle.peak')")
        mark = browser.run(LARGE + ".querySelector('text.peak').textContent")
        out = subprocess.run(["build/thermoroll", "solve", "--friction", "0.6", "--peclet", "100", "--heating", "0.0175",
                              "--friction-law", "linear", "--friction-temperature", "0.02", "--traction", "0.3",
                              "--format", "json"], capture_output=True, text=True, check=True)
        top = json.loads(out.stdout)
        assert mark == f"at most {top['traction_limit']:.4f}", (mark, top["traction_limit"])
        at = browser.run(f"""(() => {{
          const dot = {LARGE}.querySelector("circle.peak"), all = [...dot.parentElement.querySelectorAll(".line-c")];
          const line = all[0].getAttribute("d").slice(1).split("L").map((point) => point.split(" ").map(Number));
          const highest = line.reduce((a, b) => (b[1] < a[1] ? b : a));
          return [highest, ["cx", "cy"].map((name) => Number(dot.getAttribute(name)))]; }})()""")
        # The line has sixty points before full slip and as many after it, five pixels apart at most.
        assert abs(at[0][0] - at[1][0]) < 5 and abs(at[0][1] - at[1][1]) < 1, at
        changed(browser, lambda: browser.run(f"window.thermoroll.begin_at({LARGE}).change({{ law: 'constant', value: 0.2 }})"))
        browser.wait(f"!{LARGE}.querySelector('.peak')")
        # a/R and H are one number: the paper's wheel has both.
        slider = lambda name: browser.run(f"Number({LARGE}.querySelector('.{name} output').textContent)")
        wheel = browser.run("window.thermoroll.ask('wheel', {}, 'test')")
        move = lambda name, to: browser.run(f"(() => {{ const i = {LARGE}.querySelector('.{name} input');"
                                            f"i.value = {to}; i.dispatchEvent(new Event('input')); }})()")
        text = changed(browser, lambda: move("size", 120))
        size, heating = slider("size"), float(re.search(r"--heating (\S+)", text).group(1))
        assert abs(size / (2e-4 * 25000 ** 0.6) - 1) < 5e-3, size  # from 2e-4 to 5
        assert abs(heating / size / (wheel[1] / wheel[5]) - 1) < 5e-3, (heating, size, wheel)  # three digits are shown
        text = changed(browser, lambda: move("heating", 60))
        assert abs(slider("heating") / slider("size") / (wheel[1] / wheel[5]) - 1) < 1e-2, text
        assert abs(wheel[1] / wheel[5] - 0.728) < 1e-3, wheel  # pi / 4 (1 - 2 nu) / (1 - nu) Gamma of this steel
        changed(browser, lambda: move("size", 0), "--heating 0 ")
        assert slider("size") == slider("heating") == 0
        assert not browser.complaints(), browser.complaints()


def NamesAndRoles():
    """A screen reader finds each control with a name, its range and its value, and the value follows."""
    with Browser() as browser:
        opened(browser)
        drawn(browser)
        browser.wait(f"!!{LARGE}.querySelector('.line-c')")
        browser.call("Accessibility.enable")

        def controls(role):
            found = {}
            for node in browser.call("Accessibility.getFullAXTree")["nodes"]:
                if node.get("role", {}).get("value") == role and not node["ignored"]:
                    properties = {p["name"]: p["value"].get("value") for p in node["properties"]}
                    assert node["name"]["value"] not in found, node
                    found[node["name"]["value"]] = {**properties, "value": node.get("value", {}).get("value")}
            return found

        sliders = controls("slider")
        border, friction = sliders["border between stick and slip"], sliders["friction f"]
        assert set(sliders) == {"border between stick and slip", "creep", "friction f", "traction Q*/f",
                                "Péclet number Pe", "speed, m/s", "heating H", "a/R, of steel", "tolerance"}, sliders
        assert border["valuemin"] == -1 and border["valuemax"] == 1, border
        said = lambda which: browser.run(f"{LARGE}.querySelector({which!r}).getAttribute('aria-valuetext')")
        assert said(".handle") == f"border at {border['value']:.3f} half-widths", (said(".handle"), border)
        assert said(".friction input") == "0.6" and friction["valuemax"] == 200, (said(".friction input"), friction)
        assert len(controls("combobox")) == 4 and all(controls("combobox")), controls("combobox")
        browser.run(f"{LARGE}.querySelector('.handle').focus()")
        changed(browser, lambda: key(browser, "ArrowRight"))
        browser.wait(f"window.thermoroll.begin_at({LARGE}).answer.value[0] > {border['value'] + 0.03}")
        moved = controls("slider")["border between stick and slip"]
        assert moved["focused"] and abs(moved["value"] - border["value"] - 0.04) < 2e-3, (border, moved)
        assert said(".handle") == f"border at {moved['value']:.3f} half-widths", (said(".handle"), moved)
        text = said(".handle[aria-label=creep]")
        assert text == "creep {:.4f}, traction {:.4f}".format(state(browser)[CREEP], state(browser)[TRACTION]), text


def LinksAndNonsense():
    with Browser() as browser:
        opened(browser, "peclet=100&law=linear&law_temperature=0.02&given=creep&value=0.35&digits=6")
        browser.wait(f"{LARGE}.textContent.includes('--friction-law linear')")
        text = command(browser)
        assert "--peclet 100 " in text and "--creep 0.35" in text and "--tolerance 1e-6" in text, text
        link = browser.run(LARGE + ".querySelector('.live-links a').getAttribute('href')")
        assert "law=linear" in link and "peclet=100" in link and "heating" not in link, link
        assert browser.run("location.hash") == link
        opened(browser, "peclet=-1&friction=NaN&law=nonsense&value=1e999&x&=&constructor=1&__proto__=1&%&digits=3.4&heating=%3Cb%3E")
        drawn(browser)
        browser.wait(f"{LARGE}.textContent.includes('1e-3')")
        text = command(browser)
        assert text == ("thermoroll solve --friction 0.6 --traction 0.5 --peclet 4360 --heating 0.0175 "
                        "--tolerance 1e-3"), text
        assert not browser.complaints(), browser.complaints()


# --- Where it ends ----------------------------------------------------------------------------------

def story(browser):
    return browser.run(LARGE + ".querySelector('.live-story').textContent")


def RefusalsAreSentences():
    with Browser() as browser:
        opened(browser, "law=linear&law_temperature=0.02&peclet=100&value=0.99")
        browser.wait(f"{LARGE}.querySelector('.live-story')?.textContent.startsWith('Refused: ')")
        assert "traction" in story(browser), story(browser)
        browser.run(f"window.thermoroll.begin_at({LARGE}).change({{ value: 0.3 }})")
        browser.wait(f"{LARGE}.querySelector('.live-story').textContent.startsWith('Model: ')")
        # A traction that brakes is negative in the sentence and in the table of curves.
        assert "The traction is at most 0." in story(browser), story(browser)
        browser.run(f"window.thermoroll.begin_at({LARGE}).change({{ direction: 'braking' }})")
        browser.wait(f"{LARGE}.querySelector('.live-story').textContent.includes('The traction is at least −0.')")
        browser.wait(f"{LARGE}.querySelector('.live-links code').textContent.includes('--traction -0.18')")
        table = browser.run(LARGE + ".querySelector('a[download]').getAttribute('href')")
        rows = list(csv.DictReader(io.StringIO(urllib.parse.unquote(table).split(",", 1)[1].split("\n\n")[0])))
        assert min(float(row["traction"]) for row in rows) < -0.1 and max(float(row["traction"]) for row in rows) <= 0, rows
        assert max(float(row["slip"]) for row in rows) <= 0 < max(float(row["pressure"]) for row in rows), rows
        browser.run(f"window.thermoroll.begin_at({LARGE}).change({{ method: 'first-order' }})")
        browser.wait(f"{LARGE}.querySelector('.live-story').textContent.startsWith('Refused: ')")
        assert "coupled or auto" in story(browser), story(browser)
        # So is nonsense, and the next question is answered.
        got = browser.run("window.thermoroll.ask('solve', {}, 'test').catch((e) => e.message)")
        assert isinstance(got, str) and "friction" in got, got
        assert browser.run("window.thermoroll.ask('wheel', {}, 'test').then((x) => x.length)") == 6
        assert not browser.complaints(), browser.complaints()


def SlowSolvesAreCutOff():
    # The first question for times is lost on its way, as if its answer took for ever.
    lost = """const post = Worker.prototype.postMessage;
      Worker.prototype.postMessage = function (message) {
        if (message.kind === "times" && !window.lost) window.lost = performance.now();
        else post.call(this, message);
      };"""
    with Browser() as browser:
        opened(browser, before=lost)
        browser.wait("!!window.lost")
        got = browser.run("window.thermoroll.ask('wheel', {}, 'test').then((x) => x.length)")
        waited = browser.run("performance.now() - window.lost")
        assert got == 6 and waited > 4900, (got, waited)  # by the worker that followed
        changed(browser, lambda: browser.run(f"window.thermoroll.begin_at({LARGE}).change({{ digits: 3 }})"))
        browser.wait(f"!!{LARGE}.querySelector('.now')")
        assert not browser.complaints(), browser.complaints()


def PageStandsWithoutIt():
    spoilt = {
        "no worker": "delete window.Worker;",
        "no WebAssembly": "delete window.Worker; delete window.WebAssembly;",
        "a truncated module": "new MutationObserver((_, me) => {"
                              "const s = document.getElementById('solver'); if (s && s.textContent.length > 1e5) {"
                              "s.textContent = s.textContent.slice(0, 4000); me.disconnect(); } })"
                              ".observe(document, { childList: true, subtree: true });",
        "no unpacking": "delete window.Worker; delete window.DecompressionStream;",
    }
    words = "document.body.innerText.length"
    with Browser() as browser:
        browser.open(PAGE_ADDRESS, scripts=False)
        browser.call("Emulation.setScriptExecutionDisabled", value=False)
        whole = browser.run(words)
        assert browser.run(LARGE + ".textContent.includes('Without them')")
    for what, before in spoilt.items():
        with Browser() as browser:
            opened(browser, before=before)
            if what == "no worker":
                drawn(browser)
            else:
                browser.wait(f"{LARGE}.textContent.includes('does not run here')")
                assert browser.run(LARGE + ".textContent.includes('Without them')"), what
                assert browser.run(f"!{LARGE}.querySelector('svg')"), what
            assert browser.run(words) > 0.95 * whole, what
            assert not browser.complaints(), (what, browser.complaints())


def PolicyThatRefuses():
    """With a policy that refuses WebAssembly a sentence says so; with one that refuses scripts all is as without them."""
    script = "script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:"
    figures = "[...document.querySelectorAll('article figure svg')].filter((e) => e.checkVisibility()).length"
    for policy, file_name in (("script-src 'unsafe-inline' blob:", PAGE), ("script-src 'none'", "build/report.html")):
        with open(file_name, encoding="utf-8") as file:
            page = file.read()
        assert page.index(script) < page.index("<body")  # this test is in the page, too
        with open(FOLDER.name + "/refusing.html", "w", encoding="utf-8") as file:
            file.write(page.replace(script, policy, 1))
        with Browser() as browser:
            browser.open("file://" + FOLDER.name + "/refusing.html")
            if "inline" in policy:
                browser.wait(f"{LARGE}.textContent.includes('does not run here')")
            else:
                assert browser.run("typeof window.thermoroll") == "undefined"
                assert "does not run" not in browser.run(LARGE + ".textContent")
            assert browser.run(LARGE + ".textContent.includes('Without them')"), policy
            assert browser.run(f"!document.querySelector('.live svg')"), policy
            assert file_name == PAGE or browser.run(figures) > 30, (policy, browser.run(figures))
            assert all("Content Security Policy" in said for said in browser.complaints()), browser.complaints()


def FitsAPhone():
    with Browser(360, 740) as browser:
        opened(browser, address=REPORT)
        drawn(browser)
        browser.wait(f"!!{LARGE}.querySelector('.now')")
        too_wide = browser.run(
            "[...document.querySelectorAll('.live, .live *')].filter((e) => { const b = e.getBoundingClientRect();"
            "return b.width > 0 && (b.left < -0.5 || b.right > innerWidth + 0.5); }).map((e) => e.outerHTML.slice(0, 80))")
        assert not too_wide, too_wide
        assert browser.run("document.documentElement.scrollWidth <= innerWidth")
        # Labels do not leave their plots by more than the margin.
        assert browser.run(LARGE + ".querySelectorAll('.live-plot').length") == 5


if __name__ == "__main__":
    globals()[sys.argv[1]]()
