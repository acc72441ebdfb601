"""live_bench.py REPORT TABLE: how long a slider's picture takes in the report. Printed, then written."""

import csv
import datetime
import os
import re
import statistics
import sys

from browser import Browser

MOVES = 200
LARGE = "document.querySelector('.live[data-large]')"
PLACES = {"slider of the traction": ".traction input", "border between stick and slip": ".handle",
          "point on the creep curve": ".handle[aria-label=creep]"}

# From a key to the drawing that follows, and to the end of the frame in which the browser lays it out and paints it.
MEASURE = """window.measured = new Promise((done) => addEventListener("keydown", () => {
  const begin = performance.now(), picture = %s.querySelector(".live-plot .curves");
  const drawn = new MutationObserver(() => {
    const drawing = performance.now() - begin, after = new MessageChannel();
    drawn.disconnect();
    after.port1.onmessage = () => done([drawing, performance.now() - begin]);
    requestAnimationFrame(() => after.port2.postMessage(0));
  });
  drawn.observe(picture, { childList: true });
}, { capture: true, once: true })); 0""" % LARGE


def key(browser, name, code):
    for kind in ("keyDown", "keyUp"):
        browser.call("Input.dispatchKeyEvent", type=kind, key=name, code=name, windowsVirtualKeyCode=code)


def measured(browser, place):
    """Milliseconds to drawing and to picture, for each move; the quick ones follow one another as in a drag."""
    browser.run(f"{LARGE}.querySelector('{place}').focus()")
    times = []
    for move in range(MOVES):
        browser.run(MEASURE)
        key(browser, *(("ArrowLeft", 37) if move % 40 < 20 else ("ArrowRight", 39)))
        times.append(browser.run("window.measured"))
    return zip(*times)


def machine():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        name = re.search(r"^model name[^:]*: *(.*)", file.read(), re.M).group(1)
    return f"{os.cpu_count()} × {name.replace(',', '')}"


def main(report, table):
    rows, load = [], os.getloadavg()[0]
    # The browser does not wait for a screen's next refresh, which would be counted with its work.
    with Browser(1366, 900, "--disable-frame-rate-limit", "--disable-gpu-vsync") as browser:
        version = browser.call("Browser.getVersion")["product"].split("/")[1].split(".")[0]
        browser.open("file://" + os.path.abspath(report))
        browser.run(LARGE + ".scrollIntoView()")
        browser.wait(f"!!{LARGE}.querySelector('.now')")
        for name, place in PLACES.items():
            drawing, picture = measured(browser, place)
            most = statistics.quantiles(picture, n=10)[-1]
            rows.append({"moved": name, "drawn, ms": f"{statistics.median(drawing):.1f}",
                         "picture, ms": f"{statistics.median(picture):.1f}", "nine in ten, ms": f"{most:.1f}",
                         "browser": f"Chromium {version}", "machine": machine(), "its load": f"{load:.1f}",
                         "date": datetime.datetime.now(datetime.timezone.utc).date().isoformat()})
            print(", ".join(rows[-1].values()), flush=True)
    with open(table + ".tmp", "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    os.replace(table + ".tmp", table)


if __name__ == "__main__":
    main(*sys.argv[1:])
