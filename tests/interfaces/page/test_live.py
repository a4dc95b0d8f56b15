# SPDX-License-Identifier: GPL-3.0-or-later
"""The live page: what is dragged and typed is asked of `stickslip serve`, and shown."""

import json
import os
import re
import subprocess
import unittest
from fractions import Fraction

from browser import FIG1, STICKSLIP, STICKSLIP_CHECK, Keys, PageTest, cube, decide, example, in_file


class Live(PageTest):
    def serve(self, grasp, limit=0.25):
        """Verdicts take milliseconds; what takes longer than the limit, as maps do, is given up. Answers draw handles anew: the
        page rests before a test takes one."""
        server = subprocess.Popen([STICKSLIP, "serve", grasp, "--time-limit", str(limit)], stdout=subprocess.PIPE, text=True)
        self.addCleanup(server.stdout.close)
        self.addCleanup(server.wait)
        self.addCleanup(server.terminate)
        address = re.match(r"(http://127\.0\.0\.1:\d+/)", server.stdout.readline()).group(1)
        self.go(address)
        self.rest()
        return address

    def rest(self):
        """Until nothing is asked any more, and all parts are those of one grasp."""
        self.wait(lambda: self.js("return !document.body.classList.contains('busy') && !document.querySelector('.panel.stale')"),
                  "an answer")

    def grasp_file(self):
        path = os.path.join(self.folder, "live.json")
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.js("return StickslipPage.grasp.text()"))
        return path

    def agrees(self, *options):
        """The page says what `stickslip decide` says of the grasp file that the page gives away, and has a proof of it."""
        self.rest()
        path = self.grasp_file()
        verdict = decide(path, *options)["verdict"]
        self.assertEqual(self.js("return document.getElementById('verdict').dataset.verdict"), verdict)
        if verdict in ("stable", "unstable"):
            proof = os.path.join(self.folder, "live.certificate.json")
            with open(proof, "w", encoding="utf-8") as file:
                file.write(self.js("return StickslipPage.answer.certificate"))
            checked = subprocess.run([STICKSLIP_CHECK, path, proof, *options], capture_output=True, text=True, check=False)
            self.assertEqual(checked.stdout.split("\n")[0], "accepted", checked.stderr)
        return verdict

    def handle(self, name):
        return self.find(f'[data-handle="{name}"]')

    def test_the_load_is_dragged(self):
        self.serve(FIG1)
        self.assertEqual(self.agrees(), "stable")
        self.drag(self.handle("load"), 0, -30)
        self.assertEqual(self.agrees(), "unstable")
        wrench = [float(Fraction(w)) for w in json.loads(self.js("return StickslipPage.grasp.text()"))["wrench"]]
        self.assertGreater(wrench[1], 1)
        self.assertEqual(self.js("return StickslipPage.answer.wrench"), wrench)
        self.picture("live-unstable")
        self.drag(self.handle("load"), 40, 100)
        self.assertEqual(self.agrees(), "stable")

    def test_a_contact_is_dragged_along_the_outline(self):
        self.serve(example("bracket"))
        self.agrees()
        self.drag(self.handle("contact-1"), -60, 25)
        self.agrees()
        contact = self.js("return StickslipPage.answer.contacts[1]")
        self.assertEqual(contact["position"][1], 0, "it stays on the outline")
        self.assertLess(contact["position"][0], 34)
        self.assertEqual(contact["normal"], [0, 1])
        # Round the corner, on the left side.
        self.drag(self.handle("contact-0"), -60, -120)
        self.agrees()
        contact = self.js("return StickslipPage.answer.contacts[0]")
        self.assertEqual(contact["position"][0], 0)
        self.assertEqual(contact["normal"], [1, 0])
        self.picture("live-outline")

    def test_contacts_and_normals_without_an_outline(self):
        self.serve(FIG1)
        self.drag(self.handle("contact-1"), 40, -20)
        self.agrees()
        x, y = self.js("return StickslipPage.answer.contacts[1].position")
        self.assertGreater(x, 0)
        self.assertGreater(y, -1)
        self.assertEqual((x, y), (round(x, 2), round(y, 2)), "short decimals")
        self.drag(self.handle("normal-1"), 30, 10)
        self.agrees()
        n = [float(Fraction(c)) for c in json.loads(self.js("return StickslipPage.grasp.text()"))["contacts"][1]["normal"]]
        self.assertAlmostEqual((n[0] ** 2 + n[1] ** 2) ** 0.5 % 1, 0, places=9, msg="of rational length")
        self.assertGreater(n[0], 0)

    def test_with_the_keyboard(self):
        self.serve(FIG1)
        self.js("arguments[0].focus()", self.handle("contact-0"))
        before = self.js("return StickslipPage.answer.contacts[0].position")
        for _ in range(3):
            self.press(Keys.ARROW_UP)
            self.rest()
            self.assertEqual(self.js("return document.activeElement.dataset.handle"), "contact-0", "the focus stays")
        self.agrees()
        self.assertGreater(self.js("return StickslipPage.answer.contacts[0].position")[1], before[1])

    def test_numbers(self):
        self.serve(FIG1)
        friction = self.find("#live-friction")
        friction.clear()
        friction.send_keys("0.4")
        self.assertEqual(self.agrees(), "unstable")
        self.assertEqual(json.loads(self.js("return StickslipPage.grasp.text()"))["contacts"][2]["friction"], "2/5")
        self.js("arguments[0].value = '1'; arguments[0].dispatchEvent(new Event('input'))", self.find("#live-friction-range"))
        self.assertEqual(self.agrees(), "stable")
        load = self.find("#live-load-1")
        load.clear()
        load.send_keys("7/3", Keys.TAB)
        self.assertEqual(self.agrees(), "unstable")
        self.assertEqual(self.js("return StickslipPage.answer.decide.wrench[1]"), "7/3")

    def test_a_range(self):
        self.serve(FIG1)
        self.js("""const list = document.getElementById('live-uncertain-friction');
                   list.value = '10%'; list.dispatchEvent(new Event('change'))""")
        self.assertEqual(self.agrees("--uncertain", "friction=10%"), "fragile")
        self.picture("live-fragile")
        load = self.find("#live-load-1")
        load.clear()
        load.send_keys("0.5", Keys.TAB)
        self.assertEqual(self.agrees("--uncertain", "friction=10%"), "stable")
        self.assertEqual(self.check_proof(), "accepted")

    def test_the_link_has_the_grasp(self):
        address = self.serve(FIG1)
        self.drag(self.handle("load"), 20, -40)
        self.rest()
        text = self.js("return StickslipPage.grasp.text()")
        link = self.js("return location.href")
        self.assertTrue(link.startswith(address + "#"))
        self.driver.get("about:blank")
        self.allowed.append("about:blank")
        self.go(link)
        self.rest()
        self.assertEqual(self.js("return StickslipPage.grasp.text()"), text)
        self.agrees()

    def test_a_link_to_a_grasp_in_space(self):
        self.serve(example("space-cup"))
        self.find("#live-load-0").send_keys(Keys.HOME, "1", Keys.TAB)
        self.agrees()
        link = self.js("return location.hash")
        address = self.serve(FIG1)
        self.go(address + "?" + link)
        self.rest()
        self.assertEqual(self.js("return StickslipPage.answer.dimension"), 6)
        self.assertFalse(self.find("#body").is_displayed())
        self.assertTrue(self.find("#space-canvas").is_displayed())
        self.assertEqual(self.js("return document.getElementById('live-load-0').value"), "10")
        self.agrees()

    def test_what_cannot_be_asked_is_said(self):
        self.serve(FIG1)
        self.rest()  # an answer that is under way brings its own grasp
        self.js("StickslipPage.grasp.set(0, 'stiffness', '-1');")
        load = self.find("#live-load-0")
        load.clear()
        load.send_keys("1", Keys.TAB)
        self.wait(lambda: "stiffness" in self.text("#live-error"), "the error")
        self.driver.get_log("browser")  # the browser notes the status 400

    def test_in_space(self):
        self.serve(example("space-cup"))
        self.agrees()
        load = self.find("#live-load-2")
        load.clear()
        load.send_keys("-5", Keys.TAB)
        self.assertEqual(self.agrees(), "unstable")
        self.picture("live-space")


    def contact(self, i):
        return self.js("return StickslipPage.answer.contacts[arguments[0]]", i)

    def pixel(self, x, y, z):
        """From the middle of the canvas."""
        return self.js("""const view = StickslipPage.bodyView(), at = view.place([...arguments]);
                          return [at[0] - view.size[0] / 2, at[1] - view.size[1] / 2]""", x, y, z)

    def test_a_contact_is_dragged_over_a_body_in_space(self):
        self.serve(in_file(self.folder, cube()))
        self.assertEqual(self.agrees(), "stable")
        # From one side of the cube to the top.
        start, end = self.pixel(1, 0, 0), self.pixel(0.25, 0.5, 1)
        by = [5 * round((b - a) / 5) for a, b in zip(start, end)]
        self.drag(self.handle("contact-1"), *by)
        self.assertEqual(self.agrees(), "unstable")
        contact = self.contact(1)
        self.assertEqual((contact["position"][2], contact["normal"]), (1, [0, 0, -1]))
        for found, a, b in zip(self.pixel(*contact["position"]), start, by):
            self.assertAlmostEqual(found, a + b, delta=2)
        file = json.loads(self.js("return StickslipPage.grasp.whole()"))
        self.assertEqual([float(Fraction(x)) for x in file["contacts"][1]["position"]], contact["position"])
        self.assertEqual(file["body"], cube()["body"])
        self.assertNotIn("body", json.loads(self.js("return StickslipPage.grasp.text()")))
        self.picture("live-space-body")
        # With the keyboard it stays on its face, also where that is not seen.
        self.js("arguments[0].focus()", self.handle("contact-0"))
        self.press(Keys.ARROW_UP)
        self.rest()
        self.assertEqual(self.js("return document.activeElement.dataset.handle"), "contact-0", "the focus stays")
        hidden = self.contact(0)
        self.assertEqual((hidden["position"][0], hidden["normal"]), (-1, [1, 0, 0]))
        self.assertGreater(hidden["position"][2], 0)
        self.agrees()
        # A link has the contacts; the body is that of the page.
        self.go(self.js("return location.href"))
        self.rest()
        self.assertEqual(self.contact(1)["position"], contact["position"])
        self.assertEqual(json.loads(self.js("return StickslipPage.grasp.whole()"))["body"], cube()["body"])

    def test_the_load_in_space_is_dragged_at_both_ends(self):
        self.serve(in_file(self.folder, cube()))
        self.rest()
        # Upwards on the page is upwards, but for the height of the eye.
        self.drag(self.handle("load"), 0, -25)
        self.rest()
        before = self.js("return StickslipPage.answer.wrench")
        self.assertGreater(before[2], -1)
        self.assertEqual(before[3:], [0, 0, 0], "it acts where it acted")
        self.drag(self.handle("load-point"), 50, 0)
        self.agrees()
        force, torque = (lambda w: (w[:3], w[3:]))(self.js("return StickslipPage.answer.wrench"))
        self.assertEqual(force, before[:3])
        x, y, z = self.js("return StickslipPage.loadPoint()")
        self.assertGreater(max(abs(x), abs(y)), 0.1)
        fx, fy, fz = force
        for found, wanted in zip(torque, (y * fz - z * fy, z * fx - x * fz, x * fy - y * fx)):
            self.assertAlmostEqual(found, wanted, places=12)

    def test_the_load_is_dragged_in_the_region_in_space(self):
        self.serve(in_file(self.folder, {**cube(), "wrench": ["1/3", 0, -1, 0, 0, "1/7"]}), limit=5)
        self.rest()
        self.wait(lambda: self.all('[data-handle="region-load"]'), "the region")
        self.drag(self.handle("region-load"), 0, -25)
        self.agrees()
        before, wrench = ([float(Fraction(w)) for w in ("1/3", 0, -1, 0, 0, "1/7")],
                          self.js("return StickslipPage.answer.wrench"))
        self.assertGreater(wrench[2], -1)
        self.assertAlmostEqual(wrench[0], before[0], delta=0.2)
        self.assertEqual(wrench[1], 0)
        self.assertEqual(wrench[3:5], [0, 0])
        self.assertAlmostEqual(wrench[5], before[5], places=12)

    def test_a_contact_is_dragged_over_the_hull(self):
        grasp = cube()
        del grasp["body"]
        self.serve(in_file(self.folder, grasp))
        self.rest()
        self.assertIn("sketched", self.text("#body-legend"))
        before = self.contact(1)
        self.drag(self.handle("contact-1"), -20, 0)
        self.rest()
        after = self.contact(1)
        self.assertNotEqual(after["position"], before["position"])
        self.assertAlmostEqual(sum(x * x for x in after["normal"]), 1, places=5)

    def test_several_bodies(self):
        self.serve(example("bodies-stack"))
        self.rest()
        self.assertEqual(self.all("[data-handle]"), [], "nothing is dragged")
        self.assertIn("nothing is dragged", self.text("#live"))
        # Friction 1/2 holds 5 on the upper box, and 1/4 does not hold 4.
        self.js("const list = arguments[0]; list.value = 'pushed above'; list.dispatchEvent(new Event('change'))",
                self.find("#live-case"))
        self.assertEqual(self.agrees("--case", "pushed above"), "stable")
        friction = self.find("#live-friction")
        friction.clear()
        friction.send_keys("0.25")
        self.assertEqual(self.agrees("--case", "pushed above"), "unstable")
        load = self.find("#live-load-3")  # up.x
        load.clear()
        load.send_keys("2", Keys.TAB)
        self.assertEqual(self.agrees(), "stable")
        self.assertEqual(self.check_proof(), "accepted")
        self.picture("live-bodies")

    def test_a_late_verdict_is_announced_and_replaced(self):
        self.serve(in_file(self.folder, cube()))
        self.rest()
        # Requests go nowhere until the test lets them.
        self.js("""window.real = window.fetch;
            window.held = [];
            window.fetch = (url, request) => new Promise((done, fail) => {
              window.held.push(() => real(url, request).then(done, fail));
              request.signal.addEventListener('abort', () => fail(new DOMException('', 'AbortError')));
            });""")
        set_friction = """const field = document.getElementById('live-friction');
                          field.value = arguments[0]; field.dispatchEvent(new Event('input'))"""
        self.js(set_friction, "0.01")
        self.wait(lambda: self.find("#deciding").is_displayed(), "the word")
        self.assertEqual(self.text("#deciding"), "deciding \u2026")
        self.js(set_friction, "0.4")
        self.wait(lambda: self.js("return window.held.length") == 2, "the first is given up")
        # The older answer comes last, and to nobody.
        self.js("window.fetch = window.real; window.held[1](); window.held[0]();")
        self.wait(lambda: not self.find("#deciding").is_displayed(), "the verdict")
        self.assertEqual(self.js("return StickslipPage.answer.contacts.map((c) => c.friction)"), [0.4, 0.4])
        self.driver.get_log("browser")


if __name__ == "__main__":
    unittest.main()
