"""Headless Chromium on a file, for the tests of the page."""

import sys
from pathlib import Path

from report_case import need


def start(size=(1440, 1000), dark=False):
    """A driver; skips the test where Chromium does not start."""
    need("selenium", programs=("chromium", "chromedriver"))
    from selenium import webdriver
    from selenium.common.exceptions import WebDriverException
    from selenium.webdriver.chrome.service import Service
    options = webdriver.ChromeOptions()
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu",
                     "--disable-dev-shm-usage", "--hide-scrollbars",
                     f"--window-size={size[0]},{size[1]}"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    try:
        driver = webdriver.Chrome(service=Service("chromedriver"),
                                  options=options)
    except WebDriverException as error:
        print(f"skipped: Chromium does not start: {error.msg}")
        sys.exit(77)
    set_dark(driver, dark)
    return driver


def set_dark(driver, dark):
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
        {"name": "prefers-color-scheme", "value": "dark" if dark
         else "light"},
        # Scrolling at once, so that clicks meet what they aim at.
        {"name": "prefers-reduced-motion", "value": "reduce"}]})


def open_page(driver, file):
    """Loads a file and waits until the page says that it is ready."""
    from selenium.webdriver.support.ui import WebDriverWait
    driver.get(Path(file).resolve().as_uri())
    WebDriverWait(driver, 30).until(lambda d: d.execute_script(
        "return document.documentElement.dataset.ready && "
        "document.getElementById('grid').dataset.run !== undefined"))
