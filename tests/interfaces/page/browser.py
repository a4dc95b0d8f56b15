# SPDX-License-Identifier: GPL-3.0-or-later
"""Chromium without a network, and the pages that the program writes."""

import base64
import functools
import json
import os
import subprocess
import tempfile
import time
import unittest

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
STICKSLIP = os.environ["STICKSLIP"]
STICKSLIP_CHECK = os.environ["STICKSLIP_CHECK"]
PICTURES = os.environ["PAGE_PICTURES"]  # for people to look at
FIG1 = os.path.join(ROOT, "paper_examples", "grasps", "fig1.json")
PATIENCE = 120  # seconds until what has to come is missed; nothing here measures time


def example(name):
    return os.path.join(ROOT, "examples", "grasps", name + ".json")


def in_file(folder, grasp):
    """The path of a grasp file with this content."""
    path = os.path.join(folder, "grasp.json")
    with open(path, "w", encoding="utf-8") as file:
        json.dump(grasp, file)
    return path


def cube():
    """A cube with its body, held at two sides."""
    vertices = [[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    return {"format": "stickslip-grasp/2", "body": {"vertices": vertices, "faces": faces},
            "defaults": {"friction": "1/2", "preload": 4},
            "contacts": [{"position": [-1, 0, 0], "normal": [1, 0, 0]}, {"position": [1, 0, 0], "normal": [-1, 0, 0]}],
            "wrench": [0, 0, -1, 0, 0, 0]}


def run(*arguments, **more):
    return subprocess.run([STICKSLIP, *arguments], check=True, capture_output=True, text=True, **more).stdout


@functools.lru_cache(maxsize=None)
def page_of(grasp, content, options):
    """The page of a grasp file with this content: many tests open the same, and its map takes seconds."""
    return run("page", grasp, *options, encoding="utf-8")


def decide(grasp, *options):
    return json.loads(run("decide", grasp, "--json", *options))


@functools.lru_cache(maxsize=None)
def browser():
    """The browser of all tests of this process, and the folder of what it downloads."""
    folder = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(folder.cleanup)
    options = Options()
    options.binary_location = os.environ["CHROMIUM"]
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars",
                     "--disable-gpu", "--enable-unsafe-swiftshader",
                     "--window-size=1280,900",
                     "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1", "--disable-background-networking"):
        options.add_argument(argument)
    options.add_experimental_option("prefs", {"download.default_directory": folder.name})
    options.add_experimental_option("perfLoggingPrefs", {"enableNetwork": True, "enablePage": False})
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    driver = webdriver.Chrome(options=options, service=Service(os.environ["CHROMEDRIVER"]))
    unittest.addModuleCleanup(driver.quit)
    return driver, folder.name


class PageTest(unittest.TestCase):
    """Pages in a browser of which no request but for the page itself leaves, and which has nothing to complain of."""

    @classmethod
    def setUpClass(cls):
        cls.driver, cls.downloads = browser()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.allowed = []  # beginnings of addresses
        self.set_size(1280, 900)
        self.set_media()

    def set_size(self, width, height):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})

    def set_media(self, **features):
        """Who does not say what motion is liked sees none: animations in software take all of a core."""
        features.setdefault("prefers_reduced_motion", "reduce")
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {
            "features": [{"name": name.replace("_", "-"), "value": value} for name, value in features.items()]})

    def open(self, grasp, *options):
        """Writes the page of a grasp file, and opens it. Returns its answer."""
        path = os.path.join(self.folder, "page.html")
        with open(grasp, "rb") as file:
            content = file.read()
        with open(path, "w", encoding="utf-8") as file:
            file.write(page_of(grasp, content, options))
        self.size = os.path.getsize(path)
        self.go("file://" + path)
        return self.js("return StickslipPage.answer")

    def go(self, address):
        self.allowed.append(address.split("#")[0])
        self.driver.get(address)
        self.wait(lambda: self.js("return document.body.dataset.ready") == "yes", "the page is ready")

    def js(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def wait(self, is_so, what):
        end, pause = time.monotonic() + PATIENCE, 0.01
        while not is_so():
            self.assertLess(time.monotonic(), end, "waited for: " + what)
            time.sleep(pause)  # longer and longer: asking takes time from who is asked
            pause = min(1.5 * pause, 0.2)

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def text(self, selector):
        """As it is in the document, whether or not it is in view."""
        return self.js("return document.querySelector(arguments[0]).textContent", selector)

    def press(self, *keys):
        ActionChains(self.driver).send_keys(*keys).perform()

    def attributes(self, selector, name):
        """Of all elements, in one call."""
        return self.js("return [...document.querySelectorAll(arguments[0])].map((e) => e.getAttribute(arguments[1]))",
                       selector, name)

    def point_at(self, element, x, y):
        """Places are from the middle of the element."""
        self.js("arguments[0].scrollIntoView({ block: 'center' })", element)
        return ActionChains(self.driver, duration=20).move_to_element_with_offset(element, x, y)

    def drag(self, element, x, y, steps=5):
        actions = self.point_at(element, 0, 0).click_and_hold()
        for _ in range(steps):
            actions.move_by_offset(x / steps, y / steps)
        actions.release().perform()

    def picture(self, name):
        """The whole page, as a build output."""
        os.makedirs(PICTURES, exist_ok=True)
        size = self.driver.execute_cdp_cmd("Page.getLayoutMetrics", {})["cssContentSize"]
        shot = self.driver.execute_cdp_cmd("Page.captureScreenshot", {
            "captureBeyondViewport": True, "optimizeForSpeed": True,
            "clip": {"x": 0, "y": 0, "width": size["width"], "height": size["height"], "scale": 1}})
        with open(os.path.join(PICTURES, name + ".png"), "wb") as file:
            file.write(base64.b64decode(shot["data"]))

    def fits(self):
        """Nothing is wider than the window."""
        self.assertLessEqual(self.js("return document.documentElement.scrollWidth"), self.js("return window.innerWidth"))

    def check_proof(self):
        self.find("#check").click()
        self.wait(lambda: self.js("return document.getElementById('proof-result').dataset.answer"), "the checker's answer")
        return self.js("return document.getElementById('proof-result').dataset.answer")

    def tearDown(self):
        self.js("try { localStorage.clear() } catch (error) {}")
        self.driver.get("about:blank")
        said, sent = self.driver.get_log("browser"), self.driver.get_log("performance")
        for entry in said:
            self.assertNotIn(entry["level"], ("SEVERE", "ERROR"), entry)
        requests = 0
        for entry in sent:
            message = json.loads(entry["message"])["message"]
            if message["method"] != "Network.requestWillBeSent":
                continue
            address = message["params"]["request"]["url"]
            self.assertTrue(address.startswith(("data:", "blob:", *self.allowed)), address)
            requests += 1
        self.assertGreater(requests, 0, "requests are seen")
