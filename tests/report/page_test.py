#!/usr/bin/python3
"""The results page in headless Chromium: what a reader does with it."""

import base64
import io
import shutil
import tempfile
import unittest
from pathlib import Path

import browser
from report_case import need
from synthetic import Suite, heat, scene_pixels

need("selenium", programs=("chromium", "chromedriver"))

import numpy
from PIL import Image
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select, WebDriverWait

from report import command, records

GRID = (20, 10)
RED, BLUE = "#ff0000", "#0000ff"


def make_page(folder):
    """Two scenes, three encoders; `half` is all red above blue."""
    suite = Suite(folder / "sweep", GRID)
    cells = GRID[0] * GRID[1]
    for number, scene in enumerate(("alpha", "beta")):
        pixels = scene_pixels(number, (160, 160))
        reference = suite.write_jpeg(f"reference-{scene}.jpg", pixels)
        for index, (name, glyph) in enumerate(
                [("half", "▄"), ("text", "A"), ("plain", None)]):
            pictures = None
            if glyph:
                code = f"{scene}-{name}"
                pictures = {
                    "cells": suite.write_grid(
                        f"{code}.cells.json.gz", [(glyph, BLUE, RED)] * cells),
                    "flip": suite.write_jpeg(f"{code}.flip.jpg",
                                             heat(pixels, 20)),
                    "reference": reference}
            suite.quality(scene, name, 0.1 + 0.1 * index + 0.05 * number,
                          rays=[9, 8, 10][index], pictures=pictures,
                          settings={"seed": 2})
    # Another seed, without pictures and with the same figures.
    suite.quality("alpha", "half", 0.1, rays=9, settings={"seed": 1})
    suite.quality("alpha", "half", 0.4, settings={"color": "256"})
    out = folder / "out"
    out.mkdir()
    command.write(records.load(suite.folder), out, ("html",))
    return out / "index.html"


class PageTest(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="rtbench_page_"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.file = make_page(cls.folder)
        cls.driver = browser.start()
        cls.addClassCleanup(cls.driver.quit)

    def setUp(self):
        self.driver.set_window_size(1440, 1000)
        browser.set_dark(self.driver, False)
        browser.open_page(self.driver, self.file)

    def tearDown(self):
        messages = self.driver.get_log("browser")
        self.assertEqual(messages, [])

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def rows(self):
        """[scene, encoder, FLIP, ...] of the rows that are seen."""
        return self.driver.execute_script(
            "return [...document.querySelectorAll('#table tbody tr')]"
            ".map(r => [...r.cells].map(c => c.textContent))")

    def wait(self, condition):
        WebDriverWait(self.driver, 10).until(lambda _: condition())

    def choose(self, scene, encoder):
        for button in self.driver.find_elements(By.CSS_SELECTOR, ".open"):
            row = button.find_element(By.XPATH, "./ancestor::tr")
            if row.text.split()[:2] == [scene, encoder]:
                button.click()
                name = f"{scene}·{encoder}"
                self.wait(lambda: self.find("#run-name").text == name)
                return
        self.fail(f"no row {scene} {encoder}")

    def canvas(self):
        """The canvas as an array of pixels."""
        url = self.driver.execute_script(
            "return document.getElementById('grid').toDataURL()")
        data = base64.b64decode(url.split(",")[1])
        return numpy.asarray(Image.open(io.BytesIO(data)).convert("RGB"))

    def test_no_network(self):
        text = self.file.read_text(encoding="utf-8")
        for word in ("src=\"http", "href=\"http", "url(http", "@import",
                     "fetch("):
            self.assertNotIn(word, text)
        names = self.driver.execute_script(
            "return performance.getEntriesByType('resource')"
            ".map(e => e.name).filter(n => !n.startsWith('data:'))")
        self.assertEqual(names, [])

    def test_the_best_is_shown_first(self):
        self.assertEqual(self.find("#run-name").text, "alpha·half")
        self.assertIn("0.1000", self.find("#figures").text)
        measured = self.find("#measured").text
        self.assertIn("at 40 PPD on a raster of 160 x 160", measured)
        self.assertIn("means of 2 seeds, the picture is of seed 2", measured)

    def test_headings_sort(self):
        flips = [row[2] for row in self.rows()]
        self.assertEqual(flips, sorted(flips))
        button = self.find("th[data-key=flip] button")
        button.click()
        self.assertEqual([row[2] for row in self.rows()],
                         sorted(flips, reverse=True))
        self.assertEqual(self.find("th[data-key=flip]")
                         .get_attribute("aria-sort"), "descending")
        # As figures, not as words: 8, 9, 10.
        rays = self.find("th[data-key=rays] button")
        rays.send_keys(Keys.ENTER)
        column = [float(row[4]) for row in self.rows()]
        self.assertEqual(column, sorted(column))
        self.assertEqual(column[0], 8)
        # Times are unknown here: no row is lost.
        self.find("th[data-key=ms] button").click()
        self.assertEqual(len(self.rows()), 6)

    def test_filters_filter(self):
        self.assertEqual(self.find("#count").text, "6 of 6 runs")
        Select(self.find("#scene")).select_by_visible_text("beta")
        self.assertEqual({row[0] for row in self.rows()}, {"beta"})
        Select(self.find("#encoder")).select_by_visible_text("text")
        self.assertEqual([row[:2] for row in self.rows()], [["beta", "text"]])
        self.assertEqual(self.find("#count").text, "1 of 6 runs")
        Select(self.find("#scene")).select_by_index(0)
        self.assertEqual(len(self.rows()), 2)
        Select(self.find("#encoder")).select_by_index(0)
        Select(self.find("#setting")).select_by_index(1)
        self.assertEqual([row[:3] for row in self.rows()],
                         [["alpha", "half", "0.4000"]])

    def test_the_divider_follows_the_mouse(self):
        stage = self.find("#stage")
        divider = self.find("#divider")
        width = stage.size["width"]
        ActionChains(self.driver).move_to_element(divider).click_and_hold() \
            .move_by_offset(width // 4, 0).release().perform()
        self.assertAlmostEqual(float(divider.get_attribute("aria-valuenow")),
                               75, delta=2)
        box = self.driver.execute_script(
            "return document.getElementById('divider')"
            ".getBoundingClientRect().left - document.getElementById('stage')"
            ".getBoundingClientRect().left")
        self.assertAlmostEqual(box / width, 0.75, delta=0.02)
        clip = self.driver.execute_script(
            "return getComputedStyle(document.getElementById('grid'))"
            ".clipPath")
        self.assertNotIn("50%", clip)
        # After the release it stays.
        ActionChains(self.driver).move_to_element(stage).perform()
        self.assertAlmostEqual(float(divider.get_attribute("aria-valuenow")),
                               75, delta=2)

    def test_the_divider_follows_keys(self):
        divider = self.find("#divider")
        now = lambda: int(divider.get_attribute("aria-valuenow"))
        for key, expected in [(Keys.ARROW_LEFT, 48), (Keys.ARROW_RIGHT, 50),
                              (Keys.PAGE_UP, 60), (Keys.HOME, 0),
                              (Keys.ARROW_LEFT, 0), (Keys.END, 100)]:
            divider.send_keys(key)
            self.assertEqual(now(), expected)
        self.assertEqual(divider.get_attribute("role"), "slider")
        self.assertIn("% grid", divider.get_attribute("aria-valuetext"))

    def test_tab_reaches_everything_and_shows_where(self):
        reached = set()
        for _ in range(40):
            ActionChains(self.driver).send_keys(Keys.TAB).perform()
            active = self.driver.switch_to.active_element
            reached.add(active.get_attribute("id")
                        or active.get_attribute("class")
                        or active.get_attribute("name"))
            outline = self.driver.execute_script(
                "const e = document.activeElement;"
                "const shown = e.id === 'divider' ? e.firstElementChild"
                " : e.name === 'view' ? e.nextElementSibling : e;"
                "return e === document.body ? 'body'"
                " : getComputedStyle(shown).outlineStyle")
            self.assertNotEqual(outline, "none", active.tag_name)
        for name in ("scene", "encoder", "open", "view", "divider"):
            self.assertIn(name, reached)

    def test_arrow_keys_go_through_the_runs(self):
        self.find(".open").send_keys(Keys.ARROW_DOWN)
        self.assertEqual(self.find("#run-name").text, "beta·half")
        self.driver.switch_to.active_element.send_keys(Keys.ARROW_UP)
        self.assertEqual(self.find("#run-name").text, "alpha·half")
        self.assertEqual(self.find("tr[aria-current]").text.split()[:2],
                         ["alpha", "half"])

    def test_the_grid_is_drawn(self):
        pixels = self.canvas()
        height = pixels.shape[0] // GRID[1]
        self.assertEqual(pixels[height // 4, 3].tolist(), [255, 0, 0])
        self.assertEqual(pixels[3 * height // 4, 3].tolist(), [0, 0, 255])
        self.assertEqual(pixels.shape[1] / pixels.shape[0], 1)
        # A letter covers part of its cell.
        self.choose("beta", "text")
        self.wait(lambda: (self.canvas()[:, :, 2] > 0).mean() < 0.4)
        share = (self.canvas()[:, :, 2] / 255).mean()
        self.assertTrue(0.1 < share < 0.35, share)

    def test_the_other_side_is_reference_or_flip_map(self):
        under = self.find("#under")
        reference = under.get_attribute("src")
        self.assertRegex(reference, "^data:image/(webp|jpeg);base64,")
        self.wait(lambda: self.driver.execute_script(
            "return document.getElementById('under').naturalWidth") == 160)
        self.find("input[value=flip]").send_keys(Keys.SPACE)
        self.wait(lambda: under.get_attribute("src") != reference)
        self.assertIn("FLIP map", under.get_attribute("alt"))
        self.assertTrue(self.find("#scale").is_displayed())

    def test_a_run_without_pictures_says_so(self):
        self.choose("alpha", "plain")
        self.assertIn("names no pictures", self.find("#none").text)
        self.assertFalse(self.find("#divider").is_displayed())
        self.choose("alpha", "half")
        self.assertFalse(self.find("#none").is_displayed())

    def test_the_grid_is_selectable_text(self):
        self.choose("alpha", "text")
        self.find("#text-box summary").click()
        text = self.find("#text")
        line = "A" * GRID[0] + "\n"
        self.wait(lambda: text.get_attribute("textContent")
                  == line * GRID[1])
        color = self.driver.execute_script(
            "const s = getComputedStyle(document.querySelector('#text span'));"
            "return [s.color, s.backgroundColor, s.userSelect]")
        self.assertEqual(color, ["rgb(0, 0, 255)", "rgb(255, 0, 0)", "auto"])

    def test_dark_differs(self):
        ground = "return getComputedStyle(document.body).backgroundColor"
        light = self.driver.execute_script(ground)
        browser.set_dark(self.driver, True)
        dark = self.driver.execute_script(ground)
        brightness = [sum(map(int, text[4:-1].split(",")))
                      for text in (light, dark)]
        self.assertGreater(brightness[0], 600)
        self.assertLess(brightness[1], 150)
        # The plots follow.
        ink = self.driver.execute_script(
            "return getComputedStyle(document.querySelector('figure text'))"
            ".fill")
        self.assertGreater(sum(map(int, ink[4:-1].split(","))), 600)

    def test_a_narrow_window_needs_no_sideways_scrolling(self):
        self.driver.set_window_size(520, 900)
        self.assertLessEqual(*self.driver.execute_script(
            "const e = document.documentElement;"
            "return [e.scrollWidth, e.clientWidth]"))


if __name__ == "__main__":
    unittest.main()
