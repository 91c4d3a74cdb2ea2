#!/usr/bin/env python3
"""Reports as a browser shows them: no error, a model that is drawn, answers with the numbers of supports.csv and switches
its steps, charts that answer the mouse with the numbers of line.csv, print without cut tables, a phone without sideways
scrolling, no page above 2 MB.

    check_reports.py CHROMIUM FRICTIONBEAM FOLDER NAME=CASE.prm...
"""
import base64
import csv
import os
import subprocess
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from browser import Browser  # noqa: E402

MOST_BYTES = 2_000_000
PAPER = 703  # px between the margins of an upright A4 page: (210 - 24) mm at 96 px an inch
failed = []


def check(holds, what):
    if not holds:
        failed.append(what)
        print("FAILED:", what, flush=True)


def rows_of(folder, name):
    with open(os.path.join(folder, name), newline="") as file:
        return list(csv.DictReader(file))


def close(shown, exact, parts=1e-6):
    """Whether a number as text has the digits of another."""
    return abs(float(shown) - float(exact)) <= parts * abs(float(exact)) + 1e-300


# Counts what is not white in the canvas, and its colours, right after it has been drawn.
DRAWN = """new Promise(done => {
  document.getElementById('model-names').dispatchEvent(new Event('change'));
  requestAnimationFrame(() => {
    const from = document.getElementById('model-canvas'), to = document.createElement('canvas');
    to.width = from.width; to.height = from.height;
    const pen = to.getContext('2d');
    pen.drawImage(from, 0, 0);
    const bytes = pen.getImageData(0, 0, to.width, to.height).data, colours = new Set();
    let n = 0, sum = 0;
    for (let i = 0; i < bytes.length; i += 4) {
      const rgb = bytes[i] * 65536 + bytes[i + 1] * 256 + bytes[i + 2];
      if (rgb !== 0xffffff) { ++n; colours.add(rgb); sum = (sum * 31 + rgb * (i % 9973)) % 1e9; }
    }
    done([n, colours.size, sum]);
  });
})"""
TABLE = "[...document.querySelectorAll('#model-table .model-states tbody tr')].map(row => [...row.cells].map(cell => cell.textContent))"
HEAD = "[...document.querySelectorAll('#model-table .model-states th')].map(cell => cell.firstChild.textContent.trim())"


def choose(browser, name):
    """Take a step by its name."""
    browser.evaluate("""(name => {
      const chooser = document.getElementById('model-step');
      chooser.value = [...chooser.options].find(option => option.text === name).value;
      chooser.dispatchEvent(new Event('change'));
    })(%r)""" % name)


def check_model(browser, name, folder):
    browser.wait("document.getElementById('model').dataset.ready === 'yes'")
    browser.evaluate("document.getElementById('model').scrollIntoView()")
    n, colours, _ = browser.evaluate(DRAWN)
    check(n > 500 and colours > 10, f"{name}: the canvas shows something ({n} px, {colours} colours)")

    supports = rows_of(folder, "supports.csv")
    if not supports:
        return
    steps = list(dict.fromkeys(row["step"] for row in rows_of(folder, "line.csv")))
    offered = browser.evaluate("[...document.getElementById('model-step').options].map(option => option.text)")
    check(set(steps) <= set(offered), f"{name}: the chooser has the steps {steps} (it has {offered})")
    last = {step: [row for row in supports if row["step"] == step] for step in steps}
    for support in [supports[0]["support"], supports[len(supports) // 2]["support"]]:
        browser.click(*browser.evaluate("document.getElementById('model').locate(%r)" % support))
        title = browser.evaluate("document.querySelector('#model-table h3').textContent")
        check(title.startswith("Support " + support + ","), f"{name}: a click on {support} shows it (it shows {title})")
        head = browser.evaluate(HEAD)
        shown = [row for row in browser.evaluate(TABLE) if "(instant)" not in row[0]]
        check([row[0] for row in shown][: len(steps)] == steps, f"{name}: {support} has a row for each step")
        for row in shown[: len(steps)]:
            exact = [one for one in last[row[0]] if one["support"] == support][-1]
            check(row[head.index("status")] == exact["status"], f"{name}: status of {support} in {row[0]}")
            for column in ["fn", "ft1", "ft2", "slip1"]:
                text = row[head.index(column)]
                check(close(text, exact[column]), f"{name}: {column} of {support} in {row[0]} is {text}, csv {exact[column]}")

    if len(steps) > 1:
        pictures = []
        for step in steps[:2]:
            choose(browser, step)
            pictures.append(browser.evaluate(DRAWN)[2])
            check(browser.evaluate("document.getElementById('model-status').textContent").startswith(step),
                  f"{name}: the model says that it shows {step}")
            check(browser.evaluate("document.querySelector('#model-table tr.now td').textContent") == step,
                  f"{name}: the table marks {step}")
        check(pictures[0] != pictures[1], f"{name}: another step is another picture")


def check_history(browser, name, folder):
    """Of a transient step: the least and largest of a support's fn are those of envelope.csv, its history has the values of
    supports.csv under the cursor, and a click there takes the model to that instant."""
    path = os.path.join(folder, "envelope.csv")
    steps = browser.evaluate("[...document.getElementById('model-step').options].map(option => option.text)")
    over_time = [step[: -len(", over time")] for step in steps if step.endswith(", over time")]
    check(bool(over_time) == (os.path.exists(path) and any(row["part"] == "support" for row in rows_of(folder, "envelope.csv"))),
          f"{name}: a transient step can be played")
    if not over_time:
        return
    step, supports = over_time[-1], rows_of(folder, "supports.csv")
    support = supports[0]["support"]
    choose(browser, step + ", over time")
    browser.click(*browser.evaluate("document.getElementById('model').locate(%r)" % support))
    row = browser.evaluate("[...[...document.querySelectorAll('#model-table h4 + .scroll tbody tr')].find(row => row.cells[0].textContent.startsWith('fn ')).cells].map(cell => cell.textContent)")
    exact = next(one for one in rows_of(folder, "envelope.csv") if one["name"] == support and one["what"] == "fn" and one["step"] == step)
    for text, column in zip(row[1:], ["least", "time_of_least", "largest", "time_of_largest"]):
        check(close(text, exact[column], 1e-3), f"{name}: {column} of fn of {support} is {text}, envelope.csv {exact[column]}")
    x, y = browser.evaluate("(r => [r.left + 0.4 * r.width, r.top + 0.5 * r.height])((document.getElementById('model-history').scrollIntoView({block: 'center'}), document.getElementById('model-history').getBoundingClientRect()))")
    browser.mouse("mouseMoved", x, y)
    tip = browser.evaluate("(t => [t.hidden, ...[...t.childNodes].map(n => n.textContent)])(document.querySelector('#model-history + .tip'))")
    time_shown, fn = float(tip[1].split()[0]), float(tip[2].split()[1])
    at = [one for one in supports if one["support"] == support and one["step"] == step and close(one["time"], time_shown, 1e-5)]
    check(not tip[0] and at and close(fn, at[-1]["fn"], 1e-4), f"{name}: fn of {support} at {time_shown} s is {fn} under the cursor")
    browser.click(x, y)
    status = browser.evaluate("document.getElementById('model-status').textContent")
    check(status.startswith(f"{step}, {float(f'{time_shown:.5g}'):g} s"), f"{name}: a click on the history shows that instant ({status})")


def check_play(browser, name):
    groups = browser.evaluate("[...document.querySelectorAll('#model-step optgroup')].map(group => [group.label, group.firstChild.text, group.children.length])")
    moving = [first for label, first, n in groups if label in ["modes", "over time"] or (label == "at the end of" and n > 1)]
    fixed = [first for label, first, n in groups if label in ["cases", "largest over time"] or (label == "at the end of" and n == 1)]
    for state in fixed + moving:
        choose(browser, state)
        hidden = browser.evaluate("document.getElementById('model-play').hidden")
        check(hidden == (state in fixed), f"{name}: {state} can{'not' if state in fixed else ''} be played")
    if not moving:
        return
    browser.evaluate("document.getElementById('model-play').click()")
    browser.wait("document.getElementById('model-canvas').dataset.fps !== undefined")
    browser.evaluate("document.getElementById('model-play').click()")
    frames = browser.evaluate("document.getElementById('model-canvas').dataset.fps")
    print(f"{name}: {frames} frames/s while playing")


def check_chart(browser, name, folder):
    """The value under the cursor, of the first chart of section forces: N of the first pipe over s."""
    where = browser.evaluate("""(() => {
      const svg = document.querySelector('#forces svg[data-axes]');
      if (!svg) return null;
      svg.scrollIntoView({block: 'center'});
      const at = svg.getBoundingClientRect();
      return [at.left + 0.6 * at.width, at.top + 0.5 * at.height, svg.getAttribute('aria-label'), svg.closest('.charts').previousElementSibling.previousElementSibling.textContent];
    })()""")
    check(where is not None, f"{name}: there is a chart with axes")
    if where is None:
        return
    x, y, label, _ = where
    browser.mouse("mouseMoved", x, y)
    tip = browser.evaluate("(t => t && [t.hidden, t.firstChild.textContent, [...t.children].map(row => row.textContent)])(document.querySelector('#forces .tip'))")
    check(tip and not tip[0] and tip[2], f"{name}: the chart answers the mouse")
    if not tip or not tip[2] or not label.startswith("N, axial force [kN]"):
        return
    s, rows = float(tip[1]), rows_of(folder, "line.csv")
    steps = list(dict.fromkeys(row["step"] for row in rows))
    pipe = rows[0]["pipe"]
    drawn = 5e-4 * max(abs(float(row["N"]) / 1e3) for row in rows)  # what the drawing resolves, and a little more
    for text in tip[2]:
        if ": " not in text:  # of a single step, which has no name there
            text = steps[-1] + ": " + text
        step, value = text.rsplit(": ", 1)
        line = [(float(row["s"]), float(row["N"]) / 1e3) for row in rows if row["step"] == step and row["pipe"] == pipe]
        if not line:
            continue
        near = [n for at, n in line if abs(at - s) <= 0.01 * line[-1][0]]
        near += [max(line, key=lambda one: one[0] if one[0] <= s else -1)[1], min(line, key=lambda one: one[0] if one[0] >= s else 1e9)[1]]
        span = max(n for _, n in line) - min(n for _, n in line) + max(abs(n) for _, n in line)
        check(min(near) - 0.005 * span - drawn <= float(value) <= max(near) + 0.005 * span + drawn,
              f"{name}: N of {step} at s = {s} is {value}, line.csv {near}")
    browser.mouse("mousePressed", x, y, 1)
    browser.mouse("mouseMoved", x + 60, y, 1)
    browser.mouse("mouseReleased", x + 60, y)
    check(browser.evaluate("document.querySelectorAll('#forces svg [clip-path]').length") > 0, f"{name}: a drag zooms the chart")


def check_print(browser, name, pdf):
    browser.size(PAPER, 1000)
    browser.call("Emulation.setEmulatedMedia", media="print")
    cut = browser.evaluate("""[...document.querySelectorAll('table, svg, pre')].filter(e => e.getClientRects().length).flatMap(e => {
      const wrong = e.getBoundingClientRect().right > innerWidth + 1 ? ['too wide'] : [];
      for (let window = e.parentElement; window; window = window.parentElement)
        if (window.scrollHeight > window.clientHeight + 1 && getComputedStyle(window).overflowY !== 'visible' && window !== document.documentElement) wrong.push('cut');
      for (const cell of e.querySelectorAll('td, th')) if (cell.scrollWidth > cell.clientWidth + 1) wrong.push('cell ' + cell.textContent);
      return wrong.map(what => ((e.closest('section') || {}).id || 'head') + ' ' + what);
    })""")
    check(not cut, f"{name}: nothing is cut on paper: {cut[:5]}")
    hidden = browser.evaluate("[...document.querySelectorAll('.tabs > .panel')].filter(p => !p.getClientRects().length || !p.querySelector('h4').getClientRects().length).length")
    check(hidden == 0, f"{name}: on paper all tabs are shown with their names")
    data = base64.b64decode(browser.call("Page.printToPDF", preferCSSPageSize=True)["data"])
    with open(pdf, "wb") as file:
        file.write(data)
    check(data.startswith(b"%PDF") and len(data) > 20000, f"{name}: it prints")
    browser.call("Emulation.setEmulatedMedia", media="")


def check_phone(browser, name):
    browser.size(1280, 900)
    wide = browser.evaluate("document.documentElement.scrollWidth")
    check(wide <= 1280, f"{name}: no sideways scrolling on a screen ({wide} px)")
    browser.size(390, 844, mobile=True)
    wide, seen = browser.evaluate("[document.documentElement.scrollWidth, window.innerWidth]")
    check(wide <= 390 and seen <= 390, f"{name}: no sideways scrolling on a phone ({wide} px, {seen} px)")


def main():
    chromium, program, place = sys.argv[1:4]
    browser = Browser(chromium)
    try:
        for case in sys.argv[4:]:
            name, file = case.split("=")
            folder = os.path.join(place, name)
            subprocess.run([program, file, "--output-directory", folder], check=True, stdout=subprocess.DEVNULL)
            page = os.path.join(os.path.abspath(folder), "report.html")
            size = os.path.getsize(page)
            check(size <= MOST_BYTES, f"{name}: the page has {size} bytes")
            browser.size(1280, 900)
            browser.open(page)
            begin = time.time()
            has_model = browser.evaluate("document.getElementById('model-canvas') !== null")
            has_line = os.path.exists(os.path.join(folder, "line.csv")) and len(rows_of(folder, "line.csv")) > 0
            check(has_model or not has_line, f"{name}: a page of a line has a model to turn (is libjs-three installed?)")
            if has_model:
                check_model(browser, name, folder)
                check_history(browser, name, folder)
                check_play(browser, name)
                check_chart(browser, name, folder)
            check_print(browser, name, os.path.join(folder, "report.pdf"))
            check_phone(browser, name)
            check(not browser.errors, f"{name}: errors on the console: {browser.errors}")
            print(f"{name}: {size / 1e6:.2f} MB, looked at in {time.time() - begin:.1f} s")
    finally:
        browser.close()
    sys.exit(1 if failed else 0)


main()
