# SPDX-License-Identifier: GPL-3.0-or-later
"""Grasps that people brought, in doubles with all their digits; under sanitizers as well, which run no other everyday grasps."""

import json
import os
import unittest

from test_cli import read
from test_everyday import FILES, Everyday


class Files(Everyday):
    """Grasps that were brought, each with what is known of it."""

    EXPECTED = {"at_rest_rounding": "stable", "cylinder_too_heavy": "unstable", "round_disc": "unstable", "tol": "stable",
                "soft_rot0_8": "unstable", "soft_rot1_8": "unstable", "soft_rot2_8": "unstable"}
    CASES = {"cyl": {"light": "stable", "heavy": "unstable", "offcentre": "stable", "offcentre side": "stable"},
             "three_fingers_metres": {"light": "stable", "heavy": "unstable", "push": "stable", "twist": "stable"},
             "vise": {"up 1190": "stable", "up 1210": "unstable", "down 1e6": "stable", "side 5000": "stable", "side 50000": "stable"}}

    def test_answers(self):
        self.assertEqual({name[:-len(".json")] for name in os.listdir(FILES)}, {*self.EXPECTED, *self.CASES})
        for name, verdict in self.EXPECTED.items():
            self.assertEqual(self.plain_verdict(self.content(name)), verdict, name)
        for name, cases in self.CASES.items():
            # The case "exact" of two of them is on the threshold, but for rounding.
            self.assertEqual({case["name"] for case in self.content(name)["cases"]} - {"exact"}, set(cases))
            for case, verdict in cases.items():
                self.assertEqual(self.plain_verdict(self.content(name), "--case", case), verdict, (name, case))

    @staticmethod
    def content(name):
        return json.loads(read(os.path.join(FILES, name + ".json")))


if __name__ == "__main__":
    unittest.main()
