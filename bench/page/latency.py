# SPDX-License-Identifier: GPL-3.0-or-later
"""From a drag to its verdict: asks `stickslip serve` about a contact and a load that move, over HTTP.

    python3 bench/page/latency.py build/bin/stickslip
"""

import http.client
import json
import statistics
import subprocess
import sys
import time
from fractions import Fraction

CONTACTS = 10
QUESTIONS = 200
KINDS = (("verdict", {"parts": ["decide"], "options": {"warnings": False}}),
         ("verdict, warnings", {"parts": ["decide"]}),
         ("verdict, sphere, margin", {"parts": ["decide", "states", "margin"], "options": {"warnings": False}}),
         ("all but the map", {"parts": ["decide", "states", "margin", "region"]}))


def moved(step):
    """Preloaded contacts on half of an ellipse; one of them and the load are dragged."""
    contacts = []
    for i in range(CONTACTS):
        t = Fraction(i - CONTACTS // 2, CONTACTS // 2 + 1)
        c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
        contacts.append({"position": [round(float(2 * c), 3), round(float(1.5 * s), 3)],
                         "normal": [str(-c), str(-s)]})
    x, y = contacts[3]["position"]
    contacts[3]["position"] = [round(x - step / 500, 3), round(y + step / 300, 3)]
    return {"format": "stickslip-grasp/1", "defaults": {"friction": 0.3, "preload": 1}, "contacts": contacts,
            "wrench": [round(8 - step / 20, 2), round(step / 100, 2), round(step / 50, 2)]}


def main(program):
    with subprocess.Popen([program, "serve"], stdout=subprocess.PIPE, text=True) as server:
        port = int(server.stdout.readline().split(":")[2].split("/")[0])
        for kind, rest in KINDS:
            seconds, verdicts = [], []
            for step in range(0, QUESTIONS, 1 if len(rest["parts"]) < 4 else 10):
                question = json.dumps({"grasp": json.dumps(moved(step)), **rest})
                start = time.perf_counter()
                connection = http.client.HTTPConnection("127.0.0.1", port)
                connection.request("POST", "/answer", question, {"Content-Type": "application/json"})
                answer = json.loads(connection.getresponse().read())
                seconds.append(time.perf_counter() - start)
                connection.close()
                verdicts.append(answer["decide"]["verdict"])
            seconds.sort()
            middle, most = statistics.median(seconds), seconds[len(seconds) * 95 // 100]
            print(f"{kind:24} {1e3 * middle:7.1f} ms, 95 %: {1e3 * most:7.1f} ms; "
                  f"{verdicts.count('stable')} of {len(verdicts)} stable")
        server.terminate()


if __name__ == "__main__":
    main(sys.argv[1])
