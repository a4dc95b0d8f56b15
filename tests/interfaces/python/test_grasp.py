# SPDX-License-Identifier: GPL-3.0-or-later
"""Grasps: exact numbers in, the same numbers out; shapes; values that do not change."""

import copy
import pickle
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from conftest import GOOD
from stickslip import Grasp, InputError, decide

TENTH = Fraction(1, 10)
DYADIC = Fraction(0.1)  # the double nearest to 1/10


def one(friction=1, normal=(1, 0), **more):
    return Grasp([[0, 0]], [list(normal)], friction, **more)


@pytest.mark.parametrize("value, meaning", [
    (0.1, DYADIC), ("0.1", TENTH), ("1/10", TENTH), ("1e-1", TENTH), (Decimal("0.1"), TENTH),
    (TENTH, TENTH), (Decimal(0.1), DYADIC), (np.float64(0.1), DYADIC),
    (np.float32(0.1), Fraction(13421773, 2**27)), (np.float16(0.5), Fraction(1, 2)),
    (np.longdouble(0.1), DYADIC), (np.str_("1/10"), TENTH), (7, 7), (np.int64(7), 7),
    (np.uint8(7), 7), (-0.0, 0),
    pytest.param(2**4000 + 1, 2**4000 + 1, id="a long int"),
    (5e-324, Fraction(1, 2**1074)), (Fraction(1, 3**5000), Fraction(1, 3**5000)),
])
def test_numbers_are_exact(value, meaning):
    grasp = one(value)
    assert grasp.friction == (meaning,)
    assert type(grasp.friction[0]) is Fraction
    assert type(grasp.friction[0].numerator) is int
    assert one(np.array([value], dtype=object)).friction == (meaning,)
    assert Grasp([[value, 0]], [[0, value or 1]], 1).positions == ((meaning, 0),)
    assert one(wrench=(value, 0, 0)).wrench == (meaning, 0, 0)


def test_random_numbers_round_trip():
    random = np.random.default_rng(1)
    for _ in range(300):
        bits = int(random.integers(1, 700))
        number = Fraction(int.from_bytes(random.bytes(bits), "big") - 2**(4 * bits),
                          int.from_bytes(random.bytes(bits), "big") + 1)
        assert one(wrench=(number, str(number), -number)).wrench == (number, number, -number)


def test_a_float_is_not_the_decimal_that_it_prints_as():
    assert one(0.1) != one("0.1")
    assert one(0.5) == one("0.5") == one("1/2")


def test_arrays():
    positions = np.array([[-1, 0], [0.25, -1]])
    normals = np.array([[1, 0], [0, 1]], dtype=np.int32)
    grasp = Grasp(positions, normals, np.array([0.5, 0]), 2, [Fraction(1, 3), "2/3"],
                  wrench=np.zeros(3), name="two")
    assert grasp.positions == ((-1, 0), (Fraction(1, 4), -1))
    assert grasp.normals == ((1, 0), (0, 1))
    assert grasp.friction == (Fraction(1, 2), 0)
    assert grasp.stiffness == (2, 2)
    assert grasp.preload == (Fraction(1, 3), Fraction(2, 3))
    assert grasp.wrench == (0, 0, 0)
    assert (grasp.name, len(grasp)) == ("two", 2)
    assert np.array_equal(np.array(grasp.positions, float), positions)
    # Views, transposes and other orders are read as NumPy shows them.
    assert Grasp(np.asfortranarray(positions), normals[::-1][::-1], 1) == Grasp(
        positions.tolist(), normals.tolist(), 1)


def test_one_number_for_all_contacts():
    two = [[0, 1], [1, 0]]
    for scalar in (0.1, "1/10", Fraction(1, 10), np.array(0.1)):
        grasp = Grasp(two, two, scalar, scalar, scalar)
        value = Fraction(scalar.item() if isinstance(scalar, np.ndarray) else scalar)
        assert grasp.friction == grasp.stiffness == grasp.preload == (value, value)


def test_mixed_entries_stay_what_they_are():
    grasp = Grasp([["1/10", 0.1]], [[Decimal("0.1"), 1]], 1)
    assert grasp.positions == ((TENTH, DYADIC),)
    assert grasp.normals == ((TENTH, 1),)


@pytest.mark.parametrize("empty", [[], np.zeros((0, 2))])
def test_no_contact(empty):
    grasp = Grasp(empty, empty, 1)
    assert (len(grasp), grasp.positions, grasp.friction) == (0, (), ())
    assert bool(grasp)


@pytest.mark.parametrize("place, arguments", [
    ("positions", ([[1, 2, 3, 4]], [[1, 0]], 1)),
    ("normals", ([[1, 2, 3]], [[1, 0]], 1)),
    ("positions[0]", ([1, 2], [[1, 0]], 1)),
    ("positions[1]", ([[1, 2], [1]], [[1, 0], [1, 0]], 1)),
    ("positions[1]", ([[1, 2], "12"], [[1, 0], [1, 0]], 1)),
    ("normals[1]", ([[1, 2], [1, 2]], [[1, 0], [1, 0, 0]], 1)),
    ("positions", (5, [[1, 0]], 1)),
    ("positions", (Path("grasp.json"), [[1, 0]], 1)),
    ("positions", ("grasp.json", [[1, 0]], 1)),
    ("normals", ([[1, 2]], "12", 1)),
    ("positions", (iter([[1, 2]]), [[1, 0]], 1)),
    ("positions", ([np.ones((2, 2)), np.ones((2, 3))], [[1, 0]], 1)),
    ("normals", ([], np.zeros((0, 3)), 1)),
    ("positions", (np.zeros((2, 2, 2)), np.ones((2, 2)), 1)),
    ("normals", ([[1, 2]], [[1, 0], [0, 1]], 1)),
    ("normals", (np.zeros((3, 2)), np.ones((2, 3)), 1)),
    ("friction", ([[1, 2]], [[1, 0]], [1, 2])),
    ("friction", ([[1, 2]], [[1, 0]], [[1]])),
    ("stiffness", ([[1, 2]], [[1, 0]], 1, [])),
    ("preload", ([[1, 2]], [[1, 0]], 1, 1, [1, 1])),
    ("friction", ([[1, 2]], [[1, 0]], {0: 1})),
])
def test_shapes(place, arguments):
    with pytest.raises(InputError) as error:
        Grasp(*arguments)
    assert (error.value.file, error.value.place) == ("", place)
    assert error.value.problem and error.value.remedy


def masked(values, *index):
    array = np.ma.array(values, dtype=float)
    array[index] = np.ma.masked
    return array


TWO = [[0, 1], [1, 0]]


@pytest.mark.parametrize("place, make", [
    ("positions[1, 0]", lambda: Grasp(masked(TWO, 1, 0), TWO, 1)),
    ("positions[0, 1]", lambda: Grasp([masked([0, 1], 1), [1, 0]], TWO, 1)),
    ("normals[1, 1]", lambda: Grasp(TWO, [[0, 1], [1, np.ma.masked]], 1)),
    ("normals[0, 0]", lambda: Grasp(TWO, np.array([[np.ma.masked, 1], [1, 0]], object), 1)),
    ("friction[1]", lambda: Grasp(TWO, TWO, masked([1, 2], 1))),
    ("friction", lambda: Grasp(TWO, TWO, np.ma.masked)),
    ("preload[0]", lambda: Grasp(TWO, TWO, 1, 1, [np.ma.masked, 1])),
    ("within", lambda: Grasp(TWO, TWO, 1).snap(np.ma.masked)),
    ("wrench[2]", lambda: Grasp(TWO, TWO, 1, wrench=masked([0, 1, 2], 2))),
])
def test_masked_entries_are_refused(place, make):
    with pytest.raises(InputError, match="masked") as error:
        make()
    assert error.value.place == place and "filled" in error.value.remedy


def test_a_mask_that_hides_nothing():
    plain = Grasp(TWO, TWO, [1, 2])
    assert Grasp(np.ma.array(TWO), np.ma.array(TWO), np.ma.array([1, 2], mask=[0, 0])) == plain
    assert Grasp(TWO, TWO, masked([9, 1, 2], 0)[1:]) == plain


@pytest.mark.parametrize("value", [
    Fraction(1, 3**40000), 10**16384, -10**16383, Fraction(10**8191, 10**8191 + 1),
    "9" * 16000 + "e4000", Decimal((0, (9,) * 12000, -16000))],
    ids=lambda value: type(value).__name__)
def test_numbers_too_long_for_a_file(value):
    with pytest.raises(InputError, match="too long") as error:
        one(wrench=(0, value, 0))
    assert error.value.place == "wrench[1]" and "16384" in error.value.remedy


@pytest.mark.parametrize("value", [
    10**16383, 1 - 10**16383, Fraction(10**8190, 10**8190 + 1), "9" * 16384, "1e-4096"],
    ids=lambda value: type(value).__name__)
def test_the_longest_numbers_of_a_file(value):
    grasp = one(wrench=(0, value, 0))
    assert Grasp.from_text(grasp.to_text()) == grasp


@pytest.mark.parametrize("name", [None, 7, b"fig1", "\ud800", "abc\udc80", ["fig1"]])
def test_names_are_text(name):
    for place, make in (("name", lambda: one(name=name)),
                        ("name", lambda: Grasp.from_text(one().to_text(), name)),
                        ("text", lambda: Grasp.from_text(name))):
        with pytest.raises(InputError) as error:
            make()
        assert error.value.place == place
        assert error.value.problem and error.value.remedy


def test_any_other_name(tmp_path):
    for name in ("", "Gr\u00fc\u00dfe", "\U0001f600", "\n\"\0", np.str_("x"), "x" * 10000):
        grasp = one(name=name)
        assert Grasp.from_text(grasp.to_text()).name == grasp.name == name
        assert len(repr(grasp)) < 400


def test_paths_and_texts(tmp_path, monkeypatch):
    text = one().to_text()
    for wrong in (text, '{"format"', "\n", text.encode()):
        with pytest.raises(InputError, match="not a path") as error:
            Grasp.from_file(wrong)
        assert error.value.place == "path" and "from_text" in error.value.remedy
    assert Grasp.from_text("\ufeff\r\n " + text) == one()
    for wrong in (Path("grasp.json"), "grasp.json", "", text.encode(), one()):
        with pytest.raises(InputError) as error:
            Grasp.from_text(wrong)
        assert error.value.place == "text" and "from_file" in error.value.remedy
    for wrong in (3, None, one()):
        with pytest.raises(InputError) as error:
            Grasp.from_file(wrong)
        assert error.value.place == "path" and "path" in error.value.remedy
    for wrong in (tmp_path, "no\0name", "-", "x" * 10000):
        with pytest.raises(InputError, match="cannot open the file") as error:
            Grasp.from_file(wrong)
        assert error.value.file == str(wrong)
    monkeypatch.chdir(tmp_path)
    for odd in ("-", "{", b"\xff.json"):  # names all the same
        with open(odd, "w") as file:
            file.write(text)
        assert Grasp.from_file(odd) == one()


@pytest.mark.parametrize("value", [
    float("nan"), float("inf"), np.float32("nan"), np.longdouble("-inf"), Decimal("NaN"),
    Decimal("Infinity"), Decimal("1e999999999"), None, True, np.bool_(True), 1j, "", "x", " 1",
    "1/0", "0x10", "nan", "1e5000", "\ud800", b"1", object(),
])
def test_what_is_no_number(value):
    normals = np.array([[1, 0], [0, 1]], dtype=object)
    normals[1, 0] = value
    with pytest.raises(InputError) as error:
        Grasp([[0, 0], [1, 1]], normals, 1)
    assert error.value.place == "normals[1, 0]"
    assert error.value.problem and '"3/5"' in error.value.remedy
    with pytest.raises(InputError, match=r"^within: "):
        one().snap(value)
    with pytest.raises(InputError, match=r"^friction"):
        one(value)


@pytest.mark.parametrize("place, remedy, make", [
    ("contacts[0].normal", "nonzero", lambda: one(normal=(0, 0))),
    ("contacts[0].friction", "0 or more", lambda: one(-1)),
    ("contacts[0].stiffness", "above 0", lambda: one(stiffness=0)),
    ("contacts[0].preload", "0 or more", lambda: one(preload="-1/2")),
    ("within", "between 0 and 1", lambda: one().snap(1)),
    ("within", "between 0 and 1", lambda: one().snap(0)),
    ("wrench", "torque", lambda: one(wrench=(1, 2))),
    ("wrench[2]", "finite", lambda: one(wrench=(1, 2, np.nan))),
    ("friction[0]", "finite", lambda: one([np.nan])),
    ("friction", "finite", lambda: one(np.nan)),
    ("stiffness", "finite", lambda: Grasp([], [], 1, np.inf)),
    ("within", "one number", lambda: one().snap([1, 2])),
])
def test_values_out_of_range(place, remedy, make):
    with pytest.raises(InputError) as error:
        make()
    assert error.value.place == place
    assert remedy in error.value.remedy
    assert str(error.value).startswith(place + ": ")


def test_files():
    grasp = Grasp.from_file(GOOD / "fig1.json")
    assert (grasp.name, grasp.wrench) == ("fig1", (0, Fraction(-11, 10), 0))
    assert Grasp.from_file(str(GOOD / "fig1.json")) == grasp
    for path in GOOD.iterdir():
        grasp = Grasp.from_file(path)
        assert Grasp.from_text(grasp.to_text()) == grasp


def test_place_in_a_file(tmp_path):
    path = tmp_path / "Gr\u00fc\u00dfe.json"
    path.write_text('{"format": "stickslip-grasp/1", "wrench": [0, 0, 0], "contacts":\n'
                    '[{"position": [0, 0], "normal": [0, 1], "friction": -1}]}')
    with pytest.raises(InputError) as error:
        Grasp.from_file(path)
    assert (error.value.file, error.value.place) == (str(path), "contacts[0].friction")
    with pytest.raises(InputError, match="No such file"):
        Grasp.from_file(tmp_path / "missing.json")
    with pytest.raises(InputError) as error:
        Grasp.from_text('{\n"x" 1}', "some text")
    assert (error.value.file, error.value.place) == ("some text", "2:5")


def test_grasps_do_not_change(fig1):
    for name in ("friction", "wrench", "anything", "_data"):
        with pytest.raises(AttributeError):
            setattr(fig1, name, 1)
    with pytest.raises(TypeError):
        fig1.positions[0] = (1, 1)
    array = np.ones((1, 2))
    grasp = Grasp(array, array, 1)
    array[:] = 5
    assert grasp.positions == ((1, 1),)


def test_equality_and_copies(fig1):
    diagonal = one(0.1, normal=(1, 1), preload=1, name="\u00e9")
    for grasp in (fig1, diagonal, diagonal.snap().grasp, Grasp([], [], 1)):
        for same in (pickle.loads(pickle.dumps(grasp)), copy.deepcopy(grasp)):
            assert same == grasp and hash(same) == hash(grasp)
    assert fig1 != diagonal and fig1 != "fig1"
    assert repr(fig1) == "Grasp(name='fig1', contacts=3)"
    loaded = Grasp(fig1.positions, fig1.normals, "1/2", wrench=(0, 0, 0.5))
    assert repr(loaded) == "Grasp(contacts=3, wrench=(0, 0, 1/2))"


def test_snapping():
    grasp = Grasp([[0, 1], [2, 3]], [[3, 4], [1, 1]], "1/2", 2, "1/3", wrench=(1, 2, 3), name="two")
    for within in ("1e-9", 0.25, Fraction(1, 10**40)):
        snapped, moved = grasp.snap(within)
        ((contact, normal, moved_at_most),) = moved
        assert contact == 1 and 0 < Fraction(moved_at_most) <= Fraction(within)
        # Nothing else has changed, and there is nothing more to snap.
        assert snapped == Grasp(grasp.positions, [[3, 4], normal], "1/2", 2, "1/3", wrench=(1, 2, 3), name="two")
        assert snapped.snap() == (snapped, ())
    assert grasp.snap() == grasp.snap("1e-9") and grasp.normals[1] == (1, 1)
    assert repr(moved[0]).startswith("SnappedNormal(1, (~0.707107, ~0.707107), '")


def test_an_assumed_stiffness_stays_assumed():
    def traps(stiffness):  # of a plank on three supports, one of them with friction
        plank = Grasp([[-1, 0], [0, 0], [1, 0]], [[0, 1], [0, 1], ["-1/1000", 1]], [0, "1/2", 0],
                      stiffness, wrench=(2, -30, 0))
        snapped, moved = plank.snap()
        assert len(moved) == 1
        return [warning.trap for warning in decide(snapped, warnings=True).warnings]

    assert traps(None) == ["large-motion", "assumed-stiffness"]
    assert traps(1) == ["large-motion"]


def test_errors_can_be_pickled():
    with pytest.raises(InputError) as error:
        one(-1)
    again = pickle.loads(pickle.dumps(error.value))
    assert (str(again), again.remedy) == (str(error.value), error.value.remedy)
    assert isinstance(error.value, ValueError)
