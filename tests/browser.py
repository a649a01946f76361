# SPDX-License-Identifier: MIT
"""Headless Chromium, for tests of pages."""
import json

from selenium import webdriver
from selenium.webdriver.chrome.service import Service


def start_browser(profile, *more):
    """`more` are arguments of Chromium."""
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu",
                     "--disable-background-networking", f"--user-data-dir={profile}", "--window-size=1440,900", *more):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"performance": "ALL", "browser": "ALL"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


def resize(browser, width, scheme):
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                            {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False})
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia",
                            {"features": [{"name": "prefers-color-scheme", "value": scheme}]})


def addresses_asked(browser):
    """Since they were asked for last. Not those of Chromium's own page of a new tab."""
    requests = [message["params"] for entry in browser.get_log("performance")
                for message in [json.loads(entry["message"])["message"]] if message["method"] == "Network.requestWillBeSent"]
    return [request["request"]["url"] for request in requests if not request["documentURL"].startswith("chrome:")]


def errors(browser):
    """What the console has said since it was asked last."""
    return [entry for entry in browser.get_log("browser") if entry["level"] == "SEVERE"]
