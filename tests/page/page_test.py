#!/usr/bin/env python3
"""report.html in headless Chromium: what a reader does is done, and what is seen is measured. Pictures of it are kept in a folder
for those who want to look. usage: page_test.py VALIDATE [PICTURES_FOLDER]   (77: there is no Chromium)"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from browser import Browser, find_browser

VALIDATE = str(pathlib.Path(sys.argv[1]).resolve())
HOSTILE = "</script><script>document.title='broken in'</script><b>&quot;"
MEMBRANE = ["--E", "1.0209 TPa", "--thickness", "0.335 nm", "--nu", "0.165", "--pretension", "0.34 N/m", "--tip-radius", "16.5 nm"]
MEASURE = (pathlib.Path(__file__).parent / "measure.js").read_text() + "0"  # a value that can be returned


def run(folder, *words):
    code = subprocess.run([VALIDATE, *words], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    assert code.returncode in (0, 3), code.stderr


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="validate-page-")
        folder = pathlib.Path(cls.folder.name)
        cls.pictures = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else folder / "pictures"
        cls.pictures.mkdir(parents=True, exist_ok=True)
        run(folder, "indentation", "--models", "membrane", "--radius", "0.5 um", *MEMBRANE, "--loads", "point,disc", "--depth-step",
            "20 nm", "--out", "run", "--quiet")
        run(folder, "bulge", "--cells", "8", "--out", "bulge", "--quiet")
        run(folder, "indentation", "--potential", "tersoff", "--radius", "20", "--loads", "disc", "--tip-radius", "5", "--out", "atoms",
            "--quiet")
        curve = folder / (HOSTILE.replace("/", "") + ".csv")
        curve.write_text("depth_nm,force_nN\n" + "".join(f"{d},{0.25 * d + 3e-4 * d**3}\n" for d in range(2, 80, 2)))
        run(folder, "fit", curve.name, "--radius", "0.5 um", "--nu", "0.165", "--out", "fit")
        run(folder, "report", "fit")
        cls.browser = Browser(find_browser())
        cls.addClassCleanup(cls.folder.cleanup)
        cls.addClassCleanup(cls.browser.__exit__)

    def open(self, name, width=1100, scheme="light", scale=1):
        b = self.browser
        b.size(width, 900, scale)
        b.colours(scheme)
        b.open(pathlib.Path(self.folder.name) / name / "report.html")
        b.run(MEASURE)
        return b

    def quiet(self):
        """Nothing went wrong, and nothing but the page itself was asked for."""
        b = self.browser
        for event in b.events:
            self.assertNotEqual(event["method"], "Runtime.exceptionThrown", event)
            if event["method"] == "Log.entryAdded":
                self.assertNotEqual(event["params"]["entry"]["level"], "error", event)
            if event["method"] == "Network.requestWillBeSent":
                self.assertRegex(event["params"]["request"]["url"], "^(file|data):")

    def place(self, selector):
        return self.browser.run(f"place({selector!r})")

    def test_verdict_and_figure_come_first(self):
        b = self.open("run")
        order = b.run("[...document.querySelectorAll('.verdict, figure, table')].map(e => e.localName)")
        self.assertEqual(order[:3], ["p", "figure", "table"])
        b.picture(self.pictures / "top.png")
        self.quiet()

    def test_values_are_under_the_pointer(self):
        b = self.open("run")
        x, y = b.run("curve_point('Eq. 16, given constants', 0.7)")
        b.mouse("mouseMoved", x, y)
        b.settle()
        words = b.run("document.querySelector('.tip').innerText").split("\n")
        self.assertEqual(words[0], "Eq. 16, given constants")
        self.assertEqual([words[1].split()[i] for i in (0, 2)] + [words[2].split()[i] for i in (0, 2)], ["depth", "nm", "force", "nN"])
        depth, force = [1e-9 * float(words[i].split()[1]) for i in (1, 2)]
        eh, pretension, nu, a = 1.0209e12 * 0.335e-9, 0.34, 0.165, 0.5e-6  # SI
        expected = pretension * 3.141592653589793 * depth + eh * (1.05 - 0.15 * nu - 0.16 * nu**2) ** -3 * depth**3 / a**2
        self.assertAlmostEqual(force / expected, 1, delta=1e-3)
        b.picture(self.pictures / "pointer.png")

    def test_keys_go_through_the_points(self):
        b = self.open("run")
        b.run("document.querySelector('.panels svg').focus()")
        seen = []
        for key in ("ArrowRight", "ArrowRight", "ArrowDown", "Escape"):
            b.key(key)
            seen.append(b.run("document.querySelector('.tip').innerText"))
        self.assertEqual(seen[0].split("\n")[0], seen[1].split("\n")[0])
        self.assertNotEqual(seen[0], seen[1])
        self.assertNotEqual(seen[1].split("\n")[0], seen[2].split("\n")[0])
        self.assertEqual(seen[3], "")

    def test_legend_entries_switch_curves(self):
        b = self.open("run")
        name = b.run("document.querySelector('.legend button').textContent")
        shown = "[...document.querySelector('.panels').querySelectorAll('[data-name]')].filter(e => e.getBoundingClientRect().width > 0)"
        count, all_others = (f"{shown}.filter(e => (e.dataset.name === {name!r}) === {own}).length" for own in ("true", "false"))
        before, others = b.run(count), b.run(all_others)
        self.assertGreater(before, 0)
        b.click(*self.place(".legend button"))
        self.assertEqual(b.run("document.querySelector('.legend button').getAttribute('aria-pressed')"), "false")
        self.assertEqual((b.run(count), b.run(all_others)), (0, others))
        b.key("Enter")
        self.assertEqual(b.run(count), before)

    def test_tables_sort(self):
        b = self.open("run")
        b.run("document.querySelectorAll('details').forEach(d => d.open = true)")
        read = "[...document.querySelector('details table').tBodies[0].rows].map(r => Number(r.cells[1].innerText))"
        before = b.run(read)
        for expected in (sorted(before), sorted(before, reverse=True), before):
            b.run("document.querySelector('details table th:nth-child(2) button').scrollIntoView({block: 'center'})")
            b.click(*self.place("details table th:nth-child(2) button"))
            self.assertEqual(b.run(read), expected)
        self.assertGreater(len(before), 3)

    def test_colours_follow_the_system_and_the_switch(self):
        paper = "getComputedStyle(document.body).backgroundColor"
        b = self.open("run", scheme="light")
        light = b.run(paper)
        b.colours("dark")
        dark = b.run(paper)
        self.assertNotEqual(light, dark)
        b.click(*self.place(".theme"))
        self.assertEqual(b.run(paper), light)
        b.click(*self.place(".theme"))
        b.colours("light")
        self.assertEqual(b.run(paper), dark)
        b.run("localStorage.clear()")

    def test_text_can_be_read_and_things_have_names(self):
        for name, scheme, width in (("run", "light", 1100), ("run", "dark", 390), ("bulge", "dark", 1100), ("bulge", "light", 390),
                                    ("fit", "dark", 1100)):
            with self.subTest(name=name, scheme=scheme, width=width):
                b = self.open(name, width, scheme)
                b.run("document.querySelectorAll('details').forEach(d => d.open = true)")
                b.run("document.querySelector('[data-sheets]')?.scrollIntoView()")
                b.settle()
                for fault in ("low_contrast", "without_names", "small_targets", "bad_structure"):
                    self.assertEqual(b.run(f"{fault}()"), [], fault)
                self.quiet()

    def test_a_telephone_shows_all(self):
        for name in ("run", "bulge", "fit"):
            with self.subTest(name=name):
                b = self.open(name, 390, scale=2)
                self.assertLessEqual(b.run("document.documentElement.scrollWidth"), 390)
                self.assertGreaterEqual(b.run("smallest_letters()"), 11)
                self.assertEqual(b.run("overlapping_letters()"), [])
                b.picture(self.pictures / f"telephone-{name}.png")

    def test_the_sheet_is_turned_and_pressed(self):
        b = self.open("bulge")
        b.run("document.querySelector('[data-sheets]').scrollIntoView()")
        b.run("until(() => document.querySelector('.view canvas')?.dataset.milliseconds)")
        shape = "drawn_pixels(document.querySelector('.view canvas'))"
        start = b.run(shape)
        self.assertGreater(start["count"], 5000)
        x, y = self.place(".view canvas")
        b.mouse("mouseMoved", x, y)
        b.mouse("mousePressed", x, y, 1)
        b.mouse("mouseMoved", x, y + 60, 1)
        b.mouse("mouseReleased", x, y + 60)
        b.settle()
        b.settle()
        self.assertGreater(b.run(shape)["height"], 1.1 * start["height"], "seen more from above")
        b.picture(self.pictures / "sheet.png")
        b.run("document.querySelector('.controls button:nth-of-type(2)').click()")
        b.settle()
        b.settle()
        deep = b.run(shape)["height"]
        b.run("document.querySelector('.depth input').focus()")
        for _ in range(4):
            b.key("ArrowLeft")
        b.settle()
        self.assertLess(b.run(shape)["height"], 0.95 * deep, "flatter where it is pressed less")
        self.assertRegex(b.run("document.querySelector('.depth input').getAttribute('aria-valuetext')"), r"^[\d.]+ Å$")
        self.quiet()

    def sheets(self, name):
        """The page with its sheets in sight, and what the run's document says."""
        b = self.open(name)
        b.run("document.querySelector('[data-sheets]').scrollIntoView()")
        b.run("until(() => document.querySelector('.view:last-child > canvas')?.dataset.milliseconds)")
        self.assertGreater(b.run("document.querySelector('.view').getBoundingClientRect().top"), 0, "the page has not jumped past it")
        return b, json.loads((pathlib.Path(self.folder.name) / name / "summary.json").read_text())

    def said(self, view):
        return self.browser.run(f"document.querySelectorAll('.view .said')[{view}].innerText")

    def test_atoms_are_where_they_were(self):
        b, summary = self.sheets("atoms")
        atoms = next(r for r in summary["runs"] if r["model"] == "atomistic")
        depths = int(b.run("document.querySelector('.depth input').max")) + 1
        self.assertEqual(depths, len(atoms["depth_A"]) + 1, "and the flat sheet")
        for back, bond in enumerate(reversed(atoms["longest_bond_A"])):
            told = float(re.match(r"longest bond ([\d.]+) Å", self.said(0))[1])
            self.assertAlmostEqual(told, bond, delta=0.006, msg="positions are rounded to 0.004 Å")
            self.assertAlmostEqual(float(b.run("document.querySelector('.depth output').innerText").split()[0]),
                                   atoms["depth_A"][-1 - back], delta=5e-4 * atoms["depth_A"][-1 - back])
            b.run("document.querySelector('.depth input').focus()")
            b.key("ArrowLeft")
        b.run("document.querySelector('.depth input').value = 99; document.querySelector('.depth input').dispatchEvent(new Event('input'))")
        b.run("document.querySelector('.controls button:nth-of-type(1)').click()")
        b.settle()
        x, y = self.place(".view canvas")
        for up in range(0, 30, 3):  # from the middle of a hexagon to one of its atoms
            b.mouse("mouseMoved", x, y - up)
            b.settle()
            if self.said(0).startswith("atom"):
                break
        self.assertRegex(self.said(0), r"^atom \d+: longest bond [\d.]+ Å, height −[\d.]+ Å$")
        b.picture(self.pictures / "atoms.png")
        self.quiet()

    def test_forces_of_the_membrane_are_the_run_s(self):
        b, summary = self.sheets("bulge")
        expected = summary["runs"][0]["stress_1_max_eV_per_A3"][-1] * summary["case"]["membrane"]["thickness_A"] * 16.021766
        told = float(re.match(r"larger principal force up to ([\d.]+) N/m", self.said(0))[1])
        self.assertAlmostEqual(told / expected, 1, delta=0.006, msg="three digits of 255 steps")

    def test_names_of_files_are_no_markup(self):
        b = self.open("fit")
        self.assertNotIn("broken in", b.run("document.title"))
        self.assertIn("<script>document.title", b.run("document.body.innerText"))
        self.assertEqual(b.run("document.querySelectorAll('script').length"), 2)
        self.quiet()

    def test_nothing_is_lost_without_javascript(self):
        b = self.browser
        b.scripts(False)
        try:
            b.open_without_scripts(pathlib.Path(self.folder.name) / "run" / "report.html")
            b.scripts(True)  # to measure; the page's own has not run
            b.run(MEASURE)
            self.assertEqual(b.run("document.querySelectorAll('.live, .theme, th button').length"), 1, "the caption's span alone")
            self.assertTrue(b.run("[...document.querySelectorAll('figure svg, figure img')].every(e => e.getBoundingClientRect().width > 300)"))
            b.picture(self.pictures / "without-javascript.png")
        finally:
            b.scripts(True)

    def test_paper_shows_the_drawn_figures_in_light_colours(self):
        b = self.open("run", scheme="dark")
        b.colours("dark", "print")
        self.assertEqual(b.run("getComputedStyle(document.body).backgroundColor"), "rgb(255, 255, 255)")
        self.assertTrue(b.run("[...document.querySelectorAll('.live')].every(e => e.getBoundingClientRect().width === 0)"))
        self.assertTrue(b.run("[...document.querySelectorAll('figure .static')].every(e => e.getBoundingClientRect().height > 100)"))
        self.assertEqual(b.run("low_contrast()"), [])


if __name__ == "__main__":
    if not find_browser():
        print("skipped: no Chromium here (Debian's package chromium; ./bootstrap.sh --ci installs it)")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0]])
