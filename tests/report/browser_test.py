# SPDX-License-Identifier: MIT
"""browser_test.py [SCREENSHOTS]: the page of ./stagelight report, in headless Chromium. The results are made up here:
one check passed, one failed, and one whose golden could not be read. SCREENSHOTS is a folder to leave pictures in."""
import base64
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import time
import zlib

from selenium.webdriver import ActionChains, Keys
from selenium.webdriver.common.by import By

sys.path.append(str(pathlib.Path(__file__).parent.parent))

from browser import addresses_asked, errors, resize, start_browser  # noqa: E402

REPORT = pathlib.Path(__file__).parent / "report.py"
WIDTH, HEIGHT = 320, 192
TOLERANCE = {"interior": 0.0012, "edge_outliers": 2, "strays": 2, "mean_signed_error": 1.4e-4}
DEVICE = {"name": "a <device>", "platform": "Made up", "version": "OpenCL 3.0", "driver": "1.2"}


def write_png(file, color):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + bytes(color(x, y)[i] for x in range(WIDTH) for i in range(3)) for y in range(HEIGHT))
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 2, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def write_check(folder, scene, failure, has_golden=True):
    name = f"{scene}_on_made_up"
    pictures = {"render": lambda x, y: (200, x * 255 // WIDTH, 60)}
    check = {"scene": scene, "stage": "04_refraction_beer", "device": DEVICE, "when": "2026-11-22 12:00:00 UTC",
             "tolerance": TOLERANCE, "failure": failure, "milliseconds": 12.5}
    if has_golden:
        pictures |= {"golden": lambda x, y: (30, 90, y * 255 // HEIGHT), "difference": lambda x, y: (0, 0, x % 256),
                     "edges": lambda x, y: (255 * (x == y),) * 3, "outliers": lambda x, y: (255 * (x == 7), 90, 0)}
        check["figures"] = {"interior_outliers": 3, "interior": 0.25, "edge_outliers": 1, "strays": 0, "edge_pixels": 192,
                            "mean_signed_error": 1e-5, "rmse": 0.01, "psnr": None, "perceptual_failures": 0}
        check["worst"] = [{"x": x, "y": 100, "error": 0.25, "kind": "interior outlier", "golden": [0.5, 0.25, 0.125],
                           "render": [0.75, 0.25, 0.125]} for x in (7, 300)]
        check["histogram"] = [60000, 900, 300, 100, 80, 40, 10, 5, 2, 0, 0, 0, 3, 0, 0, 0]
    check["pictures"] = {what: f"{name}.{what}.png" for what in pictures}
    for what, color in pictures.items():
        write_png(folder / check["pictures"][what], color)
    (folder / f"{name}.json").write_text(json.dumps(check), encoding="utf-8")


def write_report(folder):
    return subprocess.run([sys.executable, REPORT, folder / "results", folder / "out"], capture_output=True, text=True,
                          check=False)


def check_order(browser):
    articles = browser.find_elements(By.CSS_SELECTOR, "article")
    states = [article.get_attribute("class") for article in articles]
    assert states == ["failed", "failed", "passed"], states
    assert "04_glass" in articles[0].text and "interior pixels" in articles[0].text, articles[0].text
    assert "expected finite numbers" in articles[1].text, articles[1].text
    assert "2 of 3 checks failed" in browser.title
    assert "Not run yet: ./stagelight mutate" in browser.find_element(By.TAG_NAME, "main").text


def check_scatter(browser):
    """A mark for each check that has figures; POV-Ray's are not there."""
    marks = browser.find_elements(By.CSS_SELECTOR, ".scatter path[class]")
    assert [mark.get_attribute("class") for mark in marks] == ["failed", "passed"], len(marks)
    assert "Not run yet: ./stagelight povray" in browser.find_element(By.TAG_NAME, "main").text


def check_slider(browser):
    article = browser.find_element(By.CSS_SELECTOR, "article")
    slider, over = article.find_element(By.CSS_SELECTOR, "input"), article.find_element(By.CSS_SELECTOR, ".over")
    browser.execute_script("arguments[0].scrollIntoView({block: 'center'})", slider)
    before = over.value_of_css_property("clip-path")
    ActionChains(browser).drag_and_drop_by_offset(slider, int(slider.size["width"] * 0.3), 0).perform()
    dragged = over.value_of_css_property("clip-path")
    assert before == "inset(0px 0px 0px 50%)" and dragged != before, (before, dragged)
    value = int(slider.get_attribute("value"))
    slider.send_keys(Keys.ARROW_LEFT)
    assert over.value_of_css_property("clip-path") == f"inset(0px 0px 0px {value - 1}%)"
    assert slider.get_attribute("aria-valuetext") == f"golden on {value - 1} %"


def check_blink(browser):
    article = browser.find_element(By.CSS_SELECTOR, "article")
    blink, over = article.find_element(By.CSS_SELECTOR, ".blink"), article.find_element(By.CSS_SELECTOR, ".over")
    assert blink.get_attribute("aria-pressed") == "false", "no page flashes unasked"
    blink.send_keys(Keys.ENTER)
    assert blink.get_attribute("aria-pressed") == "true"
    seen = set()
    end = time.monotonic() + 10
    while len(seen) < 2 and time.monotonic() < end:
        seen.add(over.value_of_css_property("clip-path"))
    assert seen == {"inset(0px)", "inset(0px 0px 0px 100%)"} or seen == {"inset(0px 0px 0px 0%)", "inset(0px 0px 0px 100%)"}, seen
    blink.send_keys(Keys.SPACE)
    assert blink.get_attribute("aria-pressed") == "false"


def check_zoom(browser):
    article = browser.find_element(By.CSS_SELECTOR, "article")
    crop = article.find_element(By.CSS_SELECTOR, ".crop")
    before = crop.value_of_css_property("background-position")
    article.find_elements(By.CSS_SELECTOR, ".place")[1].send_keys(Keys.ENTER)
    assert crop.get_attribute("aria-label") == "Golden around (300, 100)"
    assert crop.value_of_css_property("background-position") == "-3528px -1128px" != before


def check_images(browser):
    images = browser.find_elements(By.TAG_NAME, "img")
    assert len(images) == 7 + 1 + 7, len(images)
    for image in images:
        assert image.get_property("naturalWidth") > 0, image.get_attribute("src")
        assert image.get_attribute("alt"), image.get_attribute("src")


def check_structure(browser):
    for landmark in ("header", "nav[aria-label]", "main", "footer", "html[lang]"):
        assert len(browser.find_elements(By.CSS_SELECTOR, landmark)) == 1, landmark
    unnamed = browser.execute_script("""return [...document.querySelectorAll(
        'input, button, svg, [role=img], [role=region]')].filter(e => !(e.labels && e.labels.length
        || e.getAttribute('aria-label') || e.textContent.trim())).map(e => e.outerHTML)""")
    assert not unnamed, unnamed
    browser.refresh()  # the focus is at the top again
    order = []
    for _ in range(20):
        browser.switch_to.active_element.send_keys(Keys.TAB)
        focused = browser.switch_to.active_element
        order.append(focused.get_attribute("id") or focused.get_attribute("class") or focused.tag_name)
        assert focused.value_of_css_property("outline-style") != "none", order
    assert order == (["skip"] + ["a"] * 6 + ["summary", "slide-Stage04_glass_on_made_up", "blink", "wide", "wide", "place", "place",
                                       "summary", "wide"] + ["a"] * 3 + ["summary"]), order


def check_looks(browser, screenshots):
    """At both widths and in both schemes; nothing is wider than the page."""
    backgrounds = set()
    for width in (1440, 390):
        for scheme in ("light", "dark"):
            resize(browser, width, scheme)
            found = browser.execute_script("return [document.documentElement.scrollWidth, innerWidth]")
            assert found[0] <= found[1] == width, found
            backgrounds.add(browser.find_element(By.TAG_NAME, "body").value_of_css_property("background-color"))
            if screenshots:
                data = browser.execute_cdp_cmd("Page.captureScreenshot", {"captureBeyondViewport": True})["data"]
                (screenshots / f"{width}_{scheme}.png").write_bytes(base64.b64decode(data))
    assert len(backgrounds) == 2, backgrounds


def check_requests(browser):
    asked = addresses_asked(browser)
    assert any(url.endswith("index.html") for url in asked), asked
    strangers = [url for url in asked if not url.startswith(("file:", "data:"))]
    assert not strangers, strangers
    said = errors(browser)
    assert not said, said


def main():
    screenshots = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else None
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        os.environ["HOME"] = scratch
        empty = write_report(folder)
        assert empty.returncode == 1 and "nothing was run yet: ./stagelight test" in empty.stderr, empty
        assert not (folder / "out").exists()
        (folder / "results").mkdir()
        write_check(folder / "results", "01_sound", "")
        write_check(folder / "results", "04_glass", "3 interior pixels differ by more than 0.0012")
        write_check(folder / "results", "05_nan", "golden/05.exr: expected finite numbers, found a NaN", has_golden=False)
        written = write_report(folder)
        assert written.returncode == 0, written
        browser = start_browser(folder / "profile")
        try:
            resize(browser, 1440, "light")
            browser.get((folder / "out" / "report" / "index.html").as_uri())
            for check in (check_order, check_scatter, check_slider, check_blink, check_zoom, check_images, check_structure):
                check(browser)
            check_looks(browser, screenshots)
            check_requests(browser)
        finally:
            browser.quit()


main()
