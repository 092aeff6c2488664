# SPDX-License-Identifier: BSD-3-Clause
"""Opens a report in a browser and uses it as a reader would: check_report.py PAGE TRACKS_CSV

Prints a line a check; ends with 1 where one fails, with 77 where there is no browser.
"""
import csv
import sys

import chromium

# Pixels of a canvas that something is drawn on.
INK = """(id => { const c = document.getElementById(id);
  const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
  let n = 0; for (let i = 3; i < d.length; i += 4) n += d[i] > 0; return n; })"""


class Reader:
    def __init__(self, page, rows):
        self.page = page
        self.rows = rows

    def state(self, name):
        return self.page.js("report.state.%s" % name)

    def text(self, selector):
        return self.page.js("document.querySelector('%s')?.textContent ?? ''" % selector)

    def loads(self):
        self.page.wait("window.report !== undefined")
        ids = {row["track_id"] for row in self.rows if row["status"] in ("confirmed", "coasting")}
        shown = len({row["time_s"] for row in self.rows})
        assert self.page.js("report.run.count") == shown, "frames"
        assert "%d objects" % len(ids) in self.text("#subtitle"), self.text("#subtitle")
        assert self.page.js("report.run.tracksAt(report.state.frame).length") > 0
        self.page.press("Home")
        self.page.wait("report.views.store.ready.has(0)")

    def steps_and_seeks(self):
        self.page.press(".")
        assert self.state("frame") == 1
        self.page.press(",")
        assert self.state("frame") == 0
        self.page.press("End")
        assert self.state("frame") == self.page.js("report.run.count") - 1
        self.page.js("{ const s = document.getElementById('seek'); s.value = 5;"
                     "  s.dispatchEvent(new Event('input')); }")
        assert self.state("frame") == 5
        assert "frame 5" in self.text("#clock"), self.text("#clock")

    def draws_each_frame(self):
        self.page.wait("report.views.store.ready.has(5)")
        self.page.wait("%s('map') > 5000" % INK)

    def plays(self):
        self.page.press("Home")
        # So slowly that a busy machine looks before the end is reached.
        self.page.js("report.state.set({speed: 0.25})")
        self.page.press(" ")
        self.page.wait("report.state.frame >= 3 && report.state.playing")
        self.page.press(" ")
        assert not self.state("playing")
        self.page.js("report.state.set({speed: 10})")
        self.page.press(" ")
        self.page.wait("!report.state.playing")
        assert self.state("frame") == self.page.js("report.run.count") - 1, "plays to the end"

    def jumps_over_pauses(self):
        self.page.js("{ const run = report.run; run.kept = run.times;"
                     "  run.times = run.times.map((t, k) => t + (k > 9 ? 3000 : 0));"
                     "  report.state.seek(7); report.state.set({speed: 1, playing: true}); }")
        self.page.wait("report.state.frame >= 12")
        self.page.js("report.state.set({playing: false}); report.run.times = report.run.kept")

    def picks_a_track(self):
        """By a click on its box; the panel shows the numbers of the table."""
        self.page.js("report.state.seek(8); report.state.set({follow: 'sensor'})")
        self.page.wait("!report.views.dirty")
        track, x, y = self.page.js("""(() => {
            const {state, views, run} = report;
            const sensor = run.sensorAt(state.frame);
            const {track, i} = run.tracksAt(state.frame).sort((a, b) =>
                Math.hypot(a.track.x[a.i] - sensor[0], a.track.y[a.i] - sensor[1]) -
                Math.hypot(b.track.x[b.i] - sensor[0], b.track.y[b.i] - sensor[1]))[0];
            const box = views.map.canvas.getBoundingClientRect();
            const at = views.map.camera.toScreen(track.x[i], track.y[i]);
            return [track.id, box.left + at[0], box.top + at[1]]; })()""")
        self.page.click(x, y)
        assert self.state("track") == track, "picked %s, not %s" % (self.state("track"), track)
        assert "Track #%d" % track in self.text("#details h2")
        times = sorted({float(row["time_s"]) for row in self.rows})
        row = next(r for r in self.rows
                   if int(r["track_id"]) == track and abs(float(r["time_s"]) - times[8]) < 1e-5)
        facts = self.text("#details .facts")
        for number in ("speed_mps", "length_m", "width_m"):
            # The page holds millimetres: a half of the last place may go either way.
            shown = ("%.2f" % (float(row[number]) + d) for d in (-0.0006, 0.0, 0.0006))
            assert any(text in facts for text in shown), (number, row[number], facts)
        assert row["status"] in facts and row["points"] in facts, facts

    def shows_history_and_close_up(self):
        assert self.page.js("document.querySelectorAll('.chart').length") >= 7
        assert self.page.js("%s('closeup')" % INK) > 500
        assert self.page.js("[...document.querySelectorAll('.chart path')].every("
                            "p => !p.getAttribute('d').includes('NaN'))")
        before = self.state("frame")
        x, y = self.page.js("""(() => { const c = document.querySelector('.chart');
            c.scrollIntoView(); const b = c.getBoundingClientRect();
            return [b.left + 0.95 * b.width, b.top + b.height / 2]; })()""")
        self.page.click(x, y)
        assert self.state("frame") != before, "a click on a chart goes there"

    def names_charts_in_full(self):
        wide = self.page.js("[...document.querySelectorAll('.chart')]"
                            ".map((c) => [c.querySelector('text'), c.viewBox.baseVal.width])"
                            ".filter(([t, w]) => t.getBBox().x + t.getBBox().width > w)"
                            ".map(([t]) => t.textContent)")
        assert wide == [], wide

    def has_no_negative_zero(self):
        assert self.page.js("shortNumber(-0.004)") == "0.00"
        assert self.page.js("kColumns.find((c) => c.name === 'm/s').text(-0.04)") == "0.0"
        facts = self.page.js("""(() => {
            const {state, run} = report, track = run.byId.get(state.track);
            const i = track.at(state.frame), speed = track.speed[i];
            track.speed[i] = -0.004;
            const facts = factsOf(state, track);
            track.speed[i] = speed;
            return facts; })()""")
        assert "0.00 ±" in facts and "-0.00" not in facts, facts

    def counts_tracks(self):
        """By the pairs and the table, not by the page's own sums."""
        labelled = set(self.page.js(
            "report.run.truth.matches.flatMap((m) => m.pairs.map((p) => p[1]))"))
        published = {int(row["track_id"]) for row in self.rows
                     if row["status"] in ("confirmed", "coasting")}
        last = {int(row["track_id"]): row["vehicle_probability"] for row in self.rows}
        held = {track for track in published - labelled
                if last[track] and round(float(last[track]), 3) >= 0.5}
        assert labelled and held
        words = "%d objects were tracked, %d of them on labelled vehicles, %d others held" % (
            len(published), len(labelled), len(held))
        assert words in self.text("#tracks p"), (words, self.text("#tracks p"))

    def lists_tracks(self):
        self.page.js("document.querySelector('#tracks .row').click()")
        chosen = self.page.js("Number(document.querySelector('#tracks .row').dataset.id)")
        assert self.state("track") == chosen
        self.page.press("Escape")
        assert self.state("track") is None
        assert self.page.js("document.getElementById('details').hidden")

    def goes_to_mistakes(self):
        count = self.page.js("report.run.truth.mistakes.length")
        assert self.page.js("document.querySelectorAll('.mistake').length") == count
        self.page.press("n")
        first = self.page.js("document.querySelector('.mistake.selected').textContent")
        assert self.state("track") is not None or self.state("object") is not None
        self.page.press("n")
        assert self.page.js("document.querySelector('.mistake.selected').textContent") != first \
            or count == 1

    def turns_to_3d(self):
        self.page.press("2")
        self.page.wait("!report.views.dirty")
        if not self.page.js("report.views.space.works"):
            assert not self.page.js("document.getElementById('note').hidden"), "says why not"
            print("      without WebGL")
        else:
            colours = self.page.js("""(() => { const gl = report.views.space.gl;
                report.views.draw();
                const w = gl.drawingBufferWidth, h = gl.drawingBufferHeight;
                const d = new Uint8Array(4 * w * h);
                gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, d);
                const all = new Set(); for (let i = 0; i < d.length; i += 4)
                    all.add(d[i] << 16 | d[i + 1] << 8 | d[i + 2]); return all.size; })()""")
            assert colours > 10, colours
        self.page.press("1")
        assert self.state("view") == "above"

    def changes_theme(self):
        background = "getComputedStyle(document.body).backgroundColor"
        before = self.page.js(background)
        self.page.press("d")
        assert self.page.js(background) != before
        self.page.press("d")
        assert self.page.js(background) == before

    def helps(self):
        self.page.press("?")
        assert self.page.js("document.getElementById('help').open")
        self.page.js("document.getElementById('help').close()")

    def keeps_its_place_in_the_address(self):
        self.page.js("report.state.seek(7); report.state.selectTrack(report.run.tracks[0].id)")
        words = self.page.js("location.hash")
        assert "track=%d" % self.page.js("report.run.tracks[0].id") in words, words
        self.page.js("report.state.seek(0); location.hash = '%s&view=3d'" % words.lstrip("#"))
        self.page.wait("report.state.frame === 7 && report.state.view === '3d'")

    def is_quiet(self):
        assert self.page.console == [], self.page.console


CHECKS = [Reader.loads, Reader.steps_and_seeks, Reader.draws_each_frame, Reader.plays,
          Reader.jumps_over_pauses, Reader.picks_a_track, Reader.shows_history_and_close_up,
          Reader.names_charts_in_full, Reader.has_no_negative_zero, Reader.counts_tracks, Reader.lists_tracks,
          Reader.goes_to_mistakes, Reader.turns_to_3d, Reader.changes_theme, Reader.helps,
          Reader.keeps_its_place_in_the_address, Reader.is_quiet]


def main(page_path, table_path):
    if chromium.find() is None:
        print("no chromium")
        return 77
    with open(table_path, newline="") as file:
        rows = list(csv.DictReader(file))
    failed = 0
    page = chromium.Page("file://" + page_path, dark=True)
    try:
        reader = Reader(page, rows)
        for check in CHECKS:
            try:
                check(reader)
                print("ok    " + check.__name__)
            except (AssertionError, RuntimeError, TimeoutError) as error:
                failed += 1
                print("FAIL  %s: %r" % (check.__name__, error))
    finally:
        page.close()
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
