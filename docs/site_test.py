# SPDX-License-Identifier: MIT
"""site_test.py SITE SCREENSHOTS: every page of the built site in headless Chromium: no error on the console, no
address asked but its own, nothing wider than the page, no finding of axe-core; search, sliders and chart respond."""
import base64
import functools
import http.server
import os
import sys
import tempfile
import threading
from pathlib import Path

from selenium.webdriver import ActionChains, Keys
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

DOCS = Path(__file__).resolve().parent
sys.path.append(str(DOCS.parent / "tests"))

from browser import addresses_asked, errors, resize, start_browser  # noqa: E402

AXE = (DOCS / "node_modules/axe-core/axe.min.js").read_text()
LOOKED_AT = ["index.html", "start.html", "chapters/03_reflection_glossy.html", "chapters/09_tree.html", "chart.html",
             "stability/index.html"]
WIDTHS = (1440, 390)


class Site:
    def __init__(self, folder, browser, address):
        self.browser, self.address = browser, address
        self.pages = sorted(str(file.relative_to(folder)) for file in folder.rglob("*.html")
                            if file.name != "404.html" and "generated" not in file.parts)

    def open(self, page):
        self.browser.get(self.address + page)
        # Before the scripts have taken over, nothing responds.
        self.wait(lambda b: b.execute_script("return document.querySelector('#app')?.__vue_app__ !== undefined"))

    def wait(self, condition):
        return WebDriverWait(self.browser, 20).until(condition)

    def find(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)


def findings(browser, where):
    """Of axe-core: WCAG 2.1 A and AA, and its best practices for landmarks and headings."""
    browser.execute_script(AXE)
    found = browser.execute_async_script("""
        const done = arguments[arguments.length - 1];
        axe.run(document, {runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'best-practice'], iframes: false})
          .then(r => done(r.violations.map(v => [v.id, v.help, v.nodes.slice(0, 3).map(n => n.target.join(' '))])))""")
    return [f"{where}: axe-core: {name}: {text}: {'; '.join(targets)}" for name, text, targets in found]


def go_dark(browser, dark):
    """At once: colours that are on their way have any contrast."""
    browser.execute_script("""document.head.append(Object.assign(document.createElement('style'),
        {textContent: '*, ::before, ::after { transition: none !important }'}));
        document.documentElement.classList.toggle('dark', arguments[0])""", dark)


def check_page(site, page):
    wrong = []
    resize(site.browser, WIDTHS[0], "light")
    site.open(page)
    wrong += findings(site.browser, f"{page}, light")
    broken = site.browser.execute_script("""document.querySelectorAll('img').forEach(i => i.loading = 'eager');
        return Promise.all([...document.images].map(i => i.decode().then(() => '', () => i.src))).then(a => a.filter(s => s))""")
    wrong += [f"{page}: no picture at {image}" for image in broken]
    unnamed = site.browser.execute_script("return [...document.images].filter(i => !i.alt).map(i => i.src)")
    wrong += [f"{page}: a picture without words: {image}" for image in unnamed]
    go_dark(site.browser, True)
    wrong += findings(site.browser, f"{page}, dark")
    for width in WIDTHS:
        resize(site.browser, width, "light")
        found = site.browser.execute_script("return document.documentElement.scrollWidth")
        if found > width:
            wrong.append(f"{page}: {found} pixels wide at {width}")
    return wrong


def check_search(site):
    resize(site.browser, WIDTHS[0], "light")
    site.open("index.html")
    site.find("#local-search button, .DocSearch-Button").click()
    site.wait(lambda b: site.find("input#localsearch-input")).send_keys("Beer")
    site.wait(lambda b: any("04_refraction_beer" in a.get_attribute("href")
                            for a in b.find_elements(By.CSS_SELECTOR, "a.result")))


def check_slider(site):
    site.open("chapters/03_reflection_glossy.html")
    figure = site.wait(lambda b: site.find(".compare"))
    slider, over = (figure.find_element(By.CSS_SELECTOR, selector) for selector in ("input", ".compare-over"))
    site.browser.execute_script("arguments[0].scrollIntoView({block: 'center'})", slider)
    before = over.value_of_css_property("clip-path")
    slider.send_keys(Keys.ARROW_RIGHT)
    pressed = over.value_of_css_property("clip-path")
    ActionChains(site.browser).drag_and_drop_by_offset(slider, int(slider.size["width"] * 0.3), 0).perform()
    dragged = over.value_of_css_property("clip-path")
    assert len({before, pressed, dragged}) == 3, (before, pressed, dragged)


def check_chart(site):
    site.open("chart.html")
    site.browser.switch_to.frame(site.wait(lambda b: site.find("iframe.chart")))
    rows = site.wait(lambda b: b.find_elements(By.CSS_SELECTOR, "#table tbody tr"))
    seen = set()
    for row in rows[:2]:
        site.browser.execute_script("arguments[0].focus()", row)
        seen.add(site.find("#seen img").get_attribute("src"))
        site.wait(lambda b: site.find("#seen img").get_property("naturalWidth") > 0)
    assert len(seen) == 2, seen
    drawn = site.browser.execute_script("""const c = document.getElementById('chart');
        return new Set(c.getContext('2d').getImageData(0, 0, c.width, c.height).data).size""")
    assert drawn > 20, "the chart is empty"
    site.browser.switch_to.default_content()


def take_screenshots(site, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for page in LOOKED_AT:
        for width in WIDTHS:
            for scheme in ("light", "dark"):
                resize(site.browser, width, scheme)
                site.open(page)
                go_dark(site.browser, scheme == "dark")
                size = site.browser.execute_script("return document.documentElement.scrollHeight")
                data = site.browser.execute_cdp_cmd("Page.captureScreenshot", {
                    "captureBeyondViewport": True,
                    "clip": {"x": 0, "y": 0, "width": width, "height": min(size, 6000), "scale": 1}})["data"]
                name = page.removesuffix(".html").replace("/", "_")
                (folder / f"{name}_{width}_{scheme}.png").write_bytes(base64.b64decode(data))


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *arguments):
        pass


def main():
    folder, screenshots = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_port}/"
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch:
        os.environ["HOME"] = scratch
        browser = start_browser(scratch)
        try:
            site = Site(folder, browser, address)
            wrong = []
            for page in site.pages:
                wrong += check_page(site, page)
            for check in (check_search, check_slider, check_chart):
                check(site)
            take_screenshots(site, screenshots)
            asked = addresses_asked(browser)
            wrong += [f"asks an address outside: {url}" for url in sorted(set(asked))
                      if not url.startswith((address, "data:", "blob:"))]
            wrong += [f"the console says: {entry['message']}" for entry in errors(browser)]
        finally:
            browser.quit()
    assert len(asked) > len(site.pages), asked
    print(*wrong, sep="\n", file=sys.stderr, end="\n" if wrong else "")
    print(f"site: {len(site.pages)} pages, {len(wrong)} findings")
    sys.exit(1 if wrong else 0)


main()
