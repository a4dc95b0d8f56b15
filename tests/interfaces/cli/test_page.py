# SPDX-License-Identifier: GPL-3.0-or-later
"""The page as a file and live: what is on it is what the other commands say, it loads nothing, and the server answers
its own page alone and survives everything else."""

import concurrent.futures
import functools
import http.client
import json
import os
import re
import signal
import socket
import subprocess
import threading
import unittest

from test_cli import BAD_INPUT, CHECK, CORPUS, DONE, FIG1, HERE, STICKSLIP, UP, Case, read, run, stickslip

EXAMPLES = os.path.join(HERE, "..", "..", "..", "examples", "grasps")
SPACE = os.path.join(EXAMPLES, "space-book.json")
MEGABYTE = 1 << 20
CASES = {"format": "stickslip-grasp/2", "name": "shelf", "defaults": {"friction": "1/2"},
         "contacts": [{"position": [0, 0], "normal": [0, 1]}, {"position": [4, 0], "normal": [0, 1]}],
         "loads": [{"weight": 10, "at": [2, 1]}],
         "cases": [{"name": "at rest", "loads": []}, {"name": "lifted", "loads": [{"force": [0, 11], "at": [2, 1]}]}]}


def ring(contacts):
    """Preloaded contacts all round a body, with normals of length 1."""
    all_round = []
    for i in range(contacts):
        n, d = i - contacts // 2, contacts // 2 + 1
        c, s = d * d - n * n, 2 * n * d  # over d^2 + n^2
        side = 1 if i % 2 else -1
        all_round.append({"position": [f"{side * 2 * c}/{d * d + n * n}", f"{side * s}/{d * d + n * n}"],
                          "normal": [f"{-side * c}/{d * d + n * n}", f"{-side * s}/{d * d + n * n}"]})
    return {"format": "stickslip-grasp/1", "name": f"</script> & ring of {contacts}",
            "defaults": {"friction": "1/3", "preload": "1.7"}, "contacts": all_round, "wrench": ["1/7", -0.4, 0.05]}


@functools.lru_cache(maxsize=None)
def whole_page(*words):
    """What the command gives. Its map takes seconds, and more than one test reads the same."""
    return stickslip("page", *words, "--time-limit", "0")


def answer_in(html):
    found = re.findall(r'<script type="application/json" id="answer">(.*?)</script>', html, re.S)
    assert len(found) == 1
    return json.loads(found[0])


class Page(Case):
    def page(self, *words, stdin=None):
        code, out, err = stickslip("page", *words, stdin=stdin)
        self.assertEqual((code, err), (DONE, ""))
        return out

    def whole_page(self, *words):
        code, out, err = whole_page(*words)
        self.assertEqual((code, err), (DONE, ""))
        return out

    def test_answers_are_those_of_the_commands(self):
        for words in ((FIG1,), (FIG1, *UP, "--preload", "0", "--normal-law", "bilateral")):
            answer = answer_in(self.whole_page(*words))
            self.assertEqual((answer["format"], answer["live"], answer["dimension"], answer["messages"]),
                             ("stickslip-page/1", False, 3, []))
            self.assertEqual(answer["decide"], self.json("decide", *words, "--floats"))
            load = ",".join(answer["decide"]["wrench"])
            others = [word for word in words if word not in UP]  # no load
            self.assertEqual(answer["region"], self.json("region", *others, "--floats"))
            expected = self.json("margin", *others, "--direction", load, "--floats", "--no-warnings")
            self.assertEqual(answer["margin"], expected)
            self.assertEqual(answer["map"], self.json("map", *words, "--x", "friction=0:2", "--y", "load=0:2",
                                                      "--depth", "4", "--floats"))
            self.assertEqual(answer["compare"], self.json("compare", *words, "--floats"))
            grasp, proof = self.write("g.json", answer["grasp"]), self.write("p.json", answer["certificate"])
            code, out, err = run(CHECK, grasp, proof, *words[1:])
            self.assertEqual((code, err), (DONE, ""))
            self.assertIn(answer["decide"]["verdict"], out)
            question = {"wrench": None, "case": None, "preload": None, "normal_law": "unilateral", "uncertain": None}
            for option, value in zip(words[1::2], words[2::2]):
                question[option[2:].replace("-", "_")] = value
            self.assertEqual(answer["question"], question)

    def test_it_is_one_file_that_loads_nothing(self):
        for name, grasp in (("ring", ring(20)), ("space", json.loads(read(SPACE))), ("cases", CASES)):
            output = self.path(name + ".html")
            self.assertEqual(stickslip("page", self.write("grasp.json", grasp), "--time-limit", "5", "-o", output), (DONE, "", ""))
            html = read(output)
            self.assertLess(len(html.encode()), MEGABYTE)
            # What stands in the answer is no markup.
            answer = answer_in(html)
            self.assertEqual(answer["name"], grasp["name"])
            self.assertNotIn("<", re.search(r'id="answer">(.*?)</script>', html, re.S)[1])
            self.assertEqual(re.findall(r"<!-- (?:include|answer).*?-->", html), [])
            markup = re.sub(r"(?s)<(script|style)\b[^>]*>.*?</\1>", "", html)
            for attribute in re.findall(r"""\s(?:src|href|action|data|poster|srcset)\s*=\s*["']?([^"'\s>]*)""", markup):
                self.assertTrue(attribute.startswith(("data:", "#")), attribute)
            self.assertNotRegex(html, r"(?i)@import|<script[^>]*\ssrc|<link[^>]*stylesheet")
            for address in re.findall(r"""url\(([^)]*)\)""", html):
                self.assertTrue(address.strip("\"' ").startswith(("#", "data:")), address)

    def test_in_space(self):
        answer = answer_in(self.page(SPACE, "--case", "held off centre", "--time-limit", "0"))
        self.assertEqual(answer["decide"], self.json("decide", SPACE, "--case", "held off centre", "--floats"))
        self.assertEqual((answer["dimension"], answer["states"], answer["map"]), (6, None, None))
        self.assertEqual(len(answer["margin"]["direction"]), 6)
        # The torque of the load is too much whatever the force.
        self.assertEqual(answer["region"]["plane"]["origin"], ["0", "0", "0", "-28", "0", "0"])
        self.assertEqual([cell["verdict"] for cell in answer["region"]["cells"]], ["unstable"])
        self.assertEqual(len(answer["messages"]), 2)

    def test_an_equilibrium_to_draw_where_the_proof_has_none(self):
        grasp = {"format": "stickslip-grasp/1", "defaults": {"friction": "1/2", "preload": 1},
                 "contacts": [{"position": [-1, -1], "normal": [1, 1]}, {"position": [1, 1], "normal": [-1, -1]}],
                 "wrench": [0, 0, 0.1]}
        answer = answer_in(self.page("-", stdin=json.dumps(grasp)))
        self.assertEqual((answer["decide"]["verdict"], answer["decide"]["enclosed"]), ("stable", [0, 1]))
        self.assertNotIn("box", answer["decide"])
        total = [0, 0, 0.1]
        for contact, near in zip(answer["contacts"], answer["near"]["contacts"]):
            (x, y), (fx, fy) = contact["position"], near["force_float"]
            total = [a + b for a, b in zip(total, (fx, fy, x * fy - y * fx))]
        self.assertLess(max(map(abs, total)), 1e-6)
        # Friction holds a torque of the square root of 2, which is 14.1 times the load.
        [(low, high)] = answer["margin"]["resisted_float"]
        self.assertEqual(low, 0)
        self.assertTrue(14.1 < high < 14.1422, high)
        # What is about one grasp is left out, and it is said why.
        self.assertEqual([answer[part] for part in ("region", "map", "compare")], [None] * 3)
        self.assertEqual({message.split(":")[0] for message in answer["messages"]}, {"region", "map", "compare"})

    def test_several_bodies(self):
        grasp = os.path.join(EXAMPLES, "bodies-gripper.json")
        answer = answer_in(self.page(grasp, "--time-limit", "2"))
        self.assertEqual(answer["decide"], self.json("decide", grasp, "--floats"))
        self.assertEqual((answer["dimension"], answer["states"], answer["region"], answer["map"]), (3, None, None, None))
        said = [message for message in answer["messages"] if "several bodies" in message]
        self.assertEqual([message.split(":")[0] for message in said], ["states", "region", "map", "quality", "compare"])
        self.assertIsNone(answer["compare"])
        proof = self.write("p.json", answer["certificate"])
        self.assertEqual(run(CHECK, self.write("g.json", answer["grasp"]), proof)[0], DONE)
        bodies = answer["mechanism"]["bodies"]
        self.assertEqual([body["name"] for body in bodies], ["disc", "l1", "l2", "r1", "r2"])
        self.assertEqual([(c["of"], c["by"]) for c in answer["contacts"]], [(0, 2), (0, 4), (0, 1), (0, 3)])
        # A fingertip turns with its own joint about its hinge, and with the joint before it about that one's.
        z = dict(zip(answer["mechanism"]["coordinates"], answer["decide"]["twist_float"]))
        x, y = 0.3, 0.7
        moved = [0.0, 0.0]
        for turn, (hx, hy) in ((z["r1"], (2, -2)), (z["r2"], (1.2, 0))):
            moved[0] -= turn * (y - hy)
            moved[1] += turn * (x - hx)
        dx, dy, r = (sum(j * q for j, q in zip(row, answer["decide"]["twist_float"])) for row in bodies[4]["motion"])
        self.assertAlmostEqual(dx - r * y, moved[0], places=12)
        self.assertAlmostEqual(dy + r * x, moved[1], places=12)

    def test_a_box_of_several_bodies(self):
        grasp = os.path.join(EXAMPLES, "bodies-gripper.json")
        answer = answer_in(self.page(grasp, "--uncertain", "friction=5%,stiffness=5%,wrench=1%", "--time-limit", "2"))
        self.assertEqual((answer["decide"]["verdict"], answer["decide"]["box"], answer["margin"]), ("stable", True, None))
        # Of the grasp in the middle: the disc is in balance, and what slips has all the friction that there is.
        forces = [near["force_float"] for near in answer["near"]["contacts"]]
        total = [0, -1, 0]
        for contact, (fx, fy) in zip(answer["contacts"], forces):
            x, y = contact["position"]
            total = [a + b for a, b in zip(total, (fx, fy, x * fy - y * fx))]
            nx, ny = contact["normal"]
            self.assertAlmostEqual(abs(ny * fx - nx * fy), contact["friction"] * (nx * fx + ny * fy), places=6)
        self.assertLess(max(map(abs, total)), 1e-6)

    def test_bodies_in_space_are_there_once(self):
        cube = {"vertices": [[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (0, 2)],
                "faces": [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]}
        grasp = {"format": "stickslip-grasp/3", "bodies": [{"name": "low", "mesh": cube}, {"name": "up"}],
                 "defaults": {"friction": "1/2"},
                 "contacts": [{"of": of, "by": by, "position": [x, y, z], "normal": [0, 0, 1]}
                              for of, by, z in (("low", "ground", 0), ("up", "low", 2))
                              for x, y in ((-1, -1), (1, -1), (0, 1))],
                 "loads": [{"body": "low", "weight": 1, "at": [0, 0, 1]}, {"body": "up", "weight": 1, "at": [0, 0, 3]},
                           {"body": "up", "wrench": [{"min": "1/8", "max": 1}, 0, 0, 0, "1/4", 0]}]}
        answer = answer_in(self.page("-", "--time-limit", "5", stdin=json.dumps(grasp)))
        self.assertEqual((answer["dimension"], answer["decide"]["verdict"]), (6, "fragile"))
        text = json.dumps(answer)
        self.assertEqual(json.loads(answer["grasp"])["bodies"][0]["mesh"], cube)
        self.assertEqual(text.count("vertices"), 1)
        for verdict in ("stable", "unstable"):
            self.assertEqual(answer["examples"][verdict]["decide"]["verdict"], verdict)

    def test_the_margin_of_several_bodies(self):
        grasp = os.path.join(EXAMPLES, "bodies-stack.json")
        answer = answer_in(self.page(grasp, "--wrench", "0,0,0,1,-1,-3/2", "--time-limit", "0"))
        expected = self.json("margin", grasp, "--direction", "0,0,0,1,-1,-3/2", "--floats", "--no-warnings")
        self.assertEqual({key: answer["margin"][key] for key in ("resisted", "refuted")},
                         {key: expected[key] for key in ("resisted", "refuted")})

    def test_cases(self):
        grasp = self.write("cases.json", CASES)
        quick = ("--time-limit", "1")  # without a map
        answer = answer_in(self.page(grasp, *quick))
        self.assertEqual((answer["cases"], answer["question"]["case"], answer["decide"]["case"]),
                         (["at rest", "lifted"], "at rest", "at rest"))
        self.assertIn("2 cases", answer["messages"][0])
        self.assertEqual(answer_in(self.page(grasp, "--case", "lifted", *quick))["decide"]["verdict"], "unstable")

    def test_more_contacts_than_are_shown(self):
        grasp = ring(21)
        del grasp["wrench"]
        answer = answer_in(self.page("-", "--wrench", "0,0,0", stdin=json.dumps({**grasp, "wrench": [0, 0, 0]})))
        self.assertIsNone(answer["states"])
        self.assertRegex("".join(answer["messages"]), "21 contacts.*no load")
        answer = answer_in(self.page(self.write("many.json", ring(101)), "--time-limit", "1"))
        self.assertIsNone(answer["region"])
        self.assertIn("more than 100 contacts", "".join(answer["messages"]))

    def test_errors(self):
        self.fails("page", self.path("missing.json"), naming=["missing.json"])
        self.fails("page", FIG1, "--wrench", "1,2", naming=["--wrench"])
        self.fails("page", FIG1, "--case", "a", naming=["case"])
        self.fails("page", FIG1, "--uncertain", "friction=-1", naming=["--uncertain"])
        grasp = self.write("own.json", read(FIG1))
        self.fails("page", grasp, "-o", grasp, naming=["own.json", "input"])
        self.fails("serve", grasp, "--port", "65536", naming=["--port"])
        self.fails("serve", self.write("broken.json", "{"), naming=["broken.json"])


class Server(Case):
    ORIGIN = "http://127.0.0.1:{port}"

    def setUp(self):
        super().setUp()
        self.process = self.start(FIG1, "--time-limit", "0")
        self.port = self.listening(self.process)

    def start(self, *words):
        def set_signals():
            signal.signal(signal.SIGINT, signal.SIG_DFL)
        process = subprocess.Popen([STICKSLIP, "serve", *map(str, words)], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True, preexec_fn=set_signals)

        def end():
            process.kill()
            process.communicate()
        self.addCleanup(end)
        return process

    def listening(self, process):
        line = process.stdout.readline()
        found = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/ \(Ctrl-C ends it\)\n", line)
        self.assertIsNotNone(found, line or process.stderr)
        return int(found[1])

    def request(self, method, path, body=None, **headers):
        """Status, headers, and body; header names with _ for -."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=600)
        try:
            connection.putrequest(method, path, skip_host="Host" in headers, skip_accept_encoding=True)
            if body is not None:
                body = body if isinstance(body, bytes) else json.dumps(body).encode()
                headers = {"Content_Type": "application/json", "Content_Length": len(body), **headers}
            for name, value in headers.items():
                if value is not None:
                    connection.putheader(name.replace("_", "-"), str(value))
            connection.endheaders()
            try:
                connection.send(body or b"")
            except ConnectionError:
                pass  # refused before all of it was sent; the answer says so
            response = connection.getresponse()
            return response.status, response.headers, response.read().decode()
        finally:
            connection.close()

    def ask(self, grasp, options=None, parts=("decide",), status=200):
        question = {"grasp": grasp, "options": options or {}, "parts": list(parts)}
        found, _, body = self.request("POST", "/answer", question, Origin=self.ORIGIN.format(port=self.port))
        self.assertEqual(found, status, body)
        return json.loads(body)

    def survives(self):
        self.assertIsNone(self.process.poll())
        self.assertEqual(self.ask(read(FIG1))["decide"]["verdict"], "stable")

    def test_the_page(self):
        status, headers, html = self.request("GET", "/")
        self.assertEqual(status, 200)
        answer = answer_in(html)
        self.assertIs(answer["live"], True)
        self.assertEqual(answer["decide"], self.json("decide", FIG1, "--floats"))
        policy = headers["Content-Security-Policy"]
        nonce = re.search(r"script-src 'nonce-([0-9a-f]{32})';", policy)[1]
        self.assertTrue(policy.startswith("default-src 'none';"))
        self.assertEqual(set(re.findall(r"<script( nonce=\"\w+\")?>", html)), {f' nonce="{nonce}"'})
        self.assertNotIn(nonce, self.request("GET", "/")[2])
        self.assertEqual(headers["X-Content-Type-Options"], "nosniff")
        self.assertNotIn("Access-Control-Allow-Origin", headers)

    def test_verdicts_are_those_of_decide(self):
        for folder, _, names in os.walk(CORPUS):
            for name in sorted(names):
                path = os.path.join(folder, name)
                if os.path.getsize(path) > 3000 or not name.endswith(".json"):
                    continue
                with open(path, encoding="utf-8", errors="surrogateescape") as file:
                    text = file.read()
                try:
                    body = json.dumps({"grasp": text, "parts": ["decide"]}).encode()
                except UnicodeError:
                    continue
                status, _, reply = self.request("POST", "/answer", body)
                answer = json.loads(reply)
                code, out, err = stickslip("decide", path, "--json", "--floats")
                if code == BAD_INPUT:
                    self.assertEqual((status, set(answer), set(answer["error"])),
                                     (400, {"error"}, {"message", "place"}), path)
                elif "cases" not in json.loads(out):
                    self.assertEqual((status, err), (200, ""), path)
                    self.assertEqual(answer["decide"], json.loads(out), path)
        self.survives()

    def test_options_and_parts(self):
        text = read(FIG1)
        answer = self.ask(text, {"wrench": [0, "11/10", 0], "preload": 2, "case": None})
        self.assertEqual(answer["decide"], self.json("decide", FIG1, *UP, "--preload", "2", "--floats"))
        self.assertEqual(answer["question"], {"wrench": "0,11/10,0", "case": None, "preload": "2",
                                              "normal_law": "unilateral", "uncertain": None})
        self.assertIs(answer["live"], True)
        self.assertEqual(set(answer) & {"states", "region", "margin", "map", "compare"}, set())
        # What an answer says was asked may be asked again.
        again = self.ask(text, answer["question"])
        self.assertEqual(again["decide"], answer["decide"])
        bilateral = self.ask(text, {"bilateral": True, "wrench": "0,1/2,0"}, ["decide", "margin"])
        self.assertEqual(bilateral["decide"]["normal_law"], "bilateral")
        self.assertEqual(bilateral["margin"]["direction"], ["0", "1/2", "0"])
        quick = self.ask(text, {"warnings": False})
        self.assertEqual(quick["decide"], self.json("decide", FIG1, "--floats", "--no-warnings"))
        box = self.ask(text, {"uncertain": "friction=10%"})
        self.assertEqual(box["decide"], self.json("decide", FIG1, "--uncertain", "friction=10%", "--floats"))
        bracket = read(os.path.join(EXAMPLES, "bracket.json"))  # of a quick map
        everything = json.loads(self.request("POST", "/answer", {"grasp": bracket})[2])
        self.assertLessEqual({"decide", "certificate", "states", "region", "margin", "map", "compare"}, set(everything))
        self.assertEqual(self.ask(text, {"wrench": "0,1/2,0"}, ["compare"])["compare"],
                         self.json("compare", FIG1, "--wrench", "0,1/2,0", "--floats"))

    def test_errors_name_their_place(self):
        text = read(FIG1)
        for grasp, options, parts, place, message in (
                (text, {"wrench": "1,2"}, [], "options.wrench", "2 numbers"),
                (text, {"wrench": [[1]]}, [], "options.wrench", "expected"),
                (text, {"preload": "-1"}, [], "options.preload", "-1"),
                (text, {"normal_law": "none"}, [], "options.normal_law", "none"),
                (text, {"bilateral": 1}, [], "options.bilateral", "true or false"),
                (text, {"case": [1]}, [], "options.case", "expected the name of a case"),
                (text, {"preload": {}}, [], "options.preload", "expected a number"),
                (text, {"uncertain": []}, [], "options.uncertain", "expected tolerances"),
                (text, {"normal_law": True}, [], "options.normal_law", "expected \"unilateral\" or"),
                (text, {}, [[]], "parts[0]", "expected a name"),
                (text, {"uncertain": "x=1"}, [], "options.uncertain", "x"),
                (text, {"fiction": 1}, [], "options", "fiction"),
                (text, {"case": "a"}, [], "case", "a"),
                (text, {}, ["decided"], "parts[0]", "decided"),
                (text.replace('"contacts"', '"contact"'), {}, [], "", "contact"),
                (7, {}, [], "grasp", "text"),
                ("{", {}, [], ":", "")):
            error = self.ask(grasp, options, parts, status=400)["error"]
            self.assertNotIn("expected expected", error["message"])
            self.assertIn(place, error["place"])
            self.assertIn(message, error["message"])

    def test_other_origins_and_names_are_refused(self):
        question = {"grasp": read(FIG1), "parts": ["decide"]}
        own, port = f"127.0.0.1:{self.port}", self.port
        for host in ("example.org", f"example.org:{port}", "127.0.0.1", f"127.0.0.1:{port + 1}", f"127.0.0.1.example.org:{port}",
                     f"[::1]:{port}", "", None):
            for method, path, body in (("GET", "/", None), ("POST", "/answer", question)):
                status, headers, _ = self.request(method, path, body, Host=host)
                self.assertEqual(status, 403, host)
                self.assertNotIn("Access-Control-Allow-Origin", headers)
        for origin in ("http://example.org", "null", f"https://{own}", f"http://127.0.0.1:{port + 1}", "http://localhost",
                       f"http://{own}.example.org", f"http://{own}/", "file://"):
            self.assertEqual(self.request("POST", "/answer", question, Origin=origin)[0], 403, origin)
            self.assertEqual(self.request("GET", "/", Origin=origin)[0], 403, origin)
        for host, origin in ((own, f"http://{own}"), (f"localhost:{port}", f"http://localhost:{port}"), (own, None)):
            self.assertEqual(self.request("POST", "/answer", question, Host=host, Origin=origin)[0], 200)
        # Given twice, by which a check and a browser may disagree.
        twice = f"GET / HTTP/1.1\r\nHost: {own}\r\nHost: example.org\r\n\r\n"
        self.assertIn(b" 403 ", self.raw(twice.encode()))

    def test_what_is_no_question_is_refused(self):
        for method, path, body, headers, status in (
                ("GET", "/answer", None, {}, 405), ("POST", "/", {}, {}, 405), ("PUT", "/answer", {}, {}, 405),
                ("DELETE", "/answer", None, {}, 405), ("OPTIONS", "/answer", None, {}, 405),
                ("GET", "/../../etc/passwd", None, {}, 404), ("GET", "/grasp.json", None, {}, 404),
                ("POST", "/answer", b"{}", {"Content_Type": "text/plain"}, 415),
                ("POST", "/answer", b"{}", {"Content_Type": "multipart/form-data; boundary=a"}, 415),
                ("POST", "/answer", b"{}", {"Content_Type": "application/jsonx"}, 415),
                ("POST", "/answer", b"{}", {"Content_Type": "application/json-seq"}, 415),
                ("POST", "/answer", b"{}", {"Content_Type": "application/json; charset=utf-8"}, 400),
                ("POST", "/answer", b"{}", {"Content_Type": "Application/JSON ;charset=utf-8"}, 400),
                ("POST", "/answer", b"{}", {}, 400), ("POST", "/answer", b"", {}, 400),
                ("POST", "/answer", b"[" * 100000, {}, 400), ("POST", "/answer", b"\xff\x00{", {}, 400),
                ("POST", "/answer", b'{"grasp": "' + b"a" * 900000 + b'"}', {}, 400),
                ("POST", "/answer", b" " * (MEGABYTE + 1), {}, 413),
                ("POST", "/answer", b" " * (12 * MEGABYTE), {}, 413)):
            found, _, reply = self.request(method, path, body, **headers)
            self.assertEqual(found, status, (method, path, reply))
            self.assertRegex(reply, r'^\{"error":\{"message":', (method, path))
        self.survives()

    def raw(self, data, ends=False):
        """What comes back until the connection ends; this side of it may end with the data."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=600) as connection:
            received = b""
            try:
                connection.sendall(data)
                if ends:
                    connection.shutdown(socket.SHUT_WR)
                while part := connection.recv(65536):
                    received += part
            except ConnectionError:
                pass  # the server had enough
            return received

    def chunked(self, chunks):
        head = (f"POST /answer HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\nContent-Type: application/json\r\n"
                "Transfer-Encoding: chunked\r\n\r\n")
        return self.raw(head.encode() + b"".join(b"%x\r\n%s\r\n" % (len(c), c) for c in chunks) + b"0\r\n\r\n")

    def test_hostile_connections(self):
        question = json.dumps({"grasp": read(FIG1), "parts": ["decide"]}).encode()
        self.assertIn(b" 200 ", self.chunked([question[:100], question[100:]]))
        for data in (b"\x16\x03\x01\x02\x00\x01\x00", b"\r\n\r\n", b"GET", b"\x00" * 100000, b"A" * (3 * MEGABYTE),
                     b"GET / HTTP/9.9\r\n\r\n", b"GET http://example.org/ HTTP/1.1\r\n\r\n",
                     b"GET / HTTP/1.1\r\n" + b"X: y\r\n" * 500000,
                     b"GET / HTTP/1.1\r\nX: " + b"y" * (2 * MEGABYTE) + b"\r\n\r\n"):
            self.assertNotIn(b" 200 ", self.raw(data, ends=True))
        self.assertNotIn(b" 200 ", self.chunked([b" " * 65536] * 40))
        head = f"POST /answer HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\nContent-Type: application/json\r\n"
        for length in ("-1", "99999999999999999999", "a", "5, 6"):
            self.assertNotIn(b" 200 ", self.raw(f"{head}Content-Length: {length}\r\n\r\n{{}}".encode(), ends=True))
        # Parts of an answer are not given: a thousand of them would be a long one.
        ranges = f"GET / HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\nRange: bytes={'0-,' * 1000}0-\r\n\r\n"
        self.assertLess(len(self.raw(ranges.encode())), 2 * MEGABYTE)
        self.survives()

    def test_nobody_waits_for_slow_connections(self):
        """Each is given up only after seconds; a question that is asked behind many is answered while all of them are still heard."""
        def is_heard(connection):
            connection.setblocking(False)
            try:
                connection.recv(1)  # why it was given up, or nothing more
            except BlockingIOError:
                return True
            except ConnectionError:
                pass
            return False

        still_heard = 0
        for _ in range(5):  # on a machine that does nothing for seconds they are given up before
            idle = [socket.create_connection(("127.0.0.1", self.port), timeout=600) for _ in range(100)]
            for connection in idle:
                connection.sendall(b"POST /answer HTTP/1.1\r\n")
            self.survives()
            still_heard = sum(map(is_heard, idle))
            for connection in idle:
                connection.close()
            if still_heard == len(idle):
                break
        self.assertEqual(still_heard, 100)

    def test_half_requests_and_many_connections(self):
        # More than there are threads, which are 256, hold their connections and say no more; each is given up in time.
        idle = [socket.create_connection(("127.0.0.1", self.port), timeout=600) for _ in range(300)]
        for k, connection in enumerate(idle):
            connection.sendall(f"POST /answer HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\n"[:3 * k % 61].encode())
        self.survives()
        for connection in idle:
            connection.close()
        with concurrent.futures.ThreadPoolExecutor(40) as pool:
            verdicts = list(pool.map(lambda k: self.ask(read(FIG1), {"wrench": f"0,{k}/20,0"})["decide"]["verdict"], range(80)))
        self.assertEqual(verdicts, [self.ask(read(FIG1), {"wrench": f"0,{k}/20,0"})["decide"]["verdict"] for k in range(80)])
        self.assertEqual(set(verdicts), {"stable", "unstable"})

    def test_work_is_limited(self):
        process = self.start(FIG1, "--time-limit", "1", "--node-limit", "1")
        self.port = self.listening(process)
        grasp = json.dumps(ring(20))
        answer = self.ask(grasp, {}, ["decide", "region", "margin"])
        self.assertIn(answer["decide"]["verdict"], ("stable", "unstable", "undecided"))
        # Far more than can be done in a second: every contact has denominators of its own.
        many = ring(100)
        for i, contact in enumerate(many["contacts"]):
            contact.update(friction=f"{3000 + i}/{10007 + 10 * i}", preload=f"{20000 + i}/{10009 + 12 * i}")
        answer = self.ask(json.dumps(many), {}, ["region"])
        self.assertIsNone(answer["region"])
        self.assertIn("not known within 1 second", answer["messages"][0])

    def end(self, number):
        self.process.send_signal(number)
        out, err = self.process.communicate(timeout=120)
        self.assertEqual((self.process.returncode, out, err), (DONE, "", ""))
        with self.assertRaises(OSError):
            socket.create_connection(("127.0.0.1", self.port), timeout=600)

    def test_ctrl_c_ends_it(self):
        self.survives()
        self.end(signal.SIGINT)

    def test_terminated(self):
        self.end(signal.SIGTERM)

    def test_ctrl_c_ends_it_in_the_middle_of_work(self):
        idle = socket.create_connection(("127.0.0.1", self.port), timeout=600)
        self.addCleanup(idle.close)
        grasp = json.dumps(ring(100))

        def ask():
            try:
                self.request("POST", "/answer", {"grasp": grasp, "parts": ["region"]})
            except (OSError, http.client.HTTPException):
                pass  # no answer any more
        thread = threading.Thread(target=ask)
        thread.start()
        self.survives()
        self.end(signal.SIGINT)
        thread.join()

    def test_a_port_that_is_taken(self):
        self.fails("serve", FIG1, "--port", self.port, naming=["--port", str(self.port)])

    def test_without_a_grasp(self):
        process = self.start()
        self.port = self.listening(process)
        self.assertEqual(answer_in(self.request("GET", "/")[2])["dimension"], 3)


if __name__ == "__main__":
    unittest.main()
